#pragma once
/// Balls by their numbers, and what every part of their diagram's construction asks of them. For
/// sources only.

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../filters/bounds.hpp"
#include "tree.hpp"

namespace signum::balls {

using Triple = std::array<Index, 3>;
using Quadruple = std::array<Index, 4>;

template <class... S>
[[nodiscard]] bool same_radius(const Site3& first, const S&... others) noexcept {
    return (filters::same_number(first.r, others.r) && ...);
}

/// Below, equal or above 0 in the order of words.
[[nodiscard]] inline auto compare(std::span<const Index> a, std::span<const Index> b) noexcept {
    return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
}

class BallSet {
 public:
    explicit BallSet(std::span<const Site3> balls);

    [[nodiscard]] std::size_t size() const noexcept { return balls_.size(); }
    [[nodiscard]] const Site3& operator[](Index i) const noexcept {
        return balls_[static_cast<std::size_t>(i)];
    }
    template <std::size_t n>
    [[nodiscard]] std::array<Site3, n> of(const std::array<Index, n>& names) const noexcept {
        std::array<Site3, n> balls;
        for (std::size_t m = 0; m < n; ++m) balls[m] = (*this)[names[m]];
        return balls;
    }
    /// By a power of two, the same for all, so that the largest number is about 1.
    [[nodiscard]] const Site3& scaled(Index i) const noexcept {
        return scaled_[static_cast<std::size_t>(i)];
    }
    /// Of some of them, scaled.
    [[nodiscard]] BallTree tree_of(std::span<const Index> names) const { return {scaled_, names}; }

    /// Whether infinitely many spheres touch four balls, of which one sphere touches all.
    [[nodiscard]] bool touch_along_a_curve(const Quadruple& four) const;

 private:
    std::span<const Site3> balls_;
    std::vector<Site3> scaled_;
};

}  // namespace signum::balls
