#pragma once
/// What acts on the balls of a scene: its box, its walls, its effects, and the step of time.

#include "../../motion/effects.hpp"
#include "section.hpp"

namespace signum {

/// Reads [box], [[wall]], [effects] and run.time_step of the file's own section. Throws as
/// Document::fail for whatever is wrong, contradictions between keys included.
template <int D>
[[nodiscard]] motion::Effects<D> read_effects(const Section& file);

/// A box by its keys low and high. Throws as Document::fail.
template <int D>
[[nodiscard]] motion::Box<D> read_box(const Section& section);

}  // namespace signum
