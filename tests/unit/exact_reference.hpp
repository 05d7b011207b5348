#pragma once
/// What the tests of exact/ share: doubles as GMP integers, inputs made to hurt, and the
/// floating-point environments that a caller may have left behind.

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include <gmpxx.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace signum::reference {

/// result = value · 2^scale, in the memory that result has. Throws where that is not an integer.
inline void set_scaled(mpz_class& result, double value, int scale) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    result = static_cast<long>(std::ldexp(fraction, 53));
    const int shift = exponent - 53 + scale;
    const mpz_ptr number = result.get_mpz_t();
    if (shift >= 0) {
        mpz_mul_2exp(number, number, static_cast<mp_bitcnt_t>(shift));
        return;
    }
    const auto places = static_cast<mp_bitcnt_t>(-shift);
    if (result != 0 && mpz_scan1(number, 0) < places)
        throw std::domain_error("a set bit below the scale");
    mpz_tdiv_q_2exp(number, number, places);
}

inline mpz_class scaled(double value, int scale) {
    mpz_class result;
    set_scaled(result, value, scale);
    return result;
}

/// Every finite double is an integer at this scale.
constexpr int finest = 1074;

/// A floating-point environment that the exact stages must not trust: 0 is the default one, the
/// others are the four rounding modes, with (4 to 7) and without (1 to 3) flushing of denormals.
class Hostile {
 public:
    static constexpr int modes = 8;

    explicit Hostile(int mode) {
#if defined(__SSE2__)
        set_ = 0x1F80U | (static_cast<unsigned>(mode) & 3U) << 13 | (mode >= 4 ? 0x8040U : 0U);
        _mm_setcsr(set_);
#else
        constexpr int rounding[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
        set_ = static_cast<unsigned>(rounding[mode % 4]);
        std::fesetround(static_cast<int>(set_));
#endif
    }
    ~Hostile() {
#if defined(__SSE2__)
        _mm_setcsr(0x1F80);
#else
        std::fesetround(FE_TONEAREST);
#endif
    }
    Hostile(const Hostile&) = delete;
    Hostile& operator=(const Hostile&) = delete;

    /// Whether the control bits are still those that were set.
    [[nodiscard]] bool stands() const {
#if defined(__SSE2__)
        return (_mm_getcsr() & ~0x3FU) == set_;
#else
        return std::fegetround() == static_cast<int>(set_);
#endif
    }

 private:
    unsigned set_;
};

/// function(), called in the environment; an opaque call, across which nothing else moves.
template <class Function>
[[gnu::noinline]] auto in_environment(int mode, Function function) {
    const Hostile environment(mode);
    asm volatile("" : : : "memory");
    auto result = function();
    asm volatile("" : "+m"(result) : : "memory");
    if (!environment.stands()) throw std::logic_error("the environment was not restored");
    return result;
}

class Random {
 public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    /// 0 <= result < count.
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    int between(int low, int high) { return low + below(high - low + 1); }
    bool coin() { return (bits_() & 1) != 0; }
    std::mt19937_64& engine() { return bits_; }

    /// In [1, 2): arbitrary, few set bits, alternating bits, next to 1, next to 2.
    double significand() {
        constexpr double ulp = 0x1p-52;
        switch (below(8)) {
            case 0:
                return 1.0;
            case 1:
                return 1.0 + ulp * below(3);
            case 2:
                return 2.0 - ulp * between(1, 3);
            case 3:
                return coin() ? 0x1.5555555555555p0 : 0x1.aaaaaaaaaaaaap0;
            case 4:
                return 1.0 + std::ldexp(1.0, -between(1, 52));
            default:
                return 1.0 + ulp * static_cast<double>(bits_() >> 12);
        }
    }
    /// A magnitude in [2^low, 2^(high + 1)) and a random sign.
    double in_binades(int low, int high) {
        const double magnitude = std::ldexp(significand(), between(low, high));
        return coin() ? magnitude : -magnitude;
    }
    /// Any finite double; often 0, denormal, huge or the largest.
    double finite() {
        const double sign = coin() ? 1.0 : -1.0;
        switch (below(10)) {
            case 0:
                return sign * 0.0;
            case 1:
                return sign * std::numeric_limits<double>::denorm_min() * between(1, 5);
            case 2:
                return sign * std::bit_cast<double>(bits_() >> 12);
            case 3:
                return in_binades(1020, 1022);
            case 4:
                return sign * std::numeric_limits<double>::max();
            case 5:
                return in_binades(-3, 3);
            default:
                return in_binades(-1022, 1022);
        }
    }

 private:
    std::mt19937_64 bits_;
};

/// The square of (a-b)(x-y) + (b-x)² - 4(a-y)b, of degree 4: with x and y exchanged it differs by
/// what is small beside it, and so do products of the two.
template <class Number>
[[nodiscard]] Number quartic(const Number& a, const Number& b, const Number& x, const Number& y) {
    const Number inner = (a - b) * (x - y) + (b - x) * (b - x) - 4 * ((a - y) * b);
    return inner * inner;
}

}  // namespace signum::reference
