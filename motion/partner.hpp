#pragma once
/// What a ball strikes: another ball, or a wall, which is a side of the box or an obstacle.

#include <compare>
#include <cstdint>
#include <limits>

#include "ball.hpp"

namespace signum::motion {

/// One number tells it: that of a ball, or -1 - wall. The public structures have the same numbers
/// (Passed, StandingContact, Sketch::Expected). Balls are named by slots inside the loop and by
/// their numbers in what outlasts it.
class Partner {
 public:
    /// Nobody.
    constexpr Partner() noexcept = default;
    [[nodiscard]] static constexpr Partner coded(std::int32_t code) noexcept {
        Partner partner;
        partner.code_ = code;
        return partner;
    }
    [[nodiscard]] static constexpr Partner ball(Slot slot) noexcept {
        return coded(static_cast<std::int32_t>(slot));
    }
    [[nodiscard]] static constexpr Partner wall(Wall wall) noexcept { return coded(-1 - wall); }

    [[nodiscard]] constexpr bool is_nobody() const noexcept { return code_ == nobody; }
    [[nodiscard]] constexpr bool is_ball() const noexcept { return code_ >= 0; }
    [[nodiscard]] constexpr bool is_wall() const noexcept { return code_ < 0 && code_ != nobody; }
    /// Precondition: is_ball().
    [[nodiscard]] constexpr Slot slot() const noexcept { return static_cast<Slot>(code_); }
    /// Precondition: is_wall().
    [[nodiscard]] constexpr Wall wall() const noexcept { return -1 - code_; }
    [[nodiscard]] constexpr std::int32_t code() const noexcept { return code_; }
    /// The largest walls first, then balls.
    friend constexpr auto operator<=>(const Partner&, const Partner&) noexcept = default;

 private:
    static constexpr std::int32_t nobody = std::numeric_limits<std::int32_t>::min();

    std::int32_t code_ = nobody;
};

}  // namespace signum::motion
