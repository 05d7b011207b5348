/// The oracle of cubes and cross-polytopes against cases by hand, spheres that are built with their
/// sites, a look at every point of a lattice, the oracles of the plane, and what motions and other
/// orders do to it.

#include <gtest/gtest.h>
#include "oracle_test_support.hpp"
#include "rectangular.hpp"
#include "rectangular_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::Site;
using signum::Site3;
using signum::oracle::BallTuple;
using signum::oracle::exact_ball;
using signum::oracle::hidden_sites;
using signum::oracle::Rational;
using signum::oracle::RectangularMetric;
using signum::oracle::RectangularSphere;
using signum::oracle::RectangularSpheres;
using signum::oracle::side;
using signum::oracle::SpaceBall;
using signum::oracle::touching_spheres;

constexpr auto supremum = RectangularMetric::supremum;
constexpr auto manhattan = RectangularMetric::manhattan;
constexpr std::array both_metrics{supremum, manhattan};

template <int D>
using Vector = std::array<Rational, D>;
template <int D>
using Spheres = std::vector<RectangularSphere<D>>;

RectangularSpheres<2> touching(RectangularMetric metric, const std::array<Site, 3>& sites) {
    BallTuple<2> tuple;
    for (std::size_t i = 0; i < 3; ++i) tuple[i] = exact_ball(sites[i]);
    return touching_spheres<2>(metric, tuple);
}

RectangularSpheres<3> touching(RectangularMetric metric, const std::array<Site3, 4>& sites) {
    BallTuple<3> tuple;
    for (std::size_t i = 0; i < 4; ++i) tuple[i] = exact_ball(sites[i]);
    return touching_spheres<3>(metric, tuple);
}

TEST(OracleRectangularSpace, ByHandInThePlane) {
    // A square of side 4 with points on its left, lower and right sides.
    const auto square = touching(supremum, {Site{0, 1, 0}, {1, 0, 0}, {4, 2, 0}});
    EXPECT_FALSE(square.infinitely_many);
    EXPECT_EQ(square.spheres, (Spheres<2>{{{2, 2}, 2}}));
    // The same, larger by 1 than the sites leave it.
    const auto between = touching(supremum, {Site{0, 1, 1}, {1, 0, 1}, {4, 2, 1}});
    EXPECT_EQ(between.spheres, (Spheres<2>{{{2, 2}, 1}}));
    // Above and below the one in the middle.
    const auto two = touching(supremum, {Site{-4, 0, 2}, {0, 0, 1}, {4, 0, 2}});
    EXPECT_FALSE(two.infinitely_many);
    EXPECT_EQ(two.spheres, (Spheres<2>{{{0, -3}, 2}, {{0, 3}, 2}}));
    // Points on two sides of a square can be moved along: a ray.
    EXPECT_TRUE(touching(supremum, {Site{0, 1, 0}, {0, 2, 0}, {4, 2, 0}}).infinitely_many);
    EXPECT_TRUE(touching(supremum, {Site{0, 0, 0}, {0, 0, 0}, {4, 2, 0}}).infinitely_many);
    // Nested; nested and tangent.
    const auto nested = touching(supremum, {Site{0, 0, 5}, {1, 1, 1}, {9, 9, 0}});
    EXPECT_TRUE(nested.spheres.empty() && !nested.infinitely_many);
    EXPECT_TRUE(touching(supremum, {Site{0, 0, 5}, {4, 0, 1}, {20, 1, 0}}).infinitely_many);

    const auto diamond = touching(manhattan, {Site{2, 0, 0}, {-1, 1, 0}, {-1, -1, 0}});
    EXPECT_FALSE(diamond.infinitely_many);
    EXPECT_EQ(diamond.spheres, (Spheres<2>{{{0, 0}, 2}}));
}

