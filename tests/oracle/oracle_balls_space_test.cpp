/// The oracle of balls against spheres that are built with their balls, against cases by hand,
/// against the oracles of the plane and of points in space, and against what motions and other
/// orders do to it.

#include <gtest/gtest.h>
#include "balls_space.hpp"
#include "euclidean.hpp"
#include "linear_system.hpp"
#include "oracle_test_support.hpp"
#include "power_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::Site;
using signum::Site3;
using signum::oracle::ball_vertices;
using signum::oracle::BallTuple;
using signum::oracle::BallVertex;
using signum::oracle::exact_ball;
using signum::oracle::hidden_balls;
using signum::oracle::Rational;
using signum::oracle::side;
using signum::oracle::SpaceBall;
using signum::oracle::SphereCount;
using signum::oracle::Surd;
using signum::oracle::touching_spheres;
using signum::oracle::TouchingSphere;
using signum::oracle::TouchingSpheres;

template <int D>
using Balls = std::vector<SpaceBall<D>>;

TouchingSpheres<2> touching(const std::array<Site, 3>& sites) {
    BallTuple<2> balls;
    for (std::size_t i = 0; i < 3; ++i) balls[i] = exact_ball(sites[i]);
    return touching_spheres<2>(balls);
}

TouchingSpheres<3> touching(const std::array<Site3, 4>& sites) {
    BallTuple<3> balls;
    for (std::size_t i = 0; i < 4; ++i) balls[i] = exact_ball(sites[i]);
    return touching_spheres<3>(balls);
}

double number(const Surd& x) {
    return static_cast<double>(x.a()) +
           static_cast<double>(x.b()) * std::sqrt(static_cast<double>(x.g()));
}

template <int D>
void expect_sphere(const TouchingSphere<D>& sphere, const std::array<Surd, D>& c, const Surd& rho,
                   int orientation) {
    EXPECT_EQ(sphere.c, c);
    EXPECT_EQ(sphere.rho, rho);
    EXPECT_EQ(sphere.orientation, orientation);
}

TEST(OracleBalls, PointsHaveTheirCircumsphere) {
    const auto plane = touching({Site{0, 0, 0}, {3, 0, 0}, {0, 4, 0}});
    ASSERT_EQ(plane.count, SphereCount::one);
    expect_sphere<2>(plane.spheres[0], {Rational(3, 2), 2}, Rational(5, 2), 1);

    // det[direction, 1] of four points in space is less than 0 where det[c_i - c_0] is more.
    const auto space = touching({Site3{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}});
    ASSERT_EQ(space.count, SphereCount::one);
    const Rational half(1, 2);
    expect_sphere<3>(space.spheres[0], {half, half, half}, {0, half, 3}, -1);
    const auto mirrored = touching({Site3{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}});
    ASSERT_EQ(mirrored.count, SphereCount::one);
    expect_sphere<3>(mirrored.spheres[0], {half, half, half}, {0, half, 3}, 1);
}

TEST(OracleBalls, EqualRadiiAreTakenOff) {
    const auto tetrahedron =
        touching({Site3{1, 1, 1, 1}, {1, -1, -1, 1}, {-1, 1, -1, 1}, {-1, -1, 1, 1}});
    ASSERT_EQ(tetrahedron.count, SphereCount::one);
    expect_sphere<3>(tetrahedron.spheres[0], {0, 0, 0}, {-1, 1, 3}, 1);
    const auto overlapping =
        touching({Site3{1, 1, 1, 2}, {1, -1, -1, 2}, {-1, 1, -1, 2}, {-1, -1, 1, 2}});
    ASSERT_EQ(overlapping.count, SphereCount::one);
    EXPECT_EQ(overlapping.spheres[0].rho, Surd(-2, 1, 3));  // negative, and no harm
}

TEST(OracleBalls, SoddysCircle) {
    // Three circles that touch one another: 1/rho = 1 + 1/2 + 1/3 + 2 √(1/2 + 1/3 + 1/6). The other
    // root is the circle of radius 6 around all of them, which touches from inside.
    const auto circle = touching({Site{0, 0, 1}, {3, 0, 2}, {0, 4, 3}});
    ASSERT_EQ(circle.count, SphereCount::one);
    expect_sphere<2>(circle.spheres[0], {Rational(21, 23), Rational(20, 23)}, Rational(6, 23), 1);
}

