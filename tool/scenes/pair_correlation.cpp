#include "pair_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "../../motion/vector.hpp"
#include "../io/text_writer.hpp"

namespace signum {
namespace {

double side(const MotionFrame& frame, int k) {
    const auto axis = static_cast<std::size_t>(k);
    return frame.high[axis] - frame.low[axis];
}

}  // namespace

PairCorrelation::PairCorrelation(const MotionFrame& first) : dimension_(first.dimension) {
    double shortest = side(first, 0);
    for (int k = 1; k < dimension_; ++k) shortest = std::min(shortest, side(first, k));
    double diameter = 0.0;
    for (const MotionFrame::Ball& ball : first.balls)
        diameter += 2.0 * ball.radius / static_cast<double>(first.balls.size());
    const double most = first.periodic ? shortest / 2.0 : shortest / 4.0;
    constexpr double shells_of_points = 200.0;
    const double farthest = diameter > 0.0 ? std::min(most, 8.0 * diameter) : most;
    thickness_ = diameter > 0.0 ? diameter / 50.0 : most / shells_of_points;
    const double shells = std::clamp(std::floor(farthest / thickness_), 1.0, 400.0);
    thickness_ = std::min(thickness_, farthest / shells);
    pairs_.resize(static_cast<std::size_t>(shells));
}

void PairCorrelation::add(const MotionFrame& frame) {
    const std::size_t n = frame.balls.size();
    const double farthest = thickness_ * static_cast<double>(pairs_.size());
    std::vector<bool> is_centre(n, true);
    std::size_t centres = n;
    double volume = 1.0;
    for (int k = 0; k < dimension_; ++k)
        volume *= frame.periodic ? side(frame, k) : side(frame, k) - 2.0 * farthest;
    if (!frame.periodic) {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
                if (frame.balls[i].x[axis] - frame.low[axis] < farthest ||
                    frame.high[axis] - frame.balls[i].x[axis] < farthest)
                    is_centre[i] = false;
        centres = static_cast<std::size_t>(std::ranges::count(is_centre, true));
    }
    if (centres == 0 || n < 2) return;
    const auto number = static_cast<double>(centres);
    centres_ += number;
    expected_ += number * (frame.periodic ? number - 1.0 : number) / volume;

    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return frame.balls[a].x[0] < frame.balls[b].x[0];
    });
    // Along x each ball looks ahead, in a periodic box around it.
    for (std::size_t i = 0; i < n; ++i) {
        const MotionFrame::Ball& a = frame.balls[order[i]];
        for (std::size_t step = 1; step < n; ++step) {
            const bool is_around = i + step >= n;
            if (is_around && !frame.periodic) break;
            const std::size_t j = order[(i + step) % n];
            const MotionFrame::Ball& b = frame.balls[j];
            const double ahead = b.x[0] - a.x[0] + (is_around ? side(frame, 0) : 0.0);
            if (ahead >= farthest) break;
            double square = ahead * ahead;
            for (int k = 1; k < dimension_; ++k) {
                double d = b.x[static_cast<std::size_t>(k)] - a.x[static_cast<std::size_t>(k)];
                if (frame.periodic) d -= side(frame, k) * std::nearbyint(d / side(frame, k));
                square += d * d;
            }
            const auto shell = static_cast<std::size_t>(std::sqrt(square) / thickness_);
            if (shell >= pairs_.size()) continue;
            pairs_[shell] += (is_centre[order[i]] ? 1.0 : 0.0) + (is_centre[j] ? 1.0 : 0.0);
        }
    }
}

std::vector<double> PairCorrelation::neighbours() const {
    std::vector<double> result = pairs_;
    for (double& each : result) each /= std::max(centres_, 1.0);
    return result;
}

std::vector<PairCorrelation::Shell> PairCorrelation::shells() const {
    std::vector<Shell> result;
    const auto ball = [&](double r) {
        return dimension_ == 2 ? motion::ball_volume<2>(r) : motion::ball_volume<3>(r);
    };
    for (std::size_t i = 0; i < pairs_.size() && expected_ > 0.0; ++i) {
        const auto shell = static_cast<double>(i);
        const double volume = ball((shell + 1.0) * thickness_) - ball(shell * thickness_);
        result.push_back({(shell + 0.5) * thickness_, pairs_[i] / (expected_ * volume)});
    }
    return result;
}

void PairCorrelation::write(std::ostream& out) const {
    TextWriter text(out);
    text.put("r,g\n");
    for (const auto& [r, g] : shells()) text.put(FMT_COMPILE("{},{}\n"), r, g);
    text.flush();
}

}  // namespace signum
