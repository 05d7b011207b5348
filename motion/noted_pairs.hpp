#pragma once
/// Pairs that may meet in the next steps of time, noted when all balls were asked, so that a step
/// need not search for them.
///
/// Those are left out that were farther apart than the skin. Since then each of the two has flown
/// no farther than the fastest speed of any ball allows; so as long as twice that is no more than
/// the skin they have not met. Others were left out since the structure did not propose them: these
/// it proposes before they meet, and then they are added.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "slot_lists.hpp"

namespace signum::motion {

template <int D>
class NotedPairs {
 public:
    explicit NotedPairs(std::size_t balls) : balls_(balls), partners_(balls) {}

    /// A ball has that velocity from now on.
    void fly(const Vector<D>& v) noexcept { fastest_ = std::max(fastest_, dot(v, v)); }
    /// How much nearer two come to one another in a time, at most.
    [[nodiscard]] double way_in(double time) const noexcept {
        return 2.0 * std::sqrt(fastest_) * time * (1.0 + 0x1p-40);
    }
    /// Whether no pair that is not noted meets before that.
    [[nodiscard]] bool hold_until(double time) const noexcept {
        return skin_ >= 0.0 && way_in(time - noted_at_) <= skin_;
    }

    /// Notes pairs anew: near(i, visit) tells those of one ball after the other.
    template <class Near>
    void note(double now, double skin, const Near& near) {
        noted_at_ = now;
        skin_ = skin;
        for (Slot i = 0; i < balls_; ++i) partners_.clear(i);
        for (Slot i = 0; i < balls_; ++i) near(i, [&](Slot j) { partners_.link(i, j); });
    }
    void add(Slot i, Slot j) {
        if (std::ranges::find(of(i), j) == of(i).end()) partners_.link(i, j);
    }
    /// How fast balls were is no matter for what is noted now.
    void forget_speeds() noexcept { fastest_ = 0.0; }
    /// Nothing is noted: where there are none, or what proposes them is another one now.
    void forget() noexcept { skin_ = -1.0; }

    /// Of each pair both.
    [[nodiscard]] std::span<const Slot> of(Slot i) const noexcept { return partners_[i]; }

 private:
    std::size_t balls_;
    SlotLists partners_;
    double noted_at_ = -infinity;
    double skin_ = -1.0;
    double fastest_ = 0.0;  ///< its square
};

}  // namespace signum::motion
