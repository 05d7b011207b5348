#pragma once
/// The walls of a scene as pictures show them.

#include <vector>

#include "../../motion/effects.hpp"
#include "../draw/movie.hpp"

namespace signum {

/// Obstacles, and the sides of a box that shakes; those of a box at rest are the picture's frame. A
/// half-space is a line far beyond what is shown; in space, which is seen along z, there are only
/// those that stand upright on the picture. O(obstacles).
template <int D>
[[nodiscard]] std::vector<Movie::Wall> drawn_walls(const motion::Effects<D>& effects,
                                                   const motion::Box<D>& shown);

}  // namespace signum
