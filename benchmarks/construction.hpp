#pragma once
/// A contestant of the benchmarks of whole constructions: something that builds a triangulation of
/// given sites, whoever wrote it; and the peers that are one.

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "../core/site.hpp"
#include "../triangulation/tessellation.hpp"

namespace signum::benchmarks {

/// What was built. The triangulation lives as long as this, so that its end is not timed.
struct Built {
    std::int64_t visible = 0;
    std::shared_ptr<void> triangulation;
    /// For peers of the plane, as long as the construction is there: the faces, in any order,
    /// counterclockwise, those at infinity included; or the finite ones alone, in any orientation.
    /// Neighbours where two sites can share several edges.
    std::function<void(std::vector<Face>& faces, std::vector<Face>& neighbours)> write;
};

/// Builds the triangulation of the sites that it was made for, which it has in types of its own,
/// from scratch.
using Construction = std::function<Built()>;

/// A Tessellation as what a construction has built.
[[nodiscard]] inline Built built(Tessellation tessellation) {
    const auto made = std::make_shared<Tessellation>(std::move(tessellation));
    return {static_cast<std::int64_t>(made->sites().size() - made->hidden().size()), made,
            [&of = *made](std::vector<Face>& faces, std::vector<Face>& neighbours) {
                faces.assign(of.faces().begin(), of.faces().end());
                neighbours.assign(of.neighbours().begin(), of.neighbours().end());
            }};
}

using Prepare = std::function<Construction(const std::vector<Site>&)>;

/// signum's insertion on Shewchuk's predicates, as TetGen's library has them: Delaunay.
[[nodiscard]] Construction prepare_shewchuk(const std::vector<Site>& sites);
/// Qhull's library with the options of SciPy's Delaunay.
[[nodiscard]] Construction prepare_qhull(const std::vector<Site>& sites);

}  // namespace signum::benchmarks
