#pragma once
/// The first Ctrl-C ends what is running, not the program, or says what it ended.

#include <array>
#include <csignal>
#include <string_view>

namespace signum::cli {

/// The signal that came, or 0.
[[nodiscard]] int interrupted() noexcept;
/// As if it had come, or none had.
void set_interrupted(int signal) noexcept;

/// Has the next such signal call a function, unless it is ignored. Whether it will, and what was
/// done about it before.
bool handle_once(int signal, void (*handler)(int), struct sigaction& before) noexcept;

/// While it lives, the first Ctrl-C (or what ends a session or a batch job) calls a function, and
/// the second one ends the program.
class InterruptHandled {
 public:
    explicit InterruptHandled(void (*handler)(int));
    InterruptHandled(const InterruptHandled&) = delete;
    InterruptHandled& operator=(const InterruptHandled&) = delete;
    ~InterruptHandled();

 private:
    static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, signals.size()> before_ = {};
    std::array<bool, signals.size()> is_set_ = {};
};

/// While it lives, the first Ctrl-C is noted.
[[nodiscard]] InterruptHandled interrupt_noted();

/// While it lives, Ctrl-C says so on standard error, and ends the program as it would. The text is
/// one that lives as long, with the end of its line.
[[nodiscard]] InterruptHandled interrupt_says(std::string_view text);

}  // namespace signum::cli
