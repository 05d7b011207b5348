/// What is built, asked or simulated does not depend on the floating-point environment that the
/// caller has set, nor on one that what it gave to be called sets on the way.

#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "../../bindings/c/signum.h"
#include "../../motion/simulation.hpp"
#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/compare.hpp"
#include "../../voronoi/contacts.hpp"
#include "../../voronoi/polygon.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "../thoroughness.hpp"

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
        const std::vector<Site3> sites = denormal_sites(
            5 + seed % 4, 3 + static_cast<int>(seed % 3), 1 + static_cast<int>(seed % 3), seed);
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

/// Numbers to be compared bit by bit.
class Bits {
 public:
    void add(double number) { all_.push_back(std::bit_cast<std::uint64_t>(number)); }
    void add(Point p) {
        add(p.x);
        add(p.y);
    }
    void add(const Conic& conic) {
        for (const Point p : {conic.from, conic.control, conic.to}) add(p);
        add(conic.weight);
    }
    void add(const std::vector<Conic>& conics) {
        for (const Conic& conic : conics) add(conic);
    }
    void add(const Box& box) {
        for (const double side : {box.x0, box.y0, box.x1, box.y1}) add(side);
    }
    friend bool operator==(const Bits&, const Bits&) = default;

 private:
    std::vector<std::uint64_t> all_;
};

/// All that is told of a diagram and of its cells in a box.
Bits told_of(const Tessellation& tessellation, const Box& given, double tolerance) {
    Bits bits;
    const Voronoi diagram(tessellation, {.merge = true});
    const auto sites = tessellation.sites();
    for (const DiagramVertex& vertex : diagram.vertices())
        for (const double number : {vertex.x, vertex.y, vertex.rho}) bits.add(number);
    bits.add(diagram.exponent());
    for (Index e = 0; e < static_cast<Index>(diagram.edges().size()); ++e) {
        const auto edge = diagram.geometry(e);
        if (!edge) continue;
        for (const double number : {edge->from, edge->to}) bits.add(number);
        bits.add(edge->start);
        bits.add(edge->end);
        std::visit(
            [&](const auto& curve) {
                bits.add(curve.at(0.7));
                bits.add(curve.parameter({0.3, 0.1}));
                bits.add(curve.beyond(0.7));
            },
            edge->curve);
        if (std::isfinite(edge->from) && std::isfinite(edge->to))
            bits.add(stretch(edge->curve, edge->from, edge->start, edge->to, edge->end));
    }
    bits.add(default_box(sites, diagram.exponent()));
    for (const Box& box : {given, default_box(sites, diagram.exponent())}) {
        bits.add(fits(box, diagram) ? 1.0 : 0.0);
        if (!fits(box, diagram)) continue;
        const ClippedVoronoi clipped(diagram, box);
        for (Index e = 0; e < static_cast<Index>(diagram.edges().size()); ++e)
            bits.add(clipped.edge(e));
        for (Index i = 0; i < static_cast<Index>(sites.size()); ++i) {
            const CellShape shape = clipped.cell(i);
            for (const auto& loop : shape.loops) bits.add(loop);
            const Measure of = measure(shape);
            bits.add(of.area);
            bits.add(of.perimeter);
            bits.add(of.centroid);
            for (const auto& polygon : polygons(shape, tolerance))
                for (const Point p : polygon) bits.add(p);
        }
    }
    return bits;
}

TEST(AnyEnvironment, DiagramsAndCells) {
    std::mt19937_64 random(11);
    const auto below = [&](int end) {
        return static_cast<double>(random() % static_cast<std::uint64_t>(end));
    };
    for (int round = 0; round < 24; ++round) {
        // Denormal, usual, and both at once.
        const double unit = round % 3 == 0 ? u : 0x1.3p-4;
        std::vector<Site> sites;
        for (int i = 0; i < 3 + round % 5; ++i)
            sites.push_back({below(9) * unit, below(9) * unit, below(4) * unit});
        if (round % 3 == 1) sites.push_back({u, 0, 0});
        const Box box = {-2 * unit, 1 * unit, 6 * unit, (5 + round % 2) * unit};
        for (const Metric metric : all_metrics) {
            SCOPED_TRACE(std::string(name_of(metric)) + ", round " + std::to_string(round));
            const Tessellation tessellation = triangulate(sites, metric);
            expect_same_in_all([&] { return told_of(tessellation, box, unit); });
        }
    }
}

