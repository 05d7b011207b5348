#pragma once
/// Pairs of doubles: the rounded number, and the first-order error of all that it was made of.
///
/// Laws, with u = 2^-53, to nearest, without over- or underflow. Let M be the size of a number
/// (determinants.hpp) and k the roundings on the way to it (filters/rounding_count.hpp), a
/// difference of two doubles being one:
///  1. |high - exact| <= ((1+u)^k - 1) M, and so |low| <= k u M but for terms in u²;
///  2. |high + low - exact| <= 5 k² u² M.
/// Proof of the second, by 4 k² u² M and terms in u³. A difference is exact. A sum, k one more than
/// that of either operand, adds the roundings of two additions of lows, 2 k u²: 4(k-1)² + 2k <=
/// 4k². A product, k = p + q + 1, drops low·low, p q u², and rounds the two cross products, their
/// sum and the whole, (p + q) u², (p + q) u² and k u²: 4p² + 4q² + pq + 4k <= 4k². Of
/// double-doubles (filters/double_double.hpp) they are the cheaper kin: nothing is normalized.

#include "../../core/error_free.hpp"
#include "determinants.hpp"

namespace signum::classic {

struct Pair {
    double high;
    double low;

    [[gnu::always_inline]] friend inline Pair operator+(const Pair& x, const Pair& y) noexcept {
        const TwoTerms sum = two_sum(x.high, y.high);
        return {sum.high, sum.low + (x.low + y.low)};
    }
    [[gnu::always_inline]] friend inline Pair operator-(const Pair& x) noexcept {
        return {-x.high, -x.low};
    }
    [[gnu::always_inline]] friend inline Pair operator-(const Pair& x, const Pair& y) noexcept {
        return x + -y;
    }
    [[gnu::always_inline]] friend inline Pair operator*(const Pair& x, const Pair& y) noexcept {
        const TwoTerms product = two_product(x.high, y.high);
        return {product.high, product.low + (x.high * y.low + x.low * y.high)};
    }
};
template <>
struct Minus<Pair> {
    [[gnu::always_inline]] static Pair of(double a, double b) noexcept {
        const TwoTerms difference = two_difference(a, b);
        return {difference.high, difference.low};
    }
};

/// Roundings on the way to the determinant.
template <class Determinant>
inline constexpr int roundings =
    Determinant{}.template determinant<filters::RoundingCount>().roundings;

/// Where |high + low| is at least this multiple of the size, its error is at most 2^-56 of it, an
/// eighth of a unit in the last place; to round it costs half a unit. 6 stands in the place of 5
/// for what the size itself was rounded by.
template <class Determinant>
inline constexpr double least_of_pairs =
    6.0 * roundings<Determinant>* roundings<Determinant> * 0x1p-106 * 0x1p56;

}  // namespace signum::classic
