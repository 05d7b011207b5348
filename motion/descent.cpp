#include "descent.hpp"

#include "meeting.hpp"

namespace signum::motion {

using exact::Dyadic;
using exact::Polynomial;
using exact::Roots;

/// Above 0 the gap can only fall through 0: where it first changes its sign. Below 0 and rising it
/// first turns (or never does). Where it has not crossed 0 until then, the meeting is where it
/// turns; else it is where it comes back through 0, its second change of sign. Which of the two
/// came first is a question of counts, and never an endless one: at a turn that touches 0 from
/// below the gap does not change its sign.
double first_descent(const Polynomial& gap, double start) {
    if (gap.degree() < 1) return infinity;
    const Dyadic now(start);
    const Polynomial slope = gap.derivative();
    const Sign sign = gap.sign_at(now);
    const bool falls = exact::sign_after(slope, now) < 0;
    if (falls && sign <= 0) return start;

    const Roots crossings(exact::odd_part(gap));
    if (sign >= 0) return crossings.nearest_double(now, 1);
    const Roots turns(exact::odd_part(slope));
    auto turn = turns.isolate(now, 1);
    if (!turn) return infinity;
    for (;; turns.halve(*turn)) {
        if (crossings.between(now, turn->high) == 0) return turns.nearest_double(*turn);
        if (crossings.between(now, turn->low) > 0) return crossings.nearest_double(now, 2);
    }
}

}  // namespace signum::motion
