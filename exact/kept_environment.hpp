#pragma once
/// Calls of what a caller gave: it may change the floating-point environment, and what called it
/// goes on in the one that it had set.

#include <cfenv>

#include "floating_environment.hpp"

namespace signum::exact {

/// Its destructor restores the environment of its construction.
class KeptEnvironment {
 public:
    KeptEnvironment(const KeptEnvironment&) = delete;
    KeptEnvironment& operator=(const KeptEnvironment&) = delete;

#if defined(__SSE2__)
    KeptEnvironment() noexcept : kept_(_mm_getcsr()), mode_(std::fegetround()) {}
    ~KeptEnvironment() {
        // Of long doubles, too, which have a register of their own.
        if (std::fegetround() != mode_) [[unlikely]]
            std::fesetround(mode_);
        if (_mm_getcsr() != kept_) [[unlikely]]
            _mm_setcsr(kept_);
    }

 private:
    unsigned kept_;
    int mode_;
#else
    KeptEnvironment() noexcept {
        std::fegetenv(&kept_);
    }
    ~KeptEnvironment() {
        std::fesetenv(&kept_);
    }

 private:
    std::fenv_t kept_;
#endif
};

}  // namespace signum::exact
