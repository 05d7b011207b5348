#pragma once
/// Which of many sites is nearest to a point: a tree of boxes over sites that lie along a curve.
///
/// A box is compared as the site that it could hold at best: with the largest weight in it, where
/// the box is nearest to the point. Its coordinates and its weight are numbers of the sites or the
/// point's own, so that nothing is rounded, and the comparison is exact as that of sites.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "../../core/box_tree.hpp"
#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../../predicates/space/ties.hpp"

namespace signum::spatial {

/// Sites and their numbers, which decide between equal ones, must outlive this.
template <class S>
class NearestSite {
 public:
    /// Of the sites that `members` names, at least one, best along a curve. O(n).
    NearestSite(std::span<const S> sites, std::span<const Index> numbers, LargeArray<Index> members)
        : sites_(sites),
          numbers_(numbers),
          members_(std::move(members)),
          tree_(members_.size(), 12, 0, [&](std::size_t m) {
              const S& s = site(members_[m]);
              return Bounds<4>::point({s.x, s.y, s.z, power::weight_key(s)});
          }) {}

    /// The member nearest to p; of those as near the first one in the tie rule's order. `start`: a
    /// member, best one nearby. O(log n) where few are as near.
    [[nodiscard]] Index operator()(const Point3& p, Index start) const {
        Index best = start;
        const auto may_be_nearer = [&](const Bounds<4>& box) {
            S most{};
            most.x = std::clamp(p.x, box.low[0], box.high[0]);
            most.y = std::clamp(p.y, box.low[1], box.high[1]);
            most.z = std::clamp(p.z, box.low[2], box.high[2]);
            if constexpr (requires { most.w; }) most.w = box.high[3];
            if constexpr (requires { most.r; }) most.r = box.high[3];
            return power::nearer_decision(p, most, site(best)).sign >= 0;
        };
        tree_.visit(may_be_nearer, [&](std::uint32_t m) {
            if (members_[m] != best && is_nearer(p, members_[m], best)) best = members_[m];
        });
        return best;
    }

 private:
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool is_nearer(const Point3& p, Index a, Index b) const noexcept {
        const Sign sign = power::nearer_decision(p, site(a), site(b)).sign;
        if (sign != 0) return sign > 0;
        return power::precedes(site(a), numbers_[static_cast<std::size_t>(a)], site(b),
                               numbers_[static_cast<std::size_t>(b)]);
    }

    std::span<const S> sites_;
    std::span<const Index> numbers_;
    LargeArray<Index> members_;
    BoxTree<4> tree_;
};

}  // namespace signum::spatial
