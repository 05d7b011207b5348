// The predicates of the supremum and Manhattan metrics: the tessellation that they choose by brute
// force against the oracle's, every stage against rationals, all floating-point environments.

#include <signum/predicates/manhattan.hpp>
#include <signum/predicates/supremum.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/rectangular.hpp"
#include "unit/exact_reference.hpp"

namespace {

using signum::Decision;
using signum::Index;
using signum::Site;
using signum::Stage;
using signum::rectangular::Manhattan;
using signum::rectangular::Perturbed;
using signum::rectangular::Sums;
using signum::rectangular::Supremum;
using Sites = std::vector<Site>;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

/// The place of every site in the order of the tie rule.
std::vector<Index> ranks_of(const Sites& sites) {
    std::vector<Index> order(sites.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return signum::additive::precedes(sites[at(a)], a, sites[at(b)], b);
    });
    std::vector<Index> ranks(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) ranks[at(order[i])] = static_cast<Index>(i);
    return ranks;
}

/// Every triple of visible sites that has a vertex with which no other site conflicts.
template <class Predicates>
signum::oracle::Tessellation brute_force(const Sites& sites) {
    const std::vector<Index> rank = ranks_of(sites);
    const auto n = static_cast<Index>(sites.size());
    std::vector<Index> visible;
    signum::oracle::Tessellation result;
    for (Index q = 0; q < n; ++q) {
        bool hidden = false;
        for (Index i = 0; i < n; ++i)
            hidden |=
                i != q &&
                Predicates::hides(sites[at(i)], sites[at(q)], {rank[at(i)], rank[at(q)]}).sign > 0;
        if (hidden) {
            result.hidden.push_back({q, -1});
        } else {
            visible.push_back(q);
        }
    }
    const auto none = [&](auto conflicts, std::initializer_list<Index> but) {
        return std::none_of(visible.begin(), visible.end(), [&](Index q) {
            return std::find(but.begin(), but.end(), q) == but.end() && conflicts(q).sign > 0;
        });
    };
    for (const Index i : visible)
        for (const Index j : visible) {
            if (i == j) continue;
            const Site& a = sites[at(i)];
            const Site& b = sites[at(j)];
            if (none(
                    [&](Index q) {
                        return Predicates::in_circle_infinite(
                            a, b, sites[at(q)], {rank[at(i)], rank[at(j)], rank[at(q)]});
                    },
                    {i, j}))
                result.faces.push_back({-1, j, i});
            for (const Index k : visible) {
                if (k <= i || k == j || j <= i) continue;
                for (const auto& [u, v] : {std::pair(j, k), std::pair(k, j)}) {
                    if (j > k) continue;
                    const Site& s = sites[at(u)];
                    const Site& t = sites[at(v)];
                    if (Predicates::exists(a, s, t, {rank[at(i)], rank[at(u)], rank[at(v)]}).sign <
                        0)
                        continue;
                    if (none(
                            [&](Index q) {
                                return Predicates::in_circle(
                                    a, s, t, sites[at(q)],
                                    {rank[at(i)], rank[at(u)], rank[at(v)], rank[at(q)]});
                            },
                            {i, u, v}))
                        result.faces.push_back({i, u, v});
                }
            }
        }
    std::sort(result.faces.begin(), result.faces.end());
    return result;
}

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

template <class Directions>
void expect_oracle(const Sites& sites) {
    const signum::oracle::Tessellation expected = oracle_of<Directions>(sites);
    const auto chosen = brute_force<Perturbed<Directions>>(sites);
    std::string input;
    for (const Site& s : sites)
        input += testing::PrintToString(s.x) + " " + testing::PrintToString(s.y) + " " +
                 testing::PrintToString(s.r) + "\n";
    ASSERT_EQ(chosen.faces, expected.faces) << input;
    ASSERT_EQ(chosen.hidden.size(), expected.hidden.size()) << input;
    for (std::size_t i = 0; i < chosen.hidden.size(); ++i)
        ASSERT_EQ(chosen.hidden[i][0], expected.hidden[i][0]) << input;
}

