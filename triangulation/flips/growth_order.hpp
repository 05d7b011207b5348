#pragma once
/// When an edge stops being regular while all weights grow together, and which of two edges does so
/// first: exactly. For sources only.
///
/// The weights are w(t) = t w, from t = 0 to 1. in_circle of four sites is linear in t: it is D0 <
/// 0 at first, for a face and the site across one of its edges, and D1 at the end. Where D1 > 0 the
/// edge stops being regular in between, at t = -D0 / (D1 - D0), the sooner the larger the quotient
/// D1 / -D0 is: the haste by which times are compared. Near t = 0 and near t = 1 alike a few of its
/// bits tell two times apart.
///
/// Ties. Every weight is thought of as reduced by its own infinitesimal all the time, as the tie
/// rule wants it at the end. Both D0 and D1 gain the same sum P of infinitesimals, and of events at
/// the same time those come first for which the terms of first order say so. Before time 0 the
/// cocircular sites are brought in order: their polygons are convex, where every flip can be made.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../exact/cut_dyadic.hpp"
#include "../../exact/dyadic.hpp"
#include "../../filters/bounded.hpp"
#include "../../filters/wide.hpp"

namespace signum::triangulation {

/// The four sites of an edge: a counterclockwise face i, j, k and q across from it; or, where a
/// hull edge i - k passes over j on the same line, those three and j again.
struct Quad {
    std::array<Index, 4> sites;
    bool on_line;
};

/// What is known of D1 / -D0 without exact arithmetic: it is infinite before all times.
struct Haste {
    long double least;
    long double most;
};

/// An edge that stops being regular.
struct Failure {
    Haste haste;
    Quad quad;
};

template <class Kernel>
class GrowthOrder {
 public:
    static constexpr Haste before_all = {std::numeric_limits<long double>::infinity(),
                                         std::numeric_limits<long double>::infinity()};

    /// The kernel is that of the full weights; it is not copied.
    explicit GrowthOrder(const Kernel& kernel) noexcept : kernel_(kernel) {}

    /// For an edge that is not regular in the end. Where it is not regular at the start, either, it
    /// fails before all times. What almost every edge asks is inlined, the rest is not.
    [[nodiscard, gnu::flatten]] Failure failure(const Quad& quad) const {
        // Near ties the 100 bits of double-doubles, beyond their range the exponents of long
        // doubles.
        if (const auto haste = haste_of(bounds(motion_of<filters::Bounded>(quad))))
            return {*haste, quad};
        return failure_beyond_doubles(quad);
    }

    /// Below 0 where the first fails first, 0 where that makes no difference.
    [[nodiscard]] int operator()(const Failure& a, const Failure& b) const {
        if (a.haste.least > b.haste.most) return -1;
        if (b.haste.least > a.haste.most) return 1;
        if (a.haste.least == before_all.least && b.haste.least == before_all.least) return 0;
        return compare(a.quad, b.quad);
    }

 private:
    [[nodiscard, gnu::noinline]] Failure failure_beyond_doubles(const Quad& quad) const {
        if (const auto haste = haste_of(bounds(motion_of<filters::Wide>(quad))))
            return {*haste, quad};
        const auto m = motion_of<Exact>(quad);
        if (m.start > 0 || (m.start == 0 && first_sign(quad, m.coefficients) > 0))
            return {before_all, quad};
        constexpr long double largest = std::numeric_limits<long double>::max();
        if (m.start == 0) return {{largest, largest}, quad};
        if (m.end == 0) return {{0, 0}, quad};
        return {haste_of(bounds(m)).value_or(Haste{0, largest}), quad};
    }

    using Exact = exact::Dyadic;
    /// Between raw doubles times are often the same in their first hundreds of bits; of random bit
    /// patterns one comparison in a hundred needs more than these.
    using Cut = exact::CutDyadic<1152>;

    /// D0, D1, and the coefficients of the sites' infinitesimals.
    template <class Number>
    struct Motion {
        Number start;
        Number end;
        std::array<Number, 4> coefficients;
    };

