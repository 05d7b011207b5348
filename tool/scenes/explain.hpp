#pragma once
/// What a scene says of itself before it runs: which effects are on and what each needs, and what
/// is left out.

#include <string>
#include <string_view>

#include "scene.hpp"

namespace signum {

/// A table for people, lines of at most a hundred characters or so. `records` says what is written,
/// which not the scene alone tells. O(balls).
template <int D>
[[nodiscard]] std::string explain(const Scene<D>& scene, std::string_view records);

}  // namespace signum
