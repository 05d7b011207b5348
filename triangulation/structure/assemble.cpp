#include "assemble.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace signum::triangulation {
namespace {

std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// A face with ranks for vertices, turned to begin at the smallest, and its first half-edge.
/// Three numbers, not an array: these stay in registers.
struct Turned {
    Index a;
    Index b;
    Index c;
    HalfEdge first;
};

inline Turned turn(const Topology& topology, std::span<const Index> rank, Index f) noexcept {
    const auto& v = topology.vertices(f);
    const auto of = [&](Index vertex) { return vertex == infinite ? infinite : rank[at(vertex)]; };
    const Index a = of(v[0]);
    const Index b = of(v[1]);
    const Index c = of(v[2]);
    // By arithmetic, not branches: which vertex is smallest is anybody's guess.
    const auto at_c = static_cast<HalfEdge>(c < a) & static_cast<HalfEdge>(c < b);
    const auto at_b = static_cast<HalfEdge>(b < a) & (at_c ^ 1);
    const HalfEdge k = at_b + 2 * at_c;
    const Index twice[5] = {a, b, c, a, b};
    return {twice[k], twice[k + 1], twice[k + 2], Topology::first_edge(f) + k};
}

/// The number that leads a face in the sorted order: infinite faces come first and are led by their
/// second vertex, of which each has one of its own; finite ones by their smallest.
std::size_t lead(Index first, Index second, std::size_t sites) noexcept {
    return first == infinite ? at(second) : sites + at(first);
}

/// Vertices lie along the Hilbert curve in the topology and anywhere in the input, so that faces
/// sorted by input numbers jump about in memory. They are dealt into blocks of consecutive leads
/// first, few enough that each block's next place stays in the cache, small enough that a block
/// does.
constexpr std::size_t leads_per_block = 8192;

/// A face of the result, its neighbours and itself as faces of the topology.
struct Entry {
    Face face;
    Face neighbours;
    Index from;
};

/// Sorts one block: by lead through counting, the few faces that share it by comparing.
class BlockSort {
 public:
    explicit BlockSort(std::size_t sites) : sites_(sites) {}

    /// Deals the block into buckets, one a lead.
    void deal(std::span<const Face> faces, std::span<const Face> neighbours,
              std::span<const Index> from) {
        starts_.fill(0);
        for (const Face& face : faces) ++starts_[bucket(face) + 1];
        for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
        entries_.resize(faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i)
            entries_[starts_[bucket(faces[i])]++] = {faces[i], neighbours[i], from[i]};
    }

    /// Calls emit(place, entry) for every entry with its place in the sorted block.
    template <class Emit>
    void emit(Emit emit) {
        for (std::size_t first = 0, b = 0; first < entries_.size(); first = starts_[b++]) {
            const std::size_t last = starts_[b];
            if (last - first == 2) {
                // Most often; by selecting, for which comes first is anybody's guess.
                const std::size_t swapped = key(entries_[first + 1]) < key(entries_[first]);
                emit(first, entries_[first + swapped]);
                emit(first + 1, entries_[first + 1 - swapped]);
                continue;
            }
            if (last - first > few) {
                std::sort(&entries_[first], &entries_[last - 1] + 1, before);
                for (std::size_t i = first; i < last; ++i) emit(i, entries_[i]);
                continue;
            }
            // Nearly all buckets hold two or three faces. Counting those that come before each
            // takes more comparisons than sorting and no branch that would be guessed.
            for (std::size_t i = first; i < last; ++i) {
                std::size_t place = first;
                for (std::size_t k = first; k < last; ++k)
                    place += static_cast<std::size_t>(key(entries_[k]) < key(entries_[i]));
                // Equal triples, in metrics that have them, stay in the order of the topology.
                for (std::size_t k = first; k < i; ++k)
                    place += static_cast<std::size_t>(key(entries_[k]) == key(entries_[i]));
                emit(place, entries_[i]);
            }
        }
    }

