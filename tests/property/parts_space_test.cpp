/// Tessellations of space from parts are those from the whole: of sites made to be on cuts, to
/// reach across them, to hide one another from beyond them, and to be tied everywhere.

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/space/construct.hpp"
#include "../../triangulation/space/reach.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../thoroughness.hpp"
#include "../unit/exact_reference.hpp"
#include "in_parts.hpp"

namespace signum {
namespace {

using reference::Random;

/// Parts that share no memory, which tell one another what they must know.
template <class S>
void expect_the_same_of_parts_apart(const std::vector<S>& sites, const SpaceTessellation& whole,
                                    std::int64_t first_id, const std::string& what) {
    std::vector<distributed::Placed> placed;
    for (const S& site : sites) {
        Site3 given = {site.x, site.y, site.z};
        if constexpr (requires { site.r; }) given.r = site.r;
        if constexpr (requires { site.w; }) given.r = site.w;
        placed.push_back({given, first_id + static_cast<std::int64_t>(placed.size())});
    }
    const bool are_weights = std::same_as<S, power::Site3>;
    const distributed::Kind kind = {Metric::power,
                                    are_weights ? WeightIs::weight : WeightIs::radius, 3};
    // One number of parts for each of the three, and of few sites more parts than sites.
    constexpr bool has_radii = std::same_as<S, Site3>;
    constexpr std::size_t few = 30;
    const std::size_t many = sites.size() <= few ? 2 * few : 7;
    for (const std::size_t parts : {has_radii ? 3 : are_weights ? 2 : many}) {
        if (whole.dimension < 3) {
            EXPECT_THROW(static_cast<void>(distributed::settle_in_parts(placed, kind, parts)),
                         distributed::NoStructure)
                << what;
            continue;
        }
        distributed::WholeParts found = distributed::settle_in_parts(placed, kind, parts);
        for (auto& cell : found.cells)
            for (std::int64_t& id : cell) id -= id < 0 ? 0 : first_id;
        for (auto& [site, by] : found.hidden) {
            site -= first_id;
            by -= first_id;
        }
        ASSERT_EQ(distributed::space_of(found, whole.sites), whole)
            << what << ", " << parts << " parts apart";
    }
}

template <class S>
void expect_the_same_of(const std::vector<S>& sites, int levels, const std::string& what) {
    const SpaceTessellation whole = triangulate(std::span<const S>(sites), Power{}, {.threads = 1});
    const std::int64_t first_id = sites.size() % 2 == 0 ? 0 : std::int64_t{1} << 40;
    expect_the_same_of_parts_apart(sites, whole, first_id, what);
    if (testing::Test::HasFatalFailure()) return;
    for (int level = 1; level <= levels; ++level)
        for (const std::uint64_t seed : {1, 7})
            ASSERT_EQ(spatial::construct_in_parts(std::span<const S>(sites), {.seed = seed}, level),
                      whole)
                << what << ", " << level << " levels, seed " << seed;
}

/// Compares those of cuts in 1 to `levels` levels with that of one insertion after the other, which
/// is known to be that of oracles: as balls, as points, and as sites that carry a weight, which is
/// then that much smaller.
void expect_the_same(const std::vector<Site3>& sites, int levels, const std::string& what) {
    expect_the_same_of(sites, levels, what);
    std::vector<Point3> points;
    std::vector<power::Site3> weighted;
    for (const Site3& s : sites) {
        points.push_back({s.x, s.y, s.z});
        weighted.push_back({s.x, s.y, s.z, -s.r * std::fabs(s.r)});
    }
    if (!testing::Test::HasFatalFailure()) expect_the_same_of(points, levels, what + ", points");
    if (!testing::Test::HasFatalFailure()) expect_the_same_of(weighted, levels, what + ", weights");
}

double number(int n) {
    return static_cast<double>(n);
}

TEST(PartsOfSpace, OfFewDegenerateSites) {
    for (int trial = 0; trial < 100 * thoroughness; ++trial) {
        Random random(static_cast<std::uint64_t>(trial));
        const int family = trial % 7;
        const int span = random.between(1, 6);
        const int most = random.between(0, 4);
        std::vector<Site3> sites(static_cast<std::size_t>(random.between(1, 60)));
        const auto within = [&] { return number(random.between(0, span)); };
        for (Site3& s : sites) {
            s = {within(), within(), within(), number(random.between(0, most))};
            switch (family) {
                case 0:  // a box
                    break;
                case 1:  // of equal weights
                    s.r = 0;
                    break;
                case 2:  // in a plane, some a little beside it
                    s.z = s.x + s.y + number(random.between(0, 40) == 0 ? 1 : 0);
                    break;
                case 3:  // on a line, some a little beside it
                    s.y = 2 * s.x;
                    s.z = -s.x + number(random.between(0, 20) == 0 ? 1 : 0);
                    break;
                case 4: {  // on a sphere
                    const double a = number(random.coin() ? 2 : -2);
                    const double b = number(random.coin() ? 1 : -1);
                    const double c = number(random.coin() ? 2 : -2);
                    s = random.coin()   ? Site3{a, b, c, s.r}
                        : random.coin() ? Site3{b, c, a, s.r}
                                        : Site3{c, a, number(random.coin() ? 1 : -1), s.r};
                    if (random.between(0, 5) == 0) s = {3 * b, 0, 0, s.r};
                    break;
                }
                case 5:  // nested
                    s = {number(random.between(0, 2)), number(random.between(0, 2)),
                         number(random.between(0, 2)), number(random.between(0, 9))};
                    break;
                default:  // few giants among small ones
                    if (random.between(0, 8) == 0)
                        s = {3 * within(), -within(), 2 * within(), number(random.between(5, 12))};
            }
        }
        expect_the_same(sites, 3, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// Small integers, some giants among them: so many sites that parts have an inside of their own.
TEST(PartsOfSpace, OfManyDegenerateSites) {
    for (int trial = 0; trial < 2 * thoroughness; ++trial) {
        Random random(static_cast<std::uint64_t>(trial));
        const int count = random.between(1500, 5000);
        const int span = random.between(10, 24);
        const int most = trial % 3 == 0 ? 0 : random.between(1, 3);
        std::vector<Site3> sites;
        for (int i = 0; i < count; ++i)
            sites.push_back({number(random.between(0, 3 * span)), number(random.between(0, span)),
                             number(random.between(0, span)), number(random.between(0, most))});
        for (int i = trial % 4; i > 0; --i)
            sites.push_back(
                {number(random.between(-span, 2 * span)), number(random.between(-span, 2 * span)),
                 number(random.between(-span, 2 * span)), number(random.between(0, span / 2))});
        expect_the_same(sites, 3, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

/// A whole grid, of which all cubes are ties and the sides flat, and slabs of it.
TEST(PartsOfSpace, OfGrids) {
    for (const auto& [x, y, z] : {std::tuple{40, 10, 10}, {18, 18, 18}, {2, 40, 40}, {300, 3, 3}}) {
        std::vector<Site3> sites;
        for (int i = 0; i < x; ++i)
            for (int j = 0; j < y; ++j)
                for (int k = 0; k < z; ++k) sites.push_back({number(i), number(j), number(k), 0.5});
        expect_the_same(sites, 3,
                        std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z));
        if (HasFatalFailure()) return;
    }
}

/// One half of the sites weighs so much more than the other that it takes from it what lies far
/// beyond the cut, and hides what is there.
TEST(PartsOfSpace, WhereOneSideHidesTheOther) {
    for (int trial = 0; trial < 3 * thoroughness; ++trial) {
        Random random(static_cast<std::uint64_t>(trial));
        const double more = std::ldexp(1.0, random.between(-2, 4));
        std::vector<Site3> sites;
        for (int i = 0; i < 4000; ++i) {
            const Site3 site = {random.between(0, 1000) * 0.0625, random.between(0, 300) * 0.0625,
                                random.between(0, 300) * 0.0625,
                                random.between(0, 100) * 0.0078125};
            sites.push_back({site.x, site.y, site.z, site.r + (site.x > 30 ? more : 0.0)});
        }
        expect_the_same(sites, 3, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

TEST(PartsOfSpace, OfDistributions) {
    for (const SpaceDistribution distribution : all_space_distributions)
        for (const double radius : {0.0, 0.5, 9.0}) {
            expect_the_same(generate(distribution, {.count = is_fast ? 5000 : 1500,
                                                    .radius_from = radius / 3,
                                                    .radius_to = radius}),
                            3, std::string(name_of(distribution)));
            if (HasFatalFailure()) return;
        }
}

/// Huge and tiny: beyond the filters' windows, and beyond a double's range in between.
TEST(PartsOfSpace, OfAnyMagnitude) {
    for (const int exponent : {-1060, -530, -170, -140, 100, 140, 300, 500, 1010}) {
        Random random(5);
        std::vector<Site3> sites;
        for (int i = 0; i < 500; ++i)
            sites.push_back({std::ldexp(random.between(-1000, 1000), exponent),
                             std::ldexp(random.between(-1000, 1000), exponent),
                             std::ldexp(random.between(-1000, 1000), exponent),
                             std::ldexp(random.between(0, 60), exponent)});
        expect_the_same_of(sites, 2, "2^" + std::to_string(exponent));
        if (HasFatalFailure()) return;
    }
}

/// What is out of reach of a cell does not conflict with it, of cells that are all but flat, too;
/// and what lies well outside its sphere is out of reach.
TEST(PartsOfSpace, FormsTellOfNoConflictThatIsThere) {
    // Where products underflow.
    constexpr double least = 0x1p-1074;
    const std::array<Site3, 4> near = {{{0, 0, 0}, {0, 0.75, 0}, {-1.125, 0, 0}, {0, 0, 0.75}}};
    EXPECT_TRUE(spatial::InSphereForm(std::span<const Site3>(near), {0, 1, 2, 3})
                    .may_be_reached_from({{least, least, least}, {least, least, least}, 0.0}));
    Random random(3);
    int told = 0;
    const int trials = 20'000 * thoroughness;
    for (int trial = 0; trial < trials; ++trial) {
        const double thickness = std::ldexp(1.0, -random.between(0, 60));
        const double shift = std::ldexp(random.between(-1, 1), random.between(0, 40));
        const auto within = [&] { return shift + random.between(-1000, 1000) * 0.001; };
        std::array<Site3, 5> sites;
        for (Site3& site : sites)
            site = {within(), within(), shift + (within() - shift) * thickness,
                    random.between(0, 30) * 0.01};
        sites[4].z = within();
        const std::span<const Site3> cell(sites.data(), 4);
        const auto turn = [&] {
            return ccw(centre3(sites[0]), centre3(sites[1]), centre3(sites[2]), centre3(sites[3]));
        };
        if (turn() < 0) std::swap(sites[0], sites[1]);
        if (turn() == 0) continue;
        const Site3& q = sites[4];
        const double wide = random.coin() ? 0.0 : 0.125;
        const spatial::Box box = {
            {q.x - wide, q.y - wide, q.z - wide}, {q.x + wide, q.y + wide, q.z + wide}, q.r * q.r};
        const bool is_reached = spatial::InSphereForm(cell, {0, 1, 2, 3}).may_be_reached_from(box);
        const Sign sign = power::in_sphere(sites[0], sites[1], sites[2], sites[3], q);
        ASSERT_TRUE(is_reached || sign < 0) << "trial " << trial;
        told += is_reached ? 0 : 1;
    }
    EXPECT_GT(told, trials / 4);
}

/// The same bytes, however many threads.
class ThreadsInSpace : public testing::TestWithParam<std::tuple<SpaceDistribution, double>> {};

TEST_P(ThreadsInSpace, TellTheSame) {
    const auto [distribution, radius] = GetParam();
    const std::vector<Site3> sites =
        generate(distribution, {.count = is_fast ? 50'000 : 34'000, .radius_to = radius});
    const SpaceTessellation one =
        triangulate(std::span<const Site3>(sites), Power{}, {.threads = 1});
    for (const int threads : {2, 3, 7, 16})
        ASSERT_EQ(triangulate(std::span<const Site3>(sites), Power{}, {.threads = threads}), one)
            << threads << " threads";
}

INSTANTIATE_TEST_SUITE_P(, ThreadsInSpace,
                         testing::Combine(testing::ValuesIn(all_space_distributions),
                                          testing::Values(0.0, 0.5, 30.0)),
                         [](const testing::TestParamInfo<ThreadsInSpace::ParamType>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::to_string(static_cast<int>(std::get<1>(info.param) * 10));
                         });

}  // namespace
}  // namespace signum
