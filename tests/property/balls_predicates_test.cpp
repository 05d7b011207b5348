// The predicates of balls in the metric |x-c| - r, and the spheres that touch them, against the
// oracle, which solves for the spheres in rationals: on inputs made to break them, in every
// rounding mode, with and without flushing of denormals. In the plane by the same text, and against
// the plane's own predicates.

#include <gtest/gtest.h>
#include <mpfr.h>

#include <map>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/formulas/balls.hpp"
#include "../../predicates/ladder/balls.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/space/euclidean.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "../../voronoi/balls/touching_spheres.hpp"
#include "ball_families.hpp"
#include "environments.hpp"
#include "rounded_surd.hpp"

namespace signum {
namespace {

using ball_families::families;
using ball_families::Family;

Decision exists_of(const SitesOf<Site3>& s) {
    return euclidean::exists_decision(s[0], s[1], s[2], s[3]);
}
Decision exists_of(const SitesOf<Site>& s) {
    return euclidean::balls::exists_decision(s[0], s[1], s[2]);
}
Decision in_sphere_of(const SitesOf<Site3>& s) {
    return euclidean::in_sphere_decision(s[0], s[1], s[2], s[3], s[4]);
}
Decision in_sphere_of(const SitesOf<Site>& s) {
    return euclidean::balls::in_circle_decision(s[0], s[1], s[2], s[3]);
}
Decision hides_of(const SitesOf<Site3>& s) {
    return euclidean::hides_decision(s[0], s[4]);
}
Decision hides_of(const SitesOf<Site>& s) {
    return euclidean::balls::hides_decision(s[0], s[3]);
}

/// Asserts that the predicate says `expected` of the sites in every environment.
template <class S, class Predicate>
[[nodiscard]] testing::AssertionResult says(const SitesOf<S>& sites, int expected,
                                            const Predicate& predicate) {
    for (int e = 0; e < environments; ++e) {
        const Decision d = within(e, [&] { return predicate(sites); });
        if (d.sign != expected)
            return testing::AssertionFailure()
                   << d.sign << " by " << name_of(d.stage) << ", not " << expected << ", rounding "
                   << name_of_environment(e) << ": " << text_of<S>(sites);
    }
    return testing::AssertionSuccess();
}

/// The number in 500 bits, then as a double: a second opinion where nothing cancels to the last
/// bit.
double by_500_bits(const oracle::Surd& number) {
    mpfr_t root;
    mpfr_init2(root, 500);
    mpfr_set_q(root, number.g().backend().data(), MPFR_RNDN);
    mpfr_sqrt(root, root, MPFR_RNDN);
    mpfr_mul_q(root, root, number.b().backend().data(), MPFR_RNDN);
    mpfr_add_q(root, root, number.a().backend().data(), MPFR_RNDN);
    const double result = mpfr_get_d(root, MPFR_RNDN);
    mpfr_clear(root);
    return result;
}

class Balls : public testing::TestWithParam<Family> {
 protected:
    Random random_{2026};
    template <class S>
    [[nodiscard]] SitesOf<S> draw() {
        return sites_of<S>(GetParam().draw(random_, dimension_of<S>));
    }
    /// slow/large_balls_test asks ten million more.
    [[nodiscard]] static int trials(int count) {
        return static_cast<int>(0.4 * count * GetParam().share * effort) + 1;
    }

    template <class S>
    void test_in_sphere(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            auto sites = draw<S>();
            auto spheres = oracle::touching_spheres<dimension_of<S>>(tuple_of<S>(sites));
            const int exists = positive(spheres) != nullptr ? 1 : -1;
            ASSERT_TRUE(says<S>(sites, exists, [](const auto& s) { return exists_of(s); }));
            if (exists < 0) {
                std::swap(sites[0], sites[1]);
                spheres = oracle::touching_spheres<dimension_of<S>>(tuple_of<S>(sites));
                if (positive(spheres) == nullptr) continue;
                ASSERT_EQ(exists_of(sites).sign, 1) << text_of<S>(sites);
            }
            const int expected = -oracle::side<dimension_of<S>>(*positive(spheres),
                                                                oracle::exact_ball(sites.back()));
            ASSERT_TRUE(says<S>(sites, expected, [](const auto& s) { return in_sphere_of(s); }));
            if constexpr (dimension_of<S> == 3) {
                if (trial % 4 != 0) continue;
                const auto& [i, j, k, l, q] = sites;
                using namespace euclidean::balls;
                ASSERT_EQ((ask_exactly<InSphere, 3>(balls_of(i, j, k, l, q))), expected)
                    << text_of<S>(sites);
                ASSERT_EQ((ask_exactly<Exists, 3>(balls_of(i, j, k, l))), 1);
                ASSERT_EQ((ask_exactly<Exists, 3>(balls_of(i, j, l, k))) > 0,
                          spheres.spheres.size() == 2);
            }
        }
    }

