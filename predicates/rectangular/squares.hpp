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

#include <signum/core/contract.hpp>
#include <signum/core/index.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>
#include <signum/predicates/rectangular/forms.hpp>

namespace signum::rectangular {

/// The side of an inscribed square that no site touches, and who touches the others (in the open
/// place: who comes nearest).
struct Touching {
    int open;  ///< -1 where there is no such square
    std::array<std::size_t, 4> site;
};

/// The square that sites 0, 1, 2 of the forms touch counterclockwise, under the tie rule.
template <class AnyForms>
[[nodiscard]] inline Touching touching(AnyForms& forms) noexcept {
    Touching result{-1, {}};
    auto& touches = result.site;
    for (int side = 0; side < 4; ++side) {
        std::size_t most = forms.compare(side, 1, 0) > 0 ? 1 : 0;
        if (forms.compare(side, 2, most) > 0) most = 2;
        touches[static_cast<std::size_t>(side)] = most;
    }
    // Counterclockwise after the open side: 0, 1, 2, from any of them.
    const auto fits = [&](std::size_t open) {
        const std::size_t first = touches[(open + 1) & 3];
        return touches[(open + 2) & 3] == (first + 1) % 3 &&
               touches[(open + 3) & 3] == (first + 2) % 3;
    };
    if (!fits(0) && !fits(1) && !fits(2) && !fits(3)) return result;
    const bool wide = forms.compare_widths(0, touches[0], touches[1], touches[2], touches[3]) > 0;
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

/// A distance from a point, rounded, and the sum of the magnitudes that entered.
struct Distance {
    double value;
    double magnitude;
};
template <class Directions>
[[nodiscard]] inline Distance distance(const Point& p, const Site& m) noexcept {
    const double x = m.x - p.x;
    const double y = m.y - p.y;
    const double first = filters::magnitude(Directions::x[0] * x + Directions::y[0] * y);
    const double second = filters::magnitude(Directions::x[1] * x + Directions::y[1] * y);
    return {(first < second ? second : first) - m.r,
            (filters::magnitude(x) + filters::magnitude(y)) + filters::magnitude(m.r)};
}

/// The predicates of one of the two metrics under the tie rule: no answer is ever 0. `ranks` are
/// the places of the sites in the rule's order (falling radius, rising x, y, index); only their
/// order counts. Each is exact for all finite doubles and takes constant time.
template <class Directions, Sums sums = Sums::exact>
struct Perturbed {
    /// Whether i hides q: +1 or -1.
    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const std::array<Index, 2>& ranks) noexcept {
        Forms<Directions, sums, 2> forms({&i, &q}, ranks);
        for (int side = 0; side < 4; ++side)
            if (forms.compare(side, 1, 0) < 0) return forms.decide(-1);
        return forms.decide(1);
    }

    /// Whether a square touches i, j, k counterclockwise: +1 or -1.
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, sums, 3> forms({&i, &j, &k}, ranks);
        return forms.decide(touching(forms).open >= 0 ? 1 : -1);
    }

    /// Whether q conflicts with the vertex of i, j, k: +1 or -1. Precondition: exists(i,j,k).
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, sums, 4> forms({&i, &j, &k, &q}, ranks);
        const Touching square = touching(forms);
        SIGNUM_EXPECTS(sums == Sums::naive || square.open >= 0);
        return forms.decide(square.open < 0 ? -1 : meets(forms, square));
    }

    /// Whether q conflicts with the vertex at infinity of the hull edge a -> b (all other sites on
    /// its left): +1 or -1. The vertex is a quadrant between two directions d and d+1, bounded by
    /// b's reach to d and a's to d+1; q conflicts where it reaches into it. Precondition: neither
    /// of a and b hides the other.
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, sums, 3> forms({&a, &b, &q}, ranks);
        // Reach r + (direction d)·c is the negative of the form at the opposite side.
        for (int side = 0; side < 4; ++side) {
            const int next = (side + 1) & 3;
            if (forms.compare(side, 1, 0) < 0 || forms.compare(next, 0, 1) < 0) continue;
            const bool conflict = forms.compare(side, 1, 2) > 0 && forms.compare(next, 0, 2) > 0;
            return forms.decide(conflict ? 1 : -1);
        }
        SIGNUM_EXPECTS(sums == Sums::naive);
        return forms.decide(-1);
    }

    /// Whether the point p is nearer to a than to b: +1 or -1.
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const std::array<Index, 2>& ranks) noexcept {
        // Three roundings a distance and one for their difference, none of more than the sum of the
        // magnitudes.
        const Distance to_a = distance<Directions>(p, a);
        const Distance to_b = distance<Directions>(p, b);
        const double difference = to_b.value - to_a.value;
        const double bound = 5 * filters::epsilon * (to_a.magnitude + to_b.magnitude);
        if (sums == Sums::exact && filters::magnitude(difference) > bound &&
            filters::environment_is_default()) [[likely]]
            return {filters::sign_of_nonzero(difference), Stage::filter};
        if (sums == Sums::naive && difference != 0.0) return {sign_of(difference), Stage::filter};
        const Sign sign = sums == Sums::naive ? 0 : compare_distances<Directions, sums>(p, a, b);
        constexpr Stage stage = sums == Sums::multiprecision ? Stage::multiprecision : Stage::exact;
        if (sign != 0) return {sign, stage};
        return {ranks[0] < ranks[1] ? 1 : -1, stage, true};
    }
};

/// in_circle without the tie rule: 0 where q touches the square. The square itself, of which there
/// may be many where sites are aligned, is the one that the tie rule tends to; `ranks` as above.
template <class Directions>
[[nodiscard]] inline Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                                 const Site& q,
                                                 const std::array<Index, 4>& ranks) noexcept {
    Forms<Directions, Sums::exact, 4> forms({&i, &j, &k, &q}, ranks);
    const Touching square = touching(forms);
    SIGNUM_EXPECTS(square.open >= 0);
    forms.leave_ties();
    return forms.decide(meets(forms, square));
}

}  // namespace signum::rectangular
