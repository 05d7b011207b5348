#include "frame_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "../draw/style.hpp"

namespace signum {
namespace {

constexpr double largest_side = 800.0;
constexpr double border = 8.0;
/// Below the box, for the time, and as wide as that at least.
constexpr double strip = 20.0;
constexpr double least_width = 160.0;

/// From the plane to pixels.
class View {
 public:
    explicit View(const MotionFrame& frame)
        : low_{frame.low[0], frame.low[1]}, high_{frame.high[0], frame.high[1]} {
        constexpr double room = largest_side - 2.0 * border;
        scale_ = std::min(room / (high_[0] - low_[0]), (room - strip) / (high_[1] - low_[1]));
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
    [[nodiscard]] long width() const {
        return even(std::max(length(high_[0] - low_[0]) + 2.0 * border, least_width));
    }
    [[nodiscard]] long height() const {
        return even(length(high_[1] - low_[1]) + 2.0 * border + strip);
    }

 private:
    std::array<double, 2> low_;
    std::array<double, 2> high_;
    double scale_ = 1.0;
};

void draw_wall(std::back_insert_iterator<std::string> out, const View& view,
               const Movie::Wall& wall, double time) {
    const auto [x, y] = wall.shift ? wall.shift(time) : std::array{0.0, 0.0};
    if (wall.points.empty()) {
        fmt::format_to(out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n",
                       view.x(wall.centre[0] + x), view.y(wall.centre[1] + y),
                       view.length(wall.radius));
        return;
    }
    std::string path;
    for (const auto& point : wall.points)
        path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L", view.x(point[0] + x),
                            view.y(point[1] + y));
    fmt::format_to(out, "<path d=\"{}\"/>\n", path);
}

}  // namespace

std::string frame_picture(const MotionFrame& frame, std::span<const Movie::Wall> walls,
                          std::string_view unit) {
    const View view(frame);
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out,
                   "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                   "viewBox=\"0 0 {0} {1}\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
                   "<g stroke=\"#222\" stroke-width=\"0.5\" fill-opacity=\"0.8\">\n",
                   view.width(), view.height());
    std::vector<std::size_t> order(frame.balls.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (frame.dimension == 3)
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return frame.balls[a].x[2] < frame.balls[b].x[2];
        });
    for (const std::size_t i : order) {
        const MotionFrame::Ball& ball = frame.balls[i];
        const double depth =
            frame.dimension == 3
                ? std::clamp((frame.high[2] - ball.x[2]) / (frame.high[2] - frame.low[2]), 0.0, 1.0)
                : 0.0;
        fmt::format_to(
            out, "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\"{}/>\n",
            view.x(ball.x[0]), view.y(ball.x[1]), view.length(ball.radius), ball_colour(i),
            frame.dimension == 3 ? fmt::format(" opacity=\"{:.2f}\"", 1.0 - 0.6 * depth) : "");
    }
    fmt::format_to(out, "</g>\n<g fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\">\n");
    fmt::format_to(out, "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"{}/>\n",
                   view.x(frame.low[0]), view.y(frame.high[1]),
                   view.length(frame.high[0] - frame.low[0]),
                   view.length(frame.high[1] - frame.low[1]),
                   frame.periodic ? " stroke-dasharray=\"6 4\"" : "");
    for (const Movie::Wall& wall : walls) draw_wall(out, view, wall, frame.time);
    fmt::format_to(out,
                   "</g>\n<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"14\" "
                   "fill=\"#222\">t = {:.6g}{}{}</text>\n</svg>\n",
                   border, static_cast<double>(view.height()) - border, frame.time,
                   unit.empty() ? "" : " ", unit);
    return text;
}

}  // namespace signum
