#include "write_space_cells.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "../../triangulation/space/cells.hpp"

#include "text_writer.hpp"
#include "write_tessellation.hpp"

namespace signum {
namespace {

bool is_infinite(const SpaceCell& cell) noexcept {
    return cell[0] == infinite;
}

/// In order.
std::vector<Index> visible_sites(const SpaceTessellation& tessellation) {
    std::vector<bool> is_hidden(static_cast<std::size_t>(tessellation.sites));
    for (const auto& [site, by] : tessellation.hidden)
        is_hidden[static_cast<std::size_t>(site)] = true;
    std::vector<Index> result;
    for (Index site = 0; site < static_cast<Index>(tessellation.sites); ++site)
        if (!is_hidden[static_cast<std::size_t>(site)]) result.push_back(site);
    return result;
}

std::string triple_of(const Point3& p) {
    if (!are_finite(p)) return "null";
    return fmt::format(FMT_COMPILE("[{}, {}, {}]"), JsonNumber{p.x}, JsonNumber{p.y},
                       JsonNumber{p.z});
}

struct DualEdge {
    std::array<Index, 3> sites;
    std::array<Index, 2> vertices;
};

/// One a facet that is finite, in the order of the cells that have it first. `number_of` is by cell
/// the vertex's, -1 of infinite ones.
std::vector<DualEdge> edges_of(const SpaceTessellation& tessellation,
                               std::span<const Index> number_of) {
    std::vector<DualEdge> edges;
    if (tessellation.dimension < 3) return edges;
    for (std::size_t c = 0; c < tessellation.cells.size(); ++c) {
        const SpaceCell& cell = tessellation.cells[c];
        if (is_infinite(cell)) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto across = static_cast<std::size_t>(tessellation.neighbours[c][k]);
            const bool is_told = !is_infinite(tessellation.cells[across]) && across < c;
            if (is_told) continue;
            const auto& [i, j, m] = spatial::facet_of[k];  // counterclockwise seen from outside
            edges.push_back({{cell[i], cell[j], cell[m]}, {number_of[c], number_of[across]}});
        }
    }
    return edges;
}

void put_cell(TextWriter& text, const SpaceCells& cells, Index site, bool is_unbounded) {
    const auto& [volume, area, centroid] = cells.measures[static_cast<std::size_t>(site)];
    const auto faces = cells.faces_of(site);
    const bool is_clipped =
        std::ranges::any_of(faces, [](const SpaceFace& face) { return is_box_side(face.beyond); });
    text.put(FMT_COMPILE(R"({{"site": {}, "unbounded": {}, "clipped": {}, "volume": {}, )"
                         R"("area": {}, "centroid": {}, "faces": [)"),
             site, is_unbounded, is_clipped, number_or_null(volume), number_or_null(area),
             volume > 0.0 ? triple_of(centroid) : "null");
    const char* comma = "";
    for (const SpaceFace& face : faces) {
        text.put(FMT_COMPILE(R"({}{{"neighbour": {}, "area": {}}})"), comma, face.beyond,
                 number_or_null(face.area));
        comma = ", ";
    }
    text.put("]}");
}

std::vector<std::size_t> numbers_below(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

}  // namespace

void write_space_cells_json(std::ostream& out, const SpaceCells& cells,
                            const SpaceTessellation& tessellation, WeightIs weight_is,
                            std::span<const SpaceVertex> vertices) {
    TextWriter text(out);
    const auto& [low, high] = cells.box;
    text.put(FMT_COMPILE(R"({{"format": "signum.voronoi", "version": 1, "dimension": 3, )"
                         R"("metric": "power", "weight_is": "{}", "sites": {}, )"
                         R"("clip": [{}, {}, {}, {}, {}, {}])"),
             name_of(weight_is), tessellation.sites, low.x, low.y, low.z, high.x, high.y, high.z);
    std::vector<SpaceVertex> finite;
    std::vector<Index> number_of(tessellation.cells.size(), infinite);
    if (tessellation.dimension == 3)
        for (std::size_t c = 0; c < tessellation.cells.size(); ++c) {
            if (is_infinite(tessellation.cells[c])) continue;
            number_of[c] = static_cast<Index>(finite.size());
            finite.push_back(vertices[c]);
        }
    text.put_long_array("vertices", finite.size(), [&](TextWriter& piece, std::size_t number) {
        const SpaceVertex& v = finite[number];
        piece.put_numbers(v.x, v.y, v.z, v.rho);
    });
    const auto edges = edges_of(tessellation, number_of);
    text.put_long_array("edges", edges.size(), [&](TextWriter& piece, std::size_t number) {
        piece.put(FMT_COMPILE(R"({{"sites": [{}], "vertices": [{}]}})"),
                  fmt::join(edges[number].sites, ", "), fmt::join(edges[number].vertices, ", "));
    });
    const std::vector<bool> unbounded = unbounded_cells(tessellation);
    const auto visible = visible_sites(tessellation);
    text.put_long_array("cells", visible.size(), [&](TextWriter& piece, std::size_t number) {
        const Index site = visible[number];
        put_cell(piece, cells, site, unbounded[static_cast<std::size_t>(site)]);
    });
    put_hidden(text, tessellation.hidden);
    text.put("}\n");
    text.flush();
}

void write_space_cells_csv(std::ostream& out, const SpaceCells& cells, const SiteNames& names) {
    TextWriter text(out);
    text.put("site,volume,area,centroid_x,centroid_y,centroid_z,faces,neighbours,face_areas\n");
    for (Index i = 0; i < static_cast<Index>(cells.measures.size()); ++i) {
        if (!names.is_written(i)) continue;
        const auto& [volume, area, centroid] = cells.measures[static_cast<std::size_t>(i)];
        const auto faces = cells.faces_of(i);
        std::vector<std::int64_t> beyond;
        std::vector<std::string> areas;
        for (const SpaceFace& face : faces) {
            beyond.push_back(names.number(face.beyond));
            areas.push_back(number_or_blank(face.area));
        }
        text.put(FMT_COMPILE("{},{},{},{},{},{},{},{},{}\n"), names.number(i),
                 number_or_blank(volume), number_or_blank(area), number_or_blank(centroid.x),
                 number_or_blank(centroid.y), number_or_blank(centroid.z), faces.size(),
                 fmt::join(beyond, " "), fmt::join(areas, " "));
    }
    text.flush();
}

VtkGrid vtk_grid(const SpaceCells& cells, std::span<const SpacePolyhedron> polyhedra,
                 const SiteNames& names) {
    VtkGrid grid;
    grid.title = "signum: power cells";
    grid.of_cells = {{"site", true, {}}, {"volume", false, {}}, {"faces", true, {}}};
    for (const SpacePolyhedron& each : polyhedra) {
        if (each.corners.empty()) continue;
        const auto first = static_cast<std::int64_t>(grid.points.size());
        grid.points.insert(grid.points.end(), each.corners.begin(), each.corners.end());
        std::vector<std::int64_t> corners(each.corners.size());
        std::iota(corners.begin(), corners.end(), first);
        grid.add_cell(VtkCell::polyhedron, corners);
        grid.faces.push_back(static_cast<std::int64_t>(each.beyond.size()));
        for (std::size_t f = 0; f < each.beyond.size(); ++f) {
            const auto loop = each.corners_of(f);
            grid.faces.push_back(static_cast<std::int64_t>(loop.size()));
            for (const Index corner : loop) grid.faces.push_back(first + corner);
        }
        grid.face_ends.push_back(static_cast<std::int64_t>(grid.faces.size()));
        const double volume = cells.measures.at(static_cast<std::size_t>(each.site)).volume;
        grid.of_cells[0].values.push_back(static_cast<double>(names.number(each.site)));
        grid.of_cells[1].values.push_back(volume);
        grid.of_cells[2].values.push_back(static_cast<double>(each.beyond.size()));
    }
    return grid;
}

void write_json(std::ostream& out, const BallDiagram& diagram) {
    TextWriter text(out);
    text.put(FMT_COMPILE(R"({{"format": "signum.voronoi", "version": 1, "dimension": 3, )"
                         R"("metric": "euclidean", "weight_is": "radius", "sites": {}, )"
                         R"("clip": null)"),
             diagram.balls);
    text.put_array("vertices", diagram.spheres, [&](const Site3& sphere) {
        text.put_numbers(sphere.x, sphere.y, sphere.z, sphere.r);
    });
    text.put_array("touching", numbers_below(diagram.vertices.size()), [&](std::size_t v) {
        text.put(FMT_COMPILE("[{}]"), fmt::join(diagram.vertices[v], ", "));
    });
    text.put_array("turns", diagram.turns, [&](Sign turn) { text.put(FMT_COMPILE("{}"), turn); });
    text.put_array("edges", numbers_below(diagram.edges.size()), [&](std::size_t e) {
        const std::array<Index, 2>& ends = diagram.ends[e];
        const std::size_t count = ends[0] == no_end ? 0 : ends.size();
        text.put(FMT_COMPILE(R"({{"sites": [{}], "vertices": [{}]}})"),
                 fmt::join(diagram.edges[e], ", "), fmt::join(std::span(ends).first(count), ", "));
    });
    put_hidden(text, diagram.hidden);
    text.put("}\n");
    text.flush();
}

void write_csv(std::ostream& out, const BallDiagram& diagram) {
    TextWriter text(out);
    text.put("a,b,c,d,x,y,z,r,turn,others\n");
    for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
        const std::span<const Index> balls = diagram.vertices[v];
        const Site3& sphere = diagram.spheres[v];
        text.put(FMT_COMPILE("{},{},{},{},{},{},{}\n"), fmt::join(balls.first(4), ","),
                 number_or_blank(sphere.x), number_or_blank(sphere.y), number_or_blank(sphere.z),
                 number_or_blank(sphere.r), diagram.turns[v], fmt::join(balls.subspan(4), " "));
    }
    text.flush();
}

}  // namespace signum