TEST(OracleBalls, TwoSpheresComeInTheirOrder) {
    // c = (0, y): √(25 + y²) = rho + 3 and |y| = rho + 1.
    const auto plane = touching({Site{-5, 0, 3}, {0, 0, 1}, {5, 0, 3}});
    ASSERT_EQ(plane.count, SphereCount::two);
    expect_sphere<2>(plane.spheres[0], {0, Rational(21, 4)}, Rational(17, 4), 1);
    expect_sphere<2>(plane.spheres[1], {0, Rational(-21, 4)}, Rational(17, 4), -1);
    // The larger one in the middle: nothing reaches around it.
    EXPECT_EQ(touching({Site{-5, 0, 1}, {0, 0, 3}, {5, 0, 1}}).count, SphereCount::none);

    const std::array<Site3, 4> sites{Site3{5, 0, 0, 3}, {-5, 0, 0, 3}, {0, 5, 0, 3}, {0, 0, 0, 1}};
    const auto space = touching(sites);
    ASSERT_EQ(space.count, SphereCount::two);
    for (const auto& sphere : space.spheres) {
        EXPECT_EQ(sphere.c[0], Surd(0));
        EXPECT_EQ(sphere.c[1], Surd(0));
        EXPECT_EQ(sphere.rho, Surd(Rational(17, 4)));
    }
    EXPECT_EQ(space.spheres[0].c[2] + space.spheres[1].c[2], Surd(0));
    EXPECT_EQ(space.spheres[0].orientation, 1);
    EXPECT_EQ(space.spheres[1].orientation, -1);
}

TEST(OracleBalls, ADoubleRootIsOneFlatSphere) {
    // Four points of contact on one great circle, though the balls' radii are all different.
    const auto ring = touching({Site3{3, 0, 0, 1}, {-4, 0, 0, 2}, {0, 5, 0, 3}, {0, -6, 0, 4}});
    ASSERT_EQ(ring.count, SphereCount::one);
    expect_sphere<3>(ring.spheres[0], {0, 0, 0}, 2, 0);
    // Two of the points of contact coincide: no plane tells the third's side.
    const auto same = touching({Site{2, 0, 1}, {4, 0, 3}, {0, 5, 4}});
    ASSERT_EQ(same.count, SphereCount::one);
    EXPECT_EQ(same.spheres[0].orientation, 0);
    // The sphere's centre is that of a ball: all its directions are points of contact.
    const auto centre = touching({Site3{0, 0, 0, -1}, {1, 0, 0, 0}, {-1, 0, 0, 0}, {0, 1, 0, 0}});
    ASSERT_EQ(centre.count, SphereCount::one);
    expect_sphere<3>(centre.spheres[0], {0, 0, 0}, 1, 0);
}

TEST(OracleBalls, OneRootMayBeAtInfinity) {
    // All touch the line y = 0 from above.
    const auto plane = touching({Site{0, 1, 1}, {5, 2, 2}, {9, 4, 4}});
    ASSERT_EQ(plane.count, SphereCount::one);
    EXPECT_EQ(plane.spheres[0].rho.b(), 0);
    const auto space = touching({Site3{0, 0, 1, 1}, {5, 0, 2, 2}, {0, 9, 4, 4}, {-7, -3, 3, 3}});
    ASSERT_EQ(space.count, SphereCount::one);
    EXPECT_EQ(space.spheres[0].rho.b(), 0);
}

TEST(OracleBalls, NestedBallsHaveNone) {
    EXPECT_EQ(touching({Site{0, 0, 9}, {1, 0, 1}, {20, 3, 1}}).count, SphereCount::none);
    EXPECT_EQ(touching({Site{0, 0, 9}, {1, 0, 1}, {1, 0, 1}}).count, SphereCount::none);
    EXPECT_EQ(touching({Site{0, 0, 9}, {0, 0, 1}, {0, 0, 2}}).count, SphereCount::none);
    EXPECT_EQ(touching({Site3{0, 0, 0, 9}, {1, 0, 0, 1}, {20, 3, 1, 1}, {0, 30, 0, 2}}).count,
              SphereCount::none);
    EXPECT_EQ(touching({Site3{0, 0, 0, 9}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}}).count,
              SphereCount::none);
}

