#pragma once
/// How the sign of a formula is found, of orientations and of the power metric: by the filter or
/// the rounded number of an arithmetic, and where that leaves it open by the ladder behind it.
/// Questions about discs, balls and rectangular forms are not the sign of one formula; their stages
/// stand in discs.hpp, balls.hpp and forms.cpp.
///
/// A formula of a predicate is a struct of static functions of the predicate's sites:
///     value<Number>   the number whose sign is asked, in whatever it is computed in (formulas/)
///     filter          that sign in doubles with a proven bound, inlined into the caller
///     behind<A>       the stages of the arithmetic A behind it, out of line: the ladder that the
///                     predicate's source names (ladder/ladder.hpp)

#include "../../core/sign.hpp"
#include "../../filters/interval.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/verdict.hpp"
#include "../arithmetic.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::predicates {

template <Arithmetic arithmetic, class Formula, class... Sites>
[[nodiscard, gnu::always_inline]] inline Decision decide(const Sites&... sites) noexcept {
    if constexpr (is_filtered(arithmetic)) {
        if constexpr (requires { Formula::filter(sites...); }) {
            const filters::Verdict verdict = Formula::filter(sites...);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return Formula::template behind<arithmetic>(sites...);
    } else if constexpr (is_exact(arithmetic) && arithmetic != Arithmetic::interval) {
        return Formula::template behind<arithmetic>(sites...);
    } else {
        const auto number = Formula::template value<NumberOf<arithmetic>>(sites...);
        if (filters::exceeds(number, 0.0)) [[likely]]
            return {filters::sign_of_nonzero(number), Stage::filter};
        if constexpr (is_exact(arithmetic))
            return Formula::template behind<Arithmetic::sum>(sites...);
        else
            return {0, Stage::filter};
    }
}

}  // namespace signum::predicates

SIGNUM_IEEE_END
