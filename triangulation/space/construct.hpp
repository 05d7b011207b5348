#pragma once
/// The construction in space as tests ask for it.

#include <span>

#include "../../predicates/space/in_sphere.hpp"
#include "triangulate.hpp"

namespace signum::spatial {

/// triangulate(), in exact arithmetic in parts, with that many levels of cuts however few the sites
/// are, and fewer for the sites of joins.
template <power::PowerSite3 S>
[[nodiscard]] SpaceTessellation construct_in_parts(std::span<const S> sites, const Options& options,
                                                   int levels);

}  // namespace signum::spatial
