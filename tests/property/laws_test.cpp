// Laws that hold for any input whatsoever, stated as such (RapidCheck): what fails is made smaller
// until it is easily read. Numbers are small integers, so that ties abound and sums of two are
// exact, or, where a law allows it, any finite doubles.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../../exact/sign_of_sum.hpp"
#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/supremum.hpp"
#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"

namespace signum {
namespace {

rc::Gen<double> any_finite() {
    const auto of_bits = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
        return std::bit_cast<double>(bits);
    });
    return rc::gen::suchThat(of_bits, [](double number) { return std::isfinite(number); });
}
rc::Gen<double> small_integer() {
    return rc::gen::map(rc::gen::inRange(-4, 5), [](int number) { return double(number); });
}
rc::Gen<double> radius() {
    return rc::gen::map(rc::gen::inRange(0, 4), [](int number) { return double(number); });
}
/// Few places and ties, or anything.
rc::Gen<double> number() {
    return rc::gen::weightedOneOf<double>({{2, small_integer()}, {1, any_finite()}});
}
rc::Gen<Point> point_of(const rc::Gen<double>& coordinate) {
    return rc::gen::apply([](double x, double y) { return Point{x, y}; }, coordinate, coordinate);
}
rc::Gen<Site> site() {
    return rc::gen::apply(
        [](double x, double y, double r) {
            return Site{x, y, r};
        },
        small_integer(), small_integer(), radius());
}
rc::Gen<std::vector<Site>> sites() {
    return rc::gen::container<std::vector<Site>>(site());
}

/// Twice around is half a turn; exact, as is the mirror.
Point turned(Point p) {
    return {-p.y, p.x};
}
Point mirrored(Point p) {
    return {-p.x, p.y};
}
template <class S>
S scaled(S site, double factor) {
    return {site.x * factor, site.y * factor, site.r * factor};
}

RC_GTEST_PROP(LawsOfCcw, TurnsWithTheOrderOfItsPoints, ()) {
    const Point a = *point_of(number()), b = *point_of(number()), c = *point_of(number());
    const Sign sign = ccw(a, b, c);
    RC_ASSERT(ccw(b, c, a) == sign);
    RC_ASSERT(ccw(b, a, c) == -sign);
    RC_ASSERT(ccw(a, a, b) == 0);
}
RC_GTEST_PROP(LawsOfCcw, TurnsWithThePlaneAndAgainstItsMirror, ()) {
    const Point a = *point_of(number()), b = *point_of(number()), c = *point_of(number());
    const Sign sign = ccw(a, b, c);
    RC_ASSERT(ccw(turned(a), turned(b), turned(c)) == sign);
    RC_ASSERT(ccw(mirrored(a), mirrored(b), mirrored(c)) == -sign);
}
RC_GTEST_PROP(LawsOfCcw, OfSpaceTurnsWithTheOrderOfItsPoints, ()) {
    std::array<Point3, 4> p;
    for (Point3& each : p) each = {*number(), *number(), *number()};
    const Sign sign = ccw(p[0], p[1], p[2], p[3]);
    RC_ASSERT(ccw(p[1], p[0], p[2], p[3]) == -sign);
    RC_ASSERT(ccw(p[0], p[2], p[1], p[3]) == -sign);
    RC_ASSERT(ccw(p[0], p[1], p[3], p[2]) == -sign);
}

RC_GTEST_PROP(LawsOfInCircle, OfPointsIsTheSameFromEachOfThem, ()) {
    const Point i = *point_of(number()), j = *point_of(number()), k = *point_of(number());
    RC_PRE(power::exists(i, j, k));
    const Point q = *point_of(number());
    const Sign sign = power::in_circle(i, j, k, q);
    RC_ASSERT(power::in_circle(j, k, i, q) == sign);
    RC_ASSERT(power::in_circle(turned(i), turned(j), turned(k), turned(q)) == sign);
    RC_ASSERT(power::in_circle(mirrored(j), mirrored(i), mirrored(k), mirrored(q)) == sign);
    RC_ASSERT(power::in_circle(i, j, k, i) == 0);
}
RC_GTEST_PROP(LawsOfInCircle, UnderTheTieRuleOneDiagonalHolds, ()) {
    // i, j, k and i, k, q turn alike: a convex quadrangle, of which either triangle judges the
    // same.
    const Point i = *point_of(number()), j = *point_of(number());
    const Point k = *point_of(number()), q = *point_of(number());
    RC_PRE(power::exists(i, j, k) && power::exists(i, k, q));
    const Sign sign = power::in_circle_perturbed(i, j, k, q, {0, 1, 2, 3});
    RC_ASSERT(sign != 0);
    RC_ASSERT(power::in_circle_perturbed(i, k, q, j, {0, 2, 3, 1}) == sign);
}

