// The predicates of the supremum and the Manhattan metric of space against the oracle, which tries
// all facets in rationals: on inputs made to break them, in every rounding mode, with and without
// flushing of denormals.

#include <gtest/gtest.h>

#include <map>

#include "../../voronoi/balls/touching_rectangular.hpp"
#include "environments.hpp"
#include "rectangular_families.hpp"
#include "rounded.hpp"

namespace signum {
namespace {

using rectangular::Spheres;
using rectangular_families::families;
using rectangular_families::Family;

using Sites = SitesOf<Site3>;

template <class Space>
Spheres spheres_of(const Sites& s) {
    return Space::spheres(s[0], s[1], s[2], s[3]);
}
bool same(const Spheres& a, const Spheres& b) {
    return a.infinitely_many == b.infinitely_many && a.count == b.count && a.spheres == b.spheres;
}

/// Asserts that the predicate says `expected` in every environment.
template <class Predicate>
[[nodiscard]] testing::AssertionResult says(const Sites& sites, int expected,
                                            const Predicate& predicate) {
    for (int e = 0; e < environments; ++e) {
        const Decision decision = within(e, [&] { return predicate(sites); });
        if (decision.sign != expected)
            return testing::AssertionFailure()
                   << "says " << decision.sign << " by " << name_of(decision.stage) << ", not "
                   << expected << ", " << name_of_environment(e) << ": " << text_of<Site3>(sites);
    }
    return testing::AssertionSuccess();
}

/// The spheres in rationals. Asserts that they touch, are in order, and are the same in every
/// environment.
template <class Space>
std::vector<oracle::RectangularSphere<3>> checked_spheres(const Sites& sites) {
    const auto tuple = tuple_of<Site3>(sites);
    const Spheres found = spheres_of<Space>(sites);
    std::vector<oracle::RectangularSphere<3>> spheres;
    unsigned last = 1U << Space::facets;
    for (std::size_t n = 0; n < found.count; ++n) {
        const auto& sphere = spheres.emplace_back(sphere_of<Space>(found.spheres[n], tuple));
        for (const auto& site : tuple)
            EXPECT_EQ(oracle::side<3>(Space::metric, sphere, site), 0) << text_of<Site3>(sites);
        const unsigned facets = touched_facets<Space>(sphere, tuple);
        EXPECT_LT(facets, last) << text_of<Site3>(sites);
        last = facets;
    }
    if constexpr (std::is_same_v<Space, SupremumSpace>) {
        EXPECT_TRUE(std::is_sorted(spheres.begin(), spheres.end()));
    }
    for (int e = 1; e < environments; ++e)
        EXPECT_TRUE(same(within(e, [&] { return spheres_of<Space>(sites); }), found))
            << name_of_environment(e) << ": " << text_of<Site3>(sites);
    return spheres;
}

/// The nearest double, an infinity beyond them.
double nearest(const oracle::Rational& number) {
    const double value = rounded(mpq_class(number.backend().data()));
    return std::isnan(value) ? number.sign() * HUGE_VAL : value;
}
Site3 nearest(const oracle::RectangularSphere<3>& sphere) {
    return {nearest(sphere.c[0]), nearest(sphere.c[1]), nearest(sphere.c[2]), nearest(sphere.rho)};
}

template <class Space>
class RectangularSpace : public testing::TestWithParam<Family> {
 protected:
    Random random_{2028};
    [[nodiscard]] Sites draw() { return sites_of<Site3>(GetParam().draw(random_, 3)); }
    /// slow/large_rectangular_space_test asks ten million more.
    [[nodiscard]] static int trials(int count) {
        return static_cast<int>(0.4 * count * GetParam().share * effort) + 1;
    }

