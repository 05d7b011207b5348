#pragma once
/// What a metric's predicates say of a few sites that lie anywhere, known by their numbers in the
/// whole, and where sites are that may matter to a face, a cell or a hidden site: by kind. For
/// sources only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "../../filters/tally.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../../predicates/space/ties.hpp"
#include "../kernels/additive_kernel.hpp"
#include "../kernels/power_kernel.hpp"
#include "../kernels/predicates_of.hpp"
#include "../parts/reach.hpp"
#include "../space/reach.hpp"
#include "../vertices/vertex_of_face.hpp"
#include "exchange.hpp"

namespace signum::distributed {

using triangulation::AdditiveKernel;
using triangulation::PowerKernel;
using triangulation::PredicatesOf;
using triangulation::RankedSite;
using triangulation::SignsOfKnown;

/// A kind as a type. Kernel: over sites of any weights, in exact arithmetic.
template <class M, WeightIs weight>
struct OfPlane {
    using Metric = M;
    static constexpr WeightIs weight_is = weight;
    static constexpr std::size_t dimension = 2;
    static constexpr bool is_straight = false;
    using Kernel = AdditiveKernel<typename PredicatesOf<M>::template Perturbed<>, filters::NoTally>;
};
template <WeightIs weight>
struct OfPlane<Power, weight> {
    using Metric = Power;
    static constexpr WeightIs weight_is = weight;
    static constexpr std::size_t dimension = 2;
    static constexpr bool is_straight = true;
    using S = typename PredicatesOf<Power, weight>::SiteType;
    using Kernel = PowerKernel<SignsOfKnown<S>, filters::NoTally>;
};
template <WeightIs weight>
struct OfSpace {
    static constexpr std::size_t dimension = 3;
    static constexpr bool is_straight = true;
    using S = std::conditional_t<weight == WeightIs::weight, power::Site3, Site3>;
};

/// Calls work<K>(), K the kind as a type. Precondition: check() finds the kind right.
template <class Work>
decltype(auto) with_kind(const Kind& kind, const Work& work) {
    constexpr WeightIs weight = WeightIs::weight;
    constexpr WeightIs radius = WeightIs::radius;
    const bool are_weights = kind.weight_is == weight;
    if (kind.dimension == 3)
        return are_weights ? work.template operator()<OfSpace<weight>>()
                           : work.template operator()<OfSpace<radius>>();
    return with_metric(kind.metric, [&]<class M>(M) -> decltype(auto) {
        if constexpr (M::traits.has_weights)
            if (are_weights) return work.template operator()<OfPlane<M, weight>>();
        return work.template operator()<OfPlane<M, radius>>();
    });
}

/// A site as predicates of straight edges take it.
template <class K>
[[nodiscard]] typename K::S straight(const Placed& placed) noexcept {
    if constexpr (K::dimension == 3)
        return {placed.site.x, placed.site.y, placed.site.z, placed.site.r};
    else
        return PredicatesOf<Power, K::weight_is>::site(in_plane(placed));
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

/// A few sites of the plane, and a kernel that knows them by their places.
template <class K, std::size_t n>
class Few {
    using Kernel = typename K::Kernel;
    using S = typename Kernel::SiteType;

 public:
    explicit Few(const std::array<const Placed*, n>& given)
        : numbers_(numbered(given)), kernel_(make(given)) {}
    Few(const Few&) = delete;
    Few& operator=(const Few&) = delete;

    [[nodiscard]] Kernel& kernel() noexcept { return kernel_; }

 private:
    [[nodiscard]] Kernel make(const std::array<const Placed*, n>& given) {
        if constexpr (K::is_straight) {
            for (std::size_t a = 0; a < n; ++a) sites_[a] = straight<K>(*given[a]);
            return Kernel(sites_.data(), numbers_.data());
        } else {
            std::array<Site, n> plain;
            std::array<const Site*, n> sites;
            for (std::size_t a = 0; a < n; ++a) {
                plain[a] = in_plane(*given[a]);
                sites[a] = &plain[a];
            }
            const std::array<Index, n> ranks = additive::ranks_of<n>(sites, numbers_);
            for (std::size_t a = 0; a < n; ++a) sites_[a] = {plain[a], ranks[a]};
            return Kernel(sites_.data());
        }
    }

    std::array<S, n> sites_;
    std::array<Index, n> numbers_;
    Kernel kernel_;
};

/// Whether a site conflicts with a face or cell, if it is visible; under the tie rule.
template <class K>
[[nodiscard]] bool conflicts(const Corners& face, const Placed& q) {
    if constexpr (K::dimension == 3) {
        const std::array<typename K::S, 5> sites = {straight<K>(face[0]), straight<K>(face[1]),
                                                    straight<K>(face[2]), straight<K>(face[3]),
                                                    straight<K>(q)};
        const Sign sign =
            power::in_sphere_decision(sites[0], sites[1], sites[2], sites[3], sites[4]).sign;
        if (sign != 0) return sign > 0;
        return power::in_sphere_tie(sites,
                                    numbered<5>({&face[0], &face[1], &face[2], &face[3], &q})) > 0;
    } else {
        Few<K, 4> few({&face[0], &face[1], &face[2], &q});
        if constexpr (K::is_straight)
            return few.kernel().conflicts(0, 1, 2, 3);
        else
            return few.kernel().conflicts_if_visible(0, 1, 2, 3);
    }
}

/// Whether a is nearer than b to the centre of a site; of those as near the first one in the tie
/// rule's order is.
template <class K>
[[nodiscard]] bool is_nearer(const Placed& to, const Placed& a, const Placed& b) {
    if constexpr (K::dimension == 3) {
        const typename K::S one = straight<K>(a);
        const typename K::S other = straight<K>(b);
        const Sign sign = power::nearer_decision(place_of(to), one, other).sign;
        if (sign != 0) return sign > 0;
        return power::precedes(one, a.id < b.id ? 0 : 1, other, a.id < b.id ? 1 : 0);
    } else {
        Few<K, 3> few({&to, &a, &b});
        return few.kernel().is_nearer(0, 1, 2);
    }
}

/// What weighs a site: the greater it is, the nearer to everything. A weight, in the power metric,
/// rounded; or a radius.
template <class K>
[[nodiscard]] double weight_of(const Placed& placed) noexcept {
    if constexpr (K::is_straight)
        return triangulation::weight_of(straight<K>(placed));
    else
        return placed.site.r;
}
template <class K>
[[nodiscard]] Extent extent_of(const Placed& placed) noexcept {
    return Extent::point({placed.site.x, placed.site.y, placed.site.z, weight_of<K>(placed)});
}

/// The least distance, in the metric, of a point from the sites in an extent, where they may lie
/// anywhere in it: of each one's power, or of each one's distance less its radius.
struct Nearness {
    double low;
    double high;
};
/// A few roundings each of differences, their norm, and the difference of that and the weight;
/// 2^-48 pays for the sums here too. Squares may underflow: of the power metric here, of others
/// within the interval.
template <class K>
[[nodiscard]] Nearness nearness(const Point3& p, const Extent& extent) noexcept {
    const std::array<double, axes> place = {p.x, p.y, p.z};
    std::array<double, axes> gap;
    for (std::size_t k = 0; k < axes; ++k)
        gap[k] = std::max({extent.low[k] - place[k], place[k] - extent.high[k], 0.0});
    filters::Interval norm(0.0);
    if constexpr (K::is_straight)
        norm = filters::Interval(gap[0] * gap[0] + gap[1] * gap[1] + gap[2] * gap[2]);
    else
        norm = PredicatesOf<typename K::Metric>::norm(filters::Interval(gap[0]),
                                                      filters::Interval(gap[1]));
    const double weight = extent.high[weight_place];
    const double error = 0x1p-48 * (norm.high + std::fabs(weight)) + 0x1p-1000;
    return {(norm.low - weight) - error, (norm.high - weight) + error};
}

/// The circle of a face, or the sphere of a cell.
template <class K>
class Ball {
 public:
    explicit Ball(const Corners& face) noexcept : ball_(made_of(face)) {}

    /// Its centre, where kinds have additive weights; NaN where there is none.
    [[nodiscard]] Point centre() const noexcept {
        static_assert(!K::is_straight);
        return {ball_.x, ball_.y};
    }
    /// By how much the sites in the finite extent are too far away for a conflict, less what
    /// rounding may have made of it: above 0 where none conflicts.
    [[nodiscard]] double excess(const Extent& extent) const noexcept {
        if constexpr (K::is_straight) {
            triangulation::Box<K::dimension> box;
            for (std::size_t k = 0; k < K::dimension; ++k) {
                box.low[k] = extent.low[k];
                box.high[k] = extent.high[k];
            }
            box.greatest = extent.high[weight_place];
            return ball_.excess(box);
        } else {
            // Each number of the vertex is the nearest double; a face without a vertex has NaN.
            const double low = nearness<K>({ball_.x, ball_.y, 0.0}, extent).low;
            const double slack = std::fabs(ball_.x) + std::fabs(ball_.y) + std::fabs(ball_.rho);
            return (low - ball_.rho) - 0x1p-52 * slack;
        }
    }
    [[nodiscard]] bool may_be_reached_from(const Extent& extent) const noexcept {
        return !(excess(extent) > 0.0);
    }
    /// In a metric with additive weights, whether f >= h - G at the vertex (part.hpp), n up the
    /// axis or, where `up` is -1, down, h at the border. On the safe side, as AdditiveReach.
    [[nodiscard]] bool leads(std::size_t axis, double up, double border,
                             double greatest) const noexcept {
        static_assert(!K::is_straight);
        const double p = axis == 0 ? ball_.x : ball_.y;
        const double slack =
            (std::fabs(p) + std::fabs(border)) + (std::fabs(ball_.rho) + std::fabs(greatest));
        return !(up * (border - p) > ball_.rho + greatest + (0x1p-50 * slack + 0x1p-1072));
    }

 private:
    static auto made_of(const Corners& face) noexcept {
        const auto& [a, b, c, d] = face;
        if constexpr (K::dimension == 3) {
            const std::array<typename K::S, 4> sites = {straight<K>(a), straight<K>(b),
                                                        straight<K>(c), straight<K>(d)};
            return spatial::InSphereForm(std::span<const typename K::S>(sites), {0, 1, 2, 3});
        } else if constexpr (K::is_straight) {
            return triangulation::circle_of(straight<K>(a), straight<K>(b), straight<K>(c));
        } else {
            const std::array<Site, 3> sites = {in_plane(a), in_plane(b), in_plane(c)};
            return triangulation::vertex_of_face<typename K::Metric>(
                {&sites[0], &sites[1], &sites[2]}, numbered<3>({&a, &b, &c}), WeightIs::radius);
        }
    }
    decltype(made_of({})) ball_;
};

/// Where a site t has its centre that takes the middle of an edge of i and j and leaves both ends,
/// in a metric with additive weights: its ball is within the convex hull of theirs. No linear form
/// n, of dual norm |n|, has n·t + r_t |n| above both n·i + r_i |n| and n·j + r_j |n|.
///
/// Suppose one has. Let v be a vector of length 1 with n·v = |n|, and q = t + s v for any s >= 0.
/// Then d(q, t) = s, and d(q, i) >= n·(q - i) / |n| > s - r_t + r_i, likewise for j: t takes all of
/// this ray. So among the three its cell leads from the middle of the edge to infinity. But the
/// cell of i is connected, and leads from one side of the middle to the other, along the bisector;
/// so does that of j, on the bisector's other side. Together they close in the middle.
///
/// The class tries forms along the axes, and those at a right angle to the edge, where n·i = n·j.
/// The latter leave a strip around the line through i and j: t is no farther from it than R - r_t,
/// R the greater radius of the two. A site that is greater than both takes no middle.
///
/// The centre of t is also within the quadrilateral of i, j and the vertices at the ends of the
/// edge. From a vertex straight to i, no distance falls faster than that from i. So t, which leaves
/// the vertex, takes no point of that side, and of the three other sides neither. They are around
/// the middle of the edge, and so around the cell of t, in which its centre lies. The class asks
/// whether the forms of t's centre are between the least and the greatest ones of the corners.
class Middle {
 public:
    Middle(const Placed& i, const Placed& j) noexcept
        : i_{i.site.x, i.site.y},
          across_{i.site.y - j.site.y, j.site.x - i.site.x},
          greater_(std::max(i.site.r, j.site.r)) {
        const std::array<std::array<double, 2>, 2> centres = {
            {{i.site.x, i.site.y}, {j.site.x, j.site.y}}};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low_[axis] = std::min(centres[0][axis] - i.site.r, centres[1][axis] - j.site.r);
            high_[axis] = std::max(centres[0][axis] + i.site.r, centres[1][axis] + j.site.r);
        }
    }
    /// Of an edge with the faces that are on its sides, if they are finite.
    template <class K>
    [[nodiscard]] static Middle between_faces(const EdgeQuestion& edge) noexcept {
        const Placed& i = edge[0];
        const Placed& j = edge[1];
        const Placed& left = edge[2];
        const Placed& right = edge[3];
        Middle middle(i, j);
        if constexpr (!K::is_straight)
            if (left.id >= 0 && right.id >= 0)
                middle.keep_within({Point{i.site.x, i.site.y}, Point{j.site.x, j.site.y},
                                    Ball<K>({i, j, left, {}}).centre(),
                                    Ball<K>({j, i, right, {}}).centre()});
        return middle;
    }
    [[nodiscard]] bool may_be_taken_from(const Extent& extent) const noexcept {
        const double r = extent.low[weight_place];
        if (r > greater_) return false;
        // Two roundings.
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double slack =
                0x1p-50 * (std::fabs(low_[axis]) + std::fabs(high_[axis]) + std::fabs(r) +
                           std::fabs(extent.low[axis]) + std::fabs(extent.high[axis]));
            if (extent.low[axis] + r > high_[axis] + slack ||
                extent.high[axis] - r < low_[axis] - slack)
                return false;
            if (extent.low[axis] > corners_.high[axis] || extent.high[axis] < corners_.low[axis])
                return false;
        }
        // No dual norm is more than the sum of the magnitudes.
        const double width = (greater_ - r) * (std::fabs(across_[0]) + std::fabs(across_[1]));
        const auto [low, high, error] = across(extent);
        const double slack = error + 0x1p-50 * width;
        return !(low > std::min(width, corners_.high[2]) + slack ||
                 high < std::max(-width, corners_.low[2]) - slack);
    }

