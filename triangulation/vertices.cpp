#include "vertices.hpp"

#include <array>
#include <limits>

#include "../exact/floating_environment.hpp"
#include "kernels/predicates_of.hpp"
#include "vertices/vertex_of_face.hpp"

namespace signum {
namespace triangulation {

DiagramVertex no_vertex() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

namespace {

using Sites = std::array<const Site*, 3>;

template <class S>
DiagramVertex vertex_in(PowerPredicates<S> metric, const Sites& sites, const Face& /*face*/) {
    const auto& [i, j, k] = sites;
    return power_vertex(metric.site(*i), metric.site(*j), metric.site(*k));
}

DiagramVertex vertex_in(PredicatesOf<Euclidean> /*metric*/, const Sites& sites,
                        const Face& /*face*/) {
    const auto& [i, j, k] = sites;
    return euclidean_vertex(*i, *j, *k);
}

template <class Directions>
DiagramVertex vertex_in(RectangularPredicates<Directions> /*metric*/, const Sites& sites,
                        const Face& face) {
    const auto& [i, j, k] = sites;
    return rectangular_vertex<Directions>(*i, *j, *k, additive::ranks_of<3>(sites, face));
}

}  // namespace
}  // namespace triangulation

std::vector<DiagramVertex> vertices(const Tessellation& tessellation) {
    const exact::IeeeEnvironment environment;
    return triangulation::with_predicates(
        tessellation.metric(), tessellation.weight_is(), [&](auto metric) {
            std::vector<DiagramVertex> result;
            result.reserve(tessellation.faces().size());
            for (const Face& face : tessellation.faces()) {
                const auto site = [&](std::size_t m) {
                    return &tessellation.sites()[static_cast<std::size_t>(face[m])];
                };
                result.push_back(
                    face[0] == infinite
                        ? triangulation::no_vertex()
                        : triangulation::vertex_in(metric, {site(0), site(1), site(2)}, face));
            }
            return result;
        });
}

}  // namespace signum
