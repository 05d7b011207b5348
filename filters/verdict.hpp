#pragma once
/// What a filter answers: a sign, or that it cannot tell.

#include "../core/sign.hpp"

namespace signum::filters {

/// A certain sign, or uncertain. Uncertain is no sign: asking for the sign of an uncertain verdict
/// breaks a contract.
class [[nodiscard]] Verdict {
 public:
    static constexpr Verdict certain(Sign sign) noexcept { return Verdict(sign); }
    static constexpr Verdict uncertain() noexcept { return Verdict(unknown_); }
    [[nodiscard]] constexpr bool is_certain() const noexcept { return value_ != unknown_; }
    /// Precondition: is_certain().
    [[nodiscard]] constexpr Sign sign() const noexcept { return value_; }

 private:
    static constexpr int unknown_ = 2;
    explicit constexpr Verdict(int value) noexcept : value_(value) {}
    int value_;
};

}  // namespace signum::filters
