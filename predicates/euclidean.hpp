#pragma once
/// The predicates of the additively weighted Euclidean metric (discs, Apollonius): distance
/// |x-c| - r.
///
/// Sites are signum::Site, discs of any finite radii, negative ones included: only differences of
/// radii matter. They may intersect, touch, nest and coincide.
///
/// Each predicate asks a filter first (euclidean/filter.hpp). Behind it stand exact numbers and
/// polynomials without a square root (euclidean/exact.cpp). Sites of the same radius the metric
/// orders as Delaunay does: under the tie rule their in_circle is that of points, of lower degree.
/// Source: the identities of formulas/apollonius.hpp; the tie rule is decided at first order.

#include <array>

#include "../core/contract.hpp"
#include "../core/index.hpp"
#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "../filters/tally.hpp"
#include "additive.hpp"
#include "ccw.hpp"
#include "euclidean/filter.hpp"
#include "power/in_circle.hpp"
#include "power/ties.hpp"

namespace signum::euclidean {

/// What stands behind the filters: with Arithmetic::exact in exact arithmetic, with the others all
/// that they have. Signs, preconditions and ranks are those of the functions of Perturbed.
namespace cold {

template <std::size_t n>
using Ranks = std::array<Index, n>;

[[nodiscard, gnu::cold, gnu::pure]] Decision hides(Arithmetic arithmetic, const Site& i,
                                                   const Site& q, const Ranks<2>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision nearer(Arithmetic arithmetic, const Point& p,
                                                    const Site& a, const Site& b,
                                                    const Ranks<2>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision exists(Arithmetic arithmetic, const Site& i,
                                                    const Site& j, const Site& k,
                                                    const Ranks<3>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision exists_twice(Arithmetic arithmetic, const Site& i,
                                                          const Site& j, const Site& k,
                                                          const Ranks<3>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision precedes_on_bisector(Arithmetic arithmetic,
                                                                  const Site& i, const Site& j,
                                                                  const Site& q,
                                                                  const Site& k) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision in_circle(Arithmetic arithmetic, const Site& i,
                                                       const Site& j, const Site& k, const Site& q,
                                                       const Ranks<4>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision in_circle_infinite(Arithmetic arithmetic,
                                                                const Site& a, const Site& b,
                                                                const Site& q,
                                                                const Ranks<3>& ranks) noexcept;
/// Whether a reaches farther in the direction of rising x than b, of which it is no equal in the
/// tie rule's order.
[[nodiscard, gnu::cold, gnu::pure]] Decision reaches_farther(Arithmetic arithmetic, const Site& a,
                                                             const Site& b,
                                                             bool a_precedes_b) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision turn(Arithmetic arithmetic, const Site& a,
                                                  const Site& b, const Site& c) noexcept;

}  // namespace cold

/// Whether all radii are the same number, also where the hardware reads denormals as zero.
template <class... Others>
[[nodiscard]] inline bool same_radius(const Site& first, const Others&... others) noexcept {
    return ((first.r == others.r) && ...) && (filters::same_number(first.r, others.r) && ...);
}

/// The predicates under the tie rule: no answer is ever 0. `ranks` are the places of the sites in
/// the rule's order (falling radius, rising x, y, index); only their order counts. Each is exact
/// for all finite doubles, in every floating-point environment, and takes constant time.
template <Arithmetic arithmetic = Arithmetic::exact>
struct Perturbed {
    /// By what arithmetic; see predicates/arithmetic.hpp.
    static constexpr Arithmetic arithmetic_used = arithmetic;

    /// Whether i hides q, |c_i - c_q| <= r_i - r_q: +1 or -1.
    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const std::array<Index, 2>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::hides(i, q);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return cold::hides(arithmetic, i, q, ranks);
    }

    /// Whether a circle touches i, j, k counterclockwise: +1 or -1.
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::exists(i, j, k);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return cold::exists(arithmetic, i, j, k, ranks);
    }

    /// Whether a circle touches i, j, q counterclockwise and another one clockwise: +1 or -1. Then
    /// the part of the bisector of i and j that is nearer to q is an interval with two ends, or the
    /// complement of one.
    [[nodiscard]] static Decision exists_twice(const Site& i, const Site& j, const Site& q,
                                               const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (same_radius(i, j, q))
                return {-1, Stage::filter};  // Q = -C²; a middle one is not last
            const auto verdict = filter::exists_twice(i, j, q);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::exists_twice<Number>(i, j, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::exists_twice(arithmetic, i, j, q, ranks);
    }

    /// The order of two intervals on the bisector of i and j, walked with i on the left (in the
    /// direction in which k's part runs from vertex (i,j,k) to (j,i,k)): +1 where that of q comes
    /// before that of k, otherwise -1. The interval of k is the part that is nearer to k; that of q
    /// is the part that is nearer to q or, where that goes through infinity, the rest.
    /// Preconditions: exists_twice(i,j,q) and (i,j,k), k's part is an interval, both are disjoint.
    [[nodiscard]] static Decision precedes_on_bisector(
        const Site& i, const Site& j, const Site& q, const Site& k,
        const std::array<Index, 4>& /*ranks*/) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::precedes_on_bisector(i, j, q, k);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return cold::precedes_on_bisector(arithmetic, i, j, q, k);
    }

    /// Whether q conflicts with the vertex of i, j, k: +1 or -1. Precondition: exists(i,j,k).
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(i, j, k, q))
                return in_circle_of_points(i, j, k, q, ranks);
            const auto verdict = filter::in_circle(i, j, k, q);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::in_circle<Number>(i, j, k, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::in_circle(arithmetic, i, j, k, q, ranks);
    }

    /// The same where none of i, j, k hides q, which is not asked then.
    [[nodiscard, gnu::always_inline]] static Decision in_circle_of_visible(
        const Site& i, const Site& j, const Site& k, const Site& q,
        const std::array<Index, 4>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(i, j, k, q))
                return in_circle_of_points(i, j, k, q, ranks);
            const auto verdict = filter::in_circle_of_visible(i, j, k, q);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return in_circle(i, j, k, q, ranks);
    }

    /// Whether q conflicts with the vertex at infinity of the hull edge a -> b: a line has first a
    /// and then b on its left and touches both, and q reaches across it. +1 or -1. Precondition:
    /// neither of a and b hides the other.
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(a, b, q))
                return in_circle_infinite_of_points(a, b, q, ranks);
            const auto verdict = filter::in_circle_infinite(a, b, q);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::in_circle_infinite<Number>(a, b, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::in_circle_infinite(arithmetic, a, b, q, ranks);
    }

