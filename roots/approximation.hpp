#pragma once
/// Numbers known by a double and a bound on its error: intervals by middle and radius. For the
/// coefficients of polynomials, of which a product costs half of that of two intervals by their
/// ends (filters/interval.hpp) and has no comparison in it.
///
/// Laws, in rounding to nearest with denormals kept; elsewhere nobody asks for a sign:
///  1. The number lies within slack · error of the value. With u = 2^-53 the operations on values
///     err by at most u|v| and, in a product, by an underflow of at most 2^-1075; sums that are
///     denormal are exact. The error's own operations add and multiply numbers that are not
///     negative, so that k of them along any path lose at most a factor (1 - u)^k >= 1 / slack for
///     k up to 2^22; polynomials of degree 8 and their bisection take fewer than 2^12. A term
///     2^-52 |v| is twice what it has to be, so that its own underflow, at most a quarter of it
///     wherever v is not exact, takes nothing away.
///  2. Where something overflows value or error is infinite or NaN, and then so is the error of all
///     that comes of it: infinite values have infinite errors, as 2^-52 |v| is. No sign is certain.
///  3. A number that is exactly 0 stays so in products: a point at rest has no coefficient at t
///     that is merely small.

#include "../filters/bounds.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::roots {

struct Approximation {
    double value = 0.0;
    double error = 0.0;

    static constexpr double slack = 1.0 + 0x1p-30;
    /// Above what the three products of a product may lose, 2^-1075 each.
    static constexpr double underflow = 0x1p-1070;

    Approximation() = default;
    constexpr Approximation(double number, double bound) noexcept : value(number), error(bound) {}
    /// The number itself.
    explicit constexpr Approximation(double number) noexcept : value(number) {}

    [[nodiscard]] constexpr double size() const noexcept { return filters::magnitude(value); }
    /// Certainly not 0; then the sign of the value is that of the number.
    [[nodiscard]] constexpr bool has_sign() const noexcept { return size() > slack * error; }
    [[nodiscard]] constexpr bool is_zero() const noexcept { return value == 0.0 && error == 0.0; }

    friend constexpr Approximation operator-(const Approximation& a) noexcept {
        return {-a.value, a.error};
    }
    friend constexpr Approximation operator+(const Approximation& a,
                                             const Approximation& b) noexcept {
        const double v = a.value + b.value;
        return {v, (a.error + b.error) + filters::epsilon * filters::magnitude(v)};
    }
    friend constexpr Approximation operator-(const Approximation& a,
                                             const Approximation& b) noexcept {
        return a + -b;
    }
    friend constexpr Approximation operator*(const Approximation& a,
                                             const Approximation& b) noexcept {
        const double v = a.value * b.value;
        const double of_a = a.size() + a.error;
        const double of_b = b.size() + b.error;
        const bool either_is_zero = (of_a == 0.0) | (of_b == 0.0);
        const double lost = either_is_zero ? 0.0 : underflow;
        return {v, (a.size() * b.error + a.error * of_b) +
                       (filters::epsilon * filters::magnitude(v) + lost)};
    }
    friend constexpr Approximation operator*(int a, const Approximation& b) noexcept {
        return Approximation(a) * b;
    }
};

}  // namespace signum::roots

SIGNUM_IEEE_END
