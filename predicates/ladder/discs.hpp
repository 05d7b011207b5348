#pragma once
/// The numbers that the Euclidean predicates compute with behind their filters: sites as integers,
/// as many bits wide as they need, as rationals, as dyadic numbers, as sums for ESSA, as intervals
/// and as rounded numbers. Included by sources only, for it pulls in Boost and GMP.
///
/// All predicates are signs of homogeneous polynomials in differences of coordinates and radii, so
/// every site may be moved by the same amounts and multiplied by the same power of two.
///
/// Laws:
///  1. four sizes: differences below 2^30, in the processor's integers as far as they reach
///     (integers and grids, where ties abound); behind double-doubles that carry a bound, which
///     decide what is near to a tie and none, numbers that span at most wide_bits bits (most
///     other doubles), and at most integer_bits, in integers of two fixed sizes; all others in
///     rationals, the multiprecision stage, which alone allocates memory;
///  2. doubles are taken apart by their bits: no rounding, no environment.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include <boost/multiprecision/cpp_int.hpp>

#include "../../core/contract.hpp"
#include "../../core/site.hpp"
#include "../../exact/apart.hpp"
#include "../../exact/fixed_integer.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../exact/sum.hpp"
#include "../../filters/bounded.hpp"
#include "../../filters/interval.hpp"
#include "../formulas/discs.hpp"
#include "doubted.hpp"
#include "exact_number.hpp"

namespace signum::euclidean {

/// Differences below 2^30 have 2x2 minors and powers below 2^61, minors with a power below 2^92,
/// D below 2^124, products of two powers below 2^122; A is below 2^187, the square in H below
/// 2^248, and H of three powers below 2^126.
struct Narrow {
    using Linear = std::int64_t;
    using Quadratic = std::int64_t;
    using Quartic = __int128;
    using Octic = boost::multiprecision::int256_t;
};
/// Numbers that span 120 bits have differences below 2^121, powers below 2^243, products of two
/// powers below 2^486, and the square in H stays below 2^976. Of 400 bits it stays below 2^3216.
using Wide = Uniform<exact::FixedInteger<1024>>;
using Widest = Uniform<exact::FixedInteger<3264>>;

namespace numbers {

inline constexpr int wide_bits = 120;
/// Beyond this span most bits of the integers would be 0.
inline constexpr int integer_bits = 400;
/// Numbers of this span, moved to multiples of 2^-120 below 2^120, have differences below 2^121:
/// the square in H stays below 2^976, and products of eight are multiples of 2^-960, so that sums
/// of them neither over- nor underflow.
inline constexpr int sum_bits = 240;

/// The numbers x, y, r of n sites.
template <std::size_t n>
using Apart = exact::Apart<n, 3>;
template <std::size_t n>
[[nodiscard]] inline Apart<n> apart(const std::array<Site, n>& sites) noexcept {
    std::array<std::array<double, 3>, n> rows;
    for (std::size_t m = 0; m < n; ++m) rows[m] = {sites[m].x, sites[m].y, sites[m].r};
    return Apart<n>(rows);
}

/// Relative to the first site; precondition: span() <= 62, so that no difference overflows.
template <std::size_t n>
class SmallDiscs {
 public:
    explicit SmallDiscs(const Apart<n>& numbers) noexcept {
        std::uint64_t bits = 0;
        for (std::size_t m = 0; m < n; ++m) {
            std::int64_t* const values[] = {&discs_[m].x, &discs_[m].y, &discs_[m].r};
            for (std::size_t column = 0; column < 3; ++column) {
                *values[column] = numbers.template value<std::int64_t>(m, column) -
                                  numbers.template value<std::int64_t>(0, column);
                bits |= static_cast<std::uint64_t>(*values[column]);
            }
        }
        const int zeros = bits == 0 ? 0 : std::countr_zero(bits);
        for (Disc<Narrow>& d : discs_) d = {d.x >> zeros, d.y >> zeros, d.r >> zeros};
    }

    [[nodiscard]] const std::array<Disc<Narrow>, n>& discs() const noexcept { return discs_; }

    /// Whether all differences, not only those to the first site, are below 2^30.
    [[nodiscard]] bool narrow() const noexcept {
        return spread(&Disc<Narrow>::x) && spread(&Disc<Narrow>::y) && spread(&Disc<Narrow>::r);
    }

 private:
    [[nodiscard]] bool spread(std::int64_t Disc<Narrow>::*column) const noexcept {
        std::int64_t least = 0;
        std::int64_t greatest = 0;
        for (const Disc<Narrow>& d : discs_) {
            least = std::min(least, d.*column);
            greatest = std::max(greatest, d.*column);
        }
        constexpr std::int64_t limit = std::int64_t{1} << 30;
        return least > -limit && greatest < limit && greatest - least < limit;
    }

