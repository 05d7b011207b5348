#include "frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace signum {
namespace {

constexpr double frame_margin = 0.07;    // of the width, on every side: room for unbounded cells
constexpr double lowest = 0.4;           // height over width
constexpr double far_larger = 8.0;       // than the centres' extent and the median radius: cut off
constexpr double largest_scale = 1e200;  // its square is finite; only denormal extents reach it

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value, double radius) noexcept {
        low = std::min(low, value - radius);
        high = std::max(high, value + radius);
    }
    [[nodiscard]] double length() const noexcept { return high - low; }
    [[nodiscard]] double middle() const noexcept { return low + length() / 2; }
};

// The radius above which a disc is cut off.
double largest_shown(std::span<const Site> scaled) {
    Interval x;
    Interval y;
    std::vector<double> radii;
    radii.reserve(scaled.size());
    for (const Site& disc : scaled) {
        x.include(disc.x, 0);
        y.include(disc.y, 0);
        radii.push_back(disc.r);
    }
    const auto median = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), median, radii.end());
    return far_larger * std::max({x.length(), y.length(), *median});
}

}  // namespace

Frame::Frame(std::span<const Site> discs, double width) : width_(width), height_(lowest * width) {
    if (discs.empty()) return;

    double largest = 0.0;
    for (const Site& disc : discs)
        largest = std::max({largest, std::abs(disc.x), std::abs(disc.y), disc.r});
    if (largest > 0) exponent_ = std::ilogb(largest);

    std::vector<Site> scaled;
    scaled.reserve(discs.size());
    for (const Site& disc : discs)
        scaled.push_back({std::ldexp(disc.x, -exponent_), std::ldexp(disc.y, -exponent_),
                          std::ldexp(disc.r, -exponent_)});

    const double limit = largest_shown(scaled);
    Interval x;
    Interval y;
    for (const Site& disc : scaled) {
        const double radius = disc.r <= limit ? disc.r : 0.0;
        x.include(disc.x, radius);
        y.include(disc.y, radius);
    }
    middle_ = {x.middle(), y.middle()};

    const double room = width_ * (1 - 2 * frame_margin);
    const double extent = std::max(x.length(), y.length());
    // Around a point alone: as far as it is from the origin, at least.
    scale_ = std::min(room / (extent > 0 ? extent : 2), largest_scale);
    height_ = std::max(lowest * width_, y.length() * scale_ + 2 * frame_margin * width_);
}

Frame::Frame(const Box& box, double width) : width_(width) {
    const double largest =
        std::max({std::abs(box.x0), std::abs(box.y0), std::abs(box.x1), std::abs(box.y1)});
    exponent_ = std::ilogb(largest);
    const auto scaled = [this](double side) { return std::ldexp(side, -exponent_); };
    middle_ = {(scaled(box.x0) + scaled(box.x1)) / 2, (scaled(box.y0) + scaled(box.y1)) / 2};
    const double box_width = scaled(box.x1) - scaled(box.x0);
    const double box_height = scaled(box.y1) - scaled(box.y0);
    // A tall box becomes narrower instead of a picture without end.
    scale_ = std::min({width / box_width, 2 * width / box_height, largest_scale});
    width_ = box_width * scale_;
    height_ = box_height * scale_;
}

double Frame::rounding() const noexcept {
    return 0x1p-52 * std::max(std::abs(middle_.x) * scale_ + width_ / 2,
                              std::abs(middle_.y) * scale_ + height_ / 2);
}

double Frame::length(double in_plane) const noexcept {
    return std::ldexp(in_plane, -exponent_) * scale_;
}

double Frame::log10_of_pixel() const noexcept {
    return exponent_ * std::log10(2.0) - std::log10(scale_);
}

Point Frame::at(Point divided, int exponent) const noexcept {
    const int shift = exponent - exponent_;
    return {width_ / 2 + (std::ldexp(divided.x, shift) - middle_.x) * scale_,
            height_ / 2 - (std::ldexp(divided.y, shift) - middle_.y) * scale_};
}

Box Frame::box(int exponent) const noexcept {
    const auto side = [&](double middle, double pixels) {
        return std::ldexp(middle + pixels / scale_, exponent_ - exponent);
    };
    return {side(middle_.x, -width_ / 2), side(middle_.y, -height_ / 2),
            side(middle_.x, width_ / 2), side(middle_.y, height_ / 2)};
}

}  // namespace signum