    void test_spheres(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            const Sites sites = draw();
            const auto expected =
                oracle::touching_spheres<3>(Space::metric, tuple_of<Site3>(sites));
            ASSERT_EQ(spheres_of<Space>(sites).infinitely_many, expected.infinitely_many)
                << text_of<Site3>(sites);
            auto found = checked_spheres<Space>(sites);
            ASSERT_FALSE(HasFailure());
            std::sort(found.begin(), found.end());
            ASSERT_EQ(found, expected.spheres) << text_of<Site3>(sites);
        }
    }

    void test_in_sphere(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            const Sites sites = draw();
            const Spheres contacts = spheres_of<Space>(sites);
            const auto spheres = checked_spheres<Space>(sites);
            ASSERT_FALSE(HasFailure());
            for (std::size_t n = 0; n < spheres.size(); ++n) {
                const int expected =
                    -oracle::side<3>(Space::metric, spheres[n], oracle::exact_ball(sites[4]));
                ASSERT_TRUE(says(sites, expected, [&](const Sites& s) {
                    return Space::in_sphere_decision(s[0], s[1], s[2], s[3], contacts.spheres[n],
                                                     s[4]);
                }));
                ASSERT_EQ(Space::in_sphere(sites[0], sites[1], sites[2], sites[3], sites[4],
                                           static_cast<std::uint8_t>(n)),
                          expected);
            }
        }
    }

    void test_touching_spheres(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            const Sites sites = draw();
            const RectangularSpheres found = within(trial % environments, [&] {
                return touching_spheres(std::span(sites).first(4), typename Space::Metric());
            });
            ASSERT_EQ(found.infinitely_many, spheres_of<Space>(sites).infinitely_many);
            const auto expected = checked_spheres<Space>(sites);
            ASSERT_EQ(found.spheres.size(), expected.size());
            for (std::size_t n = 0; n < expected.size(); ++n)
                ASSERT_EQ(found.spheres[n], nearest(expected[n])) << text_of<Site3>(sites);
        }
    }

    void test_any_order(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            Sites sites = draw();
            const bool infinitely_many = spheres_of<Space>(sites).infinitely_many;
            const auto expected = checked_spheres<Space>(sites);
            for (int times = 0; times < 3; ++times) {
                for (int m = 3; m > 0; --m)
                    std::swap(sites[static_cast<std::size_t>(m)],
                              sites[static_cast<std::size_t>(random_.below(m + 1))]);
                ASSERT_EQ(checked_spheres<Space>(sites), expected) << text_of<Site3>(sites);
                ASSERT_EQ(spheres_of<Space>(sites).infinitely_many, infinitely_many);
            }
            ASSERT_FALSE(HasFailure());
        }
    }

    void test_hides(int count) {
        for (int trial = trials(count); trial > 0; --trial) {
            const Sites sites = draw();
            const std::array pair = {oracle::exact_ball(sites[4]), oracle::exact_ball(sites[0])};
            // Of equal sites the first is not hidden by the others.
            const bool expected =
                sites[4] == sites[0] || oracle::hidden_sites<3>(Space::metric, pair)[0];
            ASSERT_TRUE(says(sites, expected ? 1 : -1,
                             [](const Sites& s) { return Space::hides_decision(s[0], s[4]); }));
            ASSERT_EQ(Space::hidden(sites[4], sites[0]), expected);
        }
    }
};

using Cubes = RectangularSpace<SupremumSpace>;
using Octahedra = RectangularSpace<ManhattanSpace>;

TEST_P(Cubes, AreTheOracles) {
    test_spheres(120);
}
TEST_P(Octahedra, AreTheOracles) {
    test_spheres(30);
}
TEST_P(Cubes, InSphere) {
    test_in_sphere(3000);
}
TEST_P(Octahedra, InSphere) {
    test_in_sphere(2000);
}
TEST_P(Cubes, Rounded) {
    test_touching_spheres(2000);
}
TEST_P(Octahedra, Rounded) {
    test_touching_spheres(2000);
}
TEST_P(Cubes, InAnyOrder) {
    test_any_order(300);
}
TEST_P(Octahedra, InAnyOrder) {
    test_any_order(300);
}
TEST_P(Cubes, Hide) {
    test_hides(2000);
}
TEST_P(Octahedra, Hide) {
    test_hides(2000);
}

