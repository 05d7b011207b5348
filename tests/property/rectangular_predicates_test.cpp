// The predicates of the supremum and Manhattan metrics: the tessellation that they choose by brute
// force against the oracle's, every stage against rationals, all floating-point environments.

#include "../../predicates/manhattan.hpp"
#include "../../predicates/supremum.hpp"

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "../oracle/rectangular.hpp"
#include "../thoroughness.hpp"
#include "../unit/exact_reference.hpp"
#include "additive_brute_force.hpp"
#include "degenerate_sites.hpp"

namespace {

using signum::Arithmetic;
using signum::Decision;
using signum::Index;
using signum::Site;
using signum::Stage;
using signum::brute_force::expect_oracle;
using signum::brute_force::ranks_of;
using signum::brute_force::Sites;
using signum::rectangular::Manhattan;
using signum::rectangular::Perturbed;
using signum::rectangular::Supremum;
constexpr auto judging = signum::Arithmetic::judging;

/// Of the trials one in so many: rationals take long there.
const int share = signum::is_fast ? 1 : 10;

template <class Directions>
signum::oracle::Tessellation oracle_of(const Sites& sites) {
    if constexpr (std::is_same_v<Directions, Supremum>) {
        return signum::oracle::supremum(sites);
    } else {
        return signum::oracle::manhattan(sites);
    }
}

template <class Directions>
class RectangularPredicates : public testing::Test {};
using Metrics = testing::Types<Supremum, Manhattan>;
TYPED_TEST_SUITE(RectangularPredicates, Metrics);

TYPED_TEST(RectangularPredicates, ChooseTheTessellationOfTheOracle) {
    std::mt19937_64 random(7);
    const auto integer = [&](int from, int to) {
        return static_cast<double>(std::uniform_int_distribution<int>(from, to)(random));
    };
    for (int trial = 0; trial < 1500 / share; ++trial) {
        Sites sites(static_cast<std::size_t>(integer(2, 7)));
        const int box = 1 + trial % 8;
        const int largest = trial / 8 % 4;
        for (Site& site : sites) site = {integer(0, box), integer(0, box), integer(0, largest)};
        ASSERT_NO_FATAL_FAILURE(
            expect_oracle<Perturbed<TypeParam>>(sites, oracle_of<TypeParam>(sites)));
    }
    for (int trial = 0; trial < 300 / share; ++trial) {
        std::uniform_real_distribution<double> place(0, 10);
        Sites sites(static_cast<std::size_t>(integer(2, 7)));
        for (Site& site : sites) site = {place(random), place(random), place(random) / 5};
        ASSERT_NO_FATAL_FAILURE(
            expect_oracle<Perturbed<TypeParam>>(sites, oracle_of<TypeParam>(sites)));
    }
}

/// All answers about four sites; 0 where a precondition fails.
template <class Predicates>
std::array<int, 8> answers(const Site (&s)[4], const std::array<Index, 4>& r) {
    const std::array<Index, 3> first = {r[0], r[1], r[2]};
    const auto apart = [&](std::size_t a, std::size_t b) {
        return Predicates::hides(s[a], s[b], {r[a], r[b]}).sign < 0 &&
               Predicates::hides(s[b], s[a], {r[b], r[a]}).sign < 0;
    };
    const int exists = Predicates::exists(s[0], s[1], s[2], first).sign;
    const int twice = Predicates::exists_twice(s[0], s[1], s[2], first).sign;
    const bool both =
        twice > 0 && Predicates::exists_twice(s[0], s[1], s[3], {r[0], r[1], r[3]}).sign > 0;
    return {Predicates::hides(s[0], s[1], {r[0], r[1]}).sign,
            exists,
            exists > 0 ? Predicates::in_circle(s[0], s[1], s[2], s[3], r).sign : 0,
            apart(0, 1) ? Predicates::in_circle_infinite(s[0], s[1], s[2], first).sign : 0,
            twice,
            both ? Predicates::precedes_on_bisector(s[0], s[1], s[2], s[3], r).sign : 0,
            apart(0, 1) && apart(1, 2)
                ? Predicates::holds_first_direction(s[0], s[1], s[2], first).sign
                : 0,
            Predicates::nearer({s[0].x, s[0].y}, s[1], s[2], {r[1], r[2]}).sign};
}

TYPED_TEST(RectangularPredicates, AgreeWithRationalsForEveryDoubleInEveryEnvironment) {
    signum::brute_force::Degenerate degenerate(11);
    signum::reference::Random& random = degenerate.random();
    int vertices = 0;
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        Site s[4];
        // Any doubles; a few of them again and again; rounding errors beside a common square; small
        // integers in degenerate positions, some of them scaled up or down as far as doubles go.
        const double some[4] = {random.finite(), random.finite(), random.finite(), 0.0};
        const auto number = [&]() -> double {
            if (trial % 3 == 0) return random.finite();
            const double value = some[random.between(0, 3)];
            if (trial % 3 == 1) return value;
            return std::nextafter(1.0 + random.between(0, 3), random.between(-9, 9));
        };
        for (Site& site : s) site = {number(), number(), number()};
        if (trial % 4 == 3) {
            degenerate.fill(trial / 4 % signum::brute_force::Degenerate::families, s, 4);
            const double scale = some[0] < 0 ? 1.0 : some[1] < 0 ? 0x1p-1074 : 0x1p1015;
            for (Site& site : s) site = {site.x * scale, site.y * scale, site.r * scale};
        }
        const std::array<Index, 4> r = ranks_of(s);
        const auto expected = answers<Perturbed<TypeParam, Arithmetic::multiprecision>>(s, r);
        const auto given =
            signum::reference::in_environment(trial % signum::reference::Hostile::modes,
                                              [&] { return answers<Perturbed<TypeParam>>(s, r); });
        ASSERT_EQ(given, expected) << trial;
        const auto judged = signum::reference::in_environment(
            trial % signum::reference::Hostile::modes,
            [&] { return answers<Perturbed<TypeParam, judging>>(s, r); });
        ASSERT_EQ(judged, expected) << trial;
        ASSERT_EQ((answers<Perturbed<TypeParam, judging>>(s, r)), expected) << trial;
        ASSERT_EQ((answers<Perturbed<TypeParam, Arithmetic::sum>>(s, r)), expected) << trial;
        ASSERT_EQ((answers<Perturbed<TypeParam, Arithmetic::interval>>(s, r)), expected) << trial;
        vertices += static_cast<int>(expected[3] != 0);
    }
    EXPECT_GT(vertices, 1000 / share);
}

