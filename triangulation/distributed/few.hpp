#pragma once
/// What a metric's kernel says of a few sites that lie anywhere, known by their numbers in the
/// whole, and where sites are that may matter to a face or a hidden site: by metric. For sources
/// only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "../../filters/tally.hpp"
#include "../kernels/additive_kernel.hpp"
#include "../kernels/power_kernel.hpp"
#include "../kernels/predicates_of.hpp"
#include "../parts/reach.hpp"
#include "../vertices/vertex_of_face.hpp"
#include "exchange.hpp"

namespace signum::distributed {

using triangulation::AdditiveKernel;
using triangulation::PowerKernel;
using triangulation::PredicatesOf;
using triangulation::RankedSite;
using triangulation::SignsOfKnown;

/// The kernel of a metric, over sites of any weights, in exact arithmetic.
template <class M, WeightIs weight_is>
struct KernelOf {
    using type = AdditiveKernel<typename PredicatesOf<M>::template Perturbed<>, filters::NoTally>;
};
template <WeightIs weight_is>
struct KernelOf<Power, weight_is> {
    using S = typename PredicatesOf<Power, weight_is>::SiteType;
    using type = PowerKernel<SignsOfKnown<S>, filters::NoTally>;
};

/// Calls work<M, weight_is>().
template <class Work>
decltype(auto) with_kernel(Metric metric, WeightIs weight_is, const Work& work) {
    return with_metric(metric, [&]<class M>(M) -> decltype(auto) {
        if constexpr (M::traits.has_weights)
            if (weight_is == WeightIs::weight)
                return work.template operator()<M, WeightIs::weight>();
        return work.template operator()<M, WeightIs::radius>();
    });
}

/// The places of a few sites in the order of their numbers.
template <std::size_t n>
[[nodiscard]] std::array<Index, n> numbered(const std::array<const Placed*, n>& sites) noexcept {
    std::array<Index, n> numbers{};
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
            numbers[a] += static_cast<Index>(sites[b]->id < sites[a]->id);
    return numbers;
}

/// A few sites, and a kernel that knows them by their places.
template <class M, WeightIs weight_is, std::size_t n>
class Few {
    using Kernel = typename KernelOf<M, weight_is>::type;
    using S = typename Kernel::SiteType;

 public:
    explicit Few(const std::array<const Placed*, n>& given)
        : numbers_(numbered(given)), kernel_(make(given)) {}
    Few(const Few&) = delete;
    Few& operator=(const Few&) = delete;

    [[nodiscard]] Kernel& kernel() noexcept { return kernel_; }

 private:
    [[nodiscard]] Kernel make(const std::array<const Placed*, n>& given) {
        if constexpr (Kernel::is_straight) {
            for (std::size_t a = 0; a < n; ++a)
                sites_[a] = PredicatesOf<M, weight_is>::site(given[a]->site);
            return Kernel(sites_.data(), numbers_.data());
        } else {
            std::array<const Site*, n> sites;
            for (std::size_t a = 0; a < n; ++a) sites[a] = &given[a]->site;
            const std::array<Index, n> ranks = additive::ranks_of<n>(sites, numbers_);
            for (std::size_t a = 0; a < n; ++a) sites_[a] = {given[a]->site, ranks[a]};
            return Kernel(sites_.data());
        }
    }

