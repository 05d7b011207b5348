#pragma once
/// Dyadic numbers of which the last bits are cut off: where doubles of all sizes meet, exact
/// numbers have thousands of bits, of which the first few hundred tell most signs. For sources
/// only.
///
/// Law: a number is cut to about so many bits after every operation and knows how far it may be
/// off. What needed no cut is exact.
///
/// The bound. What is cut off is less than one unit of what is left, or less than 2^s where a
/// number below 2^s is left out of a sum; an operand that is off by less than 2^e leaves a sum off
/// by less than that. A product a·b of numbers below 2^s and 2^t in magnitude that are off by less
/// than 2^d and 2^e is off by less than 2^(s+e) + 2^(t+d) + 2^(d+e). A sum of two such bounds is
/// below twice the greater, one of three below four times the greatest.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "multiprecision.hpp"
#include "sum.hpp"

namespace signum::exact {

template <std::int64_t most_bits>
class CutDyadic : public ComparedBySign<CutDyadic<most_bits>> {
 public:
    /// 0.
    CutDyadic() = default;
    explicit CutDyadic(double value) {
        const Parts number = parts(value);
        significand_ = number.significand;
        exponent_ = number.exponent;
        if (number.negative) significand_.backend().negate();
    }

    /// Whether what was cut off leaves the sign as it is.
    [[nodiscard]] bool is_certain() const { return error_ == none || size() > error_; }
    /// Precondition: is_certain().
    [[nodiscard]] Sign sign() const { return significand_.sign(); }

    friend CutDyadic operator-(CutDyadic a) {
        a.significand_.backend().negate();
        return a;
    }
    friend CutDyadic operator+(CutDyadic a, CutDyadic b) {
        if (a.exponent_ < b.exponent_) std::swap(a, b);
        const std::int64_t error = sum_of_bounds(a.error_, b.error_);
        // 0 has no bits that need a place.
        if (a.significand_.is_zero()) std::swap(a, b);
        a.error_ = error;
        if (b.significand_.is_zero()) return a;
        if (a.size() - b.size() > most_bits) {
            // All of b would be cut off.
            a.error_ = sum_of_bounds(error, b.size());
            return a;
        }
        a.significand_ <<= a.exponent_ - b.exponent_;
        a.significand_ += b.significand_;
        a.exponent_ = b.exponent_;
        return std::move(a).cut();
    }
    friend CutDyadic operator-(CutDyadic a, CutDyadic b) { return std::move(a) + -std::move(b); }
    friend CutDyadic operator*(const CutDyadic& a, const CutDyadic& b) {
        CutDyadic product;
        product.significand_ = a.significand_ * b.significand_;
        product.exponent_ = a.exponent_ + b.exponent_;
        product.error_ = product_of_bounds(a, b);
        return std::move(product).cut();
    }

 private:
    /// The error of exact numbers, and the size of 0: far below those of others.
    static constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min() / 4;

    [[nodiscard]] static std::int64_t sum_of_bounds(std::int64_t a, std::int64_t b) noexcept {
        return std::min(a, b) == none ? std::max(a, b) : std::max(a, b) + 1;
    }
    [[nodiscard]] static std::int64_t product_of_bounds(const CutDyadic& a, const CutDyadic& b) {
        const std::int64_t bound =
            std::max({a.size() + b.error_, b.size() + a.error_, a.error_ + b.error_});
        return bound < none / 2 ? none : bound + 2;
    }
    /// The magnitude is below 2^size, and where it is not 0 at least half of that.
    [[nodiscard]] std::int64_t size() const {
        if (significand_.is_zero()) return none;
        return exponent_ + bits_of(significand_);
    }
    [[nodiscard]] CutDyadic cut() && {
        const std::int64_t surplus = size() - exponent_ - most_bits;
        if (surplus > 0) {
            significand_ >>= surplus;
            exponent_ += surplus;
            error_ = sum_of_bounds(error_, exponent_);
        }
        return std::move(*this);
    }

    Integer significand_;
    std::int64_t exponent_ = 0;
    std::int64_t error_ = none;
};

}  // namespace signum::exact