INSTANTIATE_TEST_SUITE_P(Families, Cubes, testing::ValuesIn(families<SupremumSpace>),
                         [](const auto& info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Families, Octahedra, testing::ValuesIn(families<ManhattanSpace>),
                         [](const auto& info) { return std::string(info.param.name); });

// ---- the numbers of spheres --------------------------------------------------------------------

/// All kinds of degenerate sites are among the families: so many have each number of spheres, of
/// which infinitely many counts as 99.
template <class Space>
std::map<int, int> numbers_of_spheres() {
    std::map<int, int> numbers;
    Random random(11);
    for (const Family& family : families<Space>)
        for (int trial = 0; trial < 2000; ++trial) {
            const Spheres found = spheres_of<Space>(sites_of<Site3>(family.draw(random, 3)));
            ++numbers[found.infinitely_many ? 99 : found.count];
        }
    return numbers;
}
TEST(CubesOfSpace, OfEveryNumber) {
    const auto numbers = numbers_of_spheres<SupremumSpace>();
    EXPECT_EQ(numbers.size(), 4U);
    for (const int number : {0, 1, 2, 99}) EXPECT_GT(numbers.at(number), 200) << number;
}
TEST(OctahedraOfSpace, OfEveryNumber) {
    const auto numbers = numbers_of_spheres<ManhattanSpace>();
    for (const int number : {0, 1, 2, 3, 99}) EXPECT_GT(numbers.at(number), 20) << number;
}

TEST(CubesOfSpace, ByHand) {
    // On x = 0, x = 4, y = 0 and z = 4 of a cube.
    const std::array<Site3, 4> held = {Site3{0, 1, 2, 0}, {4, 3, 1, 0}, {1, 0, 3, 0}, {2, 2, 4, 0}};
    const RectangularSpheres one = touching_spheres(held, Supremum());
    EXPECT_FALSE(one.infinitely_many);
    EXPECT_EQ(one.spheres, (std::vector<Site3>{{2, 2, 2, 2}}));
    const auto conflict = [&](const Site3& q) {
        return supremum::in_sphere(held[0], held[1], held[2], held[3], q, 0);
    };
    EXPECT_EQ(conflict({2, 2, 2, 0}), 1);
    EXPECT_EQ(conflict({4, 4, 4, 0}), 0);
    EXPECT_EQ(conflict({5, 5, 5, 1}), 0);
    EXPECT_EQ(conflict({5, 5, 5, 0x1.0000000000001p0}), 1);
    EXPECT_EQ(conflict({5, 5, 5, 0x1.fffffffffffffp-1}), -1);
    // Along y it may move if the third lies on an edge of the others' facets.
    EXPECT_TRUE(touching_spheres(std::array{held[0], held[1], held[3], held[3]}, Supremum())
                    .infinitely_many);
    // Left and right of the third.
    const std::array<Site3, 4> between = {
        Site3{0, 0, -4, 2}, {0, 0, 4, 2}, {0, 0, 0, 1}, {0, 9, 0, 6.5}};
    const RectangularSpheres two = touching_spheres(between, Supremum());
    EXPECT_EQ(two.spheres, (std::vector<Site3>{{-3, 0.5, 0, 2}, {3, 0.5, 0, 2}}));
}
TEST(OctahedraOfSpace, ByHand) {
    const std::array<Site3, 4> four = {
        Site3{1, 1, 1, 0}, {1, -1, -1, 0}, {-1, 1, -1, 0}, {-1, -1, 1, 0}};
    const RectangularSpheres one = touching_spheres(four, Manhattan());
    EXPECT_FALSE(one.infinitely_many);
    EXPECT_EQ(one.spheres, (std::vector<Site3>{{0, 0, 0, 3}}));
    const auto conflict = [&](const Site3& q) {
        return manhattan::in_sphere(four[0], four[1], four[2], four[3], q, 0);
    };
    EXPECT_EQ(conflict({1, 1, 0.5, 0}), 1);
    EXPECT_EQ(conflict({-1, -1, -1, 0}), 0);
    EXPECT_EQ(conflict({3, 0, 1, 1}), 0);
    EXPECT_EQ(conflict({3, 0, 1, 0.75}), -1);
}

/// As many as there can be.
TEST(OctahedraOfSpace, Six) {
    const std::array<Site3, 4> four = {
        Site3{0, 0, 0, 0}, {7, 15, -10, -6}, {1, 3, -2, -5}, {8, 16, -11, -4}};
    const RectangularSpheres six = touching_spheres(four, Manhattan());
    EXPECT_EQ(six.spheres, (std::vector<Site3>{{0.5, 8.5, -10.5, 19.5},
                                               {6.5, 2.5, -10.5, 19.5},
                                               {0.5, 15.5, -3.5, 19.5},
                                               {2.5, 15.5, -1.5, 19.5},
                                               {7.5, 2.5, -9.5, 19.5},
                                               {7.5, 10.5, -1.5, 19.5}}));
    oracle::BallTuple<3> tuple;
    for (std::size_t m = 0; m < 4; ++m) tuple[m] = oracle::exact_ball(four[m]);
    EXPECT_EQ(oracle::touching_spheres<3>(ManhattanSpace::metric, tuple).spheres.size(), 6U);
}

TEST(TouchingRectangular, RefuseWhatIsNoSiteAndMetricsOfBalls) {
    std::array<Site3, 4> sites = {Site3{0, 1, 2, 0}, {4, 3, 1, 0}, {1, 0, 3, 0}, {2, 2, 4, 0}};
    EXPECT_THROW(static_cast<void>(touching_spheres(std::span(sites).first(3), Supremum())),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(touching_spheres(sites, Power())), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(touching_spheres(sites, Euclidean())), std::invalid_argument);
    sites[2].r = std::numeric_limits<double>::infinity();
    EXPECT_THROW(static_cast<void>(touching_spheres(sites, Manhattan())), std::invalid_argument);
}

// ---- stages ------------------------------------------------------------------------------------

/// Which stages answer, of what: of the spheres, and of the query.
template <class Space, class Draw>
std::array<std::map<Stage, int>, 2> stages_of(const Draw& draw) {
    Random random(7);
    std::array<std::map<Stage, int>, 2> count;
    for (int trial = 0; trial < 4000; ++trial) {
        const auto s = sites_of<Site3>(draw(random, 3));
        const Spheres found = spheres_of<Space>(s);
        ++count[0][found.stage];
        for (std::size_t n = 0; n < found.count; ++n)
            ++count[1][Space::in_sphere_decision(s[0], s[1], s[2], s[3], found.spheres[n], s[4])
                           .stage];
    }
    return count;
}
template <class Space>
void test_stages() {
    const auto all = [](const std::map<Stage, int>& count) {
        int sum = 0;
        for (const auto& [stage, times] : count) sum += times;
        return sum;
    };
    for (auto& count : stages_of<Space>(ball_families::random_balls)) {
        EXPECT_GT(all(count), 500);
        EXPECT_EQ(count[Stage::filter], all(count));
    }
    // On integers no sum rounds.
    for (auto& count : stages_of<Space>(rectangular_families::tangent<Space>)) {
        EXPECT_GT(count[Stage::exact], 300);
        EXPECT_EQ(count[Stage::essa], 0);
    }
    const auto off_grid = [](Random& g, int d) {
        return ball_families::off_grid(rectangular_families::tangent<Space>(g, d));
    };
    for (auto& count : stages_of<Space>(off_grid)) EXPECT_GT(count[Stage::essa], 300);
}
TEST(CubesOfSpace, Stages) {
    test_stages<SupremumSpace>();
}
TEST(OctahedraOfSpace, Stages) {
    test_stages<ManhattanSpace>();
}

}  // namespace
}  // namespace signum