TYPED_TEST(RectangularPredicates, ChooseTheTessellationOfTheOracle) {
    std::mt19937_64 random(7);
    const auto integer = [&](int from, int to) {
        return static_cast<double>(std::uniform_int_distribution<int>(from, to)(random));
    };
    for (int trial = 0; trial < 1500; ++trial) {
        Sites sites(static_cast<std::size_t>(integer(2, 7)));
        const int box = 1 + trial % 8;
        const int largest = trial / 8 % 4;
        for (Site& site : sites) site = {integer(0, box), integer(0, box), integer(0, largest)};
        ASSERT_NO_FATAL_FAILURE(expect_oracle<TypeParam>(sites));
    }
    for (int trial = 0; trial < 300; ++trial) {
        std::uniform_real_distribution<double> place(0, 10);
        Sites sites(static_cast<std::size_t>(integer(2, 7)));
        for (Site& site : sites) site = {place(random), place(random), place(random) / 5};
        ASSERT_NO_FATAL_FAILURE(expect_oracle<TypeParam>(sites));
    }
}

/// All answers about four sites; 0 where a precondition fails.
template <class Predicates>
std::array<int, 5> answers(const Site (&s)[4], const std::array<Index, 4>& r) {
    const int hides = Predicates::hides(s[0], s[1], {r[0], r[1]}).sign;
    const int exists = Predicates::exists(s[0], s[1], s[2], {r[0], r[1], r[2]}).sign;
    const bool apart = hides < 0 && Predicates::hides(s[1], s[0], {r[1], r[0]}).sign < 0;
    return {hides, exists, exists > 0 ? Predicates::in_circle(s[0], s[1], s[2], s[3], r).sign : 0,
            apart ? Predicates::in_circle_infinite(s[0], s[1], s[2], {r[0], r[1], r[2]}).sign : 0};
}

TYPED_TEST(RectangularPredicates, AgreeWithRationalsForEveryDoubleInEveryEnvironment) {
    signum::reference::Random random(11);
    int vertices = 0;
    for (int trial = 0; trial < 60'000; ++trial) {
        Site s[4];
        // Any doubles; a few of them again and again; rounding errors beside a common square.
        const double some[4] = {random.finite(), random.finite(), random.finite(), 0.0};
        const auto number = [&]() -> double {
            if (trial % 3 == 0) return random.finite();
            const double value = some[random.between(0, 3)];
            if (trial % 3 == 1) return value;
            return std::nextafter(1.0 + random.between(0, 3), random.between(-9, 9));
        };
        for (Site& site : s) site = {number(), number(), number()};
        const std::vector<Index> place = ranks_of({s, s + 4});
        const std::array<Index, 4> r = {place[0], place[1], place[2], place[3]};
        const auto expected = answers<Perturbed<TypeParam, Sums::multiprecision>>(s, r);
        const auto given =
            signum::reference::in_environment(trial % signum::reference::Hostile::modes,
                                              [&] { return answers<Perturbed<TypeParam>>(s, r); });
        ASSERT_EQ(given, expected) << trial;
        vertices += static_cast<int>(expected[3] != 0);
    }
    EXPECT_GT(vertices, 1000);
}

TYPED_TEST(RectangularPredicates, SayWhichStageAnswered) {
    const auto stage = [](const Site& q) {
        return Perturbed<TypeParam>::in_circle({0.3, -5.5, 1}, {6.6, 0.7, 1}, {-1, 5.1, 1}, q,
                                               {0, 1, 2, 3})
            .stage;
    };
    EXPECT_EQ(stage({-7.125, 0.375, 1}), Stage::filter);
    EXPECT_EQ(stage({0.3, -5.5, 1}), Stage::exact);
    const Decision rational = Perturbed<TypeParam, Sums::multiprecision>::in_circle(
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

}  // namespace
