#pragma once
/// The linear forms of the supremum and Manhattan metrics, and the signs of their sums.
///
/// In both metrics a disc is a square with sides in four directions d, counterclockwise (right,
/// top, left, bottom; in the Manhattan metric, where u = x + y and v = y - x take the places of x
/// and y, the four diagonals). A site m pins one form to each direction,
///
///     g_d(m) = (direction d) · c_m - r_m,
///
/// and a circle with centre X and radius rho one number, G_d = (direction d) · X + rho.
/// Laws:
///  1. m's distance from X is the greatest of g_d(m) - (direction d) · X. So m is nearer than rho,
///     as near, or farther as the greatest of g_d(m) - G_d is negative, 0 or positive.
///  2. G_right + G_left = G_top + G_bottom = 2 rho: three of the numbers give the fourth.
///  3. The tie rule (every radius less by its own infinitesimal, infinitely larger for the later
///     site) adds the infinitesimal of m to all four g_d(m).
/// Everything is decided by signs of sums of two, four or eight forms: no product, no overflow that
/// decides.

#include <array>
#include <cstddef>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/interval.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/tally.hpp"
#include "../additive.hpp"
#include "../arithmetic.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::rectangular {

/// The directions of the supremum metric: right, top, left, bottom.
struct Supremum {
    static constexpr double x[4] = {1, 0, -1, 0};
    static constexpr double y[4] = {0, 1, 0, -1};
};

/// The directions of the Manhattan metric: those of u = x + y and v = y - x.
struct Manhattan {
    static constexpr double x[4] = {1, -1, -1, 1};
    static constexpr double y[4] = {1, 1, -1, -1};
};

/// factor · g_side(site), one addend of a sum; `rank` is the site's place in the tie rule's order.
struct Addend {
    const Site* site;
    Index rank;
    int side;
    int factor;
};

/// The exact sign of a sum of forms (at most eight), 0 included, in every environment, by the last
/// stages of an exact arithmetic: ESSA, which the arithmetic `exact` spares itself where the sum
/// commits no rounding, rationals, or a judge's exact numbers.
template <class Directions, Arithmetic arithmetic>
[[nodiscard, gnu::cold]] Decision decide_forms(const Addend* first, std::size_t count) noexcept;

/// Which of a and b is nearer to p: +1 for a, 0 where both are as near. By the same stages.
template <class Directions, Arithmetic arithmetic>
[[nodiscard, gnu::cold]] Decision compare_distances(const Point& p, const Site& a,
                                                    const Site& b) noexcept;

/// The sign of the infinitesimals of a sum: of the last site in the order whose factors do not
/// cancel; 0 where all do.
[[nodiscard]] Sign sign_of_infinitesimals(const Addend* first, std::size_t count) noexcept;

/// g_side(m), rounded.
template <class Directions, class Number>
[[nodiscard]] constexpr Number rounded_form(const Site& m, int side) noexcept {
    return (Number(Directions::x[side] * m.x) + Number(Directions::y[side] * m.y)) - Number(m.r);
}

/// The sums of forms that are asked for: two widths, and any, term by term.
template <class Number>
[[nodiscard]] constexpr Number difference_of_widths(const Number& a, const Number& b,
                                                    const Number& c, const Number& d) noexcept {
    return (a + c) - (b + d);
}
template <class Number>
[[nodiscard]] constexpr Number with_term(const Number& sum, int factor,
                                         const Number& form) noexcept {
    return sum + Number(factor) * form;
}

namespace count {
using filters::RoundingCount;
constexpr RoundingCount form = rounded_form<Manhattan, RoundingCount>(Site{}, 0);
constexpr RoundingCount sum_of_eight() noexcept {
    RoundingCount sum;
    for (int t = 0; t < 8; ++t) sum = with_term(sum, 1, form);
    return sum;
}
static_assert(form.roundings == 2);
static_assert(difference_of_widths(form, form, form, form).roundings == 4);
static_assert(sum_of_eight().roundings == 11);
}  // namespace count

/// The sign of a sum whose rounded value leaves it open, 0 included, and the stage that tells.
/// `exact`: the value is not rounded.
template <class Directions, Arithmetic arithmetic>
[[nodiscard]] inline Decision decide_behind(const predicates::NumberOf<arithmetic>& value,
                                            [[maybe_unused]] bool exact, const Addend* first,
                                            std::size_t count) noexcept {
    if constexpr (!is_exact(arithmetic)) {
        return {sign_of(value), Stage::filter};
    } else {
        if constexpr (arithmetic == Arithmetic::exact)
            if (exact) return {sign_of(value), Stage::filter};
        return decide_forms<Directions, arithmetic>(first, count);
    }
}

/// The bounds on the errors of sums of four and of eight forms, as multiples of S.
inline constexpr double error_of_four = 20 * filters::epsilon;
inline constexpr int eight_by_four = 5;

