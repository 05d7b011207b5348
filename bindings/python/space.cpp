/// Power tessellations of space.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "space_sites.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

/// A tessellation with its sites, which the library's own leaves to its caller.
struct Space {
    Sites sites;
    SpaceTessellation tessellation;
};

struct SpaceClip {
    std::shared_ptr<const Space> space;
    SpaceCells cells;
};

std::shared_ptr<Space> triangulated_space(const py::object& sites, const std::string& weight_is,
                                          const std::string& arithmetic, std::uint64_t seed,
                                          int threads, const py::object& progress) {
    Options options;
    options.arithmetic = arithmetic_of(arithmetic);
    options.seed = seed;
    options.threads = threads_of(threads);
    auto space = std::make_shared<Space>();
    space->sites = sites_of(sites, weight_of(weight_is) == WeightIs::weight);
    return watched(progress, [&](Watch& watch) {
        options.stop = watch.token();
        options.progress = watch.progress();
        space->tessellation =
            with_sites(space->sites, [&](auto all) { return triangulate(all, Power{}, options); });
        return space;
    });
}

/// Pairs of vertices of one cell, each once.
std::vector<Edge> edges_of(const SpaceTessellation& tessellation) {
    std::vector<Edge> edges;
    edges.reserve(tessellation.cells.size() * 6);
    for (const SpaceCell& cell : tessellation.cells)
        for (std::size_t a = 0; a < cell.size(); ++a)
            for (std::size_t b = a + 1; b < cell.size(); ++b)
                if (cell[a] != no_vertex && cell[b] != no_vertex)
                    edges.push_back({std::min(cell[a], cell[b]), std::max(cell[a], cell[b])});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

Box3 box_of(const py::object& object, const Sites& sites) {
    if (object.is_none()) return with_sites(sites, [](auto all) { return default_box(all); });
    const Rows rows(object, "box", 3, 3);
    if (rows.size() != 2) throw py::value_error("box: two corners are needed");
    return {{rows.at(0, 0), rows.at(0, 1), rows.at(0, 2)},
            {rows.at(1, 0), rows.at(1, 1), rows.at(1, 2)}};
}

std::shared_ptr<SpaceClip> clipped_space(const std::shared_ptr<Space>& space,
                                         const py::object& box) {
    auto result = std::make_shared<SpaceClip>();
    result->space = space;
    const Box3 in_box = box_of(box, space->sites);
    return watched([&](Watch&) {
        result->cells = with_sites(
            space->sites, [&](auto all) { return space_cells(space->tessellation, all, in_box); });
        return result;
    });
}

/// Corners, and of each face the corners and what lies beyond.
py::tuple polyhedron(const SpaceClip& clip, Index site) {
    const std::array<Index, 1> which = {site};
    SpacePolyhedron shape = watched([&](Watch&) {
        return with_sites(clip.space->sites, [&](auto all) {
            return std::move(
                space_polyhedra(clip.space->tessellation, all, clip.cells.box, which)[0]);
        });
    });
    py::list faces;
    for (std::size_t f = 0; f < shape.beyond.size(); ++f) {
        const std::span<const Index> corners = shape.corners_of(f);
        faces.append(column(std::vector<Index>(corners.begin(), corners.end())));
    }
    return py::make_tuple(table<double>(std::move(shape.corners)), faces,
                          column(std::move(shape.beyond)));
}

void bind_space_tessellation(py::module_& module) {
    const auto arrays = [](const py::object& self) -> const SpaceTessellation& {
        return self.cast<const Space&>().tessellation;
    };
    // Of flat sites a cell has fewer vertices, and then those numbers are not there.
    const auto cells = [](const std::vector<SpaceCell>& all, int dimension,
                          const py::object& self) {
        return view(reinterpret_cast<const Index*>(all.data()),
                    {static_cast<py::ssize_t>(all.size()), std::max(dimension + 1, 0)},
                    {sizeof(SpaceCell), sizeof(Index)}, self);
    };
    py::class_<Space, std::shared_ptr<Space>> bound(module, "SpaceTessellation",
                                                    R"(The power tessellation of sites in space.

What triangulate_space() gives. Its arrays are read-only views of its memory, which they keep alive; it
can be asked from several threads at once.)");
    complete(bound);
    bound
        .def_property_readonly(
            "sites",
            [](const py::object& self) {
                return with_sites(self.cast<const Space&>().sites,
                                  [&](auto all) { return table<double>(all, self); });
            },
            "All sites in the order given: float64 (n, 3), or (n, 4) with radii or weights.")
        .def_property_readonly(
            "weight_is",
            [](const Space& space) {
                return std::holds_alternative<std::vector<power::Site3>>(space.sites) ? "weight"
                                                                                      : "radius";
            },
            "What the fourth number of a site is: 'radius' or 'weight'.")
        .def_property_readonly(
            "dimension", [](const Space& space) { return space.tessellation.dimension; },
            "3; of sites in a plane 2, on a line 1, in one place 0, and -1 of none.")
        .def_property_readonly(
            "cells",
            [=](const py::object& self) {
                return cells(arrays(self).cells, arrays(self).dimension, self);
            },
            R"(Quadruples of sites that turn positively, int32 (m, 4), -1 being infinity.

Sorted, so that the same sites have the same array. Of flat sites a cell has dimension + 1 numbers.)")
        .def_property_readonly(
            "neighbours",
            [=](const py::object& self) {
                return cells(arrays(self).neighbours, arrays(self).dimension, self);
            },
            "int32: neighbours[c, k] is the cell across from corner k of cell c.")
        .def_property_readonly(
            "hidden",
            [=](const py::object& self) {
                return table<Index>(std::span<const Hidden>(arrays(self).hidden), self);
            },
            "int32 (m, 2): sites whose cells are empty, and the visible site nearest to each "
            "centre.")
        .def(
            "edges",
            [](const Space& space) {
                return table<Index>(watched([&](Watch&) { return edges_of(space.tessellation); }));
            },
            R"(All edges, int32 (k, 2), each once, those to infinity (-1, a) included. Sorted.

O(m log m) for m cells.)")
        .def(
            "vertices",
            [](const Space& space) {
                return table<double>(watched([&](Watch&) {
                    return with_sites(space.sites,
                                      [&](auto all) { return vertices(space.tessellation, all); });
                }));
            },
            R"(The vertex of the power diagram of every cell: float64 (m, 4), x, y, z, rho.

rho is its power distance from its sites: for points the square of the sphere's radius. Each number is the
double nearest to the exact value; NaN for a cell with infinity, and of flat sites. O(m).)")
        .def(
            "validate",
            [](const Space& space, const py::object& progress, int threads) {
                const int count = threads_of(threads);
                return watched(progress, [&](Watch& watch) {
                    return with_sites(space.sites, [&](auto all) {
                        return validate(space.tessellation, all,
                                        {watch.token(), watch.progress(), count});
                    });
                });
            },
            py::arg("progress") = py::none(), py::kw_only(), py::arg("threads") = 0,
            "Judges the tessellation from scratch, in numbers of the judge's own: a Validation.")
        .def("clip", &clipped_space, py::arg("box") = py::none(),
             R"(The cells in a box, ((x0, y0, z0), (x1, y1, z1)): a SpaceCells.

Without one in the smallest box around all centres, wider by a tenth of its longest side. Raises
ValueError unless the first corner is below the second, and where a number is beyond 2^200 of the box.)")
        .def(
            "__len__", [](const Space& space) { return space.tessellation.sites; },
            "How many sites there are.")
        .def("__repr__", [](const Space& space) {
            const SpaceTessellation& t = space.tessellation;
            return "<signum.SpaceTessellation: " + std::to_string(t.sites) + " sites, " +
                   std::to_string(t.cells.size()) + " cells, " + std::to_string(t.hidden.size()) +
                   " hidden>";
        });
}

void bind_space_cells(py::module_& module) {
    const auto cells = [](const py::object& self) -> const SpaceCells& {
        return self.cast<const SpaceClip&>().cells;
    };
    const auto measures = [=](const py::object& self, std::size_t offset, std::size_t columns) {
        return part<double>(std::span<const SpaceMeasure>(cells(self).measures), offset, columns,
                            self);
    };
    py::class_<SpaceClip, std::shared_ptr<SpaceClip>> bound(
        module, "SpaceCells",
        R"(The power cells of space in a box, which they tile.

What SpaceTessellation.clip() gives. Lengths, areas and volumes are doubles, in error by about 1e-12 of
those of a cell as large as the distance of its corners from its site.)");
    complete(bound);
    bound
        .def_property_readonly(
            "tessellation",
            [](const SpaceClip& clip) { return std::const_pointer_cast<Space>(clip.space); },
            "The SpaceTessellation whose cells they are.")
        .def_property_readonly(
            "box",
            [](const SpaceClip& clip) {
                const Box3& box = clip.cells.box;
                return py::make_tuple(py::make_tuple(box.low.x, box.low.y, box.low.z),
                                      py::make_tuple(box.high.x, box.high.y, box.high.z));
            },
            "((x0, y0, z0), (x1, y1, z1)).")
        .def_property_readonly(
            "volumes", [=](const py::object& self) { return measures(self, 0, 1); },
            "float64 (n,); 0 for a hidden site and for one whose cell is not in the box.")
        .def_property_readonly(
            "areas", [=](const py::object& self) { return measures(self, 1, 1); },
            "Of the cells' whole surfaces, float64 (n,).")
        .def_property_readonly(
            "centroids", [=](const py::object& self) { return measures(self, 2, 3); },
            "float64 (n, 3); of a cell without volume the point of the box nearest to its site.")
        .def_property_readonly(
            "first_face",
            [=](const py::object& self) {
                return column(std::span<const std::int64_t>(cells(self).first_face), self);
            },
            "int64 (n + 1,): the faces of site s are those from first_face[s] to first_face[s + "
            "1].")
        .def_property_readonly(
            "face_beyond",
            [=](const py::object& self) {
                return part<Index>(std::span<const SpaceFace>(cells(self).faces), 0, 1, self);
            },
            "int32: the site beyond each face, or -1 to -6 for a side of the box, x first, low "
            "first.")
        .def_property_readonly(
            "face_areas",
            [=](const py::object& self) {
                return part<double>(std::span<const SpaceFace>(cells(self).faces), 1, 1, self);
            },
            "float64: the area of each face, the same seen from both sides.")
        .def(
            "polyhedron", &polyhedron, py::arg("site"),
            R"(A cell as corners (k, 3), faces (a list of arrays of corners) and what lies beyond each.

Corners of a face run counterclockwise seen from outside. A cell without volume has none. Raises
IndexError where there is no such site.)")
        .def(
            "__len__", [](const SpaceClip& clip) { return clip.cells.measures.size(); },
            "How many sites there are.");
}

}  // namespace

void bind_space(py::module_& module) {
    static_assert(offsetof(SpaceFace, area) == sizeof(double));
    static_assert(sizeof(SpaceMeasure) == 5 * sizeof(double));
    bind_space_tessellation(module);
    bind_space_cells(module);
    module.def("triangulate_space", &triangulated_space, py::arg("sites"), py::kw_only(),
               py::arg("weight_is") = "radius", py::arg("arithmetic") = "exact",
               py::arg("seed") = 1, py::arg("threads") = 0, py::arg("progress") = py::none(),
               R"(The power tessellation of sites in space: a SpaceTessellation.

sites: x, y, z (Delaunay), or x, y, z and a radius (weight_is='weight': its square), a row each. They are
copied once, for the result keeps its sites. A function of its own, as three numbers a row are a disc of
the plane to triangulate(): the shape of an array does not decide what it means. arithmetic: 'exact' or
'naive'. Errors, threads and the other parameters as those of triangulate(). O(n log n) expected, O(n^2)
in the worst case, which is the size of the result.)");
}

}  // namespace signum::python
