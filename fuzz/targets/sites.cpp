#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "../../core/site.hpp"
#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/text_slice.hpp"
#include "../../tool/io/write_sites.hpp"

#include "memory_file.hpp"
#include "parsers.hpp"
#include "reading.hpp"

namespace signum::fuzz {
namespace {

template <class S>
const std::vector<S>& sites_of(const SitesFile& file) {
    if constexpr (std::is_same_v<S, Site>)
        return file.sites;
    else
        return file.in_space;
}

std::vector<double> numbers_of(const Site& site) {
    return {site.x, site.y, site.r};
}
std::vector<double> numbers_of(const Site3& site) {
    return {site.x, site.y, site.z, site.r};
}

template <class S>
void judge_sites(const SitesFile& file, SitesFormat format) {
    const std::vector<S>& sites = sites_of<S>(file);
    for (const S& site : sites) must(are_finite(site), "a site that is not finite");
    constexpr int dimension = std::is_same_v<S, Site> ? 2 : 3;
    std::ostringstream text;
    write_sites(text, std::span<const S>(sites), format);
    const MemoryFile copy(text.str());
    const SitesFile again = read_sites(copy.path(), ReadOptions{.dimension = dimension});
    must(std::ranges::equal(
             sites_of<S>(again), sites,
             [](const S& a, const S& b) { return are_same_numbers(numbers_of(a), numbers_of(b)); }),
         "sites that do not read back to the same");
}

void judge(const SitesFile& file, SitesFormat format) {
    must(file.sites.empty() != file.in_space.empty(), "sites of neither or of both dimensions");
    must(file.dimension == (file.sites.empty() ? 3 : 2), "sites of another dimension");
    for (const Attribute& attribute : file.attributes)
        must(attribute.values.size() == file.sites.size() + file.in_space.size(),
             "an attribute without a value a site");
    if (file.dimension == 2)
        judge_sites<Site>(file, format);
    else
        judge_sites<Site3>(file, format);
}

void read_with(Bytes bytes, const ReadOptions& options, SitesFormat format = SitesFormat::text) {
    const MemoryFile file(bytes);
    const auto result =
        result_of(file.path(), [&](const std::string& path) { return read_sites(path, options); });
    if (result) judge(*result, format);
}

/// Slices of a file of lines, one after the other: sites, lines, and the first one that is wrong.
std::optional<TextSlice> read_in_slices(const std::string& path, int dimension, std::uint64_t of) {
    TextSlice all;
    for (std::uint64_t number = 0; number < of; ++number) {
        const auto slice = result_of(path, [&](const std::string& name) {
            return read_text_slice(name, dimension, number, of);
        });
        if (!slice) return std::nullopt;
        if (slice->wrong && !all.wrong) all.wrong = all.lines + *slice->wrong;
        if (all.wrong) return all;
        all.sites.insert(all.sites.end(), slice->sites.begin(), slice->sites.end());
        all.has_radii = all.has_radii || slice->has_radii;
        all.lines += slice->lines;
    }
    return all;
}

/// However many there are, and as who reads the whole reads it.
void judge_slices(Bytes bytes, int dimension) {
    const MemoryFile file(bytes);
    const auto numbers = [](const std::vector<Site3>& sites) {
        std::vector<double> all;
        for (const Site3& site : sites) all.insert(all.end(), {site.x, site.y, site.z, site.r});
        return all;
    };
    const auto whole = read_in_slices(file.path(), dimension, 1);
    for (const std::uint64_t of : {2, 3, 7}) {
        const auto slices = read_in_slices(file.path(), dimension, of);
        must(slices.has_value() == whole.has_value(), "slices are read otherwise than the whole");
        if (!whole) continue;
        must(slices->wrong == whole->wrong, "another line of slices is wrong");
        if (whole->wrong) continue;
        must(are_same_numbers(numbers(slices->sites), numbers(whole->sites)) &&
                 slices->has_radii == whole->has_radii && slices->lines == whole->lines,
             "slices have other sites");
    }
    if (!whole || whole->wrong || whole->sites.empty()) return;
    // A slice does not know the header, and takes rows that end before its radius.
    const auto read = result_of(file.path(), [&](const std::string& path) {
        return read_sites(path, {.dimension = dimension, .input = SitesInput::text});
    });
    if (!read) return;
    std::vector<Site3> sites = read->in_space;
    for (const Site& site : read->sites) sites.push_back({site.x, site.y, 0.0, site.r});
    must(are_same_numbers(numbers(sites), numbers(whole->sites)),
         "slices have other sites than who reads the whole");
}

}  // namespace

void read_sites_target(Bytes bytes) {
    static const std::array<ReadOptions, 8> all = {{{},
                                                    {.attributes = true},
                                                    {.dimension = 2},
                                                    {.dimension = 3},
                                                    {.columns = {"2", "1"}, .dimension = 2},
                                                    {.columns = {"x", "Y", "3"}},
                                                    {.columns = {"x", "y", "z"}, .dimension = 3},
                                                    {.columns = {"4", "3", "2", "1"}}}};
    int format = 0;
    for (const ReadOptions& options : all) {
        read_with(bytes, options, static_cast<SitesFormat>(format));
        format = (format + 1) % 3;
    }
    judge_slices(bytes, 2);
    judge_slices(bytes, 3);
}

void read_xyz_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::xyz});
}
void read_pdb_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::pdb});
}
void read_pqr_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::pqr});
}
void read_cif_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::cif});
}
void read_gro_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::gro});
}
void read_lammpstrj_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::lammpstrj});
}
void read_off_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::off});
}
void read_ply_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::ply});
}
void read_array_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::npy});
    read_with(bytes, {.columns = {"2", "3", "1"}, .dimension = 3, .input = SitesInput::npy});
    read_with(bytes, {.input = SitesInput::f64});
    read_with(bytes, {.dimension = 3, .input = SitesInput::f64});
}
void read_node_target(Bytes bytes) {
    read_with(bytes, {.input = SitesInput::node, .attributes = true});
    read_with(bytes, {.columns = {"2", "3", "4"}, .input = SitesInput::node});
    read_with(bytes, {.columns = {"5", "2", "3", "4"}, .dimension = 3, .input = SitesInput::node});
}

}  // namespace signum::fuzz