    std::array<S, n> sites_;
    std::array<Index, n> numbers_;
    Kernel kernel_;
};

/// The third number of an extent: the greater, the nearer a site is to everything. A weight, in the
/// power metric, rounded; or a radius.
template <class M, WeightIs weight_is>
[[nodiscard]] double third_of(const Site& site) noexcept {
    if constexpr (M::traits.edges_are_straight)
        return triangulation::weight_of(PredicatesOf<M, weight_is>::site(site));
    else
        return site.r;
}
template <class M, WeightIs weight_is>
[[nodiscard]] Extent extent_of(const Site& site) noexcept {
    return Extent::point({site.x, site.y, third_of<M, weight_is>(site)});
}

/// How far a point is from an extent along each axis.
[[nodiscard]] inline std::array<double, 2> gaps(Point p, const Extent& extent) noexcept {
    return {std::max({extent.low[0] - p.x, p.x - extent.high[0], 0.0}),
            std::max({extent.low[1] - p.y, p.y - extent.high[1], 0.0})};
}

/// The least distance, in the metric, of a point from the sites in an extent, where they may lie
/// anywhere in it: of each one's power, or of each one's distance less its radius.
struct Nearness {
    double low;
    double high;
};
/// A few roundings each of differences, their norm, and the difference of that and the third
/// number; 2^-48 pays for the sums here too. Squares may underflow: of the power metric here, of
/// others within the interval.
template <class M>
[[nodiscard]] Nearness nearness(Point p, const Extent& extent) noexcept {
    const auto [x, y] = gaps(p, extent);
    filters::Interval norm(0.0);
    if constexpr (M::traits.edges_are_straight)
        norm = filters::Interval(x * x + y * y);
    else
        norm = PredicatesOf<M>::norm(filters::Interval(x), filters::Interval(y));
    const double third = extent.high[2];
    const double error = 0x1p-48 * (norm.high + std::fabs(third)) + 0x1p-1000;
    return {(norm.low - third) - error, (norm.high - third) + error};
}

/// The circle of a face.
template <class M, WeightIs weight_is>
class Ball {
 public:
    explicit Ball(const std::array<Placed, 3>& face) noexcept {
        const auto& [a, b, c] = face;
        if constexpr (M::traits.edges_are_straight) {
            using Predicates = PredicatesOf<M, weight_is>;
            circle_ = triangulation::circle_of(Predicates::site(a.site), Predicates::site(b.site),
                                               Predicates::site(c.site));
        } else {
            vertex_ = triangulation::vertex_of_face<M>({&a.site, &b.site, &c.site},
                                                       numbered<3>({&a, &b, &c}), weight_is);
        }
    }

    /// By how much the sites in the extent are too far away for a conflict, less what rounding may
    /// have made of it: above 0 where none conflicts.
    [[nodiscard]] double excess(const Extent& extent) const noexcept {
        if constexpr (M::traits.edges_are_straight) {
            return circle_.excess(
                {{extent.low[0], extent.low[1]}, {extent.high[0], extent.high[1]}, extent.high[2]});
        } else {
            // Each number of the vertex is the nearest double; a face without a vertex has NaN.
            const double low = nearness<M>({vertex_.x, vertex_.y}, extent).low;
            const double slack =
                std::fabs(vertex_.x) + std::fabs(vertex_.y) + std::fabs(vertex_.rho);
            return (low - vertex_.rho) - 0x1p-52 * slack;
        }
    }
    [[nodiscard]] bool may_be_reached_from(const Extent& extent) const noexcept {
        return !(excess(extent) > 0.0);
    }

 private:
    struct Nothing {};
    static constexpr bool is_straight = M::traits.edges_are_straight;
    [[no_unique_address]] std::conditional_t<is_straight, triangulation::Orthoball<2>, Nothing>
        circle_;
    [[no_unique_address]] std::conditional_t<is_straight, Nothing, DiagramVertex> vertex_;
};

/// Where a site has its centre that takes the middle of an edge of i and j and leaves both ends, in
/// a metric with additive weights: along no axis is it beyond both, its radius and theirs included.
///
/// Suppose t is, in direction n. Then far out towards n t is nearer than both, so its cell among
/// the three has no end. From there the cell leads to the middle of the edge. It parts the points
/// on one side of the bisector, say i's: those beside one end of the middle from those beside the
/// other, for it leaves the bisector's own ends at infinity to i and j. But the cell of i is
/// connected.
class Middle {
 public:
    Middle(const Site& i, const Site& j) noexcept {
        const std::array<std::array<double, 2>, 2> centres = {{{i.x, i.y}, {j.x, j.y}}};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low_[axis] = std::min(centres[0][axis] - i.r, centres[1][axis] - j.r);
            high_[axis] = std::max(centres[0][axis] + i.r, centres[1][axis] + j.r);
        }
    }
    [[nodiscard]] bool may_be_taken_from(const Extent& extent) const noexcept {
        // Two roundings.
        const double r = extent.low[2];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double slack =
                0x1p-50 * (std::fabs(low_[axis]) + std::fabs(high_[axis]) + std::fabs(r) +
                           std::fabs(extent.low[axis]) + std::fabs(extent.high[axis]));
            if (extent.low[axis] + r > high_[axis] + slack ||
                extent.high[axis] - r < low_[axis] - slack)
                return false;
        }
        return true;
    }

 private:
    std::array<double, 2> low_;
    std::array<double, 2> high_;
};

}  // namespace signum::distributed
