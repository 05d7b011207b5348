#include "write_tessellation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "../../triangulation/space/cells.hpp"
#include "../../triangulation/vertices.hpp"
#include "array_writer.hpp"
#include "text_writer.hpp"

namespace signum {
namespace {

// ---- JSON --------------------------------------------------------------------------------------

/// What `put` writes of the number of each simplex that has a vertex.
template <class Simplices, class Put>
void put_vertices(TextWriter& text, const Simplices& simplices, bool is_flat, const Put& put) {
    text.put_long_array("vertices", simplices.size(), [&](TextWriter& piece, std::size_t number) {
        if (simplices[number][0] == infinite || is_flat)
            piece.put("null");
        else
            put(piece, number);
    });
}

/// Numbers of sites or simplices, `size` of each tuple.
template <class Tuples>
void put_tuples(TextWriter& text, std::string_view name, const Tuples& tuples, std::size_t size) {
    text.put_long_array(name, tuples.size(), [&](TextWriter& piece, std::size_t number) {
        piece.put_whole_numbers(std::span(tuples[number]).first(size));
    });
}

void put_statistics(TextWriter& text, const Statistics& statistics) {
    text.put(",\n\"statistics\": {");
    for (const Counter& counter : counters)
        if (statistics.counted) {
            text.put(FMT_COMPILE("\"{}\": {}, "), counter.name, statistics.*counter.count);
        } else {
            text.put(FMT_COMPILE("\"{}\": null, "), counter.name);
        }
    text.put(FMT_COMPILE("\"seconds\": {}}}"), number_or_null(statistics.seconds));
}

}  // namespace

void put_hidden(TextWriter& text, std::span<const Hidden> hidden) {
    text.put_long_array("hidden", hidden.size(), [&](TextWriter& piece, std::size_t number) {
        piece.put(FMT_COMPILE("[{}, {}]"), hidden[number].site, hidden[number].by);
    });
}

void write_json(std::ostream& out, const Tessellation& tessellation, const JsonOptions& options) {
    const TessellationArrays& arrays = tessellation.arrays();
    if (arrays.order != Order::index) {
        const auto sites = tessellation.sites();
        const Tessellation by_index(ordered_by_index(arrays), {sites.begin(), sites.end()},
                                    tessellation.statistics());
        return write_json(out, by_index, options);
    }
    TextWriter text(out);
    text.put(FMT_COMPILE("{{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": "
                         "\"{}\", \"weight_is\": \"{}\", \"sites\": {}"),
             name_of(tessellation.metric()), name_of(tessellation.weight_is()),
             tessellation.arrays().sites);
    put_tuples(text, "faces", tessellation.faces(), 3);
    put_tuples(text, "neighbours", tessellation.neighbours(), 3);
    put_hidden(text, tessellation.hidden());
    if (options.vertices) {
        const std::vector<DiagramVertex> all = vertices(tessellation, options.threads);
        put_vertices(text, tessellation.faces(), false, [&](TextWriter& piece, std::size_t n) {
            piece.put_numbers(all[n].x, all[n].y, all[n].rho);
        });
    }
    if (options.statistics) put_statistics(text, tessellation.statistics());
    text.put("}\n");
    text.flush();
}

void write_json(std::ostream& out, const SpaceTessellation& tessellation, Metric metric,
                WeightIs weight_is, const std::optional<Statistics>& statistics,
                std::span<const SpaceVertex> vertices) {
    TextWriter text(out);
    text.put(
        FMT_COMPILE("{{\"format\": \"signum.tessellation\", \"version\": 1, \"dimension\": {}, "
                    "\"metric\": \"{}\", \"weight_is\": \"{}\", \"sites\": {}"),
        tessellation.dimension, name_of(metric), name_of(weight_is), tessellation.sites);
    const auto size = static_cast<std::size_t>(tessellation.dimension + 1);
    put_tuples(text, "cells", tessellation.cells, size);
    put_tuples(text, "neighbours", tessellation.neighbours, size);
    put_hidden(text, tessellation.hidden);
    if (!vertices.empty()) {
        put_vertices(text, tessellation.cells, tessellation.dimension < 3,
                     [&](TextWriter& piece, std::size_t n) {
                         const SpaceVertex& v = vertices[n];
                         piece.put_numbers(v.x, v.y, v.z, v.rho);
                     });
    }
    if (statistics) put_statistics(text, *statistics);
    text.put("}\n");
    text.flush();
}

// ---- tables, and the files of Triangle and TetGen ----------------------------------------------

namespace {

/// The first `vertices` of each simplex, under their letters.
template <class Simplex>
void write_csv_of(std::ostream& out, std::span<const Simplex> simplices, std::size_t vertices) {
    constexpr std::string_view letters = "a,b,c,d";
    TextWriter text(out);
    text.put(FMT_COMPILE("{}\n"), letters.substr(0, 2 * vertices - 1));
    for (const Simplex& each : simplices)
        text.put(FMT_COMPILE("{}\n"), fmt::join(std::span(each).first(vertices), ","));
    text.flush();
}

/// The first `vertices` of each simplex, as bytes.
template <class Simplex>
void put_bytes_of(std::ostream& out, std::span<const Simplex> simplices, std::size_t vertices) {
    if (vertices == Simplex().size()) return put_bytes(out, simplices);
    for (const Simplex& each : simplices) put_bytes(out, std::span(each).first(vertices));
}

/// By simplex, its number among the finite ones; -1 where it is infinite.
struct Numbered {
    std::vector<Index> numbers;
    Index count = 0;
};

template <class Simplex>
Numbered numbered(std::span<const Simplex> simplices) {
    Numbered result;
    for (const Simplex& each : simplices)
        result.numbers.push_back(each[0] == infinite ? infinite : result.count++);
    return result;
}

/// A line for each finite simplex: its number, and the numbers that `told` gives of it, all from
/// `first` on but -1.
template <class Simplex, class Told>
void put_lines(TextWriter& text, std::span<const Simplex> simplices, int first, const Told& told) {
    Index number = first;
    for (std::size_t i = 0; i < simplices.size(); ++i) {
        if (simplices[i][0] == infinite) continue;
        Simplex numbers = told(i);
        for (Index& each : numbers)
            if (each >= 0) each += first;
        text.put(FMT_COMPILE("{} {}\n"), number++, fmt::join(numbers, " "));
    }
}

template <class Simplex>
void write_ele_of(std::ostream& out, std::span<const Simplex> simplices, int first) {
    TextWriter text(out);
    text.put(FMT_COMPILE("{} {} 0\n"), numbered(simplices).count, Simplex().size());
    put_lines(text, simplices, first, [&](std::size_t i) { return simplices[i]; });
    text.flush();
}

template <class Simplex>
void write_neigh_of(std::ostream& out, std::span<const Simplex> simplices,
                    std::span<const Simplex> neighbours, int first) {
    const auto finite = numbered(simplices);
    TextWriter text(out);
    text.put(FMT_COMPILE("{} {}\n"), finite.count, Simplex().size());
    put_lines(text, simplices, first, [&](std::size_t i) {
        Simplex across = neighbours[i];
        for (Index& each : across) each = finite.numbers[static_cast<std::size_t>(each)];
        return across;
    });
    text.flush();
}

/// The cells where they are tetrahedra.
std::span<const SpaceCell> solid(const SpaceTessellation& tessellation) {
    if (tessellation.dimension < 3) return {};
    return tessellation.cells;
}

}  // namespace

void write_csv(std::ostream& out, const Tessellation& tessellation) {
    write_csv_of(out, tessellation.faces(), 3);
}
void write_csv(std::ostream& out, const SpaceTessellation& tessellation) {
    write_csv_of(out, std::span(tessellation.cells),
                 static_cast<std::size_t>(tessellation.dimension) + 1);
}

void write_npy(std::ostream& out, const Tessellation& tessellation) {
    put_npy_head(out, "i4", tessellation.faces().size(), 3);
    write_i32(out, tessellation);
}
void write_npy(std::ostream& out, const SpaceTessellation& tessellation) {
    put_npy_head(out, "i4", tessellation.cells.size(),
                 static_cast<std::size_t>(tessellation.dimension) + 1);
    write_i32(out, tessellation);
}
void write_i32(std::ostream& out, const Tessellation& tessellation) {
    put_bytes_of(out, tessellation.faces(), 3);
}
void write_i32(std::ostream& out, const SpaceTessellation& tessellation) {
    put_bytes_of(out, std::span(tessellation.cells),
                 static_cast<std::size_t>(tessellation.dimension) + 1);
}

void write_ele(std::ostream& out, const Tessellation& tessellation, int first) {
    write_ele_of(out, tessellation.faces(), first);
}
void write_ele(std::ostream& out, const SpaceTessellation& tessellation, int first) {
    write_ele_of(out, solid(tessellation), first);
}

void write_neigh(std::ostream& out, const Tessellation& tessellation, int first) {
    write_neigh_of(out, tessellation.faces(), tessellation.neighbours(), first);
}
void write_neigh(std::ostream& out, const SpaceTessellation& tessellation, int first) {
    write_neigh_of(out, solid(tessellation), std::span(tessellation.neighbours), first);
}

// ---- meshes ------------------------------------------------------------------------------------

void write_obj(std::ostream& out, const Tessellation& tessellation) {
    TextWriter text(out);
    text.put(FMT_COMPILE("# signum: {} tessellation, a vertex a site\n"),
             name_of(tessellation.metric()));
    if (!traits_of(tessellation.metric()).edges_are_straight) {
        text.put("# edges are curved in this metric; drawn straight, faces may overlap or turn\n");
    }
    for (const Site& site : tessellation.sites()) {
        text.put(FMT_COMPILE("v {} {} 0\n"), site.x, site.y);
    }
    for (const auto [a, b, c] : tessellation.faces()) {
        if (a == infinite) continue;
        text.put(FMT_COMPILE("f {} {} {}\n"), a + std::int64_t{1}, b + std::int64_t{1},
                 c + std::int64_t{1});
    }
    text.flush();
}

namespace {

/// An element with the numbers of its vertices from 1.
void put_element(TextWriter& text, char kind, std::span<const Index> vertices) {
    text.put(FMT_COMPILE("{}"), kind);
    for (const Index vertex : vertices) text.put(FMT_COMPILE(" {}"), vertex + std::int64_t{1});
    text.put("\n");
}

void put_facets(TextWriter& text, const SpaceTessellation& tessellation) {
    const auto& cells = tessellation.cells;
    text.put("g hull\n");
    for (const auto& [apex, a, b, c] : cells)
        if (apex == infinite) put_element(text, 'f', std::array{a, c, b});
    text.put("g inside\n");
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c][0] == infinite) continue;
        for (std::size_t k = 0; k < 4; ++k) {
            // From the first of two cells that share a facet, and away from it.
            const auto across = static_cast<std::size_t>(tessellation.neighbours[c][k]);
            if (across <= c || cells[across][0] == infinite) continue;
            const auto& [i, j, m] = spatial::facet_of[k];
            put_element(text, 'f', std::array{cells[c][i], cells[c][j], cells[c][m]});
        }
    }
}

