#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace signum {
namespace {

/// Unit vectors: a disc is cut by tangents.
std::vector<Point> normals_of_disc(Point towards, double angle) {
    constexpr int sides = 64;
    const double middle = std::atan2(towards.y, towards.x);
    std::vector<Point> normals;
    for (int i = 0; i <= sides; ++i) {
        const double direction = middle + angle * (2.0 * i / sides - 1);
        normals.push_back({std::cos(direction), std::sin(direction)});
    }
    return normals;
}

std::vector<Point> normals_of_square(Point /*towards*/, double /*angle*/) {
    return {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
}

std::vector<Point> normals_of_diamond(Point /*towards*/, double /*angle*/) {
    return {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
}

double power_radius(const Site& site, WeightIs weight_is) {
    if (weight_is == WeightIs::radius)
        return std::abs(site.r);  // the weight is r², whatever its sign
    return site.r > 0 ? std::sqrt(site.r) : 0.0;
}
// Only differences of radii count in the additive metrics; those above 0 are drawn as they are.
double additive_radius(const Site& site, WeightIs /*weight_is*/) {
    return std::max(site.r, 0.0);
}

Outline outline_in(Power /*metric*/) {
    return disc_outline();
}
Outline outline_in(Euclidean /*metric*/) {
    return disc_outline();
}
Outline outline_in(Manhattan /*metric*/) {
    return diamond_outline();
}
Outline outline_in(Supremum /*metric*/) {
    return square_outline();
}

}  // namespace

Outline disc_outline() noexcept {
    return {"circle",
            [](SvgText& text, Point centre, double radius) {
                text.add(R"(cx="{}" cy="{}" r="{}")", Px{centre.x}, Px{centre.y}, Px{radius});
            },
            [](Point v) { return std::hypot(v.x, v.y); }, normals_of_disc};
}

Outline square_outline() noexcept {
    return {"rect",
            [](SvgText& text, Point centre, double radius) {
                text.add(R"(x="{0}" y="{1}" width="{2}" height="{2}")", Px{centre.x - radius},
                         Px{centre.y - radius}, Px{2 * radius});
            },
            [](Point v) { return std::max(std::abs(v.x), std::abs(v.y)); }, normals_of_square};
}

Outline diamond_outline() noexcept {
    return {"polygon",
            [](SvgText& text, Point centre, double radius) {
                text.add(R"(points="{0},{1} {2},{3} {0},{4} {5},{3}")", Px{centre.x},
                         Px{centre.y - radius}, Px{centre.x + radius}, Px{centre.y},
                         Px{centre.y + radius}, Px{centre.x - radius});
            },
            [](Point v) { return std::abs(v.x) + std::abs(v.y); }, normals_of_diamond};
}

const Shapes& shapes_of(Metric metric) noexcept {
    return with_metric(metric, []<class M>(M each) -> const Shapes& {
        static const std::string cells = std::string(M::traits.title) + " cells";
        static const Shapes shapes = {M::traits.site, cells, outline_in(each),
                                      M::traits.has_weights ? power_radius : additive_radius};
        return shapes;
    });
}

std::vector<Point> part_inside(const Outline& outline, Point centre, double radius,
                               const Box& box) {
    const Point middle = {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
    const Point towards = {middle.x - centre.x, middle.y - centre.y};
    const double half_diagonal = std::hypot(box.x1 - middle.x, box.y1 - middle.y);
    const double distance = std::hypot(towards.x, towards.y);
    // From within so large an outline the whole box is.
    const double angle = std::asin(std::min(1.0, half_diagonal / distance));
    std::vector<Point> polygon = {
        {box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
    for (const Point& n : outline.normals(towards, angle)) {
        const double inside = radius - (n.x * towards.x + n.y * towards.y);  // at the middle
        const auto excess = [&](Point p) {
            return n.x * (p.x - middle.x) + n.y * (p.y - middle.y) - inside;
        };
        std::vector<Point> left;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point from = polygon[i];
            const Point to = polygon[(i + 1) % polygon.size()];
            const double before = excess(from);
            const double behind = excess(to);
            if (before <= 0) left.push_back(from);
            if ((before <= 0) == (behind <= 0)) continue;
            const double s = before / (before - behind);
            left.push_back({from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)});
        }
        polygon = std::move(left);
    }
    return polygon;
}

}  // namespace signum
