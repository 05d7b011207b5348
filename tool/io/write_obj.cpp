#include "write_obj.hpp"
#include "text_writer.hpp"

namespace signum {

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
template <class... Vertices>
void put_element(TextWriter& text, char kind, Vertices... vertices) {
    text.put(FMT_COMPILE("{}"), kind);
    (text.put(FMT_COMPILE(" {}"), vertices + std::int64_t{1}), ...);
    text.put("\n");
}

void put_facets(TextWriter& text, const SpaceTessellation& tessellation) {
    const auto& cells = tessellation.cells;
    text.put("g hull\n");
    for (const auto& [apex, a, b, c] : cells)
        if (apex == infinite) put_element(text, 'f', a, c, b);
    text.put("g inside\n");
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto& [a, b, c, d] = cells[cell];
        if (a == infinite) continue;
        // From the first of two cells that share a facet, and away from it.
        const auto is_first = [&](std::size_t k) {
            const auto other = static_cast<std::size_t>(tessellation.neighbours[cell][k]);
            return cell < other && cells[other][0] != infinite;
        };
        if (is_first(0)) put_element(text, 'f', b, c, d);
        if (is_first(1)) put_element(text, 'f', a, d, c);
        if (is_first(2)) put_element(text, 'f', a, b, d);
        if (is_first(3)) put_element(text, 'f', a, c, b);
    }
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
        for (const auto& [a, b, c, none] : tessellation.cells) {
            if (a == infinite) continue;
            if (tessellation.dimension == 2) put_element(text, 'f', a, b, c);
            if (tessellation.dimension == 1) put_element(text, 'l', a, b);
            if (tessellation.dimension == 0) put_element(text, 'p', a);
        }
    }
    text.flush();
}

}  // namespace signum
