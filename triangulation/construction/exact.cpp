#include "constructions.hpp"

namespace signum::triangulation {

Tessellation construct_exactly(Metric metric, const StridedSites& input, const Options& options) {
    return construct_directly<Arithmetic::exact>(metric, input, options);
}

}  // namespace signum::triangulation