TEST(OracleBalls, TangentFromInsideTouchesOnARay) {
    // From (1, 0) to the right; t as far there as (4, 0) is, less 1.
    const auto on_ray = touching({Site3{0, 0, 0, 2}, {1, 0, 0, 1}, {4, 0, 0, 1}, {4, 0, 0, 1}});
    ASSERT_EQ(on_ray.count, SphereCount::one);
    expect_sphere<3>(on_ray.spheres[0], {Rational(5, 2), 0, 0}, Rational(1, 2), 0);
    const auto plane = touching({Site{0, 0, 2}, {1, 0, 1}, {4, 0, 1}});
    ASSERT_EQ(plane.count, SphereCount::one);
    expect_sphere<2>(plane.spheres[0], {Rational(5, 2), 0}, Rational(1, 2), 0);
    // A whole ray of them.
    EXPECT_EQ(touching({Site{0, 0, 2}, {1, 0, 1}, {-3, 0, 5}}).count, SphereCount::infinitely_many);
    EXPECT_EQ(touching({Site{0, 0, 2}, {1, 0, 1}, {1, 0, 1}}).count, SphereCount::infinitely_many);
    EXPECT_EQ(touching({Site3{0, 0, 0, 2}, {1, 0, 0, 1}, {-3, 0, 0, 5}, {2, 0, 0, 0}}).count,
              SphereCount::infinitely_many);
    // Two rays, which meet only where they begin, and only if they begin in one point.
    EXPECT_EQ(touching({Site3{0, 0, 0, 2}, {1, 0, 0, 1}, {0, 1, 0, 1}, {0, 1, 0, 1}}).count,
              SphereCount::none);
    const auto apex = touching({Site3{0, 0, 0, 0}, {1, 0, 0, 1}, {0, 1, 0, 1}, {2, 0, 0, 2}});
    ASSERT_EQ(apex.count, SphereCount::one);
    expect_sphere<3>(apex.spheres[0], {0, 0, 0}, 0, 0);
}

