#pragma once
/// When two growing balls meet, in integers: the rule of motion/meeting_time.hpp, and whether a
/// double is the nearest one.
///
/// From the latest own time T on, at T + s, the gap is F = |X + V s|² - (R + q s)² = A s² + 2 B s +
/// C. They meet at the least s >= 0 with F <= 0 and F falling right after: at once, at the root
/// (-B - √(B² - AC)) / A, at -C / (2B) where A = 0, or, overlapping where F rises to its top and
/// falls from there, at the top -B / A.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "integer.hpp"
#include "scaled.hpp"

namespace signum::fuzz::meeting_oracle {

/// Two balls of space: places and radii at time 0, speeds and growth of the radii, own times.
struct Flight {
    std::array<double, 3> x;
    std::array<double, 3> v;
    double radius;
    double growth;
    double time;
};

enum class Kind : std::uint8_t { never, at_once, root, linear, top };

/// The coefficients of F, at times in units of 2^unit.
class Gap {
 public:
    Gap(const Flight& a, const Flight& b, int unit) {
        int speed = std::numeric_limits<int>::max();
        int length = std::numeric_limits<int>::max();
        const auto see = [](int& least, double number) {
            if (const Digits digits = digits_of(number); digits.significand != 0)
                least = std::min(least, digits.exponent);
        };
        for (const Flight* flight : {&a, &b}) {
            for (const double v : flight->v) see(speed, v);
            see(speed, flight->growth);
            for (const double x : flight->x) see(length, x);
            see(length, flight->radius);
        }
        if (speed == std::numeric_limits<int>::max()) speed = 0;
        if (speed + unit < length) length = speed + unit;
        shift_ = static_cast<std::uint64_t>(speed + unit - length);
        const auto number = [](double value, int exponent) {
            const Digits digits = digits_of(value);
            return digits.significand == 0
                       ? Integer()
                       : Integer(digits.significand,
                                 static_cast<std::uint64_t>(digits.exponent - exponent));
        };
        latest_ = number(std::max(a.time, b.time), unit);
        const Integer since_a = latest_ - number(a.time, unit);
        const Integer since_b = latest_ - number(b.time, unit);
        for (std::size_t k = 0; k < 3; ++k) {
            const Integer of_a = number(a.v[k], speed);
            const Integer of_b = number(b.v[k], speed);
            Integer x = number(a.x[k], length) - number(b.x[k], length);
            x += (of_a * since_a) << shift_;
            x -= (of_b * since_b) << shift_;
            const Integer v = of_a - of_b;
            a_.add_product(v, v);
            b_.add_product(x, v);
            c_.add_product(x, x);
        }
        const Integer growth = number(a.growth, speed) + number(b.growth, speed);
        Integer radius = number(a.radius, length) + number(b.radius, length);
        radius += (growth * latest_) << shift_;
        a_.subtract_product(growth, growth);
        b_.subtract_product(radius, growth);
        c_.subtract_product(radius, radius);
        under_root_ = minor(b_, a_, c_, b_);
        kind_ = kind();
    }

    [[nodiscard]] Kind meets() const { return kind_; }
    /// Whether something is exactly 0 that decides.
    [[nodiscard]] bool is_tied() const { return c_.sign() == 0 || under_root_.sign() == 0; }
    /// The sign of the meeting less the time. Precondition: they meet, later than at once.
    [[nodiscard]] int compare(const Digits& time, int unit) const {
        const Integer since =
            Integer(time.significand, static_cast<std::uint64_t>(time.exponent - unit)) - latest_;
        if (kind_ == Kind::linear) {
            Integer value = -c_;
            value -= ((b_ + b_) * since) << shift_;
            return value.sign() * b_.sign();
        }
        Integer value = -b_;
        value -= (a_ * since) << shift_;
        const int sign =
            kind_ == Kind::top ? value.sign() : sign_with_root(value, Integer(-1), under_root_);
        return sign * a_.sign();
    }

 private:
    [[nodiscard]] Kind kind() const {
        const int a = a_.sign(), b = b_.sign(), c = c_.sign(), root = under_root_.sign();
        if (c <= 0) {
            if (b < 0 || (b == 0 && a < 0)) return Kind::at_once;
            if (a >= 0) return Kind::never;
            // It rises first, and is above 0 at the top or is not.
            return root > 0 ? Kind::root : Kind::top;
        }
        if (a < 0) return Kind::root;
        if (b >= 0) return Kind::never;
        if (a == 0) return Kind::linear;
        return root > 0 ? Kind::root : Kind::never;
    }

    std::uint64_t shift_ = 0;
    Integer latest_;
    Integer a_;
    Integer b_;
    Integer c_;
    Integer under_root_;
    Kind kind_ = Kind::never;
};

/// Halfway from a finite double to the next one above or below.
[[nodiscard]] inline Digits halfway(double number, bool above) {
    const auto bits = std::bit_cast<std::uint64_t>(std::abs(number));
    const auto field = static_cast<int>(bits >> 52);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const auto significand =
        static_cast<std::int64_t>(field == 0 ? fraction : fraction | std::uint64_t{1} << 52);
    const int exponent = (field == 0 ? 1 : field) - 1075;
    const bool outwards = number == 0.0 || above == (number > 0.0);
    const std::int64_t sign = number == 0.0 ? (above ? 1 : -1) : (number > 0.0 ? 1 : -1);
    if (outwards) return {sign * (2 * significand + 1), exponent - 1};
    if (fraction == 0 && field > 1) return {sign * (4 * significand - 1), exponent - 2};
    return {sign * (2 * significand - 1), exponent - 1};
}

/// Whether the double is the nearest one to the meeting, infinity where there is none.
[[nodiscard]] inline bool is_right(const Flight& a, const Flight& b, double said, bool& tied) {
    constexpr double largest = std::numeric_limits<double>::max();
    const bool is_finite = std::abs(said) <= largest;
    if (said != said) return false;
    const Digits above = halfway(is_finite ? said : largest, true);
    const Digits below = halfway(is_finite ? said : largest, false);
    int unit = std::min(above.exponent, below.exponent);
    for (const double time : {a.time, b.time})
        if (const Digits digits = digits_of(time); digits.significand != 0)
            unit = std::min(unit, digits.exponent);
    const Gap gap(a, b, unit);
    tied = gap.is_tied();
    const double latest = std::max(a.time, b.time);
    if (gap.meets() == Kind::never) return said == std::numeric_limits<double>::infinity();
    if (gap.meets() == Kind::at_once) return said == latest;
    if (!is_finite) return said > 0.0 && gap.compare(above, unit) >= 0;
    // Of two that are as near the even one.
    const bool even = (std::bit_cast<std::uint64_t>(said) & 1U) == 0;
    const int to_above = gap.compare(above, unit);
    const int to_below = gap.compare(below, unit);
    return said >= latest && (to_above < 0 || (to_above == 0 && even)) &&
           (to_below > 0 || (to_below == 0 && even));
}

}  // namespace signum::fuzz::meeting_oracle
