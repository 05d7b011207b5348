#include "read_stretch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/input_file.hpp"
#include "../io/read_sites.hpp"
#include "hdf5.hpp"

namespace signum::mpi {
namespace {

/// A text that write_hdf5() puts beside a group's arrays.
std::string text_of(const Handle& file, const std::string& group, const std::string& attribute) {
    const Handle text(
        H5Aopen_by_name(file, group.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        H5Aclose);
    if (!text.is_there()) return "";
    const Handle type(H5Aget_type(text), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING) return "";
    if (H5Tis_variable_str(type) > 0) {
        char* value = nullptr;
        if (H5Aread(text, type, static_cast<void*>(&value)) < 0 || value == nullptr) return "";
        std::string copy = value;
        H5free_memory(value);
        return copy;
    }
    std::string value(H5Tget_size(type), '\0');
    if (H5Aread(text, type, value.data()) < 0) return "";
    return value.c_str();
}

ReadStretch read_hdf5(Communicator& ranks, const std::string& name) {
    ReadStretch read;
    ranks.together([&] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        { const InputFile named(name, "a tessellation", Contents::bytes); }
        const Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, access_by(ranks.get())), H5Fclose);
        if (!file.is_there()) throw InputError(name, "this is no file of HDF5");
        const auto metric = metric_named(text_of(file, "/signum", "metric"));
        if (H5Lexists(file, "/signum", H5P_DEFAULT) <= 0 || !metric)
            throw InputError(name,
                             "its group /signum has no attribute metric, a string as power, so it "
                             "is no tessellation");
        const bool is_space = H5Lexists(file, "/signum/cells", H5P_DEFAULT) > 0;
        const bool has_weights = H5Lexists(file, "/VTKHDF/PointData/weight", H5P_DEFAULT) > 0;
        Stretch& stretch = read.stretch;
        stretch.corners = is_space ? 4 : 3;
        const auto rows = [&](const char* path, std::uint64_t columns, std::int64_t* first,
                              std::int64_t* all) {
            const Dataset set(name, file, path);
            if (set.columns() != columns)
                throw InputError(set.name(), fmt::format("rows of {} numbers, not of {}",
                                                         set.columns(), columns));
            const auto [begin, count] = share_of(ranks, set.rows());
            if (first != nullptr) *first = static_cast<std::int64_t>(begin);
            *all = static_cast<std::int64_t>(set.rows());
            return set.read<std::int64_t>(begin, count);
        };
        std::int64_t all = 0;
        stretch.faces = rows(is_space ? "/signum/cells" : "/signum/faces", stretch.corners,
                             &stretch.first_face, &stretch.faces_of_all);
        stretch.neighbours = rows("/signum/neighbours", stretch.corners, nullptr, &all);
        if (all != stretch.faces_of_all)
            throw InputError(
                name, fmt::format("{} faces, but neighbours of {}", stretch.faces_of_all, all));
        const std::vector<std::int64_t> hidden =
            rows("/signum/hidden", 2, &stretch.first_hidden, &stretch.hidden_of_all);
        for (std::size_t k = 0; k < hidden.size(); k += 2)
            stretch.hidden.push_back({hidden[k], hidden[k + 1]});
        const Dataset points(name, file, "/VTKHDF/Points");
        read.says = {
            static_cast<std::int64_t>(points.rows()),
            {*metric, has_weights ? WeightIs::weight : WeightIs::radius, stretch.corners - 1}};
    });
    return read;
}

ReadStretch read_faces(Communicator& ranks, const std::string& name, std::size_t dimension) {
    ReadStretch read;
    ranks.together([&] {
        { const InputFile named(name, "a tessellation", Contents::bytes); }
        std::ifstream file(name, std::ios::binary | std::ios::ate);
        const auto bytes = static_cast<std::uint64_t>(file.tellg());
        Stretch& stretch = read.stretch;
        stretch.corners = dimension + 1;
        const std::uint64_t row = stretch.corners * sizeof(std::int32_t);
        if (!file || bytes % row != 0)
            throw InputError(name, fmt::format("{} bytes are no rows of {} numbers of 32 bits",
                                               bytes, stretch.corners));
        const auto [first, count] = share_of(ranks, bytes / row);
        stretch.faces_of_all = static_cast<std::int64_t>(bytes / row);
        stretch.first_face = static_cast<std::int64_t>(first);
        stretch.faces.reserve(stretch.corners * count);
        file.seekg(static_cast<std::streamoff>(first * row));
        std::vector<std::int32_t> some(stretch.corners << 16);
        while (stretch.faces.size() < stretch.corners * count) {
            some.resize(std::min(some.size(), stretch.corners * count - stretch.faces.size()));
            file.read(reinterpret_cast<char*>(some.data()),
                      static_cast<std::streamsize>(some.size() * sizeof(std::int32_t)));
            if (!file) throw InputError(name, "it ends early, or cannot be read");
            stretch.faces.insert(stretch.faces.end(), some.begin(), some.end());
        }
    });
    return read;
}

/// Rows of numbers, as sites are read: a double holds each.
ReadStretch read_array(Communicator& ranks, const std::string& name, std::size_t dimension) {
    ReadStretch read;
    ranks.together([&] {
        const SitesFile file =
            read_sites(name, {.dimension = static_cast<int>(dimension),
                              .input = input_by_ending(name.substr(name.size() - 3)),
                              .share = {ranks.rank(), ranks.size()}});
        Stretch& stretch = read.stretch;
        stretch.corners = dimension + 1;
        stretch.first_face = static_cast<std::int64_t>(file.first_row);
        const auto put = [&](double number) {
            // A number that is none of a site's is refused by the judge.
            stretch.faces.push_back(std::fabs(number) < 0x1p53 && std::trunc(number) == number
                                        ? static_cast<std::int64_t>(number)
                                        : -2);
        };
        for (const Site& face : file.sites)
            for (const double number : {face.x, face.y, face.r}) put(number);
        for (const Site3& cell : file.in_space)
            for (const double number : {cell.x, cell.y, cell.z, cell.r}) put(number);
    });
    read.stretch.faces_of_all =
        ranks.sum(static_cast<std::int64_t>(read.stretch.faces.size() / read.stretch.corners));
    return read;
}

}  // namespace

bool is_hdf5(const std::string& name) {
    constexpr std::array<std::string_view, 3> endings = {".h5", ".hdf5", ".vtkhdf"};
    return std::ranges::any_of(endings,
                               [&](std::string_view ending) { return name.ends_with(ending); });
}

ReadStretch read_stretch(Communicator& ranks, const std::string& name, std::size_t dimension) {
    if (is_hdf5(name)) return read_hdf5(ranks, name);
    if (name.ends_with(".i32")) return read_faces(ranks, name, dimension);
    if (name.ends_with(".npy")) return read_array(ranks, name, dimension);
    throw InputError(name,
                     "ranks judge the .h5 that signum-mpi triangulate writes, or .npy and .i32; "
                     "signum validate judges JSON");
}

}  // namespace signum::mpi
