#include "discs.hpp"

#include "../../exact/floating_environment.hpp"
#include "../../exact/sign_of_sum.hpp"
#include "../multiprecision.hpp"
#include "exact_discs.hpp"
#include "polynomials.hpp"

namespace signum::euclidean {
namespace {

/// The answer to a question of polynomials.hpp in intervals, or exactly.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_in_intervals(const std::array<Site, n>& sites,
                                           const Question& question) {
    bool doubt = !filters::environment_is_default();
    const Decision decision = at(Stage::filter, question(enclosed_discs(sites, doubt)));
    return doubt ? decide_exactly(sites, question) : decision;
}

/// The answer to a question of polynomials.hpp behind a filter that takes the sites one by one. In
/// an environment in which the filter declined it is asked again in the default one.
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Stages stages, Filter filter, Question question,
                              const Sites&... sites) noexcept {
    const std::array array{sites...};
    switch (stages) {
        case Stages::multiprecision:
            return at(Stage::multiprecision, question(rational_discs(array)));
        case Stages::naive:
            return at(Stage::filter, question(rounded_discs<double>(array)));
        case Stages::single:
            return at(Stage::filter, question(rounded_discs<float>(array)));
        case Stages::interval:
            return decide_in_intervals(array, question);
        case Stages::exact:
            if (!filters::environment_is_default()) {
                const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
                if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
            }
            break;
        case Stages::sum:
            break;
    }
    return decide_exactly(array, question);
}

/// The sign of a number that has no filter of its own: rounded(Number()) where the stages round,
/// exactly() otherwise.
template <class Rounded, class Exactly>
[[nodiscard]] Decision decide_number(Stages stages, Rounded rounded, Exactly exactly) noexcept {
    if (stages == Stages::naive) return {sign_of(rounded(double())), Stage::filter};
    if (stages == Stages::single) return {sign_of(rounded(float())), Stage::filter};
    if (stages == Stages::interval) {
        const filters::Interval number = rounded(filters::Interval());
        if (filters::exceeds(number, 0.0)) return {filters::sign_of_nonzero(number), Stage::filter};
    }
    return exactly();
}

}  // namespace

namespace cold {

Decision hides(Stages stages, const Site& i, const Site& q, const Ranks<2>& ranks) noexcept {
    return decide(
        stages, [](const Site& m, const Site& other) { return filter::hides(m, other); },
        [&](const auto& d) { return euclidean::hides(d, ranks); }, i, q);
}

/// The point is a site of the radius of a, so that it adds no digit to the radii.
Decision nearer(Stages stages, const Point& p, const Site& a, const Site& b,
                const Ranks<2>& ranks) noexcept {
    return decide(
        stages,
        [](const Site& point, const Site& first, const Site& second) {
            return filter::nearer({point.x, point.y}, first, second);
        },
        [&](const auto& d) { return euclidean::nearer(d, ranks); }, Site{p.x, p.y, a.r}, a, b);
}

Decision exists(Stages stages, const Site& i, const Site& j, const Site& k,
                const Ranks<3>& ranks) noexcept {
    return decide(
        stages, filter::exists, [&](const auto& d) { return euclidean::exists(d, ranks); }, i, j,
        k);
}

Decision exists_twice(Stages stages, const Site& i, const Site& j, const Site& k,
                      const Ranks<3>& ranks) noexcept {
    return decide(
        stages, filter::exists_twice,
        [&](const auto& d) { return euclidean::exists_twice(d, ranks); }, i, j, k);
}

Decision precedes(Stages stages, const Site& i, const Site& j, const Site& q,
                  const Site& k) noexcept {
    return decide(
        stages, filter::precedes, [](const auto& d) { return euclidean::precedes(d); }, i, j, q, k);
}

Decision in_circle(Stages stages, const Site& i, const Site& j, const Site& k, const Site& q,
                   const Ranks<4>& ranks) noexcept {
    return decide(
        stages, filter::in_circle, [&](const auto& d) { return euclidean::in_circle(d, ranks); }, i,
        j, k, q);
}

Decision in_circle_infinite(Stages stages, const Site& a, const Site& b, const Site& q,
                            const Ranks<3>& ranks) noexcept {
    return decide(
        stages, filter::in_circle_infinite,
        [&](const auto& d) { return euclidean::in_circle_infinite(d, ranks); }, a, b, q);
}

Decision reaches_farther(Stages stages, const Site& a, const Site& b, bool a_precedes_b) noexcept {
    const Decision decision = decide_number(
        stages,
        [&]<class Number>(Number) {
            return (Number(a.x) + Number(a.r)) - (Number(b.x) + Number(b.r));
        },
        [&]() -> Decision {
            if (stages == Stages::multiprecision) {
                using exact::to_rational;
                const exact::Rational difference =
                    to_rational(a.x) + to_rational(a.r) - to_rational(b.x) - to_rational(b.r);
                return {exact::sign(difference), Stage::multiprecision};
            }
            const double terms[] = {a.x, a.r, -b.x, -b.r};
            return {sign_of_sum(terms), Stage::exact};
        });
    if (decision.sign != 0) return decision;
    return {a_precedes_b ? 1 : -1, decision.stage, true};
}

Decision turn(Stages stages, const Site& a, const Site& b, const Site& c) noexcept {
    if (stages == Stages::exact) return ccw_decision(a, b, c);
    if (stages == Stages::multiprecision)
        return {multiprecision::ccw({a.x, a.y}, {b.x, b.y}, {c.x, c.y}), Stage::multiprecision};
    return decide_number(
        stages, [&]<class Number>(Number) { return predicates::rounded_ccw<Number>(a, b, c); },
        [&] {
            return predicates::ccw_exactly({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
        });
}

}  // namespace cold

Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    const filters::Verdict verdict = filter::in_circle(i, j, k, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Stages::exact, filter::in_circle, [&](const auto& d) { return in_circle_touch(d, ranks); },
        i, j, k, q);
}

Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    const filters::Verdict verdict = filter::in_circle_infinite(a, b, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Stages::exact, filter::in_circle_infinite,
        [](const auto& d) { return in_circle_infinite(d); }, a, b, q);
}

}  // namespace signum::euclidean
