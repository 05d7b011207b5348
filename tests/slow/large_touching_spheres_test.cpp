// The spheres that touch four balls, of a million random quadruples and two hundred thousand that
// are degenerate or nearly so: how many they are and how they turn as the oracle has it, and every
// number rounded as in 500 bits.

#include <gtest/gtest.h>
#include <mpfr.h>

#include <functional>
#include <map>

#include "../../voronoi/balls/touching_spheres.hpp"
#include "../property/ball_families.hpp"
#include "../property/rounded_surd.hpp"

namespace signum {
namespace {

/// The number in 500 bits, as a double; all roundings on the way down, or up.
double by_500_bits(const oracle::Surd& number, mpfr_rnd_t way) {
    const mpfr_rnd_t opposite = way == MPFR_RNDD ? MPFR_RNDU : MPFR_RNDD;
    const mpfr_rnd_t of_root = number.b().sign() < 0 ? opposite : way;
    mpfr_t sum;
    mpfr_init2(sum, 500);
    mpfr_set_q(sum, number.g().backend().data(), of_root);
    mpfr_sqrt(sum, sum, of_root);
    mpfr_mul_q(sum, sum, number.b().backend().data(), way);
    mpfr_add_q(sum, sum, number.a().backend().data(), way);
    const double result = mpfr_get_d(sum, MPFR_RNDN);
    mpfr_clear(sum);
    return result;
}

using Draw = std::function<AnyBalls(Random&, int dimension)>;

class LargeTouchingSpheres : public testing::Test {
 protected:
    void judge(Random& random, const Draw& draw, long quadruples) {
        for (long judged = 0; judged < quadruples; ++judged) {
            const auto sites = sites_of<Site3>(draw(random, 3));
            const auto expected = oracle::touching_spheres<3>(tuple_of<Site3>(sites));
            const auto found = touching_spheres(std::span(sites).first(4));
            ASSERT_EQ(static_cast<int>(found.count), static_cast<int>(expected.count))
                << text_of<Site3>(sites);
            ++counts_[found.count];
            if (found.count == SphereCount::one) ++orientations_[found.spheres[0].orientation];
            for (std::size_t m = 0; m < expected.spheres.size(); ++m) {
                const auto& [sphere, orientation] = found.spheres[m];
                // The oracle has the opposite order in space.
                const auto& other = expected.spheres[expected.spheres.size() - 1 - m];
                ASSERT_EQ(orientation, turn_of(other)) << text_of<Site3>(sites);
                ASSERT_TRUE(is_nearest(sphere.x, other.c[0])) << text_of<Site3>(sites);
                ASSERT_TRUE(is_nearest(sphere.y, other.c[1])) << text_of<Site3>(sites);
                ASSERT_TRUE(is_nearest(sphere.z, other.c[2])) << text_of<Site3>(sites);
                ASSERT_TRUE(is_nearest(sphere.r, other.rho)) << text_of<Site3>(sites);
            }
        }
    }

    std::map<SphereCount, long> counts_;
    std::map<Sign, long> orientations_;  // of one sphere
    /// Numbers of which 500 bits do not tell to which double they are nearest.
    long untold_ = 0;

