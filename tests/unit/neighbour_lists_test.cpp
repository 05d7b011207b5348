/// Lists of neighbours in cells of one size and of several, beside a look at all pairs: whenever a
/// list is made anew it holds all whose shells overlap with the ball's, and they hold the ball.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/sketch.hpp"
#include "../../motion/structures/lists.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"

namespace signum::motion {
namespace {

using oracle_test::Random;

enum class Bounds { none, box, periodic };

/// Places and speeds at random, radii from `least` to `most`, small ones as a power of a uniform
/// number; that balls overlap is no matter here.
template <int D>
World<D> world_of(Random& random, Slot balls, double least, double most, Bounds bounds,
                  double pull) {
    Effects<D> effects;
    effects.gravity[D - 1] = -pull;
    if (bounds != Bounds::none) {
        effects.box.emplace();
        for (int k = 0; k < D; ++k) effects.box->high[k] = 1.0 + 0.25 * k;
        effects.periodic = bounds == Bounds::periodic;
    }
    Balls<D> all;
    for (Slot i = 0; i < balls; ++i) {
        const double power = std::pow(random.unit(), 3.0);
        Ball<D> ball{{}, {}, least > 0.0 ? least * std::pow(most / least, power) : 0.0, 0.0};
        if (i == 0) ball.radius = most;
        for (int k = 0; k < D; ++k) {
            ball.x[k] = random.unit();
            ball.v[k] = random.unit() - 0.5;
        }
        all.push_back(ball);
    }
    return World<D>(all, effects, 0.0);
}

template <int D>
class Watched {
 public:
    Watched(World<D>& world, Structure structure) : world_(world), lists_(world, structure) {
        for (Slot i = 0; i < world.balls.size(); ++i) next_.push_back(lists_.next(i, 0.0));
        look_at_shells();
    }

    [[nodiscard]] const std::vector<typename Sketch<D>::Round>& shells() const { return shells_; }
    [[nodiscard]] std::size_t listed() const { return listed_; }

    /// The next event; whoever was not in the list, and is now, is proposed.
    void step() {
        const auto first = std::ranges::min_element(next_);
        ASSERT_LT(*first, infinity);
        now_ = std::max(now_, *first);
        const auto i = static_cast<Slot>(first - next_.begin());
        renew(i);
        next_[i] = lists_.next(i, now_);
        ASSERT_GE(next_[i], now_);
    }
    void renew(Slot i) {
        const std::vector<Slot> before(lists_.list(i).begin(), lists_.list(i).end());
        std::vector<Slot> proposed;
        lists_.own_event(
            i, now_, [&](Slot j) { proposed.push_back(j); }, [](Slot) {});
        look_at_shells();
        for (const Slot j : lists_.list(i))
            ASSERT_NE(std::ranges::find(before, j) != before.end(),
                      std::ranges::find(proposed, j) != proposed.end());
        expect_all_of(i);
    }
    /// A strike: the ball flies otherwise from now on.
    void turn(Slot i, const Vector<D>& v) {
        Ball<D>& ball = world_.balls[i];
        ball.x = world_.centre(i, now_);
        ball.time = now_;
        ball.v = v;
        next_[i] = lists_.next(i, now_);
    }
    void expect_all_of(Slot i) {
        for (Slot j = 0; j < shells_.size(); ++j) {
            if (j == i) continue;
            Vector<D> d;
            for (int k = 0; k < D; ++k) d[k] = shells_[i].centre[k] - shells_[j].centre[k];
            const double reach = shells_[i].radius + shells_[j].radius;
            const bool is_listed = has(i, j);
            ASSERT_EQ(is_listed, has(j, i)) << i << ", " << j;
            ASSERT_TRUE(is_listed || world_.nearest_square(d) >= reach * reach) << i << ", " << j;
            listed_ += is_listed ? 1 : 0;
        }
        ASSERT_EQ(std::ranges::count(lists_.list(i), i), 0);
    }
    /// At any time until the next event every ball lies in its sphere.
    void expect_all_in_their_spheres(Random& random) {
        const double until = std::ranges::min(next_);
        const double time = now_ + (until - now_) * random.unit();
        if (!(time < infinity)) return;
        for (Slot i = 0; i < shells_.size(); ++i) {
            Vector<D> d = world_.centre(i, time);
            for (int k = 0; k < D; ++k) d[k] -= shells_[i].centre[k];
            const double slack = shells_[i].radius - world_.balls[i].radius;
            ASSERT_LE(std::sqrt(world_.nearest_square(d)), slack * (1.0 + 0x1p-30)) << i;
        }
    }

