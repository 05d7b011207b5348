/// Qhull: the convex hull of the lifted points, merged where rounding leaves it in doubt and
/// divided into triangles again.

#include <cstdio>
#include <stdexcept>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "peer.hpp"

namespace signum::benchmarks {
namespace {

class Qhull : public Attempt {
 public:
    explicit Qhull(const std::vector<Site>& sites) : sites_(sites) {
        for (const Site& site : sites) {
            coordinates_.push_back(site.x);
            coordinates_.push_back(site.y);
        }
        qh_zero(&qhull_, stderr);
    }
    ~Qhull() override { qh_freeqhull(&qhull_, qh_ALL); }

    void build() override {
        char options[] = "qhull d Qt Qbb Qc Qz Q12";
        if (qh_new_qhull(&qhull_, 2, static_cast<int>(sites_.size()), coordinates_.data(), False,
                         options, nullptr, stderr) != 0)
            throw std::runtime_error("qhull gave up");
    }

    void write(std::vector<Face>& faces, std::vector<Face>& /*neighbours*/) const override {
        qhT* const qh = const_cast<qhT*>(&qhull_);  // the macros below read through qh
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

 private:
    std::vector<Site> sites_;
    std::vector<double> coordinates_;
    qhT qhull_;
};

}  // namespace

std::unique_ptr<Attempt> prepare_qhull(const std::vector<Site>& sites) {
    return std::make_unique<Qhull>(sites);
}

}  // namespace signum::benchmarks