TYPED_TEST(RectangularPredicates, SayWhichStageAnswered) {
    const auto stage = [](const Site& q) {
        return Perturbed<TypeParam>::in_circle({0.3, -5.5, 1}, {6.6, 0.7, 1}, {-1, 5.1, 1}, q,
                                               {0, 1, 2, 3})
            .stage;
    };
    EXPECT_EQ(stage({-7.125, 0.375, 1}), Stage::filter);
    // 0.3 + 0.7 is less than 1 by less than doubles tell; 0.1 + 0.9 is more.
    for (const auto& [x, r, sign] : {std::tuple(0.3, 0.7, 1), std::tuple(0.1, 0.9, -1)}) {
        const Decision rounds = Perturbed<TypeParam>::hides({0, 0, 1}, {x, 0, r}, {0, 1});
        EXPECT_EQ(rounds.stage, Stage::essa);
        EXPECT_EQ(rounds.sign, sign);
        EXPECT_FALSE(rounds.tied);
    }
    // A square of small integers: the sums commit no rounding, which is seen before ESSA is asked.
    const auto tie = [](auto predicates) {
        return decltype(predicates)::hides({0, 0, 2}, {1, 0, 1}, {0, 1});
    };
    EXPECT_EQ(tie(Perturbed<TypeParam>()).stage, Stage::exact);
    EXPECT_TRUE(tie(Perturbed<TypeParam>()).tied);
    EXPECT_EQ(tie(Perturbed<TypeParam, Arithmetic::sum>()).stage, Stage::essa);
    EXPECT_EQ(tie(Perturbed<TypeParam, Arithmetic::interval>()).stage, Stage::essa);
    const Decision rational = Perturbed<TypeParam, Arithmetic::multiprecision>::in_circle(
        {0, -5, 1}, {6, 0.5, 1}, {-1, 5.1, 1}, {-7, 0.25, 1}, {0, 1, 2, 3});
    EXPECT_EQ(rational.stage, Stage::multiprecision);
}

