/// Asking for pages ahead changes nothing of what lies in them, wherever memory begins and ends.

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "../../core/pages.hpp"

namespace signum {
namespace {

TEST(Pages, WhatIsThereStays) {
    std::vector<unsigned char> memory(300'001);
    for (std::size_t i = 0; i < memory.size(); ++i) memory[i] = static_cast<unsigned char>(i % 251);
    const std::vector<unsigned char> before = memory;
    for (const std::size_t first : {0, 1, 4095, 4096, 100'000})
        for (const std::size_t bytes : {0, 1, 65'536, 70'001, 200'001})
            expect_writes(memory.data() + first, bytes);
    expect_writes(memory);
    EXPECT_EQ(memory, before);
    expect_writes(nullptr, 0);
}

TEST(Pages, AnArrayGrowsWithinItsRoomAndBeyond) {
    constexpr std::size_t room = 1'000'000;
    std::vector<std::size_t> array;
    array.reserve(room);
    PagesAhead pages;
    for (std::size_t size = 0; size < 2 * room; size += 77'777) {
        pages.grow(array, size);
        while (array.size() < size) array.push_back(array.size());
    }
    for (std::size_t i = 0; i < array.size(); ++i) ASSERT_EQ(array[i], i);
}

}  // namespace
}  // namespace signum
