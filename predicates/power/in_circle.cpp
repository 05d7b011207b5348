#include "in_circle.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "../../exact/floating_environment.hpp"
#include "../../filters/wide.hpp"
#include "compared.hpp"
#include "exact_rows.hpp"
#include "multiprecision.hpp"

namespace signum::power {
namespace {

using filters::DoubleDouble;
using filters::magnitude;
using filters::Verdict;

using Integer128 = __int128;

/// A sum of products of two integers below 2^124 in magnitude: two words of 128 bits.
class Integer256 {
 public:
    Integer256(Integer128 a, Integer128 b) noexcept {
        const auto magnitude_of = [](Integer128 x) {
            return x < 0 ? -static_cast<Word>(x) : static_cast<Word>(x);
        };
        const auto half = [](Word x) { return Word{static_cast<std::uint64_t>(x)}; };
        const Word p = magnitude_of(a);
        const Word q = magnitude_of(b);
        const Word middle = half(p) * (q >> 64) + (p >> 64) * half(q);
        low_ = half(p) * half(q);
        high_ = static_cast<Integer128>((p >> 64) * (q >> 64) + (middle >> 64));
        *this += {middle << 64, 0};
        if ((a < 0) != (b < 0)) {
            low_ = -low_;
            high_ = -high_ - (low_ != 0 ? 1 : 0);
        }
    }
    friend Integer256 operator+(Integer256 a, const Integer256& b) noexcept {
        a += {b.low_, b.high_};
        return a;
    }
    [[nodiscard]] Sign sign() const noexcept {
        return high_ < 0 ? -1 : static_cast<Sign>(high_ > 0 || low_ > 0);
    }

 private:
    using Word = unsigned __int128;
    struct Words {
        Word low;
        Integer128 high;
    };
    void operator+=(const Words& b) noexcept {
        low_ += b.low;
        high_ += b.high + (low_ < b.low ? 1 : 0);
    }

    Word low_;
    Integer128 high_;
};

/// The determinant in integers, where the differences to q are exact and, as multiples of one power
/// of two g, below 2^60: on integers and on grids, where exact ties abound, and for most sites that
/// lie close together. Squares are then below 2^120, weights below 2^122, heights below 2^123,
/// minors below 2^121 and the sum of their three products below 2^246.
class IntegerRows {
 public:
    template <PowerSite S>
    IntegerRows(const S& i, const S& j, const S& k, const S& q) noexcept {
        const S* sites[3] = {&i, &j, &k};
        double largest = largest_radius(i, j, k, q);
        TwoTerms x[3];
        TwoTerms y[3];
        for (int m = 0; m < 3; ++m) {
            x[m] = two_difference(sites[m]->x, q.x);
            y[m] = two_difference(sites[m]->y, q.y);
            exact_ &= x[m].low == 0.0 && y[m].low == 0.0;
            largest = std::max({largest, magnitude(x[m].high), magnitude(y[m].high)});
        }
        if (!exact_) return;
        // 1/g, which brings the largest below 2^60. Inside the window it is below 2^320.
        constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;
        constexpr std::uint64_t sum_of_exponents = std::uint64_t{2 * 1023 + 59} << 52;
        const double scale = std::bit_cast<double>(
            sum_of_exponents - (std::bit_cast<std::uint64_t>(largest) & exponent_bits));
        for (int m = 0; m < 3; ++m)
            rows_[m] = {integer(x[m].high * scale), integer(y[m].high * scale),
                        weight(*sites[m], q, scale)};
    }

