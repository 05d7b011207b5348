#include "overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "../../motion/pair_tree.hpp"
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

/// Tells of all pairs that are less than the sum of their radii and that share of it apart, each
/// once, until visit(i, j, distance) returns false. In a periodic box the nearest image counts.
template <int D, typename Visit>
void visit_pairs(const Places<D>& places, const motion::Effects<D>& effects, double share,
                 const Visit& visit) {
    const auto& centres = places.centres;
    const auto& radii = places.radii;
    if (centres.empty()) return;
    std::vector<typename motion::PairTree<D>::Place> boxes;
    boxes.reserve(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        boxes.push_back({.box = {centres[i], centres[i]}, .radius = radii[i] * (1.0 + share)});
    // Just below 0, so that points in one place are no pairs.
    const auto bound = [] { return -std::numeric_limits<double>::denorm_min(); };
    motion::PairTree<D>(boxes, effects).visit_pairs(bound, [&](std::uint32_t i, std::uint32_t j) {
        const double square = square_between(centres[i], centres[j], periodic_box(effects));
        const double both = (radii[i] + radii[j]) * (1.0 + share);
        return square >= both * both || visit(i, j, std::sqrt(square));
    });
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
        places.centres.push_back(centre_in_box(ball, time, effects));
        places.radii.push_back(radius_at(ball, time, effects));
        for (const double x : places.centres.back()) reach = larger(reach, std::fabs(x));
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
        return true;
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
    // Around a ball are at most twelve that touch it and are no smaller, and hardly more where they
    // overlap by so little: where there are more pairs, there are deeper ones among them, which
    // nobody can take apart.
    std::size_t pairs_left = 16 * places.centres.size();
    visit_pairs(places, effects, 0.5 * margin, [&](std::size_t i, std::size_t j, double distance) {
        if (pairs_left-- == 0) return false;
        const double both = radii[i] + radii[j];
        // In a ball a point is as deep as in one of its own size.
        const double smaller = std::min(radii[i], radii[j]);
        if (depth(distance, both, smaller > 0.0 ? smaller : both) > deepest) return true;
        shrink(i, distance, both);
        shrink(j, distance, both);
        return true;
    });
}

template Overlaps deepest_overlaps(const motion::State<2>&, const motion::Effects<2>&, double);
template Overlaps deepest_overlaps(const motion::State<3>&, const motion::Effects<3>&, double);
template void part(std::span<motion::Body<2>>, const motion::Effects<2>&);
template void part(std::span<motion::Body<3>>, const motion::Effects<3>&);

}  // namespace signum
