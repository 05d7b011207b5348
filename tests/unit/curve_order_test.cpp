/// The Hilbert curve goes through every cell once, from one to the next beside it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/structure/curve_order.hpp"

namespace signum {
namespace {

template <std::size_t D>
std::array<std::uint32_t, D> cell_of(std::size_t number, int bits) {
    std::array<std::uint32_t, D> cell;
    for (std::uint32_t& axis : cell) {
        axis = static_cast<std::uint32_t>(number & ((std::size_t{1} << bits) - 1));
        number >>= bits;
    }
    return cell;
}

template <std::size_t D>
void expect_a_path(int bits) {
    const std::size_t cells = std::size_t{1} << (D * static_cast<std::size_t>(bits));
    std::vector<std::size_t> along(cells, cells);
    for (std::size_t number = 0; number < cells; ++number) {
        const std::uint64_t place = HilbertCurve<D>::place(cell_of<D>(number, bits), bits);
        ASSERT_LT(place, cells);
        ASSERT_EQ(along[place], cells) << "two cells at one place";
        along[place] = number;
    }
    EXPECT_EQ(along[0], 0U);
    for (std::size_t place = 1; place < cells; ++place) {
        const auto one = cell_of<D>(along[place - 1], bits);
        const auto next = cell_of<D>(along[place], bits);
        int steps = 0;
        for (std::size_t k = 0; k < D; ++k)
            steps += std::abs(static_cast<int>(one[k]) - static_cast<int>(next[k]));
        ASSERT_EQ(steps, 1) << "at " << place;
    }
}

TEST(HilbertCurve, IsAPathInThePlane) {
    expect_a_path<2>(4);
    expect_a_path<2>(8);
}
TEST(HilbertCurve, IsAPathInSpace) {
    expect_a_path<3>(2);
    expect_a_path<3>(4);
    expect_a_path<3>(6);
}

/// Those of a crowd in one cell as if they were alone.
TEST(CurveOrder, OfACrowdOnAScaleOfItsOwn) {
    std::mt19937 random(1);
    constexpr std::size_t count = 200;
    std::vector<std::array<double, 2>> crowd;
    for (std::size_t i = 0; i < count; ++i)
        crowd.push_back(
            {static_cast<double>(random() % 4096), static_cast<double>(random() % 4096)});
    const auto sorted = [](const std::vector<std::array<double, 2>>& places, double scale) {
        constexpr CurveKeys layout{10, 8};
        std::vector<std::uint64_t> keys;
        for (std::size_t i = 0; i < places.size(); ++i) keys.push_back(i);
        sort_along_curve<2>(
            keys, layout,
            [&](std::size_t i) {
                return std::array{places[i][0] * scale, places[i][1] * scale};
            },
            Workers(1));
        std::vector<std::size_t> order;
        for (const std::uint64_t key : keys)
            if (layout.item(key) < count) order.push_back(layout.item(key));
        return order;
    };
    auto with_one_far_away = crowd;
    with_one_far_away.push_back({0x1p60, 0x1p60});
    const std::vector<std::size_t> alone = sorted(crowd, 1.0);
    EXPECT_EQ(alone.size(), count);
    EXPECT_EQ(sorted(with_one_far_away, 1.0), alone);
    EXPECT_EQ(sorted(with_one_far_away, 0x1p900), alone);
}

/// Crowds that reach from one thread's range into the next one's, too.
TEST(CurveOrder, BySeveralThreadsIsThatByOne) {
    std::mt19937 random(2);
    std::vector<std::array<double, 2>> places;
    for (int i = 0; i < 60'000; ++i)
        places.push_back(
            {static_cast<double>(random() % 8) + 0x1p-40 * static_cast<double>(random() % 64),
             static_cast<double>(random() % 8)});
    const auto sorted = [&](int threads) {
        constexpr CurveKeys layout{17, 20};
        std::vector<std::uint64_t> keys(places.size());
        std::iota(keys.begin(), keys.end(), std::uint64_t{0});
        sort_along_curve<2>(
            keys, layout, [&](std::size_t i) { return places[i]; },
            Workers(threads, places.size()));
        for (std::uint64_t& key : keys) key = layout.item(key);
        return keys;
    };
    const std::vector<std::uint64_t> one = sorted(1);
    for (int trial = 0; trial < 20; ++trial)
        for (const int threads : {2, 3, 7}) ASSERT_EQ(sorted(threads), one) << threads;
}

}  // namespace
}  // namespace signum
