#include <signum/draw/cell_edge.hpp>
#include <signum/draw/rectangular_shapes.hpp>
#include <signum/triangulation/touched_sides.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace signum {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Towards the right, top, left and bottom side of a square or diamond, in pixels, where y points
/// down.
using Directions = std::array<Point, 4>;
constexpr Directions square_sides = {{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
constexpr Directions diamond_sides = {{{1, -1}, {-1, -1}, {-1, 1}, {1, 1}}};

/// The centres of the squares that touch a and b: while a touches the left side and b the right
/// one, a line upwards, and beyond it, where the one that is in the way above or below holds the
/// corner of growing squares, a diagonal ray on either side. "Right" is the direction from a to b
/// in which they lie farther apart.
class Bisector {
 public:
    Bisector(const Frame& frame, Metric metric, const Site& a, const Site& b, Index a_index,
             Index b_index)
        : origin_(frame.at({a.x, a.y})) {
        const Directions& directions = metric == Metric::supremum ? square_sides : diamond_sides;
        const auto direction = [&](int side) { return directions[at(side)]; };
        const std::array<bool, 4> b_touches =
            sides_touched_by_second(metric, a, a_index, b, b_index);

        const Point to_b = pixels_between(frame, a, b);
        double farthest = -1.0;
        int right = 0;
        for (int side = 0; side < 4; ++side)
            if (b_touches[at(side)] && !b_touches[at(side + 2)] &&
                dot(direction(side), to_b) > farthest) {
                farthest = dot(direction(side), to_b);
                right = side;
            }
        right_ = direction(right);
        up_ = direction(right + 1);

        // The forms relative to a, whose own are 0: only differences of radii count.
        const double r_b = radius_difference(frame, b, a);
        const auto form = [&](int side) {
            return b_touches[at(side)] ? dot(direction(side), to_b) - r_b : 0.0;
        };
        const double rho = form(right) / 2;  // of the squares that a and b touch left and right
        line_ = rho;
        lowest_ = form(right + 1) - rho;
        highest_ = std::max(lowest_, rho - form(right + 3));
        below_ = b_touches[at(right + 1)] ? 1.0 : -1.0;
        above_ = b_touches[at(right + 3)] ? 1.0 : -1.0;
        // Farther up or down all is out of the picture.
        reach_ = 8 * (frame.width() + frame.height()) + 4 * (std::abs(to_b.x) + std::abs(to_b.y));
    }

    /// How high a pixel lies on the bisector.
    [[nodiscard]] double height(Point pixel) const { return dot(up_, minus(pixel, origin_)); }

    void draw(const Frame& frame, double from, double to, std::vector<Segment>& drawn) const {
        from = std::clamp(from, -reach_, reach_);
        to = std::clamp(to, -reach_, reach_);
        Point start = point(from);
        const auto line_to = [&](double height) {
            const Point end = point(height);
            if (const auto segment = frame.clip(start, minus(end, start), 0, 1))
                drawn.push_back(*segment);
            start = end;
        };
        for (const double height : {lowest_, highest_})
            if (from < height && height < to) line_to(height);
        line_to(to);
    }

 private:
    static std::size_t at(int side) { return static_cast<std::size_t>(side & 3); }

    [[nodiscard]] Point point(double height) const {
        double along = line_;
        if (height < lowest_) along += below_ * (lowest_ - height);
        if (height > highest_) along += above_ * (height - highest_);
        const double square = dot(up_, up_);
        return plus(plus(origin_, right_, along / square), up_, height / square);
    }

    Point origin_;  // the centre of a
    Point right_;
    Point up_;
    double line_;
    double lowest_;
    double highest_;
    double below_;  // +1 where the ray runs to the right
    double above_;
    double reach_;
};

}  // namespace

std::vector<Segment> rectangular::cell_edges(const Tessellation& tessellation, const Frame& frame) {
    std::vector<Segment> drawn;
    for_each_cell_edge(tessellation, frame, [&](const CellEdge& edge) {
        const auto site = [&](Index i) -> const Site& {
            return tessellation.sites()[static_cast<std::size_t>(i)];
        };
        const Bisector bisector(frame, tessellation.metric(), site(edge.a), site(edge.b), edge.a,
                                edge.b);
        const auto height = [&](const CellCorner& corner, double end) {
            const double value = bisector.height(corner.at);
            return corner.apex == nullptr || std::isnan(value) ? end : value;
        };
        bisector.draw(frame, height(edge.below, -unbounded), height(edge.above, unbounded), drawn);
    });
    return drawn;
}

}  // namespace signum
