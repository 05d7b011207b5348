#pragma once
/// The facets of the cube and of the octahedron, and the linear relations between them.
///
/// A facet is a direction n: of the cube (supremum metric) the six ±x, ±y, ±z, of the octahedron
/// (Manhattan) the eight (±1, ±1, ±1). A distance is the greatest of the n·v. A site m pins one
/// form to each,
///
///     g_n(m) = n·c_m - r_m,
///
/// and a sphere with centre X and radius rho one number, G_n = n·X + rho. Laws:
///  1. m's distance from X, r_m and rho taken off, is the greatest of g_n(m) - G_n. So m touches
///     the sphere where this is 0, in those facets that have it, and conflicts where all are
///     negative.
///  2. The sphere has four numbers: four G_n of independent (n, 1) give the others, each a sum of
///     them with the weights that (n, 1) has in the four.
///  3. Let M_n be the greatest g_n of four sites. What touches all four, or holds some of them off,
///     is the polyhedron of the G >= M; a sphere touches a site where it lies in one of the facets
///     G_n = M_n that this site has pinned. A polyhedron without a line in it: where it touches
///     all four sites in finitely many spheres, these are corners.
///  4. So G is the lesser of all affine functions on space that are at least M_n at the points n,
///     and its corners are the cells of a subdivision of the cube (octahedron) of these points: of
///     the lifted points (n, M_n) the upper hull. A sphere is a cell whose corners are pinned by
///     all four sites; there are infinitely many spheres where a polygon of the subdivision is
///     pinned by all four, for this is an edge of the polyhedron.
///  5. The cube of the points n = (±1, ±1, ±1) has at most six cells, each at least a sixth of it.
///     The octahedron of the points ±x, ±y, ±z has the diagonal with the greatest sum of M within
///     and at most four cells around it. Of four cells at most two are spheres: of three, two would
///     share +y, say, and two +z. So there were a site u that pins both ends of the z axis but not
///     +y, and a v that pins both ends of the y axis but not +z, and each would have the lesser
///     radius of the two.
/// Source: Gavrilova 1998, 4.6.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace signum::rectangular {

