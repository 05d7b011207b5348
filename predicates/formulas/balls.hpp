#pragma once
/// The polynomials that decide about balls in the metric |x-c| - r, for any dimension d and numbers
/// of any type: the plane's (predicates/formulas/apollonius.hpp) said once for all d.
///
/// Relative to the first of d+1 balls each of the others, and q, is a row (X, R, p) of d+2 numbers:
/// its centre, its radius and p = X·X - R². Of the d rows of the others E_k is the minor without
/// column k of (X, R), and E'_k that without column k and R, but with p; of all d+1 rows, q's the
/// last, D_k the one without k, but with p, and L the one of (X, R). With <E,D> = Σ E_k D_k - E_R
/// D_R, k along the axes,
///     Q = <E,E>    A = -<E,D>    G = <D,D>    B = Σ E_k E'_k
///     Γ = 1/2 det [p_ab] in the plane,  -1/4 det [p_ab] in space, of the d+1 balls alone.
///
/// Laws:
///  1. a sphere (c, rho) touches ball m from outside where |c - c_m| = rho + r_m >= 0. Of the two
///     that may touch d+1 balls that one whose points of contact are positively oriented (they turn
///     left; ccw of four > 0) has rho + r_i = (B - E_R √Γ) / 2Q;
///  2. with s = |c - c_q|² - (rho + r_q)² of this sphere, Q s = L √Γ - A; and where Q = 0, so that
///     the other one has gone to infinity, 2 L √Γ s = -G;
///  3. A² - L² Γ = Q G and B² - E_R² Γ = Q Σ E'_k², so that Q, A, L, G (of degrees 2d, 2d+2, d+1
///     and 2d+4), B and E_R have all the signs needed;
///  4. where all p_ab > 0, none of the balls inside another, rho + r_m has the same sign for all m.
///     Γ = 4 Δ² for the determinant Δ of the rows (c_m - c, rho + r_m): 0 where the points of
///     contact lie in one plane (on a line), less than 0 where no sphere touches all. It is enough
///     that p_ib > 0 for one ball i and all others: where Γ > 0 there is a sphere, so that rho +
///     r_m has one sign, by p_ib, and then no p_ab is below 0; where one is 0, Γ is a product with
///     it in the plane, and in space, p_ij = 0, -1/4 (p_ik p_jl - p_il p_jk)²: not above 0;
///  5. a ball i that hides q, |c_i - c_q| <= r_i - r_q, keeps it from a conflict: |c - c_q| >=
///     |c - c_i| - |c_i - c_q| >= rho + r_q. So if s < 0, that is |c - c_q| < |rho + r_q|, and i
///     hides q, then rho + r_q < 0, and |c_m - c_q| <= |c - c_m| + |c - c_q| < r_m - r_q for all m:
///     all hide q, or none does. If s = 0 and rho + r_q < 0, all hide q in the same way, and all
///     but one without touching it, for what touches it lies in the direction away from q. If s =
///     0 and rho + r_q >= 0, whoever hides q touches it. So of two balls one hides q without
///     touching it where rho + r_q < 0, and none does otherwise.
/// Laws 1 to 3 were checked in rationals for d = 2, 3, 4, 5; balls_predicates_test.cpp does so for
/// 2 and 3, and holds the signs against spheres that are solved for.

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "../../core/sign.hpp"
#include "apollonius.hpp"

namespace signum::euclidean::balls {

using polynomials::sign;

/// The numbers of a ball: its centre and its radius, r the last.
template <std::size_t d, class Number>
using Ball = std::array<Number, d + 1>;

/// X, R and p.
template <std::size_t d, class Number>
using Row = std::array<Number, d + 2>;

/// X·X - R²
template <std::size_t d, class Product, class Numbers>
[[nodiscard]] constexpr Product power_of(const Numbers& a) {
    const auto squares = [&]<std::size_t... k>(std::index_sequence<k...>) {
        return (... + (a[k] * a[k]));
    };
    return squares(std::make_index_sequence<d>()) - a[d] * a[d];
}

template <std::size_t d, class Number>
[[nodiscard]] constexpr Row<d, Number> row(const Ball<d, Number>& m, const Ball<d, Number>& from) {
    Row<d, Number> result{};
    const auto subtract = [&]<std::size_t... k>(std::index_sequence<k...>) {
        ((result[k] = m[k] - from[k]), ...);
    };
    subtract(std::make_index_sequence<d + 1>());
    result[d + 1] = power_of<d, Number>(result);
    return result;
}

/// The minors of a few rows of numbers, one for each set of as many columns. A set is its bits.
template <std::size_t columns, std::size_t rows, class Number>
class Minors {
 public:
    using Numbers = std::array<Number, columns>;
    using Fewer = Minors<columns, rows - 1, Number>;

    /// Of one row: its numbers.
    explicit constexpr Minors(const Numbers& row) requires(rows == 1) : minors_(row) {}
    /// Of one row more, which is the last.
    constexpr Minors(const Fewer& others, const Numbers& row) requires(rows > 1)
        : Minors(others, row, std::make_index_sequence<count>()) {}

