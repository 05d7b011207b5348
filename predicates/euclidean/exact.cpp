#include "../euclidean.hpp"

#include "../../exact/sign_of_sum.hpp"
#include "../ladder/discs.hpp"
#include "../ladder/with_arithmetic.hpp"

namespace signum::euclidean {
namespace {

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
        [&](const auto& d) { return polynomials::hides(d, ranks); }, i, q);
}

/// The point is a site of the radius of a, so that it adds no digit to the radii.
Decision nearer(Arithmetic arithmetic, const Point& p, const Site& a, const Site& b,
                const Ranks<2>& ranks) noexcept {
    return decide(
        arithmetic,
        [](const Site& point, const Site& first, const Site& second) {
            return filter::nearer({point.x, point.y}, first, second);
        },
        [&](const auto& d) { return polynomials::nearer(d, ranks); }, Site{p.x, p.y, a.r}, a, b);
}

Decision exists(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::exists, [&](const auto& d) { return polynomials::exists(d, ranks); }, i,
        j, k);
}

Decision exists_twice(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                      const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::exists_twice,
        [&](const auto& d) { return polynomials::exists_twice(d, ranks); }, i, j, k);
}

Decision precedes_on_bisector(Arithmetic arithmetic, const Site& i, const Site& j, const Site& q,
                              const Site& k) noexcept {
    return decide(
        arithmetic, filter::precedes_on_bisector,
        [](const auto& d) { return polynomials::precedes_on_bisector(d); }, i, j, q, k);
}

Decision in_circle(Arithmetic arithmetic, const Site& i, const Site& j, const Site& k,
                   const Site& q, const Ranks<4>& ranks) noexcept {
    return decide(
        arithmetic, filter::in_circle,
        [&](const auto& d) { return polynomials::in_circle(d, ranks); }, i, j, k, q);
}

Decision in_circle_infinite(Arithmetic arithmetic, const Site& a, const Site& b, const Site& q,
                            const Ranks<3>& ranks) noexcept {
    return decide(
        arithmetic, filter::in_circle_infinite,
        [&](const auto& d) { return polynomials::in_circle_infinite(d, ranks); }, a, b, q);
}

Decision reaches_farther(Arithmetic arithmetic, const Site& a, const Site& b,
                         bool a_precedes_b) noexcept {
    const Decision decision = decide_number(
        arithmetic,
        [&]<class Number>(Number) {
            return (Number(a.x) + Number(a.r)) - (Number(b.x) + Number(b.r));
        },
        [&]() -> Decision {
            const auto farther = [](const auto& d) -> Decision {
                return at(Stage::multiprecision, ((d[0].x + d[0].r) - (d[1].x + d[1].r)).sign());
            };
            if (arithmetic == Arithmetic::judging)
                return farther(exact_discs<Arithmetic::judging>(std::array{a, b}));
            if (arithmetic == Arithmetic::multiprecision)
                return farther(exact_discs(std::array{a, b}));
            const double terms[] = {a.x, a.r, -b.x, -b.r};
            return {sign_of_sum(terms), Stage::essa};
        });
    if (decision.sign != 0) return decision;
    return {a_precedes_b ? 1 : -1, decision.stage, true};
}

Decision turn(Arithmetic arithmetic, const Site& a, const Site& b, const Site& c) noexcept {
    using predicates::Ccw;
    if (arithmetic == Arithmetic::judging)
        return predicates::decide<Arithmetic::judging, Ccw>(a, b, c);
    return predicates::with_arithmetic(
        arithmetic, [&]<Arithmetic known>() { return predicates::decide<known, Ccw>(a, b, c); });
}

}  // namespace cold

Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    const filters::Verdict verdict = filter::in_circle(i, j, k, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Arithmetic::exact, filter::in_circle,
        [&](const auto& d) { return polynomials::in_circle_touch(d, ranks); }, i, j, k, q);
}

Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    const filters::Verdict verdict = filter::in_circle_infinite(a, b, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        Arithmetic::exact, filter::in_circle_infinite,
        [](const auto& d) { return polynomials::in_circle_infinite_touch(d); }, a, b, q);
}

}  // namespace signum::euclidean
