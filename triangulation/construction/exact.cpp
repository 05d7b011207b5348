#include "constructions.hpp"

namespace signum::triangulation {

Tessellation construct_exactly(Metric metric, const StridedSites& input, const Options& options) {
    return construct_in_parts(metric, input, options, any_levels);
}

Tessellation construct_in_parts(Metric metric, const StridedSites& input, const Options& options,
                                int levels) {
    return construct_directly<Arithmetic::exact>(metric, input, options, levels);
}

}  // namespace signum::triangulation
