#pragma once
/// Certifies a power tessellation in one to six dimensions from scratch, whoever made it.

#include <span>

#include "../validate.hpp"
#include "triangulate.hpp"

namespace signum {

/// As validate() in triangulation/space/validate.hpp; D = 1, ..., 6.
template <int D>
[[nodiscard]] Validation validate(const TessellationOf<D>& tessellation,
                                  std::span<const power::SiteOf<D>> sites,
                                  const ValidationOptions& options = {});

}  // namespace signum
