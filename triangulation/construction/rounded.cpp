#include "constructions.hpp"

namespace signum::triangulation {

// What is measured is not counted: that is left to the pointers of yardsticks.cpp, which would be
// felt here.
Tessellation construct_rounded(Metric metric, const StridedSites& input, const Options& options) {
    return options.arithmetic == Arithmetic::naive
               ? construct_directly<Arithmetic::naive, filters::NoTally>(metric, input, options)
               : construct_directly<Arithmetic::single, filters::NoTally>(metric, input, options);
}

}  // namespace signum::triangulation
