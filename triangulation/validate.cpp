#include "validate.hpp"

#include "../exact/floating_environment.hpp"
#include "check/additive_check.hpp"
#include "check/power_check.hpp"
#include "kernels/predicates_of.hpp"

namespace signum {
namespace {

using namespace triangulation;

/// Where sites of one radius are ordered about every point as equal weights are, ties too,
/// predicates of half the degree tell.
template <class M>
Validation check(M, const TessellationArrays& arrays, const StridedSites& sites,
                 const ValidationOptions& options) {
    if constexpr (M::traits.is_delaunay_for_equal_radii)
        if (equal_radii(sites)) return PowerCheck<power::Site>(arrays, sites, options).run();
    using Predicates = PredicatesOf<M>;
    return AdditiveCheck<typename Predicates::template Perturbed<Arithmetic::judging>,
                         AdditiveDistance<Predicates>>(arrays, sites, options)
        .run();
}
Validation check(Power, const TessellationArrays& arrays, const StridedSites& sites,
                 const ValidationOptions& options) {
    return sites.third_is_weight() ? PowerCheck<power::Site>(arrays, sites, options).run()
                                   : PowerCheck<Site>(arrays, sites, options).run();
}

Validation invalid(std::string why) {
    Validation result;
    result.message = std::move(why);
    return result;
}

}  // namespace

Validation validate(const TessellationArrays& arrays, StridedSites sites,
                    const ValidationOptions& options) {
    const exact::IeeeEnvironment environment;
    if (sites.third_is_weight() != (arrays.weight_is == WeightIs::weight))
        return invalid("the third numbers of sites are each a " +
                       std::string(name_of(arrays.weight_is)) +
                       " in the tessellation, and not in the input");
    return with_metric(arrays.metric, [&]<class M>(M metric) {
        return sites.third_is_weight() && !M::traits.has_weights
                   ? invalid(no_weights(metric))
                   : check(metric, arrays, sites, options);
    });
}

}  // namespace signum
