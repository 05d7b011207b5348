#pragma once
/// The stages behind a filter, over any formula, and how they stand one behind the other. Included
/// by sources only, for exact numbers pull in Boost and GMP.
///
/// A stage is asked for a verdict, and says what stage it is. A ladder is a list of them, the last
/// of which is always certain, or a struct of a predicate's own whose stages share what they
/// compute. Two ladders stand behind a filter: where expansions and double-doubles hold all that
/// the formula consists of, and beyond that window. The arithmetics that have but one stage take
/// that: sums in the window, and exact numbers everywhere, those of a judge being of his own.

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "../../exact/expansion.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/sum.hpp"
#include "../../filters/double_double.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/verdict.hpp"
#include "../../filters/wide.hpp"
#include "../arithmetic.hpp"
#include "exact_number.hpp"

namespace signum::predicates {

namespace ladder {

using filters::Verdict;

// ---- what the formulas compute in (formulas/difference.hpp) -------------------------------------

/// Double-doubles.
struct Refined {
    using Number = filters::DoubleDouble;
    [[nodiscard, gnu::always_inline]] static Number difference(double a, double b) noexcept {
        return filters::exact_difference(a, b);
    }
    [[nodiscard, gnu::always_inline]] static Number difference_of_squares(double a,
                                                                          double b) noexcept {
        return filters::exact_difference(a, b) * filters::exact_sum(a, b);
    }
    [[nodiscard, gnu::always_inline]] static Number zero() noexcept { return {0.0, 0.0}; }
};

/// Expansions; 0 is one that never has a term.
struct Expanded {
    [[nodiscard, gnu::always_inline]] static exact::Expansion<2> difference(double a,
                                                                            double b) noexcept {
        return exact::difference(a, b);
    }
    [[nodiscard, gnu::always_inline]] static exact::Expansion<4> difference_of_squares(
        double a, double b) noexcept {
        return exact::product(a, a) - exact::product(b, b);
    }
    [[nodiscard, gnu::always_inline]] static exact::Expansion<1> zero() noexcept { return {}; }
};

/// Rationals, or a judge's numbers.
template <Arithmetic arithmetic>
struct Exactly {
    using Number = ExactNumber<arithmetic>;
    [[nodiscard]] static Number difference(double a, double b) {
        return exactly<arithmetic>(a) - exactly<arithmetic>(b);
    }
    [[nodiscard]] static Number difference_of_squares(double a, double b) {
        const Number of_a = exactly<arithmetic>(a);
        const Number of_b = exactly<arithmetic>(b);
        return of_a * of_a - of_b * of_b;
    }
    [[nodiscard]] static Number zero() { return {}; }
};

// ---- the stages ---------------------------------------------------------------------------------

/// The sign of a rounded number with a bound on its error.
[[nodiscard]] inline Verdict judged(double value, double bound) noexcept {
    if (filters::magnitude(value) > bound) return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}

/// The filter once more, in the default environment.
template <class Formula>
struct FilterAgain {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        return Formula::filter(sites...);
    }
};

/// The number in doubles, with the finer bound that a formula has inside the window:
/// Formula::bounded(sites...).
template <class Formula>
struct Bounded {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        const auto [value, bound] = Formula::bounded(sites...);
        return judged(value, bound);
    }
};

