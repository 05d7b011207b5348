#pragma once
/// For each ball a list of others, unordered; many short lists in one pool.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "world.hpp"

namespace signum::motion {

class SlotLists {
 public:
    explicit SlotLists(std::size_t lists) : lists_(lists) {}

    [[nodiscard]] std::span<const Slot> operator[](Slot i) const noexcept {
        const List& list = lists_[i];
        return {pool_.data() + list.begin, list.size};
    }
    void fetch(Slot i) const noexcept { __builtin_prefetch(&lists_[i]); }
    void append(Slot i, Slot j) {
        List& list = lists_[i];
        if (list.size == list.capacity) grow(list);
        pool_[list.begin + list.size++] = j;
        ++entries_;
    }
    /// Each of two in the other's list.
    void link(Slot i, Slot j) {
        append(i, j);
        append(j, i);
    }
    /// Nothing happens where it is not there.
    void remove(Slot i, Slot j) noexcept {
        List& list = lists_[i];
        Slot* const begin = pool_.data() + list.begin;
        Slot* const end = begin + list.size;
        Slot* const found = std::find(begin, end, j);
        if (found == end) return;
        *found = end[-1];
        --list.size;
        --entries_;
    }
    void clear(Slot i) noexcept {
        entries_ -= lists_[i].size;
        lists_[i].size = 0;
    }
    /// Of all lists.
    [[nodiscard]] std::size_t entries() const noexcept { return entries_; }

 private:
    struct List {
        std::uint32_t begin = 0;
        std::uint32_t size = 0;
        std::uint32_t capacity = 0;  // 0 or a power of two
    };

    /// Moves a list to a place twice as large; its old place serves another one.
    [[gnu::noinline]] void grow(List& list) {
        const std::uint32_t capacity = std::max(2 * list.capacity, 4U);
        std::vector<std::uint32_t>& free =
            free_[static_cast<std::size_t>(std::bit_width(capacity))];
        std::uint32_t begin = 0;
        if (free.empty()) {
            if (pool_.size() + capacity > std::numeric_limits<std::uint32_t>::max())
                throw std::length_error(
                    "too many pairs of balls are near one another to be listed");
            begin = static_cast<std::uint32_t>(pool_.size());
            pool_.resize(pool_.size() + capacity);
        } else {
            begin = free.back();
            free.pop_back();
        }
        std::copy_n(pool_.begin() + list.begin, list.size, pool_.begin() + begin);
        if (list.capacity > 0)
            free_[static_cast<std::size_t>(std::bit_width(list.capacity))].push_back(list.begin);
        list.begin = begin;
        list.capacity = capacity;
    }

    LargeArray<List, Pages::large> lists_;
    LargeArray<Slot, Pages::large> pool_;
    std::size_t entries_ = 0;
    std::array<std::vector<std::uint32_t>, 33> free_;
};

}  // namespace signum::motion
