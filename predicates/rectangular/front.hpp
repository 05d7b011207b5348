#pragma once
/// The numbers of the sweep: the forms of a site, sums of a few of them, and their exact order.
///
/// The sweep goes in the direction between sides 0 and 1 (supremum: the diagonal; Manhattan: y). A
/// circle is swept when its corner between those two sides is, at time (G_0 + G_1) / 2; the height
/// of a point, across, is half the difference of its coordinates in directions 0 and 1. With the
/// forms g_d(m) of forms.hpp:
///  1. The wave of m starts at (g_0(m) + g_1(m)) / 2, from the rearmost corner of its square, as a
///     ray without width. At time s it fills the heights from g_0(m) - s to s - g_1(m).
///  2. There its front, a tent, stands at (s + T) / 2, T being the lesser of height - g_3(m) and
///     -height - g_2(m): tents do not move against one another, only their lower and upper edges.
///  3. So between the waves of i, below, and j, above, the front turns from one to the other at i's
///     upper edge where i's tent is the higher one, at j's lower edge where j's is, or where both
///     are as high: at height (g_3(j) - g_2(i)) / 2, which rests.
/// All times and heights are halves of sums of forms; here they are taken twice.
/// Source: Gavrilova 1998, chapter 5, where the parabola of a site is what is a tent here.

#include <array>
#include <cstddef>
#include <limits>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../core/strided_sites.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/tally.hpp"
#include "../ladder/forms.hpp"

namespace signum::rectangular {

/// The forms of one site, rounded.
///
/// The error: with S = |x| + |y| + |r| a rounded form is off by 2eS (counted in forms.hpp) and less
/// than S(1+2e). A sum of forms of the sites a, b, ... (each taken at most twice, then alone in its
/// site) commits three roundings more, of partial sums below the sum of all S. So it is off by less
/// than the sum of the errors 8eS of its sites. Additions underflow exactly; near the greatest
/// doubles nothing is certain. Where the sums are exact (sums_are_exact) there is no error. As for
/// Forms, other arithmetics than doubles with a bound have the error 0 or an infinite one.
template <class Directions, Arithmetic arithmetic>
struct RoundedForms {
    using Number = predicates::NumberOf<arithmetic>;
    Number g[4];
    double error;

    RoundedForms(const Site& m, bool exact) noexcept {
        for (int d = 0; d < 4; ++d) g[d] = rounded_form<Directions, Number>(m, d);
        constexpr double everything = std::numeric_limits<double>::infinity();
        if constexpr (arithmetic == Arithmetic::sum || arithmetic == Arithmetic::multiprecision) {
            error = everything;
        } else if (!is_exact(arithmetic) || arithmetic == Arithmetic::interval || exact) {
            error = 0.0;
        } else {
            const double size =
                (filters::magnitude(m.x) + filters::magnitude(m.y)) + filters::magnitude(m.r);
            error = size < 0x1p1000 ? 8 * filters::epsilon * size : everything;
        }
    }
};

/// Whether all numbers of the sites are multiples of one power of two, and so small beside it that
/// sums of forms are doubles, all of them: as on integers and grids, where ties are frequent. O(n).
[[nodiscard]] bool sums_are_exact(const StridedSites& sites) noexcept;

/// The sign of a sum that its rounded value leaves open, under the tie rule; 0 only where the
/// infinitesimals cancel. `exact`: the value is not rounded.
template <class Directions, Arithmetic arithmetic, std::size_t count>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_sum(
    const predicates::NumberOf<arithmetic>& value, bool exact,
    const std::array<Addend, count>& addends) noexcept {
    const Decision decision =
        decide_behind<Directions, arithmetic>(value, exact, addends.data(), count);
    if (decision.sign != 0) return decision;
    return {sign_of_infinitesimals(addends.data(), count), decision.stage, true};
}

}  // namespace signum::rectangular
