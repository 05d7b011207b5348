#pragma once
/// Cells of one size in a box, a list of balls for each (thesis 9.4): 3^D cells are asked at a
/// strike, 3^(D-1) where a centre enters a cell. Why nothing is missed: grid.hpp, with one level.

#include "grid.hpp"

namespace signum::motion {

template <int D>
class CellsOfOneSize : public Grid<D> {
 public:
    explicit CellsOfOneSize(const World<D>& world) : Grid<D>(world, 1, false) {}
};

}  // namespace signum::motion
