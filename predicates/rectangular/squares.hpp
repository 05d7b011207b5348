#pragma once
/// The predicates of the supremum and Manhattan metrics: squares, and the squares inscribed between
/// them.
///
/// Three sites have a vertex where they touch three different sides of a square in counterclockwise
/// order. On each side the site with the greatest form touches, if any does; so the four greatest
/// leave two candidates for the side that nobody touches, and of the two pairs of opposite sides
/// the one that lies farther apart has both its sides touched.
/// Source: Gavrilova 1998, chapter 5; the tie rule is taken into every comparison.

#include <array>

#include "../../core/contract.hpp"
#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../additive.hpp"
#include "../ladder/forms.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::rectangular {

/// The side of an inscribed square that no site touches, and who touches the others (in the open
/// place: who comes nearest).
struct Touching {
    int open;  ///< -1 where there is no such square
    std::array<std::size_t, 4> site;
};

/// The square that three sites of the forms touch counterclockwise, under the tie rule.
template <class AnyForms>
[[nodiscard]] inline Touching touching(AnyForms& forms,
                                       const std::array<std::size_t, 3>& corners = {0, 1,
                                                                                    2}) noexcept {
    Touching result{-1, {}};
    std::array<std::size_t, 4> touches{};  // places among the corners
    for (int side = 0; side < 4; ++side) {
        std::size_t most = forms.compare(side, corners[1], corners[0]) > 0 ? 1 : 0;
        if (forms.compare(side, corners[2], corners[most]) > 0) most = 2;
        touches[static_cast<std::size_t>(side)] = most;
        result.site[static_cast<std::size_t>(side)] = corners[most];
    }
    // Counterclockwise after the open side: 0, 1, 2, from any of them.
    const auto fits = [&](std::size_t open) {
        const std::size_t first = touches[(open + 1) & 3];
        return touches[(open + 2) & 3] == (first + 1) % 3 &&
               touches[(open + 3) & 3] == (first + 2) % 3;
    };
    if (!fits(0) && !fits(1) && !fits(2) && !fits(3)) return result;
    const auto& at = result.site;
    const bool wide = forms.compare_widths(0, at[0], at[1], at[2], at[3]) > 0;
    for (int open = wide ? 1 : 0; open < 4; open += 2)
        if (fits(static_cast<std::size_t>(open))) result.open = open;
    return result;
}

/// Whether q (site 3 of the forms) meets the inside of the square that 0, 1 and 2 touch: +1, 0
/// where it touches, -1 where it stays outside.
template <class AnyForms>
[[nodiscard]] inline Sign meets(AnyForms& forms, const Touching& square) noexcept {
    constexpr std::size_t q = 3;
    Sign least = 1;
    for (int turn = 1; turn < 4; ++turn) {
        const int side = (square.open + turn) & 3;
        const Sign sign = forms.compare(side, square.site[static_cast<std::size_t>(side)], q);
        if (sign < 0) return sign;
        least = least < sign ? least : sign;
    }
    const auto at = [&](int turn) {
        return square.site[static_cast<std::size_t>((square.open + turn) & 3)];
    };
    // G_open - g_open(q), where G_open is the sum of its two neighbours less that of the opposite.
    const Sign sign = forms.compare_widths((square.open + 1) & 3, at(1), at(2), at(3), q);
    return least < sign ? least : sign;
}

/// The sign of twice the difference between the centres of two such squares in direction `side`.
template <class AnyForms>
[[nodiscard]] inline Sign compare_centres(AnyForms& forms, const Touching& a, const Touching& b,
                                          int side) noexcept {
    // Twice a centre is G_side less that of the opposite, where an open one is the sum of its two
    // neighbours less the other.
    std::array<typename AnyForms::Term, 8> terms{};
    std::size_t count = 0;
    for (const int factor : {1, -1}) {
        const Touching* const square = factor > 0 ? &a : &b;
        const auto add = [&](int at, int times) {
            terms[count++] = {at & 3, square->site[static_cast<std::size_t>(at & 3)], times};
        };
        const bool ahead = square->open == side;
        if (ahead || square->open == ((side + 2) & 3)) {
            const int sign = ahead ? factor : -factor;
            add(side + 1, sign);
            add(side + 3, sign);
            add(ahead ? side + 2 : side, -sign);
            add(ahead ? side + 2 : side, -sign);
        } else {
            add(side, factor);
            add(side + 2, -factor);
            terms[count++] = {0, 0, 0};
            terms[count++] = {0, 0, 0};
        }
    }
    return forms.compare_sum(terms);
}