struct Cube {
    static constexpr std::size_t facets = 6;
    static constexpr std::size_t most_cells = 4;
    static constexpr std::size_t most_spheres = 2;
    static constexpr int normals[facets][3] = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                               {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
};
struct Octahedron {
    static constexpr std::size_t facets = 8;
    static constexpr std::size_t most_cells = 6;
    static constexpr std::size_t most_spheres = 6;
    static constexpr int normals[facets][3] = {{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                                               {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
};

/// A set of facets; the first facet is the highest bit, so that of two sets the greater one has the
/// first facet that is not in both.
using FacetSet = std::uint8_t;
[[nodiscard]] constexpr FacetSet facet_bit(std::size_t facet) noexcept {
    return static_cast<FacetSet>(0x80U >> facet);
}
[[nodiscard]] constexpr bool holds(FacetSet set, std::size_t facet) noexcept {
    return (set & facet_bit(facet)) != 0;
}

/// Four facets, in rising order.
struct Basis {
    FacetSet set = 0;
    std::array<std::uint8_t, 4> facets = {};
    /// 0 where the four (n, 1) are not independent, but points of one plane; what follows is for
    /// the others.
    int determinant = 0;
    /// times[f] G_f = Σ weights[f][t] G_facets[t], times > 0, in least terms.
    std::array<std::int8_t, 8> times = {};
    std::array<std::array<std::int8_t, 4>, 8> weights = {};
    /// The facets that the relation of f with the basis is about, f among them, and the sign that
    /// the first of them has in it. Facets with a relation have but one.
    std::array<FacetSet, 8> related = {};
    std::array<std::int8_t, 8> sense = {};
    /// Of the centre's coordinates and rho: divisor · value = Σ solution[k][t] G_facets[t].
    std::array<std::int8_t, 4> divisor = {};
    std::array<std::array<std::int8_t, 4>, 4> solution = {};
};

namespace facets {

using Row = std::array<int, 4>;
using Rows = std::array<Row, 4>;

/// (n, 1)
template <class Shape>
[[nodiscard]] constexpr Row row_of(std::size_t facet) noexcept {
    const auto& n = Shape::normals[facet];
    return {n[0], n[1], n[2], 1};
}
/// Of the three other rows and columns, with its sign.
[[nodiscard]] constexpr int cofactor(const Rows& rows, std::size_t row,
                                     std::size_t column) noexcept {
    const auto at = [&](std::size_t r, std::size_t c) {
        return rows[r < row ? r : r + 1][c < column ? c : c + 1];
    };
    const int minor = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
                      at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
                      at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
    return (row + column) % 2 == 0 ? minor : -minor;
}
[[nodiscard]] constexpr int determinant(const Rows& rows) noexcept {
    int sum = 0;
    for (std::size_t column = 0; column < 4; ++column)
        sum += rows[0][column] * cofactor(rows, 0, column);
    return sum;
}

/// times · vector = Σ of[t] rows[t], in least terms, times > 0.
struct Weights {
    int times;
    std::array<std::int8_t, 4> of;
};
/// By Cramer's rule: cofactors[t][k] of row t and column k.
[[nodiscard]] constexpr Weights weights_of(const Row& vector, const Rows& cofactors,
                                           int determinant) noexcept {
    Row of = {};
    int common = determinant;
    for (std::size_t t = 0; t < 4; ++t) {
        for (std::size_t k = 0; k < 4; ++k) of[t] += vector[k] * cofactors[t][k];
        common = std::gcd(common, of[t]);
    }
    if (determinant < 0) common = -common;
    Weights result{determinant / common, {}};
    for (std::size_t t = 0; t < 4; ++t) result.of[t] = static_cast<std::int8_t>(of[t] / common);
    return result;
}

template <class Shape>
[[nodiscard]] constexpr Basis basis_of(const std::array<std::size_t, 4>& chosen) noexcept {
    Basis basis;
    Rows rows = {};
    for (std::size_t t = 0; t < 4; ++t) {
        basis.set = static_cast<FacetSet>(basis.set | facet_bit(chosen[t]));
        basis.facets[t] = static_cast<std::uint8_t>(chosen[t]);
        rows[t] = row_of<Shape>(chosen[t]);
    }
    basis.determinant = determinant(rows);
    if (basis.determinant == 0) return basis;
    Rows cofactors = {};
    for (std::size_t t = 0; t < 4; ++t)
        for (std::size_t k = 0; k < 4; ++k) cofactors[t][k] = cofactor(rows, t, k);
    for (std::size_t f = 0; f < Shape::facets; ++f) {
        const Weights weights = weights_of(row_of<Shape>(f), cofactors, basis.determinant);
        basis.times[f] = static_cast<std::int8_t>(weights.times);
        basis.weights[f] = weights.of;
        basis.related[f] = facet_bit(f);
        basis.sense[f] = 1;
        bool is_first = true;
        for (std::size_t t = 0; t < 4; ++t) {
            if (weights.of[t] == 0) continue;
            basis.related[f] = static_cast<FacetSet>(basis.related[f] | facet_bit(chosen[t]));
            if (is_first && chosen[t] < f) basis.sense[f] = weights.of[t] > 0 ? -1 : 1;
            is_first = false;
        }
    }
    for (std::size_t k = 0; k < 4; ++k) {
        Row unit = {};
        unit[k] = 1;
        const Weights weights = weights_of(unit, cofactors, basis.determinant);
        basis.divisor[k] = static_cast<std::int8_t>(weights.times);
        basis.solution[k] = weights.of;
    }
    return basis;
}

[[nodiscard]] constexpr std::size_t fours(std::size_t n) noexcept {
    return n * (n - 1) * (n - 2) * (n - 3) / 24;
}

/// All sets of four facets, in falling order.
template <class Shape>
[[nodiscard]] constexpr auto all_bases() noexcept {
    std::array<Basis, fours(Shape::facets)> bases;
    std::size_t count = 0;
    for (std::size_t a = 0; a < Shape::facets; ++a)
        for (std::size_t b = a + 1; b < Shape::facets; ++b)
            for (std::size_t c = b + 1; c < Shape::facets; ++c)
                for (std::size_t d = c + 1; d < Shape::facets; ++d)
                    bases[count++] = basis_of<Shape>({a, b, c, d});
    return bases;
}

}  // namespace facets

template <class Shape>
inline constexpr auto bases = facets::all_bases<Shape>();

/// The place of a set of four facets among the bases.
template <class Shape>
inline constexpr auto place_of_basis = [] {
    std::array<std::uint8_t, 256> places = {};
    for (std::size_t place = 0; place < bases<Shape>.size(); ++place)
        places[bases<Shape>[place].set] = static_cast<std::uint8_t>(place);
    return places;
}();
template <class Shape>
[[nodiscard]] constexpr const Basis& basis_of(FacetSet set) noexcept {
    return bases<Shape>[place_of_basis<Shape>[set]];
}

/// How many forms a relation of a facet with a basis is the sum of, at most.
template <class Shape>
inline constexpr int most_forms = [] {
    int most = 0;
    for (const Basis& basis : bases<Shape>) {
        if (basis.determinant == 0) continue;
        for (std::size_t f = 0; f < Shape::facets; ++f) {
            int forms = basis.times[f];
            for (const int weight : basis.weights[f]) forms += weight < 0 ? -weight : weight;
            most = forms > most ? forms : most;
        }
    }
    return most;
}();
static_assert(most_forms<Cube> == 4 && most_forms<Octahedron> == 6);

}  // namespace signum::rectangular
