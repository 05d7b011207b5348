#pragma once
/// ESSA, the exact sign of a sum (Ratschek and Rokne): no rounding, no overflow, no underflow.

#include <cstddef>
#include <span>

#include <signum/core/sign.hpp>

namespace signum {

/// The exact sign of terms[0] + terms[1] + ... for any finite doubles and any number of terms.
/// Does not allocate below 64 terms. Any rounding mode, denormals flushed or not.
[[nodiscard]] Sign sign_of_sum(std::span<const double> terms) noexcept;

}  // namespace signum
