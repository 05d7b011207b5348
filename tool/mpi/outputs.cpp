#include "outputs.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "../../triangulation/tessellation.hpp"
#include "../io/array_writer.hpp"
#include "../io/errors.hpp"
#include "../io/write_tessellation.hpp"
#include "cells.hpp"
#include "hdf5.hpp"
#include "shared_file.hpp"

namespace signum::mpi {
namespace {

using distributed::Placed;
using distributed::WholeHidden;

/// Faces or cells as numbers of 32 bits, of 64 where there are so many sites.
void write_faces(Communicator& ranks, const std::string& name, const Whole& whole, bool has_head) {
    SharedFile file(ranks, name);
    const SiteNumbers numbers(whole.sites);
    std::ostringstream head;
    if (has_head)
        put_npy_head(head, numbers.type(), static_cast<std::size_t>(whole.stretch.faces_of_all),
                     whole.stretch.corners);
    const std::string start = head.str();
    ranks.together([&] {
        if (ranks.rank() == 0) file.write(0, start.data(), start.size());
        const std::vector<char> bytes = numbers.bytes(whole.stretch.faces);
        file.write(start.size() + static_cast<std::uint64_t>(whole.stretch.first_face) *
                                      whole.stretch.corners * numbers.size(),
                   bytes.data(), bytes.size());
        file.finish();
    });
}

// ---- HDF5 --------------------------------------------------------------------------------------

/// Why HDF5 failed, as far as it knows.
std::string reason() {
    std::string found;
    const auto take = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
        auto& text = *static_cast<std::string*>(to);
        if (text.empty() && error->desc != nullptr) text = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take, &found);
    return found.empty() ? "it fails" : found;
}
/// Whether it is done on all ranks: none goes on alone, for the next call is one of all. Throws
/// MachineError.
void require(Communicator& ranks, bool is_done, const std::string& name) {
    const std::string why = is_done ? "" : reason();
    if (ranks.most(is_done ? 0 : 1) == 0) return;
    if (is_done) throw OtherFailed("another rank cannot write");
    throw MachineError(fmt::format("cannot write {}: {}", name, why));
}

/// Arrays of one group of a file, of whose rows each rank has some.
class Group {
 public:
    Group(Communicator& ranks, const std::string& name, const Handle& file, const char* path)
        : ranks_(ranks),
          name_(name),
          group_(H5Gcreate2(file, path, H5P_DEFAULT, untimed(H5P_GROUP_CREATE), H5P_DEFAULT),
                 H5Gclose) {
        require(ranks_, group_.is_there(), name_);
    }
    [[nodiscard]] const Handle& get() const noexcept { return group_; }

