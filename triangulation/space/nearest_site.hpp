#pragma once
/// Which of many sites is nearest to a point: a tree of boxes over sites that lie along a curve.
///
/// A box is compared as the site that it could hold at best: with the largest weight in it, where
/// the box is nearest to the point. Its coordinates and its weight are numbers of the sites or the
/// point's own, so that nothing is rounded, and the comparison is exact as that of sites.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

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
        : sites_(sites), numbers_(numbers), members_(std::move(members)) {
        build(members_, [&](Index member) { return box_of(site(member)); });
        while (levels_.back().size() > 1) build(levels_.back(), [](const Box& box) { return box; });
    }

    /// The member nearest to p; of those as near the first one in the tie rule's order. `start`: a
    /// member, best one nearby. O(log n) where few are as near.
    [[nodiscard]] Index operator()(const Point3& p, Index start) {
        Index best = start;
        pending_.assign(1, {levels_.size() - 1, 0});
        while (!pending_.empty()) {
            const auto [level, place] = pending_.back();
            pending_.pop_back();
            if (power::nearer_decision(p, best_of(levels_[level][place], p), site(best)).sign < 0)
                continue;
            const std::size_t first = place * width;
            if (level == 0) {
                const std::size_t last = std::min(first + width, members_.size());
                for (std::size_t m = first; m < last; ++m)
                    if (members_[m] != best && is_nearer(p, members_[m], best)) best = members_[m];
            } else {
                const std::size_t last = std::min(first + width, levels_[level - 1].size());
                for (std::size_t child = first; child < last; ++child)
                    pending_.emplace_back(level - 1, child);
            }
        }
        return best;
    }

 private:
    struct Box {
        std::array<double, 3> low;
        std::array<double, 3> high;
        double weight;  // the largest, as power::weight_key() has it
    };
    static constexpr std::size_t width = 8;

    [[nodiscard]] static Box box_of(const S& s) noexcept {
        return {{s.x, s.y, s.z}, {s.x, s.y, s.z}, power::weight_key(s)};
    }
    [[nodiscard]] static S best_of(const Box& box, const Point3& p) noexcept {
        S best{};
        best.x = std::clamp(p.x, box.low[0], box.high[0]);
        best.y = std::clamp(p.y, box.low[1], box.high[1]);
        best.z = std::clamp(p.z, box.low[2], box.high[2]);
        if constexpr (requires { best.w; }) best.w = box.weight;
        if constexpr (requires { best.r; }) best.r = box.weight;
        return best;
    }
    /// A level of boxes, each of so many of what is below.
    template <class Below, class BoxOf>
    void build(const Below& below, const BoxOf& box_of) {
        LargeArray<Box> level;
        level.reserve((below.size() + width - 1) / width);
        for (std::size_t first = 0; first < below.size(); first += width) {
            Box box = box_of(below[first]);
            const std::size_t last = std::min(first + width, below.size());
            for (std::size_t i = first + 1; i < last; ++i) {
                const Box other = box_of(below[i]);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    box.low[axis] = std::min(box.low[axis], other.low[axis]);
                    box.high[axis] = std::max(box.high[axis], other.high[axis]);
                }
                box.weight = std::max(box.weight, other.weight);
            }
            level.push_back(box);
        }
        levels_.push_back(std::move(level));
    }
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
    std::vector<LargeArray<Box>> levels_;
    std::vector<std::pair<std::size_t, std::size_t>> pending_;  // levels and places there
};

}  // namespace signum::spatial
