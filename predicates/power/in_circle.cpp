#include <signum/predicates/power/in_circle.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

#include <signum/exact/floating_environment.hpp>
#include <signum/predicates/power/cold_rows.hpp>
#include <signum/predicates/power/multiprecision.hpp>

namespace signum::power {
namespace {

using filters::DoubleDouble;
using filters::magnitude;
using filters::Verdict;

/// Certifies that a plain evaluation commits no rounding at all, as on integers and grids, where exact
/// ties abound. With all rows integer multiples of a unit g below 2^12 g (weights: of g², below
/// 2^24 g²), heights are below 2^26 g², minors below 2^25 g², the determinant below 2^53 g^4.
class PlainEvaluation {
 public:
    explicit PlainEvaluation(double largest) noexcept
        // The power of two 11 binades below the largest operand, so that this is below 2^12 units.
        : unit_(std::bit_cast<double>((std::bit_cast<std::uint64_t>(largest) & exponent_bits) -
                                      (std::uint64_t{11} << 52))) {}

    [[nodiscard]] bool holds(const DoubleDouble& x) const noexcept {
        return x.low == 0.0 && is_multiple(x.high, unit_);
    }
    [[nodiscard]] bool holds_weight(const DoubleDouble& w) const noexcept {
        const double square = unit_ * unit_;
        return w.low == 0.0 && magnitude(w.high) < 0x1p24 * square && is_multiple(w.high, square);
    }

 private:
    static constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;

    /// For |value| < 2^51 unit: adding 1.5·2^52 units rounds away what is below one unit.
    [[nodiscard]] static bool is_multiple(double value, double unit) noexcept {
        const double shift = 0x1.8p52 * unit;
        return (value + shift) - shift == value;
    }

    double unit_;
};

[[nodiscard]] Row<double> high(const Row<DoubleDouble>& row) noexcept {
    return {row.x.high, row.y.high, row.weight.high};
}

[[nodiscard]] Verdict plain(const Row<DoubleDouble>& a, const Row<DoubleDouble>& b,
                            const Row<DoubleDouble>& c) noexcept {
    const double largest =
        std::max({magnitude(a.x.high), magnitude(a.y.high), magnitude(b.x.high),
                  magnitude(b.y.high), magnitude(c.x.high), magnitude(c.y.high)});
    const PlainEvaluation evaluation(largest);
    for (const auto* row : {&a, &b, &c})
        if (!evaluation.holds(row->x) || !evaluation.holds(row->y) ||
            !evaluation.holds_weight(row->weight))
            return Verdict::uncertain();
    return Verdict::certain(sign_of(in_circle_determinant(high(a), high(b), high(c))));
}

/// The determinant with every operand replaced by its absolute value, every difference by a sum.
[[nodiscard]] double determinant_magnitude(const Row<double>& a, const Row<double>& b,
                                           const Row<double>& c) noexcept {
    const auto absolute = [](const Row<double>& row) {
        return Row<double>{magnitude(row.x), magnitude(row.y), magnitude(row.weight)};
    };
    const Row<double> i = absolute(a);
    const Row<double> j = absolute(b);
    const Row<double> k = absolute(c);
    return (i.x * i.x + i.y * i.y + i.weight) * (j.x * k.y + k.x * j.y) +
           (j.x * j.x + j.y * j.y + j.weight) * (k.x * i.y + i.x * k.y) +
           (k.x * k.x + k.y * k.y + k.weight) * (i.x * j.y + j.x * i.y);
}

/// The filter again, with the magnitude itself for a bound. Inside the window nothing under- or
/// overflows.
[[nodiscard]] Verdict filter(const Row<double>& a, const Row<double>& b,
                             const Row<double>& c) noexcept {
    const double determinant = in_circle_determinant(a, b, c);
    if (magnitude(determinant) > in_circle_error * determinant_magnitude(a, b, c))
        return Verdict::certain(filters::sign_of_nonzero(determinant));
    return Verdict::uncertain();
}

/// The error of the determinant in double-doubles as a multiple of its magnitude: the lemma of
/// rounding_count.hpp gives (1+d)^8 - 1; twice that covers the magnitude, rounded in doubles.
constexpr double refined_error = 16 * filters::double_double_epsilon;
constexpr Row<filters::RoundingCount> refined_row{{0}, {0}, {1}};
static_assert(in_circle_determinant(refined_row, refined_row, refined_row).roundings == 8);

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

template <PowerSite S>
[[nodiscard]] Decision decide(const S& i, const S& j, const S& k, const S& q) noexcept {
    if (!cold::in_window(i, j, k, q))
        return {multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
    if (const Verdict verdict = filter(row(i, q), row(j, q), row(k, q)); verdict.is_certain())
        return {verdict.sign(), Stage::filter};
    const auto a = cold::double_double_row(i, q);
    const auto b = cold::double_double_row(j, q);
    const auto c = cold::double_double_row(k, q);
    if (const Verdict verdict = plain(a, b, c); verdict.is_certain())
        return {verdict.sign(), Stage::refine};
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
