#pragma once
/// The power predicates as a judge asks them: the floating-point filters first, whose error bounds
/// prove what they say, and where they leave a sign open the judge's exact numbers at once
/// (predicates::judging, which those of the other metrics take as a parameter).

#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/multiprecision.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/power/multiprecision.hpp"

namespace signum::triangulation {

/// The predicates of the power metric. Their signs are 0 where there is a tie.
struct JudgingPower {
    /// The orientation of three sites' centres.
    template <power::PowerSite S>
    [[nodiscard]] static Decision ccw(const S& a, const S& b, const S& c) noexcept {
        const filters::Verdict quick = predicates::ccw_filter(a, b, c);
        if (quick.is_certain()) [[likely]]
            return {quick.sign(), Stage::filter};
        return {multiprecision::ccw<predicates::judging>(power::centre(a), power::centre(b),
                                                         power::centre(c)),
                Stage::multiprecision};
    }
    /// Precondition: ccw(i,j,k) > 0.
    template <power::PowerSite S>
    [[nodiscard]] static Decision in_circle(const S& i, const S& j, const S& k,
                                            const S& q) noexcept {
        const filters::Verdict quick = power::in_circle_filter(i, j, k, q);
        if (quick.is_certain()) [[likely]]
            return {quick.sign(), Stage::filter};
        return {power::multiprecision::in_circle<predicates::judging>(i, j, k, q),
                Stage::multiprecision};
    }
    /// in_circle on a line. Preconditions: the centres of a and b differ, q lies on their line.
    template <power::PowerSite S>
    [[nodiscard]] static Decision in_segment(const S& a, const S& b, const S& q) noexcept {
        return {power::multiprecision::in_segment<predicates::judging>(a, b, q),
                Stage::multiprecision};
    }
    /// +1 where the point is nearer to a than to b.
    template <power::PowerSite S>
    [[nodiscard]] static Decision nearer(Point p, const S& a, const S& b) noexcept {
        return {power::multiprecision::nearer<predicates::judging>(p, a, b), Stage::multiprecision};
    }
};

}  // namespace signum::triangulation