void put_head(TextWriter& text, std::string_view what, std::size_t vertices, WeightIs weight_is) {
    text.put(FMT_COMPILE("ply\nformat ascii 1.0\ncomment signum: {}\nelement vertex {}\n"
                         "property double x\nproperty double y\nproperty double z\n"
                         "property double {}\n"),
             what, vertices, name_of(weight_is));
}

}  // namespace

void write_obj(std::ostream& out, const SpaceTessellation& tessellation,
               std::span<const Site3> sites) {
    TextWriter text(out);
    text.put("# signum: power tessellation of space, a vertex a site\n");
    for (const auto& [x, y, z, r] : sites) text.put(FMT_COMPILE("v {} {} {}\n"), x, y, z);
    if (tessellation.dimension == 3) {
        put_facets(text, tessellation);
    } else {
        const auto vertices = static_cast<std::size_t>(tessellation.dimension + 1);
        for (const SpaceCell& cell : tessellation.cells)
            if (cell[0] != infinite)
                put_element(text, "plf"[vertices - 1], std::span(cell).first(vertices));
    }
    text.flush();
}

void write_ply(std::ostream& out, const Tessellation& tessellation) {
    const auto is_finite = [](const Face& face) { return face[0] != infinite; };
    const auto sites = tessellation.sites();
    const auto faces = tessellation.faces();
    TextWriter text(out);
    put_head(text, fmt::format("{} tessellation", name_of(tessellation.metric())), sites.size(),
             tessellation.weight_is());
    text.put(FMT_COMPILE("element face {}\nproperty list uchar int vertex_indices\nend_header\n"),
             std::ranges::count_if(faces, is_finite));
    for (const auto& [x, y, r] : sites) text.put(FMT_COMPILE("{} {} 0 {}\n"), x, y, r);
    for (const Face& face : faces)
        if (is_finite(face)) text.put(FMT_COMPILE("3 {}\n"), fmt::join(face, " "));
    text.flush();
}

