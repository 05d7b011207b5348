#pragma once
/// Random rounds: which of many items come before which in an order of insertion.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace signum {

/// A well-mixed function of 64 bits (the finalizer of SplitMix64, Steele, Lea and Flood 2014).
[[nodiscard]] inline std::uint64_t mix(std::uint64_t bits) noexcept {
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EBU;
    return bits ^ bits >> 31;
}

/// The rounds before one hold an eighth of what they and it hold; the first round some tens, since
/// within a round the order is not random: sites along a square's sides, one after the other, make
/// stars that each of them changes.
class InsertionRounds {
 public:
    InsertionRounds(std::size_t sites, std::uint64_t seed) noexcept : seed_(seed) {
        for (std::size_t n = sites; n > 64; n /= 8) ++last_;
    }
    [[nodiscard]] int last() const noexcept { return last_; }
    /// That of a site, from 0 to the last one.
    [[nodiscard]] int of(std::size_t site) const noexcept {
        const std::uint64_t random = mix(mix(seed_) + site * 0x9E3779B97F4A7C15U);
        return last_ - std::min(last_, std::countr_zero(random) / 3);
    }

 private:
    std::uint64_t seed_;
    int last_ = 0;
};

}  // namespace signum
