#pragma once
/// Equal radii: where all are the same the Euclidean metric orders sites as Delaunay does, and the
/// predicates of points, of lower degree, decide.

#include <signum/filters/bounds.hpp>

namespace signum::euclidean {

/// Whether all radii are the same number.
template <class S, class... Others>
[[nodiscard]] inline bool same_radius(const S& first, const Others&... others) noexcept {
    return (filters::same_number(first.r, others.r) && ...);
}

}  // namespace signum::euclidean
