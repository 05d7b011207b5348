#pragma once
/// Incremental insertion: one site at a time into a tessellation of the sphere.
///
/// The faces in conflict with the new site form a disc around it. Their boundary, joined to the site,
/// replaces them; sites that the disc encloses become hidden, and stay hidden whatever comes later.
/// A site that conflicts not even with the face that contains its centre is hidden itself.
/// Source: Gavrilova 1998, 4.2; Edelsbrunner and Shah 1996.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <signum/core/index.hpp>
#include <signum/triangulation/locate.hpp>
#include <signum/triangulation/topology.hpp>
#include <signum/triangulation/triangulate.hpp>

namespace signum::triangulation {

template <class Kernel>
class Insertion {
 public:
    /// Starts from three sites with ccw(a, b, c) > 0. hidden_by[i] becomes the site that hid i, visible
    /// or not by now, and is -1 while i is visible; it has room for every site.
    Insertion(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, Index a, Index b,
              Index c)
        : topology_(topology), kernel_(kernel), hidden_by_(hidden_by) {
        const Index corners[3] = {a, b, c};
        const Index inner = topology_.add_face(a, b, c);
        Index outer[3];
        for (int k = 0; k < 3; ++k)
            outer[k] = topology_.add_face(corners[(k + 1) % 3], corners[k], infinite);
        for (unsigned k = 0; k < 3; ++k) {
            topology_.glue(edge(inner, k), edge(outer[k], 0));
            topology_.glue(edge(outer[k], 1), edge(outer[(k + 2) % 3], 2));
        }
        recent_ = inner;
    }

    /// Inserts site q. Throws BrokenStructure where inexact arithmetic made nonsense.
    void insert(Index q) {
        const Index start = locate(topology_, kernel_, recent_, q);
        if (!conflicts(start, q)) {
            hide_in(start, q);
            return;
        }
        collect(start, q);
        if (boundary_.size() != removed_.size() + 2) hide_enclosed(q);
        retriangulate(q);
    }

 private:
    /// The mark of a face that the site at hand removes.
    static constexpr Index in_conflict = 1;

    /// An edge of the disc's boundary: the half-edge outside, and the vertex where it ends outside,
    /// where it begins for one who walks around the disc counterclockwise.
    struct BoundaryEdge {
        HalfEdge outside;
        Index from;
    };

    [[nodiscard]] static HalfEdge edge(Index f, unsigned k) noexcept {
        return Topology::first_edge(f) + k;
    }

    [[nodiscard]] bool conflicts(Index f, Index q) {
        if (topology_.is_infinite(f)) [[unlikely]] {
            const HalfEdge h = topology_.finite_edge(f);
            return kernel_.conflicts_infinite(topology_.target(h), topology_.origin(h), q);
        }
        const auto& v = topology_.vertices(f);
        return kernel_.conflicts(v[0], v[1], v[2], q);
    }

    /// Finds all faces in conflict, from one of them, and the boundary in counterclockwise order: a
    /// depth-first search that takes the edges of each face in that order.
    void collect(Index start, Index q) {
        boundary_.clear();
        removed_.clear();
        pending_.clear();
        const auto take = [this](Index f) {
            topology_.set_mark(f, in_conflict);
            removed_.push_back(f);
        };
        take(start);
        for (const unsigned k : {2U, 1U, 0U}) pending_.push_back(edge(start, k));
        while (!pending_.empty()) {
            const HalfEdge h = pending_.back();
            pending_.pop_back();
            const HalfEdge across = topology_.twin(h);
            const Index f = Topology::face(across);
            if (topology_.mark(f) == in_conflict) continue;
            if (conflicts(f, q)) {
                take(f);
                pending_.push_back(Topology::previous(across));
                pending_.push_back(Topology::next(across));
            } else {
                boundary_.push_back({across, topology_.origin(h)});
            }
        }
        if constexpr (!Kernel::is_exact) check_boundary();
    }

    /// The boundary of a disc is one closed walk. Rounded signs can make the region an annulus or all
    /// of the sphere.
    void check_boundary() const {
        bool closed = boundary_.size() >= 2;
        for (std::size_t i = 0; closed && i < boundary_.size(); ++i)
            closed = topology_.origin(boundary_[i].outside) ==
                     boundary_[(i + 1) % boundary_.size()].from;
        if (!closed) throw BrokenStructure("the conflict region of a site is not a disc");
    }

    /// Joins q to every edge of the boundary, reusing the slots of the removed faces.
    void retriangulate(Index q) {
        const std::size_t count = boundary_.size();
        for (const Index f : removed_) topology_.set_mark(f, 0);
        while (removed_.size() < count) {
            if (vacant_.empty()) {
                removed_.push_back(topology_.add_face(infinite, infinite, infinite));
            } else {
                removed_.push_back(vacant_.back());
                vacant_.pop_back();
            }
        }
        Index before = removed_[count - 1];
        for (std::size_t i = 0; i < count; ++i) {
            const Index f = removed_[i];
            const Index to = boundary_[i + 1 < count ? i + 1 : 0].from;
            topology_.set_face(f, boundary_[i].from, to, q);
            topology_.glue(edge(f, 0), boundary_[i].outside);
            topology_.glue(edge(f, 2), edge(before, 1));
            before = f;
        }
        for (std::size_t i = count; i < removed_.size(); ++i) {
            topology_.set_face(removed_[i], Topology::vacant, Topology::vacant, Topology::vacant);
            vacant_.push_back(removed_[i]);
        }
        recent_ = before;
    }

    /// q is hidden in face f. Any finite corner will do: who hides it is settled at the end.
    void hide_in(Index f, Index q) {
        const auto& v = topology_.vertices(f);
        hidden_by_[static_cast<std::size_t>(q)] = v[0] != infinite ? v[0] : v[1];
        recent_ = f;
    }

    /// Vertices of the removed faces that are not on the boundary vanish behind q.
    void hide_enclosed(Index q) {
        std::vector<Index> kept;
        for (const BoundaryEdge& edge : boundary_) kept.push_back(edge.from);
        std::sort(kept.begin(), kept.end());
        for (const Index f : removed_)
            for (const Index v : topology_.vertices(f)) {
                if (std::binary_search(kept.begin(), kept.end(), v)) continue;
                if (v == infinite) throw BrokenStructure("the hull vanished");
                hidden_by_[static_cast<std::size_t>(v)] = q;
            }
    }

    Topology& topology_;
    Kernel& kernel_;
    std::span<Index> hidden_by_;
    Index recent_ = 0;
    std::vector<HalfEdge> pending_;
    std::vector<Index> removed_;
    std::vector<BoundaryEdge> boundary_;
    std::vector<Index> vacant_;
};

}  // namespace signum::triangulation
