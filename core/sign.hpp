#pragma once
/// The sign of a number: what every predicate answers.

namespace signum {

/// -1, 0 or +1.
using Sign = int;

/// The sign of a finite double; 0 for both zeros. Compiles to code without a branch.
[[nodiscard]] constexpr Sign sign_of(double value) noexcept {
    return static_cast<int>(value > 0.0) - static_cast<int>(value < 0.0);
}

}  // namespace signum
