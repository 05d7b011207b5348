#pragma once
/// From a tessellation for some centres to one for others, near by.
///
/// What is right for the new centres stays (local_checks.hpp). What is wrong is mended in two ways:
///  - an edge is flipped, if the two faces and the edge that come of it are right for the new
///    centres; then the edges around it are looked at again;
///  - otherwise a site is taken out: one at a face that may be none, or one that stands in the way
///    of a flip. It is put in again when all is over, by whoever takes it out.
///
/// Deletion is for tessellations that are right. So sites are taken out for the old centres, from
/// the structure as it was: before all flips, or after these are undone. Then it is flipped again.
/// Every round but the last takes out a site; where rounds are too many, nothing is promised and
/// all must be built anew.
///
/// Nothing has to be shown about the way: what the flips and deletions leave is a sphere of faces,
/// each of which was asked about, and all of whose edges were.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../structure/flip.hpp"
#include "../structure/topology.hpp"
#include "local_checks.hpp"

namespace signum::triangulation {

template <class Kernel>
class Repair {
 public:
    /// The kernel is that of the new centres. face_of: a face at every visible site, which is kept
    /// true. None is copied.
    Repair(Topology& topology, Kernel& moved, std::span<Index> face_of)
        : topology_(topology), checks_(topology, moved), kernel_(moved), face_of_(face_of) {}

    /// Looks at everything, and tells how many faces and edges are wrong; where they are more than
    /// `most`, some more than that.
    [[nodiscard]] std::size_t survey(std::size_t most) {
        const auto wrong = [&] { return faces_.size() + edges_.size(); };
        checks_.survey([&](Index face) { faces_.push_back(face); },
                       [&](HalfEdge edge) { edges_.push_back(edge); },
                       [&] { return wrong() > most; });
        return wrong();
    }
    /// How many edges have been flipped.
    [[nodiscard]] std::size_t flips() const noexcept { return journal_.size(); }

    /// Makes all right; false where that takes too long, more than `most` sites would have to be
    /// taken out, or one could not. take_out(site, look_at) takes a visible site out for the old
    /// centres, calls look_at for all faces that were not there before, and returns whether there
    /// is a structure left.
    template <class TakeOut>
    [[nodiscard]] bool mend(std::size_t most, const TakeOut& take_out) {
        constexpr int most_rounds = 32;
        std::size_t taken = 0;
        const auto take = [&](Index site) {
            return ++taken <= most && take_out(site, [&](Index f) {
                faces_.push_back(f);
                for (unsigned k = 0; k < 3; ++k) edges_.push_back(Topology::first_edge(f) + k);
            });
        };
        for (int round = 0; round < most_rounds; ++round) {
            while (!faces_.empty()) {
                const Index f = faces_.back();
                faces_.pop_back();
                if (topology_.is_vacant(f) || checks_.face(f)) continue;
                if (!take(culprit(f))) return false;
            }
            flip_all();
            if (stuck_.empty()) return hull_is_right();
            // Whom to take out is read off the structure that is stuck.
            std::vector<Index> sites;
            for (const HalfEdge h : stuck_) sites.push_back(obstacle(h));
            while (!journal_.empty()) undo_last();
            std::ranges::sort(sites);
            sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
            if (taken + sites.size() > most) return false;
            for (const Index site : sites)
                if (!take(site)) return false;
        }
        return false;
    }

    /// Whether the hull winds once. Precondition: all faces and edges are right.
    [[nodiscard]] bool hull_is_right() {
        const auto is_outer = [&](Index f) {
            return !topology_.is_vacant(f) && topology_.is_infinite(f);
        };
        Index f = 0;
        while (!is_outer(f)) ++f;
        return checks_.hull(f);
    }

 private:
    /// A flip that can be undone: the two faces as they were.
    struct Flip {
        Index f;
        Index g;
        Topology::Record was_f;
        Topology::Record was_g;
    };

