#include "run_record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "arrangement.hpp"
#include "beside_wall.hpp"
#include "energy.hpp"

namespace signum {
namespace {

/// How deep two balls are in each other, as a part of the smaller radius.
double depth(double distance, double reach, double scale) {
    return (reach - distance) / scale;
}

}  // namespace

template <int D>
Overlaps deepest_overlaps(const motion::State<D>& state, const motion::Effects<D>& effects,
                          double time) {
    const std::size_t n = state.balls.size();
    std::vector<motion::Vector<D>> centres(n);
    std::vector<double> radii(n);
    double largest = 0.0;
    double reach = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        for (int k = 0; k < D; ++k)
            centres[i][k] = in_box(coordinate(state.balls[i], k, time, effects), k, effects);
        radii[i] = radius_at(state.balls[i], time, effects);
        largest = std::max(largest, radii[i]);
        for (const double x : centres[i]) reach = larger(reach, std::fabs(x));
    }
    if (!std::isfinite(reach)) return {reach, reach};
    const double of_points = largest > 0.0 ? largest : reach > 0.0 ? reach : 1.0;
    const auto scale = [&](double radius) { return radius > 0.0 ? radius : of_points; };

    Overlaps result;
    for (std::size_t i = 0; i < n; ++i)
        for (int wall = first_wall(effects); wall < end_of_walls(effects); ++wall) {
            const double distance = beside_wall(effects, wall, centres[i], time).distance;
            result.of_walls = std::max(result.of_walls, depth(distance, radii[i], scale(radii[i])));
        }

    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order,
                      [&](std::size_t a, std::size_t b) { return centres[a][0] < centres[b][0]; });
    const auto side = [&](int k) { return effects.box->high[k] - effects.box->low[k]; };
    // Along x each ball looks ahead, in a periodic box around it.
    for (std::size_t place = 0; place < n; ++place) {
        const std::size_t i = order[place];
        for (std::size_t step = 1; step < n; ++step) {
            const bool is_around = place + step >= n;
            if (is_around && !effects.periodic) break;
            const std::size_t j = order[(place + step) % n];
            const double ahead = centres[j][0] - centres[i][0] + (is_around ? side(0) : 0.0);
            if (ahead >= 2.0 * largest) break;
            double square = ahead * ahead;
            for (int k = 1; k < D; ++k) {
                double d = centres[j][k] - centres[i][k];
                if (effects.periodic) d -= side(k) * std::nearbyint(d / side(k));
                square += d * d;
            }
            const double both = radii[i] + radii[j];
            if (square >= both * both) continue;
            result.of_balls = std::max(result.of_balls, depth(std::sqrt(square), both,
                                                              scale(std::min(radii[i], radii[j]))));
        }
    }
    return result;
}

template <int D>
void RunRecord<D>::add(const motion::State<D>& state, double time, const motion::Counts& counts) {
    Moment moment;
    moment.time = time;
    const Energy<D> energy(state, effects_, time);
    moment.kinetic = energy.kinetic;
    moment.spin = energy.spin;
    moment.total = energy.total;
    moment.terms_of_total = energy.kinetic + energy.spin;
    double filled = 0.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const motion::Ball<D>& ball = state.balls[i];
        motion::Vector<D> v;
        for (int k = 0; k < D; ++k) {
            v[k] = speed(ball, k, time, effects_);
            moment.momentum[static_cast<std::size_t>(k)] += state.masses[i] * v[k];
            moment.terms_of_total += std::fabs(state.masses[i] * effects_.gravity[k] *
                                               coordinate(ball, k, time, effects_));
        }
        const double fast = std::sqrt(dot(v, v));
        moment.terms_of_momentum += state.masses[i] * fast;
        moment.fastest = larger(moment.fastest, fast);
        filled += unit_ball<D>() * std::pow(radius_at(ball, time, effects_), D);
    }
    if (effects_.box) {
        moment.packing = filled;
        for (int k = 0; k < D; ++k) moment.packing /= effects_.box->high[k] - effects_.box->low[k];
    }
    moment.strikes = counts.strikes;
    moment.virial = counts.virial;
    const Overlaps overlaps = deepest_overlaps(state, effects_, time);
    moment.overlap_of_balls = overlaps.of_balls;
    moment.overlap_of_walls = overlaps.of_walls;

    if (moments_.size() % every_ == 0) {
        if (looks_.size() == most_looks) {
            std::size_t kept = 0;
            for (std::size_t i = 0; i < looks_.size(); i += 2)
                looks_[kept++] = std::move(looks_[i]);
            looks_.resize(kept);
            every_ *= 2;
        }
        if (moments_.size() % every_ == 0) looks_.push_back({time, counts.strikes, state});
    }
    moments_.push_back(moment);
    end_ = state;
}

template Overlaps deepest_overlaps(const motion::State<2>&, const motion::Effects<2>&, double);
template Overlaps deepest_overlaps(const motion::State<3>&, const motion::Effects<3>&, double);
template class RunRecord<2>;
template class RunRecord<3>;

}  // namespace signum
