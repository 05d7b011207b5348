#include "interrupt.hpp"

#include <unistd.h>

namespace signum::cli {
namespace {

volatile std::sig_atomic_t noted_signal = 0;
std::string_view last_words;

extern "C" void note_interrupt(int signal) {
    noted_signal = signal;
}

extern "C" void say_and_die(int signal) {
    static_cast<void>(!::write(STDERR_FILENO, last_words.data(), last_words.size()));
    // The handler is reset (SA_RESETHAND), so that the shell sees the signal.
    ::raise(signal);
}

}  // namespace

int interrupted() noexcept {
    return noted_signal;
}
void set_interrupted(int signal) noexcept {
    noted_signal = signal;
}

bool handle_once(int signal, void (*handler)(int), struct sigaction& before) noexcept {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    return ::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN &&
           ::sigaction(signal, &action, nullptr) == 0;
}

InterruptHandled::InterruptHandled(void (*handler)(int)) {
    for (std::size_t k = 0; k < signals.size(); ++k)
        is_set_[k] = handle_once(signals[k], handler, before_[k]);
}

InterruptHandled::~InterruptHandled() {
    for (std::size_t k = 0; k < signals.size(); ++k)
        if (is_set_[k]) ::sigaction(signals[k], &before_[k], nullptr);
}

InterruptHandled interrupt_noted() {
    return InterruptHandled(note_interrupt);
}

InterruptHandled interrupt_says(std::string_view text) {
    last_words = text;
    return InterruptHandled(say_and_die);
}

}  // namespace signum::cli