 private:
    [[nodiscard]] bool has(Slot i, Slot j) const {
        const auto list = lists_.list(i);
        EXPECT_LE(std::ranges::count(list, j), 1);
        return std::ranges::find(list, j) != list.end();
    }
    void look_at_shells() {
        Sketch<D> sketch;
        lists_.sketch(now_, sketch);
        shells_ = sketch.rounds;
    }

    World<D>& world_;
    Lists<D> lists_;
    std::vector<double> next_;
    double now_ = 0.0;
    std::vector<typename Sketch<D>::Round> shells_;
    std::size_t listed_ = 0;
};

template <int D>
void expect_lists(std::uint64_t seed, Slot balls, double least, double most, Bounds bounds,
                  double pull) {
    for (const Structure structure : {Structure::lists, Structure::levels}) {
        SCOPED_TRACE(name_of(structure));
        Random random(seed);
        World<D> world = world_of<D>(random, balls, least, most, bounds, pull);
        Watched<D> watched(world, structure);
        for (Slot i = 0; i < balls; ++i) ASSERT_NO_FATAL_FAILURE(watched.expect_all_of(i));
        for (int step = 0; step < (is_fast ? 1600 : 100); ++step) {
            ASSERT_NO_FATAL_FAILURE(watched.expect_all_in_their_spheres(random));
            if (random.below(4) == 0) {
                const auto i = static_cast<Slot>(random.below(static_cast<int>(balls)));
                Vector<D> v;
                for (int k = 0; k < D; ++k)
                    v[k] = random.unit() - std::clamp(watched.shells()[i].centre[k], -1.0, 2.0);
                watched.turn(i, v);
            } else {
                ASSERT_NO_FATAL_FAILURE(watched.step());
            }
        }
        EXPECT_GT(watched.listed(), balls);
    }
}

TEST(NeighbourLists, HoldAllWhoseShellsOverlap) {
    for (const Bounds bounds : {Bounds::none, Bounds::box, Bounds::periodic}) {
        for (const double pull : {0.0, 4.0}) {
            SCOPED_TRACE(static_cast<int>(bounds));
            ASSERT_NO_FATAL_FAILURE(expect_lists<2>(1, 60, 0.05, 0.05, bounds, pull));
            ASSERT_NO_FATAL_FAILURE(expect_lists<2>(2, 200, 0.01, 0.12, bounds, pull));
            ASSERT_NO_FATAL_FAILURE(expect_lists<3>(3, 60, 0.08, 0.08, bounds, pull));
            ASSERT_NO_FATAL_FAILURE(expect_lists<3>(4, 200, 0.01, 0.12, bounds, pull));
        }
    }
}

/// A large ball looks into as many fine cells as there are balls, or more, and all around a
/// periodic box.
TEST(NeighbourLists, OfLargeBallsHoldTheSmallest) {
    for (const Bounds bounds : {Bounds::none, Bounds::box, Bounds::periodic}) {
        SCOPED_TRACE(static_cast<int>(bounds));
        ASSERT_NO_FATAL_FAILURE(expect_lists<2>(5, 400, 1e-6, 0.2, bounds, 0.0));
        ASSERT_NO_FATAL_FAILURE(expect_lists<2>(6, 400, 0x1p-40, 0.45, bounds, 0.5));
        ASSERT_NO_FATAL_FAILURE(expect_lists<3>(7, 400, 1e-3, 0.3, bounds, 0.0));
        ASSERT_NO_FATAL_FAILURE(expect_lists<3>(8, 12, 0.0, 0.2, bounds, 0.0));
    }
}

/// In a narrow box the cells of a level cannot be as wide as told.
TEST(NeighbourLists, OfABallAsWideAsTheBoxHoldAll) {
    for (const Bounds bounds : {Bounds::box, Bounds::periodic}) {
        ASSERT_NO_FATAL_FAILURE(expect_lists<2>(10, 300, 1e-3, 0.49, bounds, 0.0));
        ASSERT_NO_FATAL_FAILURE(expect_lists<2>(11, 300, 0.02, 0.49, bounds, 0.0));
        ASSERT_NO_FATAL_FAILURE(expect_lists<3>(12, 300, 0.02, 0.49, bounds, 0.0));
    }
}

/// Balls that crowd in a small part of the place, and balls that come to crowd there.
TEST(NeighbourLists, OfCrowdsAreShort) {
    const Slot balls = is_fast ? 2000 : 500;
    for (const Bounds bounds : {Bounds::none, Bounds::box}) {
        for (const Structure structure : {Structure::lists, Structure::levels}) {
            Random random(13);
            World<2> world = world_of<2>(random, balls, 1e-6, 1e-6, bounds, 0.0);
            const auto crowd = [&](double part) {
                for (Slot i = 1; i < balls; ++i)
                    for (double& x : world.balls[i].x) x *= part;
            };
            crowd(0x1p-10);
            Watched<2> watched(world, structure);
            for (Slot i = 0; i < balls; i += 50) ASSERT_NO_FATAL_FAILURE(watched.expect_all_of(i));
            EXPECT_LT(watched.listed(), 64 * balls / 50);
            Lists<2> lists(world, structure);
            EXPECT_FALSE(lists.is_crowded());
            crowd(0x1p-10);
            for (Slot i = 0; i < balls && !lists.is_crowded(); ++i)
                lists.own_event(
                    i, 0.0, [](Slot) {}, [](Slot) {});
            EXPECT_TRUE(lists.is_crowded());
            EXPECT_FALSE(Lists<2>(world, structure).is_crowded());
        }
    }
}

/// Where floats do not tell from both sides alike whether shells overlap.
TEST(NeighbourLists, AgreeFromBothSides) {
    Random random(9);
    std::size_t apart = 0;
    std::size_t together = 0;
    for (int turn = 0; turn < 400 * thoroughness; ++turn) {
        World<2> world = world_of<2>(random, 100, 0.01, 0.12, Bounds::box, 0.0);
        for (Ball<2>& ball : world.balls) ball.v = {};
        const double slack =
            Watched<2>(world, Structure::levels).shells()[1].radius - world.balls[1].radius;
        Ball<2>& a = world.balls[1];
        Ball<2>& b = world.balls[2];
        a.x = {0.5, 0.6};
        const double angle = 7.0 * random.unit();
        // Shells are thicker than told by some 2^-19.
        const double part = random.below(64) * 0x1p-22;
        const double reach = (a.radius + b.radius + 2.0 * slack) * (1.0 + part);
        b.x = {a.x[0] + reach * std::cos(angle), a.x[1] + reach * std::sin(angle)};
        for (const Structure structure : {Structure::lists, Structure::levels}) {
            Watched<2> watched(world, structure);
            for (const Slot each : {1U, 2U, 2U, 1U, 2U})
                ASSERT_NO_FATAL_FAILURE(watched.renew(each));
            Lists<2> lists(world, structure);
            const auto list = lists.list(1);
            ++(std::ranges::find(list, 2U) == list.end() ? apart : together);
        }
    }
    EXPECT_GT(std::min(apart, together), 20U);
}

}  // namespace
}  // namespace signum::motion
