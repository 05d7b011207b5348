#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace signum {
namespace {

double euclidean_norm(Point v) {
    return std::hypot(v.x, v.y);
}
double manhattan_norm(Point v) {
    return std::abs(v.x) + std::abs(v.y);
}
double supremum_norm(Point v) {
    return std::max(std::abs(v.x), std::abs(v.y));
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

/// An outline and the norm in which it is one.
struct Unit {
    Outline outline;
    double (*norm)(Point vector);
};

Unit unit_in(Power /*metric*/) {
    return {disc_outline(), euclidean_norm};
}
Unit unit_in(Euclidean /*metric*/) {
    return {disc_outline(), euclidean_norm};
}
Unit unit_in(Manhattan /*metric*/) {
    return {diamond_outline(), manhattan_norm};
}
Unit unit_in(Supremum /*metric*/) {
    return {square_outline(), supremum_norm};
}

}  // namespace

const Shapes& shapes_of(Metric metric) noexcept {
    return with_metric(metric, []<class M>(M each) -> const Shapes& {
        static const std::string cells = std::string(M::traits.title) + " cells";
        static const Shapes shapes = {M::traits.site, cells, unit_in(each).outline,
                                      unit_in(each).norm,
                                      M::traits.has_weights ? power_radius : additive_radius};
        return shapes;
    });
}

}  // namespace signum