void write_ply(std::ostream& out, std::span<const Site3> sites, WeightIs weight_is) {
    TextWriter text(out);
    put_head(text, "sites in space", sites.size(), weight_is);
    text.put("end_header\n");
    for (const auto& [x, y, z, r] : sites) text.put(FMT_COMPILE("{} {} {} {}\n"), x, y, z, r);
    text.flush();
}

// ---- VTK ---------------------------------------------------------------------------------------

namespace {

/// The columns that a point has.
template <class Sites>
std::vector<VtkColumn> columns_of(const Sites& sites, WeightIs weight_is,
                                  std::span<const Hidden> hidden) {
    VtkColumn third = {std::string(name_of(weight_is)), false, {}};
    for (const auto& site : sites) third.values.push_back(site.r);
    VtkColumn is_hidden = {"hidden", true, std::vector<double>(sites.size(), 0.0)};
    for (const auto& [site, by] : hidden) is_hidden.values[static_cast<std::size_t>(site)] = 1.0;
    return {std::move(third), std::move(is_hidden)};
}

/// Those between sites that no finite face has, sorted.
std::vector<Edge> edges_without_face(const Tessellation& tessellation) {
    std::vector<Edge> bounding;
    for (const Face& face : tessellation.faces()) {
        if (face[0] == infinite) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(face[k], face[(k + 1) % 3]);
            bounding.push_back({a, b});
        }
    }
    std::ranges::sort(bounding);
    std::vector<Edge> result;
    for (const Edge& edge : tessellation.edges())
        if (edge[0] != infinite && !std::ranges::binary_search(bounding, edge))
            result.push_back(edge);
    return result;
}

}  // namespace

