#pragma once
/// Constructions of checked sites, by methods and arithmetics: what triangulate() chooses from.

#include <cmath>
#include <optional>

#include "../../core/strided_sites.hpp"
#include "../options.hpp"
#include "../tessellation.hpp"

namespace signum::triangulation {

/// The same weight everywhere: ordinary Delaunay, which needs no weights at all.
inline bool equal_weights(const StridedSites& sites) noexcept {
    for (std::size_t i = 1; i < sites.size(); ++i) {
        const double first = sites[0].r;
        const double other = sites[i].r;
        if (sites.third_is_weight() ? first != other : std::fabs(first) != std::fabs(other))
            return false;
    }
    return true;
}

/// By insertion or the sweep, in options.arithmetic. The single one rounds the sites to floats,
/// which must be finite; the tessellation is still one of the sites given.
[[nodiscard]] Tessellation construct(Metric metric, const StridedSites& input,
                                     const Options& options);
/// The same in the exact arithmetic, and in the two that round, without a count; and in any, which
/// always counts.
[[nodiscard]] Tessellation construct_exactly(Metric metric, const StridedSites& input,
                                             const Options& options);
/// The exact one in parts, with that many levels of cuts however few the sites are: for tests.
[[nodiscard]] Tessellation construct_in_parts(Metric metric, const StridedSites& input,
                                              const Options& options, int levels);
[[nodiscard]] Tessellation construct_rounded(Metric metric, const StridedSites& input,
                                             const Options& options);
[[nodiscard]] Tessellation construct_in_any_arithmetic(Metric metric, const StridedSites& input,
                                                       const Options& options);

/// The power tessellation by flips, in exact arithmetic. `obstruction` is where to report the edge
/// that could not be flipped in the order of discovery; without it the order is that of time.
[[nodiscard]] Tessellation construct_by_flips(const StridedSites& input, const Options& options,
                                              std::optional<Edge>* obstruction = nullptr);

}  // namespace signum::triangulation