    /// D0 and D1, as far as they are known.
    struct Bounds {
        filters::Wide start;
        filters::Wide end;
    };
    [[nodiscard]] static Bounds bounds(const Motion<filters::Bounded>& m) noexcept {
        // Of a double-double the high part is off by 2^-53 of itself.
        const auto high = [](const filters::Bounded& number) -> filters::Wide {
            return {number.value.high,
                    filters::Wide::slack * number.error + filters::Wide::u * number.size()};
        };
        return {high(m.start), high(m.end)};
    }
    [[nodiscard]] static Bounds bounds(const Motion<filters::Wide>& m) noexcept {
        return {m.start, m.end};
    }
    [[nodiscard]] static Bounds bounds(const Motion<Exact>& m) {
        // The first 64 bits of a number, and what lies behind them.
        const auto leading = [](const Exact& number) -> filters::Wide {
            if (number.sign() == 0) return filters::Wide(0.0);
            exact::Integer significand = abs(number.significand());
            const auto rest =
                std::max<std::int64_t>(static_cast<std::int64_t>(msb(significand)) - 63, 0);
            significand >>= rest;
            const long double size =
                std::ldexp(static_cast<long double>(significand.convert_to<std::uint64_t>()),
                           static_cast<int>(number.exponent() + rest));
            return {static_cast<long double>(number.sign()) * size,
                    filters::Wide::slack * filters::Wide::u * size + filters::Wide::underflow};
        };
        return {leading(m.start), leading(m.end)};
    }

    /// Nothing where the signs of D0 and D1 are uncertain. Sums, quotient and factor round by 2^-52
    /// each, in any mode.
    [[nodiscard]] static std::optional<Haste> haste_of(const Bounds& d) noexcept {
        if (d.start.is_positive()) return before_all;
        const filters::Wide rest = -d.start;
        if (!rest.is_positive() || !d.end.is_positive()) return std::nullopt;
        constexpr long double rounding = 0x1p-48L;
        constexpr long double largest = std::numeric_limits<long double>::max();
        constexpr long double tiny = filters::Wide::underflow;
        const Haste haste = {
            (d.end.value - d.end.error) / (rest.value + rest.error) * (1 - rounding) - tiny,
            (d.end.value + d.end.error) / (rest.value - rest.error) * (1 + rounding) + tiny};
        if (!(haste.most <= largest)) return Haste{0, largest};
        return haste;
    }

    template <class Number>
    [[nodiscard]] static Number difference(double a, double b) {
        if constexpr (std::is_same_v<Number, filters::Bounded>)
            return filters::Bounded::exactly(filters::exact_difference(a, b));
        else
            return Number(a) - Number(b);
    }
    /// The difference of two weights.
    template <class Number>
    [[nodiscard]] Number weights(Index m, Index n) const {
        const auto& a = kernel_.site(m);
        const auto& b = kernel_.site(n);
        if constexpr (requires { a.w; })
            return difference<Number>(a.w, b.w);
        else
            return difference<Number>(a.r, b.r) * difference<Number>(a.r, -b.r);
    }

    template <class Number>
    [[nodiscard]] Motion<Number> motion_of(const Quad& quad) const {
        struct Row {
            Number x, y, start, end;  // start and end: the height, relative to the last site's
        };
        const Index q = quad.sites[3];
        const auto row = [&](Index m) -> Row {
            const Point p = kernel_.centre(m);
            const Point o = kernel_.centre(q);
            const Number x = difference<Number>(p.x, o.x);
            const Number y = difference<Number>(p.y, o.y);
            const Number start = x * x + y * y;
            return {x, y, start, start - weights<Number>(m, q)};
        };
        const Row i = row(quad.sites[0]);
        const Row k = row(quad.sites[2]);
        if (quad.on_line) {
            // The height of the chord from i to k above q, negative while q is below.
            const Point first = kernel_.centre(quad.sites[0]);
            const Point last = kernel_.centre(quad.sites[2]);
            const bool along_x = first.x != last.x;
            const bool rises = along_x ? first.x < last.x : first.y < last.y;
            const Number& at_i = along_x ? i.x : i.y;
            const Number& at_k = along_x ? k.x : k.y;
            const Number to_k = rises ? at_k : Number(-at_k);
            const Number to_i = rises ? Number(-at_i) : at_i;
            return {-(to_k * i.start + to_i * k.start),
                    -(to_k * i.end + to_i * k.end),
                    {-to_k, to_k - to_k, -to_i, to_k + to_i}};
        }
        const Row j = row(quad.sites[1]);
        const Number a = j.x * k.y - j.y * k.x;
        const Number b = k.x * i.y - k.y * i.x;
        const Number c = i.x * j.y - i.y * j.x;
        return {i.start * a + j.start * b + k.start * c,
                i.end * a + j.end * b + k.end * c,
                {a, b, c, -(a + b + c)}};
    }

