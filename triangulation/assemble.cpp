#include <signum/triangulation/assemble.hpp>

#include <algorithm>
#include <memory>

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

void assemble(const Topology& topology, std::span<const Index> original,
              TessellationArrays& result) {
    const auto number = [&](Index v) { return v == infinite ? infinite : original[at(v)]; };
    // The half-edge at which a face begins in the result: at its smallest vertex.
    const auto begin_of = [&](Index f) {
        const auto& v = topology.vertices(f);
        const Face face{number(v[0]), number(v[1]), number(v[2])};
        const unsigned k = face[0] < face[1] ? (face[0] < face[2] ? 0U : 2U)
                                             : (face[1] < face[2] ? 1U : 2U);
        return Topology::first_edge(f) + k;
    };

    // Vertices lie along the Hilbert curve in the topology and anywhere in the input. So the passes go
    // through the topology in its own order and scatter no more than they must: faces are counted by
    // their smallest vertex, dealt into that vertex's range and sorted inside it.
    std::vector<Index> range(original.size() + 2, 0);
    for (Index f = 0; f < topology.faces(); ++f)
        if (!topology.is_vacant(f)) ++range[at(number(topology.origin(begin_of(f))) + 2)];
    for (std::size_t v = 1; v < range.size(); ++v) range[v] += range[v - 1];
    const std::size_t count = at(range.back());
    const auto entries = std::make_unique_for_overwrite<Entry[]>(count);
    for (Index f = 0; f < topology.faces(); ++f) {
        if (topology.is_vacant(f)) continue;
        const HalfEdge h = begin_of(f);
        const Index least = number(topology.origin(h));
        entries[at(range[at(least + 1)]++)] = {
            {least, number(topology.target(h)), number(topology.apex(h))}, f};
    }

    result.faces.resize(count);
    std::vector<Index> place(at(topology.faces()));  // of each face in the result
    for (std::size_t from = 0, v = 0; from < count; from = at(range[v++])) {
        const std::size_t to = at(range[v]);
        sort({&entries[from], to - from});
        for (std::size_t i = from; i < to; ++i) {
            result.faces[i] = entries[i].face;
            place[at(entries[i].from)] = static_cast<Index>(i);
        }
    }
    result.neighbours.resize(count);
    for (Index f = 0; f < topology.faces(); ++f) {
        if (topology.is_vacant(f)) continue;
        const HalfEdge h = begin_of(f);
        const auto across = [&](HalfEdge g) { return place[at(Topology::face(topology.twin(g)))]; };
        // The edge opposite the first vertex is the one that follows the first edge.
        result.neighbours[at(place[at(f)])] = {across(Topology::next(h)),
                                               across(Topology::previous(h)), across(h)};
    }
}

}  // namespace signum::triangulation
