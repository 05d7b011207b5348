/// Qhull: the convex hull of the lifted points, merged where rounding leaves it in doubt and
/// divided into triangles again.

#include <cstdio>
#include <stdexcept>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "construction.hpp"

namespace signum::benchmarks {
namespace {

struct Hull {
    Hull() { qh_zero(&qhull, stderr); }
    Hull(const Hull&) = delete;
    Hull& operator=(const Hull&) = delete;
    ~Hull() { qh_freeqhull(&qhull, qh_ALL); }

    qhT qhull;
};

void write(qhT* qh, std::vector<Face>& faces) {
    const facetT* facet = nullptr;
    FORALLfacets {
        if (facet->upperdelaunay || qh_setsize(qh, facet->vertices) != 3) continue;
        Face triangle;
        for (int k = 0; k < 3; ++k) {
            const auto* vertex = static_cast<vertexT*>(facet->vertices->e[k].p);
            triangle[static_cast<std::size_t>(k)] = qh_pointid(qh, vertex->point);
        }
        faces.push_back(triangle);
    }
}

}  // namespace

Construction prepare_qhull(const std::vector<Site>& sites) {
    std::vector<double> coordinates;
    for (const Site& site : sites) coordinates.insert(coordinates.end(), {site.x, site.y});
    return [coordinates]() mutable {
        const auto hull = std::make_shared<Hull>();
        char options[] = "qhull d Qt Qbb Qc Qz Q12";
        if (qh_new_qhull(&hull->qhull, 2, static_cast<int>(coordinates.size() / 2),
                         coordinates.data(), False, options, nullptr, stderr) != 0)
            throw std::runtime_error("qhull gave up");
        return Built{0, hull, [&of = hull->qhull](std::vector<Face>& faces, auto& /*neighbours*/) {
                         write(&of, faces);
                     }};
    };
}

}  // namespace signum::benchmarks