    template <class S>
    void test_touching_spheres(int count) {
        constexpr int d = dimension_of<S>;
        for (int trial = trials(count); trial > 0; --trial) {
            const auto sites = draw<S>();
            const auto expected = oracle::touching_spheres<d>(tuple_of<S>(sites));
            const TouchingSpheres<S> found = within(trial % environments, [&] {
                return touching_spheres(std::span(sites.data(), sites.size() - 1));
            });
            ASSERT_EQ(static_cast<int>(found.count), static_cast<int>(expected.count))
                << text_of<S>(sites);
            for (std::size_t m = 0; m < expected.spheres.size(); ++m) {
                const auto& [sphere, orientation] = found.spheres[m];
                // The oracle has the opposite order in space.
                const auto& other = expected.spheres[d == 2 ? m : expected.spheres.size() - 1 - m];
                ASSERT_EQ(orientation, turn_of(other)) << text_of<S>(sites);
                ASSERT_TRUE(is_rounded(sphere.x, other.c[0])) << text_of<S>(sites);
                ASSERT_TRUE(is_rounded(sphere.y, other.c[1])) << text_of<S>(sites);
                if constexpr (d == 3) {
                    ASSERT_TRUE(is_rounded(sphere.z, other.c[2])) << text_of<S>(sites);
                }
                ASSERT_TRUE(is_rounded(sphere.r, other.rho)) << text_of<S>(sites);
            }
        }
    }

    template <class S>
    void test_hides(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            const auto sites = draw<S>();
            const bool expected =
                oracle::contains(oracle::exact_ball(sites[0]), oracle::exact_ball(sites.back()));
            ASSERT_TRUE(
                says<S>(sites, expected ? 1 : -1, [](const auto& s) { return hides_of(s); }));
        }
    }
};

TEST_P(Balls, InSphere) {
    test_in_sphere<Site3>(1500);
}
TEST_P(Balls, InCircle) {
    test_in_sphere<Site>(1500);
}
TEST_P(Balls, Hides) {
    test_hides<Site3>(2000);
    test_hides<Site>(1000);
}
TEST_P(Balls, TouchingSpheres) {
    test_touching_spheres<Site3>(1000);
}
TEST_P(Balls, TouchingCircles) {
    test_touching_spheres<Site>(1000);
}

/// Wherever no tie rule speaks.
TEST_P(Balls, InThePlaneAreThePlanesDiscs) {
    for (int trial = trials(3000); trial > 0; --trial) {
        const auto s = draw<Site>();
        const auto ranks = additive::ranks_of<4>({&s[0], &s[1], &s[2], &s[3]});
        using Plane = euclidean::Perturbed<>;
        const Decision exists = Plane::exists(s[0], s[1], s[2], {ranks[0], ranks[1], ranks[2]});
        const Decision ours = exists_of(s);
        ASSERT_TRUE(exists.tied || ours.sign == exists.sign) << text_of<Site>(s);
        const Decision hides = Plane::hides(s[0], s[3], {ranks[0], ranks[3]});
        ASSERT_TRUE(hides.tied || hides_of(s).sign == hides.sign) << text_of<Site>(s);
        if (ours.sign < 0 || exists.sign < 0) continue;
        if (euclidean::hidden(s[3], s[0]) || euclidean::hidden(s[3], s[1]) ||
            euclidean::hidden(s[3], s[2]))
            continue;
        ASSERT_EQ(in_sphere_of(s).sign,
                  euclidean::in_circle_decision(s[0], s[1], s[2], s[3], ranks).sign)
            << text_of<Site>(s);
    }
}

/// Of equal radii they are Delaunay's, whoever answers.
TEST_P(Balls, OfEqualRadiiArePoints) {
    for (int trial = trials(2000); trial > 0; --trial) {
        auto s = draw<Site3>();
        for (Site3& site : s) site.r = s[0].r;
        const auto p = [&](std::size_t m) { return centre3(s[m]); };
        const Sign turn = ccw(p(0), p(1), p(2), p(3));
        ASSERT_EQ(exists_of(s).sign > 0, turn > 0) << text_of<Site3>(s);
        if (turn <= 0) continue;
        const Sign expected = power::in_sphere(p(0), p(1), p(2), p(3), p(4));
        ASSERT_EQ(in_sphere_of(s).sign, expected) << text_of<Site3>(s);
        if (trial % 4 != 0) continue;
        using namespace euclidean::balls;
        ASSERT_EQ((ask_exactly<InSphere, 3>(balls_of(s[0], s[1], s[2], s[3], s[4]))), expected)
            << text_of<Site3>(s);
    }
}

