#include "movie.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

#include <fmt/format.h>

namespace signum {
namespace {

constexpr double width = 640.0;
constexpr double seconds = 12.0;
/// Told apart by the colour-blind, too; a ball's is that of its number.
constexpr std::array<const char*, 6> colours = {"#0072b2", "#e69f00", "#009e73",
                                                "#cc79a7", "#56b4e9", "#d55e00"};

}  // namespace

Movie::Movie(std::vector<double> radii, std::array<double, 2> low, std::array<double, 2> high,
             bool periodic)
    : radii_(std::move(radii)), low_(low), high_(high), periodic_(periodic) {
    shown_.resize(radii_.size());
    std::iota(shown_.begin(), shown_.end(), std::size_t{0});
    if (shown_.size() <= most_balls) return;
    std::ranges::stable_sort(shown_,
                             [&](std::size_t a, std::size_t b) { return radii_[a] > radii_[b]; });
    shown_.resize(most_balls);
    std::ranges::sort(shown_);
}

void Movie::add(double time, const std::vector<Ball>& balls) {
    if (added_++ % every_ != 0) return;
    std::vector<Ball> frame;
    frame.reserve(shown_.size());
    for (const std::size_t i : shown_) frame.push_back(balls[i]);
    times_.push_back(time);
    frames_.push_back(std::move(frame));
    if (frames_.size() <= most_frames) return;
    every_ *= 2;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < frames_.size(); k += 2, ++kept) {
        times_[kept] = times_[k];
        if (kept != k) frames_[kept] = std::move(frames_[k]);
    }
    times_.resize(kept);
    frames_.resize(kept);
}

void Movie::write(std::ostream& out, const std::string& title) const {
    const double scale = width / std::max(high_[0] - low_[0], high_[1] - low_[1]);
    const double wide = scale * (high_[0] - low_[0]);
    const double high = scale * (high_[1] - low_[1]);
    // What flies far away stays in the file as far away.
    const auto bounded = [](double pixels) { return std::clamp(pixels, -1e5, 1e5); };
    const auto x_of = [&](double x) { return bounded(scale * (x - low_[0])); };
    const auto y_of = [&](double y) { return bounded(scale * (high_[1] - y)); };
    std::string legend = title;
    if (shown_.size() < radii_.size())
        legend += fmt::format("; the {} largest of {} balls", shown_.size(), radii_.size());
    if (!times_.empty())
        legend += fmt::format("; t = {:.4g} to {:.4g}", times_.front(), times_.back());
    out << fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n<rect x=\"-10\" y=\"-10\" width=\"{:.1f}\" "
        "height=\"{:.1f}\" fill=\"white\"/>\n<rect width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill=\"none\" stroke=\"#888\"/>\n<text x=\"0\" y=\"{:.1f}\" fill=\"#333\">{}</text>\n"
        "<clipPath id=\"box\"><rect width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n"
        "<g clip-path=\"url(#box)\" fill-opacity=\"0.75\" stroke=\"#222\" stroke-width=\"0.5\">\n",
        wide + 20.0, high + 44.0, wide + 20.0, high + 44.0, wide, high, high + 22.0, legend, wide,
        high);
    std::vector<std::size_t> order(shown_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!frames_.empty()) {
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return frames_.front()[a].depth > frames_.front()[b].depth;
        });
    }
    for (const std::size_t k : order) {
        const std::size_t number = shown_[k];
        const Ball first = frames_.empty() ? Ball{} : frames_.front()[k];
        out << fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" fill=\"{}\"><title>{}</title>",
            x_of(first.x), y_of(first.y), std::max(scale * radii_[number], 1.0),
            colours[number % colours.size()], number);
        if (frames_.size() > 1) {
            const char* const mode = periodic_ ? "discrete" : "linear";
            for (const bool of_x : {true, false}) {
                out << fmt::format(
                    "<animate attributeName=\"{}\" dur=\"{}s\" repeatCount=\"indefinite\" "
                    "calcMode=\"{}\" values=\"",
                    of_x ? "cx" : "cy", seconds, mode);
                for (std::size_t f = 0; f < frames_.size(); ++f) {
                    const Ball& ball = frames_[f][k];
                    out << (f > 0 ? ";" : "")
                        << fmt::format("{:.1f}", of_x ? x_of(ball.x) : y_of(ball.y));
                }
                out << "\"/>";
            }
        }
        out << "</circle>\n";
    }
    out << "</g>\n</svg>\n";
}

}  // namespace signum
