/// Error-free transforms, whatever the caller's compiler may contract: a product goes through
/// settled(), so that the compiler fuses no addition with it. Number is named by callers and always
/// double. Laws and sources: as those of core/error_free.hpp.

#include <cmath>

namespace signum {

template <class Number>
struct TwoTermsOf {
    Number high;
    Number low;
};
using TwoTerms = TwoTermsOf<double>;

/// The number, computed before anything is made of it.
[[nodiscard, gnu::always_inline]] inline double settled(double number) noexcept {
#if defined(__SSE2__)
    asm("" : "+x"(number));
#elif defined(__aarch64__)
    asm("" : "+w"(number));
#else
    asm("" : "+m"(number));
#endif
    return number;
}

template <class Number = double>
[[nodiscard, gnu::always_inline]] inline TwoTerms two_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_virtual = sum - a;
    const double a_virtual = sum - b_virtual;
    return {sum, (a - a_virtual) + (b - b_virtual)};
}
template <class Number = double>
[[nodiscard, gnu::always_inline]] inline TwoTerms quick_two_sum(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
[[nodiscard, gnu::always_inline]] inline TwoTerms two_difference(double a, double b) noexcept {
    return two_sum(a, -b);
}

/// By a fused multiply-add where the processor is known to have one; else by halves of 26 bits
/// (Veltkamp, Dekker), which may overflow where a factor is above 2^995.
[[nodiscard, gnu::always_inline]] inline TwoTerms two_product(double a, double b) noexcept {
    const double product = settled(a * b);
#if defined(__FMA__) || defined(__aarch64__)
    return {product, settled(__builtin_fma(a, b, -product))};
#else
    constexpr double splitter = 0x1p27 + 1.0;
    const double scaled_a = settled(splitter * a);
    const double scaled_b = settled(splitter * b);
    const double high_a = scaled_a - settled(scaled_a - a);
    const double high_b = scaled_b - settled(scaled_b - b);
    const double low_a = a - high_a;
    const double low_b = b - high_b;
    // Each of these is exact, fused or not.
    const double rest = ((high_a * high_b - product) + high_a * low_b) + low_a * high_b;
    return {product, settled(low_a * low_b + rest)};
#endif
}

}  // namespace signum
