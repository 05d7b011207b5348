#include "constructions.hpp"

namespace signum::triangulation {

template Tessellation construct<Arithmetic::sum>(Metric, const StridedSites&, const Options&);

}  // namespace signum::triangulation
