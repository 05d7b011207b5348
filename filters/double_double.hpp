#pragma once
/// Double-double arithmetic: unevaluated sums of two doubles, some 100 bits, for the refine stage.
///
/// Laws, with u = 2^-53, in rounding to nearest, without overflow and with no product's error term
/// under the denormals (the caller checks the window):
///  1. results are normalized, |low| <= u |high|;
///  2. |x + y - exact| <= 4 u² (|x| + |y|): fl(xl + yl) errs by u (|xl| + |yl|) <= u² (|x| + |y|),
///     the next sum by u (|error of xh + yh| + |xl + yl|) <= 2u² (|x| + |y|), terms in u³ fill the
///     rest;
///  3. |x · y - exact| <= 9 u² |x y|: the dropped xl·yl is u², the two cross products err by u²
///     each, their sum by 2u², the last addition by 3u², terms in u³ fill the rest.
/// So every operation commits a relative error of at most double_double_epsilon against the
/// magnitudes of its operands.

#include "../core/error_free.hpp"

namespace signum::filters {

inline constexpr double double_double_epsilon = 0x1p-102;

struct DoubleDouble {
    double high;
    double low;

    [[gnu::always_inline]] friend inline DoubleDouble operator+(DoubleDouble x,
                                                                DoubleDouble y) noexcept {
        const TwoTerms sum = two_sum(x.high, y.high);
        const TwoTerms result = two_sum(sum.high, sum.low + (x.low + y.low));
        return {result.high, result.low};
    }
    [[gnu::always_inline]] friend inline DoubleDouble operator-(DoubleDouble x,
                                                                DoubleDouble y) noexcept {
        return x + DoubleDouble{-y.high, -y.low};
    }
    [[gnu::always_inline]] friend inline DoubleDouble operator*(DoubleDouble x,
                                                                DoubleDouble y) noexcept {
        const TwoTerms product = two_product(x.high, y.high);
        const double cross = x.high * y.low + x.low * y.high;
        // What is small here is at most 4u of the product.
        const TwoTerms result = quick_two_sum(product.high, product.low + cross);
        return {result.high, result.low};
    }
    [[gnu::always_inline]] friend inline DoubleDouble operator*(double x, DoubleDouble y) noexcept {
        const TwoTerms product = two_product(x, y.high);
        const TwoTerms result = quick_two_sum(product.high, product.low + x * y.low);
        return {result.high, result.low};
    }
};

/// sum += x·y for sums of up to four products, of which the parts overlap until normalized(): they
/// err by less than 2^-99 = 128 u² of the sum S of their magnitudes, with the normalization. For
/// what is added to the low part is at most 5uS, in 5 operations a product, and u² S is dropped.
[[gnu::always_inline]] inline void add_product(DoubleDouble& sum, DoubleDouble x,
                                               DoubleDouble y) noexcept {
    const TwoTerms product = two_product(x.high, y.high);
    const TwoTerms high = two_sum(sum.high, product.high);
    const double cross = x.high * y.low + x.low * y.high;
    sum = {high.high, sum.low + (high.low + (product.low + cross))};
}
[[nodiscard, gnu::always_inline]] inline DoubleDouble normalized(DoubleDouble x) noexcept {
    const TwoTerms result = two_sum(x.high, x.low);
    return {result.high, result.low};
}

/// a - b, exactly.
[[nodiscard, gnu::always_inline]] inline DoubleDouble exact_difference(double a,
                                                                       double b) noexcept {
    const TwoTerms difference = two_difference(a, b);
    return {difference.high, difference.low};
}

/// a + b, exactly.
[[nodiscard, gnu::always_inline]] inline DoubleDouble exact_sum(double a, double b) noexcept {
    const TwoTerms sum = two_sum(a, b);
    return {sum.high, sum.low};
}

}  // namespace signum::filters