TYPED_TEST(RectangularPredicates, WithoutTheTieRuleATouchIsZero) {
    // Three sites on three sides of a square with centre 0, scaled to the metric's own axes; the
    // fourth touches the last side, comes closer, stays away.
    const auto site = [](int side, double distance, double r) {
        const double length = std::abs(TypeParam::x[side]) + std::abs(TypeParam::y[side]);
        return Site{TypeParam::x[side] * distance / length, TypeParam::y[side] * distance / length,
                    r};
    };
    const Site i = site(0, 8, 2);
    const Site j = site(1, 7, 1);
    const Site k = site(2, 6.5, 0.5);
    const auto answer = [&](double distance) {
        return signum::rectangular::in_circle_decision<TypeParam>(i, j, k, site(3, distance, 1),
                                                                  {0, 1, 3, 2})
            .sign;
    };
    EXPECT_EQ(answer(7), 0);
    EXPECT_EQ(answer(std::nextafter(7, 8)), -1);
    EXPECT_EQ(answer(std::nextafter(7, 6)), 1);
}

TYPED_TEST(RectangularPredicates, AConflictIsTiedWhereWithoutTheTieRuleItTouches) {
    std::mt19937_64 random(9);
    std::uniform_int_distribution<int> place(0, 6);
    std::uniform_int_distribution<int> radius(0, 2);
    int touch = 0;
    int meet = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        Site s[4];
        for (Site& site : s)
            site = {static_cast<double>(place(random)), static_cast<double>(place(random)),
                    static_cast<double>(radius(random))};
        const auto r = signum::brute_force::ranks_of(s);
        using Asked = Perturbed<TypeParam>;
        if (Asked::exists(s[0], s[1], s[2], {r[0], r[1], r[2]}).sign < 0) continue;
        const Decision conflict = Asked::in_circle(s[0], s[1], s[2], s[3], r);
        if (conflict.sign < 0) continue;
        const Decision plain =
            signum::rectangular::in_circle_decision<TypeParam>(s[0], s[1], s[2], s[3], r);
        ASSERT_GE(plain.sign, 0);
        ASSERT_EQ(conflict.tied, plain.sign == 0) << "trial " << trial;
        ++(plain.sign == 0 ? touch : meet);
    }
    EXPECT_GT(touch, 100);
    EXPECT_GT(meet, 100);
}

TYPED_TEST(RectangularPredicates, OfTwoThatAreAsNearTheEarlierOneIsNearer) {
    const auto nearer = [](const Site& a, const Site& b, const std::array<Index, 2>& ranks) {
        return Perturbed<TypeParam>::nearer({1, 1}, a, b, ranks);
    };
    for (const Site& b : {Site{-2, 1, 0}, Site{1, -3, 1}, Site{4, 1, 0}}) {
        EXPECT_EQ(nearer({4, 1, 0}, b, {0, 1}).sign, 1);
        EXPECT_EQ(nearer({4, 1, 0}, b, {1, 0}).sign, -1);
        EXPECT_TRUE(nearer({4, 1, 0}, b, {0, 1}).tied);
    }
    EXPECT_EQ(nearer({4, 1, 0}, {-2, 1, 0.5}, {0, 1}).sign, -1);
    EXPECT_FALSE(nearer({4, 1, 0}, {-2, 1, 0.5}, {0, 1}).tied);
}

TEST(RectangularTies, AreDecidedByTheLastSiteWhoseFactorsDoNotCancel) {
    using signum::rectangular::Addend;
    using signum::rectangular::sign_of_infinitesimals;
    const auto sign = [](const std::vector<std::array<int, 2>>& ranks_and_factors) {
        std::vector<Addend> addends;
        for (const auto& [rank, factor] : ranks_and_factors)
            addends.push_back({nullptr, rank, 0, factor});
        return sign_of_infinitesimals(addends.data(), addends.size());
    };
    EXPECT_EQ(sign({{0, 1}, {3, -1}, {2, 1}}), -1);
    EXPECT_EQ(sign({{3, 1}, {1, -1}, {3, -1}}), -1);
    EXPECT_EQ(sign({{3, -2}, {1, 1}, {3, 1}}), -1);
    EXPECT_EQ(sign({{3, 2}, {1, -1}, {3, -1}}), 1);
    EXPECT_EQ(sign({{3, 1}, {1, -1}, {3, -1}, {1, 1}}), 0);
}

}  // namespace
