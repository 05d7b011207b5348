#pragma once
/// The filters whose bounds are proved.

#include <vector>

#include "../../../predicates/ccw.hpp"
#include "../../../predicates/euclidean/filter.hpp"
#include "../../../predicates/power.hpp"
#include "../../../predicates/ladder/forms.hpp"
#include "../../../predicates/space/in_sphere.hpp"
#include "../../../predicates/space/nearer.hpp"
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

template <class S>
Lemma third_of_square() {
    const auto row = [](int m) { return power::row<Expression>(input<S>(m), input<S>(4)); };
    const auto height = [row](int m) {
        const auto [x, y, weight] = row(m);
        return (x * x + y * y) + magnitude(weight);
    };
    const auto product = [row, height](int i, int j, int k) {
        return height(i) * (row(j).x * row(k).y + row(k).x * row(j).y);
    };
    return {[product] { return product(1, 2, 3) + (product(2, 3, 1) + product(3, 1, 2)); },
            [height] {
                const Expression s = height(1) + (height(2) + height(3));
                return s * s;
            },
            1 / 3.0L, prove_third_of_square};
}

/// Behind these: the sites as radii, which are the costliest.
inline power::Row<Expression> power_row(int m) {
    return power::row<Expression>(input<Site>(m), input<Site>(4));
}
inline Compared in_circle_of_power_finely() {
    return power::compared_in_circle_finely(power_row(1), power_row(2), power_row(3));
}
inline Compared in_segment_of_power() {
    const power::Row<Expression> a = power_row(1);
    const power::Row<Expression> b = power_row(2);
    return power::compared_in_segment(a, b, a.x, b.x);
}
inline Compared nearer_of_power() {
    return power::compared_nearer<Expression>(input<Point>(1), input<Site>(2), input<Site>(3));
}

// ---- the Euclidean metric ----------------------------------------------------------------------

/// The l of the two sites.
inline Monomial size_in_euclidean(const std::string& atom) {
    if (atom.size() < 5) return {0};
    return {10 * (atom[1] - '0') + (atom[4] - '0')};
}
using EuclideanTriple = euclidean::filter::TripleOf<Expression>;
using EuclideanDifference = euclidean::filter::DifferenceOf<Expression>;
inline EuclideanTriple euclidean_triple(int third = 3) {
    return {input<Site>(1), input<Site>(2), input<Site>(third)};
}
inline EuclideanDifference euclidean_query() {
    return {input<Site>(4), input<Site>(1)};
}

inline Filter in_euclidean(const char* name, std::function<Compared()> evaluate) {
    return {.name = name,
            .evaluate = std::move(evaluate),
            .size_of = size_in_euclidean,
            .window = 110,
            .terms = 3};
}

// ---- space -------------------------------------------------------------------------------------

/// Coordinates by axes; weights.
inline std::string kind_in_space(const std::string& atom) {
    return atom.substr(0, 1);
}
/// Differences of radii and their sums apart, whose product is a weight.
inline std::string kind_of_radii(const std::string& atom) {
    return atom[0] == 'r' ? std::string("r") + atom[2] : kind_in_space(atom);
}
/// In the window are coordinates alone.
inline Monomial size_in_space(const std::string& atom) {
    if (atom[0] == 'w') return {'w', 'w'};
    return {atom[0]};
}
inline predicates::Offset3<Expression> offset_in_space(int m, int from) {
    return predicates::offset<Expression>(input<Point3>(m), input<Point3>(from));
}
inline Compared ccw_in_space() {
    const auto b = offset_in_space(2, 1);
    const auto c = offset_in_space(3, 1);
    const auto d = offset_in_space(4, 1);
    return {predicates::ccw_determinant(b, c, d),
            predicates::bound_of_ccw(predicates::reach(b, c, d))};
}
template <class S>
Compared in_sphere_of_power() {
    const auto row = [](int m) { return power::lifted_row<Expression>(input<S>(m), input<S>(5)); };
    const auto a = row(1);
    return {power::in_sphere_determinant(a, row(2), row(3), row(4)),
            power::bound_of_in_sphere(a.offset, magnitude(a.weight))};
}
template <class S>
Compared nearer_in_space() {
    const auto [difference, size] =
        power::compared_nearer<Expression>(input<Point3>(1), input<S>(2), input<S>(3));
    return {difference, power::nearer_error * size};
}

