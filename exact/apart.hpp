#pragma once
/// Doubles in rows, such as sites or balls, taken apart by their bits: as integers, all divided by
/// one power of two. No rounding, no environment. For sources only.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "multiprecision.hpp"

namespace signum::exact {

template <std::size_t rows, std::size_t columns>
class Apart {
 public:
    explicit Apart(const std::array<std::array<double, columns>, rows>& numbers) noexcept {
        bool any = false;
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column) {
                const Parts& number = parts_[row][column] = parts(numbers[row][column]);
                if (number.significand == 0) continue;
                const int end =
                    number.exponent + static_cast<int>(std::bit_width(number.significand));
                lowest_ = any ? std::min(lowest_, number.exponent) : number.exponent;
                highest_ = any ? std::max(highest_, end) : end;
                any = true;
            }
    }

    /// All are multiples of 2^lowest below 2^(lowest + span).
    [[nodiscard]] int span() const noexcept { return highest_ - lowest_; }

    /// A number / 2^lowest. Precondition: the type holds span() bits and a sign.
    template <class Integer>
    [[nodiscard]] Integer value(std::size_t row, std::size_t column) const {
        const Parts& number = parts_[row][column];
        Integer result = static_cast<Integer>(number.significand);
        if (number.significand != 0) result <<= number.exponent - lowest_;
        if constexpr (requires { result.backend().negate(); }) {
            if (number.negative) result.backend().negate();
            return result;
        } else {
            return number.negative ? -result : result;
        }
    }
    /// All of them.
    template <class Integer>
    [[nodiscard]] std::array<std::array<Integer, columns>, rows> values() const {
        std::array<std::array<Integer, columns>, rows> result;
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column)
                result[row][column] = value<Integer>(row, column);
        return result;
    }
    /// A number / 2^(lowest + bits / 2). Precondition: span() <= bits, an even number below 2000.
    [[nodiscard]] double centred(std::size_t row, std::size_t column, int bits) const noexcept {
        const Parts& number = parts_[row][column];
        const double result = std::ldexp(static_cast<double>(number.significand),
                                         number.exponent - lowest_ - bits / 2);
        return number.negative ? -result : result;
    }

 private:
    std::array<std::array<Parts, columns>, rows> parts_;
    int lowest_ = 0;
    int highest_ = 0;
};

}  // namespace signum::exact
