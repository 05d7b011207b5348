#include <signum/draw/cell_edge.hpp>
#include <signum/draw/power_shapes.hpp>

#include <cmath>
#include <limits>

namespace signum::power {
namespace {

using Plane = signum::Site;

constexpr double unbounded = std::numeric_limits<double>::infinity();
// Pixels. A vertex farther away is as good as at infinity: only the direction to it shows, and that
// is perpendicular to the edge.
constexpr double far_away = 1e6;

bool is_near(Point p) noexcept {
    return std::abs(p.x) < far_away && std::abs(p.y) < far_away;
}

// The points at equal distance from a and b, in pixels: a line along `upward`.
class Bisector {
 public:
    Bisector(const Frame& frame, WeightIs weight_is, const Plane& a, const Plane& b)
        : frame_(frame), weight_is_(weight_is), a_(a), b_(b) {
        const Point along = frame.direction({a.x, a.y}, {b.x, b.y});
        upward_ = {along.y, -along.x};  // a quarter turn to the left, where y points down
    }

    [[nodiscard]] std::optional<Segment> between(const CellCorner& lower,
                                                 const CellCorner& upper) const {
        const Point below = lower.at;
        const Point above = upper.at;
        if (is_near(below) && is_near(above)) return frame_.clip(below, minus(above, below), 0, 1);
        if (is_near(below)) return frame_.clip(below, upward_, 0, unbounded);
        if (is_near(above)) return frame_.clip(above, upward_, -unbounded, 0);
        // Both ends are far away. They are on different sides of the picture, or on the same, where
        // one of the other two sites is nearer to the whole visible part of the line.
        const Point point = visible_point();
        if (is_nearer(lower.apex, point) || is_nearer(upper.apex, point)) return {};
        return frame_.clip(point, upward_, -unbounded, unbounded);
    }

 private:
    [[nodiscard]] Point pixel(const Plane& site) const { return frame_.at({site.x, site.y}); }

    // w(a) - w(b) in square pixels.
    [[nodiscard]] double excess(const Plane& a, const Plane& b) const {
        if (weight_is_ == WeightIs::weight) return frame_.area(a.r - b.r);
        const double r_a = frame_.length(a.r);
        const double r_b = frame_.length(b.r);
        return (r_a - r_b) * (r_a + r_b);
    }

    // The point of the line of equal power distance that is next to the middle of the picture.
    [[nodiscard]] Point visible_point() const {
        const Point a = pixel(a_);
        const Point step = minus(pixel(b_), a);
        const Point foot = plus(a, step, 0.5 + excess(a_, b_) / (2 * dot(step, step)));
        const Point middle = {frame_.width() / 2, frame_.height() / 2};
        return plus(foot, upward_, dot(minus(middle, foot), upward_));
    }

    [[nodiscard]] bool is_nearer(const Plane* site, Point point) const {
        if (site == nullptr) return false;
        const Point to_site = minus(point, pixel(*site));
        const Point to_a = minus(point, pixel(a_));
        return dot(to_site, to_site) - dot(to_a, to_a) < excess(*site, a_);
    }

    const Frame& frame_;
    WeightIs weight_is_;
    const Plane& a_;
    const Plane& b_;
    Point upward_;
};

}  // namespace

double drawn_radius(const signum::Site& site, WeightIs weight_is) {
    if (weight_is == WeightIs::radius)
        return std::abs(site.r);  // the weight is r², whatever its sign
    return site.r > 0 ? std::sqrt(site.r) : 0.0;
}

std::vector<Segment> cell_edges(const Tessellation& tessellation, const Frame& frame) {
    std::vector<Segment> drawn;
    for_each_cell_edge(tessellation, frame, [&](const CellEdge& edge) {
        const auto site = [&](Index i) -> const Plane& {
            return tessellation.sites()[static_cast<std::size_t>(i)];
        };
        const Bisector bisector(frame, tessellation.weight_is(), site(edge.a), site(edge.b));
        if (const auto segment = bisector.between(edge.below, edge.above))
            drawn.push_back(*segment);
    });
    return drawn;
}

}  // namespace signum::power
