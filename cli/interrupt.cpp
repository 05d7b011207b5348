#include "interrupt.hpp"

namespace signum::cli {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_interrupt(int signal) {
    noted_signal = signal;
}

}  // namespace

int interrupted() noexcept {
    return noted_signal;
}
void set_interrupted(int signal) noexcept {
    noted_signal = signal;
}

InterruptNoted::InterruptNoted() {
    struct sigaction action = {};
    action.sa_handler = note_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    for (std::size_t k = 0; k < signals.size(); ++k) {
        is_set_[k] = ::sigaction(signals[k], nullptr, &before_[k]) == 0 &&
                     before_[k].sa_handler != SIG_IGN &&
                     ::sigaction(signals[k], &action, nullptr) == 0;
    }
}

InterruptNoted::~InterruptNoted() {
    for (std::size_t k = 0; k < signals.size(); ++k)
        if (is_set_[k]) ::sigaction(signals[k], &before_[k], nullptr);
}

}  // namespace signum::cli