struct Additive {
    bool (*exists)(const Site&, const Site&, const Site&);
    Sign (*in_circle)(const Site&, const Site&, const Site&, const Site&);
    bool (*hidden)(const Site&, const Site&);
};
constexpr Additive additive_metrics[] = {
    {euclidean::exists, euclidean::in_circle, euclidean::hidden},
    {supremum::exists, supremum::in_circle, supremum::hidden},
    {manhattan::exists, manhattan::in_circle, manhattan::hidden}};

RC_GTEST_PROP(LawsOfAdditive, OnlyDifferencesOfRadiiMatter, ()) {
    const Site i = *site(), j = *site(), k = *site(), q = *site();
    const double more = *radius();
    const auto grown = [&](Site s) { return Site{s.x, s.y, s.r + more}; };
    for (const Additive& metric : additive_metrics) {
        RC_ASSERT(metric.hidden(q, i) == metric.hidden(grown(q), grown(i)));
        const bool there = metric.exists(i, j, k);
        RC_ASSERT(metric.exists(grown(i), grown(j), grown(k)) == there);
        if (there && !metric.hidden(q, i) && !metric.hidden(q, j) && !metric.hidden(q, k))
            RC_ASSERT(metric.in_circle(grown(i), grown(j), grown(k), grown(q)) ==
                      metric.in_circle(i, j, k, q));
    }
}
RC_GTEST_PROP(LawsOfAdditive, WhatIsHiddenStaysHiddenWhenItShrinks, ()) {
    const Site q = *site(), i = *site();
    for (const Additive& metric : additive_metrics)
        if (metric.hidden(q, i)) RC_ASSERT(metric.hidden({q.x, q.y, q.r - 1}, i));
}

RC_GTEST_PROP(LawsOfSums, TheOrderDoesNotMatterAndTheOppositeHasTheOppositeSign, ()) {
    std::vector<double> terms = *rc::gen::container<std::vector<double>>(number());
    const Sign sign = sign_of_sum(terms);
    std::reverse(terms.begin(), terms.end());
    RC_ASSERT(sign_of_sum(terms) == sign);
    for (double& term : terms) term = -term;
    RC_ASSERT(sign_of_sum(terms) == -sign);
}
RC_GTEST_PROP(LawsOfSums, AListAndItsOppositeLeaveWhatElseThereIs, ()) {
    const std::vector<double> terms = *rc::gen::container<std::vector<double>>(any_finite());
    const double rest = *any_finite();
    std::vector<double> all = terms;
    all.push_back(rest);
    for (const double term : terms) all.push_back(-term);
    RC_ASSERT(sign_of_sum(all) == (rest > 0) - (rest < 0));
}

template <class Metric>
class LawsOfTessellations : public testing::Test {};
using Metrics = testing::Types<Power, Euclidean, Manhattan, Supremum>;
TYPED_TEST_SUITE(LawsOfTessellations, Metrics);

TYPED_TEST(LawsOfTessellations, AreCanonicalForTheirJudge) {
    EXPECT_TRUE(rc::check([] {
        const Validation judged = validate(triangulate(*sites(), TypeParam{}));
        RC_ASSERT(judged.valid);
        RC_ASSERT(judged.canonical);
    }));
}
TYPED_TEST(LawsOfTessellations, MoveAndGrowWithTheirSites) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Site> some = *sites();
        const TessellationArrays before = triangulate(some, TypeParam{}).arrays();
        const double factor = std::ldexp(1.0, *rc::gen::inRange(-200, 200));
        const double x = *small_integer(), y = *small_integer();
        for (Site& each : some) each = scaled(Site{each.x + x, each.y + y, each.r}, factor);
        RC_ASSERT(triangulate(some, TypeParam{}).arrays() == before);
    }));
}
TYPED_TEST(LawsOfTessellations, WhatComesAndGoesLeavesNothing) {
    EXPECT_TRUE(rc::check([] {
        DynamicTessellation changing(TypeParam::metric);
        const std::vector<Site> some = *sites();
        for (const Site& each : some) changing.insert(each);
        const TessellationArrays before = changing.tessellation().arrays();
        const Index guest = changing.insert(*site());
        changing.erase(guest);
        RC_ASSERT(changing.tessellation().arrays() == before);
    }));
}
RC_GTEST_PROP(LawsOfSpace, TessellationsMoveAndGrowWithTheirSites, ()) {
    const auto ball = rc::gen::apply(
        [](double x, double y, double z, double r) {
            return Site3{x, y, z, r};
        },
        small_integer(), small_integer(), small_integer(), radius());
    std::vector<Site3> balls = *rc::gen::container<std::vector<Site3>>(ball);
    const SpaceTessellation before = triangulate(balls, Power{});
    const double factor = std::ldexp(1.0, *rc::gen::inRange(-200, 200));
    for (Site3& b : balls)
        b = {(b.x + 3) * factor, (b.y - 2) * factor, (b.z + 1) * factor, b.r * factor};
    RC_ASSERT(triangulate(balls, Power{}) == before);
}

}  // namespace
}  // namespace signum
