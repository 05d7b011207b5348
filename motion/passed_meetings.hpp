#pragma once
/// Meetings that were no strikes, and contacts that stand: what a ball does not strike until
/// something happens to it.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "partner.hpp"

namespace signum::motion {

/// Up to when each of some pairs is passed over.
class PassedMeetings {
 public:
    struct Entry {
        Partner partner;
        double until;
    };

    explicit PassedMeetings(std::size_t balls) : balls_(balls) {}

    [[nodiscard]] bool is_empty() const noexcept { return size_ == 0; }
    [[nodiscard]] std::span<const Entry> of(Slot i) const noexcept {
        return of_.empty() ? std::span<const Entry>() : of_[i];
    }
    /// -infinity where the pair is not passed over.
    [[nodiscard]] double until(Slot i, Partner partner) const noexcept {
        for (const Entry& entry : of(i))
            if (entry.partner == partner) return entry.until;
        return -infinity;
    }
    void pass(Slot i, Partner partner, double until) {
        if (of_.empty()) of_.resize(balls_);
        put(i, partner, until);
        if (partner.is_ball()) put(partner.slot(), Partner::ball(i), until);
    }
    /// Something has happened to a ball.
    void release(Slot i) {
        if (is_empty()) return;
        for (const Entry& entry : of_[i])
            if (entry.partner.is_ball())
                size_ -= std::erase_if(of_[entry.partner.slot()], [i](const Entry& other) {
                    return other.partner == Partner::ball(i);
                });
        size_ -= of_[i].size();
        of_[i].clear();
    }
    void clear() {
        for (std::vector<Entry>& each : of_) each.clear();
        size_ = 0;
    }

 private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    void put(Slot i, Partner partner, double until) {
        for (Entry& entry : of_[i]) {
            if (entry.partner != partner) continue;
            entry.until = until;
            return;
        }
        of_[i].push_back({partner, until});
        ++size_;
    }

    std::size_t balls_;
    std::size_t size_ = 0;
    std::vector<std::vector<Entry>> of_;  // none until one is passed
};

}  // namespace signum::motion
