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

/// Of doubles, or of vectors of them.
template <class Number>
struct DoubleDoubleOf {
    Number high;
    Number low;

    [[gnu::always_inline]] friend inline DoubleDoubleOf operator+(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> sum = two_sum(x.high, y.high);
        const TwoTermsOf<Number> result = two_sum<Number>(sum.high, sum.low + (x.low + y.low));
        return {result.high, result.low};
    }
    [[gnu::always_inline]] friend inline DoubleDoubleOf operator-(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        return x + DoubleDoubleOf{-y.high, -y.low};
    }
    [[gnu::always_inline]] friend inline DoubleDoubleOf operator*(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> product = two_product(x.high, y.high);
        const Number cross = x.high * y.low + x.low * y.high;
        // What is small here is at most 4u of the product.
        const TwoTermsOf<Number> result = quick_two_sum<Number>(product.high, product.low + cross);
        return {result.high, result.low};
    }
    [[gnu::always_inline]] friend inline DoubleDoubleOf operator*(
        const Number& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> product = two_product(x, y.high);
        const TwoTermsOf<Number> result =
            quick_two_sum<Number>(product.high, product.low + x * y.low);
        return {result.high, result.low};
    }
};
using DoubleDouble = DoubleDoubleOf<double>;

/// a - b, exactly.
template <class Number>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Number> exact_difference(
    const Number& a, const Number& b) noexcept {
    const TwoTermsOf<Number> difference = two_difference(a, b);
    return {difference.high, difference.low};
}

/// a + b, exactly.
[[nodiscard, gnu::always_inline]] inline DoubleDouble exact_sum(double a, double b) noexcept {
    const TwoTerms sum = two_sum(a, b);
    return {sum.high, sum.low};
}

}  // namespace signum::filters
