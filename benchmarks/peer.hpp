#pragma once
/// The peers of the benchmarks, each a way from sites to a construction.

#include <memory>
#include <utility>
#include <vector>

#include "../core/site.hpp"
#include "../triangulation/tessellation.hpp"

#include "construction.hpp"

namespace signum::benchmarks {

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
