#pragma once
/// Many short lists, unordered, in one pool: for each ball others, for each cell who is there.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "world.hpp"

namespace signum::motion {

template <class T>
class PooledLists {
 public:
    explicit PooledLists(std::size_t lists) : lists_(lists) {}

    [[nodiscard]] std::size_t size() const noexcept { return lists_.size(); }
    [[nodiscard]] std::span<const T> operator[](std::uint32_t i) const noexcept {
        const List& list = lists_[i];
        return {pool_.data() + list.begin, list.size};
    }
    void fetch(std::uint32_t i) const noexcept { __builtin_prefetch(&lists_[i]); }
    void append(std::uint32_t i, const T& thing) {
        List& list = lists_[i];
        if (list.size == list.capacity) grow(list);
        pool_[list.begin + list.size++] = thing;
    }
    /// The first one for which that holds; nothing happens where there is none.
    template <class Is>
    void remove_if(std::uint32_t i, const Is& is) noexcept {
        List& list = lists_[i];
        T* const begin = pool_.data() + list.begin;
        T* const end = begin + list.size;
        T* const found = std::find_if(begin, end, is);
        if (found == end) return;
        *found = end[-1];
        --list.size;
    }
    void clear(std::uint32_t i) noexcept { lists_[i].size = 0; }

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

    std::vector<List> lists_;
    std::vector<T> pool_;
    std::array<std::vector<std::uint32_t>, 33> free_;
};

/// For each ball a list of others.
class SlotLists : public PooledLists<Slot> {
 public:
    using PooledLists::PooledLists;
    void remove(Slot i, Slot j) noexcept {
        remove_if(i, [j](Slot other) { return other == j; });
    }
};

}  // namespace signum::motion
