#pragma once
/// A part of a tessellation of space. For sources only.

#include <memory>

#include "part.hpp"

namespace signum::distributed {

[[nodiscard]] std::unique_ptr<Part> make_part_of_space(const Kind& kind);

}  // namespace signum::distributed
