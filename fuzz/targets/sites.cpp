#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "../../core/site.hpp"
#include "../../tool/io/read_sites.hpp"
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
