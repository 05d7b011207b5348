#pragma once
/// The numbers that the predicates of balls compute with behind their filters. For sources only,
/// for Boost and GMP come with it.
///
/// All predicates are signs of homogeneous polynomials in differences, so all balls may be moved by
/// the same amounts and multiplied by the same power of two. Laws:
///  1. four sizes: differences to the first ball below 2^24, in the processor's integers as far as
///     they reach (integers and grids, where ties abound); numbers that span at most wide_bits
///     bits (most other doubles), and at most integer_bits, in integers of two fixed sizes; all
///     others in rationals, the multiprecision stage, which alone allocates memory;
///  2. before the last two, long doubles that carry a bound, for what spans so many bits is rarely
///     tied;
///  3. doubles are taken apart by their bits: no rounding, no environment.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include <boost/multiprecision/cpp_int.hpp>

#include "../../core/site.hpp"
#include "../../exact/apart.hpp"
#include "../../exact/fixed_integer.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/wide.hpp"
#include "../formulas/balls.hpp"
#include "doubted.hpp"

namespace signum::euclidean::balls {

/// A type for polynomials of d+3 factors at most, and one for products of two of these.
template <class N, class P = N>
struct Numbers {
    using Number = N;
    using Product = P;
};

/// Differences to the first ball are below 2^b, b = 24, and those between others below twice that.
/// |p| is at most 3·2^2b, or 3·2^(2b+2) between others, where the product of two is below 2^(4b+8);
/// minors are the sums of up to 24 terms: with p at most 72·2^5b, which is below 2^127. Products of
/// these add up to at most 4·72²·2^10b, below 2^255.
using Narrow = Numbers<__int128, boost::multiprecision::int256_t>;
/// Numbers that span 99 bits have differences below 2^100: by the same count the largest sum is
/// below 2^1015. Of 400 bits it is below 2^4025.
using Wide = Numbers<exact::FixedInteger<1024>>;
using Widest = Numbers<exact::FixedInteger<4032>>;

inline constexpr int narrow_bits = 24;
inline constexpr int wide_bits = 99;
inline constexpr int integer_bits = 400;

/// Moves the first ball to the origin and divides by as large a power of two as all numbers allow;
/// whether all are below 2^narrow_bits then. Precondition: all are below 2^62.
template <std::size_t d, std::size_t n>
[[nodiscard]] bool narrowed(std::array<Ball<d, __int128>, n>& balls) noexcept {
    const Ball<d, __int128> first = balls[0];
    std::uint64_t bits = 0;
    for (auto& ball : balls)
        for (std::size_t k = 0; k <= d; ++k) {
            ball[k] -= first[k];
            bits |= static_cast<std::uint64_t>(ball[k] < 0 ? -ball[k] : ball[k]);
        }
    const int zeros = bits == 0 ? 0 : std::countr_zero(bits);
    for (auto& ball : balls)
        for (auto& number : ball) number >>= zeros;
    return static_cast<int>(std::bit_width(bits)) - zeros <= narrow_bits;
}

/// Each number by the function.
template <std::size_t d, std::size_t n, class Make>
[[nodiscard]] auto made(const std::array<Ball<d, double>, n>& balls, const Make& make) {
    std::array<Ball<d, decltype(make(0.0))>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        for (std::size_t k = 0; k <= d; ++k) result[m][k] = make(balls[m][k]);
    return result;
}

/// The same balls, that one first whose coordinates are least: differences to a far ball lose what
/// tells the others apart. Two pairs are exchanged: that is an even permutation, which changes no
/// orientation.
template <std::size_t d, std::size_t n>
[[nodiscard]] std::array<Ball<d, double>, n> based_on_least(std::array<Ball<d, double>, n> balls) {
    const auto reach = [&](std::size_t m) {
        double largest = 0.0;
        for (const double number : balls[m])
            largest = std::max(largest, filters::magnitude(number));
        return largest;
    };
    std::size_t least = 0;
    for (std::size_t m = 1; m <= d; ++m)
        if (reach(m) < reach(least)) least = m;
    if (least == 0) return balls;
    const std::size_t third = least == 1 ? 2 : 1;
    std::swap(balls[0], balls[least]);
    std::swap(balls[least], balls[third]);
    return balls;
}

// ---- the ladder ---------------------------------------------------------------------------------

[[nodiscard]] inline Ball<2, double> ball(const Site& s) noexcept {
    return {s.x, s.y, s.r};
}
[[nodiscard]] inline Ball<3, double> ball(const Site3& s) noexcept {
    return {s.x, s.y, s.z, s.r};
}
template <class... S>
[[nodiscard]] auto balls_of(const S&... sites) noexcept {
    return std::array{ball(sites)...};
}

/// A question of formulas/balls.hpp in numbers of one kind.
struct Hides {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, 2>& b) {
        return hides<d>(row<d, typename Numbers::Number>(b[1], b[0]));
    }
};
struct Exists {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, d + 1>& b) {
        return exists<d, typename Numbers::Product>(b);
    }
};
struct InSphere {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, d + 2>& b) {
        return in_sphere<d, typename Numbers::Product>(b);
    }
};

/// In rationals.
template <class Question, std::size_t d, std::size_t n>
[[nodiscard]] Sign ask_exactly(const std::array<Ball<d, double>, n>& balls) noexcept {
    return Question::template ask<d, Numbers<exact::Rational>>(
        made<d>(balls, [](double number) { return exact::to_rational(number); }));
}

/// In long doubles that carry a bound; in the default environment.
template <class Question, std::size_t d, std::size_t n>
[[nodiscard]] filters::Verdict ask_bounded(const std::array<Ball<d, double>, n>& balls) noexcept {
    bool doubt = false;
    const Sign sign = Question::template ask<d, Numbers<Doubted<filters::Wide>>>(
        made<d>(n > 2 ? based_on_least<d>(balls) : balls,
                [&](double number) { return Doubted<filters::Wide>(number, doubt); }));
    return doubt ? filters::Verdict::uncertain() : filters::Verdict::certain(sign);
}

/// In the narrowest numbers that hold the balls.
template <class Question, std::size_t d, std::size_t n>
[[nodiscard]] Decision decide(const std::array<Ball<d, double>, n>& balls) noexcept {
    const exact::Apart<n, d + 1> apart(balls);
    if (apart.span() <= 62) {
        auto small = apart.template values<__int128>();
        if (narrowed<d>(small)) return {Question::template ask<d, Narrow>(small), Stage::exact};
    }
    if (apart.span() <= wide_bits)
        return {Question::template ask<d, Wide>(apart.template values<Wide::Number>()),
                Stage::exact};
    const filters::Verdict verdict = exact::in_ieee_environment(ask_bounded<Question, d, n>, balls);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    if (apart.span() <= integer_bits)
        return {Question::template ask<d, Widest>(apart.template values<Widest::Number>()),
                Stage::exact};
    return {ask_exactly<Question, d>(balls), Stage::multiprecision};
}

/// Behind a filter: in an environment in which it declined it is asked again in the default one.
template <class Question, std::size_t d, class Filter, class... S>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_cold(Filter filter,
                                                             const S&... sites) noexcept {
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide<Question, d>(balls_of(sites...));
}

template <class Question, std::size_t d, class Filter, class... S>
[[nodiscard, gnu::always_inline]] inline Decision filtered(Filter filter,
                                                           const S&... sites) noexcept {
    const filters::Verdict verdict = filter(sites...);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return decide_cold<Question, d>(filter, sites...);
}

}  // namespace signum::euclidean::balls
