#pragma once
/// The predicates as a judge asks them: the floating-point filters first, whose error bounds prove
/// what they say, and where they leave a sign open rationals at once. What a construction relies on
/// between the two (double-doubles, expansions, integers, the exact sign of a sum) is believed
/// nowhere, so that an error in it cannot confirm itself.

#include <array>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/multiprecision.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/power/multiprecision.hpp"

namespace signum::triangulation::judging {

/// A decision that a filter made, or else that of rationals.
template <class InRationals>
[[nodiscard]] Decision believe(const Decision& decision, InRationals in_rationals) noexcept {
    return decision.stage == Stage::filter ? decision : in_rationals();
}

/// The predicates of a metric with additive weights under the tie rule, from the struct that
/// constructions take and from the one that has rationals alone.
template <class Filtered, class Rational>
struct AdditivePredicates {
    template <std::size_t n>
    using Ranks = std::array<Index, n>;

    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const Ranks<2>& ranks) noexcept {
        return believe(Filtered::hides(i, q, ranks), [&] { return Rational::hides(i, q, ranks); });
    }
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const Ranks<3>& ranks) noexcept {
        return believe(Filtered::exists(i, j, k, ranks),
                       [&] { return Rational::exists(i, j, k, ranks); });
    }
    [[nodiscard]] static Decision exists_twice(const Site& i, const Site& j, const Site& k,
                                               const Ranks<3>& ranks) noexcept {
        return believe(Filtered::exists_twice(i, j, k, ranks),
                       [&] { return Rational::exists_twice(i, j, k, ranks); });
    }
    [[nodiscard]] static Decision precedes(const Site& i, const Site& j, const Site& q,
                                           const Site& k, const Ranks<4>& ranks) noexcept {
        return believe(Filtered::precedes(i, j, q, k, ranks),
                       [&] { return Rational::precedes(i, j, q, k, ranks); });
    }
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q, const Ranks<4>& ranks) noexcept {
        return believe(Filtered::in_circle(i, j, k, q, ranks),
                       [&] { return Rational::in_circle(i, j, k, q, ranks); });
    }
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const Ranks<3>& ranks) noexcept {
        return believe(Filtered::in_circle_infinite(a, b, q, ranks),
                       [&] { return Rational::in_circle_infinite(a, b, q, ranks); });
    }
    [[nodiscard]] static Decision holds_first_direction(const Site& k, const Site& s, const Site& l,
                                                        const Ranks<3>& ranks) noexcept {
        return believe(Filtered::holds_first_direction(k, s, l, ranks),
                       [&] { return Rational::holds_first_direction(k, s, l, ranks); });
    }
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const Ranks<2>& ranks) noexcept {
        return believe(Filtered::nearer(p, a, b, ranks),
                       [&] { return Rational::nearer(p, a, b, ranks); });
    }
};

/// The predicates of the power metric. Their signs are 0 where there is a tie.
struct PowerPredicates {
    /// The orientation of three sites' centres.
    template <power::PowerSite S>
    [[nodiscard]] static Decision ccw(const S& a, const S& b, const S& c) noexcept {
        const filters::Verdict quick = predicates::ccw_filter(a, b, c);
        if (quick.is_certain()) [[likely]]
            return {quick.sign(), Stage::filter};
        return {multiprecision::ccw(power::centre(a), power::centre(b), power::centre(c)),
                Stage::multiprecision};
    }
    /// Precondition: ccw(i,j,k) > 0.
    template <power::PowerSite S>
    [[nodiscard]] static Decision in_circle(const S& i, const S& j, const S& k,
                                            const S& q) noexcept {
        const filters::Verdict quick = power::in_circle_filter(i, j, k, q);
        if (quick.is_certain()) [[likely]]
            return {quick.sign(), Stage::filter};
        return {power::multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
    }
    /// in_circle on a line. Preconditions: the centres of a and b differ, q lies on their line.
    template <power::PowerSite S>
    [[nodiscard]] static Decision in_segment(const S& a, const S& b, const S& q) noexcept {
        return believe(power::in_segment_decision(a, b, q), [&]() -> Decision {
            return {power::multiprecision::in_segment(a, b, q), Stage::multiprecision};
        });
    }
    /// +1 where the point is nearer to a than to b.
    template <power::PowerSite S>
    [[nodiscard]] static Decision nearer(Point p, const S& a, const S& b) noexcept {
        return believe(power::nearer_decision(p, a, b), [&]() -> Decision {
            return {power::multiprecision::nearer(p, a, b), Stage::multiprecision};
        });
    }
};

}  // namespace signum::triangulation::judging
