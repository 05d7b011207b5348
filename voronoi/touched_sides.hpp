#pragma once
/// Which of two sites a square between them touches on which side: what the shape of their bisector
/// in the supremum and Manhattan metrics depends on, beyond coordinates.

#include <array>

#include "../triangulation/tessellation.hpp"

namespace signum {

/// For the right, top, left and bottom side of a square (Manhattan: the sides towards rising
/// u = x + y, v = y - x, falling u, v) whether b touches it first, and not a, as squares shrink
/// onto the two. Exact, by the tie rule where both do. The metric is one of the two.
[[nodiscard]] std::array<bool, 4> sides_touched_by_second(Metric metric, const Site& a,
                                                          Index a_index, const Site& b,
                                                          Index b_index);

}  // namespace signum
