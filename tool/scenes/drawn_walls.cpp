#include "drawn_walls.hpp"

#include <array>
#include <cmath>
#include <variant>

#include "snapshot.hpp"

namespace signum {
namespace {

using Place = std::array<double, 2>;

template <int D>
void add_wall(std::vector<Movie::Wall>& walls, const motion::HalfSpace<D>& wall,
              const motion::Box<D>& shown) {
    if constexpr (D == 3) {
        if (wall.normal[2] != 0.0) return;
    }
    const double a = wall.normal[0];
    const double b = wall.normal[1];
    const double square = a * a + b * b;
    const double width = shown.high[0] - shown.low[0] + shown.high[1] - shown.low[1];
    // From the place of the wall that is nearest to the middle of what is shown.
    const double x = 0.5 * (shown.low[0] + shown.high[0]);
    const double y = 0.5 * (shown.low[1] + shown.high[1]);
    const double off = (wall.offset - a * x - b * y) / square;
    const double far = 4.0 * width / std::sqrt(square);
    Movie::Wall line;
    for (const double side : {-far, far})
        line.points.push_back({x + off * a - side * b, y + off * b + side * a});
    if (wall.speed != 0.0)
        line.shift = [rate = wall.speed / square, a, b](double time) {
            return Place{rate * a * time, rate * b * time};
        };
    walls.push_back(line);
}

template <int D>
void add_wall(std::vector<Movie::Wall>& walls, const motion::Sphere<D>& wall,
              const motion::Box<D>&) {
    Movie::Wall circle;
    circle.centre = {wall.centre[0], wall.centre[1]};
    circle.radius = wall.radius;
    if (wall.velocity != motion::Vector<D>{})
        circle.shift = [v = Place{wall.velocity[0], wall.velocity[1]}](double time) {
            return Place{v[0] * time, v[1] * time};
        };
    walls.push_back(circle);
}

void add_wall(std::vector<Movie::Wall>& walls, const motion::Segment& wall, const motion::Box<2>&) {
    Movie::Wall line;
    line.points = {{wall.from[0], wall.from[1]}, {wall.to[0], wall.to[1]}};
    walls.push_back(line);
}

}  // namespace

template <int D>
std::vector<Movie::Wall> drawn_walls(const motion::Effects<D>& effects,
                                     const motion::Box<D>& shown) {
    std::vector<Movie::Wall> walls;
    if (effects.shake) {
        const auto& [low, high] = *effects.box;
        Movie::Wall sides;
        sides.points = {{low[0], low[1]},
                        {high[0], low[1]},
                        {high[0], high[1]},
                        {low[0], high[1]},
                        {low[0], low[1]}};
        sides.shift = [effects](double time) {
            const motion::Box<D> moved = box_at({}, effects, time);
            return Place{moved.low[0], moved.low[1]};
        };
        walls.push_back(sides);
    }
    for (const auto& obstacle : effects.obstacles)
        std::visit([&](const auto& wall) { add_wall(walls, wall, shown); }, obstacle);
    return walls;
}

template std::vector<Movie::Wall> drawn_walls(const motion::Effects<2>&, const motion::Box<2>&);
template std::vector<Movie::Wall> drawn_walls(const motion::Effects<3>&, const motion::Box<3>&);

}  // namespace signum
