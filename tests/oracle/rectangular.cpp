#include "rectangular.hpp"

#include "linear_form.hpp"
#include "sphere.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace signum::oracle {
namespace {

/// The four sides of a square, counterclockwise; also the four directions.
enum Side : std::size_t { right = 0, top = 1, left = 2, bottom = 3 };

/// A site of the supremum metric, its radius reduced by its infinitesimal; or, in rationals,
/// without.
template <class Number>
struct SquareOf {
    Number x;
    Number y;
    Number r;
};
using Square = SquareOf<LinearForm>;

/// A point of the plane and a distance.
template <class Number>
struct Circle {
    Number x;
    Number y;
    Number rho;
};

/// max(|x - X|, |y - Y|) - r
template <class Number>
Number distance(const SquareOf<Number>& site, const Number& x, const Number& y) {
    return std::max<Number>({x - site.x, site.x - x, y - site.y, site.y - y}) - site.r;
}

/// Where a side of the inscribed circle lies that the site touches from outside:
/// right is X + rho, top is Y + rho, left is X - rho, bottom is Y - rho.
template <class Number>
Number pinned(const SquareOf<Number>& site, std::size_t side) {
    if (side == right) return site.x - site.r;
    if (side == top) return site.y - site.r;
    if (side == left) return site.x + site.r;
    return site.y + site.r;
}

/// The circle with three of its sides where they are given: all but `open`.
template <class Number>
Circle<Number> solve(const std::array<Number, 4>& at, std::size_t open) {
    const Rational half(1, 2);
    if (open == top || open == bottom) {
        const Number rho = (at[right] - at[left]) * half;
        return {(at[right] + at[left]) * half, open == top ? at[bottom] + rho : at[top] - rho, rho};
    }
    const Number rho = (at[top] - at[bottom]) * half;
    return {open == right ? at[left] + rho : at[right] - rho, (at[top] + at[bottom]) * half, rho};
}

/// How far the site reaches in one of the four directions.
LinearForm reach(const Square& site, std::size_t direction) {
    if (direction == right) return site.r + site.x;
    if (direction == top) return site.r + site.y;
    if (direction == left) return site.r - site.x;
    return site.r - site.y;
}

/// Does a Voronoi edge leave for infinity between directions d and d + 1 (north-east: right and
/// top) with the cell of a on its right and that of b on its left, so that a -> b is an edge of the
/// hull, counterclockwise? Far out on that diagonal the distance to a site is smallest where the
/// smaller of its reaches (one of them shifted by a constant, which tells parallel diagonals apart)
/// is largest: b holds the one side of an infinite quadrant and a the other, each beyond the side
/// of the other, and no third site reaches into the quadrant.
bool is_hull_edge(const std::vector<Square>& sites, std::size_t a, std::size_t b, std::size_t d) {
    const std::size_t e = (d + 1) % 4;
    const LinearForm corner_d = reach(sites[b], d);
    const LinearForm corner_e = reach(sites[a], e);
    if (less(reach(sites[a], d), corner_d) || less(reach(sites[b], e), corner_e)) return false;
    for (std::size_t q = 0; q < sites.size(); ++q)
        if (q != a && q != b && less(corner_d, reach(sites[q], d)) &&
            less(corner_e, reach(sites[q], e)))
            return false;
    return true;
}

/// Whether the sites i, j, k touch a circle, each on its side and counterclockwise from the one
/// that is open, and no other site is as near. In rationals, without infinitesimals, as near is
/// allowed.
template <class Number>
bool is_face(const std::vector<SquareOf<Number>>& sites, std::size_t open, std::size_t i,
             std::size_t j, std::size_t k) {
    const std::size_t first = (open + 1) % 4, second = (open + 2) % 4, third = (open + 3) % 4;
    std::array<Number, 4> at;
    at[first] = pinned(sites[i], first);
    at[second] = pinned(sites[j], second);
    at[third] = pinned(sites[k], third);
    const Circle<Number> circle = solve(at, open);
    const auto farther = [&](std::size_t q) {
        return (distance(sites[q], circle.x, circle.y) - circle.rho).sign();
    };
    if (farther(i) != 0 || farther(j) != 0 || farther(k) != 0) return false;
    for (std::size_t q = 0; q < sites.size(); ++q) {
        if (q == i || q == j || q == k) continue;
        const int sign = farther(q);
        if (std::is_same_v<Number, Rational> ? sign < 0 : sign <= 0) {
            if (sign == 0) throw std::logic_error("oracle: the tie rule does not decide");
            return false;
        }
    }
    return true;
}

Tessellation tessellate(const std::vector<Square>& sites) {
    const auto number = [](std::size_t i) { return static_cast<std::int32_t>(i); };
    const std::size_t n = sites.size();
    Tessellation result;

    // A cell that is not empty contains the centre of its site.
    std::vector<bool> visible(n, true);
    for (std::size_t q = 0; q < n; ++q)
        for (std::size_t i = 0; i < n; ++i)
            if (i != q && less(distance(sites[i], sites[q].x, sites[q].y),
                               distance(sites[q], sites[q].x, sites[q].y)))
                visible[q] = false;

    std::vector<SquareOf<Rational>> values;
    for (const Square& site : sites)
        values.push_back({site.x.value(), site.y.value(), site.r.value()});

    // Finite faces: i, j, k touch three different sides, counterclockwise, and no other site is as
    // near. That the sides are different is no restriction: two sites on one side would be a tie.
    for (std::size_t open = 0; open < 4; ++open) {
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < n; ++k) {
                    if (i == j || j == k || k == i) continue;
                    // Forms take long, and their values alone tell most triples apart.
                    if (is_face(values, open, i, j, k) && is_face(sites, open, i, j, k))
                        result.faces.push_back(canonical({number(i), number(j), number(k)}));
                }
            }
        }
    }
    for (std::size_t d = 0; d < 4; ++d)
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b)
                if (a != b && is_hull_edge(sites, a, b, d))
                    result.faces.push_back(canonical({number(b), number(a), at_infinity}));
    std::sort(result.faces.begin(), result.faces.end());

    for (std::size_t q = 0; q < n; ++q) {
        if (visible[q]) continue;
        std::size_t by = n;
        for (std::size_t i = 0; i < n; ++i)
            if (visible[i] && (by == n || less(distance(sites[i], sites[q].x, sites[q].y),
                                               distance(sites[by], sites[q].x, sites[q].y))))
                by = i;
        result.hidden.push_back({number(q), number(by)});
    }
    check_sphere(result, visible);
    return result;
}

