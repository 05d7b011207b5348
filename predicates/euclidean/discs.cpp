#include <signum/predicates/euclidean/discs.hpp>

#include <signum/exact/floating_environment.hpp>
#include <signum/predicates/euclidean/cold_discs.hpp>
#include <signum/predicates/euclidean/polynomials.hpp>
#include <signum/predicates/multiprecision.hpp>

namespace signum::euclidean {
namespace {

/// The answer to a question of polynomials.hpp behind a filter that takes the sites one by one. In
/// an environment in which the filter declined it is asked again in the default one.
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Stages stages, Filter filter, Question question,
                              const Sites&... sites) noexcept {
    const std::array array{sites...};
    if (stages == Stages::multiprecision)
        return at(Stage::multiprecision, question(rational_discs(array)));
    if (stages == Stages::naive) return at(Stage::filter, question(rounded_discs(array)));
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide_exactly(array, question);
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

Decision turn(Stages stages, const Site& a, const Site& b, const Site& c) noexcept {
    if (stages == Stages::multiprecision)
        return {multiprecision::ccw({a.x, a.y}, {b.x, b.y}, {c.x, c.y}), Stage::multiprecision};
    if (stages == Stages::exact) return ccw_decision(a, b, c);
    return {sign_of(predicates::ccw_determinant(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y)),
            Stage::filter};
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