TEST(OracleBalls, EqualBallsCountOnce) {
    EXPECT_EQ(touching({Site{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).count, SphereCount::infinitely_many);
    EXPECT_EQ(touching({Site{1, 2, 3}, {1, 2, 3}, {9, 2, 3}}).count, SphereCount::infinitely_many);
    EXPECT_EQ(touching({Site3{1, 2, 3, 1}, {1, 2, 3, 1}, {9, 2, 3, 4}, {3, 8, 0, 0}}).count,
              SphereCount::infinitely_many);
    // Three balls in a row, the middle one the largest.
    EXPECT_EQ(touching({Site3{-4, 0, 0, 0}, {0, 0, 0, 3}, {4, 0, 0, 0}, {4, 0, 0, 0}}).count,
              SphereCount::none);
}

TEST(OracleBalls, CirclesOfSpheres) {
    const auto infinitely_many = SphereCount::infinitely_many;
    // Cocircular points; collinear ones; three on a line.
    EXPECT_EQ(touching({Site3{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}, {2, 2, 0, 1}}).count,
              infinitely_many);
    EXPECT_EQ(touching({Site3{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 2, 0, 1}, {2, 3, 0, 1}}).count,
              SphereCount::none);
    EXPECT_EQ(touching({Site3{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}, {3, 0, 0, 1}}).count,
              SphereCount::none);
    EXPECT_EQ(touching({Site{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}).count, SphereCount::none);
    // Coaxial balls around which a sphere of radius 2 rolls, 3 from the axis.
    EXPECT_EQ(touching({Site3{-4, 0, 0, 3}, {0, 0, 0, 1}, {4, 0, 0, 3}, {2.25, 0, 0, 1.75}}).count,
              infinitely_many);
    EXPECT_EQ(touching({Site3{-4, 0, 0, 3}, {0, 0, 0, 1}, {4, 0, 0, 3}, {2.25, 0, 0, 1.5}}).count,
              SphereCount::none);
    // Radii of the opposite sign: |c - c_i| = -(rho + r_i) for them all.
    EXPECT_EQ(
        touching({Site3{-4, 0, 0, -3}, {0, 0, 0, -1}, {4, 0, 0, -3}, {2.25, 0, 0, -1.75}}).count,
        SphereCount::none);
}

TEST(OracleBalls, EveryFiniteDoubleAndNoOther) {
    const double large = std::numeric_limits<double>::max();
    const double small = std::numeric_limits<double>::denorm_min();
    const auto tiny = touching({Site{0, 0, 0}, {small, 0, 0}, {0, small, 0}});
    ASSERT_EQ(tiny.count, SphereCount::one);
    EXPECT_EQ(tiny.spheres[0].c[0] * Surd(2), Surd(signum::oracle::exactly(small)));
    EXPECT_EQ(touching({Site{-large, 0, 0}, {large, small, 0}, {0, large, small}}).count,
              SphereCount::one);
    EXPECT_THROW(exact_ball(Site{0, std::numeric_limits<double>::infinity(), 0}),
                 std::invalid_argument);
}

TEST(OracleBalls, TheSideOfAFurtherBall) {
    const auto spheres =
        touching({Site3{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}).spheres;
    const auto of = [&](const Site3& q) { return side(spheres.at(0), exact_ball(q)); };
    const double speck = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(of({1, 1, 1, 0}), 0);
    EXPECT_EQ(of({1, 1, 1, speck}), -1);
    EXPECT_EQ(of({1, 1, 1, -speck}), 1);
    EXPECT_EQ(of({1, 1, 0, 0}), 0);
    EXPECT_EQ(of({0.5, 0.5, 0.5, 0}), -1);
    EXPECT_EQ(of({0.5, 0.5, 0.5, -1}), 1);  // rho + r < 0, nearer than which nothing is
    EXPECT_EQ(of({9, 9, 9, 100}), -1);
}

TEST(OracleBalls, SidesAsInDoubles) {
    Random random(17);
    std::array<int, 2> seen{};
    for (int trial = 0; trial < 1000; ++trial) {
        const auto some = [&] {
            const double x = random.unit(), y = random.unit(), z = random.unit();
            return Site3{x, y, z, random.unit() - 0.5};
        };
        const Site3 q = some();
        for (const auto& sphere : touching({some(), some(), some(), some()}).spheres) {
            const double x = number(sphere.c[0]) - q.x, y = number(sphere.c[1]) - q.y,
                         z = number(sphere.c[2]) - q.z;
            const double distance = std::sqrt(x * x + y * y + z * z);
            const double difference = distance - q.r - number(sphere.rho);
            if (std::abs(difference) < 1e-9 * (1 + distance)) continue;
            ASSERT_EQ(side(sphere, exact_ball(q)), difference < 0 ? -1 : 1);
            ++seen[difference < 0];
        }
    }
    for (const std::size_t sign : {0U, 1U}) EXPECT_GT(seen[sign], 100);
}

TEST(OracleBalls, RawDoubles) {
    // Any bits that are a finite number; the balls touch what is found, however far it is.
    Random random(18);
    std::array<int, 4> counts{};
    for (int trial = 0; trial < 100; ++trial) {
        const auto some = [&] {
            double value = 0;
            do {
                value = std::ldexp(random.unit() - 0.5, random.below(2 * 1074) - 1074);
            } while (!std::isfinite(value));
            return value;
        };
        BallTuple<3> balls;
        for (auto& ball : balls) {
            const double x = some(), y = some(), z = some();
            ball = exact_ball(Site3{x, y, z, some()});
        }
        const auto found = touching_spheres<3>(balls);
        ++counts[static_cast<std::size_t>(found.count)];
        for (const auto& sphere : found.spheres)
            for (const auto& ball : balls) {
                ASSERT_EQ(side(sphere, ball), 0);
                ASSERT_GE((sphere.rho + Surd(ball.r)).sign(), 0);
            }
    }
    EXPECT_GT(counts[0], 10);
    EXPECT_GT(counts[1] + counts[2], 10);
}

TEST(OracleBalls, HiddenBalls) {
    const auto hidden = [](const std::vector<Site>& sites) {
        Balls<2> balls;
        for (const Site& site : sites) balls.push_back(exact_ball(site));
        return hidden_balls<2>(balls);
    };
    EXPECT_EQ(hidden({{0, 0, 5}, {1, 0, 3}, {9, 0, 1}}), (std::vector<bool>{0, 1, 0}));
    EXPECT_EQ(hidden({{3, 4, 0}, {0, 0, 5}, {6, 8, -5}}), (std::vector<bool>{1, 0, 1}));
    EXPECT_EQ(hidden({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), (std::vector<bool>{0, 1, 1}));
    EXPECT_TRUE(hidden({}).empty());
}

/// A direction with rational coordinates: the inverse stereographic projection of t.
template <int D>
std::array<Rational, D> direction(Random& random) {
    std::array<Rational, D> t;
    Rational square = 0;
    for (std::size_t x = 0; x + 1 < D; ++x) {
        t[x] = Rational(random.below(13) - 6, 1 + random.below(4));
        square += t[x] * t[x];
    }
    for (std::size_t x = 0; x + 1 < D; ++x) t[x] = 2 * t[x] / (square + 1);
    t[D - 1] = random.below(2) == 0 ? Rational((square - 1) / (square + 1))
                                    : Rational((1 - square) / (square + 1));
    return t;
}

template <int D>
int orientation_of(const std::array<std::array<Rational, D>, D + 1>& p) {
    if constexpr (D == 2) {
        const Rational det =
            (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
        return det.sign();
    } else {
        std::array<std::array<Rational, 3>, 3> v;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t x = 0; x < 3; ++x) v[i][x] = p[i + 1][x] - p[0][x];
        Rational det = 0;
        for (std::size_t x = 0; x < 3; ++x) {
            const std::size_t y = (x + 1) % 3, z = (x + 2) % 3;
            det += v[0][x] * (v[1][y] * v[2][z] - v[1][z] * v[2][y]);
        }
        return -det.sign();
    }
}

/// Balls around a sphere, at any directions and of any radii, so that it must be found.
template <int D>
void finds_the_sphere_that_is_there() {
    Random random(7);
    std::array<int, 4> seen{};
    int flat = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        TouchingSphere<D> sphere;
        std::array<Rational, D> c;
        for (std::size_t x = 0; x < D; ++x) sphere.c[x] = c[x] = Rational(random.below(9), 3);
        const Rational rho(random.below(15) - 4, 2);
        sphere.rho = rho;
        BallTuple<D> balls;
        std::array<std::array<Rational, D>, D + 1> directions;
        for (std::size_t i = 0; i <= D; ++i) {
            const Rational reach(1 + random.below(20), 4);
            directions[i] = direction<D>(random);
            for (std::size_t x = 0; x < D; ++x) balls[i].c[x] = c[x] + reach * directions[i][x];
            balls[i].r = reach - rho;
        }
        sphere.orientation = orientation_of<D>(directions);
        const auto found = touching_spheres<D>(balls);
        ++seen[static_cast<std::size_t>(found.count)];
        if (found.count == SphereCount::infinitely_many) {
            ASSERT_EQ(sphere.orientation, 0);
            continue;
        }
        flat += sphere.orientation == 0;
        ASSERT_TRUE(std::any_of(found.spheres.begin(), found.spheres.end(), [&](const auto& other) {
            return other.c == sphere.c && other.rho == sphere.rho &&
                   other.orientation == sphere.orientation;
        }));
    }
    EXPECT_EQ(seen[0], 0);
    for (const std::size_t count : {1U, 2U, 3U}) EXPECT_GT(seen[count], 0) << count;
    EXPECT_GT(flat, 10);
}

TEST(OracleBalls, FindsTheCircleThatIsThere) {
    finds_the_sphere_that_is_there<2>();
}
TEST(OracleBalls, FindsTheSphereThatIsThere) {
    finds_the_sphere_that_is_there<3>();
}

template <int D>
BallTuple<D> lattice_tuple(Random& random, int range, int radii) {
    BallTuple<D> balls;
    for (auto& ball : balls) {
        for (Rational& x : ball.c) x = random.below(range);
        ball.r = random.below(radii) - radii / 2;
    }
    return balls;
}

template <int D>
BallTuple<D> scattered_tuple(Random& random, double radius) {
    BallTuple<D> balls;
    for (auto& ball : balls) {
        for (Rational& x : ball.c) x = random.unit();
        ball.r = random.unit() * radius;
    }
    return balls;
}

template <int D>
int separation(const SpaceBall<D>& a, const SpaceBall<D>& b) {
    Rational sum = -(a.r - b.r) * (a.r - b.r);
    for (std::size_t x = 0; x < a.c.size(); ++x) sum += (a.c[x] - b.c[x]) * (a.c[x] - b.c[x]);
    return sum.sign();
}

/// What a sphere has to be, and what touches from outside cannot be.
template <int D>
void check_spheres(const BallTuple<D>& balls, const TouchingSpheres<D>& found) {
    const bool infinitely_many = found.count == SphereCount::infinitely_many;
    ASSERT_EQ(found.spheres.size(), infinitely_many ? 0 : static_cast<std::size_t>(found.count));
    for (const auto& sphere : found.spheres) {
        for (const auto& ball : balls) {
            ASSERT_EQ(side(sphere, ball), 0);
            ASSERT_GE((sphere.rho + Surd(ball.r)).sign(), 0);
        }
    }
    if (found.spheres.size() == 2) {
        ASSERT_EQ(found.spheres[0].orientation, 1);
        ASSERT_EQ(found.spheres[1].orientation, -1);
        ASSERT_FALSE(found.spheres[0].c == found.spheres[1].c &&
                     found.spheres[0].rho == found.spheres[1].rho);
    }
    for (const auto& a : balls) {
        for (const auto& b : balls) {
            const int apart = separation(a, b);
            if (apart < 0) {
                ASSERT_EQ(found.count, SphereCount::none);
            }
            if (apart == 0 && a != b) {
                for (const auto& sphere : found.spheres) ASSERT_EQ(sphere.orientation, 0);
            }
        }
    }
}

/// Other orders, mirror images, motions, all radii changed by one number.
template <int D>
void check_images(const BallTuple<D>& balls, const TouchingSpheres<D>& found, Random& random) {
    BallTuple<D> image = balls;
    std::array<std::size_t, D + 1> from;
    for (std::size_t i = 0; i <= D; ++i) from[i] = i;
    int sign = 1;
    for (std::size_t i = D; i > 0; --i) {
        const auto j = static_cast<std::size_t>(random.below(static_cast<int>(i) + 1));
        if (i != j) std::swap(from[i], from[j]), sign = -sign;
    }
    const Rational more(random.below(9) - 4, 3), shift(random.below(9) - 4, 5);
    const bool is_mirrored = random.below(2) == 0;
    if (is_mirrored) sign = -sign;
    for (std::size_t i = 0; i <= D; ++i) {
        image[i] = balls[from[i]];
        image[i].r += more;
        image[i].c[0] += shift;
        if (is_mirrored) std::swap(image[i].c[0], image[i].c[1]);
    }
    const auto again = touching_spheres<D>(image);
    ASSERT_EQ(again.count, found.count);
    for (std::size_t i = 0; i < found.spheres.size(); ++i) {
        auto expected = found.spheres[sign < 0 && found.spheres.size() == 2 ? 1 - i : i];
        expected.orientation *= sign;
        expected.c[0] = expected.c[0] + Surd(shift);
        if (is_mirrored) std::swap(expected.c[0], expected.c[1]);
        expected.rho = expected.rho - Surd(more);
        expect_sphere<D>(again.spheres[i], expected.c, expected.rho, expected.orientation);
    }
}

template <int D>
void agrees_with_the_definition() {
    Random random(D);
    std::array<int, 4> seen{};
    for (int trial = 0; trial < 6000; ++trial) {
        const auto balls = trial % 3 == 0   ? scattered_tuple<D>(random, 0.6)
                           : trial % 3 == 1 ? lattice_tuple<D>(random, 3, 3)
                                            : lattice_tuple<D>(random, 6, 5);
        const auto found = touching_spheres<D>(balls);
        ++seen[static_cast<std::size_t>(found.count)];
        ASSERT_NO_FATAL_FAILURE(check_spheres<D>(balls, found));
        ASSERT_NO_FATAL_FAILURE(check_images<D>(balls, found, random));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
    for (const int times : seen) EXPECT_GT(times, 50);
}

TEST(OracleBalls, AgreesWithTheDefinitionInThePlane) {
    agrees_with_the_definition<2>();
}
TEST(OracleBalls, AgreesWithTheDefinitionInSpace) {
    agrees_with_the_definition<3>();
}

/// (c_a - c_0)·(c_b - c_0) - (r_a - r_0)(r_b - r_0)
Rational inner(const BallTuple<3>& balls, std::size_t a, std::size_t b) {
    Rational sum = -(balls[a].r - balls[0].r) * (balls[b].r - balls[0].r);
    for (std::size_t x = 0; x < 3; ++x)
        sum += (balls[a].c[x] - balls[0].c[x]) * (balls[b].c[x] - balls[0].c[x]);
    return sum;
}

/// Three balls of which none contains another are touched by a curve's spheres: by the sign of
/// Gram's determinant a hyperbola, a parabola or an ellipse, of which all touch from outside, or
/// all from inside, or which is empty. A fourth ball that the same spheres touch changes nothing,
/// so it is let go of here.
bool is_curve(const BallTuple<3>& balls, std::size_t i, std::size_t j) {
    const Rational pi = inner(balls, i, i), pj = inner(balls, j, j), pij = inner(balls, i, j);
    const Rational gram = pi * pj - pij * pij;
    if (gram.sign() > 0) return true;
    // The nearest to a solution in the span, (s v_i + t v_j) / gram; of a parabola its direction.
    const Rational s = pi * pj - pij * pj, t = pi * pj - pij * pi;
    const auto radius = [&](std::size_t a) { return Rational(balls[0].r - balls[a].r); };
    if (gram.sign() == 0) {
        // v_i less its part along v_j, which has product 0 with both, is a direction of the cone.
        const Rational factor = pij / pj;
        const Rational h = radius(i) - factor * radius(j);
        const Rational product = pi - factor * pj;  // of the solution and that direction, twice
        return (h * product).sign() < 0;
    }
    const Rational square = s * pi + t * pj;  // 2 gram |solution|²
    const Rational h = s * radius(i) + t * radius(j);
    return square.sign() > 0 && h.sign() < 0;
}

TEST(OracleBalls, CurvesOfSpheresByGramsDeterminant) {
    Random random(11);
    int inconsistent = 0;
    std::map<int, std::array<int, 2>>
        seen;  // by the sign of Gram's determinant, how many are curves
    for (int trial = 0; trial < 40000; ++trial) {
        BallTuple<3> balls = lattice_tuple<3>(random, 4, 6);
        const int family = random.below(4);
        if (family == 0) {  // in a plane
            for (auto& ball : balls) ball.c[2] = 0, ball.r = random.below(2);
        } else if (family == 1) {  // all touch the plane x = 0 on a line of it
            const int sign = random.below(2) == 0 ? 1 : -1, slope = random.below(5) - 2;
            for (auto& ball : balls) {
                const int y = random.below(9) - 4, x = sign * y * (y + slope);
                ball = {{x, y, 0}, -x};
            }
        } else if (family == 2) {  // on an axis, a circle of radius 1 around it as far or less far
            const int sign = random.below(2) == 0 ? 1 : -1;
            for (auto& ball : balls) {
                const Rational t(1 + random.below(6), 1 + random.below(6));
                ball = {{(t - 1 / t) / 2, 0, 0}, sign * (t + 1 / t) / 2};
            }
        }
        bool is_apart = true;
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = 0; b < a; ++b)
                is_apart = is_apart && separation(balls[a], balls[b]) > 0;
        if (!is_apart) continue;
        // Of rank two, and consistent: 2 s·v_i = |v_i|² for a sphere s, so what one of them is of
        // the others its square is of theirs.
        const auto rank_two = [&] {
            for (std::size_t skipped = 0; skipped < 4; ++skipped) {
                std::vector<std::vector<Rational>> rows;
                for (std::size_t i = 1; i < 4; ++i) {
                    std::vector<Rational>& row = rows.emplace_back();
                    for (std::size_t x = 0; x < 3; ++x)
                        if (x != skipped) row.push_back(balls[i].c[x] - balls[0].c[x]);
                    if (skipped != 3) row.push_back(balls[i].r - balls[0].r);
                }
                if (!signum::oracle::determinant(rows).is_zero()) return false;
            }
            return true;
        };
        if (!rank_two()) continue;
        const auto found = touching_spheres<3>(balls);
        ASSERT_TRUE(found.spheres.empty());
        std::vector<std::vector<Rational>> rows;
        for (std::size_t i = 1; i < 4; ++i) {
            std::vector<Rational>& row = rows.emplace_back();
            for (std::size_t x = 0; x < 3; ++x) row.push_back(balls[i].c[x] - balls[0].c[x]);
            row.push_back(balls[i].r - balls[0].r);
            row.push_back(inner(balls, i, i) / 2);
        }
        const bool is_consistent = signum::oracle::solutions(rows, 4).has_value();
        const bool expected = is_consistent && is_curve(balls, 1, 2);
        ASSERT_EQ(found.count, expected ? SphereCount::infinitely_many : SphereCount::none);
        if (!is_consistent) {
            ++inconsistent;
            continue;
        }
        const Rational p12 = inner(balls, 1, 2);
        const Rational gram = inner(balls, 1, 1) * inner(balls, 2, 2) - p12 * p12;
        ++seen[gram.sign()][expected];
    }
    EXPECT_GT(inconsistent, 50);
    EXPECT_GT(seen[1][1], 10);
    for (const int sign : {0, -1})
        for (const int times : seen[sign]) EXPECT_GT(times, 10) << sign;
}

Balls<2> plane_balls(const std::vector<Site>& sites) {
    Balls<2> balls;
    for (const Site& site : sites) balls.push_back(exact_ball(site));
    return balls;
}

/// A vertex of three balls as a face of the plane's oracle.
Face face_of(const BallVertex<2>& vertex) {
    const auto& b = vertex.balls;
    return vertex.sphere.orientation > 0 ? Face{b[0], b[1], b[2]} : Face{b[0], b[2], b[1]};
}

Faces finite_faces_of(const signum::oracle::Tessellation& t) {
    Faces faces;
    for (const Face& face : t.faces)
        if (face[0] >= 0) faces.push_back(face);
    return faces;
}

void check_hidden(const signum::oracle::Tessellation& t, const Balls<2>& balls) {
    std::vector<bool> expected(balls.size(), false);
    for (const auto& [site, by] : t.hidden) expected[static_cast<std::size_t>(site)] = true;
    ASSERT_EQ(hidden_balls<2>(balls), expected);
}

TEST(OracleBallVertices, AreTheFacesOfTheApolloniusGraph) {
    Random random(3);
    std::size_t faces = 0, hidden = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const auto sites = generic_sites<Site>(random, random.below(10), 0.1 + 0.1 * (trial % 6));
        const auto balls = plane_balls(sites);
        const auto expected = signum::oracle::euclidean(sites);
        check_hidden(expected, balls);
        Faces found;
        for (const auto& vertex : ball_vertices<2>(balls)) {
            ASSERT_EQ(vertex.balls.size(), 3U);
            found.push_back(face_of(vertex));
        }
        std::sort(found.begin(), found.end());
        ASSERT_EQ(found, finite_faces_of(expected));
        faces += found.size();
        hidden += expected.hidden.size();
    }
    EXPECT_GT(faces, 500U);
    EXPECT_GT(hidden, 50U);
}

TEST(OracleBallVertices, StandWhereTiesAreDecided) {
    // What three balls touch and no fourth does is not changed by infinitely small changes of
    // radii; where more balls touch, faces are between these.
    Random random(4);
    std::size_t simple = 0, tied = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const auto sites =
            integer_sites<Site>(random, 4 + random.below(5), 3 + trial % 4, 1 + trial % 3);
        const auto balls = plane_balls(sites);
        const auto t = signum::oracle::euclidean(sites);
        check_hidden(t, balls);
        for (const auto& vertex : ball_vertices<2>(balls)) {
            std::size_t within = 0;
            for (const Face& face : finite_faces_of(t))
                within += std::all_of(face.begin(), face.end(), [&](std::int32_t i) {
                    return std::binary_search(vertex.balls.begin(), vertex.balls.end(), i);
                });
            if (vertex.balls.size() > 3) {
                ASSERT_GT(within, 0U);
                ++tied;
            } else {
                ASSERT_EQ(std::count(t.faces.begin(), t.faces.end(), face_of(vertex)), 1);
                ++simple;
            }
        }
    }
    EXPECT_GT(simple, 200U);
    EXPECT_GT(tied, 15U);
}

TEST(OracleBallVertices, OfPointsAreTheDelaunayCells) {
    Random random(5);
    std::size_t simple = 0, tied = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const int n = 4 + random.below(5);
        std::vector<signum::oracle::SpaceSite<3>> sites;
        Balls<3> balls;
        for (int i = 0; i < n; ++i) {
            auto& site = sites.emplace_back();
            for (double& x : site.c) x = trial % 2 == 0 ? random.unit() : random.below(3);
            balls.push_back(exact_ball(Site3{site.c[0], site.c[1], site.c[2], 0.25}));
        }
        const auto t = signum::oracle::power_space<3>(sites);
        if (t.dimension < 3) continue;
        const auto vertices = ball_vertices<3>(balls);
        std::size_t cells = 0;
        for (const auto& vertex : vertices) {
            std::size_t within = 0;
            for (const auto& cell : t.cells)
                within += std::includes(vertex.balls.begin(), vertex.balls.end(), cell.begin(),
                                        cell.end());
            ASSERT_GT(within, 0U);
            cells += within;
            if (vertex.balls.size() == 4) {
                const std::array<std::int32_t, 4> tuple{vertex.balls[0], vertex.balls[1],
                                                        vertex.balls[2], vertex.balls[3]};
                ASSERT_EQ(within, 1U);
                ASSERT_EQ(vertex.sphere.orientation, -signum::oracle::orientation<3>(sites, tuple));
                ++simple;
            } else {
                ++tied;
            }
        }
        ASSERT_EQ(cells, t.cells.size());
    }
    EXPECT_GT(simple, 100U);
    EXPECT_GT(tied, 15U);
}

TEST(OracleBallVertices, ByHand) {
    // A large ball between three small ones and a fourth far off: two vertices of the same balls.
    Balls<3> balls;
    for (const Site3& site : {Site3{5, 0, 0, 3},
                              {-5, 0, 0, 3},
                              {0, 5, 0, 3},
                              {0, 0, 0, 1},
                              {0, 0, 0, 0.5},
                              {5, 0, 0, 3}})
        balls.push_back(exact_ball(site));
    const auto vertices = ball_vertices<3>(balls);
    ASSERT_EQ(vertices.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(vertices[i].balls, (std::vector<std::int32_t>{0, 1, 2, 3}));
        EXPECT_EQ(vertices[i].sphere.orientation, i == 0 ? 1 : -1);
    }
    EXPECT_TRUE(ball_vertices<3>({}).empty());

    // The eight corners of a cube.
    Balls<3> cube;
    for (int i = 0; i < 8; ++i)
        cube.push_back(exact_ball(Site3{static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1),
                                        static_cast<double>(i >> 2), 0}));
    ASSERT_EQ(ball_vertices<3>(cube).size(), 1U);
    EXPECT_EQ(ball_vertices<3>(cube)[0].balls.size(), 8U);
    // Another in the middle: each corner's octant now has nothing, for centres at infinity are
    // passed over; a face of the cube and the middle are touched by one sphere.
    cube.push_back(exact_ball(Site3{0.5, 0.5, 0.5, 0}));
    const auto faces = ball_vertices<3>(cube);
    ASSERT_EQ(faces.size(), 6U);
    for (const auto& vertex : faces) EXPECT_EQ(vertex.balls.size(), 5U);
}

}  // namespace
