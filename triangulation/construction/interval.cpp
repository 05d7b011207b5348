#include "constructions.hpp"

namespace signum::triangulation {

template Tessellation construct<Arithmetic::interval>(Metric, const StridedSites&, const Options&);

}  // namespace signum::triangulation
