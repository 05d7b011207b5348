#pragma once
/// Many sites in a tree of boxes, for the question which of them may be as near to a point as some
/// other one is.
///
/// A box is a site whose numbers are intervals; the distance from it, in interval arithmetic, is no
/// greater than that from any site in it. What is certainly farther is passed over as a whole, so
/// that a point is compared with the few sites about it, however many neighbours one of them has.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/interval.hpp"
#include "../../predicates/power/weight.hpp"

namespace signum::triangulation {

using filters::Interval;

/// Where a site may lie relative to a point, coordinate by coordinate in absolute values, and its
/// third number.
struct Reach {
    Interval x;
    Interval y;
    Interval third;
};

/// The square root of a number that is not negative. The machine's is off by half a unit at most.
[[nodiscard]] inline Interval square_root(const Interval& square) noexcept {
    return {std::sqrt(std::max(square.low, 0.0)) * (1.0 - 2.0 * filters::epsilon),
            std::sqrt(square.high) * (1.0 + 2.0 * filters::epsilon)};
}

/// The distances of the metrics.
struct EuclideanDistance {
    [[nodiscard]] Interval operator()(const Reach& reach) const noexcept {
        return square_root(reach.x * reach.x + reach.y * reach.y) - reach.third;
    }
};
struct ManhattanDistance {
    [[nodiscard]] Interval operator()(const Reach& reach) const noexcept {
        return reach.x + reach.y - reach.third;
    }
};
struct SupremumDistance {
    [[nodiscard]] Interval operator()(const Reach& reach) const noexcept {
        return filters::max(reach.x, reach.y) - reach.third;
    }
};
/// Of sites with radii, or with weights.
template <class S>
struct PowerDistance {
    [[nodiscard]] Interval operator()(const Reach& reach) const noexcept {
        const Interval square = reach.x * reach.x + reach.y * reach.y;
        if constexpr (std::is_same_v<S, power::Site>) return square - reach.third;
        const Interval radius = filters::magnitude(reach.third);
        return square - radius * radius;
    }
};

/// Distance: a function that takes a Reach to the distance from the point, an Interval. All this in
/// the default environment. Building takes O(n log n).
template <class Distance>
class NearSites {
 public:
    /// Of the sites that `members` names.
    template <class SiteOf>
    NearSites(std::vector<Index> members, const SiteOf& site_of) {
        for (const Index i : members) members_.push_back({site_of(i), i});
        if (!members_.empty()) build(0, members_.size());
    }

    /// Calls visit(i) for each site that is not certainly farther from p than `other` is. Returns
    /// how often something was passed over.
    template <class Visit>
    std::size_t visit_near(const Point& p, const Site& other, Visit visit) {
        std::size_t passed = 0;
        const Interval limit = distance(p, Interval(other.x), Interval(other.y), Interval(other.r));
        pending_.assign(nodes_.empty() ? 0 : 1, 0);
        while (!pending_.empty()) {
            const std::size_t place = pending_.back();
            const Node& node = nodes_[place];
            pending_.pop_back();
            if ((distance(p, node.x, node.y, node.third) - limit).low > 0.0) {
                ++passed;
                continue;
            }
            if (node.right != 0) {
                pending_.push_back(node.right);
                pending_.push_back(place + 1);
                continue;
            }
            for (std::size_t m = node.first; m < node.last; ++m) {
                const Site& site = members_[m].site;
                if ((distance(p, Interval(site.x), Interval(site.y), Interval(site.r)) - limit)
                        .low > 0.0) {
                    ++passed;
                } else {
                    visit(members_[m].number);
                }
            }
        }
        return passed;
    }

 private:
    struct Member {
        Site site;
        Index number;
    };
    /// The left child follows; a leaf has no right one.
    struct Node {
        Interval x;
        Interval y;
        Interval third;
        std::size_t first;
        std::size_t last;
        std::size_t right;
    };
    static constexpr std::size_t leaf_size = 8;

    [[nodiscard]] static Interval distance(const Point& p, const Interval& x, const Interval& y,
                                           const Interval& third) {
        return Distance()(Reach{filters::magnitude(x - Interval(p.x)),
                                filters::magnitude(y - Interval(p.y)), third});
    }

    void build(std::size_t first, std::size_t last) {
        const auto extent = [&](double Site::*number) {
            Interval all(members_[first].site.*number);
            for (std::size_t m = first; m < last; ++m)
                all = {std::min(all.low, members_[m].site.*number),
                       std::max(all.high, members_[m].site.*number)};
            return all;
        };
        const std::size_t place = nodes_.size();
        nodes_.push_back({extent(&Site::x), extent(&Site::y), extent(&Site::r), first, last, 0});
        if (last - first <= leaf_size) return;
        // Halved by the number in which they differ most.
        const auto width = [](const Interval& all) { return all.high - all.low; };
        const Node& node = nodes_[place];
        auto number = width(node.x) < width(node.y) ? &Site::y : &Site::x;
        if (std::max(width(node.x), width(node.y)) < width(node.third)) number = &Site::r;
        const std::size_t middle = first + (last - first) / 2;
        const auto at = [&](std::size_t m) {
            return members_.begin() + static_cast<std::ptrdiff_t>(m);
        };
        std::nth_element(
            at(first), at(middle), at(last),
            [number](const Member& a, const Member& b) { return a.site.*number < b.site.*number; });
        build(first, middle);
        nodes_[place].right = nodes_.size();
        build(middle, last);
    }

    std::vector<Member> members_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> pending_;
};

}  // namespace signum::triangulation
