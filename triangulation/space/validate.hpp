#pragma once
/// Certifies a power tessellation of space from scratch, whoever made it. Signs are believed where
/// a floating-point filter proves them, otherwise in exact numbers that are the judge's own; the
/// stages that constructions have behind the filters are never asked.

#include <span>

#include "../../core/site.hpp"
#include "../validate.hpp"
#include "triangulate.hpp"

namespace signum {

/// Checks that the arrays are a power tessellation of the sites: the dimension that their centres
/// span, neighbours that agree, every cell's orientation, a convex hull that winds once, no site in
/// conflict with a cell, every hidden site truly hidden and nearest to the site it names. The
/// arrays may hold any numbers, and cells be in any order and turned in any way that keeps their
/// orientation (flat ones in any way): canonical are only those as the laws of a SpaceTessellation
/// say. Messages name cells and sites by their numbers. Throws std::invalid_argument for a site
/// that is not finite; Stopped where options.stop asks for it.
///
/// O(n) for n cells and, where sites are hidden, O(n log n) for a tree of the visible ones; for
/// each hidden site the visible ones that may be as near to it as the one it names, and the way to
/// it from that one. Source: the head of any_dimension/check.hpp.
[[nodiscard]] Validation validate(const SpaceTessellation& tessellation,
                                  std::span<const Point3> sites,
                                  const ValidationOptions& options = {});
/// The same of balls.
[[nodiscard]] Validation validate(const SpaceTessellation& tessellation,
                                  std::span<const Site3> sites,
                                  const ValidationOptions& options = {});
/// The same of sites with weights.
[[nodiscard]] Validation validate(const SpaceTessellation& tessellation,
                                  std::span<const power::Site3> sites,
                                  const ValidationOptions& options = {});

}  // namespace signum
