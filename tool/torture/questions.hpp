#pragma once
/// What a plugin of predicates is asked: points, in families that are hard, and the exact answer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>

#include "../../core/sign.hpp"
#include "../generate/hard.hpp"
#include "own_points.hpp"

namespace signum::torture {

/// Shewchuk's four functions.
enum class Asked : std::uint8_t { orient2d, incircle, orient3d, insphere };
inline constexpr std::size_t functions = 4;
inline constexpr std::array<Asked, functions> all_asked = {Asked::orient2d, Asked::incircle,
                                                           Asked::orient3d, Asked::insphere};
[[nodiscard]] constexpr std::size_t place_of(Asked asked) noexcept {
    return static_cast<std::size_t>(asked);
}
[[nodiscard]] std::string_view name_of(Asked asked) noexcept;
[[nodiscard]] constexpr std::size_t dimension_of(Asked asked) noexcept {
    return asked == Asked::orient2d || asked == Asked::incircle ? 2 : 3;
}
[[nodiscard]] constexpr std::size_t points_of(Asked asked) noexcept {
    return dimension_of(asked) + (asked == Asked::orient2d || asked == Asked::orient3d ? 1 : 2);
}

/// Points, one after the other; those that a function does not take are 0.
struct Question {
    Asked asked = Asked::orient2d;
    std::array<double, 15> numbers = {};
    [[nodiscard]] std::size_t size() const noexcept {
        return points_of(asked) * dimension_of(asked);
    }
    [[nodiscard]] const double* point(std::size_t m) const noexcept {
        return &numbers[m * dimension_of(asked)];
    }
};
/// The sign as Shewchuk's functions have it: orient3d is positive where the fourth point lies below
/// the plane of the others, insphere where the last one lies inside and orient3d is positive.
[[nodiscard]] Sign exact_sign(const Question& question);
/// Of all but the last point of incircle and insphere: orient2d and orient3d of them.
[[nodiscard]] Sign exact_turn(const Question& question);
/// Greater for questions that are harder to read: the bits of the significands and the spread of
/// the exponents. Above 0.
[[nodiscard]] int cost_of(const Question& question) noexcept;

struct Family {
    std::string_view name;
    std::string_view says;
    int in_a_row = 500;   ///< questions before the next family's turn
    bool is_far = false;  ///< products of its numbers over- or underflow
};
[[nodiscard]] std::span<const Family> families() noexcept;
/// The family of somebody's own points.
inline constexpr std::string_view own_points_name = "own";

/// Questions of a family, the same for the same seed.
class Maker {
 public:
    explicit Maker(std::uint64_t seed, std::span<const OwnPoints> own = {})
        : plane_(seed), space_(seed), random_(seed), own_(own) {}
    /// Whether the family has questions for the function: that of somebody's own points may lack.
    [[nodiscard]] bool has(Asked asked, std::size_t family) const;
    [[nodiscard]] Question make(Asked asked, std::size_t family);
    /// One whose points are far from a tie, among small integers.
    [[nodiscard]] Question make_clear(Asked asked);

 private:
    template <std::size_t d>
    [[nodiscard]] Question made(hard::Moves<d>& moves, Asked asked, std::size_t family);
    [[nodiscard]] Question make_worst(Asked asked);
    [[nodiscard]] Question make_own(Asked asked);
    /// Whole numbers from 0 on, below `end`.
    [[nodiscard]] std::size_t below(std::size_t end) { return random_() % end; }

    hard::Moves<2> plane_;
    hard::Moves<3> space_;
    std::mt19937_64 random_;
    std::span<const OwnPoints> own_;
};

}  // namespace signum::torture
