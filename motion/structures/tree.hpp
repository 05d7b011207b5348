#pragma once
/// Cells of one size, of which only the occupied ones are kept (thesis 9.5): no bounds are needed.
/// The thesis keeps them in a search tree; here they are hashed. Why nothing is missed: grid.hpp,
/// with one level.

#include "grid.hpp"

namespace signum::motion {

template <int D>
class OccupiedCells : public Grid<D> {
 public:
    explicit OccupiedCells(const World<D>& world) : Grid<D>(world, 1, true) {}
};

}  // namespace signum::motion