TEST(AnyEnvironment, BoxesOfDenormalSizeHaveCells) {
    const std::vector<Site> sites = {{0, 0, 0}, {8 * u, 0, 0}, {0, 8 * u, 0}};
    const Tessellation tessellation = triangulate(sites, Power{});
    const auto area_in_box = [&] {
        const Voronoi diagram(tessellation);
        const ClippedVoronoi clipped(diagram, {-u, -u, 3 * u, 5 * u});
        return clipped.cell(0).loops.size();
    };
    EXPECT_EQ(area_in_box(), 1U);
    expect_same_in_all(area_in_box);
}

TEST(AnyEnvironment, ArcsAndTheirParts) {
    const Conic arc = {{0.1, 0.2}, {0.7, 0.3}, {1.1, 0.9}, 1.7};
    const Conic denormal = Conic::straight({u, u}, {6 * u, 4 * u});
    expect_same_in_all([&] {
        Bits bits;
        for (const Conic& conic : {arc, denormal}) {
            bits.add(conic.at(0.3));
            bits.add(conic.part(0.1, 0.7));
            bits.add(conic.halves().first);
            bits.add(conic.halves().second);
            for (const double number :
                 {conic.bulge(), conic.distance_from_parabola(), conic.length()})
                bits.add(number);
            const Conic::Moments moments = conic.moments({0.3, 0.1});
            for (const double number : {moments.area, moments.x, moments.y}) bits.add(number);
            for (const Inside& inside : parts_inside(conic, {2 * u, 2 * u, 0.6, 0.7})) {
                bits.add(inside.first);
                bits.add(inside.last);
            }
            std::vector<Point> points;
            sample(conic, 1e-3, points);
            for (const Point p : points) bits.add(p);
            bits.add(parabolas(conic, 1e-3));
            bits.add(Conic::straight(conic.from, conic.to));
        }
        return bits;
    });
}

TEST(AnyEnvironment, SitesThatAreCompared) {
    const auto of = [](double least) {
        return triangulate(std::vector<Site>{{0, 0, 0}, {1, 0, 0}, {least, 1, 0}}, Power{});
    };
    const Tessellation one = of(u);
    const Tessellation other = of(2 * u);
    expect_same_in_all([&] {
        try {
            static_cast<void>(compare_edges(one, other));
        } catch (const std::invalid_argument&) {
            return true;
        }
        return false;
    });
}

