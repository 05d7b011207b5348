/// The log among obstacles against the oracle's, strike by strike and bit by bit, whatever the
/// structure: oblique walls, circles and spheres from both sides, at rest and in motion.

#include <algorithm>
#include <cstdint>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "effects_scenes.hpp"
#include "motion_oracle.hpp"

namespace signum::motion {
namespace {

const std::uint64_t scenes = is_fast ? 12 : 3;

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
        expect_log_of_oracle(scene, 8.0, 30, &strikes);
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
    expect_log_of_oracle(scene, 10.0, 100, &strikes);
    // With a part towards the wall it bounces along.
    scene.bodies[0].v[0] = 0.125;
    expect_log_of_oracle(scene, 10.0, 100, &strikes);
    EXPECT_GT(strikes, 5U);
    // From outside it flies on.
    scene.bodies[0].x = {6.0, 0.0};
    std::get<Sphere<2>>(scene.effects.obstacles[0]).side = Sphere<2>::Side::outside;
    scene.bodies[0].v[0] = 0.0;
    expect_log_of_oracle(scene, 10.0, 100, &strikes);
}

}  // namespace
}  // namespace signum::motion