    /// The cyclic order of three arcs of directions around s: +1 where they come in the order k, q,
    /// l counterclockwise, otherwise -1. The arc of m are the directions in which m reaches farther
    /// than s; its middle is that of c_m - c_s. With `rest` q's arc is replaced by the rest of the
    /// circle. Preconditions: the three arcs are disjoint; s hides none of the three, none hides s.
    ///
    /// Law: of the turns from a to b, b to c and c to a of three different directions in
    /// counterclockwise order at least two are less than half a circle, and one less than two if
    /// they are in the other order.
    [[nodiscard]] static Decision in_order_at_infinity(
        const Site& s, const Site& k, const Site& q, const Site& l, bool rest,
        const std::array<Index, 4>& /*ranks*/) noexcept {
        const Sign side = rest ? -1 : 1;
        const Decision to_q = turn(s, k, q);
        const Decision from_q = turn(s, q, l);
        const Stage stage = to_q.stage < from_q.stage ? from_q.stage : to_q.stage;
        const Sign sum = side * (to_q.sign + from_q.sign);
        if (sum != 0) return {sum > 0 ? 1 : -1, stage};
        const Decision back = turn(s, l, k);
        return {back.sign > 0 ? 1 : -1, stage < back.stage ? back.stage : stage};
    }

    /// Whether the part of the horizon that belongs to s alone of s, k and l, counterclockwise from
    /// the hull edge k -> s to s -> l, contains the direction of rising x: +1 or -1; k and l may be
    /// the same.
    ///
    /// Law: neither k nor l reaches farther in it; and if their arcs are disjoint, so that there
    /// are two such parts, it comes between the middle of k's arc and the middle of l's.
    [[nodiscard]] static Decision holds_first_direction(
        const Site& k, const Site& s, const Site& l, const std::array<Index, 3>& ranks) noexcept {
        Stage stage = Stage::filter;
        const auto is_positive = [&stage](const Decision& decision) {
            if (stage < decision.stage) stage = decision.stage;
            return decision.sign > 0;
        };
        if (is_positive(cold::reaches_farther(arithmetic, k, s, ranks[0] < ranks[1])) ||
            is_positive(cold::reaches_farther(arithmetic, l, s, ranks[2] < ranks[1])))
            return {-1, stage};
        if (ranks[0] == ranks[2] ||
            is_positive(in_circle_infinite(s, k, l, {ranks[1], ranks[0], ranks[2]})) ||
            is_positive(in_circle_infinite(l, s, k, {ranks[2], ranks[1], ranks[0]})))
            return {1, stage};
        const Sign sum = filters::compare_numbers(s.y, k.y) + filters::compare_numbers(l.y, s.y);
        const bool holds = sum != 0 ? sum > 0 : is_positive(turn(s, l, k));
        return {holds ? 1 : -1, stage};
    }