/// The forms of n sites, rounded, and the comparisons that a predicate makes of them.
///
/// The bound: with S the greatest |x| + |y| + |r| of the sites, the magnitude of a sum of four
/// forms is 4S at most, and that of eight 8S. By the lemma of rounding_count.hpp the former is off
/// by ((1+e)^4 - 1) 4S < 17eS, e = 2^-52, the latter by ((1+e)^11 - 1) 8S < 89eS; of what remains
/// to 20e and to 100e the roundings of S and of the bound take a few e². Comparing two forms
/// commits less. Additions underflow exactly; where one could overflow the bound is infinite.
///
/// Other arithmetics than doubles with a bound say themselves what they are worth: intervals, and
/// numbers that are taken for the truth, have the bound 0; where no rounded number counts the bound
/// is infinite.
template <class Directions, Arithmetic arithmetic, std::size_t n>
class Forms {
    using Number = predicates::NumberOf<arithmetic>;

 public:
    Forms(const std::array<const Site*, n>& sites, const std::array<Index, n>& ranks) noexcept
        : sites_(sites), ranks_(ranks) {
        double magnitude = 0.0;
        for (std::size_t m = 0; m < n; ++m) {
            const Site site = filters::pinned(*sites[m]);
            for (int d = 0; d < 4; ++d) forms_[m][d] = rounded_form<Directions, Number>(site, d);
            const double size = (filters::magnitude(site.x) + filters::magnitude(site.y)) +
                                filters::magnitude(site.r);
            magnitude = magnitude < size ? size : magnitude;
        }
        bound_ = bound(magnitude);
    }

    /// The sign of g_side(a) - g_side(b); never 0 for two sites.
    [[nodiscard]] Sign compare(int side, std::size_t a, std::size_t b) noexcept {
        const Number difference = forms_[a][side] - forms_[b][side];
        if (filters::exceeds(difference, bound_)) [[likely]]
            return filters::sign_of_nonzero(difference);
        return resolve(difference, {addend(side, a, 1), addend(side, b, -1)});
    }

    /// The sign of the sum of two forms (a at side s, c at side s+2) minus that of two others
    /// (b at side s+1, d at side s+3); 0 only where the infinitesimals cancel.
    [[nodiscard]] Sign compare_widths(int s, std::size_t a, std::size_t b, std::size_t c,
                                      std::size_t d) noexcept {
        const int sides[4] = {s, (s + 1) & 3, (s + 2) & 3, (s + 3) & 3};
        const Number difference = difference_of_widths(forms_[a][sides[0]], forms_[b][sides[1]],
                                                       forms_[c][sides[2]], forms_[d][sides[3]]);
        if (filters::exceeds(difference, bound_)) [[likely]]
            return filters::sign_of_nonzero(difference);
        return resolve(difference, {addend(sides[0], a, 1), addend(sides[1], b, -1),
                                    addend(sides[2], c, 1), addend(sides[3], d, -1)});
    }

    /// factor · g_side(site), where the site is given by its place among the n.
    struct Term {
        int side;
        std::size_t site;
        int factor;
    };

    /// The sign of a sum of at most eight forms; 0 only where the infinitesimals cancel.
    template <std::size_t count>
    [[nodiscard]] Sign compare_sum(const std::array<Term, count>& terms) noexcept {
        static_assert(count <= 8);
        Number sum(0.0);
        Addend addends[count];
        for (std::size_t t = 0; t < count; ++t) {
            const Term& term = terms[t];
            sum = with_term(sum, term.factor, forms_[term.site][term.side]);
            addends[t] = addend(term.side, term.site, term.factor);
        }
        if (filters::exceeds(sum, eight_by_four * bound_)) return filters::sign_of_nonzero(sum);
        return resolve(sum, addends);
    }

    /// A sign with the dearest stage that was needed so far, and whether a sum was exactly 0.
    [[nodiscard]] Decision decide(Sign sign) const noexcept { return {sign, stage_, tied_}; }
    /// From here on, ties count as met; those before only helped to find the square.
    void forget_ties() noexcept { tied_ = false; }
    /// From now on sums that are 0 stay 0.
    void leave_ties() noexcept { perturbed_ = false; }

 private:
    [[nodiscard]] static double bound(double magnitude) noexcept {
        constexpr double everything = __builtin_huge_val();
        if constexpr (!is_exact(arithmetic) || arithmetic == Arithmetic::interval) return 0.0;
        if constexpr (arithmetic == Arithmetic::sum || arithmetic == Arithmetic::multiprecision)
            return everything;
        // Where additions may overflow, saturate or be flushed nothing is certain.
        return magnitude < 0x1p1000 && filters::environment_is_default() ? error_of_four * magnitude
                                                                         : everything;
    }

    [[nodiscard]] Addend addend(int side, std::size_t m, int factor) const noexcept {
        return {sites_[m], ranks_[m], side, factor};
    }

    template <std::size_t count>
    [[nodiscard, gnu::cold, gnu::noinline]] Sign resolve(const Number& rounded,
                                                         const Addend (&addends)[count]) noexcept {
        const Decision decision =
            decide_behind<Directions, arithmetic>(rounded, false, addends, count);
        if (stage_ < decision.stage) stage_ = decision.stage;
        if (decision.sign != 0) return decision.sign;
        tied_ = true;
        return perturbed_ ? sign_of_infinitesimals(addends, count) : 0;
    }

    std::array<const Site*, n> sites_;
    std::array<Index, n> ranks_;
    Number forms_[n][4];
    double bound_;
    Stage stage_ = Stage::filter;
    bool tied_ = false;
    bool perturbed_ = true;
};

}  // namespace signum::rectangular

SIGNUM_IEEE_END
