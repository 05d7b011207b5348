#pragma once
/// Many sites in a tree of boxes, for the question which of them may be as near to a point as some
/// other one is.
///
/// A box is a site whose numbers are intervals; the distance from it, in interval arithmetic, is no
/// greater than that from any site in it. What is certainly farther is passed over as a whole, so
/// that a point is compared with the few sites about it, however many neighbours one of them has.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/interval.hpp"
#include "../structure/judgement.hpp"

namespace signum::triangulation {

using filters::Interval;

/// Where a site may lie relative to a point, coordinate by coordinate in absolute values, and by
/// how much its radius may exceed that of the site it is compared with, at most.
struct Reach {
    Interval x;
    Interval y;
    Interval third;
};

/// Of a metric with additive weights, by its norm.
template <class Predicates>
struct AdditiveDistance {
    [[nodiscard]] Interval operator()(const Reach& reach) const noexcept {
        return Predicates::norm(reach.x, reach.y) - reach.third;
    }
};

/// Distance: a function that takes a Reach to the distance from the point, an Interval. All this in
/// the default environment. Building takes O(n log n).
template <class Distance>
class NearSites {
 public:
    /// Of the sites that `members` names. Boxes are cut along coordinates alone.
    template <class SiteOf>
    NearSites(const std::vector<Index>& members, const SiteOf& site_of, const Workers& workers)
        : tree_(
              members.size(), 8, 2, [&](std::size_t m) { return only(site_of(members[m])); },
              most_alone(workers, members.size()), both_by(workers)) {
        for (const std::uint32_t m : tree_.order())
            members_.push_back({site_of(members[m]), members[m]});
    }

    /// Calls visit(i) for each site that is not certainly farther from p than `other` is. Returns
    /// how often something was passed over.
    template <class Visit>
    std::size_t visit_near(const Point& p, const Site& other, Visit visit) const {
        std::size_t passed = 0;
        const auto distance = [&](const Bounds<3>& site) {
            const auto number = [&](std::size_t k) { return Interval(site.low[k], site.high[k]); };
            // Only differences of radii count, and these may be small beside the radii.
            return Distance()(Reach{filters::magnitude(number(0) - Interval(p.x)),
                                    filters::magnitude(number(1) - Interval(p.y)),
                                    Interval(site.high[2]) - Interval(other.r)});
        };
        const Interval limit = distance(only(other));
        const auto may_be_near = [&](const Bounds<3>& site) {
            if (!((distance(site) - limit).low > 0.0)) return true;
            ++passed;
            return false;
        };
        tree_.visit(may_be_near, [&](std::uint32_t place) {
            if (may_be_near(only(members_[place].site))) visit(members_[place].number);
        });
        return passed;
    }

 private:
    struct Member {
        Site site;
        Index number;
    };
    [[nodiscard]] static Bounds<3> only(const Site& s) noexcept {
        return Bounds<3>::point({s.x, s.y, s.r});
    }

    BoxTree<3> tree_;
    std::vector<Member> members_;
};

}  // namespace signum::triangulation
