/// The meeting times of two balls of space that may grow. Of a configuration the first two balls
/// are the places and radii, the next two the speeds and the growth of the radii; the last one's
/// first two numbers are the own times.

#include <array>
#include <cstddef>

#include "../../motion/meeting_time.hpp"
#include "blocks.hpp"
#include "meeting_oracle.hpp"

namespace signum::fuzz {

void ask_meeting(const Configuration<3>& configuration, Ledger& ledger) {
    const auto& balls = configuration.balls;
    const auto flight = [&](std::size_t m) -> meeting_oracle::Flight {
        return {balls[m].centre, balls[2 + m].centre, balls[m].size, balls[2 + m].size,
                balls[4].centre[m]};
    };
    const auto ball = [](const meeting_oracle::Flight& of) {
        motion::GrowingBall<3> result;
        for (std::size_t k = 0; k < 3; ++k) {
            result.x[static_cast<int>(k)] = of.x[k];
            result.v[static_cast<int>(k)] = of.v[k];
        }
        result.radius = of.radius;
        result.time = of.time;
        result.growth = of.growth;
        return result;
    };
    const meeting_oracle::Flight a = flight(0);
    const meeting_oracle::Flight b = flight(1);
    const double said =
        motion::meeting_time<3>(ball(a), ball(b), motion::Image<3>{}, motion::Effects<3>{});
    bool tied = false;
    const bool right = meeting_oracle::is_right(a, b, said, tied);
    // As a sign: that it is right.
    ledger.note(Predicate::meeting, {right ? 1 : 0, Stage::exact}, 1, tied);
}

/// Flights that touch at once, graze, go along with one another, or are anything small.
void make_meeting(hard::Moves<3>& moves, Configuration<3>& into) {
    into.kind = Kind::euclidean;
    auto& balls = into.balls;
    const auto set = [&](Ball<3>& ball, std::int64_t most, std::int64_t size) {
        for (double& x : ball.centre) x = static_cast<double>(moves.integer(-most, most));
        ball.size =
            static_cast<double>(moves.integer(size < 0 ? size : 0, size < 0 ? -size : size));
    };
    set(balls[0], 8, 5);
    set(balls[1], 8, 5);
    set(balls[2], 4, -2);
    set(balls[3], 4, -2);
    set(balls[4], moves.once_in(2) ? 0 : 4, 0);
    if (moves.once_in(2)) balls[2].size = balls[3].size = 0.0;
    const bool in_plane = moves.once_in(2);
    if (!moves.once_in(4)) {
        // They touch, at their own times; or fly on across that, and graze unless they grow.
        std::array<Ball<3>, 2> touching;
        moves.tangent(Kind::euclidean, touching);
        std::array<double, 3> apart = touching[0].centre;
        double distance = 0.0;
        for (const double x : apart) distance += x * x;
        distance = std::sqrt(distance);  // an integer
        balls[0].size = static_cast<double>(moves.integer(0, static_cast<std::int64_t>(distance)));
        balls[1].size = distance - balls[0].size;
        balls[4].centre = {};
        for (std::size_t k = 0; k < 3; ++k) balls[0].centre[k] = balls[1].centre[k] + apart[k];
        if (!moves.once_in(3)) {
            const auto times = static_cast<double>(moves.integer(-3, 3));
            const auto other = static_cast<double>(moves.integer(-3, 3));
            const std::array<double, 3> way = {-times * apart[1] - other * apart[2],
                                               times * apart[0], other * apart[0]};
            const auto before = static_cast<double>(moves.integer(0, 3));
            for (std::size_t k = 0; k < 3; ++k) {
                balls[2].centre[k] = balls[3].centre[k] + way[k];
                balls[0].centre[k] -= before * way[k];
            }
        }
    } else if (in_plane) {
        for (std::size_t m = 0; m < 4; ++m) balls[m].centre[2] = 0.0;
    }
    const auto scale = [&](std::size_t first, int exponent) {
        for (std::size_t m = first; m < first + 2; ++m) {
            for (double& x : balls[m].centre) x = std::ldexp(x, exponent);
            balls[m].size = std::ldexp(balls[m].size, exponent);
        }
    };
    if (moves.once_in(2)) scale(0, static_cast<int>(moves.integer(-30, 30)));
    if (moves.once_in(2)) scale(2, static_cast<int>(moves.integer(-30, 30)));
    if (!moves.once_in(4))
        moves.move_by_ulps(into.kind, balls, static_cast<int>(moves.integer(1, 3)), 4);
    if (moves.once_in(16)) moves.raw(into.kind, balls, static_cast<int>(moves.integer(0, 60)));
    balls[0].size = std::abs(balls[0].size);
    balls[1].size = std::abs(balls[1].size);
}

}  // namespace signum::fuzz
