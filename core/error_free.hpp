#pragma once
/// Error-free transforms: the rounded result of one operation and its exact error.
///
/// Laws, in rounding to nearest without flushing of denormals (see exact/floating_environment.hpp):
///  1. high + low equals the exact result of the operation;
///  2. high is the rounded result, |low| <= ulp(high) / 2.
/// Always inlined, so that no other program's copy of them, compiled with other flags, takes the
/// place of the library's. Sources: Dekker 1971, Knuth TAOCP 2 (4.2.2), Ogita, Rump and Oishi 2005.

#include "contract.hpp"

namespace signum {

/// An unevaluated sum high + low.
struct TwoTerms {
    double high;
    double low;
};

/// a + b, for |a| and |b| below the largest double (beside it b_virtual can overflow) whose sum
/// does not overflow.
[[nodiscard, gnu::always_inline]] inline TwoTerms two_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_virtual = sum - a;
    const double a_virtual = sum - b_virtual;
    return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// a + b where |a| >= |b| or a = 0.
[[nodiscard, gnu::always_inline]] inline TwoTerms quick_two_sum(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a - b, for |a| and |b| below the largest double whose difference does not overflow.
[[nodiscard, gnu::always_inline]] inline TwoTerms two_difference(double a, double b) noexcept {
    return two_sum(a, -b);
}

/// a · b, where the product does not overflow and is 0 or at least 2^-968: below, the error
/// would need bits under the smallest denormal.
[[nodiscard, gnu::always_inline]] inline TwoTerms two_product(double a, double b) noexcept {
    const double product = a * b;
    return {product, __builtin_fma(a, b, -product)};
}

}  // namespace signum
