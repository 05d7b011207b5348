#pragma once
/// Numbers known by a double-double and a bound on its error: approximations (approximation.hpp)
/// with a hundred bits, for a sign beside a root that doubles cannot tell. For sources only.
///
/// Laws, in rounding to nearest with denormals kept; elsewhere nobody asks for a sign:
///  1. The number lies within Approximation::slack · error of the value. By the laws of
///     filters/double_double.hpp a sum errs by at most 2^-104 (|x| + |y|) and a product by 9/16 of
///     2^-102 |xy|, where |x| is at most 1 + 2^-53 times that of its first double; the bounds below
///     are larger. Beside that a product loses 2^-1075 in each of its three smaller products, where
///     these underflow; sums that are denormal are exact. What the error's own operations lose the
///     slack gives back, as there.
///  2. Where something overflows value or error is infinite or NaN, and then so is all that comes
///     of it. No sign is certain.

#include "../filters/double_double.hpp"
#include "approximation.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::roots {

struct Refined {
    filters::DoubleDouble value{0.0, 0.0};
    double error = 0.0;

    Refined() = default;
    Refined(const filters::DoubleDouble& number, double bound) noexcept
        : value(number), error(bound) {}
    /// The number itself.
    explicit Refined(double number) noexcept : value{number, 0.0} {}

    [[nodiscard]] double size() const noexcept { return filters::magnitude(value.high); }
    /// Certainly not 0; then the sign of the value is that of the number. The second double is less
    /// than an epsilon of the first one.
    [[nodiscard]] bool has_sign() const noexcept {
        return (1.0 - filters::epsilon) * size() > Approximation::slack * error;
    }

    friend Refined operator-(const Refined& a) noexcept {
        return {{-a.value.high, -a.value.low}, a.error};
    }
    friend Refined operator+(const Refined& a, const Refined& b) noexcept {
        return {a.value + b.value, (a.error + b.error) + 0x1p-103 * (a.size() + b.size())};
    }
    friend Refined operator-(const Refined& a, const Refined& b) noexcept { return a + -b; }
    friend Refined operator*(const Refined& a, const Refined& b) noexcept {
        const double of_a = a.size() + a.error;
        const double of_b = b.size() + b.error;
        const bool either_is_zero = (of_a == 0.0) | (of_b == 0.0);
        const double lost = either_is_zero ? 0.0 : Approximation::underflow;
        return {a.value * b.value,
                (a.size() * b.error + a.error * of_b) +
                    (filters::double_double_epsilon * (a.size() * b.size()) + lost)};
    }
    friend Refined operator*(int a, const Refined& b) noexcept { return Refined(a) * b; }
};

}  // namespace signum::roots

SIGNUM_IEEE_END
