#pragma once
/// The rows of lifted determinants in integers, where the differences to one site are exact and, as
/// multiples of one power of two g, below 2^60 g: on integers and grids, where exact ties abound,
/// and for most sites that lie close together. For sources only.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "../core/error_free.hpp"
#include "../core/sign.hpp"

namespace signum::exact {

using Integer128 = __int128;

/// An offset: a product of two is one of 128 bits, as Square takes it, and one of three as Cube.
template <class Square, class Cube = Integer128>
struct Word {
    std::int64_t value;

    friend Square operator*(Word a, Word b) noexcept {
        return Square{Integer128{a.value} * b.value};
    }
    friend Cube operator*(Word a, Integer128 b) noexcept { return Cube{a.value} * Cube{b}; }
};

/// An integer below 2^255 in magnitude: two words of 128 bits, in two's complement.
class Integer256 {
 public:
    // NOLINTNEXTLINE(google-explicit-constructor): an integer stays what it is
    Integer256(Integer128 a) noexcept : low_(static_cast<Half>(a)), high_(a < 0 ? -1 : 0) {}
    /// The product of two below 2^124.
    Integer256(Integer128 a, Integer128 b) noexcept {
        const auto magnitude_of = [](Integer128 x) {
            return x < 0 ? -static_cast<Half>(x) : static_cast<Half>(x);
        };
        const auto low_of = [](Half x) { return Half{static_cast<std::uint64_t>(x)}; };
        const Half p = magnitude_of(a);
        const Half q = magnitude_of(b);
        const Half middle = low_of(p) * (q >> 64) + (p >> 64) * low_of(q);
        low_ = low_of(p) * low_of(q);
        high_ = static_cast<Integer128>((p >> 64) * (q >> 64) + (middle >> 64));
        *this += {middle << 64, 0};
        if ((a < 0) != (b < 0)) {
            low_ = -low_;
            high_ = -high_ - (low_ != 0 ? 1 : 0);
        }
    }
    friend Integer256 operator+(Integer256 a, const Integer256& b) noexcept {
        a += {b.low_, b.high_};
        return a;
    }
    friend Integer256 operator-(const Integer256& a, const Integer256& b) noexcept {
        return {a.low_ - b.low_, static_cast<Half>(a.high_) - static_cast<Half>(b.high_) -
                                     (a.low_ < b.low_ ? 1 : 0)};
    }
    /// By the words as they stand, modulo 2^256: that is the product wherever it is below 2^255.
    friend Integer256 operator*(const Integer256& a, const Integer256& b) noexcept {
        const auto low_of = [](Half x) { return Half{static_cast<std::uint64_t>(x)}; };
        const Half both_low = low_of(a.low_) * low_of(b.low_);
        const Half first = low_of(a.low_) * (b.low_ >> 64) + (both_low >> 64);
        const Half second = (a.low_ >> 64) * low_of(b.low_) + low_of(first);
        return {second << 64 | low_of(both_low),
                (a.low_ >> 64) * (b.low_ >> 64) + (first >> 64) + (second >> 64) +
                    a.low_ * static_cast<Half>(b.high_) + static_cast<Half>(a.high_) * b.low_};
    }
    [[nodiscard]] Sign sign() const noexcept {
        return high_ < 0 ? -1 : static_cast<Sign>(high_ > 0 || low_ > 0);
    }

 private:
    using Half = unsigned __int128;
    Integer256(Half low, Half high) noexcept : low_(low), high_(static_cast<Integer128>(high)) {}
    struct Halves {
        Half low;
        Integer128 high;
    };
    void operator+=(const Halves& b) noexcept {
        low_ += b.low;
        high_ += b.high + (low_ < b.low ? 1 : 0);
    }

    Half low_;
    Integer128 high_;
};

/// An integer of 128 bits whose products have 256.
struct Factor {
    Integer128 value;