TEST(AnyEnvironment, CellsOfSpace) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        std::vector<Site3> sites = denormal_sites(6 + seed % 4, 5, 5, seed);
        if (seed % 2 == 1)
            for (Site3& s : sites) s = {s.x / u * 0.3, s.y / u * 0.3, s.z / u * 0.3, 0.1};
        // Of denormal lengths the squares are none.
        std::vector<power::Site3> weighted;
        for (const Site3& s : sites)
            weighted.push_back({s.x, s.y, s.z, seed % 2 == 1 ? 0.1 * s.x : 0.0});
        const SpaceTessellation tessellation = triangulate(sites, Power{});
        const SpaceTessellation of_weights = triangulate(weighted, Power{});
        std::vector<Index> all(sites.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
        const double side = seed % 2 == 1 ? 0.7 : 3 * u;
        const Box3 box = {{-side, -side, -side}, {side, side, side}};
        expect_same_in_all([&] { return default_box(std::span<const Site3>(sites)); });
        expect_same_in_all([&] { return default_box(std::span<const power::Site3>(weighted)); });
        for (const Box3& of : {box, default_box(std::span<const Site3>(sites))}) {
            expect_same_in_all([&] { return space_cells(tessellation, sites, of); });
            expect_same_in_all([&] { return space_cells(of_weights, weighted, of); });
            expect_same_in_all([&] { return space_polyhedra(tessellation, sites, of, all); });
            expect_same_in_all([&] { return space_polyhedra(of_weights, weighted, of, all); });
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
    for (int environment = 1; environment < environments; environment += is_sanitized ? 6 : 3) {
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

/// Answers and refusals one after the other, doubles by their bits: nothing is computed here.
class Answers {
 public:
    void tell(double number) { all_.push_back(std::bit_cast<std::uint64_t>(number)); }
    void tell(std::int64_t number) { all_.push_back(static_cast<std::uint64_t>(number)); }
    void tell(std::span<const Face> faces) {
        for (const Face& face : faces)
            for (const Index v : face) tell(std::int64_t{v});
    }
    void tell(const std::optional<double>& number) {
        tell(static_cast<std::int64_t>(number.has_value()));
        if (number) tell(*number);
    }
    /// Whether it is done or refused.
    template <class Call>
    void ask(const Call& call) {
        std::int64_t refused = 0;
        try {
            call();
        } catch (const std::logic_error&) {
            refused = 1;
        }
        tell(refused);
    }
    /// What a function of the C interface says; `result` as it leaves it.
    void ask_c(signum_status status, double result = 0.0) {
        tell(std::int64_t{status});
        tell(result);
    }

    friend bool operator==(const Answers&, const Answers&) = default;

 private:
    std::vector<std::uint64_t> all_;
};

TEST(AnyEnvironment, TimesOfWhatMoves) {
    // Four corners, and one that leaves the square at the time 3u and comes back through the other
    // side; those of denormal places turn at 5u.
    constexpr double far = 8.0;
    const std::vector<MovingSite> sites = {{0, 0, 0, 0},      {far, 0, 0, 0},
                                           {far, far, 0, 0},  {0, far, 0, 0},
                                           {3, 3 * u, 0, -1}, {5, far - 5 * u, 0, 1}};
    const std::vector<MovingSite> tiny = {
        {0, 0, 0, 0}, {8 * u, 0, 0, 0}, {0, 8 * u, 0, 0}, {5 * u, 5 * u, -1, -1}};
    for (const std::vector<MovingSite>& all : {sites, tiny}) {
        const auto of_times = [&] {
            Answers answers;
            KineticTessellation moving(all, 2 * u);
            answers.tell(moving.next_event());
            const auto go = [&](double time) {
                answers.ask([&] { moving.advance(time); });
                answers.tell(moving.time());
                answers.tell(moving.next_event());
                answers.tell(moving.faces());
            };
            for (const double time :
                 {u, 2 * u, -u, 3 * u, 2 * u, -0.0, 4 * u, 3 * u, 5 * u, 5 * u, 4 * u, 1.0, 0.5})
                go(time);
            answers.ask([&] { static_cast<void>(moving.insert({u, 2 * u, u, 0, -u, u})); });
            answers.ask([&] { moving.change(1, {4.0, u, 0, 0, u, 0}); });
            answers.ask([&] { moving.erase(9); });
            answers.tell(moving.next_event());
            answers.tell(moving.faces());
            return answers;
        };
        expect_same_in_all(of_times);
    }
    KineticTessellation moving(sites, 2 * u);
    const auto refuses = [&](double time) {
        enter(4);
        bool refused = false;
        try {
            moving.advance(time);
        } catch (const std::invalid_argument&) {
            refused = true;
        }
        leave();
        return refused;
    };
    EXPECT_TRUE(refuses(u));
    EXPECT_FALSE(refuses(3 * u));
    EXPECT_TRUE(refuses(0.0));
    EXPECT_EQ(moving.time(), 3 * u);
}

TEST(AnyEnvironment, SitesThatChange) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        std::vector<Site> sites;
        for (const Site3& s : denormal_sites(9, 5, 5, seed)) sites.push_back({s.x, s.y, s.z});
        std::vector<Point> centres;
        for (const Site3& s : denormal_sites(8, 5, 5, seed + 100)) centres.push_back({s.x, s.y});
        for (const Metric metric : all_metrics)
            expect_same_in_all([&] {
                Answers answers;
                DynamicTessellation live(metric);
                for (const Site& site : sites) answers.tell(std::int64_t{live.insert(site)});
                const auto look = [&] {
                    const Tessellation tessellation = live.tessellation();
                    answers.tell(tessellation.faces());
                    for (const auto& [site, by] : tessellation.hidden())
                        answers.tell(std::int64_t{by});
                };
                look();
                live.change(1, 2 * u);
                live.move(2, {3 * u, -u});
                live.erase(3);
                look();
                live.move_all(centres);
                look();
                answers.ask([&] { live.move(3, {u, u}); });
                answers.ask([&] { live.change(4, u / 0.0); });
                return answers;
            });
    }
}

TEST(AnyEnvironment, WhatTheInterfaceOfCRefuses) {
    const signum_ball still = {{-3, 0, 0}, {0, 0, 0}, 1, 0, 1};
    signum_ball negative = {{3, 0, 0}, {-1, 0, 0}, -u, 0, 1};
    signum_ball light = {{3, 0, 0}, {-1, 0, 0}, 1, 0, u};
    const double site[] = {u, 2 * u, u};
    const double box[] = {0.0, 0.0, u, u};
    const signum_moving_site moving[] = {
        {0, 0, 0, 0, 0, 0}, {8, 0, 0, 0, 0, 0}, {0, 8, 0, 0, 0, 0}, {1, u, 0, -1, 0, 0}};
    const auto of_c = [&] {
        Answers answers;
        double result = 7.0;
        signum_effects effects = SIGNUM_EFFECTS(2);
        answers.ask_c(signum_meeting_time(&still, &negative, &effects, HUGE_VAL, &result, nullptr),
                      result);
        answers.ask_c(signum_meeting_time(&still, &light, &effects, HUGE_VAL, &result, nullptr),
                      result);
        effects.growth_rate = -u;  // refused; and not none
        answers.ask_c(signum_meeting_time(&still, &light, &effects, HUGE_VAL, &result, nullptr),
                      result);
        effects.growth_rate = 0.0;
        effects.restitution = -u;
        answers.ask_c(signum_meeting_time(&still, &light, &effects, HUGE_VAL, &result, nullptr),
                      result);
        effects.restitution = 1.0;
        effects.box = SIGNUM_WALLS;
        effects.low[0] = effects.low[1] = -6;
        effects.high[0] = effects.high[1] = 6;
        for (const signum_ball& other : {negative, light}) {
            const signum_ball balls[] = {still, other};
            signum_simulation* simulation = nullptr;
            answers.ask_c(signum_simulation_create(balls, 2, &effects, &simulation, nullptr));
            if (simulation == nullptr) continue;
            std::int32_t found = -1;
            signum_strike strike{};
            answers.ask_c(
                signum_simulation_next_strike(simulation, 0.0, u, &found, &strike, nullptr),
                strike.time);
            answers.ask_c(
                signum_simulation_next_strike(simulation, 2 * u, u, &found, &strike, nullptr),
                strike.time);
            signum_limits limits = SIGNUM_LIMITS;
            limits.until = 3 * u;
            answers.ask_c(signum_simulation_run(simulation, &limits, nullptr, nullptr, nullptr));
            answers.ask_c(signum_simulation_time(simulation, &result, nullptr), result);
            limits.until = u;
            answers.ask_c(signum_simulation_run(simulation, &limits, nullptr, nullptr, nullptr));
            answers.ask_c(signum_simulation_time(simulation, &result, nullptr), result);
            signum_simulation_free(simulation);
        }

        signum_kinetic* kinetic = nullptr;
        answers.ask_c(signum_kinetic_create(moving, 4, 2 * u, nullptr, &kinetic, nullptr));
        for (const double time : {u, 2 * u, 3 * u, 2 * u, 0.0}) {
            answers.ask_c(signum_kinetic_advance(kinetic, time, nullptr));
            answers.ask_c(signum_kinetic_time(kinetic, &result, nullptr), result);
            answers.ask_c(signum_kinetic_next_event(kinetic, &result, nullptr), result);
        }
        signum_kinetic_free(kinetic);

        signum_tessellation* tessellation = nullptr;
        signum_voronoi* voronoi = nullptr;
        const double sites[] = {0, 0, 2 * u, 0, 0, 2 * u, 3 * u, 3 * u};
        answers.ask_c(
            signum_triangulate(sites, 4, 2, SIGNUM_EUCLIDEAN, nullptr, &tessellation, nullptr));
        std::int32_t near = -1;
        answers.ask_c(signum_tessellation_nearest(tessellation, site, &near, nullptr));
        answers.tell(std::int64_t{near});
        answers.ask_c(signum_tessellation_locate(tessellation, site, &near, nullptr));
        answers.tell(std::int64_t{near});
        double areas[4] = {7, 7, 7, 7};
        answers.ask_c(signum_voronoi_create(tessellation, 1, &voronoi, nullptr));
        answers.ask_c(signum_voronoi_areas(voronoi, box, areas, 4, nullptr), areas[0]);
        signum_voronoi_free(voronoi);
        signum_tessellation_free(tessellation);
        return answers;
    };
    expect_same_in_all(of_c);
    enter(4);
    double time = 7.0;
    signum_effects effects = SIGNUM_EFFECTS(2);
    const signum_status status =
        signum_meeting_time(&still, &negative, &effects, HUGE_VAL, &time, nullptr);
    leave();
    EXPECT_EQ(status, SIGNUM_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace signum
