#include "shapes.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

const Shapes& shapes_of(Metric metric) noexcept {
    static const Shapes power_shapes = {"disc", "power cells", disc_outline(), power_radius};
    static const Shapes euclidean_shapes = {"disc", "Euclidean cells", disc_outline(),
                                            additive_radius};
    static const Shapes manhattan_shapes = {"diamond", "Manhattan cells", diamond_outline(),
                                            additive_radius};
    static const Shapes supremum_shapes = {"square", "supremum cells", square_outline(),
                                           additive_radius};
    switch (metric) {
        case Metric::euclidean:
            return euclidean_shapes;
        case Metric::manhattan:
            return manhattan_shapes;
        case Metric::supremum:
            return supremum_shapes;
        case Metric::power:
            break;
    }
    return power_shapes;
}

}  // namespace signum