    friend Factor operator+(Factor a, Factor b) noexcept { return {a.value + b.value}; }
    friend Factor operator-(Factor a, Factor b) noexcept { return {a.value - b.value}; }
    friend Integer256 operator*(Factor a, Factor b) noexcept { return {a.value, b.value}; }
};

/// The rows of d+1 sites in d dimensions relative to q. Precondition: all numbers in the window of
/// the determinant, so that 1/g and its square are doubles.
template <std::size_t d>
class IntegerRows {
 public:
    struct IntegerRow {
        std::array<std::int64_t, d> offset;
        Integer128 weight;
    };

    template <class S>
    IntegerRows(const std::array<const S*, d + 1>& sites, const S& q) noexcept {
        TwoTerms offsets[d + 1][d];
        double largest = 0.0;
        for (std::size_t m = 0; m <= d; ++m) {
            offsets[m][0] = two_difference(sites[m]->x, q.x);
            offsets[m][1] = two_difference(sites[m]->y, q.y);
            if constexpr (d == 3) offsets[m][2] = two_difference(sites[m]->z, q.z);
            for (const TwoTerms& each : offsets[m]) {
                are_exact_ &= each.low == 0.0;
                largest = std::max(largest, std::fabs(each.high));
            }
        }
        if (!are_exact_) return;
        if constexpr (requires { q.r; }) {
            largest = std::max(largest, std::fabs(q.r));
            for (const S* site : sites) largest = std::max(largest, std::fabs(site->r));
        }
        // 1/g, which brings the largest below 2^60. Inside the window it is below 2^320.
        constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;
        constexpr std::uint64_t sum_of_exponents = std::uint64_t{2 * 1023 + 59} << 52;
        const double scale = std::bit_cast<double>(
            sum_of_exponents - (std::bit_cast<std::uint64_t>(largest) & exponent_bits));
        for (std::size_t m = 0; m <= d; ++m) {
            for (std::size_t k = 0; k < d; ++k)
                rows_[m].offset[k] = integer(offsets[m][k].high * scale);
            rows_[m].weight = weight(*sites[m], q, scale);
        }
    }

    [[nodiscard]] bool are_exact() const noexcept { return are_exact_; }
    [[nodiscard]] const IntegerRow& operator[](std::size_t m) const noexcept { return rows_[m]; }

    /// Without factors of two that all have in common, where they have so many: small numbers,
    /// those of most grids. Weights count as degree 2.
    [[nodiscard]] bool divide_by_power_of_two(int power) noexcept {
        std::int64_t bits = 0;
        Integer128 weight_bits = 0;
        for (const IntegerRow& row : rows_) {
            for (const std::int64_t each : row.offset) bits |= each;
            weight_bits |= row.weight;
        }
        const std::int64_t low = (std::int64_t{1} << power) - 1;
        const Integer128 weight_low = (Integer128{1} << 2 * power) - 1;
        if ((bits & low) != 0 || (weight_bits & weight_low) != 0) return false;
        for (IntegerRow& row : rows_) {
            for (std::int64_t& each : row.offset) each >>= power;
            row.weight >>= 2 * power;
        }
        return true;
    }

 private:
    [[nodiscard]] std::int64_t integer(double value) noexcept {
        if (!(std::fabs(value) < 0x1p60)) {
            are_exact_ = false;
            return 0;
        }
        const auto result = static_cast<std::int64_t>(value);
        are_exact_ &= static_cast<double>(result) == value;
        return result;
    }

    /// Below 2^122.
    template <class S>
    [[nodiscard]] Integer128 weight(const S& m, const S& q, double scale) noexcept {
        if constexpr (requires { m.w; }) {
            const TwoTerms difference = two_difference(m.w, q.w);
            const double value = difference.high * scale * scale;
            if (difference.low != 0.0 || !(std::fabs(value) < 0x1p122)) {
                are_exact_ = false;
                return 0;
            }
            const auto result = static_cast<Integer128>(value);
            are_exact_ &= static_cast<double>(result) == value;
            return result;
        } else if constexpr (requires { m.r; }) {
            const Integer128 m_radius = integer(m.r * scale);
            const Integer128 q_radius = integer(q.r * scale);
            return (m_radius - q_radius) * (m_radius + q_radius);
        } else {
            return 0;
        }
    }

    bool are_exact_ = true;
    std::array<IntegerRow, d + 1> rows_;
};

}  // namespace signum::exact
