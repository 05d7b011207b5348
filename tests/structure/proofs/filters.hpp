#pragma once
/// The filters whose bounds are proved.

#include <vector>

#include "../../../predicates/ccw.hpp"
#include "../../../predicates/power/in_circle.hpp"
#include "filter.hpp"

namespace signum::proofs {

/// Coordinates are at most t, weights t². Of a weight that is the product of r - r' and r + r'
/// these are p and q, which come in pairs.
inline Monomial size_in_power(const std::string& atom) {
    if (atom[0] == 'w') return {'t', 't'};
    if (atom[0] != 'r') return {'t'};
    return {atom.find('-') != std::string::npos ? 'p' : 'q'};
}

/// The two products have one sign: elsewhere nothing cancels, and the sign is right whatever the
/// bound.
inline Compared ccw_in_plane() {
    const Point a = input<Point>(1);
    const Point b = input<Point>(2);
    const Point c = input<Point>(3);
    const auto difference = [](double to, double from) {
        return Expression(to) - Expression(from);
    };
    return predicates::compared_ccw(difference(a.x, c.x), difference(a.y, c.y),
                                    difference(b.x, c.x), difference(b.y, c.y));
}

template <class S>
Compared in_circle_of_power() {
    const auto row = [](int m) { return power::row<Expression>(input<S>(m), input<S>(4)); };
    return power::compared_in_circle(row(1), row(2), row(3));
}

/// The magnitude is the sum of the products of two heights h, and a third of s² at most: each minor
/// |x y'| + |x' y| is at most half the sum of the squares, the height of each at least that.
inline void prove_third_of_square(Scripts& scripts) {
    const std::string minor = "x * v + y * u - (x * x + y * y + u * u + v * v) / 2";
    scripts.write(
        "power_in_circle-minor", "A minor is at most half the sum of the squares.",
        {"x in [0, 1] /\\ y in [0, 1] /\\ u in [0, 1] /\\ v in [0, 1] -> " + minor + " <= 0", "",
         minor + " -> -((x - v) * (x - v) + (y - u) * (y - u)) / 2;\n"});
    const std::string sum =
        "i * (j + k) / 2 + j * (k + i) / 2 + k * (i + j) / 2 - (i + j + k) * (i + j + k) / 3";
    scripts.write(
        "power_in_circle-third", "The products of two heights are a third of the square.",
        {"i in [0, 1] /\\ j in [0, 1] /\\ k in [0, 1] -> " + sum + " <= 0", "",
         sum + " -> -((i - j) * (i - j) + (j - k) * (j - k) + (k - i) * (k - i)) / 6;\n"});
}

inline const std::vector<Filter>& all_filters() {
    static const long double third = 1 / (3 * 5 * static_cast<long double>(filters::epsilon));
    static const Polynomial of_in_circle = {{{'t', 't'}, 0x1p-1000L}, {{}, 0x1p-1000L}};
    static const std::vector<Filter> filters = {
        {.name = "ccw",
         .evaluate = ccw_in_plane,
         .size_of = size_in_power,
         .spare_for_underflow = {{{}, 0x1p-1000L}}},
        {.name = "power_in_circle_points",
         .evaluate = in_circle_of_power<Point>,
         .size_of = size_in_power,
         .spare_for_underflow = of_in_circle,
         .share = third,
         .prove_share = prove_third_of_square},
        {.name = "power_in_circle_weights",
         .evaluate = in_circle_of_power<power::Site>,
         .size_of = size_in_power,
         .spare_for_underflow = of_in_circle,
         .share = third,
         .prove_share = prove_third_of_square},
        {.name = "power_in_circle_radii",
         .evaluate = in_circle_of_power<Site>,
         .size_of = size_in_power,
         .spare_for_underflow = of_in_circle,
         .share = third,
         .prove_share = prove_third_of_square},
    };
    return filters;
}

}  // namespace signum::proofs