TEST(OracleRectangularSpace, ByHandInSpace) {
    // Points on the facets x = 0, x = 4, y = 0, z = 4 of a cube.
    const auto cube =
        touching(supremum, {Site3{0, 1, 2, 0}, {4, 3, 1, 0}, {1, 0, 3, 0}, {2, 2, 4, 0}});
    EXPECT_FALSE(cube.infinitely_many);
    EXPECT_EQ(cube.spheres, (Spheres<3>{{{2, 2, 2}, 2}}));
    // Cubes of their own in place of points.
    const auto cubes = touching(
        supremum, {Site3{-1, 1, 2, 1}, {4.5, 3, 1, 0.5}, {1, -3, 3, 3}, {2, 2, 3.5, -0.5}});
    EXPECT_EQ(cubes.spheres, (Spheres<3>{{{2, 2, 2}, 2}}));
    // Points on x = 0, x = 4, y = 0, y = 4: the cube may rise and fall.
    EXPECT_TRUE(touching(supremum, {Site3{0, 1, 2, 0}, {4, 3, 1, 0}, {1, 0, 3, 0}, {2, 4, 2, 0}})
                    .infinitely_many);
    // Where one of them lies on z = 0 and another on z = 4 it may not.
    const auto held =
        touching(supremum, {Site3{0, 1, 0, 0}, {4, 3, 4, 0}, {1, 0, 3, 0}, {2, 4, 2, 0}});
    EXPECT_FALSE(held.infinitely_many);
    EXPECT_EQ(held.spheres, (Spheres<3>{{{2, 2, 2}, 2}}));

    // Points of the facets +++, +--, -+-, --+ of a cross-polytope, which are those of a
    // tetrahedron.
    const auto inside =
        touching(manhattan, {Site3{1, 1, 1, 0}, {1, -1, -1, 0}, {-1, 1, -1, 0}, {-1, -1, 1, 0}});
    EXPECT_FALSE(inside.infinitely_many);
    EXPECT_TRUE(std::count(inside.spheres.begin(), inside.spheres.end(),
                           RectangularSphere<3>{{0, 0, 0}, 3}) == 1);
    const auto nested =
        touching(manhattan, {Site3{0, 0, 0, 9}, {1, 1, 1, 0}, {1, 2, 1, 0}, {50, 50, 50, 0}});
    EXPECT_TRUE(nested.spheres.empty() && !nested.infinitely_many);
    EXPECT_TRUE(touching(manhattan, {Site3{1, 2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4}, {1, 2, 3, 4}})
                    .infinitely_many);
}

TEST(OracleRectangularSpace, SidesAndHiddenSites) {
    const RectangularSphere<3> sphere{{2, 2, 2}, 2};
    const auto of = [&](RectangularMetric metric, const Site3& q) {
        return side<3>(metric, sphere, exact_ball(q));
    };
    EXPECT_EQ(of(supremum, {4, 4, 4, 0}), 0);
    EXPECT_EQ(of(supremum, {4, 4, 4, 0x1p-1000}), -1);
    EXPECT_EQ(of(supremum, {4, 4, 4, -0x1p-1000}), 1);
    EXPECT_EQ(of(manhattan, {4, 4, 4, 0}), 1);
    EXPECT_EQ(of(manhattan, {4, 4, 4, 4}), 0);
    EXPECT_EQ(of(manhattan, {3, 2, 2, 0}), -1);

    std::vector<SpaceBall<3>> sites;
    for (const Site3& site : {Site3{0, 0, 0, 3}, {2, 2, 2, 1}, {1, 1, 1, 0}, {0, 0, 0, 3}})
        sites.push_back(exact_ball(site));
    EXPECT_EQ(hidden_sites<3>(supremum, sites), (std::vector<bool>{0, 1, 1, 1}));
    EXPECT_EQ(hidden_sites<3>(manhattan, sites), (std::vector<bool>{0, 0, 1, 1}));
}

template <int D>
Rational distance(RectangularMetric metric, const Vector<D>& a, const Vector<D>& b) {
    Rational largest = 0, sum = 0;
    for (std::size_t x = 0; x < D; ++x) {
        const Rational difference = abs(Rational(a[x] - b[x]));
        largest = std::max(largest, difference);
        sum += difference;
    }
    return metric == supremum ? largest : sum;
}

template <int D>
BallTuple<D> lattice_tuple(Random& random, int range, int radii) {
    BallTuple<D> sites;
    for (auto& site : sites) {
        for (Rational& x : site.c) x = random.below(range);
        site.r = random.below(radii) - radii / 2;
    }
    return sites;
}

template <int D>
BallTuple<D> scattered_tuple(Random& random, double radius) {
    BallTuple<D> sites;
    for (auto& site : sites) {
        for (Rational& x : site.c) x = random.unit();
        site.r = random.unit() * radius;
    }
    return sites;
}

