#include "constructions.hpp"

namespace signum::triangulation {

template Tessellation construct<Arithmetic::exact>(Metric, const StridedSites&, const Options&);

}  // namespace signum::triangulation
