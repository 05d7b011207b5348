#pragma once
/// Dyadic numbers m·2^e: what doubles are, and all their sums and products. For sources only, for
/// multiprecision.hpp comes with it.
///
/// m is an integer of 128 bits while these surely hold it, which they do in most ties, and of any
/// size otherwise. Nothing is normalised: where a rational divides by a greatest common divisor
/// after every operation, here an exponent is added or a sum shifted.
///
/// Laws:
///  1. every operation is exact;
///  2. all is done in integers: no rounding mode, no flushing of denormals;
///  3. no predicate of a construction computes in it, so that a judge may rely on it: but for the
///     order of flips, what it decides is what a judge asks.

#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

#include "../core/sign.hpp"
#include "multiprecision.hpp"
#include "sum.hpp"

namespace signum::exact {

class Dyadic : public ComparedBySign<Dyadic> {
 public:
    /// 0.
    Dyadic() = default;
    /// Precondition: the number is finite.
    explicit Dyadic(double number) noexcept {
        const Parts of_number = parts(number);
        small_ = static_cast<Small>(of_number.significand);
        if (of_number.negative) small_ = -small_;
        exponent_ = of_number.exponent;
    }
    /// m·2^exponent.
    Dyadic(Integer m, int exponent) noexcept : exponent_(exponent), large_(std::move(m)) {}

    friend Dyadic operator-(Dyadic a) {
        a.small_ = -a.small_;
        if (a.large_) a.large_->backend().negate();
        return a;
    }
    /// In 128 bits where both numbers, as multiples of one power of two, are below 2^126.
    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
        if (b.sign() == 0) return a;
        if (a.sign() == 0) return b;
        const Dyadic& coarse = a.exponent_ < b.exponent_ ? b : a;
        const Dyadic& fine = a.exponent_ < b.exponent_ ? a : b;
        const int shift = coarse.exponent_ - fine.exponent_;
        if (coarse.bits() + shift <= most_bits - 1 && fine.bits() <= most_bits - 1) [[likely]]
            return {(coarse.small_ << shift) + fine.small_, fine.exponent_};
        return sum_of_large(coarse, fine);
    }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
    Dyadic& operator+=(const Dyadic& other) { return *this = *this + other; }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        if (a.bits() + b.bits() <= most_bits) [[likely]]
            return {a.small_ * b.small_, a.exponent_ + b.exponent_};
        return product_of_large(a, b);
    }
    friend Dyadic operator*(int a, const Dyadic& b) { return Dyadic(a, 0) * b; }

    /// -1, 0 or +1.
    [[nodiscard]] Sign sign() const noexcept {
        return large_ ? large_->sign()
                      : static_cast<int>(small_ > 0) - static_cast<int>(small_ < 0);
    }
    /// As of a CutDyadic.
    [[nodiscard]] static constexpr bool is_certain() noexcept { return true; }
    /// m and e.
    [[nodiscard]] Integer significand() const;
    [[nodiscard]] int exponent() const noexcept { return exponent_; }

 private:
    using Small = __int128;
    /// The magnitude of a small number is below 2^most_bits.
    static constexpr int most_bits = 127;

    Dyadic(Small m, int exponent) noexcept : small_(m), exponent_(exponent) {}

    /// The magnitude of m is below 2^bits(); more than most_bits where m is large.
    [[nodiscard]] int bits() const noexcept {
        if (large_) [[unlikely]]
            return most_bits + 1;
        const auto magnitude = static_cast<unsigned __int128>(small_ < 0 ? -small_ : small_);
        const auto high = static_cast<std::uint64_t>(magnitude >> 64);
        return static_cast<int>(high != 0 ? 64 + std::bit_width(high)
                                          : std::bit_width(static_cast<std::uint64_t>(magnitude)));
    }

    [[gnu::cold]] static Dyadic sum_of_large(const Dyadic& coarse, const Dyadic& fine);
    [[gnu::cold]] static Dyadic product_of_large(const Dyadic& a, const Dyadic& b);

    Small small_ = 0;  // m, unless it is large
    int exponent_ = 0;
    std::optional<Integer> large_;
};

/// m·2^e.
[[nodiscard]] Rational to_rational(const Dyadic& number);
[[nodiscard]] inline double round_to_double(const Dyadic& number) {
    return round_to_double(to_rational(number));
}

}  // namespace signum::exact
