#include <signum/triangulation/validate.hpp>

#include <signum/exact/floating_environment.hpp>
#include <signum/predicates/manhattan.hpp>
#include <signum/predicates/supremum.hpp>
#include <signum/triangulation/additive_check.hpp>
#include <signum/triangulation/power_check.hpp>

namespace signum {
namespace {

template <class Directions>
using InRationals = rectangular::Perturbed<Directions, rectangular::Sums::multiprecision>;

}  // namespace

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
    switch (arrays.metric) {
        case Metric::manhattan:
            return AdditiveCheck<InRationals<rectangular::Manhattan>>(arrays, sites).run();
        case Metric::supremum:
            return AdditiveCheck<InRationals<rectangular::Supremum>>(arrays, sites).run();
        case Metric::euclidean:
            return {false, false, "tessellations of the euclidean metric cannot be checked yet"};
        case Metric::power:
            break;
    }
    if (sites.third_is_weight()) return PowerCheck<power::Site>(arrays, sites).run();
    return PowerCheck<Site>(arrays, sites).run();
}

}  // namespace signum
