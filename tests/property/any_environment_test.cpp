/// What is built, asked or simulated does not depend on the floating-point environment that the
/// caller has set, nor on one that what it gave to be called sets on the way.

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../kinetic/kinetic_tessellation.hpp"
#include "../../motion/simulation.hpp"
#include "../../spatial/ball_diagram.hpp"
#include "../../spatial/triangulate.hpp"
#include "../../spatial/validate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/contacts.hpp"

#include "environments.hpp"

namespace signum {
namespace {

constexpr double u = 0x1p-1074;

/// Multiples of u from 0 to most - 1, in the planes x = 0 to x = layers - 1.
std::vector<Site3> denormal_sites(std::size_t count, int most, int layers, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](int end) {
        return static_cast<double>(random() % static_cast<std::uint64_t>(end)) * u;
    };
    std::vector<Site3> sites;
    for (std::size_t i = 0; i < count; ++i)
        sites.push_back({below(layers), below(most), below(most), 0.0});
    return sites;
}

std::vector<power::Site3> with_weights(const std::vector<Site3>& sites, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<power::Site3> weighted;
    for (const Site3& s : sites)
        weighted.push_back({s.x, s.y, s.z, static_cast<double>(random() % 3) * u});
    return weighted;
}

/// In each environment but the default one the same as there.
template <class Function>
void expect_same_in_all(const Function& function) {
    const auto expected = function();
    for (int environment = 1; environment < environments; ++environment)
        EXPECT_TRUE(within(environment, function) == expected) << name_of_environment(environment);
}

TEST(AnyEnvironment, TessellationsOfSpace) {
    const std::vector<Point3> flat = {{0, 0, 0}, {1e-310, 0, 0}, {0, 1e-310, 0}};
    expect_same_in_all([&] { return triangulate(flat, Power{}); });
    EXPECT_EQ(triangulate(flat, Power{}).dimension, 2);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const std::vector<Site3> sites =
            denormal_sites(5 + seed % 4, 3 + static_cast<int>(seed % 3), 1 + static_cast<int>(seed % 3), seed);
        expect_same_in_all([&] { return triangulate(sites, Power{}); });
        const std::vector<power::Site3> weighted = with_weights(sites, seed);
        expect_same_in_all([&] { return triangulate(weighted, Power{}); });
    }
}

TEST(AnyEnvironment, ContactsOfSites) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        std::vector<Site> sites;
        for (const Site3& s : denormal_sites(6, 4, 4, seed)) sites.push_back({s.x, s.y, s.z});
        if (seed % 2 == 0) sites.push_back({1.0, 0.5, 0.25});
        for (const Metric metric : all_metrics) {
            const Tessellation tessellation = triangulate(sites, metric);
            expect_same_in_all([&] {
                const Canonical canonical(tessellation);
                const Contacts touch = contacts_of(canonical);
                std::vector<int> all;
                for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
                    for (Index j = 0; j < i; ++j) all.push_back(touch(i, j));
                return all;
            });
        }
    }
}

/// Whom a construction tells how far it is.
std::function<void(double)> entering(int environment) {
    return [environment](double /*done*/) { enter(environment); };
}

TEST(AnyEnvironment, MayChangeWhileProgressIsTold) {
    // So many that progress is told on the way; most of them are where others are.
    const std::vector<Site3> sites = denormal_sites(4400, 6, 6, 7);
    const std::vector<power::Site3> weighted = with_weights(sites, 7);
    std::vector<Site> plane;
    for (const Site3& s : sites) plane.push_back({s.x, s.y, 0.0});
    const std::vector<Site3> few(sites.begin(), sites.begin() + 300);
    const SpaceTessellation in_space = triangulate(weighted, Power{});
    const Tessellation in_plane = triangulate(plane, Power{});
    const BallDiagram diagram = ball_diagram(few);
    for (int environment = 1; environment < environments; environment += 3) {
        SCOPED_TRACE(name_of_environment(environment));
        const Options options = {.progress = entering(environment)};
        EXPECT_TRUE(triangulate(weighted, Power{}, options) == in_space);
        EXPECT_EQ(triangulate(plane, Power{}, options).arrays(), in_plane.arrays());
        EXPECT_TRUE(ball_diagram(few, options).vertices == diagram.vertices);
        const ValidationOptions asked = {.progress = entering(environment)};
        EXPECT_EQ(validate(in_space, weighted, asked).message, "");
        EXPECT_EQ(validate(in_plane.arrays(), plane, asked).message, "");
        EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "the caller's own is there again";
    }
    leave();
}

/// The strikes of two balls, and how they fly then; each strike enters another environment.
template <class Told>
std::vector<double> numbers_of_a_run(const Told& told) {
    using namespace motion;
    const std::vector<Body<2>> bodies = {
        {.x = {0.0, 0.0}, .v = {0x1.8p+1, 0.0}, .radius = 1.0},
        {.x = {0x1.4p+3, 0x1p-1}, .v = {-0x1p+2, 0x1p-2}, .radius = 1.0, .mass = 0.3}};
    Effects<2> effects;
    effects.box = {{-3.0, -4.0}, {15.0, 4.0}};
    effects.restitution = 0.9;
    Simulation<2> simulation(start<2>(bodies, effects), effects);
    std::vector<double> numbers;
    simulation.run({.until = 9.0}, [&](const Strike& strike) {
        numbers.push_back(strike.time);
        told();
    });
    for (const Ball<2>& ball : simulation.state().balls)
        numbers.insert(numbers.end(), {ball.x[0], ball.x[1], ball.v[0], ball.v[1], ball.time});
    return numbers;
}

TEST(AnyEnvironment, LogsOfStrikes) {
    const std::vector<double> expected = numbers_of_a_run([] {});
    ASSERT_GT(expected.size(), 15U);
    EXPECT_EQ(expected[0], 0x1.2a8b2dfff08c4p+0);
    expect_same_in_all([] { return numbers_of_a_run([] {}); });
    for (int environment = 1; environment < environments; ++environment)
        EXPECT_EQ(numbers_of_a_run([&] { enter(environment); }), expected);
    leave();
}

TEST(AnyEnvironment, MayChangeWhileEdgesAreTold) {
    const auto edges_with = [](const std::function<void()>& told) {
        KineticTessellation moving;
        std::mt19937_64 random(3);
        const auto number = [&] { return static_cast<double>(random() % 1000) * 0x1.3p-7; };
        for (int i = 0; i < 40; ++i)
            static_cast<void>(
                moving.insert({number(), number(), number() - 4, number() - 4, 0, 0}));
        std::vector<Index> edges;
        moving.watch([&](Index a, Index b, bool comes) {
            edges.insert(edges.end(), {a, b, static_cast<Index>(comes)});
            told();
        });
        moving.advance(1.5);
        return edges;
    };
    const std::vector<Index> expected = edges_with([] {});
    for (int environment = 1; environment < environments; ++environment)
        EXPECT_EQ(edges_with([&] { enter(environment); }), expected);
    leave();
}

}  // namespace
}  // namespace signum
