#pragma once
/// The lattice that sites lie on: the largest power of two of which all their numbers are
/// multiples. Close together on it, determinants of offsets commit no rounding, and an exact zero
/// is seen without exact numbers.

#include <algorithm>
#include <cmath>
#include <span>

#include "../../exact/parts.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum::spatial {

class Lattice {
 public:
    /// A weight is to be a multiple of the square. Radii of which sums overflow lie on none: the
    /// difference of two equal weights, a product of difference and sum, is no number then.
    template <power::PowerSite3 S>
    explicit Lattice(std::span<const S> sites) noexcept {
        int lowest = 1024;
        for (const S& site : sites) {
            for (const double number : {site.x, site.y, site.z})
                lowest = std::min(lowest, last_bit(number));
            if constexpr (requires { site.r; }) {
                if (!(std::fabs(site.r) < 0x1p1023)) return;
                lowest = std::min(lowest, last_bit(site.r));
            }
            if constexpr (requires { site.w; })
                lowest = std::min(lowest, (last_bit(site.w) - (last_bit(site.w) & 1)) / 2);
            if (lowest < -least_exponent) return;
        }
        if (lowest > least_exponent) return;
        per_unit_ = std::ldexp(1.0, -lowest);
        exact_below_3_ = std::ldexp(1.0, 53 + 3 * lowest);
        exact_below_5_ = std::ldexp(1.0, 53 + 5 * lowest);
    }

    /// What a sum of products of three offsets, or five (of which a weight counts as two), may
    /// come to in magnitude, every term positive, so that no operation rounds: all numbers on the
    /// way are multiples of a power of the lattice's unit and below 2^53 times it. Holds where no
    /// offset is below the unit along all axes.
    [[nodiscard]] double exact_below_3() const noexcept { return exact_below_3_; }
    [[nodiscard]] double exact_below_5() const noexcept { return exact_below_5_; }
    /// A sum of products of five that is in error by less than this, and no greater, is 0: it is a
    /// multiple of the unit's fifth power, of which this is half.
    [[nodiscard]] double zero_below_5() const noexcept { return exact_below_5_ * 0x1p-54; }
    /// How many units are 1.
    [[nodiscard]] double per_unit() const noexcept { return per_unit_; }

 private:
    static constexpr int least_exponent = 150;

    /// The exponent of the last bit that is set; large for 0.
    [[nodiscard]] static int last_bit(double number) noexcept {
        const exact::Parts parts = exact::parts(number);
        return parts.significand == 0 ? 1024 : parts.exponent;
    }

    double per_unit_ = 0.0;
    double exact_below_3_ = 0.0;
    double exact_below_5_ = 0.0;
};

}  // namespace signum::spatial
