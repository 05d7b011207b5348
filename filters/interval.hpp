#pragma once
/// Interval arithmetic: numbers known between two doubles.
///
/// Law: the result of an operation contains the exact results for all numbers of its operands, in
/// rounding to nearest with denormals kept; elsewhere exceeds() is false.
/// Why: with r the rounded result and e = 2^-52 the exact one lies within ulp(r) <= e|r| of it,
/// unless a product underflows, which costs less than 2^-1022 (sums do not: below 2^-1021 they are
/// exact). So r - (e|r| + underflow), before it is rounded, is at most the double before r, and
/// rounded no more than that, as rounding keeps order; the same above. Where something overflows
/// the interval is that of all numbers. No rounding mode is changed, and no compiler need know of
/// one; contraction to fused multiply-add leaves out roundings and does no harm.

#include "bounds.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::filters {

/// Of two rounded numbers.
template <class Number>
[[nodiscard]] constexpr Number min(Number a, Number b) noexcept {
    return a < b ? a : b;
}
template <class Number>
[[nodiscard]] constexpr Number max(Number a, Number b) noexcept {
    return a < b ? b : a;
}

/// All numbers from low to high.
struct Interval {
    double low;
    double high;

    Interval() = default;
    constexpr Interval(double from, double to) noexcept : low(from), high(to) {}
    /// The number itself.
    explicit constexpr Interval(double number) noexcept : low(number), high(number) {}

    [[nodiscard]] static constexpr Interval everything() noexcept {
        constexpr double infinity = __builtin_huge_val();
        return {-infinity, infinity};
    }

    friend Interval operator-(const Interval& a) noexcept { return {-a.high, -a.low}; }
    friend Interval operator+(const Interval& a, const Interval& b) noexcept {
        return around(a.low + b.low, a.high + b.high, 0.0);
    }
    friend Interval operator-(const Interval& a, const Interval& b) noexcept { return a + -b; }
    friend Interval operator*(const Interval& a, const Interval& b) noexcept {
        const double p = a.low * b.low;
        const double q = a.low * b.high;
        const double r = a.high * b.low;
        const double s = a.high * b.high;
        // The comparisons below would pass by a NaN.
        if (!((magnitude(p) + magnitude(q)) + (magnitude(r) + magnitude(s)) <=
              0x1.fffffffffffffp1023)) [[unlikely]]
            return everything();
        const double least = min(min(p, q), min(r, s));
        const double greatest = max(max(p, q), max(r, s));
        return around(least, greatest, 0x1p-1022);
    }
    friend Interval operator*(int a, const Interval& b) noexcept { return Interval(a) * b; }

 private:
    static Interval around(double low, double high, double underflow) noexcept {
        const double below = low - (epsilon * magnitude(low) + underflow);
        const double above = high + (epsilon * magnitude(high) + underflow);
        if (!(below <= above)) [[unlikely]]
            return everything();
        return {below, above};
    }
};

/// Of absolute values.
[[nodiscard]] inline Interval magnitude(const Interval& a) noexcept {
    if (a.low >= 0.0) return a;
    if (a.high <= 0.0) return -a;
    return {0.0, max(-a.low, a.high)};
}

/// Of all numbers of the one and all of the other.
[[nodiscard]] inline Interval max(const Interval& a, const Interval& b) noexcept {
    return {max(a.low, b.low), max(a.high, b.high)};
}

// What a predicate asks of a rounded number, whatever its type.

/// Whether the magnitude is certainly greater than the bound.
[[nodiscard]] inline bool exceeds(double value, double bound) noexcept {
    return magnitude(value) > bound;
}
[[nodiscard]] inline bool exceeds(const Interval& value, double bound) noexcept {
    return (value.low > bound || value.high < -bound) && environment_is_default();
}

/// The sign of all numbers of an interval that does not contain 0.
[[nodiscard]] inline int sign_of_nonzero(const Interval& value) noexcept {
    return value.low > 0.0 ? 1 : -1;
}

}  // namespace signum::filters

SIGNUM_IEEE_END
