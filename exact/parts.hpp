#pragma once
/// Doubles taken apart by their bits: for sources only.

#include <bit>
#include <cstdint>

#include "../core/contract.hpp"

namespace signum::exact {

/// ±significand · 2^exponent; the significand is odd, or 0.
struct Parts {
    std::uint64_t significand;
    int exponent;
    bool negative;
};

/// Of a double, by its bits: no floating-point operation, no environment. Precondition: value is
/// finite.
[[nodiscard]] inline Parts parts(double value) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const int biased = static_cast<int>(bits >> 52 & 0x7FF);
    SIGNUM_EXPECTS(biased != 0x7FF);
    const std::uint64_t significand = fraction | std::uint64_t{biased != 0} << 52;
    if (significand == 0) return {0, 0, false};
    const int zeros = std::countr_zero(significand);
    return {significand >> zeros, (biased == 0 ? 1 : biased) - 1075 + zeros, bits >> 63 != 0};
}

}  // namespace signum::exact
