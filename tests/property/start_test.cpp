/// Every sentence with which start() refuses effects or balls, once each; and what is just allowed.

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/simulation.hpp"

namespace signum::motion {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double huge = 0x1p151;

struct Case {
    std::string begin;  ///< of the sentence
    std::function<void(Effects<2>&, Body<2>&)> change;
};

/// What is said of a ball in the middle of a box whose effects or numbers are changed.
std::string sentence(const std::function<void(Effects<2>&, Body<2>&)>& change, bool& of_a_ball) {
    Effects<2> effects;
    effects.box = Box<2>{{-4.0, -4.0}, {4.0, 4.0}};
    effects.time_step = 0.125;
    Body<2> body{{0.0, 0.0}, {1.0, 0.5}, 0.5, 1.0};
    change(effects, body);
    of_a_ball = false;
    try {
        (void)start<2>(std::vector<Body<2>>{{{-2.0, -2.0}, {}, 0.5, 1.0}, body}, effects);
    } catch (const BallError& error) {
        of_a_ball = true;
        EXPECT_EQ(error.ball(), 1);
        return error.what();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

void expect_sentences(const std::vector<Case>& cases, bool of_balls) {
    for (const Case& each : cases) {
        bool of_a_ball = false;
        const std::string said = sentence(each.change, of_a_ball);
        EXPECT_EQ(said.substr(0, each.begin.size()), each.begin) << said;
        EXPECT_EQ(of_a_ball, of_balls) << said;
    }
}

TEST(Start, RefusesEffectsThatMakeNoSense) {
    using E = Effects<2>;
    using B = Body<2>;
    const auto obstacle = [](const Obstacle<2>& wall) {
        return [wall](E& e, B&) { e.obstacles.push_back(wall); };
    };
    expect_sentences(
        {{"gravity:", [](E& e, B&) { e.gravity[1] = huge; }},
         {"gravity:", [](E& e, B&) { e.gravity[0] = nan; }},
         {"restitution:", [](E& e, B&) { e.restitution = 1.5; }},
         {"restitution:", [](E& e, B&) { e.restitution = nan; }},
         {"wall_restitution:", [](E& e, B&) { e.wall_restitution = -0.1; }},
         {"a periodic world needs a box",
          [](E& e, B&) {
              e.box.reset();
              e.periodic = true;
          }},
         {"box:", [](E& e, B&) { e.box->high[0] = -4.0; }},
         {"box.low:", [](E& e, B&) { e.box->low[1] = -huge; }},
         {"speed_law.speed: give a number above 0",
          [](E& e, B&) {
              e.speed_law = SpeedLaw{0.0, 0.2};
          }},
         {"speed_law.power: give a number above 0, at most 8",
          [](E& e, B&) {
              e.speed_law = SpeedLaw{1.0, 0.0};
          }},
         {"speed_law.power: give a number above 0, at most 8",
          [](E& e, B&) {
              e.speed_law = SpeedLaw{1.0, 9.0};
          }},
         {"speed_law.speed:",
          [](E& e, B&) {
              e.speed_law = SpeedLaw{nan, 0.2};
          }},
         {"contact_duration:", [](E& e, B&) { e.contact_duration = -1.0; }},
         {"contact_duration:", [](E& e, B&) { e.contact_duration = huge; }},
         {"friction.coefficient: give 0 or more", [](E& e, B&) { e.friction = Friction{-0.5}; }},
         {"friction.wall_coefficient: give 0 or more",
          [](E& e, B&) {
              e.friction = Friction{0.5, nan};
          }},
         {"friction.tangential_restitution: give a number from -1 to 1",
          [](E& e, B&) {
              e.friction = Friction{0, 0, 1.5};
          }},
         {"friction.tangential_restitution: give a number from -1 to 1",
          [](E& e, B&) {
              e.friction = Friction{0, 0, nan};
          }},
         {"friction.inertia: give a number above 0, at most 1",
          [](E& e, B&) {
              e.friction = Friction{0, 0, 0, 0.0};
          }},
         {"friction.inertia: give a number above 0, at most 1",
          [](E& e, B&) {
              e.friction = Friction{0, 0, 0, 1.5};
          }},
         {"friction.inertia: give 0 or a number of 2^-150 to 2^150",
          [](E& e, B&) {
              e.friction = Friction{0, 0, 0, 1e-300};
          }},
         {"a box that shakes needs walls",
          [](E& e, B&) {
              e.box.reset();
              e.shake.emplace();
          }},
         {"a box that shakes needs walls",
          [](E& e, B&) {
              e.periodic = true;
              e.shake.emplace();
          }},
         {"shake.amplitude:",
          [](E& e, B&) {
              e.shake = Shake<2>{{0.0, huge}, 1.0, 0.0};
          }},
         {"shake.frequency:",
          [](E& e, B&) {
              e.shake = Shake<2>{{0.0, 1.0}, nan, 0.0};
          }},
         {"shake.phase:",
          [](E& e, B&) {
              e.shake = Shake<2>{{0.0, 1.0}, 1.0, 1e-300};
          }},
         {"half-space: give a normal", obstacle(HalfSpace<2>{})},
         {"half-space.normal: give a finite", obstacle(HalfSpace<2>{{1.0, nan}})},
         {"half-space.offset:", obstacle(HalfSpace<2>{{1.0, 0.0}, -huge})},
         {"half-space.speed:", obstacle(HalfSpace<2>{{1.0, 0.0}, -9.0, 1e-300})},
         {"sphere.radius: give 0 or more",
          obstacle(Sphere<2>{.centre = {9.0, 9.0}, .radius = -1.0})},
         {"sphere.centre:", obstacle(Sphere<2>{.centre = {9.0, nan}, .radius = 1.0})},
         {"sphere.velocity:", obstacle(Sphere<2>{.centre = {9.0, 9.0}, .velocity = {0.0, huge}})},
         {"segment.to:", obstacle(Segment{{9.0, 9.0}, {9.0, huge}})},
         {"segment: its two ends", obstacle(Segment{{9.0, 9.0}, {9.0, 9.0}})},
         {"more than 100000 obstacles",
          [](E& e, B&) {
              e.obstacles.assign(100'001, HalfSpace<2>{{1.0, 0.0}, -9.0});
          }},
         {"obstacles are for a world that is not periodic",
          [](E& e, B&) {
              e.periodic = true;
              e.obstacles.emplace_back(HalfSpace<2>{{1.0, 0.0}, -9.0});
          }},
         {"growth.rate:",
          [](E& e, B&) {
              e.growth = Growth{0.0, 1.0};
          }},
         {"growth.until:",
          [](E& e, B&) {
              e.growth = Growth{1.0, 0.0};
          }},
         {"growth.until:",
          [](E& e, B&) {
              e.growth = Growth{1.0, INFINITY};
          }},
         {"growth and contacts",
          [](E& e, B&) {
              e.growth = Growth{1.0, 1.0};
              e.contacts = LastingContacts{1.0};
          }},
         {"fluid.velocity:",
          [](E& e, B&) {
              e.fluid = Fluid<2>{{nan, 0.0}};
          }},
         {"fluid.gradient:",
          [](E& e, B&) {
              e.fluid = Fluid<2>{{}, {{{huge, 0.0}, {}}}};
          }},
         {"fluid.linear: give 0 or more",
          [](E& e, B&) {
              e.fluid = Fluid<2>{{}, {}, -1.0};
          }},
         {"fluid.quadratic: give 0 or more",
          [](E& e, B&) {
              e.fluid = Fluid<2>{{}, {}, 0.0, nan};
          }},
         {"time_step:", [](E& e, B&) { e.time_step = -0.125; }},
         {"time_step:", [](E& e, B&) { e.time_step = INFINITY; }},
         {"fluid: what a fluid does is computed in steps of time",
          [](E& e, B&) {
              e.fluid.emplace();
              e.time_step = 0.0;
          }},
         {"contacts: contact that lasts is computed in steps of time",
          [](E& e, B&) {
              e.contacts = LastingContacts{1.0};
              e.time_step = 0.0;
          }},
         {"contacts that stand in a box that shakes",
          [](E& e, B&) {
              e.contacts = LastingContacts{1.0};
              e.shake = Shake<2>{{0.0, 0.125}, 8.5, 0.0};
          }},
         {"growth: in the end",
          [](E& e, B&) {
              e.growth = Growth{3.0, 2.0};
          }},
         {"contacts.speed: give a number above 0",
          [](E& e, B&) { e.contacts = LastingContacts{0.0}; }},
         {"contacts.tolerance: give a number above 0, below 1",
          [](E& e, B&) {
              e.contacts = LastingContacts{1.0, 1.0};
          }},
         {"contacts.sweeps: give 2 or more",
          [](E& e, B&) {
              e.contacts = LastingContacts{1.0, 0.5, 0};
          }}},
        false);
}

TEST(Start, RefusesBallsThatCannotBe) {
    using E = Effects<2>;
    using B = Body<2>;
    const auto obstacle = [](const Obstacle<2>& wall) {
        return [wall](E& e, B&) { e.obstacles.push_back(wall); };
    };
    constexpr auto inside = Sphere<2>::Side::inside;
    expect_sentences(
        {{"a coordinate or speed", [](E&, B& b) { b.x[0] = nan; }},
         {"a coordinate or speed", [](E&, B& b) { b.v[1] = huge; }},
         {"a spin", [](E&, B& b) { b.spin[0] = INFINITY; }},
         {"a radius", [](E&, B& b) { b.radius = -0.5; }},
         {"a radius", [](E&, B& b) { b.radius = nan; }},
         {"a mass that is not positive", [](E&, B& b) { b.mass = 0.0; }},
         {"a mass that is not positive", [](E&, B& b) { b.mass = nan; }},
         {"a mass beyond", [](E&, B& b) { b.mass = huge; }},
         {"a ball outside its walls", [](E&, B& b) { b.x[0] = std::nextafter(3.5, 4.0); }},
         {"a ball outside its walls",
          [](E& e, B& b) {
              e.shake = Shake<2>{{0.0, 1.0}, 1.0, 1.5};
              b.x[1] = -3.5;
          }},
         {"a centre outside the periodic box",
          [](E& e, B& b) {
              e.periodic = true;
              b.x[0] = 4.125;
          }},
         {"a ball whose diameter is more than a quarter",
          [](E& e, B& b) {
              e.periodic = true;
              b.radius = std::nextafter(1.0, 2.0);
          }},
         {"a ball whose diameter is more than a quarter",
          [](E& e, B& b) {
              e.periodic = true;
              e.growth = Growth{0.5, 1.5};
              b.radius = 0.75;
          }},
         {"a ball that is wider than its walls",
          [](E& e, B& b) {
              e.growth = Growth{2.5, 2.0};
              b.radius = 0.75;
          }},
         {"a ball that overlaps ball 0",
          [](E&, B& b) {
              b.x = {-1.5, -1.5};
          }},
         {"a ball that overlaps wall 4", obstacle(HalfSpace<2>{{0.0, -2.0}, -0.75})},
         {"a ball that overlaps wall 4", obstacle(Sphere<2>{.centre = {1.0, 0.0}, .radius = 0.75})},
         {"a ball that overlaps wall 4",
          obstacle(Sphere<2>{.centre = {-3.0, -3.0}, .radius = 4.5, .side = inside})},
         {"a ball that overlaps wall 4", obstacle(Segment{{-0.5, 0.25}, {1.0, 0.25}})},
         {"a ball that overlaps wall 4", obstacle(Segment{{0.25, 0.25}, {1.0, 0.25}})},
         {"a ball of radius 0 where there are segments",
          [](E& e, B& b) {
              e.obstacles.emplace_back(Segment{{3.0, 3.0}, {3.0, 2.0}});
              b.radius = 0.0;
          }}},
        true);
    // It may touch all that.
    const std::vector<std::function<void(E&, B&)>> allowed = {
        [](E&, B& b) { b.x[0] = 3.5; },
        [](E&, B& b) {
            b.x = {-1.0, -2.0};
        },
        [](E& e, B& b) {
            e.periodic = true;
            b.radius = 1.0;
        },
        obstacle(HalfSpace<2>{{0.0, -2.0}, -1.0}),
        obstacle(Sphere<2>{.centre = {1.0, 0.0}, .radius = 0.5}),
        obstacle(Sphere<2>{.centre = {-1.0, -1.0}, .radius = 4.0, .side = inside}),
        obstacle(Segment{{-0.5, 0.5}, {1.0, 0.5}}),
        [](E& e, B& b) {
            e.obstacles.emplace_back(Segment{{0.375, 0.5}, {1.0, 1.0}});
            b.radius = 0.625;
        }};
    for (const auto& change : allowed) {
        bool of_a_ball = false;
        EXPECT_EQ(sentence(change, of_a_ball), "");
    }
}

/// Whole numbers, so that doubles tell who overlaps; points too, which do so within a disc alone.
TEST(Start, NamesTheFirstBallThatOverlapsOneBeforeIt) {
    std::mt19937_64 random(29);
    const auto below = [&](std::uint64_t count) { return static_cast<double>(random() % count); };
    int refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<Body<2>> bodies;
        std::string expected;
        const std::uint64_t extent = trial % 4 == 0 ? 3 : 40;
        for (int i = 0; i < 20; ++i) {
            const Body<2> body{{below(extent), below(extent)}, {}, below(3), 1.0};
            for (std::size_t j = 0; j < bodies.size() && expected.empty(); ++j) {
                const double dx = body.x[0] - bodies[j].x[0];
                const double dy = body.x[1] - bodies[j].x[1];
                const double radii = body.radius + bodies[j].radius;
                if (dx * dx + dy * dy < radii * radii)
                    expected = std::to_string(i) + ": a ball that overlaps ball " +
                               std::to_string(j) + "; balls may touch";
            }
            bodies.push_back(body);
        }
        std::string said;
        try {
            (void)start<2>(bodies, {});
        } catch (const BallError& error) {
            said = std::to_string(error.ball()) + ": " + error.what();
            ++refused;
        }
        ASSERT_EQ(said, expected) << trial;
    }
    EXPECT_GT(refused, 100);
    EXPECT_LT(refused, 400);
}

/// Were all pairs asked, each of these would take a minute.
TEST(Start, TakesManyBallsInOnePlace) {
    std::vector<Body<2>> bodies(100'000, Body<2>{{1.0, 2.0}, {}, 0.0, 1.0});
    EXPECT_EQ(start<2>(bodies, {}).balls.size(), bodies.size());
    for (Body<2>& body : bodies) body.radius = 0.5;
    bodies[0].x[0] = 9.0;
    try {
        (void)start<2>(bodies, {});
        ADD_FAILURE();
    } catch (const BallError& error) {
        EXPECT_EQ(error.ball(), 2);
    }
}

TEST(Start, RefusesStatesThatCannotBe) {
    Effects<2> effects;
    effects.box = Box<2>{{-4.0, -4.0}, {4.0, 4.0}};
    effects.time_step = 0.125;
    effects.friction.emplace();
    effects.contact_duration = 0.5;
    effects.contacts = LastingContacts{0.1};
    const State<2> good = start<2>(
        std::vector<Body<2>>{{{0, 0}, {1, 0}, 0.5, 1}, {{2, 0}, {-1, 0}, 0.5, 1}}, effects);
    EXPECT_NO_THROW(check(good, effects));
    const std::vector<std::pair<std::string, std::function<void(State<2>&)>>> cases = {
        {"a state whose balls and masses differ", [](State<2>& s) { s.masses.pop_back(); }},
        {"a state whose balls and masses differ", [](State<2>& s) { s.in_place.push_back(0); }},
        {"a state that does not have what its effects", [](State<2>& s) { s.spins.clear(); }},
        {"a state that does not have what its effects",
         [](State<2>& s) { s.last_strikes.pop_back(); }},
        {"a state with pressed balls that", [](State<2>& s) { s.pressed = {{2}}; }},
        {"a state with pressed balls that", [](State<2>& s) { s.pressed = {{-1}}; }},
        {"a state with pressed balls that",
         [](State<2>& s) {
             s.pressed = {{0, 1, false, 0.0, 0.0, 0.0}, {0, 1, false, 0.0, 0.0, 0.0}};
         }},
        {"a state with pressed balls at",
         [](State<2>& s) {
             s.pressed = {{0, 1, false, nan, 0.0, 0.0}};
         }},
        {"a state with pressed balls at",
         [](State<2>& s) {
             s.pressed = {{0, 1, false, 0.0, 0.0, 1e300}};
         }},
        {"a state with pressed balls at", [](State<2>& s) { s.pressed = {{0}}; }},
        {"a state with contacts",
         [](State<2>& s) {
             s.contacts.push_back({0, 2});
         }},
        {"a state with contacts",
         [](State<2>& s) {
             s.contacts.push_back({-1, 0});
         }},
        {"a state with contacts",
         [](State<2>& s) {
             s.contacts.push_back({0, -5});
         }},
        {"a state with contacts",
         [](State<2>& s) {
             s.contacts.push_back({1, 0});
         }},
        {"a state whose time is not within", [](State<2>& s) { s.half_steps = 2; }},
        {"a state whose time is not within", [](State<2>& s) { s.time = 0.2; }},
        {"a state's time", [](State<2>& s) { s.time = -1.0; }},
        {"a state's time", [](State<2>& s) { s.time = nan; }},
        {"a coordinate or speed", [](State<2>& s) { s.balls[0].x[0] = nan; }},
        {"a coordinate or speed", [](State<2>& s) { s.balls[0].x[1] = 1e308; }},
        {"a coordinate or speed", [](State<2>& s) { s.balls[1].v[0] = -1e307; }},
        {"a state with a spin", [](State<2>& s) { s.spins[1][0] = 1e300; }},
        {"a state with a last strike", [](State<2>& s) { s.last_strikes[0] = nan; }},
        {"a state with a last strike", [](State<2>& s) { s.last_strikes[1] = 1.0; }},
        {"a state with contacts",
         [](State<2>& s) {
             s.contacts.push_back({0, 1, nan});
         }},
        {"a state with a meeting",
         [](State<2>& s) {
             s.passed.push_back({0, 1, nan});
         }},
        {"a ball that is wider than its walls", [](State<2>& s) { s.balls[0].radius = 4.5; }},
        {"a radius", [](State<2>& s) { s.balls[0].radius = -1.0; }},
        {"a mass", [](State<2>& s) { s.masses[1] = 0.0; }},
        {"a ball's own time", [](State<2>& s) { s.balls[0].time = 1.0; }}};
    for (const auto& [begin, change] : cases) {
        State<2> state = good;
        change(state);
        try {
            check(state, effects);
            ADD_FAILURE() << begin;
        } catch (const std::invalid_argument& error) {
            EXPECT_EQ(std::string(error.what()).substr(0, begin.size()), begin);
        }
    }
}

/// Which was built for a world without a box, or with growth, or segments.
TEST(Start, RefusesStatesForWhichTheWorldIsTooNarrow) {
    const std::vector<Body<2>> bodies = {{{0, 0}, {1, 0}, 0.5, 1}, {{2, 0}, {-1, 0}, 0.0, 1}};
    State<2> state = start<2>(bodies, {});
    Effects<2> effects;
    effects.box = Box<2>{{-2.0, -2.0}, {2.0, 2.0}};
    EXPECT_NO_THROW(check(state, effects));
    effects.periodic = true;
    EXPECT_NO_THROW(check(state, effects));
    state.balls[0].radius = 0.5 + 0x1p-53;  // as growth may round it
    EXPECT_NO_THROW(check(state, effects));
    state.balls[0].radius = 0.5625;
    EXPECT_THROW(check(state, effects), BallError);
    state.balls[0].radius = 0.5;
    effects.growth = Growth{0.5, 1.0};
    EXPECT_THROW(check(state, effects), BallError);
    state.time = 1.0;  // it has grown already
    EXPECT_NO_THROW(check(state, effects));
    state.time = 0x1p201;
    EXPECT_THROW(check(state, effects), std::invalid_argument);
    state.time = 1.0;
    Effects<2> segments;
    segments.obstacles.push_back(Segment{{9.0, 0.0}, {9.0, 1.0}});
    EXPECT_THROW(check(state, segments), BallError);
}

}  // namespace
}  // namespace signum::motion
