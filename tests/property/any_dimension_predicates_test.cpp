/// The questions of tessellations in any dimension beside determinants in rationals, written from
/// the definition: where doubles suffice, nearly tied, tied, and at the ends of their range.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../exact/multiprecision.hpp"
#include "../../triangulation/any_dimension/questions.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"
#include "any_dimension_sites.hpp"

namespace signum::any_dimension {
namespace {

using exact::Rational;
using oracle_test::Random;
using Rows = std::vector<std::vector<Rational>>;

/// By the first row.
Rational by_minors(const Rows& rows) {
    if (rows.empty()) return 1;
    Rational sum = 0;
    for (std::size_t column = 0; column < rows.size(); ++column) {
        Rows minor(rows.begin() + 1, rows.end());
        for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
        const Rational term = rows[0][column] * by_minors(minor);
        column % 2 == 0 ? sum += term : sum -= term;
    }
    return sum;
}
template <class S>
Rational weight_of(const S& s) {
    if constexpr (requires { s.w; })
        return exact::to_rational(s.w);
    else
        return exact::to_rational(s.r) * exact::to_rational(s.r);
}
template <class S>
Rational distance(const S& from, const S& to) {
    Rational sum = -weight_of(to);
    for (std::size_t axis = 0; axis < dimension_of<S>; ++axis) {
        const Rational x =
            exact::to_rational(coordinate(from, axis)) - exact::to_rational(coordinate(to, axis));
        sum += x * x;
    }
    return sum;
}
template <class S>
std::vector<Rational> row(const S& from, const S& to, const Axes<dimension_of<S>>& axes) {
    std::vector<Rational> result;
    for (std::size_t k = 0; k < axes.count; ++k)
        result.push_back(exact::to_rational(coordinate(to, axes.axis[k])) -
                         exact::to_rational(coordinate(from, axes.axis[k])));
    return result;
}

/// All questions of the first k + 2 sites along some axes, in both kinds of exact numbers.
template <class S>
void expect_right(const std::vector<S>& sites, const Axes<dimension_of<S>>& axes,
                  std::array<int, 3>& signs, std::uint64_t& exact) {
    constexpr int D = dimension_of<S>;
    Questions<S, Rational> one{std::span<const S>(sites)};
    Questions<S, exact::Dyadic> other{std::span<const S>(sites)};
    one.ask_along(axes);
    other.ask_along(axes);
    CellOf<D> cell;
    cell.fill(no_vertex);
    for (std::size_t i = 0; i <= axes.count; ++i) cell[i] = static_cast<Index>(i);
    const auto q = static_cast<Index>(axes.count + 1);
    Rows offsets;
    Rows lifted;
    Rational power;
    for (std::size_t i = 0; i <= axes.count; ++i) {
        if (i > 0) offsets.push_back(row(sites[0], sites[i], axes));
        lifted.push_back(row(sites[axes.count + 1], sites[i], axes));
        lifted.back().push_back(distance(sites[axes.count + 1], sites[i]) +
                                weight_of(sites[axes.count + 1]));
    }
    const Sign orientation = by_minors(offsets).sign();
    ASSERT_EQ(one.orientation(cell), orientation);
    ASSERT_EQ(other.orientation(cell), orientation);
    // The middle of the others.
    if (axes.count > 0) {
        CellOf<D> others = cell;
        for (std::size_t i = 0; i <= axes.count; ++i) ++others[i];
        for (const std::size_t place : {std::size_t{0}, axes.count}) {
            Rational sum = 0;
            for (std::size_t m = 1; m <= axes.count + 1; ++m) {
                Rows with = {};
                std::vector<S> moved = sites;
                moved[place] = sites[m];
                for (std::size_t i = 1; i <= axes.count; ++i)
                    with.push_back(row(moved[0], moved[i], axes));
                sum += by_minors(with);
            }
            ASSERT_EQ(one.orientation_with_middle(cell, place, others), sum.sign());
            ASSERT_EQ(other.orientation_with_middle(cell, place, others), sum.sign());
        }
    }
    const Sign nearer =
        (distance(sites[0], sites[2 % sites.size()]) - distance(sites[0], sites[1])).sign();
    ASSERT_EQ(one.nearer(0, 1, static_cast<Index>(2 % sites.size())), nearer);
    ASSERT_EQ(other.nearer(0, 1, static_cast<Index>(2 % sites.size())), nearer);
    if (orientation != 0) {
        // Of vertices that turn positively.
        if (orientation < 0) std::swap(cell[0], cell[1]);
        const Sign turn = axes.count % 2 == 0 ? 1 : -1;
        const Sign in_sphere = turn * orientation * by_minors(lifted).sign();
        ASSERT_EQ(one.in_sphere(cell, q), in_sphere);
        ASSERT_EQ(other.in_sphere(cell, q), in_sphere);
        ++signs[static_cast<std::size_t>(in_sphere + 1)];
    }
    exact += other.exact_count();
}

/// Sites of all sizes, nearly on a sphere, on a lattice, nearly flat.
template <class S>
std::vector<S> drawn(Random& random) {
    constexpr auto D = static_cast<std::size_t>(dimension_of<S>);
    const int kind = random.below(8);
    const int exponent = random.below(3) == 0 ? random.below(2000) - 1040 : 0;
    std::vector<S> sites;
    for (std::size_t n = 0; n < D + 2; ++n) {
        std::array<double, 8> x{};
        for (double& each : x) {
            each = kind <= 2 ? random.below(3) : random.unit() - 0.5;
            if (kind == 4) each = std::ldexp(each, random.below(200) - 100);
        }
        double length = 0.0;
        for (std::size_t axis = 0; axis < D; ++axis) length += x[axis] * x[axis];
        length = std::sqrt(length);
        if (kind == 5 && length > 0.0)
            for (double& each : x) each /= length;
        if (kind == 6 && D > 1) x[D - 1] = 0.1 * x[0] + 0.3 * x[D - 2];
        if (kind == 7)
            for (std::size_t axis = 1; axis < D; ++axis)
                x[axis] = x[0] * (1.0 + static_cast<double>(axis));
        for (double& each : x) {
            each = std::ldexp(each, exponent);
            if (!std::isfinite(each)) each = 1.0;
        }
        // A weight is a multiple of the unit's square, or nothing of the kind.
        double weight = random.below(3) == 0 ? std::ldexp(x[7], exponent) : 0.0;
        if (random.below(50) == 0) weight = std::numeric_limits<double>::max();
        if (random.below(50) == 0) x[0] = std::numeric_limits<double>::max();
        if (random.below(50) == 0) x[0] = std::numeric_limits<double>::denorm_min();
        S site{};
        if constexpr (requires { site.centre; }) {
            for (std::size_t axis = 0; axis < D; ++axis) site.centre[axis] = x[axis];
            site.w = std::isfinite(weight) ? weight : 0.0;
        } else {
            site = {x[0], x[1], x[2], random.below(2) == 0 ? x[3] : 0.0};
            // Radii whose sum overflows.
            if constexpr (requires { site.r; })
                if (random.below(20) == 0) {
                    for (S& each : sites) each.r = 1e308;
                    site.r = 1e308;
                }
        }
        sites.push_back(site);
    }
    return sites;
}

template <class S>
void expect_right(std::uint64_t seed, int trials) {
    constexpr int D = dimension_of<S>;
    Random random(seed);
    std::array<int, 3> signs{};
    std::uint64_t exact = 0;
    for (int trial = 0; trial < trials; ++trial) {
        Axes<D> axes;
        if (random.below(2) == 0) {
            axes = Axes<D>::all();
        } else {
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
                if (random.below(2) == 0) axes.axis[axes.count++] = axis;
        }
        const std::vector<S> sites = drawn<S>(random);
        ASSERT_NO_FATAL_FAILURE(expect_right(sites, axes, signs, exact)) << "trial " << trial;
    }
    if (trials < 100) return;
    for (const int times : signs) EXPECT_GT(times, 0);
    EXPECT_GT(exact, static_cast<std::uint64_t>(trials / 10));
}

TEST(AnyDimensionPredicates, AreThoseOfTheDefinition) {
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<1>>(71, 2000 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<2>>(72, 1000 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<3>>(73, 500 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<4>>(74, 200 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<5>>(75, 50 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<power::SiteOf<6>>(76, 10 * thoroughness));
}
TEST(AnyDimensionPredicates, OfBallsAndWeightsInSpaceAsWell) {
    ASSERT_NO_FATAL_FAILURE(expect_right<power::Site3>(77, 500 * thoroughness));
    ASSERT_NO_FATAL_FAILURE(expect_right<Site3>(78, 500 * thoroughness));
}

TEST(AnyDimensionPredicates, TheCountOfRoundingsIsThatOfTheFormula) {
    // A row has one more product and as many sums as it has columns: 1, then 2 + 1, 2 + 2, ...
    EXPECT_EQ((roundings<7, 6>(1, false)), 1);
    EXPECT_EQ((roundings<7, 6>(2, false)), 4);
    EXPECT_EQ((roundings<7, 6>(3, false)), 8);
    EXPECT_EQ((roundings<7, 6>(6, false)), 1 + 3 + 4 + 5 + 6 + 7);
    EXPECT_GT((roundings<7, 6>(7, true)), (roundings<7, 6>(7, false)));
}

/// What Tally and stages are for elsewhere: on a lattice zeros are proven without exact numbers.
TEST(AnyDimensionPredicates, OnALatticeNothingIsAskedExactly) {
    const auto sites = any_dimension_test::lattice<4>(2);
    Questions<power::SiteOf<4>, exact::Dyadic> questions{std::span<const power::SiteOf<4>>(sites)};
    const CellOf<4> cell = {0, 1, 2, 4, 8};
    ASSERT_GT(questions.orientation(cell), 0);
    for (Index q = 3; q < 16; ++q)
        if (q != 4 && q != 8) {
            EXPECT_EQ(questions.in_sphere(cell, q), 0);
        }
    EXPECT_EQ(questions.exact_count(), 0U);
    EXPECT_GT(questions.filtered_count(), 10U);
}

}  // namespace
}  // namespace signum::any_dimension
