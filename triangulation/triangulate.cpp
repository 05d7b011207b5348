#include "triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "../exact/floating_environment.hpp"
#include "construction/construct.hpp"

namespace signum {
namespace triangulation {
namespace {

void check_sites(const StridedSites& sites, const Options& options) {
    if (sites.size() > static_cast<std::size_t>(max_sites))
        throw std::invalid_argument("too many sites: " + std::to_string(sites.size()) +
                                    ", the limit is " + std::to_string(max_sites));
    const bool single = options.arithmetic == Arithmetic::single;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Site site = sites[i];
        if (!std::isfinite(site.x) || !std::isfinite(site.y) || !std::isfinite(site.r))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
        if (single && std::max({std::fabs(site.x), std::fabs(site.y), std::fabs(site.r)}) >
                          std::numeric_limits<float>::max())
            throw std::invalid_argument("site " + std::to_string(i) +
                                        " is beyond single precision, 3.4e38");
    }
}

void check_method(const StridedSites& sites, Metric metric, const Options& options) {
    if (!builds(options.method, metric))
        throw std::invalid_argument("the method " + std::string(name_of(options.method)) +
                                    " does not build tessellations of the " +
                                    std::string(traits_of(metric).title) + " metric");
    if (options.method == Method::flips && options.arithmetic != Arithmetic::exact)
        throw std::invalid_argument("flips have exact arithmetic alone");
    if (sites.third_is_weight() && !traits_of(metric).has_weights)
        throw std::invalid_argument(no_weights(metric));
}

}  // namespace

Tessellation construct(Metric metric, const StridedSites& input, const Options& options) {
    if (options.count) return construct_in_any_arithmetic(metric, input, options);
    if (options.arithmetic == Arithmetic::exact) return construct_exactly(metric, input, options);
    if (!is_exact(options.arithmetic)) return construct_rounded(metric, input, options);
    return construct_in_any_arithmetic(metric, input, options);
}

}  // namespace triangulation

FlipOutcome flip_from_delaunay(StridedSites sites, const Options& options) {
    const exact::IeeeEnvironment environment;
    triangulation::check_sites(sites, {});
    FlipOutcome outcome;
    outcome.tessellation = triangulation::construct_by_flips(sites, options, &outcome.obstruction);
    return outcome;
}

Tessellation triangulate(StridedSites sites, Metric metric, const Options& options) {
    using namespace triangulation;
    // Comparisons, and the speed of the filters, want denormals kept; the predicates would be right
    // without.
    const exact::IeeeEnvironment environment;
    check_sites(sites, options);
    check_method(sites, metric, options);
    if (options.method == Method::flips && !equal_weights(sites))
        return construct_by_flips(sites, options);
    return construct(metric, sites, options);
}

}  // namespace signum
