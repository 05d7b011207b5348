#pragma once
/// Error-free transforms: the rounded result of one operation and its exact error.
///
/// Laws, in rounding to nearest without flushing of denormals (see exact/floating_environment.hpp):
///  1. high + low equals the exact result of the operation;
///  2. high is the rounded result, |low| <= ulp(high) / 2.
/// Always inlined, so that no other program's copy of them, compiled with other flags, takes the
/// place of the library's. Sources: Dekker 1971, Knuth TAOCP 2 (4.2.2), Ogita, Rump and Oishi 2005.

#include <cstddef>
#include <type_traits>

#include "contract.hpp"

namespace signum {

/// An unevaluated sum high + low; of doubles, or of vectors of them.
template <class Number>
struct TwoTermsOf {
    Number high;
    Number low;
};
using TwoTerms = TwoTermsOf<double>;

/// a + b, for |a| and |b| below the largest double (beside it b_virtual can overflow) whose sum
/// does not overflow.
template <class Number>
[[nodiscard, gnu::always_inline]] inline TwoTermsOf<Number> two_sum(const Number& a,
                                                                    const Number& b) noexcept {
    const Number sum = a + b;
    const Number b_virtual = sum - a;
    const Number a_virtual = sum - b_virtual;
    return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// a + b where |a| >= |b| or a = 0.
template <class Number>
[[nodiscard, gnu::always_inline]] inline TwoTermsOf<Number> quick_two_sum(
    const Number& a, const Number& b) noexcept {
    const Number sum = a + b;
    return {sum, b - (sum - a)};
}

/// a - b, for |a| and |b| below the largest double whose difference does not overflow.
template <class Number>
[[nodiscard, gnu::always_inline]] inline TwoTermsOf<Number> two_difference(
    const Number& a, const Number& b) noexcept {
    return two_sum<Number>(a, -b);
}

/// a · b + c, rounded once.
template <class Number>
[[gnu::always_inline]] inline void multiply_add(Number& result, const Number& a, const Number& b,
                                                const Number& c) noexcept {
    if constexpr (std::is_same_v<Number, double>)
        result = __builtin_fma(a, b, c);
    else
        for (std::size_t k = 0; k < sizeof(Number) / sizeof(double); ++k)
            result[k] = __builtin_fma(a[k], b[k], c[k]);
}

/// a · b, where the product does not overflow and is 0 or at least 2^-968: below, the error
/// would need bits under the smallest denormal.
template <class Number>
[[nodiscard, gnu::always_inline]] inline TwoTermsOf<Number> two_product(const Number& a,
                                                                        const Number& b) noexcept {
    const Number product = a * b;
    Number error;
    multiply_add<Number>(error, a, b, -product);
    return {product, error};
}

}  // namespace signum