/// Sites around a sphere, of any radii, so that it must be found.
template <int D>
void finds_the_sphere_that_is_there(int trials) {
    Random random(D);
    for (const auto metric : both_metrics) {
        int alone = 0;
        for (int trial = 0; trial < trials; ++trial) {
            RectangularSphere<D> sphere;
            for (Rational& x : sphere.c) x = Rational(random.below(9), 3);
            sphere.rho = Rational(random.below(15) - 4, 2);
            BallTuple<D> sites;
            for (auto& site : sites) {
                Vector<D> direction;
                do {
                    for (Rational& x : direction) x = Rational(random.below(21) - 10, 7);
                } while (direction == Vector<D>{});
                const Rational length = distance<D>(metric, direction, {});
                const Rational reach(1 + random.below(20), 4);
                for (std::size_t x = 0; x < D; ++x)
                    site.c[x] = sphere.c[x] + reach * direction[x] / length;
                site.r = reach - sphere.rho;
            }
            const auto found = touching_spheres<D>(metric, sites);
            if (found.infinitely_many) continue;
            ASSERT_EQ(std::count(found.spheres.begin(), found.spheres.end(), sphere), 1);
            ++alone;
        }
        EXPECT_GT(alone, trials / 10);
    }
}

TEST(OracleRectangularSpace, FindsTheSphereThatIsThereInThePlane) {
    finds_the_sphere_that_is_there<2>(300);
}
TEST(OracleRectangularSpace, FindsTheSphereThatIsThereInSpace) {
    finds_the_sphere_that_is_there<3>(60);
}

/// What a sphere has to be; the same for other orders, mirror images, turned axes, motions, and all
/// radii changed by one number.
template <int D>
void check(RectangularMetric metric, const BallTuple<D>& sites, const RectangularSpheres<D>& found,
           Random& random) {
    if (found.infinitely_many) {
        ASSERT_TRUE(found.spheres.empty());
    }
    for (const auto& sphere : found.spheres)
        for (const auto& site : sites) {
            ASSERT_EQ(distance<D>(metric, sphere.c, site.c), sphere.rho + site.r);
            ASSERT_EQ(side<D>(metric, sphere, site), 0);
        }
    BallTuple<D> image = sites;
    std::rotate(image.begin(), image.begin() + 1 + random.below(D), image.end());
    const int turned = random.below(D), mirrored = random.below(2);
    const Rational more(random.below(9) - 4, 3), shift(random.below(9) - 4, 5);
    const auto moved = [&](Vector<D>& c) {
        std::rotate(c.begin(), c.begin() + turned, c.end());
        if (mirrored == 1) c[0] = -c[0];
        c[1] += shift;
    };
    for (auto& site : image) site.r += more, moved(site.c);
    const auto again = touching_spheres<D>(metric, image);
    ASSERT_EQ(again.infinitely_many, found.infinitely_many);
    auto expected = found.spheres;
    for (auto& sphere : expected) sphere.rho -= more, moved(sphere.c);
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(again.spheres, expected);
}

template <int D>
void agrees_with_the_definition(int trials) {
    Random random(D);
    std::map<std::size_t, int> seen;
    for (const auto metric : both_metrics) {
        for (int trial = 0; trial < trials; ++trial) {
            const auto sites =
                trial % 2 == 0 ? scattered_tuple<D>(random, 0.6) : lattice_tuple<D>(random, 6, 3);
            const auto found = touching_spheres<D>(metric, sites);
            ASSERT_NO_FATAL_FAILURE(check<D>(metric, sites, found, random));
            ++seen[found.infinitely_many ? 99 : found.spheres.size()];
        }
    }
    for (const std::size_t count : {0U, 1U, 99U}) EXPECT_GT(seen[count], trials / 50) << count;
}

TEST(OracleRectangularSpace, AgreesWithTheDefinitionInThePlane) {
    agrees_with_the_definition<2>(1000);
}
TEST(OracleRectangularSpace, AgreesWithTheDefinitionInSpace) {
    agrees_with_the_definition<3>(30);
}

/// All points of a lattice that touch; in doubles, which hold them exactly. The corners of what
/// touches sites with integers lie on halves (supremum) or quarters (Manhattan, in space).
template <int D>
Spheres<D> seen_on_lattice(RectangularMetric metric, const BallTuple<D>& sites, double low,
                           double high, double step) {
    std::array<std::array<double, D>, D + 1> c;
    std::array<double, D + 1> r;
    for (std::size_t i = 0; i <= D; ++i) {
        for (std::size_t x = 0; x < D; ++x) c[i][x] = static_cast<double>(sites[i].c[x]);
        r[i] = static_cast<double>(sites[i].r);
    }
    Spheres<D> seen;
    std::array<double, D> p;
    p.fill(low);
    while (p[D - 1] <= high) {
        const auto rho = [&](std::size_t i) {
            double largest = 0, sum = 0;
            for (std::size_t x = 0; x < D; ++x) {
                largest = std::max(largest, std::abs(p[x] - c[i][x]));
                sum += std::abs(p[x] - c[i][x]);
            }
            return (metric == supremum ? largest : sum) - r[i];
        };
        bool touches = true;
        for (std::size_t i = 1; i <= D && touches; ++i) touches = rho(i) == rho(0);
        if (touches) {
            auto& sphere = seen.emplace_back();
            for (std::size_t x = 0; x < D; ++x) sphere.c[x] = p[x];
            sphere.rho = rho(0);
        }
        std::size_t x = 0;
        while ((p[x] += step) > high && x + 1 < D) p[x++] = low;
    }
    std::sort(seen.begin(), seen.end());
    return seen;
}

