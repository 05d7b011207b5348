#include <signum/triangulation/assemble.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace signum::triangulation {
namespace {

std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }

/// A face with input numbers, turned to begin at its smallest vertex, and its first half-edge.
struct Turned {
    Face face;
    HalfEdge first;
};

inline Turned turn(const Topology& topology, std::span<const Index> original, Index f) noexcept {
    const auto& v = topology.vertices(f);
    const auto number = [&](Index vertex) {
        return vertex == infinite ? infinite : original[at(vertex)];
    };
    const Index a = number(v[0]);
    const Index b = number(v[1]);
    const Index c = number(v[2]);
    // By selections, not branches: which vertex is smallest is anybody's guess.
    const bool at_c = c < std::min(a, b);
    const bool at_b = !at_c && b < a;
    const auto select = [&](Index from_a, Index from_b, Index from_c) {
        return at_c ? from_c : at_b ? from_b : from_a;
    };
    return {{select(a, b, c), select(b, c, a), select(c, a, b)},
            Topology::first_edge(f) + static_cast<HalfEdge>(select(0, 1, 2))};
}

/// Vertices lie along the Hilbert curve in the topology and anywhere in the input, so that faces sorted
/// by input numbers jump about in memory. They are dealt into blocks of consecutive smallest vertices
/// first, few enough that each block's next place stays in the cache, small enough that a block does.
constexpr int vertices_per_block = 8192;
constexpr std::size_t block_of(Index least) noexcept {
    return static_cast<std::size_t>((least + 1) / vertices_per_block);
}

/// A face of the result, its neighbours and itself as faces of the topology.
struct Entry {
    Face face;
    Face neighbours;
    Index from;
};

/// Sorts one block: by smallest vertex through counting, the few faces that share it by comparing.
class BlockSort {
 public:
    [[nodiscard]] std::span<const Entry> operator()(std::span<const Face> faces,
                                                    std::span<const Face> neighbours,
                                                    std::span<const Index> from) {
        starts_.fill(0);
        for (const Face& face : faces) ++starts_[bucket(face) + 1];
        for (std::size_t b = 1; b < starts_.size(); ++b) starts_[b] += starts_[b - 1];
        sorted_.resize(faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i)
            sorted_[starts_[bucket(faces[i])]++] = {faces[i], neighbours[i], from[i]};
        for (std::size_t first = 0, b = 0; first < faces.size(); first = starts_[b++])
            sort({&sorted_[first], starts_[b] - first});
        return sorted_;
    }

 private:
    [[nodiscard]] static std::size_t bucket(const Face& face) noexcept {
        return static_cast<std::size_t>((face[0] + 1) % vertices_per_block);
    }

    /// Nearly all buckets hold two or three faces.
    static void sort(std::span<Entry> bucket) {
        const auto before = [](const Entry& a, const Entry& b) {
            return a.face[1] != b.face[1] ? a.face[1] < b.face[1] : a.face[2] < b.face[2];
        };
        if (bucket.size() > 16) {
            std::sort(bucket.begin(), bucket.end(), before);
            return;
        }
        for (std::size_t i = 1; i < bucket.size(); ++i)
            for (std::size_t k = i; k > 0 && before(bucket[k], bucket[k - 1]); --k)
                std::swap(bucket[k], bucket[k - 1]);
    }

    std::array<std::size_t, vertices_per_block + 1> starts_;
    std::vector<Entry> sorted_;
};

}  // namespace

void assemble(Topology topology, std::span<const Index> original, TessellationArrays& result) {
    const Index slots = topology.faces();
    std::vector<std::size_t> starts(block_of(static_cast<Index>(original.size())) + 2, 0);
    for (Index f = 0; f < slots; ++f)
        if (!topology.is_vacant(f)) ++starts[block_of(turn(topology, original, f).face[0]) + 1];
    for (std::size_t b = 1; b < starts.size(); ++b) starts[b] += starts[b - 1];

    // The neighbours are faces of the topology until the place of every face is known.
    const std::size_t count = starts.back();
    result.faces.resize(count);
    result.neighbours.resize(count);
    LargeArray<Index> from(count);
    std::vector<std::size_t> ends = starts;
    for (Index f = 0; f < slots; ++f) {
        if (topology.is_vacant(f)) continue;
        const auto [face, first] = turn(topology, original, f);
        const auto across = [&](HalfEdge h) { return Topology::face(topology.twin(h)); };
        const std::size_t i = ends[block_of(face[0])]++;
        result.faces[i] = face;
        // The edge opposite the first vertex is the one that follows the first edge.
        result.neighbours[i] = {across(Topology::next(first)), across(Topology::previous(first)),
                                across(first)};
        from[i] = f;
    }
    topology = Topology(0);

    LargeArray<Index> place(at(slots));
    BlockSort sort;
    for (std::size_t b = 0; b + 1 < starts.size(); ++b) {
        const std::size_t first = starts[b];
        const std::size_t size = starts[b + 1] - first;
        const auto sorted = sort({&result.faces[first], size}, {&result.neighbours[first], size},
                                 {&from[first], size});
        for (std::size_t i = 0; i < size; ++i) {
            result.faces[first + i] = sorted[i].face;
            result.neighbours[first + i] = sorted[i].neighbours;
            place[at(sorted[i].from)] = static_cast<Index>(first + i);
        }
    }
    for (Face& neighbours : result.neighbours)
        for (Index& f : neighbours) f = place[at(f)];
}

}  // namespace signum::triangulation
