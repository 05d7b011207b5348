#include "constructions.hpp"

namespace signum::triangulation {

Tessellation construct_exactly(Metric metric, const StridedSites& input, const Options& options) {
    return with_tally(options, [&]<class Tally>() {
        return construct_directly<Arithmetic::exact, Tally>(metric, input, options);
    });
}

}  // namespace signum::triangulation
