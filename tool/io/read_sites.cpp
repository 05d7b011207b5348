#include <fmt/format.h>

#include "../../core/index.hpp"
#include "atoms.hpp"
#include "input_file.hpp"
#include "json_sites.hpp"
#include "mesh_sites.hpp"
#include "node_sites.hpp"
#include "read_sites.hpp"
#include "text_sites.hpp"

namespace signum {
namespace {

SitesFile read_input(InputFile& file, const ReadOptions& options) {
    switch (options.input) {
        case SitesInput::xyz:
            return read_xyz_sites(file);
        case SitesInput::pdb:
            return read_pdb_sites(file);
        case SitesInput::pqr:
            return read_pqr_sites(file);
        case SitesInput::ply:
            return read_ply_sites(file);
        case SitesInput::node:
            return read_node_sites(file, options);
        case SitesInput::text:
            break;
    }
    const char first = file.first_character();
    return first == '[' || first == '{' ? read_json_sites(file, options.columns, options.dimension)
                                        : read_text_sites(file, options);
}

}  // namespace

SitesInput input_by_ending(std::string_view ending) noexcept {
    if (ending == "xyz") return SitesInput::xyz;
    if (ending == "pdb" || ending == "ent") return SitesInput::pdb;
    if (ending == "pqr") return SitesInput::pqr;
    if (ending == "ply") return SitesInput::ply;
    if (ending == "node") return SitesInput::node;
    return SitesInput::text;
}

SitesFile read_sites(const std::string& path, const Columns& columns) {
    return read_sites(path, ReadOptions{.columns = columns, .dimension = 2});
}

SitesFile read_sites(const std::string& path, const ReadOptions& options) {
    InputFile file(path, "a file of sites");
    SitesFile result = read_input(file, options);
    const std::size_t number = result.sites.size() + result.in_space.size();
    if (static_cast<std::int64_t>(number) > max_sites) {
        file.fail({}, fmt::format("{} sites; {} is the most that 32-bit indices allow", number,
                                  max_sites));
    }
    return result;
}

StridedSites strided_view(std::span<const Site> sites, WeightIs third) noexcept {
    if (sites.empty()) return {};
    const Site& first = sites.front();
    return {sites.size(), sizeof(Site), &first.x, &first.y, &first.r, third == WeightIs::weight};
}

}  // namespace signum