    /// The exact sign, or uncertain where the sites are not such integers.
    [[nodiscard]] Verdict sign() const noexcept {
        if (!exact_) return Verdict::uncertain();
        const auto& [a, b, c] = rows_;
        // Small numbers, those of most grids, have many factors of two in common: without them
        // heights stay below 2^63, minors below 2^61, and the sum below 2^126.
        constexpr int narrow = 30;
        std::int64_t bits = 0;
        Integer128 weight_bits = 0;
        for (const IntegerRow& row : rows_) {
            bits |= row.x | row.y;
            weight_bits |= row.weight;
        }
        constexpr std::int64_t low = (std::int64_t{1} << narrow) - 1;
        constexpr Integer128 weight_low = (Integer128{1} << 2 * narrow) - 1;
        if ((bits & low) == 0 && (weight_bits & weight_low) == 0) {
            const Integer128 determinant = product<Integer128>(a, b, c, narrow) +
                                           product<Integer128>(b, c, a, narrow) +
                                           product<Integer128>(c, a, b, narrow);
            return Verdict::certain((determinant > 0) - (determinant < 0));
        }
        const Integer256 determinant = product<Integer256>(a, b, c, 0) +
                                       product<Integer256>(b, c, a, 0) +
                                       product<Integer256>(c, a, b, 0);
        return Verdict::certain(determinant.sign());
    }

 private:
    struct IntegerRow {
        std::int64_t x;
        std::int64_t y;
        Integer128 weight;
    };

    /// The height of row a times the minor of rows b and c, all in multiples of 2^shift.
    template <class Product>
    [[nodiscard]] static Product product(const IntegerRow& a, const IntegerRow& b,
                                         const IntegerRow& c, int shift) noexcept {
        const Integer128 height =
            (Integer128{a.x} * a.x + Integer128{a.y} * a.y - a.weight) >> 2 * shift;
        const Integer128 minor = (Integer128{b.x} * c.y - Integer128{c.x} * b.y) >> 2 * shift;
        if constexpr (std::is_same_v<Product, Integer128>)
            return height * minor;
        else
            return {height, minor};
    }

    [[nodiscard]] std::int64_t integer(double value) noexcept {
        if (!(magnitude(value) < 0x1p60)) {
            exact_ = false;
            return 0;
        }
        const auto result = static_cast<std::int64_t>(value);
        exact_ &= static_cast<double>(result) == value;
        return result;
    }

    [[nodiscard]] static double largest_radius(const Point&, const Point&, const Point&,
                                               const Point&) noexcept {
        return 0.0;
    }
    [[nodiscard]] static double largest_radius(const Site&, const Site&, const Site&,
                                               const Site&) noexcept {
        return 0.0;
    }
    [[nodiscard]] static double largest_radius(const signum::Site& i, const signum::Site& j,
                                               const signum::Site& k,
                                               const signum::Site& q) noexcept {
        return std::max({magnitude(i.r), magnitude(j.r), magnitude(k.r), magnitude(q.r)});
    }

    [[nodiscard]] Integer128 weight(const Point&, const Point&, double) noexcept { return 0; }
    [[nodiscard]] Integer128 weight(const Site& m, const Site& q, double scale) noexcept {
        const TwoTerms difference = two_difference(m.w, q.w);
        const double value = difference.high * scale * scale;
        if (difference.low != 0.0 || !(magnitude(value) < 0x1p122)) {
            exact_ = false;
            return 0;
        }
        const auto result = static_cast<Integer128>(value);
        exact_ &= static_cast<double>(result) == value;
        return result;
    }
    [[nodiscard]] Integer128 weight(const signum::Site& m, const signum::Site& q,
                                    double scale) noexcept {
        const Integer128 m_radius = integer(m.r * scale);
        const Integer128 q_radius = integer(q.r * scale);
        return (m_radius - q_radius) * (m_radius + q_radius);
    }

