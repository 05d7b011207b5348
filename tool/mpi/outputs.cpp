#include "outputs.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <type_traits>

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

/// An array of which each rank has some rows.
struct Array {
    const char* path;
    hid_t type;
    std::uint64_t rows;
    std::uint64_t columns;
    std::uint64_t first_byte;  ///< of the rank's own rows
    std::span<const char> own;
};
template <class Number>
[[nodiscard]] Array array_of(const char* path, hid_t type, std::uint64_t rows,
                             std::uint64_t columns, std::uint64_t first_row,
                             std::span<const std::type_identity_t<Number>> own) {
    return {path,
            type,
            rows,
            columns,
            first_row * columns * sizeof(Number),
            {reinterpret_cast<const char*>(own.data()), own.size_bytes()}};
}

/// A file of HDF5 as one rank lays it out: groups, attributes, and arrays with places for their
/// rows, which ranks write as bytes. Were HDF5 to write by all ranks, those would wait for ever for
/// one whose disk is full.
class Layout {
 public:
    explicit Layout(std::string name)
        : name_(std::move(name)),
          file_(H5Fcreate(unfinished(name_).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                H5Fclose) {
        require(file_.is_there());
    }
    /// Whose attributes follow.
    void begin_group(const char* path) {
        group_.emplace(H5Gcreate2(file_, path, H5P_DEFAULT, untimed(H5P_GROUP_CREATE), H5P_DEFAULT),
                       H5Gclose);
        require(group_->is_there());
    }
    /// Where its first row will be in the file.
    [[nodiscard]] std::uint64_t put_array(const Array& array) const {
        const std::array<hsize_t, 2> shape = {array.rows, array.columns};
        const Handle space(H5Screate_simple(array.columns == 1 ? 1 : 2, shape.data(), nullptr),
                           H5Sclose);
        const Handle how = untimed(H5P_DATASET_CREATE);
        H5Pset_alloc_time(how, H5D_ALLOC_TIME_EARLY);
        H5Pset_fill_time(how, H5D_FILL_TIME_NEVER);
        const Handle set(
            H5Dcreate2(file_, array.path, array.type, space, H5P_DEFAULT, how, H5P_DEFAULT),
            H5Dclose);
        require(set.is_there());
        return array.rows == 0 ? 0 : H5Dget_offset(set);
    }
    void put_text(const char* attribute, const std::string& text) const {
        const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type, text.size());
        H5Tset_strpad(type, H5T_STR_NULLPAD);
        const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        put(attribute, type, type, space, text.data());
    }
    void put_version(std::int64_t major, std::int64_t minor) const {
        const std::array<std::int64_t, 2> version = {major, minor};
        const hsize_t two = 2;
        const Handle space(H5Screate_simple(1, &two, nullptr), H5Sclose);
        put("Version", H5T_STD_I64LE, H5T_NATIVE_INT64, space, version.data());
    }
    /// What is said so far, to the disk.
    void flush() const { require(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0); }

 private:
    void put(const char* attribute, hid_t stored, hid_t type, hid_t space,
             const void* value) const {
        const Handle made(H5Acreate2(*group_, attribute, stored, space, H5P_DEFAULT, H5P_DEFAULT),
                          H5Aclose);
        require(made.is_there() && H5Awrite(made, type, value) >= 0);
    }
    void require(bool is_done) const {
        if (!is_done) fail(name_, errno);
    }
    /// The time would make each file another one.
    [[nodiscard]] static Handle untimed(hid_t kind) {
        Handle properties(H5Pcreate(kind), H5Pclose);
        H5Pset_obj_track_times(properties, 0);
        return properties;
    }
    std::string name_;
    Handle file_;
    std::optional<Handle> group_;
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

    std::vector<double> places;
    std::vector<double> thirds;
    std::vector<std::int64_t> offsets;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> hidden;
    ranks.together([&] {
        for (const auto& [site, id] : whole.slice) {
            places.insert(places.end(), {site.x, site.y, site.z});
            thirds.push_back(site.r);
        }
        for (std::int64_t k = is_first ? 0 : 1; k <= finite; ++k)
            offsets.push_back(static_cast<std::int64_t>(size) * (first + k));
        constexpr std::uint8_t triangle = 5;
        constexpr std::uint8_t tetrahedron = 10;
        types.assign(static_cast<std::size_t>(finite), size == 4 ? tetrahedron : triangle);
        for (const auto& [site, by] : stretch.hidden) hidden.insert(hidden.end(), {site, by});
    });

    // Each number is an array, too.
    const std::array<std::int64_t, 3> numbers = {static_cast<std::int64_t>(sites),
                                                 static_cast<std::int64_t>(all),
                                                 static_cast<std::int64_t>(size * all)};
    const auto number = [&](const char* path, std::size_t k) {
        return array_of<std::int64_t>(path, H5T_NATIVE_INT64, 1, 1, 0,
                                      std::span(numbers).subspan(k, is_first ? 1 : 0));
    };
    const auto integers = [](const char* path, std::uint64_t rows, std::uint64_t columns,
                             std::uint64_t first_row, std::span<const std::int64_t> own) {
        return array_of<std::int64_t>(path, H5T_NATIVE_INT64, rows, columns, first_row, own);
    };
    const auto doubles = [](const char* path, std::uint64_t rows, std::uint64_t columns,
                            std::uint64_t first_row, std::span<const double> own) {
        return array_of<double>(path, H5T_NATIVE_DOUBLE, rows, columns, first_row, own);
    };
    const std::uint64_t faces = ours(stretch.faces_of_all);
    const std::uint64_t first_face = ours(stretch.first_face);
    const std::vector<Array> arrays = {
        number("/VTKHDF/NumberOfPoints", 0),
        number("/VTKHDF/NumberOfCells", 1),
        number("/VTKHDF/NumberOfConnectivityIds", 2),
        doubles("/VTKHDF/Points", sites, 3, first_site, places),
        integers("/VTKHDF/Connectivity", size * all, 1, size * ours(first), corners),
        integers("/VTKHDF/Offsets", all + 1, 1, is_first ? 0 : ours(first) + 1, offsets),
        array_of<std::uint8_t>("/VTKHDF/Types", H5T_NATIVE_UINT8, all, 1, ours(first), types),
        doubles(whole.weight_is == WeightIs::weight ? "/VTKHDF/PointData/weight"
                                                    : "/VTKHDF/PointData/radius",
                sites, 1, first_site, thirds),
        integers(size == 4 ? "/signum/cells" : "/signum/faces", faces, size, first_face,
                 stretch.faces),
        integers("/signum/neighbours", faces, size, first_face, stretch.neighbours),
        integers("/signum/hidden", ours(stretch.hidden_of_all), 2, ours(stretch.first_hidden),
                 hidden)};

    std::vector<std::uint64_t> begins;
    ranks.together([&] {
        if (!is_first) return;
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        Layout layout(name);
        layout.begin_group("/VTKHDF");
        layout.put_version(1, 0);
        layout.put_text("Type", "UnstructuredGrid");
        layout.begin_group("/VTKHDF/PointData");
        layout.begin_group("/signum");
        layout.put_text("metric", std::string(name_of(whole.metric)));
        for (const Array& array : arrays) begins.push_back(layout.put_array(array));
        layout.flush();
    });
    begins = ranks.all_of<std::uint64_t>(begins);

    SharedFile file(ranks, name, SharedFile::Opened::as_it_is);
    ranks.together([&] {
        for (std::size_t k = 0; k < arrays.size(); ++k)
            file.write(begins[k] + arrays[k].first_byte, arrays[k].own.data(),
                       arrays[k].own.size());
        file.finish();
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
