/// Where products might over- or underflow the filters of circles and of balls are uncertain:
/// beyond the sizes for which their bounds are derived, and not before.

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "../../predicates/euclidean/filter.hpp"
#include "../../predicates/space/ball_filter.hpp"

namespace signum::euclidean {
namespace {

/// Far from a tie at any scale.
template <class S, std::size_t n>
std::array<S, n> scaled(std::array<S, n> sites, double scale) {
    for (S& site : sites) {
        site.x *= scale;
        site.y *= scale;
        if constexpr (requires { site.z; }) site.z *= scale;
        site.r *= scale;
    }
    return sites;
}

struct Certain {
    bool exists;
    bool in_circle;
    bool hides;
    friend bool operator==(const Certain&, const Certain&) = default;
};
constexpr Certain all{true, true, true};
constexpr Certain none{false, false, false};

Certain in_plane(double scale) {
    const auto [i, j, k, q] = scaled(
        std::array{Site{0, 0, 0.25}, Site{1, 0, 0.5}, Site{0, 1, 0}, Site{0.125, 0, 0}}, scale);
    return {filter::exists(i, j, k).is_certain(),
            filter::in_circle_of_visible(i, j, k, q).is_certain(),
            filter::hides(j, q).is_certain() && filter::hides(i, q).is_certain()};
}
Certain in_space(double scale) {
    namespace balls = balls::filter;
    const auto [i, j, k, l, q] =
        scaled(std::array{Site3{0, 0, 0, 0.25}, Site3{1, 0, 0, 0.5}, Site3{0, 1, 0, 0},
                          Site3{0, 0, 1, 0.125}, Site3{0.125, 0, 0, 0}},
               scale);
    return {balls::exists<3>(i, j, k, l).is_certain(),
            balls::in_sphere<3>(q, i, j, k, l).is_certain(), balls::hides<3>(i, q).is_certain()};
}

TEST(FilterWindows, OfThePlane) {
    for (const double scale : {0x1p-105, 1.0, 0x1p108}) EXPECT_EQ(in_plane(scale), all) << scale;
    for (const double scale : {0x1p-112, 0x1p112}) EXPECT_EQ(in_plane(scale), none) << scale;
}

TEST(FilterWindows, OfSpace) {
    for (const double scale : {0x1p-76, 1.0, 0x1p78}) EXPECT_EQ(in_space(scale), all) << scale;
    for (const double scale : {0x1p-85, 0x1p85}) EXPECT_EQ(in_space(scale), none) << scale;
}

/// All are in the window as seen from the first, but no two of the others as seen from each other.
TEST(FilterWindows, OfThoseBetween) {
    constexpr double far = 0.75 * 0x1p80;
    EXPECT_FALSE(balls::filter::exists<3>(Site3{0, 0, 0, 0}, Site3{far, 0, 0, 0},
                                          Site3{0, far, 0, 0}, Site3{0, 0, far, 0})
                     .is_certain());
    EXPECT_TRUE(balls::filter::exists<3>(Site3{0, 0, 0, 0}, Site3{far / 2, 0, 0, 0},
                                         Site3{0, far / 2, 0, 0}, Site3{0, 0, far / 2, 0})
                    .is_certain());
}

}  // namespace
}  // namespace signum::euclidean
