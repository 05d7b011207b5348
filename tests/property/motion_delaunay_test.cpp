/// What delaunay knows of discs in flight: its neighbours at any time are those of the exact
/// triangulation right after it, neither ahead of the clock nor behind it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/structures/delaunay.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "motion_scenes.hpp"

namespace signum::motion {
namespace {

using Pairs = std::set<std::pair<Index, Index>>;

/// Discs that fly on whatever they meet, and the structure asked in the loop's way.
class Flight {
 public:
    Flight(const std::vector<Ball<2>>& balls, const Effects<2>& effects, double start)
        : world_({balls.begin(), balls.end()}, effects, start), delaunay_(world_) {
        for (Slot i = 0; i < balls.size(); ++i) own_.push_back(delaunay_.next(i, start));
    }
    [[nodiscard]] double next_event() const { return *std::ranges::min_element(own_); }
    /// All events of the structure at a time.
    void happen(double now) {
        for (;;) {
            const auto first = std::ranges::min_element(own_);
            if (*first > now) return;
            const auto i = static_cast<Slot>(first - own_.begin());
            delaunay_.own_event(
                i, now, [](Slot) {}, [&](Slot j) { own_[j] = delaunay_.next(j, now); });
            own_[i] = delaunay_.next(i, now);
        }
    }
    [[nodiscard]] Pairs neighbours() const {
        Pairs pairs;
        for (Slot i = 0; i < own_.size(); ++i)
            delaunay_.near(i, [&](Slot j) {
                pairs.insert(std::minmax(static_cast<Index>(i), static_cast<Index>(j)));
            });
        return pairs;
    }

 private:
    World<2> world_;
    Delaunay<2> delaunay_;
    std::vector<double> own_;
};

Pairs edges_of(const KineticTessellation& tessellation) {
    Pairs pairs;
    for (const Face& face : tessellation.faces())
        for (std::size_t k = 0; k < 3; ++k) pairs.insert(std::minmax(face[k], face[(k + 1) % 3]));
    return pairs;
}

/// At the structure's own events and halfway between them.
void expect_neighbours_of_the_clock(const std::vector<Ball<2>>& balls, const Effects<2>& effects,
                                    double start, int most_events) {
    Flight flight(balls, effects, start);
    KineticTessellation exact(start, {effects.gravity[0], effects.gravity[1]});
    for (const Ball<2>& ball : balls)
        exact.insert({ball.x[0], ball.x[1], ball.v[0], ball.v[1], ball.radius, ball.time});
    ASSERT_EQ(flight.neighbours(), edges_of(exact));
    double now = start;
    int events = 0;
    for (; events < most_events; ++events) {
        const double event = flight.next_event();
        if (event == infinity) break;
        const double between = now + 0.5 * (event - now);
        if (now < between && between < event) {
            exact.advance(between);
            ASSERT_EQ(flight.neighbours(), edges_of(exact)) << "before event " << events;
        }
        now = event;
        flight.happen(now);
        exact.advance(now);
        ASSERT_EQ(flight.neighbours(), edges_of(exact)) << "event " << events << " at " << now;
    }
    ASSERT_GT(events, 30);
}

std::vector<Ball<2>> balls_of(const Scene<2>& scene, double time) {
    std::vector<Ball<2>> balls = start<2>(scene.bodies, scene.effects).balls;
    for (Ball<2>& ball : balls) ball.time = time;
    return balls;
}

TEST(MotionDelaunay, NeighboursAreThoseOfTheClock) {
    Scene<2> gas_of_radii = gas<2>(64, false, 71);
    std::mt19937_64 random(72);
    for (Body<2>& body : gas_of_radii.bodies)
        body.radius = 0.01 + 0.4 * static_cast<double>(random() % 1024) / 1024.0;
    Scene<2> falling = gas_of_radii;
    falling.effects.gravity = {0.25, -1.0};
    // All events are ties.
    Scene<2> mirrored = symmetric<2>(64, 73);
    for (const Scene<2>& scene : {gas<2>(64, false, 70), gas_of_radii, falling, mirrored}) {
        SCOPED_TRACE(scene.name);
        for (const double start : {0.0, 3.0, 0x1p20}) {
            SCOPED_TRACE(start);
            ASSERT_NO_FATAL_FAILURE(expect_neighbours_of_the_clock(
                balls_of(scene, start), scene.effects, start, is_fast ? 400 : 100));
        }
    }
}

/// Columns that pass one another slowly, nearly all at once: roots that are hard to tell apart.
TEST(MotionDelaunay, NeighboursAreThoseOfTheClockWhereEventsCrowd) {
    for (const double speed : {1.0, 0x1p-20, 0x1p-40}) {
        SCOPED_TRACE(speed);
        std::vector<Ball<2>> balls;
        for (const Vector<2>& x : lattice<2>(36)) {
            const double sign = std::fmod(x[1], 2.0) < 1.0 ? 1.0 : -1.0;
            balls.push_back({x, {sign * speed, speed * 0x1p-30 * x[0]}, 0.25, 0.0});
        }
        ASSERT_NO_FATAL_FAILURE(expect_neighbours_of_the_clock(balls, {}, 0.0, 200));
    }
}

}  // namespace
}  // namespace signum::motion
