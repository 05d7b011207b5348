#pragma once
/// Orthogonal circles and spheres in doubles, with bounds of their errors: whether sites in a box
/// may conflict with them. What is not surely out of reach is in reach, so that signs,
/// infinitesimals of the tie rule and lack of precision need no special case.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "plan.hpp"

namespace signum::triangulation {

/// w of a site of the power metric, rounded.
template <class S>
[[nodiscard]] double weight_of(const S& site) noexcept {
    if constexpr (requires { site.w; })
        return site.w;
    else if constexpr (requires { site.r; })
        return site.r * site.r;
    else
        return 0.0;
}

/// A point, and its power.
template <std::size_t D>
struct Orthoball {
    std::array<double, D> centre;
    double error;   ///< of each coordinate of the centre
    double square;  ///< at least the power of the centre

    /// More than a few roundings of what it multiplies; and more than any underflow.
    static constexpr double slop = 0x1p-40;
    static constexpr double least = 0x1p-900;

    /// The one whose centre is that far from a site's, but for an error in each coordinate.
    [[nodiscard]] static Orthoball from(const std::array<double, D>& site, double weight,
                                        const std::array<double, D>& offset,
                                        double error) noexcept {
        using std::fabs;
        Orthoball ball{{}, error, 0.0};
        double magnitude = 0.0;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const double most = fabs(offset[axis]) + error;
            ball.centre[axis] = site[axis] + offset[axis];
            ball.square += most * most;
            magnitude += fabs(site[axis]) + fabs(offset[axis]);
        }
        ball.error += 0x1p-50 * magnitude;
        ball.square = ball.square * (1.0 + slop) - weight + slop * fabs(weight);
        return ball;
    }
    /// By how much the sites in the box are farther from the point than its power says, less what
    /// rounding may have made of it: above 0 where none of them is nearer.
    [[nodiscard]] double excess(const Box<D>& box) const noexcept {
        double least_square = 0.0;
        for (std::size_t axis = 0; axis < D; ++axis) {
            const double c = centre[axis];
            const double distance =
                std::max(std::max(box.low[axis] - c, c - box.high[axis]) - error, 0.0);
            least_square += distance * distance;
        }
        const double slack = std::fabs(square) + std::fabs(box.greatest);
        return least_square * (1.0 - slop) - ((square + box.greatest) + (slop * slack + least));
    }
    /// Whether a site in the box may be nearer to the point than its power says.
    [[nodiscard]] bool may_be_reached_from(const Box<D>& box) const noexcept {
        return !(excess(box) > 0.0);
    }
};

}  // namespace signum::triangulation
