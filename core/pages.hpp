#pragma once
/// Pages of memory that is about to be written, asked for many at a time: a fault a page is a large
/// part of what a construction of many sites takes, the more so in a virtual machine. Wishes, all
/// of them: what the system makes of them does not matter.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace signum {

/// This memory will be written soon. Of what is small nothing is asked.
inline void expect_writes(void* memory, std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
    constexpr std::size_t enough = std::size_t{1} << 16;
    if (bytes < enough) return;
    constexpr std::uintptr_t page = 4096;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_WRITE);
#else
    static_cast<void>(memory);
    static_cast<void>(bytes);
#endif
}

/// What is in this memory will not be read again.
inline void expect_nothing(void* memory, std::size_t bytes) noexcept {
#if defined(__linux__)
    constexpr std::uintptr_t page = 4096;
    const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) / page * page;
    const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
    if (begin < end) ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
#else
    static_cast<void>(memory);
    static_cast<void>(bytes);
#endif
}

/// As much as the array has room for.
template <class T, class Allocator>
void expect_writes(std::vector<T, Allocator>& array) noexcept {
    expect_writes(array.data(), array.capacity() * sizeof(T));
}

/// The pages of an array that grows within its capacity, from its first element to its last: a
/// megabyte at a time.
class PagesAhead {
 public:
    /// Before the array grows to this size.
    template <class T>
    void grow(std::vector<T>& array, std::size_t size) noexcept {
        if (size <= asked_) [[likely]]
            return;
        constexpr std::size_t step = (std::size_t{1} << 20) / sizeof(T);
        const std::size_t from = array.size();
        asked_ = size + step;
        const std::size_t to = std::min(asked_, array.capacity());
        if (from < to) expect_writes(array.data() + from, (to - from) * sizeof(T));
    }

 private:
    std::size_t asked_ = 0;  // elements
};

}  // namespace signum
