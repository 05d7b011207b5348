#include "constructions.hpp"

namespace signum::triangulation {

template Tessellation construct<Arithmetic::naive>(Metric, const StridedSites&, const Options&);
template Tessellation construct<Arithmetic::single>(Metric, const StridedSites&, const Options&);

}  // namespace signum::triangulation
