/// What is drawn of a structure is true: it holds the pairs that strike, and the balls.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion_scenes.hpp"

namespace signum::motion {
namespace {

const std::uint64_t looks = is_fast ? 200 : 40;

/// A gas in the plane with two balls far larger than the others, and two between.
Scene<2> sizes(std::uint64_t seed) {
    Scene<2> scene = gas<2>(256, false, seed);
    scene.name = "several sizes";
    for (Body<2>& body : scene.bodies) body.radius = 0.2;
    const std::vector<Body<2>> large = {{{4.0, 4.0}, {0.5, 0.25}, 3.0, 20.0},
                                        {{12.0, 12.0}, {-0.25, 0.5}, 3.0, 20.0},
                                        {{4.0, 12.0}, {0.5, -0.5}, 0.875, 5.0},
                                        {{12.0, 4.0}, {-0.5, 0.5}, 0.875, 5.0}};
    for (const Body<2>& body : large)
        std::erase_if(scene.bodies, [&](const Body<2>& other) {
            const double reach = body.radius + 0.25;
            return square_of_distance(body.x, other.x, scene.effects) < reach * reach;
        });
    scene.bodies.insert(scene.bodies.end(), large.begin(), large.end());
    return scene;
}
std::vector<Scene<2>> scenes() {
    Scene<2> endless = gas<2>(64, false, 53);
    endless.name = "gas without a box";
    endless.effects.box.reset();
    return {gas<2>(64, false, 51), gas<2>(64, true, 52), endless, sizes(54), falling<2>(64, 55)};
}

template <int D>
std::vector<Vector<D>> centres(const State<D>& state, const Effects<D>& effects) {
    std::vector<Vector<D>> places;
    for (const Ball<D>& ball : state.balls) {
        Vector<D>& x = places.emplace_back(centre(ball, state.time, effects));
        for (int k = 0; k < D; ++k) x[k] = in_box(x[k], k, effects);
    }
    return places;
}
template <int D>
bool lies_in(const Vector<D>& x, const Box<D>& box) {
    for (int k = 0; k < D; ++k)
        if (x[k] < box.low[k] - 1e-9 || x[k] > box.high[k] + 1e-9) return false;
    return true;
}

template <int D>
std::vector<Box<D>> boxes_of(const Sketch<D>& sketch) {
    std::vector<Box<D>> boxes;
    for (const auto& area : sketch.areas) boxes.push_back(area.box);
    return boxes;
}

using Link = std::pair<std::int32_t, std::int32_t>;

/// Looks at a simulation just before each of its first strikes.
template <int D, class Look>
void look_at(const Scene<D>& scene, Structure wish, const Look& look) {
    SCOPED_TRACE(scene.name);
    const State<D> begin = start<D>(scene.bodies, scene.effects);
    const Structure structure = choose(wish, begin, scene.effects).structure;
    SCOPED_TRACE(name_of(structure));
    std::vector<Strike> log;
    Simulation<D>(begin, scene.effects, {structure})
        .run({.until = 100.0, .strikes = looks},
             [&](const Strike& strike) { log.push_back(strike); });
    EXPECT_FALSE(log.empty());
    Simulation<D> simulation(begin, scene.effects, {structure});
    for (const Strike& strike : log) {
        simulation.run({.until = std::nextafter(strike.time, 0.0)});
        look(structure, simulation.sketch(), simulation.state(), strike);
        simulation.run({.until = strike.time});
    }
}

TEST(MotionSketch, ThePairThatStrikesNextIsLinked) {
    for (const Structure wish : {Structure::lists, Structure::segments}) {
        for (const Scene<2>& scene : scenes()) {
            look_at(scene, wish,
                    [](Structure structure, const Sketch<2>& sketch, const State<2>&,
                       const Strike& next) {
                        // Of a periodic box segments leave it to others.
                        if (next.wall ||
                            (structure != Structure::lists && structure != Structure::segments))
                            return;
                        EXPECT_TRUE(std::ranges::binary_search(sketch.links, Link{next.a, next.b}))
                            << next.a << " and " << next.b << " at " << next.time;
                    });
        }
    }
}

TEST(MotionSketch, LinksAreInOrderAndOnlyOnce) {
    look_at(gas<3>(64, false, 61), Structure::lists,
            [](Structure, const Sketch<3>& sketch, const State<3>&, const Strike&) {
                EXPECT_FALSE(sketch.links.empty());
                EXPECT_TRUE(std::ranges::is_sorted(sketch.links));
                EXPECT_EQ(std::ranges::adjacent_find(sketch.links), sketch.links.end());
                EXPECT_TRUE(std::ranges::all_of(sketch.links, [](const Link& link) {
                    return 0 <= link.first && link.first < link.second && link.second < 64;
                }));
            });
}

template <int D>
void expect_every_centre_in_a_box_and_none_empty(const Scene<D>& scene) {
    for (const Structure wish : {Structure::cells, Structure::tree}) {
        look_at(scene, wish,
                [&](Structure, const Sketch<D>& sketch, const State<D>& state, const Strike&) {
                    const std::vector<Vector<D>> places = centres(state, scene.effects);
                    const auto boxes = boxes_of(sketch);
                    ASSERT_FALSE(boxes.empty());
                    ASSERT_LE(boxes.size(), places.size());
                    for (const Vector<D>& x : places)
                        ASSERT_TRUE(std::ranges::any_of(
                            boxes, [&](const auto& box) { return lies_in(x, box); }));
                    for (const Box<D>& box : boxes)
                        ASSERT_TRUE(std::ranges::any_of(
                            places, [&](const auto& x) { return lies_in(x, box); }));
                    for (const Box<D>& box : boxes)
                        ASSERT_EQ(std::ranges::count_if(boxes,
                                                        [&](const Box<D>& other) {
                                                            return box.low == other.low &&
                                                                   box.high == other.high;
                                                        }),
                                  1);
                });
    }
}
TEST(MotionSketch, CellsHoldTheCentresAndNoneIsEmpty) {
    for (const Scene<2>& scene : scenes()) {
        expect_every_centre_in_a_box_and_none_empty(scene);
    }
    expect_every_centre_in_a_box_and_none_empty(gas<3>(64, false, 62));
}

TEST(MotionSketch, LevelsHaveCellsOfSeveralSizes) {
    look_at(sizes(63), Structure::levels,
            [](Structure, const Sketch<2>& sketch, const State<2>&, const Strike&) {
                const auto width = [](const Box<2>& box) { return box.high[0] - box.low[0]; };
                const auto boxes = boxes_of(sketch);
                ASSERT_FALSE(boxes.empty());
                const auto [least, most] = std::ranges::minmax(boxes, {}, width);
                EXPECT_GT(width(most), 3.9 * width(least));
            });
}

TEST(MotionSketch, BallsLieInTheirShells) {
    for (const Scene<2>& scene : scenes()) {
        for (const Structure wish : {Structure::lists, Structure::levels})
            look_at(
                scene, wish,
                [&](Structure, const Sketch<2>& sketch, const State<2>& state, const Strike&) {
                    const std::vector<Vector<2>> places = centres(state, scene.effects);
                    ASSERT_EQ(sketch.rounds.size(), places.size());
                    for (std::size_t i = 0; i < places.size(); ++i) {
                        const auto& [ball, centre, radius] = sketch.rounds[i];
                        ASSERT_EQ(ball, static_cast<std::int32_t>(i));
                        ASSERT_LE(std::sqrt(square_of_distance(places[i], centre, scene.effects)),
                                  radius - state.balls[i].radius + 1e-9);
                        ASSERT_TRUE(!scene.effects.periodic || lies_in(centre, *scene.effects.box));
                    }
                });
    }
}

TEST(MotionSketch, BoxesOfSegmentsLieCloseAroundTheirBalls) {
    for (const Scene<2>& scene : scenes()) {
        if (scene.effects.periodic) continue;
        look_at(scene, Structure::segments,
                [&](Structure, const Sketch<2>& sketch, const State<2>& state, const Strike&) {
                    const std::vector<Vector<2>> places = centres(state, scene.effects);
                    ASSERT_EQ(sketch.areas.size(), places.size());
                    // Twice the margin is at most 2^-17 of the distance between neighbours.
                    double widest = 0.0;
                    for (int k = 0; k < 2; ++k) {
                        const auto along = [k](const Vector<2>& x) { return x[k]; };
                        const auto [low, high] = std::ranges::minmax(places, {}, along);
                        widest = std::max(widest, high[k] - low[k]);
                    }
                    const double margins =
                        0x1p-16 * widest / std::sqrt(static_cast<double>(places.size()));
                    for (std::size_t i = 0; i < places.size(); ++i) {
                        const auto& [box, level, ball] = sketch.areas[i];
                        const double radius = state.balls[i].radius;
                        ASSERT_EQ(ball, static_cast<std::int32_t>(i));
                        for (int k = 0; k < 2; ++k) {
                            ASSERT_LT(box.low[k], places[i][k] - radius + 1e-9);
                            ASSERT_GT(box.high[k], places[i][k] + radius - 1e-9);
                            ASSERT_LT(box.high[k] - box.low[k], 2.0 * radius + margins);
                        }
                    }
                });
    }
}

Strike strike_of(const Sketch<2>::Expected& expected) {
    if (expected.partner < 0) return {0.0, true, expected.ball, -1 - expected.partner, 0.0};
    return {0.0, false, std::min(expected.ball, expected.partner),
            std::max(expected.ball, expected.partner), 0.0};
}
bool is_same_pair(const Strike& one, const Strike& other) {
    return one.wall == other.wall && one.a == other.a && one.b == other.b;
}
TEST(MotionSketch, TheEarliestThatIsExpectedStrikesNext) {
    for (const Structure wish : all_structures) {
        for (const Scene<2>& scene : scenes()) {
            look_at(scene, wish,
                    [](Structure, const Sketch<2>& sketch, const State<2>&, const Strike& next) {
                        using Expected = Sketch<2>::Expected;
                        ASSERT_FALSE(sketch.expected.empty());
                        EXPECT_TRUE(std::ranges::is_sorted(sketch.expected, {}, &Expected::ball));
                        const Expected first =
                            *std::ranges::min_element(sketch.expected, {}, &Expected::time);
                        EXPECT_TRUE(is_same_pair(strike_of(first), next))
                            << first.ball << " and " << first.partner << ", not " << next.a
                            << " and " << next.b;
                        EXPECT_NEAR(first.time, next.time, 1e-6);
                    });
        }
    }
}

}  // namespace
}  // namespace signum::motion
