#include "frame_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>

namespace signum {
namespace {

constexpr double largest_side = 800.0;
constexpr double border = 8.0;
/// The same as those of a film.
constexpr std::array<const char*, 6> ball_colours = {"#0072b2", "#e69f00", "#009e73",
                                                     "#cc79a7", "#56b4e9", "#d55e00"};

/// From the plane to pixels.
class View {
 public:
    explicit View(const MotionFrame& frame)
        : low_{frame.low[0], frame.low[1]}, high_{frame.high[0], frame.high[1]} {
        const double longest = std::max(high_[0] - low_[0], high_[1] - low_[1]);
        scale_ = (largest_side - 2.0 * border) / longest;
    }
    // What flies far away stays in the file as far away.
    [[nodiscard]] double x(double value) const {
        return std::clamp(border + scale_ * (value - low_[0]), -1e5, 1e5);
    }
    [[nodiscard]] double y(double value) const {
        return std::clamp(border + scale_ * (high_[1] - value), -1e5, 1e5);
    }
    [[nodiscard]] double length(double value) const { return std::min(scale_ * value, 1e5); }
    [[nodiscard]] static long even(double pixels) {
        return 2 * static_cast<long>(std::ceil(pixels / 2.0));
    }
    [[nodiscard]] long width() const { return even(length(high_[0] - low_[0]) + 2.0 * border); }
    [[nodiscard]] long height() const { return even(length(high_[1] - low_[1]) + 2.0 * border); }

 private:
    std::array<double, 2> low_;
    std::array<double, 2> high_;
    double scale_ = 1.0;
};

using Text = std::back_insert_iterator<std::string>;

template <int D>
void draw_wall(Text out, const View& view, const motion::HalfSpace<D>& wall, double time) {
    // Of space only what stands upright on the page is a line there.
    if constexpr (D == 3) {
        if (wall.normal[2] != 0.0) return;
    }
    const double a = wall.normal[0];
    const double b = wall.normal[1];
    const double square = a * a + b * b;
    const double offset = (wall.offset + wall.speed * time) / square;
    constexpr double far = 1e4;
    const double x = view.x(offset * a);
    const double y = view.y(offset * b);
    const double dx = far * b / std::sqrt(square);
    const double dy = far * a / std::sqrt(square);
    fmt::format_to(out, "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", x - dx, y - dy, x + dx,
                   y + dy);
}
template <int D>
void draw_wall(Text out, const View& view, const motion::Sphere<D>& wall, double time) {
    fmt::format_to(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n",
                   view.x(wall.centre[0] + wall.velocity[0] * time),
                   view.y(wall.centre[1] + wall.velocity[1] * time), view.length(wall.radius));
}
void draw_segment(Text out, const View& view, const motion::Segment& wall) {
    fmt::format_to(out, "<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", view.x(wall.from[0]),
                   view.y(wall.from[1]), view.x(wall.to[0]), view.y(wall.to[1]));
}

template <int D>
void draw_walls(Text out, const View& view, const std::vector<motion::Obstacle<D>>& obstacles,
                double time) {
    for (const auto& obstacle : obstacles) {
        std::visit(
            [&]<class Wall>(const Wall& wall) {
                if constexpr (std::is_same_v<Wall, motion::Segment>)
                    draw_segment(out, view, wall);
                else
                    draw_wall(out, view, wall, time);
            },
            obstacle);
    }
}

}  // namespace

template <int D>
std::string frame_picture(const MotionFrame& frame, const motion::Effects<D>& effects) {
    const View view(frame);
    std::string text;
    const Text out = std::back_inserter(text);
    fmt::format_to(out,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                   "viewBox=\"0 0 {0} {1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
                   "<g stroke=\"#222\" stroke-width=\"0.5\" fill-opacity=\"0.8\">\n",
                   view.width(), view.height());
    std::vector<std::size_t> order(frame.balls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (D == 3)
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return frame.balls[a].x[2] < frame.balls[b].x[2];
        });
    for (const std::size_t i : order) {
        const MotionFrame::Ball& ball = frame.balls[i];
        const double depth =
            D == 3
                ? std::clamp((frame.high[2] - ball.x[2]) / (frame.high[2] - frame.low[2]), 0.0, 1.0)
                : 0.0;
        fmt::format_to(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"{}/>\n",
                       view.x(ball.x[0]), view.y(ball.x[1]), view.length(ball.radius),
                       ball_colours[i % ball_colours.size()],
                       D == 3 ? fmt::format(" opacity=\"{:.2f}\"", 1.0 - 0.6 * depth) : "");
    }
    fmt::format_to(out, "</g>\n<g fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\">\n");
    if (effects.box)
        fmt::format_to(
            out, "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"{}/>\n",
            view.x(frame.low[0]), view.y(frame.high[1]), view.length(frame.high[0] - frame.low[0]),
            view.length(frame.high[1] - frame.low[1]),
            frame.periodic ? " stroke-dasharray=\"6 4\"" : "");
    draw_walls<D>(out, view, effects.obstacles, frame.time);
    text += "</g>\n</svg>\n";
    return text;
}

template std::string frame_picture(const MotionFrame&, const motion::Effects<2>&);
template std::string frame_picture(const MotionFrame&, const motion::Effects<3>&);

}  // namespace signum
