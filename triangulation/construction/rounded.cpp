#include "constructions.hpp"

namespace signum::triangulation {

Tessellation construct_rounded(Metric metric, const StridedSites& input, const Options& options) {
    return options.arithmetic == Arithmetic::naive
               ? construct_directly<Arithmetic::naive>(metric, input, options)
               : construct_directly<Arithmetic::single>(metric, input, options);
}

}  // namespace signum::triangulation