// ---- supremum, Manhattan -----------------------------------------------------------------------

inline Expression manhattan_form(int site) {
    return rectangular::rounded_form<rectangular::Manhattan, Expression>(input<Site>(site), 0);
}
/// S, the greatest size of the sites.
inline Expression manhattan_size() {
    const Site site = input<Site>(1);
    return (Expression(site.x) + (Expression(site.y) + Expression(0.0))) + Expression(site.r);
}
inline Compared sum_of_four_forms() {
    return {rectangular::difference_of_widths(manhattan_form(1), manhattan_form(2),
                                              manhattan_form(3), manhattan_form(4)),
            rectangular::error_of_four * manhattan_size()};
}
inline Compared sum_of_eight_forms() {
    Expression sum(0.0);
    for (int m = 1; m <= 8; ++m) sum = rectangular::with_term(sum, 1, manhattan_form(m));
    return {sum, rectangular::eight_by_four * (rectangular::error_of_four * manhattan_size())};
}

inline const std::vector<Filter>& all_filters() {
    static const std::vector<Filter> filters = {
        {.name = "ccw", .evaluate = ccw_in_plane, .size_of = size_in_power},
        {.name = "power_in_circle_points",
         .evaluate = in_circle_of_power<Point>,
         .size_of = size_in_power,
         .lemma = third_of_square<Point>()},
        {.name = "power_in_circle_weights",
         .evaluate = in_circle_of_power<power::Site>,
         .size_of = size_in_power,
         .lemma = third_of_square<power::Site>()},
        {.name = "power_in_circle_radii",
         .evaluate = in_circle_of_power<Site>,
         .size_of = size_in_power,
         .lemma = third_of_square<Site>()},
        {.name = "power_in_circle_finely",
         .evaluate = in_circle_of_power_finely,
         .size_of = size_in_power,
         .in_range = true},
        {.name = "power_in_segment",
         .evaluate = in_segment_of_power,
         .size_of = size_in_power,
         .in_range = true},
        {.name = "power_nearer",
         .evaluate = nearer_of_power,
         .size_of = size_in_power,
         .in_range = true},
        in_euclidean("euclidean_power", [] { return euclidean_query().compared_power(); }),
        in_euclidean("euclidean_xy", [] { return euclidean_triple().compared_xy(); }),
        in_euclidean("euclidean_q", [] { return euclidean_triple().compared_q(); }),
        {.name = "euclidean_q_anywhere",
         .evaluate = [] { return euclidean_triple().compared_q_anywhere(); },
         .size_of = size_in_euclidean},
        in_euclidean("euclidean_twice_ab", [] { return euclidean_triple().compared_twice_ab(); }),
        in_euclidean("euclidean_order_of_middles",
                     [] {
                         return euclidean::filter::compared_order_of_middles(euclidean_triple(3),
                                                                             euclidean_triple(4));
                     }),
        {.name = "space_ccw",
         .evaluate = ccw_in_space,
         .size_of = size_in_space,
         .kind_of = kind_in_space,
         .window = 150,
         .terms = 1},
        {.name = "space_in_sphere_points",
         .evaluate = in_sphere_of_power<Point3>,
         .size_of = size_in_space,
         .kind_of = kind_in_space,
         .window = 150,
         .terms = 1},
        {.name = "space_in_sphere_weights",
         .evaluate = in_sphere_of_power<power::Site3>,
         .size_of = size_in_space,
         .kind_of = kind_in_space,
         .window = 150,
         .terms = 1},
        {.name = "space_in_sphere_radii",
         .evaluate = in_sphere_of_power<Site3>,
         .size_of = size_in_space,
         .kind_of = kind_of_radii,
         .window = 150,
         .terms = 1},
        {.name = "space_nearer_radii",
         .evaluate = nearer_in_space<Site3>,
         .size_of = size_in_space,
         .in_range = true},
        {.name = "space_nearer_weights",
         .evaluate = nearer_in_space<power::Site3>,
         .size_of = size_in_space,
         .in_range = true},
        {.name = "rectangular_four",
         .evaluate = sum_of_four_forms,
         .size_of = size_in_space,
         .kind_of = kind_in_space,
         .in_range = true},
        {.name = "rectangular_eight",
         .evaluate = sum_of_eight_forms,
         .size_of = size_in_space,
         .kind_of = kind_in_space,
         .in_range = true},
    };
    return filters;
}

}  // namespace signum::proofs
