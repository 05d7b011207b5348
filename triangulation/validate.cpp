#include "validate.hpp"

#include "../exact/floating_environment.hpp"
#include "check/additive_check.hpp"
#include "check/power_check.hpp"
#include "kernels/predicates_of.hpp"

namespace signum {
Validation validate(const TessellationArrays& arrays, StridedSites sites) {
    using namespace triangulation;
    const exact::IeeeEnvironment environment;
    if (sites.third_is_weight() != (arrays.weight_is == WeightIs::weight))
        return {false, false,
                "the tessellation takes the third numbers of sites for " +
                    std::string(name_of(arrays.weight_is)) + "s, the input does not"};
    if (sites.third_is_weight() && !traits_of(arrays.metric).has_weights)
        return {false, false, no_weights(arrays.metric)};
    return with_metric(arrays.metric, [&]<class M>(M) {
        if constexpr (M::traits.edges_are_straight) {
            if (sites.third_is_weight()) return PowerCheck<power::Site>(arrays, sites).run();
            return PowerCheck<Site>(arrays, sites).run();
        } else {
            using Predicates =
                typename PredicatesOf<M>::template Perturbed<Arithmetic::multiprecision>;
            return AdditiveCheck<Predicates>(arrays, sites).run();
        }
    });
}

}  // namespace signum