/// The vertex at infinity of the hull edge a -> b: a quadrant between direction `side` and the next
/// one, bounded by b's reach to the one and a's to the other; side -1 where one hides the other.
/// Reach r + (direction d)·c is the negative of the form at the opposite side.
struct Quadrant {
    int side;
    std::size_t a;
    std::size_t b;
};
template <class AnyForms>
[[nodiscard]] inline Quadrant quadrant(AnyForms& forms, std::size_t a, std::size_t b) noexcept {
    for (int side = 0; side < 4; ++side)
        if (forms.compare(side, b, a) > 0 && forms.compare((side + 1) & 3, a, b) > 0)
            return {(side + 2) & 3, a, b};
    return {-1, a, b};
}

/// Whether x stands before y, counterclockwise from the first quadrant. In one quadrant their
/// corners follow one another by a's reach less b's.
template <class AnyForms>
[[nodiscard]] inline bool stands_before(AnyForms& forms, const Quadrant& x,
                                        const Quadrant& y) noexcept {
    if (x.side != y.side) return x.side < y.side;
    const int opposite = (x.side + 2) & 3;
    const int next = (x.side + 3) & 3;
    return forms.compare_sum(std::array<typename AnyForms::Term, 4>{
               {{next, x.a, 1}, {opposite, x.b, -1}, {next, y.a, -1}, {opposite, y.b, 1}}}) > 0;
}

/// How far a point is from the centre of a site.
template <class Directions, class Number>
[[nodiscard]] constexpr Number distance_to_centre(const Point& p, const Site& m) noexcept {
    using filters::magnitude;
    using filters::max;
    const Number x = Number(m.x) - Number(p.x);
    const Number y = Number(m.y) - Number(p.y);
    const auto along = [&](int side) {
        return magnitude(Number(Directions::x[side]) * x + Number(Directions::y[side]) * y);
    };
    return max(along(0), along(1));
}
static_assert(distance_to_centre<Manhattan, filters::RoundingCount>(Point{}, Site{}).roundings ==
              3);

/// The predicates of one of the two metrics under the tie rule: no answer is ever 0. `ranks` are
/// the places of the sites in the rule's order (falling radius, rising x, y, index); only their
/// order counts. Each is exact for all finite doubles and takes constant time. A conflict that is
/// `tied` is a touch without the rule.
template <class Directions, Arithmetic arithmetic = Arithmetic::exact>
struct Perturbed {
    static constexpr Arithmetic arithmetic_used = arithmetic;