 private:
    [[nodiscard]] bool is_nearest(double x, const oracle::Surd& number) {
        const double below = by_500_bits(number, MPFR_RNDD);
        const double above = by_500_bits(number, MPFR_RNDU);
        if (below == above) return x == below;
        ++untold_;
        return is_rounded(x, number);
    }
};

const long hundred_thousand = static_cast<long>(100'000 * effort * effort);

// ---- random ------------------------------------------------------------------------------------

/// Balls in a cube of the side 2; radii of both signs, so that fewer pairs are separate where they
/// may be larger.
Draw random_balls(double largest) {
    return [largest](Random& g, int) {
        const auto one = [&] { return 2 * g.real() - 1; };
        return ball_families::each([&] { return AnyBall{{one(), one(), one()}, largest * one()}; });
    };
}

class LargeTouchingSpheresOfRandomBalls : public LargeTouchingSpheres {
 protected:
    void test(const Draw& draw, long quadruples) {
        Random random(2033);
        judge(random, draw, quadruples);
        for (const auto count : {SphereCount::none, SphereCount::one, SphereCount::two})
            EXPECT_GT(counts_[count], quadruples / 100) << static_cast<int>(count);
        EXPECT_EQ(counts_[SphereCount::infinitely_many], 0);
        for (const Sign orientation : {-1, 1})
            EXPECT_GT(orientations_[orientation], quadruples / 500);
        EXPECT_EQ(untold_, 0);
    }
};

TEST_F(LargeTouchingSpheresOfRandomBalls, Small) {
    test(random_balls(0.1), 3 * hundred_thousand);
}
TEST_F(LargeTouchingSpheresOfRandomBalls, Middling) {
    test(random_balls(0.3), 4 * hundred_thousand);
}
TEST_F(LargeTouchingSpheresOfRandomBalls, Large) {
    test(random_balls(1.0), 3 * hundred_thousand);
}
TEST_F(LargeTouchingSpheres, OfRawBits) {
    Random random(2034);
    judge(random, ball_families::raw, hundred_thousand / 50);
    judge(random, ball_families::mixed, hundred_thousand / 10);
}

// ---- degenerate --------------------------------------------------------------------------------

/// Centres in one plane.
AnyBalls coplanar(Random& g, int d) {
    const auto u = ball_families::pythagorean(g, d);
    const auto v = ball_families::pythagorean(g, d);
    return ball_families::each([&] {
        const double s = g.between(-4, 4);
        const double t = g.between(-4, 4);
        return AnyBall{{s * u.x[0] + t * v.x[0], s * u.x[1] + t * v.x[1], s * u.x[2] + t * v.x[2]},
                       0.5 * g.between(-4, 4)};
    });
}
/// Two of the four, or more.
AnyBalls equal(Random& g, int d) {
    AnyBalls balls = ball_families::tangent(g, d);
    do {
        balls[static_cast<std::size_t>(g.below(4))] = balls[static_cast<std::size_t>(g.below(4))];
    } while (g.coin());
    return balls;
}
/// Two of the four, or more, and their radii differ now and then.
AnyBalls concentric(Random& g, int d) {
    AnyBalls balls = g.coin() ? ball_families::tangent(g, d) : ball_families::lattice(g, d);
    do {
        AnyBall& b = balls[static_cast<std::size_t>(g.below(4))];
        b = balls[static_cast<std::size_t>(g.below(4))];
        if (g.below(4) != 0) b.r += 0.5 * g.between(-4, 4);
    } while (g.coin());
    return balls;
}

const Draw degenerate[] = {ball_families::tangent,
                           ball_families::other_half,
                           ball_families::nested,
                           ball_families::coaxial,
                           ball_families::lattice,
                           ball_families::equal_radii,
                           ball_families::on_floor,
                           ball_families::flat,
                           coplanar,
                           equal,
                           concentric};

TEST_F(LargeTouchingSpheres, OfDegenerateBalls) {
    Random random(2035);
    for (const Draw& draw : degenerate)
        ASSERT_NO_FATAL_FAILURE(judge(random, draw, hundred_thousand / 10));
    for (const auto count :
         {SphereCount::none, SphereCount::one, SphereCount::two, SphereCount::infinitely_many})
        EXPECT_GT(counts_[count], hundred_thousand / 50) << static_cast<int>(count);
    for (const Sign orientation : {-1, 0, 1})
        EXPECT_GT(orientations_[orientation], hundred_thousand / 100);
}
TEST_F(LargeTouchingSpheres, OfDegenerateBallsMovedByUlps) {
    Random random(2036);
    for (const Draw& draw : degenerate) {
        const Draw moved = [&](Random& g, int d) {
            return ball_families::moved_all(g, draw(g, d));
        };
        ASSERT_NO_FATAL_FAILURE(judge(random, moved, hundred_thousand / 10));
    }
}

}  // namespace
}  // namespace signum