    template <unsigned set>
    [[nodiscard]] constexpr const Number& of() const {
        static_assert(std::popcount(set) == rows && set >> columns == 0);
        return minors_[place_of(set)];
    }

 private:
    static constexpr unsigned sets = 1U << columns;
    [[nodiscard]] static constexpr std::size_t place_of(unsigned set) {
        std::size_t place = 0;
        for (unsigned other = 0; other < set; ++other) place += std::popcount(other) == rows;
        return place;
    }
    static constexpr std::size_t count = place_of(sets);
    [[nodiscard]] static constexpr unsigned set_at(std::size_t place) {
        unsigned set = (1U << rows) - 1;
        while (place_of(set) != place || std::popcount(set) != rows) ++set;
        return set;
    }

    template <std::size_t... n>
    constexpr Minors(const Fewer& others, const Numbers& row, std::index_sequence<n...>)
        : minors_{expanded<set_at(n)>(others, row)...} {}

    /// By the last row, from the last column on: signs alternate.
    template <unsigned set, unsigned rest = set>
    [[nodiscard]] static constexpr Number expanded(const Fewer& others, const Numbers& row) {
        constexpr unsigned last = std::bit_floor(rest);
        if constexpr (rest == last) {
            return others.template of<set ^ last>() * row[std::countr_zero(last)];
        } else {
            return others.template of<set ^ last>() * row[std::countr_zero(last)] -
                   expanded<set, rest ^ last>(others, row);
        }
    }

    std::array<Number, count> minors_;
};

/// The columns of X, those of (X, R), and that of p.
template <std::size_t d>
inline constexpr unsigned axes = (1U << d) - 1;
template <std::size_t d>
inline constexpr unsigned all = (1U << (d + 1)) - 1;
template <std::size_t d>
inline constexpr unsigned last = 1U << (d + 1);

/// <E,E>, <E,D> and <D,D>: a and b are minors of d rows, or of d+1, then with p.
template <std::size_t d, class Product, unsigned with_a, unsigned with_b, class A, class B>
[[nodiscard]] constexpr Product inner(const A& a, const B& b) {
    const auto term = [&]<unsigned without>(std::integral_constant<unsigned, without>) -> Product {
        return Product(a.template of<(all<d> ^ without) | with_a>()) *
               Product(b.template of<(all<d> ^ without) | with_b>());
    };
    const auto sum = [&]<unsigned... k>(std::integer_sequence<unsigned, k...>)->Product {
        return (... + term(std::integral_constant<unsigned, 1U << k>()));
    };
    return sum(std::make_integer_sequence<unsigned, d>()) -
           term(std::integral_constant<unsigned, 1U << d>());
}

/// What d+1 balls decide alone. The minors are of one type of number, products of two minors of
/// another, which may be the same.
template <std::size_t d, class Number, class ProductOfTwo = Number>
struct Tuple {
    static_assert(d == 2 || d == 3);
    using Product = ProductOfTwo;
    using Of = Minors<d + 2, d, Number>;

    std::array<Row<d, Number>, d> rows;
    Of e;

    explicit constexpr Tuple(const std::array<Row<d, Number>, d>& to_first)
        : rows(to_first), e(minors_of(rows)) {}
    template <std::size_t n>
    explicit constexpr Tuple(const std::array<Ball<d, Number>, n>& b) : Tuple(rows_of(b)) {}

    [[nodiscard]] constexpr const Number& e_r() const { return e.template of<axes<d>>(); }
    [[nodiscard]] constexpr Product q() const { return inner<d, Product, 0, 0>(e, e); }
    [[nodiscard]] constexpr Product b() const {
        constexpr unsigned r = 1U << d;
        const auto sum = [&]<unsigned... k>(std::integer_sequence<unsigned, k...>)->Product {
            return (... + (Product(e.template of<all<d> ^ (1U << k)>()) *
                           Product(e.template of<(all<d> ^ (1U << k) ^ r) | last<d>>())));
        };
        return sum(std::make_integer_sequence<unsigned, d>());
    }