    /// Whether i hides q: +1 or -1.
    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const std::array<Index, 2>& ranks) noexcept {
        Forms<Directions, arithmetic, 2> forms({&i, &q}, ranks);
        for (int side = 0; side < 4; ++side)
            if (forms.compare(side, 1, 0) < 0) return forms.decide(-1);
        return forms.decide(1);
    }

    /// Whether a square touches i, j, k counterclockwise: +1 or -1.
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&i, &j, &k}, ranks);
        return forms.decide(touching(forms).open >= 0 ? 1 : -1);
    }

    /// Whether q conflicts with the vertex of i, j, k: +1 or -1. Precondition: exists(i,j,k).
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&i, &j, &k, &q}, ranks);
        const Touching square = touching(forms);
        SIGNUM_EXPECTS(!is_exact(arithmetic) || square.open >= 0);
        forms.forget_ties();
        return forms.decide(square.open < 0 ? -1 : meets(forms, square));
    }
    /// The same where none of i, j, k hides q: what hidden ones do not meet needs no question here.
    [[nodiscard]] static Decision in_circle_of_visible(const Site& i, const Site& j, const Site& k,
                                                       const Site& q,
                                                       const std::array<Index, 4>& ranks) noexcept {
        return in_circle(i, j, k, q, ranks);
    }

    /// Whether q conflicts with the vertex at infinity of the hull edge a -> b (all other sites on
    /// its left), where it reaches into the quadrant: +1 or -1. Precondition: neither of a and b
    /// hides the other.
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&a, &b, &q}, ranks);
        const int side = quadrant(forms, 0, 1).side;
        SIGNUM_EXPECTS(!is_exact(arithmetic) || side >= 0);
        if (side < 0) return forms.decide(-1);
        forms.forget_ties();
        const bool conflict =
            forms.compare((side + 2) & 3, 1, 2) > 0 && forms.compare((side + 3) & 3, 0, 2) > 0;
        return forms.decide(conflict ? 1 : -1);
    }

    /// Whether squares touch i, j, k both counterclockwise and clockwise: +1 or -1.
    [[nodiscard]] static Decision exists_twice(const Site& i, const Site& j, const Site& k,
                                               const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&i, &j, &k}, ranks);
        const bool both = touching(forms).open >= 0 && touching(forms, {1, 0, 2}).open >= 0;
        return forms.decide(both ? 1 : -1);
    }

    /// Whether q's part of the bisector of i and j comes before k's, where k's runs from vertex
    /// (i,j,k) to (j,i,k): +1 or -1. Preconditions: each exists twice with i and j; k's part is an
    /// interval, q's or its complement one that k's does not meet.
    ///
    /// Along the bisector of sites that lie farther apart from left to right than in height, with i
    /// on the left, the centres of the circles rise (on its diagonal rays too); otherwise a quarter
    /// turn makes it so.
    [[nodiscard]] static Decision precedes_on_bisector(const Site& i, const Site& j, const Site& q,
                                                       const Site& k,
                                                       const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&i, &j, &q, &k}, ranks);
        const Touching of_q = touching(forms, {1, 0, 2});
        const Touching of_k = touching(forms, {1, 0, 3});
        SIGNUM_EXPECTS(!is_exact(arithmetic) || (of_q.open >= 0 && of_k.open >= 0));
        if (of_q.open < 0 || of_k.open < 0) return forms.decide(-1);
        // Twice the distance from i to j to the right and to the top; radii cancel.
        using Term = typename Forms<Directions, arithmetic, 4>::Term;
        const auto along = [](int side, int factor) {
            return std::array<Term, 4>{{{side, 1, factor},
                                        {side, 0, -factor},
                                        {side + 2, 1, -factor},
                                        {side + 2, 0, factor}}};
        };
        const Sign right = forms.compare_sum(along(0, 1));
        const Sign top = forms.compare_sum(along(1, 1));
        const auto width = along(0, right);
        const auto height = along(1, -top);
        const Sign wide = forms.compare_sum(std::array<Term, 8>{
            width[0], width[1], width[2], width[3], height[0], height[1], height[2], height[3]});
        // Counterclockwise from the direction in which j lies.
        const int side = wide >= 0 ? (right >= 0 ? 1 : 3) : (top >= 0 ? 2 : 0);
        return forms.decide(compare_centres(forms, of_q, of_k, side) < 0 ? 1 : -1);
    }

    /// Whether the arcs of k, q and l, directions in which each reaches farther than s, follow one
    /// another counterclockwise, those of k and l being disjoint, and q's or its complement, with
    /// `rest`, lying between them: +1 or -1.
    [[nodiscard]] static Decision in_order_at_infinity(const Site& s, const Site& k, const Site& q,
                                                       const Site& l, bool /*rest*/,
                                                       const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&s, &k, &q, &l}, ranks);
        // Where k's arc ends, and where those of q and l begin.
        const Quadrant first = quadrant(forms, 1, 0);
        const Quadrant second = quadrant(forms, 0, 2);
        const Quadrant third = quadrant(forms, 0, 3);
        const int falls = static_cast<int>(!stands_before(forms, first, second)) +
                          static_cast<int>(!stands_before(forms, second, third)) +
                          static_cast<int>(!stands_before(forms, third, first));
        return forms.decide(falls == 1 ? 1 : -1);
    }

    /// Whether the part of the horizon that belongs to s alone of s, k and l, counterclockwise from
    /// the hull edge k -> s to s -> l, contains direction 0: +1 or -1; k and l may be the same.
    [[nodiscard]] static Decision holds_first_direction(
        const Site& k, const Site& s, const Site& l, const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&k, &s, &l}, ranks);
        const Quadrant first = quadrant(forms, 0, 1);
        const Quadrant last = quadrant(forms, 1, 2);
        return forms.decide(stands_before(forms, last, first) ? 1 : -1);
    }

    /// How far the point p is from m, of three roundings, for additive::nearer.
    [[nodiscard]] static additive::Distance distance(const Point& p, const Site& m) noexcept {
        const Site site = filters::pinned(m);
        const Point point = filters::pinned(p);
        const double size =
            filters::magnitude(site.x - point.x) + filters::magnitude(site.y - point.y);
        return {distance_to_centre<Directions, double>(point, site), size, site.r};
    }

    /// Whether the point p is nearer to a than to b: +1 or -1.
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const std::array<Index, 2>& ranks) noexcept {
        if constexpr (predicates::is_filtered(arithmetic)) {
            const filters::Verdict verdict = additive::nearer(distance(p, a), distance(p, b));
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        } else if constexpr (!is_exact(arithmetic) || arithmetic == Arithmetic::interval) {
            const auto difference = rounded_distance(p, b) - rounded_distance(p, a);
            if (filters::exceeds(difference, 0.0)) [[likely]]
                return {filters::sign_of_nonzero(difference), Stage::filter};
        }
        Decision decision{0, Stage::filter};
        if constexpr (is_exact(arithmetic))
            decision = compare_distances<Directions, arithmetic>(p, a, b);
        if (decision.sign != 0) return decision;
        return {ranks[0] < ranks[1] ? 1 : -1, decision.stage, true};
    }

 private:
    using Number = predicates::NumberOf<arithmetic>;

    /// The distance itself, in an arithmetic that rounds.
    [[nodiscard]] static Number rounded_distance(const Point& p, const Site& m) noexcept {
        return distance_to_centre<Directions, Number>(p, m) - Number(m.r);
    }
};

