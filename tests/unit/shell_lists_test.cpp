/// Lists of shells beside a plain table of them, told in doubles.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/shells.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::motion {
namespace {

using oracle_test::Random;

template <int D>
struct Known {
    std::uint32_t list;
    Shell<D> shell;
};

/// How far two shells are from overlapping; below 0 they do.
template <int D>
double gap(const Shell<D>& a, const Shell<D>& b) {
    double square = 0.0;
    for (int k = 0; k < D; ++k) {
        const double d = static_cast<double>(a.into[k]) - static_cast<double>(b.into[k]);
        square += d * d;
    }
    return std::sqrt(square) - static_cast<double>(a.reach) - static_cast<double>(b.reach);
}

template <int D>
void expect_a_plain_table(std::uint64_t seed, std::uint32_t lists, int balls) {
    Random random(seed);
    ShellLists<D> shells(lists);
    EXPECT_EQ(shells.size(), lists);
    std::map<Slot, Known<D>> known;
    const auto any = [&](Slot ball) {
        Shell<D> shell;
        for (int k = 0; k < D; ++k) shell.into[k] = static_cast<float>(random.unit());
        shell.reach = random.below(50) == 0 ? std::numeric_limits<float>::infinity()
                                            : static_cast<float>(0.2 * random.unit());
        shell.ball = ball;
        return shell;
    };
    std::size_t found_in_all = 0;
    for (int turn = 0; turn < 20 * balls; ++turn) {
        const auto ball = static_cast<Slot>(random.below(balls));
        if (const auto at = known.find(ball); at != known.end()) {
            shells.remove(at->second.list, ball);
            known.erase(at);
        } else {
            const auto list = static_cast<std::uint32_t>(random.below(static_cast<int>(lists)));
            const Shell<D> shell = any(ball);
            shells.insert(list, shell);
            known.insert({ball, {list, shell}});
        }
        const Shell<D> asked = any(0);
        for (std::uint32_t list = 0; list < lists; ++list) {
            // What stands before is left alone.
            std::vector<Slot> found = {7, 7, 7};
            std::size_t size = 3;
            shells.find_overlapping(list, asked, found, size);
            ASSERT_GE(size, 3U);
            ASSERT_EQ(std::ranges::count(found.begin(), found.begin() + 3, Slot{7}), 3);
            found.erase(found.begin() + static_cast<std::ptrdiff_t>(size), found.end());
            found.erase(found.begin(), found.begin() + 3);
            found_in_all += found.size();
            for (const Slot each : found) {
                const auto at = known.find(each);
                ASSERT_NE(at, known.end());
                ASSERT_EQ(at->second.list, list);
                ASSERT_LT(gap(asked, at->second.shell), 0x1p-20);
                ASSERT_EQ(std::ranges::count(found, each), 1);
            }
            for (const auto& [other, its] : known) {
                const bool overlaps = its.list == list && gap(asked, its.shell) < -0x1p-20;
                ASSERT_GE(std::ranges::count(found, other), overlaps ? 1 : 0) << other;
            }
        }
    }
    EXPECT_GT(found_in_all, static_cast<std::size_t>(balls));
}

TEST(ShellLists, FindWhatOverlapsAsAPlainTableDoes) {
    expect_a_plain_table<2>(1, 1, 3);
    expect_a_plain_table<2>(2, 3, 40);
    expect_a_plain_table<3>(3, 2, 40);
    expect_a_plain_table<3>(4, 16, 30);
}

}  // namespace
}  // namespace signum::motion
