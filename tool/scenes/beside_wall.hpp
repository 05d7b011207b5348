#pragma once
/// Where a place lies beside a wall: for what is checked or drawn, in doubles, from the definitions
/// of the walls alone and not from the code that makes balls strike them.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "snapshot.hpp"

namespace signum {

template <int D>
struct BesideWall {
    double distance = 0.0;        ///< of the surface; below 0 behind a wall that has a behind
    motion::Vector<D> normal{};   ///< from the wall to the place, of length 1
    motion::Vector<D> nearest{};  ///< the wall's nearest point
};

namespace beside {

template <int D>
BesideWall<D> of(const motion::HalfSpace<D>& wall, const motion::Vector<D>& x, double time) {
    const double length = norm(wall.normal);
    BesideWall<D> result;
    result.distance = (dot(wall.normal, x) - wall.offset - wall.speed * time) / length;
    for (int k = 0; k < D; ++k) result.normal[k] = wall.normal[k] / length;
    result.nearest = x - result.distance * result.normal;
    return result;
}

/// Seen from a point: the distance from it, and the direction.
template <int D>
BesideWall<D> of_point(const motion::Vector<D>& point, const motion::Vector<D>& x) {
    BesideWall<D> result{norm(x - point), x - point, point};
    if (result.distance > 0.0)
        for (double& each : result.normal) each /= result.distance;
    return result;
}

template <int D>
BesideWall<D> of(const motion::Sphere<D>& wall, const motion::Vector<D>& x, double time) {
    BesideWall<D> result = of_point<D>(wall.centre + time * wall.velocity, x);
    result.nearest = result.nearest + wall.radius * result.normal;
    result.distance -= wall.radius;
    if (wall.side == motion::Sphere<D>::Side::inside) {
        result.distance = -result.distance;
        result.normal = -1.0 * result.normal;
    }
    return result;
}

/// From the end that is nearer, for the other one may be so far away that no double tells how far x
/// is from it.
inline BesideWall<2> of(const motion::Segment& wall, const motion::Vector<2>& x, double) {
    motion::Vector<2> near = wall.from;
    motion::Vector<2> far = wall.to;
    if (dot(x - far, x - far) < dot(x - near, x - near)) std::swap(near, far);
    const motion::Vector<2> along = far - near;
    const double share = std::clamp(dot(x - near, along) / dot(along, along), 0.0, 1.0);
    return of_point<2>(near + share * along, x);
}

}  // namespace beside

/// How many walls there are, the sides of a box among them; a periodic one has none. The first
/// number of an obstacle is 2 D.
template <int D>
[[nodiscard]] int first_wall(const motion::Effects<D>& effects) {
    return effects.box && !effects.periodic ? 0 : 2 * D;
}
template <int D>
[[nodiscard]] int end_of_walls(const motion::Effects<D>& effects) {
    return 2 * D + static_cast<int>(effects.obstacles.size());
}

/// Precondition: first_wall(effects) <= wall < end_of_walls(effects).
template <int D>
[[nodiscard]] BesideWall<D> beside_wall(const motion::Effects<D>& effects, int wall,
                                        const motion::Vector<D>& x, double time) {
    if (wall >= 2 * D)
        return std::visit([&](const auto& obstacle) { return beside::of(obstacle, x, time); },
                          effects.obstacles[static_cast<std::size_t>(wall - 2 * D)]);
    const motion::Box<D> box = box_at(*effects.box, effects, time);
    const int axis = wall / 2;
    const bool is_upper = wall % 2 != 0;
    BesideWall<D> result;
    result.normal[axis] = is_upper ? -1.0 : 1.0;
    result.nearest = x;
    result.nearest[axis] = is_upper ? box.high[axis] : box.low[axis];
    result.distance = (x[axis] - result.nearest[axis]) * result.normal[axis];
    return result;
}

}  // namespace signum
