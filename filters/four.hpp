#pragma once
/// Four doubles at once, by the compiler's vectors: one instruction where the processor has wide
/// ones (core/processor.hpp), several elsewhere, and the same bits. For sources only.
///
/// What makes such a vector writes it into its first argument: how a function would return one
/// depends on the processor it is compiled for.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "double_double.hpp"

namespace signum::filters {

inline constexpr std::size_t lanes = 4;
using Four = double __attribute__((vector_size(lanes * sizeof(double))));
/// Four answers: all bits or none.
using Flags = std::int64_t __attribute__((vector_size(lanes * sizeof(double))));
using FourDoubleDoubles = DoubleDoubleOf<Four>;

[[gnu::always_inline]] inline void magnitude(Four& result, const Four& numbers) noexcept {
    result = (Four)((Flags)numbers & std::numeric_limits<std::int64_t>::max());
}
[[gnu::always_inline]] inline void add_magnitude(Four& sum, const Four& numbers) noexcept {
    Four magnitudes;
    magnitude(magnitudes, numbers);
    sum += magnitudes;
}
[[gnu::always_inline]] inline void square_root(Four& result, const Four& numbers) noexcept {
    for (std::size_t k = 0; k < lanes; ++k) result[k] = std::sqrt(numbers[k]);
}
[[nodiscard, gnu::always_inline]] inline double sum_of(const Four& numbers) noexcept {
    return (numbers[0] + numbers[1]) + (numbers[2] + numbers[3]);
}
[[nodiscard, gnu::always_inline]] inline FourDoubleDoubles four_times(DoubleDouble x) noexcept {
    return {Four{} + x.high, Four{} + x.low};
}

/// The sum of the products of the first lanes, with an error below 2^-99 = 128 u² of the sum S of
/// their magnitudes. For what is added to the low part is at most 5uS, in 5 operations a product,
/// and u² S is dropped.
template <int number>
[[nodiscard, gnu::always_inline]] inline DoubleDouble dot(const FourDoubleDoubles& x,
                                                          const FourDoubleDoubles& y) noexcept {
    const TwoTermsOf<Four> product = two_product(x.high, y.high);
    const Four low = product.low + (x.high * y.low + x.low * y.high);
    double high = product.high[0];
    double rest = low[0];
    for (int k = 1; k < number; ++k) {
        const TwoTerms sum = two_sum<double>(high, product.high[k]);
        high = sum.high;
        rest += sum.low + low[k];
    }
    const TwoTerms result = two_sum(high, rest);
    return {result.high, result.low};
}

}  // namespace signum::filters