/// Two of the spheres with a third in the middle.
template <int D>
bool have_a_segment(RectangularMetric metric, const BallTuple<D>& sites, const Spheres<D>& seen) {
    for (const auto& a : seen) {
        for (const auto& b : seen) {
            if (a == b) continue;
            RectangularSphere<D> middle = a;
            for (std::size_t x = 0; x < D; ++x) middle.c[x] = (a.c[x] + b.c[x]) / 2;
            middle.rho = (a.rho + b.rho) / 2;
            if (std::all_of(sites.begin(), sites.end(),
                            [&](const auto& site) { return side<D>(metric, middle, site) == 0; }))
                return true;
        }
    }
    return false;
}

template <int D>
void sees_all_of_a_lattice(int trials) {
    Random random(20 + D);
    std::map<std::size_t, int> seen;
    for (const auto metric : both_metrics) {
        for (int trial = 0; trial < trials; ++trial) {
            const auto sites = lattice_tuple<D>(random, 4, 3);
            const auto found = touching_spheres<D>(metric, sites);
            const double step = metric == supremum ? 0.5 : 0.25;
            const auto expected = seen_on_lattice<D>(metric, sites, -5, 8, step);
            if (found.infinitely_many) {
                ASSERT_TRUE(have_a_segment<D>(metric, sites, expected));
            } else {
                ASSERT_EQ(found.spheres, expected);
            }
            ++seen[found.infinitely_many ? 99 : found.spheres.size()];
        }
    }
    for (const std::size_t count : {0U, 1U, 99U}) EXPECT_GT(seen[count], trials / 50) << count;
}

TEST(OracleRectangularSpace, SeesAllOfALatticeOfThePlane) {
    sees_all_of_a_lattice<2>(400);
}
TEST(OracleRectangularSpace, SeesAllOfALatticeOfSpace) {
    sees_all_of_a_lattice<3>(25);
}

TEST(OracleRectangularSpace, EmptySquaresAreTheFacesOfThePlane) {
    Random random(3);
    std::size_t faces = 0, hidden = 0;
    for (const auto metric : both_metrics) {
        for (int trial = 0; trial < 60; ++trial) {
            const auto sites = generic_sites<Site>(random, random.below(9), 0.1 * (trial % 6));
            const auto expected = metric == supremum ? signum::oracle::supremum(sites)
                                                     : signum::oracle::manhattan(sites);
            std::vector<SpaceBall<2>> balls;
            for (const Site& site : sites) balls.push_back(exact_ball(site));
            std::vector<bool> is_hidden(sites.size(), false);
            for (const auto& [site, by] : expected.hidden)
                is_hidden[static_cast<std::size_t>(site)] = true;
            ASSERT_EQ(hidden_sites<2>(metric, balls), is_hidden);

            Faces found, of_plane;
            for (std::size_t i = 0; i < balls.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    for (std::size_t k = 0; k < j; ++k) {
                        const auto spheres =
                            touching_spheres<2>(metric, {balls[k], balls[j], balls[i]});
                        ASSERT_FALSE(spheres.infinitely_many);
                        for (const auto& sphere : spheres.spheres)
                            if (std::none_of(balls.begin(), balls.end(), [&](const auto& q) {
                                    return side<2>(metric, sphere, q) < 0;
                                }))
                                found.push_back({static_cast<std::int32_t>(k),
                                                 static_cast<std::int32_t>(j),
                                                 static_cast<std::int32_t>(i)});
                    }
                }
            }
            for (Face face : expected.faces) {
                std::sort(face.begin(), face.end());
                if (face[0] >= 0) of_plane.push_back(face);
            }
            std::sort(found.begin(), found.end());
            std::sort(of_plane.begin(), of_plane.end());
            ASSERT_EQ(found, of_plane);
            faces += found.size();
            hidden += expected.hidden.size();
        }
    }
    EXPECT_GT(faces, 200U);
    EXPECT_GT(hidden, 20U);
}

}  // namespace
