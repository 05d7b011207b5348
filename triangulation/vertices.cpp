#include "vertices.hpp"

#include <limits>

#include "../exact/floating_environment.hpp"
#include "../predicates/additive.hpp"
#include "../predicates/rectangular/forms.hpp"
#include "vertices/vertex_of_face.hpp"

namespace signum {
namespace triangulation {

DiagramVertex no_vertex() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

namespace {

DiagramVertex vertex_of(const Tessellation& t, const Face& face) {
    const auto site = [&](std::size_t m) -> const Site& {
        return t.sites()[static_cast<std::size_t>(face[m])];
    };
    const Site& i = site(0);
    const Site& j = site(1);
    const Site& k = site(2);
    switch (t.metric()) {
        case Metric::euclidean:
            return euclidean_vertex(i, j, k);
        case Metric::manhattan:
            return rectangular_vertex<rectangular::Manhattan>(
                i, j, k, additive::ranks_of<3>({&i, &j, &k}, face));
        case Metric::supremum:
            return rectangular_vertex<rectangular::Supremum>(
                i, j, k, additive::ranks_of<3>({&i, &j, &k}, face));
        case Metric::power:
            break;
    }
    if (t.weight_is() == WeightIs::radius) return power_vertex(i, j, k);
    const auto weighted = [](const Site& s) { return power::Site{s.x, s.y, s.r}; };
    return power_vertex(weighted(i), weighted(j), weighted(k));
}

}  // namespace
}  // namespace triangulation

std::vector<DiagramVertex> vertices(const Tessellation& tessellation) {
    const exact::IeeeEnvironment environment;
    std::vector<DiagramVertex> result;
    result.reserve(tessellation.faces().size());
    for (const Face& face : tessellation.faces())
        result.push_back(face[0] == infinite ? triangulation::no_vertex()
                                             : triangulation::vertex_of(tessellation, face));
    return result;
}

}  // namespace signum
