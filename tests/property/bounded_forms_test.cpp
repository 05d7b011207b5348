/// Approximate determinants of moving sites beside the exact ones: errors are within their bounds,
/// and bounds are no larger than they have to be.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../triangulation/moving/bounded_forms.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::kinetic {
namespace {

using exact::Dyadic;
using oracle_test::Random;

/// Sites about some place, flying from their own times; some at rest, some in one place.
struct Systems {
    Random random;

    double real(double size) {
        return size * (static_cast<double>(random.below(1 << 30)) * 0x1p-29 - 1.0);
    }
    MovingSite site(int kind) {
        const double far = kind % 2 == 0 ? 0.0 : 1000.0;
        MovingSite site{far + real(1.0),      real(1.0), real(1.0), real(1.0),
                        std::fabs(real(0.5)), real(2.0)};
        if (kind % 3 == 1) site.time = 0.0;
        if (kind % 5 == 2) site.vx = site.vy = 0.0;
        if (kind % 5 == 3) site.r = 0.5;
        if (kind % 7 == 4) site.x = std::ldexp(site.x, random.below(200) - 100);
        return site;
    }
};

void expect_within(const PolynomialIn<Approximation, 4>& p, const PolynomialIn<Dyadic, 4>& exactly,
                   double& worst) {
    for (std::size_t i = 0; i < p.c.size(); ++i) {
        Dyadic off = Dyadic(p.c[i].value) - exactly.c[i];
        if (off.sign() < 0) off = -off;
        const Dyadic bound = Dyadic(Approximation::slack) * Dyadic(p.c[i].error);
        ASSERT_LE((off - bound).sign(), 0) << "coefficient " << i;
        if (p.c[i].value == 0.0 && p.c[i].error == 0.0) {
            ASSERT_EQ(exactly.c[i].sign(), 0);
        }
        if (p.c[i].error > 0.0 && (Dyadic(0.01) * bound - off).sign() < 0) worst = 1.0;
    }
}

TEST(BoundedForms, ErrorsAreWithinTheirBounds) {
    Systems systems{Random(77)};
    int bounded = 0;
    double in_circle_is_near = 0.0;
    double orientation_is_near = 0.0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const int kind = systems.random.below(210);
        const MovingSite a = systems.site(kind);
        const MovingSite b = systems.site(kind);
        const MovingSite c = trial % 11 == 0 ? a : systems.site(kind);
        const MovingSite q = systems.site(kind);
        const Fall fall = trial % 4 == 0 ? Fall{systems.real(1.0), systems.real(1.0)} : Fall{};
        const double origin = trial % 3 == 0 ? 0.0 : systems.real(4.0);
        const Frame at{fall, origin};
        const auto four = bounded_in_circle(a, b, c, q, at);
        const auto three = bounded_orientation(a, b, q, at);
        if (!four || !three) continue;
        ++bounded;
        expect_within(*four, in_circle<Dyadic>(a, b, c, q, at), in_circle_is_near);
        expect_within(*three, roots::widened<4>(orientation<Dyadic>(a, b, q, at)),
                      orientation_is_near);
        ASSERT_FALSE(HasFatalFailure()) << "trial " << trial;
    }
    EXPECT_GT(bounded, 15'000);
    // Somewhere an error is more than a hundredth of its bound.
    EXPECT_EQ(in_circle_is_near, 1.0);
    EXPECT_EQ(orientation_is_near, 1.0);
}

/// A turn that is certain is that of all times within the radius: asked at the ends and between.
TEST(BoundedForms, ATurnThatIsCertainIsRightWithinTheRadius) {
    Systems systems{Random(78)};
    int certain = 0;
    for (int trial = 0; trial < 20'000; ++trial) {
        const int kind = systems.random.below(210);
        const MovingSite a = systems.site(kind);
        MovingSite b = systems.site(kind);
        const MovingSite q = systems.site(kind);
        // On a line but for roundings, at some time.
        if (trial % 3 == 1) b = a;
        if (trial % 3 == 2) {
            b.x = 0.5 * (a.x + q.x);
            b.y = 0.5 * (a.y + q.y);
            b.time = trial % 2 == 0 ? a.time : q.time;
        }
        const Fall fall = trial % 4 == 0 ? Fall{systems.real(1.0), systems.real(1.0)} : Fall{};
        const double origin = trial % 5 == 0 ? b.time : systems.real(4.0);
        const double radius = trial % 7 == 0 ? 0.0 : std::ldexp(1.0, -1 - systems.random.below(60));
        const auto verdict = bounded_turn(a, b, q, {fall, origin}, radius);
        if (!verdict.is_certain()) continue;
        ++certain;
        const auto turn = orientation<Dyadic>(a, b, q, {fall, origin});
        for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
            const Dyadic s(part * radius);
            const Dyadic value = turn.c[0] + s * (turn.c[1] + s * turn.c[2]);
            ASSERT_EQ(value.sign(), verdict.sign()) << "trial " << trial << " part " << part;
        }
    }
    EXPECT_GT(certain, 10'000);
}

/// What moves alone makes no coefficients beyond its degree: these are 0, and known to be.
TEST(BoundedForms, SitesAtRestLeaveHighCoefficientsZero) {
    const MovingSite a{1.0, 0.25, 0.0, 0.0, 0.5, 0.0};
    const MovingSite b{-1.0, 0.5, 0.0, 0.0, 0.5, 0.0};
    const MovingSite q{0.1, 0.75, 0.0, 0.0, 0.5, 0.0};
    const MovingSite mover{0.3, -0.7, 0.5, 1.0, 0.5, 1.0};
    const auto p = bounded_in_circle(a, b, mover, q, {{}, 3.0});
    ASSERT_TRUE(p.has_value());
    for (const std::size_t i : {3U, 4U}) EXPECT_TRUE(p->c[i].is_zero()) << i;
    EXPECT_FALSE(p->c[2].is_zero());
}

TEST(BoundedForms, DeclineWhatIsOutOfRange) {
    const MovingSite a{1.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    const MovingSite b{0.0, 1.0, 0.0, 1.0, 0.0, 0.0};
    const MovingSite c{-1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    MovingSite q{0.0, -1.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_TRUE(bounded_in_circle(a, b, c, q, {{}, 0.0}).has_value());
    q.vx = 0x1p300;
    EXPECT_FALSE(bounded_in_circle(a, b, c, q, {{}, 0.0}).has_value());
    EXPECT_FALSE(bounded_orientation(a, b, q, {{}, 0.0}).has_value());
    // The square of a radius underflows, but is not 0.
    q = {0.0, -1.0, 0.0, 0.0, 1e-180, 0.0};
    EXPECT_FALSE(bounded_in_circle(a, b, c, q, {{}, 0.0}).has_value());
    // Where it is now is known to some hundreds: too badly beside a distance of 1.
    q = {0x1p60, -1.0, -1.0, 0.0, 0.0, -0x1p60};
    EXPECT_FALSE(bounded_in_circle(a, b, c, q, {{}, 0.0}).has_value());
}

}  // namespace
}  // namespace signum::kinetic
