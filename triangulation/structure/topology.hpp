#pragma once
/// The combinatorial structure: a triangulation of the sphere as faces with twin half-edges.
///
/// Laws:
///  1. Half-edge 4f+k is edge k of face f, k = 0, 1, 2; it leads from origin(h) to target(h), its
///     face on its left. (Four, not three, so that face and k come from a shift and a mask.)
///  2. twin(h) is the same edge seen from the other face. Twins, not vertices, say what is
///     adjacent: two vertices may share several edges, two faces several edges, a vertex may have
///     degree 2.
///  3. One vertex may be infinite (-1); the structure treats it as any other and knows no
///     coordinate.
///  4. A face that was taken out has `vacant` for vertices and waits for reuse.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/contract.hpp"
#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/pages.hpp"
#include "../../core/parallel.hpp"
#include "cycle.hpp"

namespace signum::triangulation {

/// Unsigned, so that 4·2n fits for max_sites.
using HalfEdge = std::uint32_t;

class Topology {
 public:
    static constexpr Index vacant = -2;

    /// What is stored of a face. Half a cache line, never across two.
    struct alignas(32) Record {
        Index vertex[3];
        Index mark;  ///< a number that an algorithm keeps with a face; 0 when the face is added
        HalfEdge twin[3];
    };

    /// Room for the faces of `sites` sites and no more; vertices never exceed sites + 1.
    explicit Topology(std::size_t sites) { make_room(sites); }
    /// The same; the faces that are there stay. Precondition: the structure is no window.
    void make_room(std::size_t sites) {
        capacity_ = sites < 2 ? 0 : 2 * sites - 2;
        own_.resize(capacity_);
        records_ = own_.data();
    }
    /// Precondition: the other is no window.
    Topology(const Topology& other)
        : faces_(other.faces_),
          capacity_(other.capacity_),
          own_(other.own_),
          records_(own_.data()) {}
    Topology(Topology&&) noexcept = default;
    Topology& operator=(Topology&&) noexcept = default;
    ~Topology() = default;

    /// A structure of its own in a part of this one's room, which nobody else works in meanwhile:
    /// of the faces of `sites` sites from face `first` on. Faces have the numbers that they have
    /// here.
    [[nodiscard]] Topology window(std::size_t first, std::size_t sites) noexcept {
        Topology part(0);
        part.records_ = records_;
        part.first_ = part.faces_ = first;
        part.asked_ = first;
        part.capacity_ = first + (sites < 2 ? 0 : 2 * sites - 2);
        SIGNUM_EXPECTS(part.capacity_ <= capacity_);
        return part;
    }
    /// Nothing is asked any more. Precondition: the structure is no window.
    void give_back(const Workers& workers) {
        signum::give_back(workers, own_);
        *this = Topology(0);
    }
    /// Takes all the room for faces: windows have filled it.
    void use_all() noexcept { faces_ = capacity_; }

    [[nodiscard]] static Index face(HalfEdge h) noexcept { return static_cast<Index>(h >> 2); }
    [[nodiscard]] static HalfEdge first_edge(Index f) noexcept {
        return static_cast<HalfEdge>(f) << 2;
    }
    // By tables of two bits an edge, for which edge of its face h is, is anybody's guess.
    [[nodiscard]] static HalfEdge next(HalfEdge h) noexcept {
        return (h & ~3U) | (0b00'10'01U >> 2 * (h & 3) & 3);
    }
    [[nodiscard]] static HalfEdge previous(HalfEdge h) noexcept {
        return (h & ~3U) | (0b01'00'10U >> 2 * (h & 3) & 3);
    }

    [[nodiscard]] Index origin(HalfEdge h) const noexcept { return at(h).vertex[h & 3]; }
    [[nodiscard]] Index target(HalfEdge h) const noexcept { return origin(next(h)); }
    /// The vertex of the face that is not on the edge.
    [[nodiscard]] Index apex(HalfEdge h) const noexcept { return origin(previous(h)); }
    [[nodiscard]] HalfEdge twin(HalfEdge h) const noexcept { return at(h).twin[h & 3]; }
    /// The vertices of the faces at an edge: its origin and target, the apex and that across.
    [[nodiscard]] std::array<Index, 4> about(HalfEdge h) const noexcept {
        return {origin(h), target(h), apex(h), apex(twin(h))};
    }
    /// The name of an edge: the lesser of its two half-edges.
    [[nodiscard]] HalfEdge edge(HalfEdge h) const noexcept { return std::min(h, twin(h)); }
    /// The next half-edge out of the same origin, counterclockwise.
    [[nodiscard]] HalfEdge around_origin(HalfEdge h) const noexcept { return twin(previous(h)); }
    /// All half-edges out of the origin of h, counterclockwise from h: a range for a range-for. The
    /// structure must not change on the way.
    [[nodiscard]] auto fan(HalfEdge h) const noexcept {
        return Cycle(h, [this](HalfEdge of) noexcept { return around_origin(of); });
    }
    /// The half-edge of face f out of v. Precondition: v is a vertex of f.
    [[nodiscard]] HalfEdge spoke(Index f, Index v) const noexcept {
        HalfEdge h = first_edge(f);
        while (origin(h) != v) ++h;
        return h;
    }
    /// The three vertices of a face, counterclockwise.
    [[nodiscard]] const Index (&vertices(Index f) const noexcept)[3] {
        return at(first_edge(f)).vertex;
    }

