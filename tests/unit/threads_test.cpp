// Eight threads at once, each with predicates and constructions of its own, and all with one that
// they read: every one arrives at what a single thread arrives at. Under the thread sanitizer
// (scripts/sanitize_threads.sh) nobody touches what another one writes.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <latch>
#include <thread>
#include <vector>

#include "../../exact/sign_of_sum.hpp"
#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/formulas/facets.hpp"
#include "../../predicates/supremum.hpp"
#include "constructions.hpp"

namespace signum {
namespace {

constexpr std::size_t threads = 8;

/// What each of the threads has for a result, all beginning at once.
std::array<std::uint64_t, threads> at_once(const std::function<std::uint64_t()>& job) {
    std::array<std::uint64_t, threads> results{};
    std::latch begin(threads);
    std::vector<std::jthread> crew;
    for (std::uint64_t& result : results)
        crew.emplace_back([&] {
            begin.arrive_and_wait();
            result = job();
        });
    crew.clear();
    return results;
}

void expect_same(const char* name, const std::function<std::uint64_t()>& job) {
    // The threads first: whatever is made ready at the first call is made ready by them.
    const auto results = at_once(job);
    const std::uint64_t alone = job();
    for (const std::uint64_t result : results) EXPECT_EQ(result, alone) << name;
}

TEST(Threads, BuildWhatOneThreadBuilds) {
    for (const constructions::Construction& each : constructions::all) {
        const std::vector<Site> sites = constructions::sites_near_ties(each.few);
        expect_same(each.name, [&] { return each.run(sites); });
    }
}

/// Of all tuples of a few sites.
template <class S, class Ask>
std::uint64_t asked(const std::vector<S>& sites, const Ask& ask) {
    constructions::Digest digest;
    for (std::size_t i = 0; i + 4 < sites.size(); ++i)
        ask([&](std::size_t k) -> const S& { return sites[i + k]; },
            [&](std::int64_t answer) { digest.add(answer); });
    return digest.value();
}

template <class S>
std::uint64_t ask_power(const std::vector<S>& sites) {
    return asked(sites, [](const auto& s, const auto& add) {
        const Decision turn = ccw_decision(s(0), s(1), s(2));
        add(turn.sign);
        if (turn.sign > 0) add(power::in_circle(s(0), s(1), s(2), s(3)));
        if (turn.sign == 0 && power::centre(s(0)).x != power::centre(s(1)).x)
            add(power::in_circle_infinite(s(0), s(1), s(2)));
        add(power::nearer(power::centre(s(3)), s(0), s(1)));
        add(power::hidden(s(0), s(1)));
    });
}

template <class Perturbed>
std::uint64_t ask_additive(const std::vector<Site>& sites) {
    return asked(sites, [](const auto& s, const auto& add) {
        const auto ranks = additive::ranks_of<4>({&s(0), &s(1), &s(2), &s(3)});
        const std::array first = {ranks[0], ranks[1], ranks[2]};
        const bool exists = Perturbed::exists(s(0), s(1), s(2), first).sign > 0;
        add(exists);
        if (exists) add(Perturbed::in_circle(s(0), s(1), s(2), s(3), ranks).sign);
        add(Perturbed::exists_twice(s(0), s(1), s(2), first).sign);
        const bool apart = Perturbed::hides(s(0), s(1), {ranks[0], ranks[1]}).sign < 0 &&
                           Perturbed::hides(s(1), s(0), {ranks[1], ranks[0]}).sign < 0;
        if (apart) add(Perturbed::in_circle_infinite(s(0), s(1), s(2), first).sign);
        add(Perturbed::nearer({s(2).x, s(2).y}, s(0), s(1), {ranks[0], ranks[1]}).sign);
    });
}

template <class S>
std::uint64_t ask_power_of_space(const std::vector<S>& sites) {
    return asked(sites, [](const auto& s, const auto& add) {
        const Sign turn = ccw(s(0), s(1), s(2), s(3));
        add(turn);
        if (turn > 0) add(power::in_sphere(s(0), s(1), s(2), s(3), s(4)));
        add(power::nearer_decision({s(4).x, s(4).y, s(4).z}, s(0), s(1)).sign);
    });
}
template <class Shape>
std::uint64_t ask_facets(const std::vector<Site3>& sites) {
    return asked(sites, [](const auto& s, const auto& add) {
        const auto spheres = rectangular::spheres<Shape>(s(0), s(1), s(2), s(3));
        add(spheres.infinitely_many ? -1 : spheres.count);
        if (!spheres.infinitely_many)
            for (std::uint8_t n = 0; n < spheres.count; ++n)
                add(rectangular::in_sphere<Shape>(s(0), s(1), s(2), s(3), s(4), n));
        add(rectangular::hides_decision<Shape>(s(0), s(1)).sign);
    });
}
std::uint64_t ask_balls(const std::vector<Site3>& sites) {
    return asked(sites, [](const auto& s, const auto& add) {
        const bool exists = euclidean::exists(s(0), s(1), s(2), s(3));
        add(exists);
        if (exists) add(euclidean::in_sphere(s(0), s(1), s(2), s(3), s(4)));
        add(euclidean::hidden(s(0), s(1)));
    });
}

TEST(Threads, AskWhatOneThreadAsks) {
    const std::vector<Site> sites = constructions::sites_near_ties(400);
    const std::vector<Site3> balls = constructions::sites_in_space(sites);
    std::vector<Point> points;
    std::vector<power::Site> weights;
    for (const Site& s : sites) {
        points.push_back({s.x, s.y});
        weights.push_back({s.x, s.y, s.r});
    }
    std::vector<Point3> points3;
    for (const Site3& s : balls) points3.push_back({s.x, s.y, s.z});
    expect_same("points", [&] { return ask_power(points); });
    expect_same("weights", [&] { return ask_power(weights); });
    expect_same("circles", [&] { return ask_power(sites); });
    expect_same("Euclidean", [&] { return ask_additive<euclidean::Perturbed<>>(sites); });
    expect_same("Manhattan", [&] { return ask_additive<manhattan::Perturbed<>>(sites); });
    expect_same("supremum", [&] { return ask_additive<supremum::Perturbed<>>(sites); });
    expect_same("points of space", [&] { return ask_power_of_space(points3); });
    expect_same("balls' powers", [&] { return ask_power_of_space(balls); });
    expect_same("balls", [&] { return ask_balls(balls); });
    expect_same("cubes", [&] { return ask_facets<rectangular::Cube>(balls); });
    expect_same("octahedra", [&] { return ask_facets<rectangular::Octahedron>(balls); });
    expect_same("sums", [&] {
        std::vector<double> terms;
        for (const Site& s : sites) terms.insert(terms.end(), {s.x, s.y, -s.x, -s.y});
        return static_cast<std::uint64_t>(sign_of_sum(terms));
    });
}

/// One object that all of them read, and none writes.
TEST(Threads, ReadOneObject) {
    const std::vector<Site> sites = constructions::sites_near_ties(200);
    for (const Metric metric : all_metrics) {
        const Voronoi diagram = voronoi(triangulate(sites, metric));
        DynamicTessellation dynamic(metric);
        for (const Site& s : sites) dynamic.insert(s);
        const ClippedVoronoi clipped(diagram, default_box(sites));
        expect_same("one object", [&] {
            constructions::Digest digest;
            const Tessellation& tessellation = diagram.tessellation();
            constructions::require(validate(tessellation));
            for (const Site& s : sites) {
                digest.add(std::int64_t{tessellation.nearest({s.x + 0.25, s.y})});
                digest.add(std::int64_t{tessellation.locate({s.x + 0.25, s.y})});
            }
            digest.add(measure(clipped.cell(0)).area);
            digest.add_all(dynamic.tessellation().faces());
            return digest.value();
        });
    }
    std::vector<MovingSite> moving;
    for (const Site& s : sites) moving.push_back({s.x, s.y, s.y, -s.x, s.r});
    const KineticTessellation kinetic(moving);
    expect_same("kinetic", [&] {
        constructions::Digest digest;
        digest.add(kinetic.next_event().value_or(-1.0));
        digest.add_all(kinetic.faces());
        digest.add_all(kinetic.tessellation().faces());
        return digest.value();
    });
}

}  // namespace
}  // namespace signum
