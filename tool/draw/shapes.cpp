#include "shapes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace signum {
namespace {

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

const Shapes& shapes_of(Metric metric) noexcept {
    return with_metric(metric, []<class M>(M each) -> const Shapes& {
        static const std::string cells = std::string(M::traits.title) + " cells";
        static const Shapes shapes = {M::traits.site, cells, outline_in(each),
                                      M::traits.has_weights ? power_radius : additive_radius};
        return shapes;
    });
}

}  // namespace signum
