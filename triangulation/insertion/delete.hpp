#pragma once
/// Deletion: one visible site out of a tessellation of the sphere.
///
/// What a site's cell leaves behind is shared by its neighbours alone: between the cells of the
/// others nothing changes, and a point of the cell is nearest to a site whose cell grows into it.
/// So the tessellation of the neighbours is built apart. There the conflict region of the site is
/// the patch that replaces its star: it has the same boundary, and is glued along it.
///
/// Laws:
///  1. The boundary of the region and the ring around the site are the same cyclic sequence of
///     vertices. Where it agrees with itself in more than one position nothing is done.
///     Neighbours that have no tessellation of their own because they are on one line (power
///     metric) or because there is but one see the site go that stood between them and infinity,
///     unless nothing else is left: then nothing is done, either.
///  2. Sites that the deleted one hid are not looked at.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/insertion_rounds.hpp"
#include "../structure/topology.hpp"
#include "insert.hpp"

namespace signum::triangulation {

/// What became of the gap that a site leaves.
enum class Gap : std::uint8_t {
    closed,
    open,      ///< not closed: without the site there are only its neighbours, and no structure
    ambiguous  ///< not closed: the boundary fits in no position, or in more than one
};

template <class Kernel>
class Deletion {
 public:
    /// `none_hidden` has room for every site and -1 everywhere; it stays so.
    Deletion(Insertion<Kernel>& tessellation, std::span<Index> none_hidden)
        : into_(tessellation), topology_(tessellation.topology_), none_hidden_(none_hidden) {}

    /// Deletes the origin of h; see law 1. O(degree log degree) expected, whatever the neighbours,
    /// and O(degree²) at most, apart from the predicates.
    [[nodiscard]] Gap erase(HalfEdge h) {
        const Index v = topology_.origin(h);
        find_ring(h);
        if (ring_.size() <= few)
            sort_neighbours();
        else
            order_neighbours();

        Topology patch(neighbours_.size() + 1);
        std::optional<Insertion<Kernel>> apart = start(patch);
        if (!apart) return lay_bare() ? Gap::closed : Gap::open;
        for (const Index site : neighbours_) apart->insert(site);
        if (!apart->find_conflicts(v)) return Gap::ambiguous;
        const auto turn = position(*apart);
        if (!turn) return Gap::ambiguous;
        replace(*apart, patch, *turn);
        return Gap::closed;
    }

 private:
    /// An edge of the ring: where it begins, the half-edge outside, the star's face, and whether
    /// the half-edge outside is one of the star, too.
    struct RingEdge {
        Index from;
        HalfEdge outside;
        Index face;
        bool is_inner;
    };
    using Boundary = typename Insertion<Kernel>::BoundaryEdge;
    /// Of so many neighbours the order of insertion makes no difference.
    static constexpr std::size_t few = 32;

    void find_ring(HalfEdge h) {
        constexpr Index in_star = 1;
        ring_.clear();
        for (const HalfEdge spoke : topology_.fan(h)) {
            const HalfEdge link = Topology::next(spoke);
            ring_.push_back(
                {topology_.origin(link), topology_.twin(link), Topology::face(spoke), false});
            topology_.record(Topology::face(spoke)).mark = in_star;
        }
        for (RingEdge& edge : ring_)
            edge.is_inner = topology_.record(Topology::face(edge.outside)).mark == in_star;
        for (const RingEdge& edge : ring_) topology_.record(edge.face).mark = 0;
    }

    void sort_neighbours() {
        neighbours_.clear();
        for (const RingEdge& edge : ring_)
            if (edge.from != infinite) neighbours_.push_back(edge.from);
        std::sort(neighbours_.begin(), neighbours_.end());
        neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    }
    /// Many are inserted in random rounds, each along the ring: so walks from one to the next are
    /// short, and none has many neighbours for long but in the end.
    void order_neighbours() {
        std::vector<std::pair<Index, Index>> places;  // of each in the ring
        for (std::size_t i = 0; i < ring_.size(); ++i)
            if (ring_[i].from != infinite)
                places.emplace_back(ring_[i].from, static_cast<Index>(i));
        std::sort(places.begin(), places.end());
        const auto same_site = [](const auto& a, const auto& b) { return a.first == b.first; };
        places.erase(std::unique(places.begin(), places.end(), same_site), places.end());
        const InsertionRounds rounds(places.size(), 1);
        std::vector<std::array<Index, 3>> order;  // round, place, site
        for (const auto& [site, place] : places)
            order.push_back({rounds.of(static_cast<std::size_t>(place)), place, site});
        std::sort(order.begin(), order.end());
        neighbours_.clear();
        for (const auto& [round, place, site] : order) neighbours_.push_back(site);
    }