    /// `stored`: the type in the file.
    template <class Number>
    void put(const char* array, hid_t stored, hid_t type, std::span<const Number> own,
             std::uint64_t first, std::uint64_t all, std::uint64_t columns) const {
        const int axes = columns == 1 ? 1 : 2;
        const std::array<hsize_t, 2> shape = {all, columns};
        const Handle space(H5Screate_simple(axes, shape.data(), nullptr), H5Sclose);
        const Handle set(H5Dcreate2(group_, array, stored, space, H5P_DEFAULT,
                                    untimed(H5P_DATASET_CREATE), H5P_DEFAULT),
                         H5Dclose);
        require(ranks_, set.is_there(), name_);
        if (all == 0) return;
        const std::array<hsize_t, 2> begin = {first, 0};
        const std::array<hsize_t, 2> extent = {own.size() / columns, columns};
        const Handle memory(H5Screate_simple(axes, extent.data(), nullptr), H5Sclose);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, extent.data(), nullptr);
        // By itself each rank, for its rows lie side by side: in a write of all, Open MPI's ranks
        // wait for ever for one whose disk is full.
        require(ranks_,
                own.empty() || H5Dwrite(set, type, memory, space, H5P_DEFAULT, own.data()) >= 0,
                name_);
    }
    void put_longs(const char* array, std::span<const std::int64_t> own, std::uint64_t first,
                   std::uint64_t all, std::uint64_t columns) const {
        put(array, H5T_STD_I64LE, H5T_NATIVE_INT64, own, first, all, columns);
    }
    void put_text(const char* attribute, const std::string& text) const {
        const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type, text.size());
        H5Tset_strpad(type, H5T_STR_NULLPAD);
        const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        const Handle made(H5Acreate2(group_, attribute, type, space, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
        require(ranks_, made.is_there() && H5Awrite(made, type, text.data()) >= 0, name_);
    }
    void put_version(std::int64_t major, std::int64_t minor) const {
        const std::array<std::int64_t, 2> version = {major, minor};
        const hsize_t two = 2;
        const Handle space(H5Screate_simple(1, &two, nullptr), H5Sclose);
        const Handle made(
            H5Acreate2(group_, "Version", H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose);
        require(ranks_, made.is_there() && H5Awrite(made, H5T_NATIVE_INT64, version.data()) >= 0,
                name_);
    }

 private:
    /// The time would make each file another one.
    [[nodiscard]] static Handle untimed(hid_t kind) {
        Handle properties(H5Pcreate(kind), H5Pclose);
        H5Pset_obj_track_times(properties, 0);
        return properties;
    }
    Communicator& ranks_;
    std::string name_;
    Handle group_;
};

/// Faces, neighbours and hidden sites as signum has them, and the finite faces as triangles, cells
/// as tetrahedra, between the centres as VTK's readers take them.
void write_hdf5(Communicator& ranks, const std::string& name, const Whole& whole) {
    const Stretch& stretch = whole.stretch;
    const std::size_t size = stretch.corners;
    std::vector<std::int64_t> corners;
    for (std::size_t c = 0; c < stretch.faces.size(); c += size) {
        const auto cell = stretch.faces.begin() + static_cast<std::ptrdiff_t>(c);
        if (*cell >= 0)
            corners.insert(corners.end(), cell, cell + static_cast<std::ptrdiff_t>(size));
    }
    const auto finite = static_cast<std::int64_t>(corners.size() / size);
    const std::int64_t first = ranks.sum_before(finite);
    const auto all = static_cast<std::uint64_t>(ranks.sum(finite));
    const auto first_site =
        static_cast<std::uint64_t>(ranks.sum_before(static_cast<std::int64_t>(whole.slice.size())));
    const auto sites = static_cast<std::uint64_t>(whole.sites);
    const bool is_first = ranks.rank() == 0;
    const auto ours = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };

    ranks.together([&] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        const Handle file(
            H5Fcreate(unfinished(name).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access_by(ranks.get())),
            H5Fclose);
        require(ranks, file.is_there(), name);
        const Group vtk(ranks, name, file, "/VTKHDF");
        vtk.put_version(1, 0);
        vtk.put_text("Type", "UnstructuredGrid");
        const auto put_number = [&](const char* array, std::uint64_t number) {
            const std::array<std::int64_t, 1> one = {static_cast<std::int64_t>(number)};
            vtk.put_longs(array, std::span(one).first(is_first ? 1 : 0), 0, 1, 1);
        };
        put_number("NumberOfPoints", sites);
        put_number("NumberOfCells", all);
        put_number("NumberOfConnectivityIds", size * all);
        std::vector<double> places;
        std::vector<double> thirds;
        for (const auto& [site, id] : whole.slice) {
            places.insert(places.end(), {site.x, site.y, site.z});
            thirds.push_back(site.r);
        }
        vtk.put<double>("Points", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, places, first_site, sites, 3);
        vtk.put_longs("Connectivity", corners, size * ours(first), size * all, 1);
        std::vector<std::int64_t> offsets;
        for (std::int64_t k = is_first ? 0 : 1; k <= finite; ++k)
            offsets.push_back(static_cast<std::int64_t>(size) * (first + k));
        vtk.put_longs("Offsets", offsets, is_first ? 0 : ours(first) + 1, all + 1, 1);
        constexpr std::uint8_t triangle = 5;
        constexpr std::uint8_t tetrahedron = 10;
        const std::vector<std::uint8_t> types(static_cast<std::size_t>(finite),
                                              size == 4 ? tetrahedron : triangle);
        vtk.put<std::uint8_t>("Types", H5T_STD_U8LE, H5T_NATIVE_UINT8, types, ours(first), all, 1);
        const Group point_data(ranks, name, file, "/VTKHDF/PointData");
        point_data.put<double>(whole.weight_is == WeightIs::weight ? "weight" : "radius",
                               H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, thirds, first_site, sites, 1);

        const Group own(ranks, name, file, "/signum");
        own.put_text("metric", std::string(name_of(whole.metric)));
        own.put_longs(size == 4 ? "cells" : "faces", stretch.faces, ours(stretch.first_face),
                      ours(stretch.faces_of_all), size);
        own.put_longs("neighbours", stretch.neighbours, ours(stretch.first_face),
                      ours(stretch.faces_of_all), size);
        std::vector<std::int64_t> hidden;
        for (const auto& [site, by] : stretch.hidden) hidden.insert(hidden.end(), {site, by});
        own.put_longs("hidden", hidden, ours(stretch.first_hidden), ours(stretch.hidden_of_all), 2);
        require(ranks, H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0, name);
    });
}