/// A power of two changes nothing, wherever products of some of the numbers begin to over- or
/// underflow.
TEST_P(Balls, ScaleByPowersOfTwo) {
    for (int trial = trials(8000); trial > 0; --trial) {
        const auto sites = draw<Site3>();
        bool holds = true;
        for (const Site3& s : sites)
            for (const double number : {s.x, s.y, s.z, s.r})
                holds &= number == 0.0 || std::ldexp(std::ldexp(number, -240), 240) == number;
        if (!holds) continue;
        const Sign exists = exists_of(sites).sign;
        const Sign conflict = exists > 0 ? in_sphere_of(sites).sign : 0;
        for (int place = 0; place < 4; ++place) {
            const int exponent = random_.between(-240, 120);
            auto scaled = sites;
            for (Site3& s : scaled)
                for (double* number : {&s.x, &s.y, &s.z, &s.r})
                    *number = std::ldexp(*number, exponent);
            if (!std::all_of(scaled.begin(), scaled.end(),
                             [](const Site3& s) { return are_finite(s); }))
                continue;
            ASSERT_EQ(exists_of(scaled).sign, exists) << text_of<Site3>(scaled);
            if (exists < 0) continue;
            ASSERT_EQ(in_sphere_of(scaled).sign, conflict) << text_of<Site3>(scaled);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Balls, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

// ---- the identities ----------------------------------------------------------------------------

/// A² - L² Γ = Q G, of which B² - E_R² Γ = Q Σ E'_k² is a case.
template <std::size_t d>
void test_identities() {
    using namespace euclidean::balls;
    using oracle::Rational;
    Random random(3);
    for (int trial = 0; trial < 500; ++trial) {
        std::array<Ball<d, Rational>, d + 1> balls;
        for (auto& ball : balls)
            for (Rational& number : ball) number = random.between(-9, 9);
        Ball<d, Rational> query;
        for (Rational& number : query) number = random.between(-9, 9);
        const Tuple<d, Rational> t(balls);
        const WithQuery<d, Rational> with_q(t.e, row<d, Rational>(query, balls[0]));
        const Rational four = four_gamma<d, Rational>(t.rows, rows_between<d, Rational>(balls));
        const Rational a = minus_a<Rational, d, Rational>(t, with_q);
        const Rational l = euclidean::balls::l<d, Rational>(with_q);
        const Rational g = inner<d, Rational, last<d>, last<d>>(with_q, with_q);
        ASSERT_EQ(4 * a * a - l * l * four, 4 * t.q() * g);
        // In the row of a 1 at R and p = 0 they are those of B.
        Row<d, Rational> unit{};
        unit[d] = 1;
        const WithQuery<d, Rational> with_unit(t.e, unit);
        ASSERT_EQ((-minus_a<Rational, d, Rational>(t, with_unit)), t.b());
        ASSERT_EQ((euclidean::balls::l<d, Rational>(with_unit)), t.e_r());
    }
}
TEST(BallPolynomials, Identities) {
    test_identities<2>();
    test_identities<3>();
}

// ---- stages ------------------------------------------------------------------------------------

/// Which stages answer, of what.
template <class S>
std::map<Stage, int> stages_of(AnyBalls (*draw)(Random&, int)) {
    Random random(7);
    std::map<Stage, int> count;
    for (int trial = 0; trial < 4000; ++trial) {
        const auto s = sites_of<S>(draw(random, dimension_of<S>));
        if (exists_of(s).sign > 0) ++count[in_sphere_of(s).stage];
    }
    return count;
}
int of(const std::map<Stage, int>& count, Stage stage) {
    return count.contains(stage) ? count.at(stage) : 0;
}
int all(const std::map<Stage, int>& count) {
    int sum = 0;
    for (const auto& [stage, times] : count) sum += times;
    return sum;
}

TEST(BallStages, TheFilterTellsAllThatIsRandom) {
    for (const auto& count : {stages_of<Site3>(ball_families::random_balls),
                              stages_of<Site>(ball_families::random_balls)}) {
        EXPECT_GT(all(count), 500);
        EXPECT_EQ(of(count, Stage::filter), all(count));
    }
}
TEST(BallStages, IntegersTellTies) {
    // From 0 the next double is 1074 bits away.
    const auto moved_numbers = [](Random& g, int d) {
        return ball_families::changed(ball_families::tangent(g, d),
                                      [&](double v) { return v == 0.0 ? v : moved(g, v); });
    };
    const auto off_grid = [](Random& g, int d) {
        return ball_families::off_grid(ball_families::tangent(g, d));
    };
    for (const auto& count :
         {stages_of<Site3>(ball_families::tangent), stages_of<Site3>(moved_numbers),
          stages_of<Site3>(off_grid), stages_of<Site>(ball_families::tangent)}) {
        EXPECT_GT(of(count, Stage::exact), 300);
        EXPECT_EQ(of(count, Stage::multiprecision), 0);
    }
}
TEST(BallStages, IntegersOfAnySizeTellWhatSpans400Bits) {
    const auto far = [](Random& g, int d) {
        AnyBalls balls = ball_families::tangent(g, d);
        for (AnyBall& b : balls) b.x[0] += g.coin() ? 0x1p-150 : 0.0;
        for (AnyBall& b : balls)
            for (double& x : b.x) x = x == 0.0 ? 0x1p-150 : x;
        return balls;
    };
    const auto count = stages_of<Site3>(far);
    EXPECT_GT(of(count, Stage::exact), 100);
    EXPECT_EQ(of(count, Stage::multiprecision), 0);
}
TEST(BallStages, RationalsTellTheRest) {
    const auto far = [](Random& g, int d) {
        AnyBalls balls = ball_families::tangent(g, d);
        for (AnyBall& b : balls)
            for (double& x : b.x) x = x == 0.0 ? 0x1p-600 : x;
        return balls;
    };
    EXPECT_GT(of(stages_of<Site3>(far), Stage::multiprecision), 100);
}
TEST(BallStages, LongDoublesTellRawBits) {
    const auto small = [](Random& g, int d) {
        return ball_families::changed(ball_families::random_balls(g, d),
                                      [&](double v) { return std::ldexp(v, -100 - g.below(100)); });
    };
    const auto count = stages_of<Site3>(small);
    EXPECT_GT(all(count), 300);
    EXPECT_GT(of(count, Stage::filter), all(count) * 9 / 10);
}

TEST(TouchingSpheres, OfRandomBallsAsIn500Bits) {
    Random random(5);
    int spheres = 0;
    for (int trial = 0; trial < 2000 * effort; ++trial) {
        const auto sites = sites_of<Site3>(ball_families::random_balls(random, 3));
        const auto expected = oracle::touching_spheres<3>(tuple_of<Site3>(sites)).spheres;
        const auto found = touching_spheres(std::span(sites).first(4)).spheres;
        for (std::size_t m = 0; m < expected.size(); ++m) {
            const auto& [centre, rho, turn] = expected[expected.size() - 1 - m];
            ASSERT_EQ(found[m].sphere, (Site3{by_500_bits(centre[0]), by_500_bits(centre[1]),
                                              by_500_bits(centre[2]), by_500_bits(rho)}))
                << text_of<Site3>(sites);
            ++spheres;
        }
    }
    EXPECT_GT(spheres, 400 * effort);
}
/// All kinds of degenerate balls are among the families: so many have each number of spheres, and
/// of one sphere so many each orientation.
TEST(TouchingSpheres, OfEveryNumberAndOrientation) {
    std::map<SphereCount, int> counts;
    std::map<Sign, int> orientations;
    Random random(11);
    for (const Family& family : families)
        for (int trial = 0; trial < 200; ++trial) {
            const auto sites = sites_of<Site3>(family.draw(random, 3));
            const auto found = touching_spheres(std::span(sites).first(4));
            ++counts[found.count];
            if (found.count == SphereCount::one) ++orientations[found.spheres[0].orientation];
        }
    for (const auto count :
         {SphereCount::none, SphereCount::one, SphereCount::two, SphereCount::infinitely_many})
        EXPECT_GT(counts[count], 40) << static_cast<int>(count);
    for (const Sign orientation : {-1, 0, 1}) EXPECT_GT(orientations[orientation], 20);
}

// ---- what is refused ---------------------------------------------------------------------------

TEST(TouchingSpheres, RefuseWhatIsNoBall) {
    std::array<Site3, 4> balls = {Site3{0, 0, 0, 1}, {5, 0, 0, 1}, {0, 5, 0, 1}, {0, 0, 5, 1}};
    EXPECT_EQ(touching_spheres(balls).count, SphereCount::one);
    EXPECT_THROW(static_cast<void>(touching_spheres(std::span(balls).first(3))),
                 std::invalid_argument);
    balls[2].r = std::numeric_limits<double>::infinity();
    EXPECT_THROW(static_cast<void>(touching_spheres(balls)), std::invalid_argument);
}
/// A flat triangle: beyond the doubles a number is an infinity, and the others are still right.
TEST(TouchingSpheres, BeyondTheDoubles) {
    const double h = 0x1p1023;
    const auto found =
        touching_spheres(std::array{Site{h, 0, 0}, Site{-h, 0, 0}, Site{0, 0x1p-1000, 0}});
    ASSERT_EQ(found.count, SphereCount::one);
    EXPECT_EQ(found.spheres[0].orientation, -1);
    EXPECT_EQ(found.spheres[0].sphere, (Site{0, -HUGE_VAL, HUGE_VAL}));
}

}  // namespace
}  // namespace signum
