#include <signum/triangulation/assemble.hpp>

#include <algorithm>
#include <utility>

namespace signum::triangulation {
namespace {

std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }

/// A face of the result and the face of the topology that it comes from.
struct Entry {
    Face face;
    Index from;
};

/// Insertion sort: nearly all ranges hold two or three faces.
void sort(std::span<Entry> entries) {
    const auto before = [](const Entry& a, const Entry& b) { return a.face < b.face; };
    if (entries.size() > 16) {
        std::sort(entries.begin(), entries.end(), before);
        return;
    }
    for (std::size_t i = 1; i < entries.size(); ++i)
        for (std::size_t k = i; k > 0 && before(entries[k], entries[k - 1]); --k)
            std::swap(entries[k], entries[k - 1]);
}

}  // namespace

void assemble(Topology topology, std::span<const Index> original, TessellationArrays& result) {
    // Vertices lie along the Hilbert curve in the topology and anywhere in the input. So the passes go
    // through the topology in its own order, scatter no more than they must, and ask for the memory
    // that they will scatter to a little ahead.
    constexpr Index ahead = 16;
    const Index slots = topology.faces();

    // Input numbers, and every face turned to begin at its smallest vertex; a count of faces by it.
    LargeArray<Index> range(original.size() + 2, 0);
    for (Index f = 0; f < slots; ++f) {
        if (topology.is_vacant(f)) continue;
        topology.renumber(f, original);
        ++range[at(topology.vertices(f)[0] + 2)];
    }
    for (std::size_t v = 1; v < range.size(); ++v) range[v] += range[v - 1];
    const std::size_t count = at(range[range.size() - 1]);

    // Faces dealt into the ranges of their smallest vertices and sorted inside them.
    LargeArray<Entry> entries(count);
    for (Index f = 0; f < slots; ++f) {
        if (f + ahead < slots && !topology.is_vacant(f + ahead))
            __builtin_prefetch(&entries[at(range[at(topology.vertices(f + ahead)[0] + 1)])], 1);
        if (topology.is_vacant(f)) continue;
        const auto& v = topology.vertices(f);
        entries[at(range[at(v[0] + 1)]++)] = {{v[0], v[1], v[2]}, f};
    }
    result.faces.resize(count);
    for (std::size_t from = 0, v = 0; from < count; from = at(range[v++])) {
        const std::size_t to = at(range[v]);
        sort({&entries[from], to - from});
        for (std::size_t i = from; i < to; ++i) {
            if (i + ahead < count) topology.prefetch(entries[i + ahead].from);
            result.faces[i] = entries[i].face;
            topology.set_mark(entries[i].from, static_cast<Index>(i));
        }
    }
    entries = {};
    range = {};

    result.neighbours.resize(count);
    for (Index f = 0; f < slots; ++f) {
        if (f + ahead < slots && !topology.is_vacant(f + ahead))
            __builtin_prefetch(&result.neighbours[at(topology.mark(f + ahead))], 1);
        if (topology.is_vacant(f)) continue;
        const HalfEdge h = Topology::first_edge(f);
        const auto across = [&](HalfEdge g) {
            return topology.mark(Topology::face(topology.twin(g)));
        };
        // The edge opposite the first vertex is the one that follows the first edge.
        result.neighbours[at(topology.mark(f))] = {across(h + 1), across(h + 2), across(h)};
    }
}

}  // namespace signum::triangulation
