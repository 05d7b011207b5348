#include <array>

#include <fmt/format.h>

#include "../../core/index.hpp"
#include "read_sites.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

template <SitesFile (*read)(InputFile&)>
SitesFile as_it_is(InputFile& file, const ReadOptions&) {
    return read(file);
}
SitesFile read_text_or_json(InputFile& file, const ReadOptions& options) {
    const char first = file.first_character();
    return first == '{'   ? read_geojson_sites(file, options)
           : first == '[' ? read_json_sites(file, options)
                          : read_text_sites(file, options);
}

constexpr std::array kinds = {
    SitesInputKind{SitesInput::text, "text", "",
                   "lines of columns, JSON [[x, y, r], ...], or points of\nGeoJSON", false,
                   Contents::text, read_text_or_json},
    SitesInputKind{SitesInput::xyz, "xyz", "", "atoms in space: element x y z [radius]", true,
                   Contents::text, as_it_is<read_xyz_sites>},
    SitesInputKind{SitesInput::cif, "cif", "mmcif", "the same in mmCIF", true, Contents::text,
                   read_cif_sites},
    SitesInputKind{SitesInput::gro, "gro", "", "atoms of GROMACS, in nanometres", true,
                   Contents::text, read_gro_sites},
    SitesInputKind{SitesInput::lammpstrj, "lammpstrj", "dump", "a dump of LAMMPS", true,
                   Contents::text, read_lammpstrj_sites},
    SitesInputKind{SitesInput::pdb, "pdb", "ent",
                   "atoms of a protein, with the van der Waals\nradii of their elements", true,
                   Contents::text, read_pdb_sites},
    SitesInputKind{SitesInput::pqr, "pqr", "", "the same with radii of their own", true,
                   Contents::text, as_it_is<read_pqr_sites>},
    SitesInputKind{SitesInput::off, "off", "", "the vertices of a mesh", true, Contents::text,
                   as_it_is<read_off_sites>},
    SitesInputKind{SitesInput::ply, "ply", "", "the vertices of a mesh", true, Contents::mixed,
                   as_it_is<read_ply_sites>},
    SitesInputKind{SitesInput::npy, "npy", "", "a NumPy array, rows x y [r], in space x y z [r]",
                   false, Contents::bytes, read_npy_sites},
    SitesInputKind{SitesInput::f64, "f64", "",
                   "doubles, rows x y r, in space x y z r, without\na head", false, Contents::bytes,
                   read_f64_sites},
    SitesInputKind{SitesInput::node, "node", "", "points of Triangle or, in space, TetGen", false,
                   Contents::text, read_node_sites}};
constexpr bool are_in_order() {
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].input != static_cast<SitesInput>(i)) return false;
    return kinds.back().input == SitesInput::node;
}
static_assert(are_in_order(), "a row an enumerator, in their order, node the last");

const SitesInputKind& sites_kind_of(SitesInput input) noexcept {
    return kinds[static_cast<std::size_t>(input)];
}

}  // namespace

void add_site(SitesFile& file, const LineWords& line, const std::array<std::size_t, 4>& words) {
    std::array<double, 4> numbers = {};
    for (std::size_t which = 0; which < words.size(); ++which)
        if (words[which] < line.size()) numbers[which] = line.number(words[which]);
    file.add(numbers, [&](std::size_t which) { return line.position_of(words[which]); });
}

std::span<const SitesInputKind> sites_input_kinds() noexcept {
    return kinds;
}
bool is_of_space(SitesInput input) noexcept {
    return sites_kind_of(input).is_of_space;
}
bool is_array(SitesInput input) noexcept {
    return kinds[static_cast<std::size_t>(input)].contents == Contents::bytes;
}
SitesInput input_by_ending(std::string_view ending) noexcept {
    for (const SitesInputKind& kind : kinds)
        if (!ending.empty() && (ending == kind.name || ending == kind.ending)) return kind.input;
    return SitesInput::text;
}

SitesFile read_sites(const std::string& path, const ReadOptions& options) {
    const SitesInputKind& kind = sites_kind_of(options.input);
    InputFile file(path, "a file of sites", kind.contents);
    SitesFile result = kind.read(file, options);
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