 private:
    struct Across {
        double low;
        double high;
        double error;
    };
    /// The form across, less that of i. Four roundings of each term, of which products may
    /// underflow.
    [[nodiscard]] Across across(const Extent& extent) const noexcept {
        Across result{0.0, 0.0, 0.0};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double one = across_[axis] * (extent.low[axis] - i_[axis]);
            const double other = across_[axis] * (extent.high[axis] - i_[axis]);
            result.low += std::min(one, other);
            result.high += std::max(one, other);
            result.error += std::max(std::fabs(one), std::fabs(other));
        }
        result.error = 0x1p-50 * result.error + 0x1p-1000;
        return result;
    }
    /// Each number of a vertex is the nearest double; a face without a vertex has NaN.
    void keep_within(const std::array<Point, 4>& corners) noexcept {
        Bounds<3> bounds = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
        for (const Point& p : corners) {
            const Across there = across(Extent::point({p.x, p.y, 0.0, 0.0}));
            const std::array<double, 3> value = {p.x, p.y, there.low};
            const std::array<double, 3> error = {
                0x1p-50 * std::fabs(p.x) + 0x1p-1070, 0x1p-50 * std::fabs(p.y) + 0x1p-1070,
                there.error +
                    0x1p-50 * (std::fabs(across_[0] * p.x) + std::fabs(across_[1] * p.y))};
            for (std::size_t k = 0; k < 3; ++k) {
                if (!std::isfinite(value[k]) || !std::isfinite(error[k])) return;
                bounds.low[k] = std::min(bounds.low[k], value[k] - error[k]);
                bounds.high[k] = std::max(bounds.high[k], value[k] + error[k]);
            }
        }
        corners_ = bounds;
    }

    std::array<double, 2> i_;
    std::array<double, 2> across_;  ///< the form at a right angle to the edge
    double greater_;
    std::array<double, 2> low_;
    std::array<double, 2> high_;
    /// Of the quadrilateral: along the axes, and across as across() tells.
    Bounds<3> corners_ = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
};

}  // namespace signum::distributed
