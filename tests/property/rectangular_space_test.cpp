// The predicates of the supremum and the Manhattan metric of space against the oracle, which tries
// all facets in rationals: on inputs made to break them, in every rounding mode, with and without
// flushing of denormals.

#include <gtest/gtest.h>

#include <map>

#include "environments.hpp"
#include "rectangular_families.hpp"

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

template <class Space>
class RectangularSpace : public testing::TestWithParam<Family> {
 protected:
    Random random_{2028};
    [[nodiscard]] Sites draw() { return sites_of<Site3>(GetParam().draw(random_, 3)); }
    [[nodiscard]] static int trials(int count) {
        return static_cast<int>(count * GetParam().share * effort) + 1;
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
    test_spheres(200);
}
TEST_P(Octahedra, AreTheOracles) {
    test_spheres(60);
}
TEST_P(Cubes, InSphere) {
    test_in_sphere(3000);
}
TEST_P(Octahedra, InSphere) {
    test_in_sphere(2000);
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

}  // namespace
}  // namespace signum
