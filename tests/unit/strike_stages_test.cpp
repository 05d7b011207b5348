/// Both stages of a strike, and which of them answered: doubles worked out by hand that only the
/// exact stage can tell, and generic ones, of which double-doubles nearly always do.

#include <cmath>
#include <cstdint>
#include <ostream>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "../../motion/strike.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::motion {

bool operator==(const StrikeTally& a, const StrikeTally& b) {
    return a.refined == b.refined && a.exact == b.exact;
}
void PrintTo(const StrikeTally& tally, std::ostream* out) {
    *out << tally.refined << " refined, " << tally.exact << " exact";
}

namespace {

using oracle_test::Random;

constexpr double ulp = 0x1p-52;  // of 1

constexpr StrikeTally tally(std::uint64_t refined, std::uint64_t exact) {
    return {refined, exact};
}

// ---- arrived: a count per coordinate of x, and one per coordinate of v that was exact ----------

struct Arrival {
    Ball<2> ball;
    StrikeTally told;
};
Arrival arrival(const Ball<2>& ball, double t, const Effects<2>& effects = {}) {
    Arrival result;
    result.ball = arrived(ball, t, effects, result.told);
    EXPECT_EQ(result.ball.time, t);
    EXPECT_EQ(result.ball.radius, ball.radius);
    return result;
}
Effects<2> gravity(double g) {
    Effects<2> effects;
    effects.gravity[1] = g;
    return effects;
}

TEST(ArrivalStages, OfFlightDoubleDoublesTellAll) {
    const Arrival a = arrival({{1.0, 2.0}, {0.5, -0.25}, 0.125, 1.0}, 3.0);
    EXPECT_EQ(a.ball.x, (Vector<2>{2.0, 1.5}));
    EXPECT_EQ(a.ball.v, (Vector<2>{0.5, -0.25}));
    EXPECT_EQ(a.told, tally(2, 0));
    // One operation rounds once, to even, and to a zero without a sign.
    const Arrival halfway = arrival({{1.0, 1.0 + ulp}, {ulp / 2, ulp / 2}, 0.0, 0.0}, 1.0);
    EXPECT_EQ(halfway.ball.x, (Vector<2>{1.0, 1.0 + 2 * ulp}));
    EXPECT_EQ(halfway.told, tally(2, 0));
    const Arrival zero = arrival({{-0.0, 1.0}, {-0.0, -0.5}, 0.0, 0.0}, 2.0);
    EXPECT_FALSE(std::signbit(zero.ball.x[0]) || std::signbit(zero.ball.x[1]));
    EXPECT_EQ(zero.told, tally(2, 0));
}

TEST(ArrivalStages, OfATimeThatIsNoDoubleHalfwayIsExact) {
    // The flight takes 1 - 2^-60.
    const Arrival halfway = arrival({{ulp / 2 + 0x1p-60, 3.0}, {1.0, 0.0}, 0.0, 0x1p-60}, 1.0);
    EXPECT_EQ(halfway.ball.x, (Vector<2>{1.0, 3.0}));
    EXPECT_EQ(halfway.told, tally(1, 1));
    const Arrival beyond = arrival({{ulp / 2 + 0x1p-59, 3.0}, {1.0, 0.0}, 0.0, 0x1p-60}, 1.0);
    EXPECT_EQ(beyond.ball.x, (Vector<2>{1.0 + ulp, 3.0}));
    EXPECT_EQ(beyond.told, tally(2, 0));
}

TEST(ArrivalStages, OfAFallHalfwayIsExact) {
    const Arrival down = arrival({{0.0, 1.0}, {0.0, 0.0}, 0.0, 0.0}, 1.0, gravity(ulp));
    EXPECT_EQ(down.ball.x, (Vector<2>{0.0, 1.0}));
    EXPECT_EQ(down.ball.v, (Vector<2>{0.0, ulp}));
    EXPECT_EQ(down.told, tally(1, 1));
    const Arrival up = arrival({{0.0, 1.0 + ulp}, {0.0, 0.0}, 0.0, 0.0}, 1.0, gravity(ulp));
    EXPECT_EQ(up.ball.x, (Vector<2>{0.0, 1.0 + 2 * ulp}));
    EXPECT_EQ(up.told, tally(1, 1));
    const Arrival velocity = arrival({{0.0, 0.0}, {0.0, 1.0}, 0.0, 0.0}, 1.0, gravity(ulp / 2));
    EXPECT_EQ(velocity.ball.v, (Vector<2>{0.0, 1.0}));
    EXPECT_EQ(velocity.told, tally(2, 1));
}

TEST(ArrivalStages, OfAFallAZeroIsExact) {
    const Arrival peak = arrival({{0.0, 0.0}, {0.0, 1.0}, 0.0, 0.0}, 1.0, gravity(-1.0));
    EXPECT_EQ(peak.ball.x, (Vector<2>{0.0, 0.5}));
    EXPECT_EQ(peak.ball.v, (Vector<2>{0.0, 0.0}));
    EXPECT_FALSE(std::signbit(peak.ball.v[1]));
    EXPECT_EQ(peak.told, tally(2, 1));
    const Arrival ground = arrival({{0.0, 0.5}, {0.0, 0.0}, 0.0, 0.0}, 1.0, gravity(-1.0));
    EXPECT_EQ(ground.ball.x, (Vector<2>{0.0, 0.0}));
    EXPECT_EQ(ground.ball.v, (Vector<2>{0.0, -1.0}));
    EXPECT_EQ(ground.told, tally(1, 1));
}

TEST(ArrivalStages, AtASideOfThePeriodicBoxIsExact) {
    Effects<2> effects;
    effects.box = Box<2>{{0.0, 0.0}, {1.0, 1.0}};
    effects.periodic = true;
    const Ball<2> ball{{0.5, 0.25}, {0.5, 1.0}, 0.0, 0.0};
    const Arrival within = arrival(ball, 0.5, effects);
    EXPECT_EQ(within.ball.x, (Vector<2>{0.75, 0.75}));
    EXPECT_EQ(within.told, tally(2, 0));
    const Arrival beyond = arrival(ball, 1.5, effects);
    EXPECT_EQ(beyond.ball.x, (Vector<2>{0.25, 0.75}));
    EXPECT_EQ(beyond.told, tally(2, 0));
    const Arrival at_side = arrival(ball, 1.0, effects);
    EXPECT_EQ(at_side.ball.x, (Vector<2>{0.0, 0.25}));
    EXPECT_EQ(at_side.told, tally(1, 1));
}

// ---- strike: a count per pair that does not surely recede --------------------------------------

struct Struck {
    Ball<2> a;
    Ball<2> b;
    Exchange exchange;
    StrikeTally told;
};
/// Of masses 1.
Struck struck(Struck balls, double restitution = 1.0, double mass_b = 1.0) {
    Effects<2> effects;
    effects.restitution = restitution;
    balls.exchange = strike(balls.a, balls.b, Image<2>{}, 1.0, mass_b, {effects.restitution},
                            effects, balls.told);
    return balls;
}
Ball<2> ball(const Vector<2>& x, const Vector<2>& v) {
    return {x, v, 0.5, 0.0};
}
/// b lies at 0.
Struck at_origin(const Vector<2>& x, const Vector<2>& v, const Vector<2>& v_of_b) {
    return {ball(x, v), ball({0.0, 0.0}, v_of_b), {}, {}};
}

TEST(StrikeStages, DoubleDoublesTellWhatIsNotHalfway) {
    const Struck swapped = struck(at_origin({-1.0, 0.0}, {1.0, 3.0}, {-2.0, 5.0}));
    EXPECT_TRUE(swapped.exchange.struck);
    EXPECT_EQ(swapped.a.v, (Vector<2>{-2.0, 3.0}));
    EXPECT_EQ(swapped.b.v, (Vector<2>{1.0, 5.0}));
    EXPECT_EQ(swapped.exchange.approach, 3.0);
    EXPECT_EQ(swapped.exchange.square, 1.0);
    EXPECT_EQ(swapped.exchange.virial, 3.0);
    EXPECT_EQ(swapped.told, tally(1, 0));
    // 2 μ = 1.5 of the relative speed.
    const Struck heavy = struck(at_origin({-1.0, 0.0}, {1.0, 3.0}, {-1.0, 5.0}), 1.0, 3.0);
    EXPECT_EQ(heavy.a.v, (Vector<2>{-2.0, 3.0}));
    EXPECT_EQ(heavy.b.v[1], 5.0);
    EXPECT_EQ(heavy.told, tally(0, 1));  // b comes to rest
    EXPECT_EQ(heavy.b.v[0], 0.0);
}

TEST(StrikeStages, AVelocityThatBecomesZeroIsExact) {
    const Struck stopped = struck(at_origin({-1.0, 0.0}, {1.0, 3.0}, {0.0, 5.0}));
    EXPECT_TRUE(stopped.exchange.struck);
    EXPECT_EQ(stopped.a.v, (Vector<2>{0.0, 3.0}));
    EXPECT_FALSE(std::signbit(stopped.a.v[0]));
    EXPECT_EQ(stopped.b.v, (Vector<2>{1.0, 5.0}));
    EXPECT_EQ(stopped.told, tally(0, 1));
    const Struck stays = struck(at_origin({-1.0, 0.0}, {1.0, 0.0}, {-2.0, 0.0}));
    EXPECT_EQ(stays.a.v, (Vector<2>{-2.0, 0.0}));
    EXPECT_EQ(stays.b.v, (Vector<2>{1.0, 0.0}));
    EXPECT_EQ(stays.told, tally(0, 1));
}

TEST(StrikeStages, AVelocityHalfwayIsExact) {
    // Both fly on at the mean velocity, which is rounded to even.
    const Struck down = struck(at_origin({-1.0, 0.0}, {1.0 + ulp, 3.0}, {1.0, 5.0}), 0.0);
    EXPECT_TRUE(down.exchange.struck);
    EXPECT_EQ(down.a.v, (Vector<2>{1.0, 3.0}));
    EXPECT_EQ(down.b.v, (Vector<2>{1.0, 5.0}));
    EXPECT_EQ(down.told, tally(0, 1));
    const Struck up = struck(at_origin({-1.0, 0.0}, {1.0 + 2 * ulp, 3.0}, {1.0 + ulp, 5.0}), 0.0);
    EXPECT_EQ(up.a.v, (Vector<2>{1.0 + 2 * ulp, 3.0}));
    EXPECT_EQ(up.b.v, (Vector<2>{1.0 + 2 * ulp, 5.0}));
    EXPECT_EQ(up.told, tally(0, 1));
    const Struck between = struck(at_origin({-1.0, 0.0}, {1.0 + 2 * ulp, 3.0}, {1.0, 5.0}), 0.0);
    EXPECT_EQ(between.a.v, (Vector<2>{1.0 + ulp, 3.0}));
    EXPECT_EQ(between.b.v, (Vector<2>{1.0 + ulp, 5.0}));
    EXPECT_EQ(between.told, tally(1, 0));
}

TEST(StrikeStages, WhoSurelyRecedesIsNotCounted) {
    const Struck balls = at_origin({-1.0, 0.5}, {-1.0, 3.0}, {2.0, 3.0});
    const Struck after = struck(balls);
    EXPECT_FALSE(after.exchange.struck);
    EXPECT_EQ(after.a.v, balls.a.v);
    EXPECT_EQ(after.b.v, balls.b.v);
    EXPECT_EQ(after.told, tally(0, 0));
}

/// D·V is 0, or ±2^-120, far below the double-doubles' error.
TEST(StrikeStages, WhoNearlyRecedesIsExact) {
    const Struck across = struck(at_origin({-1.0, 0.0}, {0.0, 3.0}, {0.0, 5.0}));
    EXPECT_FALSE(across.exchange.struck);
    EXPECT_EQ(across.told, tally(0, 1));
    // Away from one another, or so slowly toward one another that only a velocity of 0 changes.
    for (const double way : {-1.0, 1.0}) {
        Struck balls = at_origin({1.0, 1.0}, {way, -way}, {way * 0x1p-60, 0.0});
        balls.b.x[0] = -0x1p-60;
        const Struck after = struck(balls);
        EXPECT_EQ(after.exchange.struck, way > 0.0);
        EXPECT_EQ(after.exchange.approach, way > 0.0 ? 0x1p-120 : 0.0);
        EXPECT_EQ(after.a.v, balls.a.v);
        EXPECT_EQ(after.b.v, (Vector<2>{balls.b.v[0], way > 0.0 ? -0x1p-121 : 0.0}));
        EXPECT_EQ(after.told, tally(0, 1));
    }
}

TEST(StrikeStages, AnImpulseHalfwayIsExact) {
    const Effects<2> effects;
    const auto told = [&](const Struck& balls, double expected) {
        StrikeTally stages;
        EXPECT_EQ(
            impulse(balls.a, balls.b, Image<2>{}, 1.0, 1.0, {effects.restitution}, effects, stages),
            expected);
        EXPECT_EQ(stages.refined, 0U);  // these are not counted
        return stages.exact;
    };
    EXPECT_EQ(told(at_origin({-3.0, 4.0}, {5.0, 0.0}, {0.0, 0.0}), 3.0), 0U);
    EXPECT_EQ(told(at_origin({-1.0, 0.0}, {1.0, 0.0}, {-ulp / 2, 0.0}), 1.0), 1U);
    EXPECT_EQ(told(at_origin({-1.0, 0.0}, {1.0 + ulp, 0.0}, {-ulp / 2, 0.0}), 1.0 + 2 * ulp), 1U);
    EXPECT_EQ(told(at_origin({-1.0, 0.0}, {1.0, 0.0}, {-ulp, 0.0}), 1.0 + ulp), 0U);
}

// ---- Generic balls -----------------------------------------------------------------------------

/// Whether no other double is nearer to a number.
bool is_nearest(double told, const mpq_class& number) {
    const auto off = [&](double x) { return mpq_class(abs(mpq_class(x) - number)); };
    return off(told) <= off(std::nextafter(told, -HUGE_VAL)) &&
           off(told) <= off(std::nextafter(told, HUGE_VAL));
}
/// The same of a root, which is not negative: whether it lies between the middles to its
/// neighbours.
bool is_nearest_root(double told, const mpq_class& square) {
    const auto middle = [&](double to) {
        return mpq_class((mpq_class(told) + mpq_class(std::nextafter(told, to))) / 2);
    };
    const mpq_class below = middle(0.0);
    const mpq_class above = middle(HUGE_VAL);
    return told >= 0.0 && below * below <= square && square <= above * above;
}

/// What two balls exchange, from its definition.
template <int D>
struct Law {
    Law(const Ball<D>& a, const Ball<D>& b, const Image<D>& image, double mass_a, double mass_b,
        const Effects<D>& effects) {
        PerAxis<mpq_class, D> d;
        mpq_class product;
        mpq_class square;
        for (int k = 0; k < D; ++k) {
            d[k] = mpq_class(a.x[k]) - mpq_class(b.x[k]);
            if (effects.periodic)
                d[k] -=
                    image[k] * (mpq_class(effects.box->high[k]) - mpq_class(effects.box->low[k]));
            product += d[k] * (mpq_class(a.v[k]) - mpq_class(b.v[k]));
            square += d[k] * d[k];
        }
        const mpq_class masses = mpq_class(mass_a) + mpq_class(mass_b);
        const mpq_class step = (1 + mpq_class(effects.restitution)) * product / square / masses;
        for (int k = 0; k < D; ++k) {
            of_a[k] = mpq_class(a.v[k]) - step * mpq_class(mass_b) * d[k];
            of_b[k] = mpq_class(b.v[k]) + step * mpq_class(mass_a) * d[k];
        }
        const mpq_class momentum = step * mpq_class(mass_a) * mpq_class(mass_b);
        impulse = momentum * momentum * square;
    }
    PerAxis<mpq_class, D> of_a;
    PerAxis<mpq_class, D> of_b;
    mpq_class impulse;  ///< its square
};

template <int D>
void expect_refined_nearly_always(std::uint64_t seed) {
    Random random(seed);
    const auto number = [&](double size) {
        return size * (2.0 * (random.unit() + 0x1p-30 * random.unit()) - 1.0);
    };
    StrikeTally arrivals;
    StrikeTally strikes;
    StrikeTally impulses;
    int receding = 0;
    constexpr int cases = 2000;
    for (int i = 0; i < cases; ++i) {
        Effects<D> effects;
        effects.restitution = i % 2 == 0 ? 1.0 : random.unit();
        effects.periodic = i % 3 == 0;
        if (effects.periodic) {
            effects.box.emplace();
            effects.box->low.fill(-2.0);
            effects.box->high.fill(2.0);
        }
        Ball<D> balls[2];
        for (Ball<D>& each : balls) {
            for (double& x : each.x) x = number(2.0);
            for (double& v : each.v) v = number(1.0);
            each.time = random.unit();
        }
        if (i % 4 == 0)
            for (double& g : effects.gravity) g = number(1.0);
        for (Ball<D>& each : balls) each = arrived(each, 1.0, effects, arrivals);
        const double mass_a = 1.0 + random.unit();
        const double mass_b = i % 5 == 0 ? mass_a : 1.0 + random.unit();
        const Image<D> image = nearest_image(balls[0].x, balls[1].x, effects);
        const Law<D> law(balls[0], balls[1], image, mass_a, mass_b, effects);
        EXPECT_TRUE(is_nearest_root(impulse(balls[0], balls[1], image, mass_a, mass_b,
                                            {effects.restitution}, effects, impulses),
                                    law.impulse));
        if (!strike(balls[0], balls[1], image, mass_a, mass_b, {effects.restitution}, effects,
                    strikes)
                 .struck) {
            ++receding;
            continue;
        }
        for (int k = 0; k < D; ++k) {
            EXPECT_TRUE(is_nearest(balls[0].v[k], law.of_a[k]));
            EXPECT_TRUE(is_nearest(balls[1].v[k], law.of_b[k]));
        }
    }
    EXPECT_EQ(arrivals.refined, 2U * D * cases);
    EXPECT_EQ(arrivals.exact, 0U);
    EXPECT_EQ(strikes.refined + static_cast<std::uint64_t>(receding), cases);
    EXPECT_GT(receding, cases / 4);
    EXPECT_LT(receding, 3 * cases / 4);
    EXPECT_EQ(strikes.exact, 0U);
    EXPECT_EQ(impulses.exact, 0U);
}

TEST(StrikeStages, OfGenericDiscsAreRefined) {
    expect_refined_nearly_always<2>(1805);
}
TEST(StrikeStages, OfGenericBallsAreRefined) {
    expect_refined_nearly_always<3>(1806);
}

}  // namespace
}  // namespace signum::motion