    /// The sign of a sum of infinitesimals.
    [[nodiscard]] int first_sign(const Quad& quad, const std::array<Exact, 4>& coefficients) const {
        std::array<std::size_t, 4> order = {0, 1, 2, 3};
        std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
            return quad.sites[a] != quad.sites[b] && kernel_.precedes(quad.sites[b], quad.sites[a]);
        });
        for (const std::size_t m : order)
            if (coefficients[m] != 0) return coefficients[m] > 0 ? 1 : -1;
        return 0;
    }

    /// The same where the hastes are too near: below 0 where the first fails first.
    [[nodiscard]] int compare(const Quad& one, const Quad& other) const {
        // The three edges of a site that sinks have the same sites around them.
        if (std::is_permutation(one.sites.begin(), one.sites.end(), other.sites.begin())) return 0;
        if (!are_short(one, other))
            if (const auto order = compare_in<Cut>(one, other)) return *order;
        return *compare_in<Exact>(one, other);
    }

    /// Whether all numbers are integers of some 20 bits times one power of two, as of grids, where
    /// times are equal: what is made of them is then short, and exact numbers are the cheapest.
    [[nodiscard]] bool are_short(const Quad& one, const Quad& other) const {
        int least = std::numeric_limits<int>::max();
        int end = std::numeric_limits<int>::min();
        const auto look_at = [&](double value) {
            const exact::Parts number = exact::parts(value);
            if (number.significand == 0) return;
            least = std::min(least, number.exponent);
            end = std::max(end,
                           number.exponent + static_cast<int>(std::bit_width(number.significand)));
        };
        for (const Quad* quad : {&one, &other})
            for (const Index i : quad->sites) {
                const auto& site = kernel_.site(i);
                look_at(site.x);
                look_at(site.y);
                if constexpr (requires { site.w; })
                    look_at(site.w);
                else
                    look_at(site.r);
            }
        return end - least <= 20;
    }

    /// Nothing where what was cut off from the numbers might matter.
    template <class Number>
    [[nodiscard]] std::optional<int> compare_in(const Quad& one, const Quad& other) const {
        const Motion<Number> a = motion_of<Number>(one);
        const Motion<Number> b = motion_of<Number>(other);
        // The earlier one has the larger quotient of end and -start.
        const Number difference = b.end * a.start - a.end * b.start;
        if (!difference.is_certain()) return std::nullopt;
        if (difference != 0) return difference > 0 ? -1 : 1;
        // P_a (b.end - b.start) - P_b (a.end - a.start), the last site's infinitesimal first.
        const Number of_a = b.end - b.start;
        const Number of_b = a.end - a.start;
        std::vector<Index> sites(one.sites.begin(), one.sites.end());
        sites.insert(sites.end(), other.sites.begin(), other.sites.end());
        std::ranges::sort(sites);
        sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
        std::ranges::sort(sites,
                          [&](Index m, Index n) { return m != n && kernel_.precedes(n, m); });
        const auto coefficient = [](const Quad& quad, const Motion<Number>& motion, Index site) {
            Number sum;
            for (std::size_t k = 0; k < 4; ++k)
                if (quad.sites[k] == site) sum = sum + motion.coefficients[k];
            return sum;
        };
        for (const Index site : sites) {
            const Number sum =
                coefficient(one, a, site) * of_a - coefficient(other, b, site) * of_b;
            if (!sum.is_certain()) return std::nullopt;
            if (sum != 0) return sum > 0 ? -1 : 1;
        }
        return 0;
    }

    const Kernel& kernel_;
};

}  // namespace signum::triangulation
