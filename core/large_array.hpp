#pragma once
/// Large working arrays: std::vector without needless zeros.
///
/// An array that is filled at once need not be zeroed before, and of one that is filled in part
/// only that part is to be touched: elements of trivial type, and sites, have no value where they
/// are made without one.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "site.hpp"

namespace signum {

/// Whether an array's elements are filled by their constructor. Sites begin to live without it.
template <class T>
inline constexpr bool begins_with_value = !std::is_trivially_default_constructible_v<T>;
template <>
inline constexpr bool begins_with_value<Point> = false;
template <>
inline constexpr bool begins_with_value<Point3> = false;
template <>
inline constexpr bool begins_with_value<Site> = false;
template <>
inline constexpr bool begins_with_value<Site3> = false;
template <>
inline constexpr bool begins_with_value<power::Site> = false;
template <>
inline constexpr bool begins_with_value<power::Site3> = false;

/// Which pages an array's memory comes in: 4 KiB each, or 2 MiB. Where the system has no large ones
/// at hand it stops to collect them, which may double the time of a construction: its arrays have
/// ordinary ones. Balls of a simulation are read in any order for as long as it runs, and large
/// pages, of which the processor can remember all, pay.
enum class Pages { ordinary, large };

template <class T, Pages pages>
class LargeAllocator {
 public:
    using value_type = T;
    template <class Other>
    struct rebind {
        using other = LargeAllocator<Other, pages>;
    };
    LargeAllocator() = default;
    template <class U>
    // NOLINTNEXTLINE(google-explicit-constructor): what the standard asks of an allocator
    LargeAllocator(const LargeAllocator<U, pages>&) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        static_assert(alignof(T) <= 64);
        const std::size_t bytes = count * sizeof(T);
        void* const memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
        // A wish; what the system makes of it does not matter.
        if (are_large(bytes)) ::madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        ::operator delete(memory, alignment(count * sizeof(T)));
    }

    template <class U>
    void construct(U* place) noexcept(std::is_nothrow_default_constructible_v<U>) {
        if constexpr (begins_with_value<U>) ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }

    template <class U>
    friend bool operator==(const LargeAllocator&, const LargeAllocator<U, pages>&) noexcept {
        return true;
    }

 private:
    static constexpr std::size_t large_page = std::size_t{1} << 21;

    static constexpr bool are_large(std::size_t bytes) noexcept {
        return pages == Pages::large && bytes >= large_page;
    }
    /// Of a cache line, which a face is then never across, or of a page.
    static constexpr std::align_val_t alignment(std::size_t bytes) noexcept {
        return std::align_val_t{are_large(bytes) ? large_page : 64};
    }
};

template <class T, Pages pages = Pages::ordinary>
using LargeArray = std::vector<T, LargeAllocator<T, pages>>;

/// Empties an array and gives its memory back, which `array = {}` would keep.
template <class T, class Allocator>
void release(std::vector<T, Allocator>& array) noexcept {
    std::vector<T, Allocator>().swap(array);
}

}  // namespace signum
