#pragma once
/// Numbers for oracles that multiply by small factors alone: integers of the processor, or any.

#include <cstdint>
#include <type_traits>

#include "integer.hpp"
#include "scaled.hpp"

namespace signum::fuzz {

/// For numbers that span this many bits at most: an oracle adds fewer than the rest.
using Narrow = __int128;
inline constexpr int narrow_bits = 118;

/// The number in units of 2^(unit - extra).
template <class Number>
[[nodiscard]] Number number_of(const Digits& digits, int unit, int extra) {
    if (digits.significand == 0) return Number(0);
    const auto bits = static_cast<std::uint64_t>(digits.exponent - unit + extra);
    if constexpr (std::is_same_v<Number, Integer>)
        return Integer(digits.significand, bits);
    else
        return static_cast<Narrow>(static_cast<unsigned __int128>(Narrow{digits.significand})
                                   << bits);
}

}  // namespace signum::fuzz
