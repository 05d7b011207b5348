#include "constructions.hpp"

namespace signum::triangulation {

template Tessellation construct<Arithmetic::multiprecision>(Metric, const StridedSites&,
                                                            const Options&);

}  // namespace signum::triangulation