    /// The tessellation of the first two or three neighbours; they leave the list.
    [[nodiscard]] std::optional<Insertion<Kernel>> start(Topology& patch) {
        Kernel& kernel = into_.kernel_;
        if constexpr (Kernel::is_straight) {
            if (neighbours_.size() < 3) return std::nullopt;
            const Index a = neighbours_[0];
            const Index b = neighbours_[1];
            for (std::size_t i = 2; i < neighbours_.size(); ++i) {
                const Sign side = kernel.ccw(a, b, neighbours_[i]);
                if (side == 0) continue;
                const Index c = neighbours_[i];
                neighbours_.erase(neighbours_.begin() + static_cast<std::ptrdiff_t>(i));
                neighbours_.erase(neighbours_.begin(), neighbours_.begin() + 2);
                return std::optional<Insertion<Kernel>>(std::in_place, patch, kernel, none_hidden_,
                                                        side > 0 ? a : b, side > 0 ? b : a, c);
            }
            return std::nullopt;
        } else {
            if (neighbours_.size() < 2) return std::nullopt;
            const Index a = neighbours_[0];
            const Index b = neighbours_[1];
            neighbours_.erase(neighbours_.begin(), neighbours_.begin() + 2);
            return std::optional<Insertion<Kernel>>(std::in_place, patch, kernel, none_hidden_, a,
                                                    b);
        }
    }

    /// The place in the ring at which the boundary begins, if there is one alone.
    [[nodiscard]] std::optional<std::size_t> position(const Insertion<Kernel>& apart) const {
        const std::size_t count = ring_.size();
        if (apart.boundary_.size() != count) return std::nullopt;
        std::optional<std::size_t> found;
        for (std::size_t turn = 0; turn < count; ++turn) {
            bool same = true;
            for (std::size_t i = 0; same && i < count; ++i)
                same = apart.boundary_[i].from == ring_[(i + turn) % count].from;
            if (!same) continue;
            if (found) return std::nullopt;
            found = turn;
        }
        return found;
    }

    void vacate(Index f) {
        topology_.vacate(f);
        into_.vacant_.push(f);
    }

    /// No tessellation of the neighbours: they lie on one line behind a corner of the hull or,
    /// where edges are curved, there is one beside infinity. Infinity takes the site's place; false
    /// where nothing is behind them.
    [[nodiscard]] bool lay_bare() {
        const auto outer = std::find_if(ring_.begin(), ring_.end(),
                                        [](const RingEdge& edge) { return edge.from == infinite; });
        if (outer == ring_.end()) return false;
        std::rotate(ring_.begin(), outer, ring_.end());
        const std::size_t last = ring_.size() - 1;
        if (last == 1 && ring_[0].is_inner) return false;
        for (std::size_t i = 1; i < last; ++i)
            if (topology_.is_infinite(Topology::face(ring_[i].outside))) return false;
        HalfEdge before = ring_[0].outside;
        for (std::size_t i = 1; i < last; ++i) {
            const HalfEdge h = Topology::first_edge(ring_[i].face);
            topology_.record(ring_[i].face) = {
                {ring_[i].from, ring_[i + 1].from, infinite}, 0, {0, 0, 0}};
            topology_.glue(h, ring_[i].outside);
            topology_.glue(h + 2, before);
            before = h + 1;
        }
        topology_.glue(before, ring_[last].outside);
        vacate(ring_[0].face);
        vacate(ring_[last].face);
        into_.recent_ = Topology::face(before);
        return true;
    }

    void replace(const Insertion<Kernel>& apart, const Topology& patch, std::size_t turn) {
        const std::size_t count = ring_.size();
        const auto& removed = apart.removed_;
        // The faces of the patch take the places of the star's.
        std::vector<std::pair<Index, Index>> place;
        for (std::size_t i = 0; i < removed.size(); ++i)
            place.emplace_back(removed[i], ring_[i].face);
        std::sort(place.begin(), place.end());
        const auto place_of = [&](Index f) -> Index {
            const auto at = std::lower_bound(place.begin(), place.end(), std::pair{f, Index{-1}});
            return at != place.end() && at->first == f ? at->second : -1;
        };
        for (std::size_t i = removed.size(); i < count; ++i) vacate(ring_[i].face);
        for (std::size_t i = 0; i < removed.size(); ++i) {
            const auto& corners = patch.vertices(removed[i]);
            topology_.record(ring_[i].face) = {{corners[0], corners[1], corners[2]}, 0, {0, 0, 0}};
        }
        const auto moved = [&](HalfEdge h) {
            return Topology::first_edge(place_of(Topology::face(h))) + (h & 3);
        };
        for (std::size_t i = 0; i < removed.size(); ++i)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge half = Topology::first_edge(removed[i]) + k;
                if (place_of(Topology::face(patch.twin(half))) >= 0)
                    topology_.glue(moved(half), moved(patch.twin(half)));
            }
        for (std::size_t i = 0; i < count; ++i) {
            const HalfEdge outside = apart.boundary_[i].outside;
            const auto& [from, here, face, is_inner] = ring_[(i + turn) % count];
            // Where the ring runs along both sides of an edge whose middle was not the site's, the
            // patch has the edge whole; unless another site divides that middle.
            if (is_inner) continue;
            const HalfEdge inside = patch.twin(outside);
            if (place_of(Topology::face(inside)) >= 0) {
                topology_.glue(here, moved(inside));
            } else {
                // No vertex was the site's: both sides of the ring meet.
                topology_.glue(here, ring_[(i + 1 + turn) % count].outside);
            }
        }
        // Outside the star there may be no face.
        into_.recent_ = removed.size() > 0 ? ring_[0].face : Topology::face(ring_[0].outside);
    }

    Insertion<Kernel>& into_;
    Topology& topology_;
    std::span<Index> none_hidden_;
    std::vector<RingEdge> ring_;
    std::vector<Index> neighbours_;
};

}  // namespace signum::triangulation
