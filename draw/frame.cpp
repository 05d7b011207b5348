#include <signum/draw/frame.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace signum {
namespace {

constexpr double margin = 0.07;          // of the width, on every side: room for unbounded cells
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

    const double room = width_ * (1 - 2 * margin);
    const double extent = std::max(x.length(), y.length());
    scale_ = extent > 0 ? std::min(room / extent, largest_scale) : 1.0;
    height_ = std::max(lowest * width_, y.length() * scale_ + 2 * margin * width_);
}

Point Frame::at(Point point) const noexcept {
    return {width_ / 2 + (std::ldexp(point.x, -exponent_) - middle_.x) * scale_,
            height_ / 2 - (std::ldexp(point.y, -exponent_) - middle_.y) * scale_};
}

double Frame::length(double in_plane) const noexcept {
    return std::ldexp(in_plane, -exponent_) * scale_;
}

double Frame::area(double in_plane) const noexcept {
    return std::ldexp(in_plane, -2 * exponent_) * scale_ * scale_;
}

Point Frame::direction(Point a, Point b) const noexcept {
    const double x = std::ldexp(b.x, -exponent_) - std::ldexp(a.x, -exponent_);
    const double y = std::ldexp(a.y, -exponent_) - std::ldexp(b.y, -exponent_);
    const double norm = std::hypot(x, y);
    return {x / norm, y / norm};
}

std::optional<Segment> Frame::clip(Point start, Point step, double low,
                                   double high) const noexcept {
    const auto cut = [&](double at, double along, double end) {
        if (along == 0) return 0 <= at && at <= end;
        const auto [enter, leave] = std::minmax({-at / along, (end - at) / along});
        low = std::max(low, enter);
        high = std::min(high, leave);
        return low < high;
    };
    if (!cut(start.x, step.x, width_) || !cut(start.y, step.y, height_)) return {};
    const Segment inside = {{start.x + low * step.x, start.y + low * step.y},
                            {start.x + high * step.x, start.y + high * step.y}};
    const auto finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    if (!finite(inside.from) || !finite(inside.to)) return {};
    return inside;
}

}  // namespace signum