void write_json(Communicator& ranks, const std::string& name, const Whole& whole) {
    constexpr std::int64_t most = 20'000'000;
    if (whole.stretch.faces_of_all > most)
        throw std::invalid_argument(
            fmt::format("{}: {} faces; JSON is written by one rank, which "
                        "holds them all: {} at most. Write .h5 or .npy",
                        name, whole.stretch.faces_of_all, most));
    // To the first rank.
    const auto gathered = [&]<class T>(const std::vector<T>& own) {
        std::vector<std::vector<T>> to(ranks.size());
        to[0] = own;
        std::vector<T> all;
        for (const auto& from : ranks.exchanged(to))
            all.insert(all.end(), from.begin(), from.end());
        return all;
    };
    const auto faces = gathered(whole.stretch.faces);
    const auto neighbours = gathered(whole.stretch.neighbours);
    const auto hidden = gathered(whole.stretch.hidden);
    const auto sites = gathered(whole.slice);
    SharedFile file(ranks, name);
    ranks.together([&] {
        if (ranks.rank() != 0) return;
        const auto rows = [](const std::vector<std::int64_t>& numbers, auto& to) {
            const std::size_t size = to.empty() ? 0 : to.front().size();
            for (std::size_t k = 0; k < numbers.size(); ++k)
                to[k / size][k % size] = static_cast<Index>(numbers[k]);
        };
        const auto fill = [&](auto& result, auto& cells) {
            result.sites = whole.sites;
            cells.resize(faces.size() / whole.stretch.corners);
            result.neighbours.resize(cells.size());
            rows(faces, cells);
            rows(neighbours, result.neighbours);
            for (const auto& [site, by] : hidden)
                result.hidden.push_back({static_cast<Index>(site), static_cast<Index>(by)});
        };
        std::ostringstream out;
        if (whole.stretch.corners == 4) {
            SpaceTessellation space;
            space.dimension = 3;
            fill(space, space.cells);
            signum::write_json(out, space, whole.metric, whole.weight_is, std::nullopt, {});
        } else {
            TessellationArrays arrays;
            arrays.metric = whole.metric;
            arrays.weight_is = whole.weight_is;
            fill(arrays, arrays.faces);
            std::vector<Site> all;
            for (const Placed& each : sites) all.push_back(in_plane(each));
            signum::write_json(out,
                               triangulation::constructed(std::move(arrays), std::move(all), {}));
        }
        const std::string text = out.str();
        file.write(0, text.data(), text.size());
        file.finish();
    });
}

/// How a file of an ending is written.
struct Format {
    std::string_view ending;
    void (*write)(Communicator&, const std::string&, const Whole&);
};
constexpr Format formats[] = {
    {".pvtu", [](Communicator& ranks, const std::string& name,
                 const Whole& whole) { write_pieces(ranks, name, whole.piece); }},
    {".h5", write_hdf5},
    {".hdf5", write_hdf5},
    {".vtkhdf", write_hdf5},
    {".json", write_json},
    {".npy", [](Communicator& ranks, const std::string& name,
                const Whole& whole) { write_faces(ranks, name, whole, true); }},
    {".i32", [](Communicator& ranks, const std::string& name,
                const Whole& whole) { write_faces(ranks, name, whole, false); }},
};
const Format* format_of(const std::string& name) {
    const auto* const found = std::ranges::find_if(
        formats, [&](const Format& format) { return name.ends_with(format.ending); });
    return found == std::end(formats) ? nullptr : found;
}

}  // namespace

std::string endings() {
    std::string all;
    for (const Format& format : formats)
        all += (all.empty() ? "" : ", ") + std::string(format.ending);
    return all;
}

void write(Communicator& ranks, const std::string& name, const Whole& whole) {
    complete(ranks, name, [&] { format_of(name)->write(ranks, name, whole); });
}

}  // namespace signum::mpi
