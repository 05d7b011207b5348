#pragma once
/// The working arrays of a construction: std::vector without needless zeros.
///
/// An array that is filled at once need not be zeroed before, and of one that is filled in part
/// only that part is to be touched: elements of trivial type made without a value have none. Pages
/// are those that the system gives: asked for huge ones it may stop to collect them, and a
/// construction take twice its time by luck.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace signum::triangulation {

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
        return static_cast<T*>(::operator new(count * sizeof(T), alignment));
    }
    void deallocate(T* memory, std::size_t /*count*/) noexcept {
        ::operator delete(memory, alignment);
    }

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

 private:
    /// Of a cache line, which a face is then never across.
    static constexpr std::align_val_t alignment{64};
};

template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

}  // namespace signum::triangulation
