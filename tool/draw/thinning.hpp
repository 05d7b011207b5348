#pragma once
/// Thinning out: what is least goes first.

#include <cstddef>
#include <span>

namespace signum {

/// The size, a multiple of `step`, from which on things are drawn so that at most `limit` of them
/// are; 0 where all are. Equal sizes stay or go together. Precondition: no size is negative.
[[nodiscard]] double smallest_drawn(std::span<const double> sizes, std::size_t limit, double step);

}  // namespace signum