/// The tie order looks at the original x and y, whatever the coordinates of the metric are.
Ranks ranks_of(std::span<const signum::Site> sites) {
    std::vector<TieKey> keys;
    for (const signum::Site& site : sites)
        keys.push_back({exactly(site.r), exactly(site.x), exactly(site.y)});
    return tie_ranks(keys);
}

}  // namespace

Tessellation supremum(std::span<const signum::Site> sites, const Ranks& order) {
    const Ranks ranks = order.empty() ? ranks_of(sites) : order;
    std::vector<Square> squares;
    for (std::size_t i = 0; i < sites.size(); ++i)
        squares.push_back({LinearForm(exactly(sites[i].x)), LinearForm(exactly(sites[i].y)),
                           LinearForm(exactly(sites[i].r)) - LinearForm::infinitesimal(ranks[i])});
    return tessellate(squares);
}

/// |x| + |y| = max(|u|, |v|) with u = x + y and v = y - x, a rotation and a scaling.
Tessellation manhattan(std::span<const signum::Site> sites, const Ranks& order) {
    const Ranks ranks = order.empty() ? ranks_of(sites) : order;
    std::vector<Square> squares;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Rational x = exactly(sites[i].x), y = exactly(sites[i].y);
        squares.push_back({LinearForm(x + y), LinearForm(y - x),
                           LinearForm(exactly(sites[i].r)) - LinearForm::infinitesimal(ranks[i])});
    }
    return tessellate(squares);
}

}  // namespace signum::oracle