    std::array<Disc<Narrow>, n> discs_;
};

}  // namespace numbers

/// The sites in rationals or, for a judge, in dyadic numbers.
template <Arithmetic arithmetic = Arithmetic::multiprecision, std::size_t n>
[[nodiscard]] auto exact_discs(const std::array<Site, n>& sites) {
    using predicates::exactly;
    std::array<Disc<Uniform<predicates::ExactNumber<arithmetic>>>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {exactly<arithmetic>(sites[m].x), exactly<arithmetic>(sites[m].y),
                     exactly<arithmetic>(sites[m].r)};
    return result;
}

/// The sites in doubles or floats, for the predicates that round.
template <class Number, std::size_t n>
[[nodiscard]] std::array<Disc<Uniform<Number>>, n> rounded_discs(const std::array<Site, n>& sites) {
    std::array<Disc<Uniform<Number>>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {Number(sites[m].x), Number(sites[m].y), Number(sites[m].r)};
    return result;
}

/// The sites in intervals, or in double-doubles that carry a bound.
template <class Number, std::size_t n>
[[nodiscard]] std::array<Disc<Uniform<Doubted<Number>>>, n> doubted_discs(
    const std::array<Site, n>& sites, bool& doubt) {
    std::array<Disc<Uniform<Doubted<Number>>>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {{sites[m].x, doubt}, {sites[m].y, doubt}, {sites[m].r, doubt}};
    return result;
}

// ---- the ladder ---------------------------------------------------------------------------------

using polynomials::Answer;

/// A question's answer with its stage.
[[nodiscard]] inline Decision at(Stage stage, const Answer& answer) noexcept {
    return {answer.sign, stage, answer.tied};
}
[[nodiscard]] inline Decision at(Stage stage, Sign sign) noexcept {
    return {sign, stage};
}

/// The answer in double-doubles that carry a bound; of another stage where they leave a sign open.
template <std::size_t n, class Question>
[[nodiscard]] Decision refine(const std::array<Site, n>& sites, const Question& question) {
    return exact::in_ieee_environment(
        [&](const std::array<Site, n>& given) {
            bool doubt = false;
            const Decision decision =
                at(Stage::refine, question(doubted_discs<filters::Bounded>(given, doubt)));
            return doubt ? Decision{} : decision;
        },
        sites);
}

/// The answer to a question about sites, any of those of formulas/discs.hpp, in the narrowest
/// numbers that hold them; before the longer ones in double-doubles.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_exactly(const std::array<Site, n>& sites, const Question& question) {
    const numbers::Apart<n> parts = numbers::apart(sites);
    if (parts.span() > numbers::integer_bits)
        return at(Stage::multiprecision, question(exact_discs(sites)));
    if (parts.span() <= 62) {
        const numbers::SmallDiscs<n> small(parts);
        if (small.narrow()) return at(Stage::exact, question(small.discs()));
    }
    if (const Decision refined = refine(sites, question); refined.stage == Stage::refine)
        return refined;
    const auto ask = [&]<class D>(std::array<Disc<D>, n> discs) -> Decision {
        using Integer = typename D::Linear;
        for (std::size_t m = 0; m < n; ++m)
            discs[m] = {parts.template value<Integer>(m, 0), parts.template value<Integer>(m, 1),
                        parts.template value<Integer>(m, 2)};
        return at(Stage::exact, question(discs));
    };
    if (parts.span() <= numbers::wide_bits) return ask(std::array<Disc<Wide>, n>());
    return ask(std::array<Disc<Widest>, n>());
}

/// The same by the exact sign of a sum (ESSA), as far as doubles hold all terms.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_by_essa(const std::array<Site, n>& sites, const Question& question) {
    const numbers::Apart<n> parts = numbers::apart(sites);
    if (parts.span() > numbers::sum_bits) return decide_exactly(sites, question);
    std::array<Site, n> centred;
    for (std::size_t m = 0; m < n; ++m)
        centred[m] = {parts.centred(m, 0, numbers::sum_bits),
                      parts.centred(m, 1, numbers::sum_bits),
                      parts.centred(m, 2, numbers::sum_bits)};
    return exact::in_ieee_environment(
        [&](const std::array<Site, n>& given) {
            std::array<Disc<Uniform<exact::Sum>>, n> discs;
            for (std::size_t m = 0; m < n; ++m)
                discs[m] = {exact::Sum(given[m].x), exact::Sum(given[m].y), exact::Sum(given[m].r)};
            return at(Stage::essa, question(discs));
        },
        centred);
}

/// The answer to a question of formulas/discs.hpp in intervals, or by ESSA.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_in_intervals(const std::array<Site, n>& sites,
                                           const Question& question) {
    bool doubt = !filters::environment_is_default();
    const Decision decision =
        at(Stage::filter, question(doubted_discs<filters::Interval>(sites, doubt)));
    return doubt ? decide_by_essa(sites, question) : decision;
}

/// The answer to a question of formulas/discs.hpp behind a filter that takes the sites one by one.
/// In an environment in which the filter declined it is asked again in the default one.
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Arithmetic arithmetic, Filter filter, Question question,
                              const Sites&... sites) noexcept {
    const std::array array{sites...};
    switch (arithmetic) {
        case Arithmetic::judging:
            return at(Stage::multiprecision, question(exact_discs<Arithmetic::judging>(array)));
        case Arithmetic::multiprecision:
            return at(Stage::multiprecision, question(exact_discs(array)));
        case Arithmetic::naive:
            return at(Stage::filter, question(rounded_discs<double>(array)));
        case Arithmetic::single:
            return at(Stage::filter, question(rounded_discs<float>(array)));
        case Arithmetic::interval:
            return decide_in_intervals(array, question);
        case Arithmetic::exact:
            if (!filters::environment_is_default()) {
                const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
                if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
            }
            break;
        case Arithmetic::sum:
            return decide_by_essa(array, question);
    }
    return decide_exactly(array, question);
}

}  // namespace signum::euclidean
