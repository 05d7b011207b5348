#pragma once
/// Whether long work is to end before it is done: somebody is asked now and then. For sources only.

#include <cstdint>
#include <functional>

#include "../exact/kept_environment.hpp"

namespace signum::motion {

class Stop {
 public:
    /// `asked` has to outlive it; where it is empty nothing is stopped.
    explicit Stop(const std::function<bool()>& asked) : asked_(asked) {}

    /// Asks at once. Who has been told once asks no more.
    bool ask() {
        if (is_told_ || !asked_) return is_told_;
        const exact::KeptEnvironment kept;
        return is_told_ = asked_();
    }
    /// A step of the work, some µs at most: asks once in a thousand.
    bool turn() { return ++turns_ % 1024 == 0 ? ask() : is_told_; }
    [[nodiscard]] bool is_told() const noexcept { return is_told_; }

 private:
    const std::function<bool()>& asked_;
    std::uint32_t turns_ = 0;
    bool is_told_ = false;
};

}  // namespace signum::motion
