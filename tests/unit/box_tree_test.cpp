/// The tree of boxes: whoever asks it meets what brute force meets, however it was halved.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../core/box_tree.hpp"

namespace signum {
namespace {

using Box = Bounds<3>;

std::vector<Box> random_boxes(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto number = [&](unsigned most) { return static_cast<double>(random() % most); };
    std::vector<Box> boxes(count);
    for (Box& box : boxes)
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = number(50);
            box.high[k] = box.low[k] + number(4);
        }
    return boxes;
}
bool overlap(const Box& a, const Box& b) {
    bool result = true;
    for (std::size_t k = 0; k < 3; ++k)
        result = result && a.low[k] <= b.high[k] && b.low[k] <= a.high[k];
    return result;
}
BoxTree<3> tree_of(const std::vector<Box>& boxes, std::uint32_t most_in_a_leaf, std::size_t axes) {
    return {boxes.size(), most_in_a_leaf, axes, [&](std::size_t i) { return boxes[i]; }};
}

TEST(BoxTree, MeetsWhatBruteForceMeets) {
    for (const std::size_t count : {0U, 1U, 4U, 5U, 300U})
        for (const std::size_t axes : {0U, 2U, 3U})
            for (const std::uint32_t most_in_a_leaf : {1U, 4U, 8U}) {
                const std::vector<Box> boxes = random_boxes(count, 1);
                const BoxTree<3> tree = tree_of(boxes, most_in_a_leaf, axes);
                for (const Box& box : random_boxes(20, 2)) {
                    std::vector<std::uint32_t> met, expected;
                    tree.visit([&](const Box& node) { return overlap(node, box); },
                               [&](std::uint32_t place) {
                                   const std::uint32_t i = tree.order()[place];
                                   if (overlap(boxes[i], box)) met.push_back(i);
                               });
                    for (std::uint32_t i = 0; i < count; ++i)
                        if (overlap(boxes[i], box)) expected.push_back(i);
                    std::ranges::sort(met);
                    EXPECT_EQ(met, expected);
                }
            }
}

TEST(BoxTree, HalvesLieInTheirWholeAndInOrder) {
    const std::vector<Box> boxes = random_boxes(300, 3);
    for (const std::size_t axes : {0U, 3U}) {
        const BoxTree<3> tree = tree_of(boxes, 4, axes);
        for (const auto& node : tree.nodes()) {
            Box around = boxes[tree.order()[node.first]];
            for (std::uint32_t place = node.first; place < node.last; ++place)
                around.include(boxes[tree.order()[place]]);
            EXPECT_EQ(node.low, around.low);
            EXPECT_EQ(node.high, around.high);
            EXPECT_EQ(node.second == 0, node.last - node.first <= 4);
            if (node.second == 0) continue;
            EXPECT_EQ(tree.nodes()[tree.number_of(node) + 1].first, node.first);
            EXPECT_EQ(tree.nodes()[tree.number_of(node) + 1].last, tree.nodes()[node.second].first);
            EXPECT_EQ(tree.nodes()[node.second].last, node.last);
        }
    }
    const BoxTree<3> as_they_come = tree_of(boxes, 4, 0);
    EXPECT_TRUE(std::ranges::is_sorted(as_they_come.order()));
}

TEST(BoxTree, TheNearerHalfFirstUntilOneIsFound) {
    std::vector<Box> boxes;
    for (int i = 0; i < 100; ++i) boxes.push_back(Box::point({static_cast<double>(i), 0.0, 0.0}));
    const BoxTree<3> tree = tree_of(boxes, 1, 1);
    std::vector<std::uint32_t> met;
    const bool is_through =
        tree.visit([](const Box&) { return true; },
                   [](const Box& one, const Box& other) { return one.low[0] < other.low[0]; },
                   [&](const BoxTree<3>::Node& leaf) {
                       met.push_back(tree.order()[leaf.first]);
                       return met.size() < 3;
                   });
    EXPECT_FALSE(is_through);
    EXPECT_EQ(met, (std::vector<std::uint32_t>{99, 98, 97}));
}

TEST(BoxTree, LargestDoublesAndNoEnds) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Box> boxes;
    for (int i = 0; i < 40; ++i) {
        const double x = i % 2 == 0 ? largest : -largest;
        boxes.push_back(i % 5 == 0 ? Box{{-infinity, x, x}, {infinity, x, x}}
                                   : Box::point({x, -x, 0.0}));
    }
    const BoxTree<3> tree = tree_of(boxes, 2, 3);
    std::size_t met = 0;
    tree.visit([](const Box& node) { return node.high[0] > 0.0; },
               [&](std::uint32_t place) { met += boxes[tree.order()[place]].high[0] > 0.0; });
    EXPECT_EQ(met, 24U);
}

}  // namespace
}  // namespace signum
