#pragma once
/// The forms g_n(m) = n·c_m - r_m of facets.hpp and the signs of their sums: rounded, with a bound,
/// and exact. For sources only.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "../../core/contract.hpp"
#include "../../core/error_free.hpp"
#include "../../core/site.hpp"
#include "../../exact/sign_of_sum.hpp"
#include "../../filters/bounds.hpp"
#include "../../filters/rounding_count.hpp"
#include "../../filters/tally.hpp"
#include "../../filters/verdict.hpp"
#include "../formulas/facets.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::rectangular {

template <class Shape, class Number = double>
using Forms3 = std::array<Number, Shape::facets>;

/// All forms of a site, in any arithmetic.
template <class Shape, class Number = double>
[[nodiscard, gnu::always_inline]] constexpr Forms3<Shape, Number> rounded_forms(
    const Site3& m) noexcept {
    const Number x(m.x), y(m.y), z(m.z), r(m.r);
    if constexpr (std::is_same_v<Shape, Cube>) {
        return {x - r, -x - r, y - r, -y - r, z - r, -z - r};
    } else {
        const Number sum = x + y;
        const Number difference = x - y;
        return {(sum + z) - r,        (sum - z) - r,         (difference + z) - r,
                (difference - z) - r, (-difference + z) - r, (-difference - z) - r,
                (-sum + z) - r,       (-sum - z) - r};
    }
}

/// times · form less the sum of the weights times the forms of a basis: positive where the sphere
/// in which these are 0 has this facet too far inside.
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number excess(
    const Basis& basis, std::size_t facet, const Number& form,
    const std::array<Number, 4>& of_basis) noexcept {
    Number sum = Number(basis.times[facet]) * form;
    for (std::size_t t = 0; t < 4; ++t) sum = sum - Number(basis.weights[facet][t]) * of_basis[t];
    return sum;
}

namespace count {
using filters::RoundingCount;
template <class Shape>
constexpr int facet_form = rounded_forms<Shape, RoundingCount>(Site3{})[0].roundings;
/// The products, by 0, 1 and 2, are exact, but counted.
template <class Shape>
constexpr int excess =
    rectangular::excess<RoundingCount>(bases<Shape>[0], 0, RoundingCount::of(facet_form<Shape>), {
        RoundingCount::of(facet_form<Shape>), RoundingCount::of(facet_form<Shape>),
            RoundingCount::of(facet_form<Shape>), RoundingCount::of(facet_form<Shape>)
    }).roundings;
static_assert(excess<Cube> == 6 && excess<Octahedron> == 8);
}  // namespace count

/// |x| + |y| + |z| + |r|
[[nodiscard, gnu::always_inline]] inline double size_of(const Site3& m) noexcept {
    return ((filters::magnitude(m.x) + filters::magnitude(m.y)) + filters::magnitude(m.z)) +
           filters::magnitude(m.r);
}

/// The bound on the error of a sum of forms that a relation of facets asks for, the comparison of
/// two forms among them, where S is the greatest size of the sites.
///
/// A sum has f forms at most, 4 of the cube and 6 of the octahedron (most_forms), its magnitude is
/// f S, and it commits k roundings at most: by the lemma of rounding_count.hpp it is off by
/// ((1+e)^k - 1) f S < (k + 1/2) f e S, e = 2^-52; the other half of fe pays for the roundings of S
/// and of the bound. Additions underflow exactly, and where the bound itself underflows so much
/// that it is off by more than that half, no sum of forms rounds. Where a sum could overflow the
/// bound is infinite, and nothing exceeds it.
template <class Shape>
[[nodiscard, gnu::always_inline]] inline double bound_of(double size) noexcept {
    constexpr int times = (count::excess<Shape> + 1) * most_forms<Shape>;
    return size < 0x1p1000 ? times * filters::epsilon * size
                           : std::numeric_limits<double>::infinity();
}

/// factor · g_facet(site), one addend of a sum.
struct Addend3 {
    const Site3* site;
    std::size_t facet;
    int factor;
};

/// The exact sign of a sum of forms (factors of 6 in all), 0 included, in the default environment:
/// the rounded sum, where no addition rounded, as on grids; else ESSA.
template <class Shape>
[[nodiscard]] inline Decision sign_of_forms(std::span<const Addend3> addends) noexcept {
    std::array<double, 4 * std::size_t{6}> terms;
    std::size_t count = 0;
    for (const Addend3& addend : addends)
        for (int times = addend.factor < 0 ? -addend.factor : addend.factor; times > 0; --times) {
            const double sign = addend.factor < 0 ? -1.0 : 1.0;
            const double coordinates[] = {addend.site->x, addend.site->y, addend.site->z};
            for (std::size_t k = 0; k < 3; ++k)
                if (const int n = Shape::normals[addend.facet][k]; n != 0)
                    terms[count++] = sign * n * coordinates[k];
            terms[count++] = -sign * addend.site->r;
        }
    double sum = 0.0;
    bool rounded = false;
    for (std::size_t t = 0; t < count; ++t) {
        const TwoTerms next = two_sum(sum, terms[t]);
        // NaN where something overflowed.
        rounded |= !(next.low == 0.0);
        sum = next.high;
    }
    if (!rounded) return {sign_of(sum), Stage::exact};
    return {sign_of_sum({terms.data(), count}), Stage::essa};
}

}  // namespace signum::rectangular

SIGNUM_IEEE_END
