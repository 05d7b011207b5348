#include "rectangular.hpp"

#include "linear_form.hpp"
#include "sphere.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace signum::oracle {
namespace {

/// The four sides of a square, counterclockwise; also the four directions.
enum Side : std::size_t { right = 0, top = 1, left = 2, bottom = 3 };

/// A site of the supremum metric, its radius reduced by its infinitesimal.
struct Square {
    LinearForm x;
    LinearForm y;
    LinearForm r;
};

/// A point of the plane and a distance.
struct Circle {
    LinearForm x;
    LinearForm y;
    LinearForm rho;
};

/// max(|x - X|, |y - Y|) - r
LinearForm distance(const Square& site, const LinearForm& x, const LinearForm& y) {
    return std::max({x - site.x, site.x - x, y - site.y, site.y - y}) - site.r;
}

/// Where a side of the inscribed circle lies that the site touches from outside:
/// right is X + rho, top is Y + rho, left is X - rho, bottom is Y - rho.
LinearForm pinned(const Square& site, std::size_t side) {
    if (side == right) return site.x - site.r;
    if (side == top) return site.y - site.r;
    if (side == left) return site.x + site.r;
    return site.y + site.r;
}

/// The circle with three of its sides where they are given: all but `open`.
Circle solve(const std::array<LinearForm, 4>& at, std::size_t open) {
    const Rational half(1, 2);
    if (open == top || open == bottom) {
        const LinearForm rho = (at[right] - at[left]) * half;
        return {(at[right] + at[left]) * half, open == top ? at[bottom] + rho : at[top] - rho, rho};
    }
    const LinearForm rho = (at[top] - at[bottom]) * half;
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

    // Finite faces: i, j, k touch three different sides, counterclockwise, and no other site is as
    // near. That the sides are different is no restriction: two sites on one side would be a tie.
    for (std::size_t open = 0; open < 4; ++open) {
        const std::size_t first = (open + 1) % 4, second = (open + 2) % 4, third = (open + 3) % 4;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < n; ++k) {
                    if (i == j || j == k || k == i) continue;
                    std::array<LinearForm, 4> at;
                    at[first] = pinned(sites[i], first);
                    at[second] = pinned(sites[j], second);
                    at[third] = pinned(sites[k], third);
                    const Circle circle = solve(at, open);
                    const auto nearer = [&](std::size_t q) {
                        return (distance(sites[q], circle.x, circle.y) - circle.rho).sign();
                    };
                    if (nearer(i) != 0 || nearer(j) != 0 || nearer(k) != 0) continue;
                    bool empty = true;
                    for (std::size_t q = 0; q < n && empty; ++q)
                        if (q != i && q != j && q != k)
                            empty = less(circle.rho, distance(sites[q], circle.x, circle.y));
                    if (empty) result.faces.push_back(canonical({number(i), number(j), number(k)}));
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
