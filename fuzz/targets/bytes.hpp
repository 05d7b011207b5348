#pragma once
/// Bytes as choices: what a target of structures does, one after the other.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "target.hpp"

namespace signum::fuzz {

class Choices {
 public:
    explicit Choices(Bytes bytes) : bytes_(bytes) {}

    [[nodiscard]] bool are_left() const noexcept { return next_ < bytes_.size(); }
    /// 0 where none are left.
    std::uint8_t byte() noexcept { return are_left() ? bytes_[next_++] : std::uint8_t{0}; }
    int below(int count) noexcept { return byte() % count; }

    /// A coordinate on a grid of 8, in one of eight cases an ulp or two beside it.
    double coordinate() noexcept {
        const int choice = byte();
        const double place = choice % 8;
        switch (choice / 8) {
            case 31:
                return std::nextafter(place, 9.0);
            case 30:
                return std::nextafter(place, -1.0);
            case 29:
                return std::nextafter(std::nextafter(place, 9.0), 9.0);
            case 28:
                return std::nextafter(std::nextafter(place, -1.0), -1.0);
            default:
                return place;
        }
    }
    /// 0, 1, 2 or 3, or a half more, mostly small.
    double radius() noexcept {
        const int choice = byte();
        const double radius = choice % 4 == 3 ? choice / 4 % 4 : choice % 2;
        return choice >= 192 ? radius + 0.5 : radius;
    }

 private:
    Bytes bytes_;
    std::size_t next_ = 0;
};

}  // namespace signum::fuzz