 private:
    template <std::size_t n>
    [[nodiscard]] static constexpr auto rows_of(const std::array<Ball<d, Number>, n>& b) {
        if constexpr (d == 2) {
            return std::array{row<d, Number>(b[1], b[0]), row<d, Number>(b[2], b[0])};
        } else {
            return std::array{row<d, Number>(b[1], b[0]), row<d, Number>(b[2], b[0]),
                              row<d, Number>(b[3], b[0])};
        }
    }
    [[nodiscard]] static constexpr Of minors_of(const std::array<Row<d, Number>, d>& rows) {
        const Minors<d + 2, 2, Number> two(Minors<d + 2, 1, Number>(rows[0]), rows[1]);
        if constexpr (d == 2) {
            return two;
        } else {
            return Of(two, rows[2]);
        }
    }
};

/// The rows of the others relative to one another: j to k in the plane; j to k and l, and k to l.
template <std::size_t d, class Number, std::size_t n>
[[nodiscard]] constexpr auto rows_between(const std::array<Ball<d, Number>, n>& b) {
    if constexpr (d == 2) {
        return std::array<Row<d, Number>, 1>{row<d, Number>(b[2], b[1])};
    } else {
        return std::array{row<d, Number>(b[2], b[1]), row<d, Number>(b[3], b[1]),
                          row<d, Number>(b[3], b[2])};
    }
}

/// 4Γ, from the rows to the first ball and those between the others.
template <std::size_t d, class Product, class Rows, class Between>
[[nodiscard]] constexpr Product four_gamma(const Rows& to, const Between& between) {
    const auto p = [](const auto& row) -> const auto& {
        return row[d + 1];
    };
    const auto twice = [](const auto& number) { return Product(number) + Product(number); };
    if constexpr (d == 2) {
        return Product(p(between[0])) * (twice(p(to[0])) * twice(p(to[1])));
    } else {
        const Product a = Product(p(to[0])) * Product(p(between[2]));
        const Product b = Product(p(to[1])) * Product(p(between[1]));
        const Product c = Product(p(to[2])) * Product(p(between[0]));
        const Product rest = (a - b) - c;
        return twice(b) * twice(c) - rest * rest;
    }
}

/// What d+1 balls and q decide: the minors with q's row.
template <std::size_t d, class Number>
using WithQuery = Minors<d + 2, d + 1, Number>;

template <std::size_t d, class Number>
[[nodiscard]] constexpr const Number& l(const WithQuery<d, Number>& with_q) {
    return with_q.template of<all<d>>();
}
/// -A
template <class Product, std::size_t d, class Number>
[[nodiscard]] constexpr Product minus_a(const Tuple<d, Number, Product>& t,
                                        const WithQuery<d, Number>& with_q) {
    return inner<d, Product, 0, last<d>>(t.e, with_q);
}

// ---- the questions -----------------------------------------------------------------------------

/// Whether i hides q, from q's row relative to i: +1 or -1.
template <std::size_t d, class Number>
[[nodiscard]] Sign hides(const Row<d, Number>& q) {
    return sign(q[d]) <= 0 && sign(q[d + 1]) <= 0 ? 1 : -1;
}

/// Whether a sphere touches the balls so that the points of contact are positively oriented: +1 or
/// -1. With law 4 it touches all of them from outside where it does so the first. Where Q < 0 one
/// root is positive, by law 3; where Q > 0 none is or both are, and where Q = 0 the one at infinity
/// is not the one that is asked for.
template <std::size_t d, class Product, class Number>
[[nodiscard]] Sign exists(const std::array<Ball<d, Number>, d + 1>& balls) {
    const Tuple<d, Number, Product> t(balls);
    for (const auto& row : t.rows)
        if (sign(row[d + 1]) <= 0) return -1;
    const auto between = rows_between<d, Number>(balls);
    if (sign(four_gamma<d, Product>(t.rows, between)) <= 0) return -1;
    const Sign of_q = sign(t.q());
    if (of_q <= 0 && sign(t.e_r()) <= 0) return -1;
    return of_q < 0 || sign(t.b()) > 0 ? 1 : -1;
}

/// +1 where the last ball conflicts with the sphere that touches the others, 0 where it touches, -1
/// otherwise. Precondition: that sphere exists.
template <std::size_t d, class Product, class Number>
[[nodiscard]] Sign in_sphere(const std::array<Ball<d, Number>, d + 2>& balls) {
    const Tuple<d, Number, Product> t(balls);
    const Row<d, Number> q = row<d, Number>(balls[d + 1], balls[0]);
    const WithQuery<d, Number> with_q(t.e, q);
    const auto sign_of_g = [&] {
        return sign(inner<d, Product, last<d>, last<d>>(with_q, with_q));
    };
    // The opposite of the sign of s: law 2. Where L = 0, too, q's row is a sum of multiples of the
    // others, and s the same sum of their p taken from its own.
    Sign conflict = 0;
    const Sign of_l = sign(l<d, Number>(with_q));
    const Sign of_q = sign(t.q());
    if (of_q != 0) {
        const Sign of_a = -sign(minus_a<Product, d, Number>(t, with_q));
        conflict =
            of_q * polynomials::sign_of_difference(of_a, of_l, [&] { return of_q * sign_of_g(); });
    } else if (of_l != 0) {
        conflict = of_l * sign_of_g();
    } else {
        conflict = -sign(t.e_r()) * sign(with_q.template of<axes<d> | last<d>>());
    }
    // Law 5.
    const auto is_inside = [](const Row<d, Number>& m) {
        return sign(m[d]) < 0 && sign(m[d + 1]) < 0;
    };
    if (conflict > 0) return hides<d, Number>(q) > 0 ? -1 : 1;
    if (conflict == 0 && (is_inside(q) || is_inside(row<d, Number>(balls[d + 1], balls[1]))))
        return -1;
    return conflict;
}

}  // namespace signum::euclidean::balls
