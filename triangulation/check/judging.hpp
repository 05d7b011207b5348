#pragma once
/// The power predicates as a judge asks them: the floating-point filters first, whose error bounds
/// prove what they say, and where they leave a sign open the judge's exact numbers at once
/// (Arithmetic::judging, which those of the other metrics take as a parameter).

#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/power.hpp"

namespace signum::triangulation {

/// The predicates of the power metric, over any kind of its sites. Their signs are 0 where there is
/// a tie.
struct JudgingPower {
    template <class S>
    [[nodiscard]] static Decision ccw(const S& a, const S& b, const S& c) noexcept {
        return predicates::decide<Arithmetic::judging, predicates::Ccw>(a, b, c);
    }
    /// Precondition: ccw(i,j,k) > 0.
    template <class S>
    [[nodiscard]] static Decision in_circle(const S& i, const S& j, const S& k,
                                            const S& q) noexcept {
        return predicates::decide<Arithmetic::judging, power::InCircle>(i, j, k, q);
    }
    /// in_circle on a line. Preconditions: the centres of a and b differ, q lies on their line.
    template <class S>
    [[nodiscard]] static Decision in_segment(const S& a, const S& b, const S& q) noexcept {
        return predicates::decide<Arithmetic::judging, power::InSegment>(a, b, q);
    }
    /// +1 where the point is nearer to a than to b.
    template <class S>
    [[nodiscard]] static Decision nearer(Point p, const S& a, const S& b) noexcept {
        return predicates::decide<Arithmetic::judging, power::Nearer>(p, a, b);
    }
};

}  // namespace signum::triangulation