    /// How far the point p is from m, for additive::nearer.
    [[nodiscard]] static additive::Distance distance(const Point& p, const Site& m) noexcept {
        return filter::distance(p, m);
    }

    /// Whether the point p is nearer to a than to b: +1 or -1.
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const std::array<Index, 2>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::nearer(p, a, b);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::nearer<Number>(p, a, b);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::nearer(arithmetic, p, a, b, ranks);
    }

 private:
    static constexpr bool is_filtered = predicates::is_filtered(arithmetic);
    /// Predicates of points have exact stages of their own, which a judge does not believe.
    static constexpr bool asks_points = arithmetic == Arithmetic::exact;
    using Number = predicates::NumberOf<arithmetic>;

    /// Of equal radii only equal sites hide one another, and the circle exists where ccw > 0.
    [[nodiscard]] static Decision in_circle_of_points(const Site& i, const Site& j, const Site& k,
                                                      const Site& q,
                                                      const std::array<Index, 4>& ranks) noexcept {
        const auto centre = [](const Site& m) -> Point { return {m.x, m.y}; };
        const Decision decision =
            power::in_circle_decision(centre(i), centre(j), centre(k), centre(q));
        if (decision.sign != 0) [[likely]]
            return decision;
        return {power::in_circle_tie(centre(i), centre(j), centre(k), centre(q), ranks),
                decision.stage, true};
    }

    /// Of equal radii only ccw counts, and on the line whether q lies strictly between a and b: the
    /// last of the three in the order, by rising x and y, is at an end. Of equal sites the first
    /// hides the other.
    [[nodiscard]] static Decision in_circle_infinite_of_points(
        const Site& a, const Site& b, const Site& q, const std::array<Index, 3>& ranks) noexcept {
        const Decision side = ccw_decision(a, b, q);
        if (side.sign != 0) [[likely]]
            return {-side.sign, side.stage};
        const auto order = [](const Site& m, const Site& n) {
            const Sign by_x = filters::compare_numbers(m.x, n.x);
            return by_x != 0 ? by_x : filters::compare_numbers(m.y, n.y);
        };
        const Sign from_a = order(a, q);
        const Sign to_b = order(q, b);
        const bool conflict = from_a == 0 ? ranks[2] < ranks[0]
                              : to_b == 0 ? ranks[2] < ranks[1]
                                          : from_a == to_b;
        return {conflict ? 1 : -1, side.stage, true};
    }

    [[nodiscard]] static Decision turn(const Site& a, const Site& b, const Site& c) noexcept {
        if constexpr (arithmetic == Arithmetic::exact) return ccw_decision(a, b, c);
        if constexpr (is_filtered) {
            const auto verdict = predicates::ccw_filter(a, b, c);
            if (verdict.is_certain()) [[likely]]
                return {verdict.sign(), Stage::filter};
        }
        return cold::turn(arithmetic, a, b, c);
    }
};

/// in_circle without the tie rule: 0 where q touches the circle. Preconditions: i, j, k exist under
/// the tie rule, and none of them hides q. The radius may be infinite where they exist under the
/// tie rule alone, for which `ranks` are needed.
[[nodiscard]] Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                          const Site& q,
                                          const std::array<Index, 4>& ranks) noexcept;

/// in_circle_infinite without the tie rule: 0 where q touches the line.
[[nodiscard]] Decision in_circle_infinite_decision(const Site& a, const Site& b,
                                                   const Site& q) noexcept;

// ---- what users call ---------------------------------------------------------------------------
// The meanings stand at the templates in additive.hpp.

/// Whether a circle touches i, j, k counterclockwise, ties decided by the tie rule.
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    return additive::exists<Perturbed<>>(i, j, k);
}
/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise.
inline constexpr auto& in_circle = additive::in_circle<in_circle_decision>;
/// The same at the hull edge a -> b; no tie rule makes this line.
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    return in_circle_infinite_decision(a, b, q).sign;
}
/// Whether i alone hides q.
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return additive::hidden<Perturbed<>>(q, i);
}
/// Which of two sites is nearer to a point.
inline constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
/// Under the tie rule, never 0.
inline constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
/// Under the tie rule, never 0.
inline constexpr auto& in_circle_infinite_perturbed =
    additive::in_circle_infinite_perturbed<Perturbed<>>;

}  // namespace signum::euclidean