 private:
    static constexpr std::size_t few = 12;

    [[nodiscard]] std::size_t bucket(const Face& face) const noexcept {
        return lead(face[0], face[1], sites_) % leads_per_block;
    }
    /// The second and third vertex, neither of which is negative.
    [[nodiscard]] static std::uint64_t key(const Entry& entry) noexcept {
        return static_cast<std::uint64_t>(entry.face[1]) << 32 |
               static_cast<std::uint64_t>(entry.face[2]);
    }
    [[nodiscard]] static bool before(const Entry& a, const Entry& b) noexcept {
        return key(a) < key(b);
    }

    std::size_t sites_;
    std::array<std::size_t, leads_per_block + 1> starts_;
    LargeArray<Entry> entries_;
};

}  // namespace

void assemble(Topology topology, std::span<const Index> number, std::span<const Index> rank,
              TessellationArrays& result, const Workers& workers) {
    const auto slots = static_cast<std::size_t>(topology.faces());
    const std::size_t blocks = 2 * rank.size() / leads_per_block + 1;
    const auto block_of = [&](const Turned& face) {
        return lead(face.a, face.b, rank.size()) / leads_per_block;
    };
    // Where ranks are no numbers, the numbers by rank.
    LargeArray<Index> numbers;
    if (rank.data() != number.data()) {
        numbers = LargeArray<Index>(rank.size());
        for (std::size_t v = 0; v < rank.size(); ++v) numbers[at(rank[v])] = number[v];
    }
    const auto number_of = [&](Index r) { return r == infinite ? infinite : numbers[at(r)]; };
    // The neighbours are faces of the topology until the place of every face is known.
    LargeArray<Index> from;
    const std::vector<std::size_t> starts = deal(
        workers, slots, blocks,
        [&](std::size_t f) {
            const auto face = static_cast<Index>(f);
            return topology.is_vacant(face) ? blocks : block_of(turn(topology, rank, face));
        },
        [&](std::size_t count) {
            make_room(workers, count, result.faces, result.neighbours);
            from = LargeArray<Index>(count);
        },
        [&](std::size_t f, std::size_t i) {
            const Turned turned = turn(topology, rank, static_cast<Index>(f));
            const auto across = [&](HalfEdge h) { return Topology::face(topology.twin(h)); };
            result.faces[i] = {turned.a, turned.b, turned.c};
            // The edge opposite the first vertex is the one that follows the first edge.
            result.neighbours[i] = {across(Topology::next(turned.first)),
                                    across(Topology::previous(turned.first)), across(turned.first)};
            from[i] = static_cast<Index>(f);
        });
    topology.give_back(workers);
    LargeArray<Index> place(slots);
    const std::size_t groups = std::min(blocks, 8 * static_cast<std::size_t>(workers.count()));
    workers.each(groups, [&](std::size_t group) {
        const auto sort = std::make_unique<BlockSort>(rank.size());
        for (std::size_t b = blocks * group / groups; b < blocks * (group + 1) / groups; ++b) {
            const std::size_t first = starts[b];
            const std::size_t size = starts[b + 1] - first;
            if (size == 0) continue;
            sort->deal({&result.faces[first], size}, {&result.neighbours[first], size},
                       {&from[first], size});
            sort->emit([&](std::size_t i, const Entry& entry) {
                const auto& [a, b, c] = entry.face;
                result.faces[first + i] =
                    numbers.empty() ? entry.face : Face{number_of(a), number_of(b), number_of(c)};
                result.neighbours[first + i] = entry.neighbours;
                place[at(entry.from)] = static_cast<Index>(first + i);
            });
        }
    });
    workers.each_range(result.neighbours.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (Index& f : result.neighbours[i]) f = place[at(f)];
    });
    give_back(workers, from, place, numbers);
}

}  // namespace signum::triangulation
