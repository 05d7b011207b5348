#include "validate.hpp"

#include "../exact/floating_environment.hpp"
#include "../predicates/euclidean.hpp"
#include "../predicates/manhattan.hpp"
#include "../predicates/supremum.hpp"
#include "check/additive_check.hpp"
#include "check/power_check.hpp"

namespace signum {
Validation validate(const TessellationArrays& arrays, StridedSites sites) {
    using namespace triangulation;
    const exact::IeeeEnvironment environment;
    if (sites.third_is_weight() != (arrays.weight_is == WeightIs::weight))
        return {false, false,
                "the tessellation takes the third numbers of sites for " +
                    std::string(name_of(arrays.weight_is)) + "s, the input does not"};
    if (arrays.metric != Metric::power && sites.third_is_weight())
        return {false, false,
                "sites of the " + std::string(name_of(arrays.metric)) +
                    " metric have radii, not weights"};
    constexpr auto in_rationals = Arithmetic::multiprecision;
    switch (arrays.metric) {
        case Metric::manhattan:
            return AdditiveCheck<manhattan::Perturbed<in_rationals>>(arrays, sites).run();
        case Metric::supremum:
            return AdditiveCheck<supremum::Perturbed<in_rationals>>(arrays, sites).run();
        case Metric::euclidean:
            return AdditiveCheck<euclidean::Perturbed<in_rationals>>(arrays, sites).run();
        case Metric::power:
            break;
    }
    if (sites.third_is_weight()) return PowerCheck<power::Site>(arrays, sites).run();
    return PowerCheck<Site>(arrays, sites).run();
}

}  // namespace signum
