#include "slices.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/input_file.hpp"
#include "../io/read_sites.hpp"
#include "../io/text_slice.hpp"
#include "hdf5.hpp"

namespace signum::mpi {
namespace {

using distributed::Placed;

Slices read_array(Communicator& ranks, const std::string& name, int dimension, SitesInput input) {
    Slices slices;
    ranks.together([&] {
        const SitesFile file = read_sites(
            name, {.dimension = dimension, .input = input, .share = {ranks.rank(), ranks.size()}});
        auto id = static_cast<std::int64_t>(file.first_row);
        const auto put = [&](const auto& sites) {
            for (const auto& site : sites) {
                slices.sites.push_back({site, id++});
                slices.has_radii = slices.has_radii || site.r != 0.0;
            }
        };
        put(file.sites);
        put(file.in_space);
    });
    return slices;
}

Slices read_text(Communicator& ranks, const std::string& name, int dimension) {
    Slices slices;
    TextSlice slice;
    ranks.together([&] { slice = read_text_slice(name, dimension, ranks.rank(), ranks.size()); });
    const std::int64_t before = ranks.sum_before(slice.lines);
    ranks.together([&] {
        if (slice.wrong) throw wrong_line(name, dimension, before, slice);
    });
    slices.has_radii = slice.has_radii;
    std::int64_t id = ranks.sum_before(static_cast<std::int64_t>(slice.sites.size()));
    for (const Site3& site : slice.sites) slices.sites.push_back({site, id++});
    return slices;
}

// ---- HDF5 --------------------------------------------------------------------------------------

Slices read_hdf5(Communicator& ranks, const std::string& file, const std::string& path,
                 std::uint64_t dimension, const std::string& radii_path) {
    Slices slices;
    ranks.together([&] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        { const InputFile named(file, "a file of sites", Contents::bytes); }
        const Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, access_by(ranks.get())),
                            H5Fclose);
        if (!opened.is_there()) throw InputError(file, "this is no file of HDF5");
        const Dataset set(file, opened, path);
        if (set.columns() < dimension || set.columns() > dimension + 1)
            throw InputError(
                set.name(), fmt::format("rows of {} numbers; sites {} have {}, "
                                        "or {} with a radius or weight",
                                        set.columns(), dimension == 3 ? "of space" : "of the plane",
                                        dimension, dimension + 1));
        if (set.rows() == 0) throw InputError(set.name(), "no site in this array");
        const auto [first, count] = share_of(ranks, set.rows());
        const std::vector<double> places = set.read<double>(first, count);
        std::vector<double> radii;
        if (!radii_path.empty()) {
            const Dataset of_radii(file, opened, radii_path);
            if (of_radii.columns() != 1 || of_radii.rows() != set.rows())
                throw InputError(
                    of_radii.name(),
                    fmt::format("{} rows of {} numbers; {} has {} sites", of_radii.rows(),
                                of_radii.columns(), set.name(), set.rows()));
            radii = of_radii.read<double>(first, count);
        }
        const std::uint64_t columns = set.columns();
        slices.has_radii = columns > dimension || !radii.empty();
        for (std::uint64_t k = 0; k < count; ++k) {
            const double* const row = &places[k * columns];
            const double r = !radii.empty() ? radii[k] : columns > dimension ? row[dimension] : 0.0;
            const double z = dimension == 3 ? row[2] : 0.0;
            for (const double number : {row[0], row[1], z, r})
                if (!std::isfinite(number))
                    throw InputError(set.name(), fmt::format("row {}: {} where a finite number "
                                                             "should be",
                                                             first + k, number));
            slices.sites.push_back(
                {Site3{row[0], row[1], z, r}, static_cast<std::int64_t>(first + k)});
        }
    });
    return slices;
}

}  // namespace

std::string file_of(const std::string& name) {
    for (const std::string_view ending : {".h5:", ".hdf5:", ".hdf:"})
        if (const std::size_t at = name.find(ending); at != std::string::npos)
            return name.substr(0, at + ending.size() - 1);
    return name;
}

Slices read_slices(Communicator& ranks, const std::string& name, int dimension,
                   const std::string& radii) {
    if (const std::string file = file_of(name); file != name)
        return read_hdf5(ranks, file, name.substr(file.size() + 1),
                         static_cast<std::uint64_t>(dimension), radii);
    if (!radii.empty())
        throw InputError(name,
                         "--radii and --weights name arrays of a file of HDF5: give "
                         "FILE.h5:/path/to/coordinates");
    if (name.ends_with(".h5") || name.ends_with(".hdf5") || name.ends_with(".hdf"))
        throw InputError(name, "which array? give FILE.h5:/path/to/coordinates");
    const SitesInput input = input_by_ending(name.substr(name.find_last_of("./") + 1));
    if (is_array(input)) return read_array(ranks, name, dimension, input);
    if (input != SitesInput::text)
        throw InputError(
            name,
            "several ranks read lines x y [r] or x y z [r], arrays and HDF5; signum reads the "
            "rest");
    return read_text(ranks, name, dimension);
}

}  // namespace signum::mpi