template <class Formula>
struct InExpansions {
    static constexpr Stage stage = Stage::exact;
    template <class... Sites>
    [[nodiscard, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        return Verdict::certain(Formula::template value<Expanded>(sites...).sign());
    }
};

/// By the exact sign of a sum. Source: Gavrilova 1998, section 4.7.2.
template <class Formula>
struct BySums {
    static constexpr Stage stage = Stage::essa;
    template <class... Sites>
    [[nodiscard, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        return Verdict::certain(Formula::template value<exact::Sum>(sites...).sign());
    }
};

/// Right for all finite doubles, in any environment.
template <class Formula, Arithmetic arithmetic = Arithmetic::multiprecision>
struct InExactNumbers {
    static constexpr Stage stage = Stage::multiprecision;
    template <class... Sites>
    [[nodiscard, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        return Verdict::certain(Formula::template value<Exactly<arithmetic>>(sites...).sign());
    }
};

/// In numbers whose exponents go far beyond those of doubles. Where exchanging two sites turns the
/// sign, the origin may be any of them: Formula::origin is its place.
template <class Formula>
struct InWideNumbers {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        if constexpr (requires { Formula::origin; }) {
            std::array order = {&sites...};
            const Sign turn = filters::base_on_least(order, Formula::origin);
            const Verdict verdict = [&]<std::size_t... m>(std::index_sequence<m...>) {
                return Formula::template value<filters::Wide>(*order[m]...).sign();
            }
            (std::make_index_sequence<sizeof...(Sites)>());
            return verdict.is_certain() ? Verdict::certain(turn * verdict.sign()) : verdict;
        } else {
            return Formula::template value<filters::Wide>(sites...).sign();
        }
    }
};

// ---- the ladders --------------------------------------------------------------------------------

/// One after the other.
template <class First, class... Others>
struct Steps {
    template <class... Sites>
    [[nodiscard, gnu::always_inline]] static inline Decision climb(const Sites&... sites) noexcept {
        const Verdict verdict = First::ask(sites...);
        if constexpr (sizeof...(Others) > 0)
            if (!verdict.is_certain()) return Steps<Others...>::climb(sites...);
        return {verdict.sign(), First::stage};
    }
};

/// Where expansions might over- or underflow.
template <class Formula>
using Beyond = Steps<InWideNumbers<Formula>, InExactNumbers<Formula>>;

/// Whether |coordinate| and |radius| are 0 or in [2^-exponent, 2^exponent], a weight counting as
/// degree 2.
template <int exponent, class S>
[[nodiscard, gnu::always_inline]] inline bool in_window(const S& s) noexcept {
    using exact::window::contains;
    bool holds = contains(s.x, exponent) && contains(s.y, exponent);
    if constexpr (requires { s.z; }) holds = holds && contains(s.z, exponent);
    if constexpr (requires { s.r; }) holds = holds && contains(s.r, exponent);
    if constexpr (requires { s.w; }) holds = holds && contains(s.w, 2 * exponent);
    return holds;
}

/// The two ladders. The window is the formula's own: at 200 expansions and sums hold all terms of
/// degree up to 4 (exact/expansion.hpp). A formula without one is always beyond it.
/// A function of its own, for what is inlined into a cold one is compiled for size.
template <class Formula, class Within, class Outside, class... Sites>
[[nodiscard, gnu::noinline]] Decision climb_one(const Sites&... sites) noexcept {
    if constexpr (requires { Formula::window; })
        if ((in_window<Formula::window>(sites) && ...)) [[likely]]
            return Within::climb(sites...);
    return Outside::climb(sites...);
}

/// What an arithmetic has behind its filter.
template <Arithmetic arithmetic, class Formula, class Within, class Outside, class... Sites>
[[nodiscard]] inline Decision climb(const Sites&... sites) noexcept {
    if constexpr (arithmetic == Arithmetic::exact)
        return exact::in_ieee_environment(climb_one<Formula, Within, Outside, Sites...>, sites...);
    else if constexpr (arithmetic == Arithmetic::sum)
        return exact::in_ieee_environment(
            climb_one<Formula, Steps<BySums<Formula>>, Steps<InExactNumbers<Formula>>, Sites...>,
            sites...);
    else
        return Steps<InExactNumbers<Formula, arithmetic>>::climb(sites...);
}

}  // namespace ladder
}  // namespace signum::predicates

/// What each predicate's source instantiates for a kind of sites, behind filters and for a judge.
#define SIGNUM_FOR_ARITHMETICS(instantiate, S)                                   \
    instantiate(Arithmetic::exact, S) instantiate(Arithmetic::multiprecision, S) \
        instantiate(Arithmetic::judging, S)
#define SIGNUM_FOR_POWER_SITES(instantiate)                                \
    SIGNUM_FOR_ARITHMETICS(instantiate, Point)                             \
    SIGNUM_FOR_ARITHMETICS(instantiate, Site)                              \
    SIGNUM_FOR_ARITHMETICS(instantiate, signum::Site)                      \
    instantiate(Arithmetic::sum, Point) instantiate(Arithmetic::sum, Site) \
        instantiate(Arithmetic::sum, signum::Site)
