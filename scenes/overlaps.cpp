#include "overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "beside_wall.hpp"

namespace signum {
namespace {

template <int D>
struct Places {
    std::vector<motion::Vector<D>> centres;
    std::vector<double> radii;
};

double largest_of(const std::vector<double>& radii) {
    return radii.empty() ? 0.0 : *std::ranges::max_element(radii);
}

/// Tells of all pairs that are less than the sum of their radii and that share of it apart:
/// visit(i, j, distance). Along x each ball looks ahead as far as it goes itself, in a periodic box
/// around it.
template <int D, typename Visit>
void visit_pairs(const Places<D>& places, const motion::Effects<D>& effects, double share,
                 const Visit& visit) {
    const auto& [centres, radii] = places;
    const std::size_t n = centres.size();
    std::vector<double> begins(n);
    for (std::size_t i = 0; i < n; ++i) begins[i] = centres[i][0] - radii[i] * (1.0 + share);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return begins[a] < begins[b]; });
    const auto side = [&](int k) { return effects.box->high[k] - effects.box->low[k]; };
    for (std::size_t place = 0; place < n; ++place) {
        const std::size_t i = order[place];
        const double end = centres[i][0] + radii[i] * (1.0 + share);
        for (std::size_t step = 1; step < n; ++step) {
            const bool is_around = place + step >= n;
            if (is_around && !effects.periodic) break;
            const std::size_t j = order[(place + step) % n];
            const double shift = is_around ? side(0) : 0.0;
            if (begins[j] + shift >= end) break;
            const double ahead = centres[j][0] - centres[i][0] + shift;
            double square = ahead * ahead;
            for (int k = 1; k < D; ++k) {
                double d = centres[j][k] - centres[i][k];
                if (effects.periodic) d -= side(k) * std::nearbyint(d / side(k));
                square += d * d;
            }
            const double both = (radii[i] + radii[j]) * (1.0 + share);
            if (square < both * both) visit(i, j, std::sqrt(square));
        }
    }
}

/// visit(i, distance) for each ball and wall.
template <int D, typename Visit>
void visit_walls(const Places<D>& places, const motion::Effects<D>& effects, double time,
                 const Visit& visit) {
    for (std::size_t i = 0; i < places.centres.size(); ++i)
        for (int wall = first_wall(effects); wall < end_of_walls(effects); ++wall)
            visit(i, beside_wall(effects, wall, places.centres[i], time).distance);
}

/// How deep something is in a ball, as a part of a length.
double depth(double distance, double reach, double scale) {
    return (reach - distance) / scale;
}

}  // namespace

template <int D>
Overlaps deepest_overlaps(const motion::State<D>& state, const motion::Effects<D>& effects,
                          double time) {
    Places<D> places;
    double reach = 0.0;
    for (const motion::Ball<D>& ball : state.balls) {
        motion::Vector<D>& centre = places.centres.emplace_back();
        for (int k = 0; k < D; ++k)
            centre[k] = in_box(coordinate(ball, k, time, effects), k, effects);
        places.radii.push_back(radius_at(ball, time, effects));
        for (const double x : centre) reach = larger(reach, std::fabs(x));
    }
    if (!std::isfinite(reach)) return {reach, reach};
    const std::vector<double>& radii = places.radii;
    const double largest = largest_of(radii);
    const double of_points = largest > 0.0 ? largest : reach > 0.0 ? reach : 1.0;
    const auto scale = [&](double radius) { return radius > 0.0 ? radius : of_points; };

    Overlaps result;
    visit_walls(places, effects, time, [&](std::size_t i, double distance) {
        result.of_walls = std::max(result.of_walls, depth(distance, radii[i], scale(radii[i])));
    });
    visit_pairs(places, effects, 0.0, [&](std::size_t i, std::size_t j, double distance) {
        result.of_balls = std::max(result.of_balls, depth(distance, radii[i] + radii[j],
                                                          scale(std::min(radii[i], radii[j]))));
    });
    return result;
}

template <int D>
void part(std::span<motion::Body<D>> bodies, const motion::Effects<D>& effects) {
    constexpr double margin = 1e-9;
    constexpr double deepest = 0x1.4p-8;
    Places<D> places;
    for (const motion::Body<D>& body : bodies) {
        places.centres.push_back(body.x);
        places.radii.push_back(body.radius);
    }
    const std::vector<double>& radii = places.radii;
    const auto shrink = [&](std::size_t i, double distance, double reach) {
        bodies[i].radius =
            std::min(bodies[i].radius, radii[i] * ((1.0 - margin) * distance / reach));
    };
    // Half the margin is what the others keep, so that nobody shrinks a second time.
    visit_walls(places, effects, 0.0, [&](std::size_t i, double distance) {
        if (distance < radii[i] * (1.0 + 0.5 * margin) &&
            depth(distance, radii[i], radii[i]) <= deepest)
            shrink(i, distance, radii[i]);
    });
    visit_pairs(places, effects, 0.5 * margin, [&](std::size_t i, std::size_t j, double distance) {
        const double both = radii[i] + radii[j];
        // In a ball a point is as deep as in one of its own size.
        const double smaller = std::min(radii[i], radii[j]);
        if (depth(distance, both, smaller > 0.0 ? smaller : both) > deepest) return;
        shrink(i, distance, both);
        shrink(j, distance, both);
    });
}

template Overlaps deepest_overlaps(const motion::State<2>&, const motion::Effects<2>&, double);
template Overlaps deepest_overlaps(const motion::State<3>&, const motion::Effects<3>&, double);
template void part(std::span<motion::Body<2>>, const motion::Effects<2>&);
template void part(std::span<motion::Body<3>>, const motion::Effects<3>&);

}  // namespace signum