    /// Flips wrong edges until none is left but those that no flip helps; after very many flips,
    /// which may go in circles where edges are curved, none helps any more.
    void flip_all() {
        const std::size_t most_flips = 64 + 4 * edges_.size();
        journal_.clear();
        stuck_.clear();
        pending_ = edges_;
        for (std::size_t next = 0; next < pending_.size(); ++next) {
            const HalfEdge h = pending_[next];
            if (is_settled(h)) continue;
            if (journal_.size() == most_flips || !try_flip(h)) stuck_.push_back(h);
        }
        // A flip near by may have helped.
        std::erase_if(stuck_, [&](HalfEdge h) { return is_settled(h); });
    }
    /// Flips an edge, and its sides are to be looked at again; false, and nothing is done, where
    /// faces or the edge would be wrong then.
    [[nodiscard]] bool try_flip(HalfEdge h) {
        if (!can_flip(h)) return false;
        const Index f = Topology::face(h);
        const Index g = Topology::face(topology_.twin(h));
        journal_.push_back({f, g, topology_.record(f), topology_.record(g)});
        flip(topology_, h);
        if (!checks_.edge(Topology::first_edge(f) + 2)) {
            undo_last();
            return false;
        }
        note(f);
        note(g);
        for (const Index face : {f, g})
            for (unsigned k = 0; k < 2; ++k) pending_.push_back(Topology::first_edge(face) + k);
        return true;
    }
    [[nodiscard]] bool is_settled(HalfEdge h) {
        return topology_.is_vacant(Topology::face(h)) || checks_.edge(h);
    }
    [[nodiscard]] bool can_flip(HalfEdge h) {
        const auto [i, j, k, l] = topology_.about(h);
        return k != l && checks_.may_be_face(i, l, k) && checks_.may_be_face(l, j, k);
    }

    void undo_last() {
        const Flip last = journal_.back();
        journal_.pop_back();
        topology_.record(last.f) = last.was_f;
        topology_.record(last.g) = last.was_g;
        for (const Index f : {last.f, last.g}) {
            for (unsigned k = 0; k < 3; ++k)
                topology_.glue(Topology::first_edge(f) + k, topology_.record(f).twin[k]);
            note(f);
        }
    }

    void note(Index f) {
        for (const Index v : topology_.vertices(f))
            if (v >= 0) face_of_[static_cast<std::size_t>(v)] = f;
    }

    /// The site of a wrong face that goes: across from the hull, one that comes out; one that
    /// another hides; else the one with the fewest neighbours.
    [[nodiscard]] Index culprit(Index f) {
        const HalfEdge first = Topology::first_edge(f);
        for (const HalfEdge h : {first, first + 1, first + 2})
            if (topology_.apex(topology_.twin(h)) == infinite && topology_.apex(h) != infinite)
                return topology_.apex(h);
        if constexpr (!Kernel::is_straight)
            for (const HalfEdge h : {first, first + 1, first + 2}) {
                const Index i = topology_.origin(h);
                const Index j = topology_.target(h);
                if (i == infinite || j == infinite) continue;
                if (kernel_.hides(i, j)) return j;
                if (kernel_.hides(j, i)) return i;
            }
        HalfEdge least = first;
        for (const HalfEdge h : {first + 1, first + 2}) least = lesser(least, h);
        return topology_.origin(least);
    }
    /// The end of an edge at which a flip would leave a face that may be none.
    [[nodiscard]] Index obstacle(HalfEdge h) {
        const auto [i, j, k, l] = topology_.about(h);
        if (i != infinite && k != l && !checks_.may_be_face(i, l, k)) return i;
        if (j != infinite && k != l && !checks_.may_be_face(l, j, k)) return j;
        return topology_.origin(lesser(h, topology_.twin(h)));
    }
    /// Out of two half-edges the one whose origin is a site and has fewer neighbours.
    [[nodiscard]] HalfEdge lesser(HalfEdge a, HalfEdge b) const {
        if (topology_.origin(a) == infinite) return b;
        if (topology_.origin(b) == infinite) return a;
        HalfEdge around_a = a;
        HalfEdge around_b = b;
        for (;;) {
            around_a = topology_.around_origin(around_a);
            if (around_a == a) return a;
            around_b = topology_.around_origin(around_b);
            if (around_b == b) return b;
        }
    }

    Topology& topology_;
    LocalChecks<Kernel> checks_;
    Kernel& kernel_;
    std::span<Index> face_of_;
    std::vector<Index> faces_;       ///< to be looked at
    std::vector<HalfEdge> edges_;    ///< to be looked at in every round
    std::vector<HalfEdge> pending_;  ///< ... in this one
    std::vector<HalfEdge> stuck_;    ///< wrong, and not to be flipped
    std::vector<Flip> journal_;
};

}  // namespace signum::triangulation
