#pragma once
/// Doubles made to break predicates, and the same as integers of any size.

#include <gmpxx.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "../thoroughness.hpp"

namespace signum {

/// The exponent of the last set bit.
inline int last_bit(double value) {
    if (value == 0.0) return 1023;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const auto bits = static_cast<std::int64_t>(std::ldexp(std::fabs(fraction), 53));
    return exponent - 53 + __builtin_ctzll(static_cast<std::uint64_t>(bits));
}

/// value · 2^scale, an integer.
inline mpz_class scaled(double value, int scale) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    mpz_class result = static_cast<long>(std::ldexp(fraction, 53));
    const int shift = exponent - 53 + scale;
    if (shift >= 0) {
        mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    } else {
        mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
    }
    return result;
}

class Random {
 public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    int between(int low, int high) { return low + below(high - low + 1); }
    bool coin() { return (bits_() & 1) != 0; }
    double real() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    double sign() { return coin() ? 1.0 : -1.0; }
    template <class T, std::size_t n>
    T any(const T (&values)[n]) {
        return values[below(static_cast<int>(n))];
    }
    /// Significand in [1, 2): all kinds.
    double significand() {
        switch (below(4)) {
            case 0:
                return 1.0;
            case 1:
                return 1.0 + 0x1p-52 * below(4);
            case 2:
                return 2.0 - 0x1p-52 * between(1, 4);
            default:
                return 1.0 + real();
        }
    }

 private:
    std::mt19937_64 bits_;
};

/// Up to three steps to a neighbouring double, most often none.
inline double moved(Random& random, double value) {
    if (random.below(3) != 0) return value;
    const double toward = random.coin() ? HUGE_VAL : -HUGE_VAL;
    double result = value;
    for (int steps = random.between(1, 3); steps > 0; --steps) {
        const double next = std::nextafter(result, toward);
        if (std::isfinite(next)) result = next;
    }
    return result;
}

/// How many trials, as a share of those of an optimised build.
#if defined(__SANITIZE_THREAD__)
inline const double effort = 0.1;
#else
inline const double effort = is_fast ? 1.0 : is_sanitized ? 0.03 : 0.25;
#endif

}  // namespace signum
