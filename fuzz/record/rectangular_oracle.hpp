#pragma once
/// The supremum metric of the plane, squares, and the Manhattan metric, which is the same of x + y
/// and y - x: from the definition of a distance, by trying all squares that three sides make. No
/// number is multiplied but by 2.

#include <array>
#include <cstddef>
#include <cstdint>

#include "integer.hpp"
#include "scaled.hpp"

namespace signum::fuzz::rectangular_oracle {

template <class Number>
struct Square {
    Number x, y, r;
};

template <class Number>
[[nodiscard]] int sign_of(const Number& number) {
    if constexpr (requires { number.sign(); })
        return number.sign();
    else
        return (number > 0) - (number < 0);
}
template <class Number>
[[nodiscard]] Number positive(const Number& number) {
    return sign_of(number) < 0 ? Number(-number) : number;
}
template <class Number>
[[nodiscard]] const Number& greater(const Number& a, const Number& b) {
    return a < b ? b : a;
}

/// A square between sites: twice its centre and its size.
template <class Number>
struct Inscribed {
    Number x, y, rho;
};
/// Twice the distance from its centre to the site less its size: 0 where they touch.
template <class Number>
[[nodiscard]] Number gap(const Inscribed<Number>& square, const Square<Number>& site) {
    const Number x = positive<Number>(site.x + site.x - square.x);
    const Number y = positive<Number>(site.y + site.y - square.y);
    return greater(x, y) - (site.r + site.r) - square.rho;
}

/// Where the square's side lies that the site touches; sides counterclockwise from the right one.
template <class Number>
[[nodiscard]] Number pinned(const Square<Number>& site, std::size_t side) {
    if (side == 0) return site.x - site.r;
    if (side == 1) return site.y - site.r;
    if (side == 2) return site.x + site.r;
    return site.y + site.r;
}

/// Which site touches which side, counterclockwise after the one that none touches.
struct Touching {
    std::size_t open = 4;  ///< 4 where there is no such square
    std::array<std::size_t, 3> sites = {};
};

/// The square whose sides after `open` lie where these sites touch them.
template <class Number, std::size_t n>
[[nodiscard]] Inscribed<Number> inscribed(const std::array<Square<Number>, n>& sites,
                                          const Touching& touching) {
    std::array<Number, 4> at;
    for (std::size_t turn = 0; turn < 3; ++turn) {
        const std::size_t side = (touching.open + 1 + turn) % 4;
        at[side] = pinned(sites[touching.sites[turn]], side);
    }
    Inscribed<Number> square;
    if (touching.open % 2 == 1) {
        square.rho = at[0] - at[2];
        square.x = at[0] + at[2];
        square.y = touching.open == 1 ? at[3] + at[3] + square.rho : at[1] + at[1] - square.rho;
    } else {
        square.rho = at[1] - at[3];
        square.y = at[1] + at[3];
        square.x = touching.open == 0 ? at[2] + at[2] + square.rho : at[0] + at[0] - square.rho;
    }
    return square;
}

/// The square that touches the first three counterclockwise, if there is one. No two numbers that
/// are compared may be equal but where sites touch.
template <class Number, std::size_t n>
[[nodiscard]] Touching touching(const std::array<Square<Number>, n>& sites) {
    for (std::size_t open = 0; open < 4; ++open)
        for (std::size_t first = 0; first < 3; ++first) {
            const Touching candidate{open, {first, (first + 1) % 3, (first + 2) % 3}};
            const Inscribed<Number> square = inscribed(sites, candidate);
            bool touches = true;
            for (std::size_t m = 0; m < 3 && touches; ++m)
                touches = sign_of(gap(square, sites[m])) == 0;
            if (touches) return candidate;
        }
    return {};
}

/// Whether i covers q, without its boundary.
template <class Number>
[[nodiscard]] bool covers(const Square<Number>& i, const Square<Number>& q) {
    const Number x = positive<Number>(i.x - q.x);
    const Number y = positive<Number>(i.y - q.y);
    return greater(x, y) < i.r - q.r;
}

/// How much nearer the point is to a than to b.
template <class Number>
[[nodiscard]] int nearer(const Square<Number>& point, const Square<Number>& a,
                         const Square<Number>& b) {
    const auto distance = [&](const Square<Number>& site) {
        return Number(greater<Number>(positive<Number>(site.x - point.x),
                                      positive<Number>(site.y - point.y)) -
                      site.r);
    };
    return sign_of<Number>(distance(b) - distance(a));
}

/// How far a site reaches to one of the sides.
template <class Number>
[[nodiscard]] Number reach(const Square<Number>& site, std::size_t side) {
    if (side % 4 == 0) return site.r + site.x;
    if (side % 4 == 1) return site.r + site.y;
    if (side % 4 == 2) return site.r - site.x;
    return site.r - site.y;
}
/// The quadrant that a and b leave between a side and the next, a reaching farther to the first and
/// b to the second; 4 where one covers the other.
template <class Number>
[[nodiscard]] std::size_t quadrant(const Square<Number>& a, const Square<Number>& b) {
    for (std::size_t side = 0; side < 4; ++side)
        if (reach(b, side) < reach(a, side) && reach(a, side + 1) < reach(b, side + 1)) return side;
    return 4;
}
/// Whether q reaches into it: 0 where it only touches.
template <class Number>
[[nodiscard]] int reaches(const Square<Number>& a, const Square<Number>& b, const Square<Number>& q,
                          std::size_t side) {
    const int first = sign_of<Number>(reach(q, side) - reach(b, side));
    const int second = sign_of<Number>(reach(q, side + 1) - reach(a, side + 1));
    return first < second ? first : second;
}

}  // namespace signum::fuzz::rectangular_oracle
