#pragma once
/// Cells of several sizes, each a power of two above the next: a large ball does not ruin small
/// ones (thesis 9.4.2, table 10.4.4). Why nothing is missed: grid.hpp.

#include "grid.hpp"

namespace signum::motion {

template <int D>
class Levels : public Grid<D> {
 public:
    explicit Levels(const World<D>& world) : Grid<D>(world, 24, false) {}
};

}  // namespace signum::motion