VtkGrid vtk_grid(const Tessellation& tessellation) {
    VtkGrid grid;
    grid.title = fmt::format("signum: {} tessellation", name_of(tessellation.metric()));
    for (const Site& site : tessellation.sites()) grid.points.push_back({site.x, site.y, 0.0});
    for (const Edge& edge : edges_without_face(tessellation)) grid.add_cell(VtkCell::line, edge);
    for (const Face& face : tessellation.faces())
        if (face[0] != infinite) grid.add_cell(VtkCell::triangle, face);
    grid.of_points =
        columns_of(tessellation.sites(), tessellation.weight_is(), tessellation.hidden());
    return grid;
}

VtkGrid vtk_grid(const SpaceTessellation& tessellation, std::span<const Site3> sites,
                 WeightIs weight_is) {
    constexpr std::array kinds = {VtkCell::vertex, VtkCell::line, VtkCell::triangle,
                                  VtkCell::tetrahedron};
    const auto dimension = static_cast<std::size_t>(tessellation.dimension);
    VtkGrid grid;
    grid.title = "signum: power tessellation of space";
    for (const auto& [x, y, z, r] : sites) grid.points.push_back({x, y, z});
    for (const SpaceCell& cell : tessellation.cells)
        if (cell[0] != infinite)
            grid.add_cell(kinds.at(dimension), std::span(cell).first(dimension + 1));
    grid.of_points = columns_of(sites, weight_is, tessellation.hidden);
    return grid;
}

}  // namespace signum
