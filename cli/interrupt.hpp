#pragma once
/// The first Ctrl-C ends what is running, not the program.

#include <array>
#include <csignal>

namespace signum::cli {

/// The signal that came, or 0.
[[nodiscard]] int interrupted() noexcept;
/// As if it had come, or none had.
void set_interrupted(int signal) noexcept;

/// While it lives, the first Ctrl-C (or what ends a session or a batch job) is noted, and the
/// second one ends the program.
class InterruptNoted {
 public:
    InterruptNoted();
    InterruptNoted(const InterruptNoted&) = delete;
    InterruptNoted& operator=(const InterruptNoted&) = delete;
    ~InterruptNoted();

 private:
    static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, signals.size()> before_ = {};
    std::array<bool, signals.size()> is_set_ = {};
};

}  // namespace signum::cli
