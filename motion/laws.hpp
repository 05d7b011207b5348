#pragma once
/// By what law a pair strikes, and what a ball remembers for it.

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "effects/friction.hpp"
#include "effects/speed_law.hpp"
#include "simulation.hpp"
#include "strike.hpp"

namespace signum::motion {

/// Which effects a loop is compiled for. The library's loops know all of them, and ask once a
/// strike whether any is on; a test compiles loops that do not know one, to see what asking costs.
struct Known {
    bool walls = true;  ///< but sides of a box at rest
    bool speed_law = true;
    bool contact_duration = true;
    bool friction = true;
    bool growth = true;
    bool time_steps = true;
    bool contacts = true;  ///< that stand; only where there are time steps
};

template <int D, Known known>
class Laws {
 public:
    Laws(const Effects<D>& effects, std::size_t balls) : effects_(effects) {
        if (has_friction()) spins_.resize(balls);
        if (has_duration()) last_strikes_.assign(balls, -infinity);
        is_plain_ = !(has_friction() || has_duration() || has_speed_law() || has_contacts() ||
                      (known.growth && effects_.growth));
    }
    /// Takes over what a state remembers of its balls, by number.
    void set(const State<D>& state, std::span<const Slot> slots) {
        for (std::size_t number = 0; number < slots.size(); ++number) {
            if (has_friction()) spins_[slots[number]] = state.spins[number];
            if (has_duration()) last_strikes_[slots[number]] = state.last_strikes[number];
        }
    }
    [[nodiscard]] bool has_friction() const noexcept {
        return known.friction && effects_.friction.has_value();
    }
    [[nodiscard]] bool has_duration() const noexcept {
        return known.contact_duration && effects_.contact_duration > 0.0;
    }
    [[nodiscard]] bool has_contacts() const noexcept {
        return known.contacts && effects_.contacts.has_value();
    }
    /// Whether restitution is a number, and there is nothing else.
    [[nodiscard]] bool is_plain() const noexcept { return is_plain_; }

    [[nodiscard]] const Spin<D>& spin(Slot i) const noexcept { return spins_[i]; }
    [[nodiscard]] Spin<D>& spin(Slot i) noexcept { return spins_[i]; }
    [[nodiscard]] double last_strike(Slot i) const noexcept { return last_strikes_[i]; }
    void struck(Slot i, double t) {
        if (has_duration()) last_strikes_[i] = t;
    }

    /// The restitution of some balls that strike at t, one or two, given what it is without
    /// effects and the speed of approach; whether they stay in contact, and whether they rub.
    struct Bounce {
        double restitution;
        bool stays;
        bool rubs;
    };
    [[nodiscard]] Bounce bounce(std::initializer_list<Slot> balls, double t, double restitution,
                                double approach) const {
        Bounce result{restitution, false, has_friction()};
        if (has_speed_law())
            result.restitution = restitution_at(*effects_.speed_law, restitution, approach);
        if (has_duration()) {
            for (const Slot i : balls)
                if (t - last_strikes_[i] <= effects_.contact_duration) result = {1.0, false, false};
        }
        if (has_contacts() && result.restitution * approach < effects_.contacts->speed)
            result = {0.0, true, has_friction()};
        return result;
    }

 private:
    [[nodiscard]] bool has_speed_law() const noexcept {
        return known.speed_law && effects_.speed_law.has_value();
    }

    Effects<D> effects_;
    bool is_plain_ = true;
    std::vector<Spin<D>> spins_;
    std::vector<double> last_strikes_;
};

}  // namespace signum::motion
