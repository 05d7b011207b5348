#include <signum/draw/cell_edge.hpp>
#include <signum/draw/euclidean_shapes.hpp>

#include <algorithm>
#include <cmath>

namespace signum::euclidean {
namespace {

constexpr double flat = 0.05;  // pixels from an arc to its chord
constexpr int most_halvings = 40;

/// The bisector of a and b, half of a hyperbola, by its parameter t:
///
///     middle + forward · A cosh t + upward · B sinh t,
///
/// A being half the difference of the radii and A² + B² the square of half the distance. It rises
/// with t, and a lies on its left. At t = 0 it turns: before and after, it is never steeper to its
/// chord than a right angle.
class Hyperbola {
 public:
    Hyperbola(const Frame& frame, const Site& a, const Site& b) : frame_(frame), a_(a) {
        const Point to_b = pixels_between(frame, a, b);
        const double distance = std::hypot(to_b.x, to_b.y);
        forward_ = {to_b.x / distance, to_b.y / distance};
        upward_ = {forward_.y, -forward_.x};  // a quarter turn to the left, where y points down
        middle_ = plus(frame.at({a.x, a.y}), to_b, 0.5);
        slant_ = std::clamp(radius_difference(frame, a, b) / distance, -1.0, 1.0);
        rise_ = std::sqrt((1 - slant_) * (1 + slant_));
        half_ = distance / 2;
        // From this parameter on all is out of the picture.
        const double reach =
            std::hypot(frame.width(), frame.height()) +
            std::hypot(middle_.x - frame.width() / 2, middle_.y - frame.height() / 2);
        end_ = std::asinh(reach / half_);
    }

    /// Sites too close to each other for any direction.
    [[nodiscard]] bool is_lost() const { return !std::isfinite(end_ + forward_.x + rise_); }

    /// The parameter of an end of an edge, within the picture's range.
    [[nodiscard]] double parameter(const CellCorner& corner, bool above) const {
        if (corner.apex == nullptr) return above ? end_ : -end_;
        if (!std::isfinite(corner.at.x) || !std::isfinite(corner.at.y))
            return touches_line_above(*corner.apex) ? end_ : -end_;
        const Point to_corner = minus(corner.at, middle_);
        const double cosh = dot(to_corner, forward_) / (half_ * slant_);
        const double sinh = dot(to_corner, upward_) / (half_ * rise_);
        // The coordinate that changes faster tells the parameter better.
        const bool by_cosh = std::isfinite(cosh) && cosh > 1 &&
                             std::abs(slant_) * std::sqrt((cosh - 1) * (cosh + 1)) > rise_ * cosh;
        const double t = by_cosh ? std::copysign(std::acosh(cosh), sinh) : std::asinh(sinh);
        return std::clamp(t, -end_, end_);
    }

    void draw(double from, double to, std::vector<Segment>& drawn) const {
        if (from < 0 && 0 < to) {
            draw(from, 0, drawn);
            draw(0, to, drawn);
        } else if (from < to) {
            draw(from, point(from), to, point(to), most_halvings, drawn);
        }
    }

 private:
    [[nodiscard]] Point point(double t) const {
        return plus(plus(middle_, forward_, half_ * slant_ * std::cosh(t)), upward_,
                    half_ * rise_ * std::sinh(t));
    }

    /// A vertex at infinity, where a common tangent line touches the three: whether the line is the
    /// upper one.
    [[nodiscard]] bool touches_line_above(const Site& apex) const {
        const Point to_apex = pixels_between(frame_, a_, apex);
        const double excess = slant_ * dot(to_apex, forward_) - radius_difference(frame_, a_, apex);
        const double height = rise_ * dot(to_apex, upward_);
        return std::abs(excess + height) < std::abs(excess - height);
    }

    /// Halfway in t the arc is parallel to its chord and farthest from it.
    void draw(double from, Point start, double to, Point end, int halvings,
              std::vector<Segment>& drawn) const {
        const double half = from + (to - from) / 2;
        const Point middle = point(half);
        const Point chord = minus(end, start);
        const Point off = minus(middle, start);
        const double length = std::hypot(chord.x, chord.y);
        const double bulge =
            length > 0 ? std::abs(off.x * chord.y - off.y * chord.x) / length : 0.0;
        const auto misses = [&](double one, double other, double size) {
            return std::max(one, other) + bulge < 0 || std::min(one, other) - bulge > size;
        };
        if (misses(start.x, end.x, frame_.width()) || misses(start.y, end.y, frame_.height()))
            return;
        if (bulge <= flat || halvings == 0) {
            if (const auto segment = frame_.clip(start, chord, 0, 1)) drawn.push_back(*segment);
            return;
        }
        draw(from, start, half, middle, halvings - 1, drawn);
        draw(half, middle, to, end, halvings - 1, drawn);
    }

    const Frame& frame_;
    const Site& a_;
    Point forward_;
    Point upward_;
    Point middle_;
    double slant_;  // A in units of half the distance
    double rise_;   // B
    double half_;
    double end_;
};

}  // namespace

std::vector<Segment> cell_edges(const Tessellation& tessellation, const Frame& frame) {
    std::vector<Segment> drawn;
    for_each_cell_edge(tessellation, frame, [&](const CellEdge& edge) {
        const auto site = [&](Index i) -> const Site& {
            return tessellation.sites()[static_cast<std::size_t>(i)];
        };
        const Hyperbola hyperbola(frame, site(edge.a), site(edge.b));
        if (hyperbola.is_lost()) return;
        hyperbola.draw(hyperbola.parameter(edge.below, false),
                       hyperbola.parameter(edge.above, true), drawn);
    });
    return drawn;
}

}  // namespace signum::euclidean
