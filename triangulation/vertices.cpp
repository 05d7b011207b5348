#include "vertices.hpp"

#include <limits>

#include "../core/parallel.hpp"
#include "../exact/floating_environment.hpp"
#include "vertices/vertex_of_face.hpp"

namespace signum {
namespace triangulation {

DiagramVertex no_vertex() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan};
}

}  // namespace triangulation

std::vector<DiagramVertex> vertices(const Tessellation& tessellation, int threads) {
    const auto faces = tessellation.faces();
    const Workers workers(threads, faces.size());
    std::vector<DiagramVertex> result;
    make_room(workers, faces.size(), result);
    with_metric(tessellation.metric(), [&]<class M>(M) {
        workers.each_range(faces.size(), [&](std::size_t begin, std::size_t end) {
            const exact::IeeeEnvironment environment;
            for (std::size_t f = begin; f < end; ++f) {
                const Face& face = faces[f];
                const auto site = [&](std::size_t m) {
                    return &tessellation.sites()[static_cast<std::size_t>(face[m])];
                };
                result[f] = face[0] == infinite
                                ? triangulation::no_vertex()
                                : triangulation::vertex_of_face<M>({site(0), site(1), site(2)},
                                                                   face, tessellation.weight_is());
            }
        });
    });
    return result;
}

}  // namespace signum
