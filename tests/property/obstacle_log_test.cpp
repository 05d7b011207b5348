/// The log among obstacles against the oracle's, strike by strike and bit by bit, whatever the
/// structure: oblique walls, circles and spheres from both sides, at rest and in motion.

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "effects_scenes.hpp"
#include "motion_oracle.hpp"

namespace signum::motion {
namespace {

constexpr std::uint64_t scenes = is_fast ? 12 : 3;

/// Precondition: there is no segment.
template <int D>
void expect_log_of_oracle_among_obstacles(const Scene<D>& scene, double until, std::size_t most,
                                          std::size_t& strikes) {
    std::vector<brute::Ball> balls;
    for (const Body<D>& body : scene.bodies) balls.push_back(to_brute(body));
    brute::World world = to_brute(scene.effects);
    // The oracle numbers those walls alone that there are.
    const int first = static_cast<int>(2 * D - world.walls.size());
    for (const Obstacle<D>& obstacle : scene.effects.obstacles) {
        std::visit(
            [&](const auto& wall) {
                if constexpr (!std::is_same_v<decltype(wall), const Segment&>)
                    world.walls.push_back(to_brute(wall));
            },
            obstacle);
    }
    const brute::Run expected = brute::simulate(balls, world, until, most);
    strikes += expected.log.size();
    const State<D> begin = start<D>(scene.bodies, scene.effects);
    for (const Structure structure : all_structures) {
        SCOPED_TRACE(std::string(name_of(structure)));
        Simulation<D> simulation(begin, scene.effects, {.structure = structure});
        std::vector<Strike> log;
        const Outcome outcome =
            simulation.run({.until = until, .strikes = most},
                           [&](const Strike& strike) { log.push_back(strike); });
        for (std::size_t i = 0; i < std::min(log.size(), expected.log.size()); ++i) {
            const brute::Strike& e = expected.log[i];
            ASSERT_EQ(log[i], (Strike{e.time, e.wall, e.a, e.wall ? e.b + first : e.b, e.impulse}))
                << "strike " << i << ": " << log[i].time << " " << log[i].wall << " " << log[i].a
                << " " << log[i].b << " " << log[i].impulse << ", expected " << e.time << " "
                << e.wall << " " << e.a << " " << e.b << " " << e.impulse;
        }
        ASSERT_EQ(log.size(), expected.log.size());
        ASSERT_EQ(outcome.ending == Ending::collapse, expected.collapsed);
    }
}

template <int D>
void expect_logs_of_oracle(const std::vector<Effect>& wanted) {
    std::size_t strikes = 0;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Scene<D> scene = effects_scene<D>(seed, wanted);
        if (scene.effects.periodic) continue;
        if constexpr (D == 2)
            std::erase_if(scene.effects.obstacles, [](const Obstacle<2>& each) {
                return std::holds_alternative<Segment>(each);
            });
        expect_log_of_oracle_among_obstacles(scene, 8.0, 30, strikes);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(strikes, 2 * scenes);
}

TEST(ObstacleLog, InThePlaneIsTheOracles) {
    expect_logs_of_oracle<2>({Effect::obstacles});
}
TEST(ObstacleLog, OfBallsThatFallInThePlaneIsTheOracles) {
    expect_logs_of_oracle<2>({Effect::gravity, Effect::losses, Effect::obstacles});
}
TEST(ObstacleLog, InSpaceIsTheOracles) {
    expect_logs_of_oracle<3>({Effect::losses, Effect::obstacles});
}
TEST(ObstacleLog, OfBallsThatFallInSpaceIsTheOracles) {
    expect_logs_of_oracle<3>({Effect::gravity, Effect::obstacles});
}

/// Along a wall that bends towards it a ball would strike for ever at one time.
TEST(ObstacleLog, ABallThatTouchesACircleFromInsideAndFliesAlongItCollapses) {
    Scene<2> scene{"along a circle", {{{4.0, 0.0}, {0.0, 1.0}, 1.0, 1.0}}, {}};
    Sphere<2> circle;
    circle.radius = 5.0;
    circle.side = Sphere<2>::Side::inside;
    scene.effects.obstacles.emplace_back(circle);
    std::size_t strikes = 0;
    expect_log_of_oracle_among_obstacles(scene, 10.0, 100, strikes);
    // With a part towards the wall it bounces along.
    scene.bodies[0].v[0] = 0.125;
    expect_log_of_oracle_among_obstacles(scene, 10.0, 100, strikes);
    EXPECT_GT(strikes, 5U);
    // From outside it flies on.
    scene.bodies[0].x = {6.0, 0.0};
    std::get<Sphere<2>>(scene.effects.obstacles[0]).side = Sphere<2>::Side::outside;
    scene.bodies[0].v[0] = 0.0;
    expect_log_of_oracle_among_obstacles(scene, 10.0, 100, strikes);
}

}  // namespace
}  // namespace signum::motion
