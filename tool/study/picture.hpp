#pragma once
/// What goes wrong, as a picture: for who reads on.

#include "template.hpp"

namespace signum::study {

/// The tessellation of sites on a circle as single precision makes it, its wrong edges thick: the
/// address of the `picture`, and how many `sites`, `edges` and `wrong` edges it has.
[[nodiscard]] Values wrong_picture();

}  // namespace signum::study
