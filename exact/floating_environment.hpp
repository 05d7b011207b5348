#pragma once
/// The floating-point environment that error-free transforms need: rounding to nearest, denormals
/// kept, no trap. A caller may have set another one; the exact stages enter this one and leave it.
///
/// Laws:
///  1. while an IeeeEnvironment lives, its thread computes as IEEE 754 prescribes by default;
///  2. afterwards the control bits are those from before (the sticky flags need not be);
///  3. a thread that is in the default environment pays one read and one comparison.
///
/// A compiler knows nothing of law 1: to it, additions have no side effects and may move across the
/// guard. So no arithmetic of which a sign depends is written beside a guard; call
/// in_ieee_environment(function, operands...). A guard around whole constructions spares their
/// predicates, each of which looks at the environment by itself, the change of it.

#include "../core/contract.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#else
#include <cfenv>
#endif

namespace signum::exact {

/// Enters the default environment; its destructor restores the one before.
class IeeeEnvironment {
 public:
    IeeeEnvironment(const IeeeEnvironment&) = delete;
    IeeeEnvironment& operator=(const IeeeEnvironment&) = delete;

#if defined(__SSE2__)
    IeeeEnvironment() noexcept : saved_(_mm_getcsr()) {
        if (differs()) [[unlikely]]
            _mm_setcsr(default_control);
    }
    ~IeeeEnvironment() {
        if (differs()) [[unlikely]]
            _mm_setcsr(saved_);
    }

 private:
    /// Every exception masked, nearest, neither flush-to-zero nor denormals-are-zero.
    static constexpr unsigned default_control = 0x1F80;
    static constexpr unsigned sticky_flags = 0x003F;
    [[nodiscard]] bool differs() const noexcept {
        return (saved_ & ~sticky_flags) != default_control;
    }

    unsigned saved_;
#else
    IeeeEnvironment() noexcept {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~IeeeEnvironment() {
        std::fesetenv(&saved_);
    }

 private:
    std::fenv_t saved_;
#endif
};

/// function(operands...), computed in the default environment, whatever the caller's. The function
/// takes its operands by value or const reference and returns a value.
///
/// Why no arithmetic leaves the guard, inlined or not: the function reads its operands through an
/// address that the first barrier makes up, so what depends on them follows the barrier; the second
/// barrier reads the result, so what it depends on precedes it. Barriers and guard are volatile and
/// keep their order. What does not depend on the operands is constant, and compilers fold constants
/// in the default environment.
template <class Function, class... Operands>
[[nodiscard]] inline auto in_ieee_environment(Function function,
                                              const Operands&... operands) noexcept {
    const IeeeEnvironment environment;
    const auto opaque = [](const auto& value) -> const auto& {
        const auto* address = &value;
        asm volatile("" : "+r"(address) : : "memory");
        return *address;
    };
    auto result = function(opaque(operands)...);
    asm volatile("" : "+m"(result) : : "memory");
    return result;
}

}  // namespace signum::exact
