#include "voronoi_space.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "../draw/space_cells_svg.hpp"
#include "../io/write_space_cells.hpp"

#include "clip.hpp"
#include "commands.hpp"
#include "formats.hpp"
#include "space_sites.hpp"

namespace signum::cli {
namespace {

/// Options and formats that are of the plane alone.
void refuse_what_is_planar(const VoronoiCall& call, std::span<const Target> targets) {
    constexpr std::string_view what = "cells in space";
    if (call.tolerance) refuse_option(call, "--tolerance", what, "have no arcs");
    if (call.merge) refuse_option(call, "--merge", what, "have vertices one by one alone");
    if (call.carry) refuse_option(call, "--carry", what, "have tables of measures alone");
    require_formats_of(Dimension::three, targets, voronoi_formats, call.input);
}

struct Cells {
    SpaceCells measured;
    std::vector<SpacePolyhedron> polyhedra;  ///< none where nobody asked for them
};

/// Throws CallError where doubles cannot compute with the box.
Cells cells_in(const Box3& box, const SpaceTessellation& tessellation, const InputSites& sites,
               bool asks_for_polyhedra) {
    std::vector<Index> all;
    if (asks_for_polyhedra)
        for (Index site = 0; site < static_cast<Index>(tessellation.sites); ++site)
            all.push_back(site);
    try {
        return with_sites_in_space(sites, [&](auto those) -> Cells {
            return {space_cells(tessellation, those, box),
                    space_polyhedra(tessellation, those, box, all)};
        });
    } catch (const std::invalid_argument& error) {
        throw CallError(fmt::format(
            "the box {} {} {} {} {} {}: {}; cut the cells to another one "
            "with --clip",
            box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z, error.what()));
    }
}

void summarize(const SpaceTessellation& tessellation, const SpaceCells& cells, WeightIs third,
               std::span<const Target> targets) {
    const std::size_t hidden = tessellation.hidden.size();
    const auto unbounded = std::ranges::count(unbounded_cells(tessellation), true);
    const auto finite = std::ranges::count_if(
        tessellation.cells, [](const SpaceCell& cell) { return cell[0] != infinite; });
    const auto inner = std::ranges::count_if(
        cells.faces, [](const SpaceFace& face) { return !is_box_side(face.beyond); });
    double volume = 0.0;
    for (const SpaceMeasure& measure : cells.measures) volume += measure.volume;
    const Point3& low = cells.box.low;
    const Point3& high = cells.box.high;
    say_sites_in_space(tessellation.sites, third);
    say("cells    {}, {} of them unbounded\n", cells.measures.size() - hidden, unbounded);
    say("hidden   {}\n", hidden);
    say("vertices {}\n", tessellation.dimension == 3 ? finite : 0);
    say("faces    {} between two cells\n", inner / 2);
    say("box      {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", low.x, low.y, low.z, high.x, high.y,
        high.z);
    say("volume   {:.6g}, of the box {:.6g}\n", volume,
        (high.x - low.x) * (high.y - low.y) * (high.z - low.z));
    say("{}", written(targets));
}

}  // namespace

void voronoi_in_space(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets) {
    refuse_what_is_planar(call, targets);
    require_numbers(call.clip, 6, call.input);
    const std::optional<Box3> clip = box_in_space_of(call.clip);
    const Outputs outputs(targets);
    const SpaceTessellation tessellation = construct_in_space(call, sites);
    const bool asks_for_polyhedra =
        is_written(targets, "vtk") || is_written(targets, "vtu") || is_picture_written(targets);
    const Cells found = cells_in(clip ? *clip : default_box(sites.file.in_space), tessellation,
                                 sites, asks_for_polyhedra);
    const SpaceCells& cells = found.measured;
    std::vector<SpaceVertex> diagram;
    if (is_written(targets, "json")) {
        diagram =
            with_sites_in_space(sites, [&](auto those) { return vertices(tessellation, those); });
    }
    outputs.write(
        {{"csv", [&](std::ostream& out) { write_space_cells_csv(out, cells); }},
         {"svg",
          [&](std::ostream& out) {
              write_space_cells_svg(out, sites.file.in_space, cells, found.polyhedra);
          }},
         {"vtk", [&](std::ostream& out) { write_vtk(out, vtk_grid(cells, found.polyhedra)); }},
         {"vtu", [&](std::ostream& out) { write_vtu(out, vtk_grid(cells, found.polyhedra)); }},
         {"json", [&](std::ostream& out) {
              write_space_cells_json(out, cells, tessellation, sites.third, diagram);
          }}});
    if (!call.quiet) summarize(tessellation, cells, sites.third, targets);
}

}  // namespace signum::cli
