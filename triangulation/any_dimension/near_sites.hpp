#pragma once
/// Sites in a tree of boxes, for the question which of them may be as near to a place as some other
/// one is: as triangulation/check/near_sites.hpp, in any dimension.
///
/// A box is a site whose numbers are intervals; the distance from it, in interval arithmetic, is no
/// greater than that from any site in it. What is certainly farther is passed over as a whole.
/// Numbers are multiplied by a power of two first, so that squares are doubles: the largest are
/// near 2^400, for coordinates may be far below radii.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/index.hpp"
#include "../../filters/interval.hpp"
#include "../structure/judgement.hpp"
#include "sites.hpp"

namespace signum::any_dimension {

/// All this in the default environment. Building takes O(n log n).
template <class S>
class NearSites {
 public:
    /// Of the sites that `members` names.
    NearSites(std::span<const S> sites, std::vector<Index> members, const Workers& workers)
        : members_(std::move(members)), scale_(scale(sites, members_)) {
        const auto bounds_of = [&](std::size_t m) {
            return scaled(sites[static_cast<std::size_t>(members_[m])]);
        };
        // Cut along coordinates alone: weights may be greater by far, and say little of who is near.
        tree_ = {members_.size(),
                 4,
                 coordinates,
                 bounds_of,
                 triangulation::most_alone(workers, members_.size()),
                 triangulation::both_by(workers)};
    }

    /// Calls visit(i) for each site that is not certainly farther from the centre of q than `other`
    /// is. Returns how often something was passed over: never, where nothing may be.
    template <bool passes_over, class Visit>
    std::size_t visit_near(const S& q, const S& other, Visit visit) const {
        std::size_t passed = 0;
        const Box centre = around(scaled(q));
        const Box that = around(scaled(other));
        const Interval limit = square_of_distance(centre, that);
        const auto may_be_near = [&](const Bounds<numbers>& bounds) {
            Box box;
            for (std::size_t k = 0; k < numbers; ++k) box[k] = {bounds.low[k], bounds.high[k]};
            const Interval nearer = square_of_distance(centre, box) - limit;
            if (!passes_over || !(nearer.low > excess(box, that))) return true;
            ++passed;
            return false;
        };
        tree_.visit(may_be_near,
                    [&](std::uint32_t place) { visit(members_[tree_.order()[place]]); });
        return passed;
    }

 private:
    using Interval = filters::Interval;
    static constexpr auto coordinates = static_cast<std::size_t>(dimension_of<S>);
    /// The coordinates, and what orders sites by weight.
    static constexpr std::size_t numbers = coordinates + 1;
    using Box = std::array<Interval, numbers>;
    static constexpr bool has_radius = requires(const S& s) { s.r; };

    [[nodiscard]] static double scale(std::span<const S> sites, std::span<const Index> members) {
        double largest = 0.0;
        for (const Index m : members) {
            const S& s = sites[static_cast<std::size_t>(m)];
            for (std::size_t axis = 0; axis < coordinates; ++axis)
                largest = std::max(largest, std::fabs(coordinate(s, axis)));
            // Of a weight the radius that it is the square of.
            const double weight = std::fabs(power::weight_key(s));
            largest = std::max(largest, has_radius ? weight : std::sqrt(weight));
        }
        if (!(largest > 0.0)) return 1.0;
        return std::ldexp(1.0, std::clamp(400 - std::ilogb(largest), -1000, 1000));
    }
    /// But for what underflows.
    [[nodiscard]] Bounds<numbers> scaled(const S& s) const noexcept {
        Bounds<numbers> at;
        for (std::size_t axis = 0; axis < coordinates; ++axis)
            at.low[axis] = coordinate(s, axis) * scale_;
        at.low[coordinates] = power::weight_key(s) * scale_ * (has_radius ? 1.0 : scale_);
        at.high = at.low;
        return at;
    }
    /// As much wider as underflow may take of a number and of another one that is compared with it:
    /// where that is lost beside the number, it is less than what a difference is widened by.
    [[nodiscard]] static Box around(const Bounds<numbers>& at) noexcept {
        constexpr double least = 0x1p-1022;
        Box box;
        for (std::size_t k = 0; k < numbers; ++k) box[k] = {at.low[k] - least, at.low[k] + least};
        return box;
    }
    [[nodiscard, gnu::always_inline]] static Interval square_of_distance(const Box& centre,
                                                                         const Box& box) noexcept {
        Interval sum(0.0);
        for (std::size_t axis = 0; axis < coordinates; ++axis) {
            const Interval x = filters::magnitude(box[axis] - centre[axis]);
            sum = sum + x * x;
        }
        return sum;
    }
    /// By how much the weight of a site in the box exceeds that of `other`, at most. Weights are
    /// subtracted first: beside them the distances may be nothing. Three roundings; that `other` is
    /// wider by `least` is less than a fourth, or than 2^-1022.
    [[nodiscard, gnu::always_inline]] static double excess(const Box& box,
                                                           const Box& other) noexcept {
        const double greatest = box[coordinates].high;
        const auto& [low, high] = other[coordinates];
        double most = greatest - low;
        if constexpr (has_radius) most *= greatest + high;
        return most + (3.0 * filters::epsilon * filters::magnitude(most) + 0x1p-1022);
    }

    std::vector<Index> members_;
    double scale_;
    BoxTree<numbers> tree_;
};

}  // namespace signum::any_dimension