    bool exact_ = true;
    IntegerRow rows_[3];
};

[[nodiscard]] Row<double> high(const Row<DoubleDouble>& row) noexcept {
    return {row.x.high, row.y.high, row.weight.high};
}

/// The filter again, with the magnitude itself for a bound.
[[nodiscard]] Verdict filter(const Row<double>& a, const Row<double>& b,
                             const Row<double>& c) noexcept {
    const auto [determinant, bound] = compared_in_circle_finely(a, b, c);
    if (magnitude(determinant) > bound)
        return Verdict::certain(filters::sign_of_nonzero(determinant));
    return Verdict::uncertain();
}

/// The error of the determinant in double-doubles as a multiple of its magnitude: the lemma of
/// rounding_count.hpp gives (1+d)^8 - 1; twice that covers the magnitude, rounded in doubles.
constexpr double refined_error = 16 * filters::double_double_epsilon;
constexpr Row<filters::RoundingCount> refined_row{
    filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount::of(1)};
static_assert(in_circle_determinant(refined_row, refined_row, refined_row).roundings == 8);
static_assert(refined_error >= 2 * 8 * filters::double_double_epsilon);

[[nodiscard]] Verdict refine(const Row<DoubleDouble>& a, const Row<DoubleDouble>& b,
                             const Row<DoubleDouble>& c) noexcept {
    const double determinant = in_circle_determinant(a, b, c).high;
    const double bound = refined_error * determinant_magnitude(high(a), high(b), high(c));
    if (magnitude(determinant) > bound)
        return Verdict::certain(filters::sign_of_nonzero(determinant));
    return Verdict::uncertain();
}

template <PowerSite S>
[[nodiscard]] Sign expand(const S& i, const S& j, const S& k, const S& q) noexcept {
    const cold::ExpansionRow<S> a(i, q);
    const cold::ExpansionRow<S> b(j, q);
    const cold::ExpansionRow<S> c(k, q);
    return (a.height * (b.x * c.y - c.x * b.y) + b.height * (c.x * a.y - a.x * c.y) +
            c.height * (a.x * b.y - b.x * a.y))
        .sign();
}

/// Where expansions might over- or underflow. The origin may be any of the four: the determinant is
/// that of four rows (1, x, y, height), of which exchanging two turns the sign.
template <PowerSite S>
[[nodiscard]] Decision decide_beyond_window(const S& i, const S& j, const S& k,
                                            const S& q) noexcept {
    std::array sites = {&i, &j, &k, &q};
    const Sign turn = filters::base_on_least(sites);
    const S& origin = *sites[3];
    const Verdict verdict = in_circle_determinant(row<filters::Wide>(*sites[0], origin),
                                                  row<filters::Wide>(*sites[1], origin),
                                                  row<filters::Wide>(*sites[2], origin))
                                .sign();
    if (verdict.is_certain()) return {turn * verdict.sign(), Stage::filter};
    return {multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
}

template <PowerSite S>
[[nodiscard]] Decision decide(const S& i, const S& j, const S& k, const S& q) noexcept {
    if (!cold::in_window(i, j, k, q)) return decide_beyond_window(i, j, k, q);
    if (const Verdict verdict = filter(row(i, q), row(j, q), row(k, q)); verdict.is_certain())
        return {verdict.sign(), Stage::filter};
    if (const Verdict verdict = IntegerRows(i, j, k, q).sign(); verdict.is_certain())
        return {verdict.sign(), Stage::exact};
    const auto a = cold::double_double_row(i, q);
    const auto b = cold::double_double_row(j, q);
    const auto c = cold::double_double_row(k, q);
    if (const Verdict verdict = refine(a, b, c); verdict.is_certain())
        return {verdict.sign(), Stage::refine};
    return {expand(i, j, k, q), Stage::exact};
}

}  // namespace

Decision in_circle_cold(const Point& i, const Point& j, const Point& k, const Point& q) noexcept {
    return exact::in_ieee_environment(decide<Point>, i, j, k, q);
}
Decision in_circle_cold(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    return exact::in_ieee_environment(decide<Site>, i, j, k, q);
}
Decision in_circle_cold(const signum::Site& i, const signum::Site& j, const signum::Site& k,
                        const signum::Site& q) noexcept {
    return exact::in_ieee_environment(decide<signum::Site>, i, j, k, q);
}

}  // namespace signum::power
