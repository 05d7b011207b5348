#include "discs.hpp"

#include "../../exact/floating_environment.hpp"
#include "../../exact/sign_of_sum.hpp"
#include "../essa.hpp"
#include "../multiprecision.hpp"
#include "exact_discs.hpp"
#include "polynomials.hpp"

namespace signum::euclidean {
namespace {

/// The answer to a question of polynomials.hpp in intervals, or by ESSA.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_in_intervals(const std::array<Site, n>& sites,
                                           const Question& question) {
    bool doubt = !filters::environment_is_default();
    const Decision decision = at(Stage::filter, question(enclosed_discs(sites, doubt)));
    return doubt ? decide_by_essa(sites, question) : decision;
}

/// The answer to a question of polynomials.hpp behind a filter that takes the sites one by one. In
/// an environment in which the filter declined it is asked again in the default one.
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Arithmetic arithmetic, Filter filter, Question question,
                              const Sites&... sites) noexcept {
    const std::array array{sites...};
    switch (arithmetic) {
        case Arithmetic::multiprecision:
            return at(Stage::multiprecision, question(rational_discs(array)));
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

/// The sign of a number that has no filter of its own: rounded(Number()) where the stages round,
/// exactly() otherwise.
template <class Rounded, class Exactly>
[[nodiscard]] Decision decide_number(Arithmetic arithmetic, Rounded rounded,
                                     Exactly exactly) noexcept {
    if (arithmetic == Arithmetic::naive) return {sign_of(rounded(double())), Stage::filter};
    if (arithmetic == Arithmetic::single) return {sign_of(rounded(float())), Stage::filter};
    if (arithmetic == Arithmetic::interval) {
        const filters::Interval number = rounded(filters::Interval());
        if (filters::exceeds(number, 0.0)) return {filters::sign_of_nonzero(number), Stage::filter};
    }
    return exactly();
}

}  // namespace

namespace cold {

Decision hides(Arithmetic arithmetic, const Site& i, const Site& q,
               const Ranks<2>& ranks) noexcept {
    return decide(
        arithmetic, [](const Site& m, const Site& other) { return filter::hides(m, other); },
        [&](const auto& d) { return euclidean::hides(d, ranks); }, i, q);
}

/// The point is a site of the radius of a, so that it adds no digit to the radii.
Decision nearer(Arithmetic arithmetic, const Point& p, const Site& a, const Site& b,
                const Ranks<2>& ranks) noexcept {
    return decide(
        arithmetic,
        [](const Site& point, const Site& first, const Site& second) {
            return filter::nearer({point.x, point.y}, first, second);
        },
        [&](const auto& d) { return euclidean::nearer(d, ranks); }, Site{p.x, p.y, a.r}, a, b);
}

Decision exists(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::exists, [&](const auto& d) { return euclidean::exists(d, ranks); }, i,
        j, k);
}

Decision exists_twice(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                      const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::exists_twice,
        [&](const auto& d) { return euclidean::exists_twice(d, ranks); }, i, j, k);
}

Decision precedes(Arithmetic arithmetic, const Site& i, const Site& j, const Site& q,
                  const Site& k) noexcept {
    return decide(
        arithmetic, filter::precedes, [](const auto& d) { return euclidean::precedes(d); }, i, j, q,
        k);
}

Decision in_circle(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                   const Site& q, const Ranks<4>& ranks) noexcept {
    return decide(
        arithmetic, filter::in_circle,
        [&](const auto& d) { return euclidean::in_circle(d, ranks); }, i, j, k, q);
}

Decision in_circle_infinite(Arithmetic arithmetic, const Site& a, const Site& b, const Site& q,
                            const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::in_circle_infinite,
        [&](const auto& d) { return euclidean::in_circle_infinite(d, ranks); }, a, b, q);
}

Decision reaches_farther(Arithmetic arithmetic, const Site& a, const Site& b,
                         bool a_precedes_b) noexcept {
    const Decision decision = decide_number(
        arithmetic,
        [&]<class Number>(Number) {
            return (Number(a.x) + Number(a.r)) - (Number(b.x) + Number(b.r));
        },
        [&]() -> Decision {
            if (arithmetic == Arithmetic::multiprecision) {
                using exact::to_rational;
                return {exact::sign((to_rational(a.x) + to_rational(a.r)) -
                                    (to_rational(b.x) + to_rational(b.r))),
                        Stage::multiprecision};
            }
            const double terms[] = {a.x, a.r, -b.x, -b.r};
            return {sign_of_sum(terms), Stage::essa};
        });
    if (decision.sign != 0) return decision;
    return {a_precedes_b ? 1 : -1, decision.stage, true};
}

Decision turn(Arithmetic arithmetic, const Site& a, const Site& b, const Site& c) noexcept {
    if (arithmetic == Arithmetic::exact) return ccw_decision(a, b, c);
    if (arithmetic == Arithmetic::multiprecision)
        return {multiprecision::ccw({a.x, a.y}, {b.x, b.y}, {c.x, c.y}), Stage::multiprecision};
    return decide_number(
        arithmetic, [&]<class Number>(Number) { return predicates::rounded_ccw<Number>(a, b, c); },
        [&] {
            return essa::ccw({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        });
}

}  // namespace cold

Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    const filters::Verdict verdict = filter::in_circle(i, j, k, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Arithmetic::exact, filter::in_circle,
        [&](const auto& d) { return in_circle_touch(d, ranks); }, i, j, k, q);
}

Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    const filters::Verdict verdict = filter::in_circle_infinite(a, b, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Arithmetic::exact, filter::in_circle_infinite,
        [](const auto& d) { return in_circle_infinite(d); }, a, b, q);
}

}  // namespace signum::euclidean
