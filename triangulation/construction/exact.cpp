#include "constructions.hpp"

namespace signum::triangulation {

Tessellation construct_exactly(Metric metric, const StridedSites& input, const Options& options) {
    return construct_in_parts(metric, input, options, any_levels);
}

Tessellation construct_in_parts(Metric metric, const StridedSites& input, const Options& options,
                                int levels) {
    return construct_directly<Arithmetic::exact>(metric, input, options, levels);
}

// Parts that share no memory insert by these, too (distributed/part.cpp).
namespace {
template <class S>
using OfPower = PowerKernel<SignsOfKnown<S>, filters::NoTally>;
template <class M>
using OfDistance =
    AdditiveKernel<typename PredicatesOf<M>::template Perturbed<>, filters::NoTally>;
}  // namespace
template bool insert_all(Topology&, OfPower<Site>&, std::span<Index>, std::span<Index>,
                         const Watch&);
template bool insert_all(Topology&, OfPower<power::Site>&, std::span<Index>, std::span<Index>,
                         const Watch&);
template bool insert_all(Topology&, OfDistance<Euclidean>&, std::span<Index>, std::span<Index>,
                         const Watch&);
template bool insert_all(Topology&, OfDistance<Manhattan>&, std::span<Index>, std::span<Index>,
                         const Watch&);
template bool insert_all(Topology&, OfDistance<Supremum>&, std::span<Index>, std::span<Index>,
                         const Watch&);

}  // namespace signum::triangulation
