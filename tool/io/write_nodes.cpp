#include "write_nodes.hpp"

#include <cstddef>
#include <vector>

#include "text_writer.hpp"

namespace signum {
namespace {

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

/// A line for each finite simplex: its number, and the numbers that `told` gives of it.
template <class Simplex, class Told>
void put_lines(TextWriter& text, std::span<const Simplex> simplices, const Told& told) {
    Index number = 0;
    for (std::size_t i = 0; i < simplices.size(); ++i)
        if (simplices[i][0] != infinite)
            text.put(FMT_COMPILE("{} {}\n"), number++, fmt::join(told(i), " "));
}

template <class Simplex>
void write_ele_of(std::ostream& out, std::span<const Simplex> simplices) {
    TextWriter text(out);
    text.put(FMT_COMPILE("{} {} 0\n"), numbered(simplices).count, Simplex().size());
    put_lines(text, simplices, [&](std::size_t i) { return simplices[i]; });
    text.flush();
}

template <class Simplex>
void write_neigh_of(std::ostream& out, std::span<const Simplex> simplices,
                    std::span<const Simplex> neighbours) {
    const auto finite = numbered(simplices);
    TextWriter text(out);
    text.put(FMT_COMPILE("{} {}\n"), finite.count, Simplex().size());
    put_lines(text, simplices, [&](std::size_t i) {
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

void write_node(std::ostream& out, std::span<const Site> sites) {
    TextWriter text(out);
    text.put(FMT_COMPILE("{} 2 1 0\n"), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
        text.put(FMT_COMPILE("{} {} {} {}\n"), i, sites[i].x, sites[i].y, sites[i].r);
    text.flush();
}

void write_node(std::ostream& out, std::span<const Site3> sites) {
    TextWriter text(out);
    text.put(FMT_COMPILE("{} 3 1 0\n"), sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i)
        text.put(FMT_COMPILE("{} {} {} {} {}\n"), i, sites[i].x, sites[i].y, sites[i].z,
                 sites[i].r);
    text.flush();
}

void write_ele(std::ostream& out, const Tessellation& tessellation) {
    write_ele_of(out, tessellation.faces());
}
void write_ele(std::ostream& out, const SpaceTessellation& tessellation) {
    write_ele_of(out, solid(tessellation));
}

void write_neigh(std::ostream& out, const Tessellation& tessellation) {
    write_neigh_of(out, tessellation.faces(), tessellation.neighbours());
}
void write_neigh(std::ostream& out, const SpaceTessellation& tessellation) {
    write_neigh_of(out, solid(tessellation), std::span(tessellation.neighbours));
}

}  // namespace signum
