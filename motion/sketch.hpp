#pragma once
/// What a structure and the loop over it have sketched of themselves, as it is shown.

#include <cstdint>
#include <span>

#include "ball.hpp"
#include "simulation.hpp"

namespace signum::motion {

/// Two that are linked; slots stand for numbers until all is put in order.
template <int D>
void link(Sketch<D>& sketch, Slot i, Slot j) {
    if (i < j)
        sketch.links.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
}

/// From slots to the numbers of their balls, into the box, in order, and each cell once. Walls keep
/// their numbers.
template <int D>
void put_in_order(Sketch<D>& sketch, std::span<const std::int32_t> numbers,
                  const Effects<D>& effects);

}  // namespace signum::motion
