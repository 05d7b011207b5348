#include "validate.hpp"

#include "../exact/floating_environment.hpp"
#include "check/additive_check.hpp"
#include "check/power_check.hpp"
#include "kernels/predicates_of.hpp"

namespace signum {
namespace {

using namespace triangulation;

/// Discs of one radius are ordered about every point as equal weights are, ties too: predicates of
/// half the degree tell.
Validation check(Euclidean, const TessellationArrays& arrays, const StridedSites& sites,
                 const ValidationOptions& options) {
    if (equal_radii(sites)) return PowerCheck<power::Site>(arrays, sites, options).run();
    return AdditiveCheck<euclidean::Perturbed<Arithmetic::judging>, EuclideanDistance>(
               arrays, sites, options)
        .run();
}
Validation check(Manhattan, const TessellationArrays& arrays, const StridedSites& sites,
                 const ValidationOptions& options) {
    return AdditiveCheck<manhattan::Perturbed<Arithmetic::judging>, ManhattanDistance>(
               arrays, sites, options)
        .run();
}
Validation check(Supremum, const TessellationArrays& arrays, const StridedSites& sites,
                 const ValidationOptions& options) {
    return AdditiveCheck<supremum::Perturbed<Arithmetic::judging>, SupremumDistance>(arrays, sites,
                                                                                     options)
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
    if (sites.third_is_weight() && !traits_of(arrays.metric).has_weights)
        return invalid(no_weights(arrays.metric));
    return with_metric(arrays.metric,
                       [&](auto metric) { return check(metric, arrays, sites, options); });
}

}  // namespace signum
