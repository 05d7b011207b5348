#pragma once
/// What the oracle says of balls in flight.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "../oracle/motion.hpp"
#include "motion_case.hpp"

namespace signum::hard {

template <std::size_t D>
class OracleOfMotion {
 public:
    explicit OracleOfMotion(const std::vector<Flight<D>>& flights) {
        world_.dimension = static_cast<int>(D);
        for (const Flight<D>& flight : flights) {
            oracle::motion::Ball ball;
            std::ranges::copy(flight.x, ball.x.begin());
            std::ranges::copy(flight.v, ball.v.begin());
            ball.r = flight.radius;
            balls_.push_back(ball);
        }
    }
    double meeting_time(std::size_t a, std::size_t b) const {
        return oracle::motion::meeting_time(balls_[a], balls_[b], world_)
            .value_or(std::numeric_limits<double>::infinity());
    }
    std::vector<StrikeOfTwo> strikes(double until) const {
        std::vector<StrikeOfTwo> result;
        for (const auto& strike : oracle::motion::simulate(balls_, world_, until, most_strikes).log)
            result.push_back({strike.time, strike.a, strike.b});
        return result;
    }

 private:
    std::vector<oracle::motion::Ball> balls_;
    oracle::motion::World world_;
};

}  // namespace signum::hard
