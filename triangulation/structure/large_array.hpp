#pragma once
/// The working arrays of a construction: std::vector with pages that fit and without needless
/// zeros.
///
/// An insertion touches memory all over; with pages of 4 KiB a tenth of its time goes into page
/// tables. Linux gives pages of 2 MiB to those who ask. And an array that is filled at once need
/// not be zeroed before: elements of trivial type made without a value have none. Results are plain
/// vectors, which may wish for such pages too.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace signum::triangulation {

/// Memory for an array, on huge pages where it is large and the system has them. Throws
/// std::bad_alloc.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void free_pages(void* memory) noexcept;

/// Asks the system for huge pages within memory that nobody has touched yet.
void prefer_huge_pages(void* memory, std::size_t bytes) noexcept;

/// A vector of `count` elements on huge pages, if the system has them.
template <class T>
[[nodiscard]] std::vector<T> large_vector(std::size_t count) {
    std::vector<T> result;
    result.reserve(count);
    prefer_huge_pages(result.data(), count * sizeof(T));
    result.resize(count);
    return result;
}

template <class T>
class LargeAllocator {
 public:
    using value_type = T;
    LargeAllocator() = default;
    template <class U>
    // NOLINTNEXTLINE(google-explicit-constructor): what the standard asks of an allocator
    LargeAllocator(const LargeAllocator<U>&) noexcept {}

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_pages(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t) noexcept { free_pages(memory); }

    template <class U>
    void construct(U* place) noexcept(std::is_nothrow_default_constructible_v<U>) {
        ::new (static_cast<void*>(place)) U;
    }
    template <class U, class... Arguments>
    void construct(U* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
    }

    template <class U>
    friend bool operator==(const LargeAllocator&, const LargeAllocator<U>&) noexcept {
        return true;
    }
};

template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace signum::triangulation