    /// How many faces there is room for.
    [[nodiscard]] std::size_t room() const noexcept { return capacity_ - first_; }
    /// Face slots in use, vacant ones included.
    [[nodiscard]] Index faces() const noexcept { return static_cast<Index>(faces_); }
    [[nodiscard]] bool is_vacant(Index f) const noexcept { return vertices(f)[0] == vacant; }
    /// Whether infinity is a vertex of the face.
    [[nodiscard]] bool is_infinite(Index f) const noexcept {
        const auto& v = vertices(f);
        return (v[0] | v[1] | v[2]) < 0;
    }
    /// The edge of an infinite face that does not touch infinity. Precondition: is_infinite(f).
    [[nodiscard]] HalfEdge finite_edge(Index f) const noexcept {
        const auto& v = vertices(f);
        return first_edge(f) + (v[0] < 0 ? 1U : v[1] < 0 ? 2U : 0U);
    }

    /// A new face; its edges have no twins yet. Precondition: the faces of the tessellation fit.
    Index add_face(Index a, Index b, Index c) noexcept {
        SIGNUM_EXPECTS(faces_ < capacity_);
        if (faces_ >= asked_) [[unlikely]]
            ask_for_pages();
        const auto f = static_cast<Index>(faces_++);
        record(f) = {{a, b, c}, 0, {0, 0, 0}};
        return f;
    }
    /// Takes a face out.
    void vacate(Index f) noexcept { record(f) = {{vacant, vacant, vacant}, 0, {0, 0, 0}}; }
    /// For algorithms that rewrite whole faces at a time.
    [[nodiscard]] Record& record(Index f) noexcept { return at(first_edge(f)); }
    [[nodiscard]] const Record& record(Index f) const noexcept { return at(first_edge(f)); }
    void glue(HalfEdge h, HalfEdge g) noexcept {
        at(h).twin[h & 3] = g;
        at(g).twin[g & 3] = h;
    }

 private:
    [[nodiscard]] const Record& at(HalfEdge h) const noexcept {
        SIGNUM_EXPECTS((h >> 2) < faces_ && (h & 3) < 3);
        return records_[h >> 2];
    }
    [[nodiscard]] Record& at(HalfEdge h) noexcept {
        return const_cast<Record&>(std::as_const(*this).at(h));
    }

    /// Half a megabyte of them at a time: they are filled one after the other.
    [[gnu::noinline]] void ask_for_pages() noexcept {
        constexpr std::size_t step = std::size_t{1} << 14;
        expect_writes(records_ + faces_, std::min(step, capacity_ - faces_) * sizeof(Record));
        asked_ = faces_ + step;
    }

    /// In numbers of faces.
    std::size_t first_ = 0;
    std::size_t faces_ = 0;
    std::size_t capacity_ = 0;
    std::size_t asked_ = 0;
    LargeArray<Record> own_;
    Record* records_ = nullptr;  ///< of face 0, in own_ or, of a window, in another structure
};

/// A face at every visible vertex, -1 for the hidden ones.
[[nodiscard]] inline std::vector<Index> faces_of_vertices(const Topology& topology,
                                                          std::size_t sites,
                                                          const Workers& workers) {
    std::vector<Index> result(sites, -1);
    workers.each_range(
        static_cast<std::size_t>(topology.faces()), [&](std::size_t begin, std::size_t end) {
            for (auto f = static_cast<Index>(begin); f < static_cast<Index>(end); ++f)
                for (const Index v : topology.vertices(f)) {
                    if (v < 0) continue;
                    // Others may write theirs: any of them will do.
                    std::atomic_ref(result[static_cast<std::size_t>(v)])
                        .store(f, std::memory_order_relaxed);
                }
        });
    return result;
}

}  // namespace signum::triangulation
