#pragma once
/// When velocities are kicked (effects/fluid.hpp): at the beginning of each step and at its end, by
/// half a step, between which all fly straight. Where contacts stand it is by a whole step at the
/// beginning, so that forces and reactions meet there (Moreau 1988).
///
/// Step k is from k Δ to (k + 1) Δ, these products rounded once.

#include <cstdint>

#include "effects/fluid.hpp"
#include "meeting.hpp"

namespace signum::motion {

template <int D>
class TimeSteps {
 public:
    TimeSteps(const Effects<D>& effects, std::uint64_t half_steps)
        : length_(effects.time_step),
          half_steps_(half_steps),
          stands_(effects.contacts.has_value()),
          kicks_(effects, stands_ ? length_ : 0.5 * length_) {}

    [[nodiscard]] std::uint64_t half_steps() const noexcept { return half_steps_; }
    [[nodiscard]] double length() const noexcept { return length_; }
    /// When a step begins or ends next; infinity without steps.
    [[nodiscard]] double next() const noexcept {
        if (!(length_ > 0.0)) return infinity;
        return static_cast<double>((half_steps_ + 1) / 2) * length_;
    }
    /// When one began or ended last; 0 before all.
    [[nodiscard]] double last() const noexcept {
        return static_cast<double>(half_steps_ / 2) * length_;
    }
    [[nodiscard]] bool begins() const noexcept { return half_steps_ % 2 == 0; }
    /// Whether one begins that is not the first.
    [[nodiscard]] bool follows() const noexcept { return begins() && half_steps_ > 0; }
    /// Whether there is nothing to do then.
    [[nodiscard]] bool is_idle() const noexcept { return stands_ && !begins(); }
    void advance() noexcept { ++half_steps_; }
    [[nodiscard]] Kicks<D>& kicks() noexcept { return kicks_; }

 private:
    double length_;
    std::uint64_t half_steps_;
    bool stands_;
    Kicks<D> kicks_;
};

}  // namespace signum::motion