/// in_circle without the tie rule: 0 where q touches the square. The square itself, of which there
/// may be many where sites are aligned, is the one that the tie rule tends to; `ranks` as above.
template <class Directions>
[[nodiscard]] inline Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                                 const Site& q,
                                                 const std::array<Index, 4>& ranks) noexcept {
    Forms<Directions, Arithmetic::exact, 4> forms({&i, &j, &k, &q}, ranks);
    const Touching square = touching(forms);
    SIGNUM_EXPECTS(square.open >= 0);
    forms.leave_ties();
    return forms.decide(meets(forms, square));
}

/// in_circle_infinite without the tie rule: 0 where q reaches just to the border of the quadrant.
template <class Directions>
[[nodiscard]] inline Decision in_circle_infinite_decision(
    const Site& a, const Site& b, const Site& q, const std::array<Index, 3>& ranks) noexcept {
    Forms<Directions, Arithmetic::exact, 3> forms({&a, &b, &q}, ranks);
    const int side = quadrant(forms, 0, 1).side;
    SIGNUM_EXPECTS(side >= 0);
    forms.leave_ties();
    const Sign first = forms.compare((side + 2) & 3, 1, 2);
    const Sign second = forms.compare((side + 3) & 3, 0, 2);
    return forms.decide(first < second ? first : second);
}

}  // namespace signum::rectangular

SIGNUM_IEEE_END
