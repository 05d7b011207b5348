#pragma once
/// The targets that build: bytes are sites on a small grid, so that all kinds of ties come, and
/// what is done with them. They look at 600 bytes and no more.

#include "target.hpp"

namespace signum::fuzz {

/// Of each metric the roads of construction agree, whatever the seed, and the result is the
/// canonical one.
void triangulate_target(Bytes bytes);
/// Sites that come, go, change and move one by one or all at once: the tessellation is the one of
/// the sites that are there.
void dynamic_target(Bytes bytes);
/// Sites in flight: the faces do not depend on the way there.
void kinetic_target(Bytes bytes);
/// The power tessellation of space is the canonical one.
void space_target(Bytes bytes);

}  // namespace signum::fuzz
