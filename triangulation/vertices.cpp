#include "vertices.hpp"

#include <limits>

#include "../exact/floating_environment.hpp"
#include "vertices/vertex_of_face.hpp"

namespace signum {
namespace triangulation {

DiagramVertex no_vertex() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

}  // namespace triangulation

std::vector<DiagramVertex> vertices(const Tessellation& tessellation) {
    const exact::IeeeEnvironment environment;
    return with_metric(tessellation.metric(), [&]<class M>(M) {
        std::vector<DiagramVertex> result;
        result.reserve(tessellation.faces().size());
        for (const Face& face : tessellation.faces()) {
            const auto site = [&](std::size_t m) {
                return &tessellation.sites()[static_cast<std::size_t>(face[m])];
            };
            result.push_back(face[0] == infinite ? triangulation::no_vertex()
                                                 : triangulation::vertex_of_face<M>(
                                                       {site(0), site(1), site(2)}, face,
                                                       tessellation.weight_is()));
        }
        return result;
    });
}

}  // namespace signum
