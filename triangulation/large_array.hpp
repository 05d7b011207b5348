#pragma once
/// A flat array for millions of elements: uninitialized, of fixed size, on huge pages where it is large.
///
/// The passes over a tessellation touch memory all over; with pages of 4 KiB much of their time would
/// go into page tables. Linux gives pages of 2 MiB to those who ask; elsewhere this is a plain array.

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>
#include <type_traits>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace signum::triangulation {

template <class T>
class LargeArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
    LargeArray() = default;
    explicit LargeArray(std::size_t size) : data_(allocate(size)), size_(size) {}
    LargeArray(std::size_t size, const T& value) : LargeArray(size) {
        std::uninitialized_fill_n(data_.get(), size, value);
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] T* data() const noexcept { return data_.get(); }
    [[nodiscard]] T& operator[](std::size_t i) const noexcept { return data_.get()[i]; }
    [[nodiscard]] T* begin() const noexcept { return data(); }
    [[nodiscard]] T* end() const noexcept { return data() + size_; }

 private:
    struct Free {
        void operator()(T* data) const noexcept { std::free(data); }
    };

    [[nodiscard]] static T* allocate(std::size_t size) {
        constexpr std::size_t huge_page = std::size_t{1} << 21;
        const std::size_t bytes = size * sizeof(T);
        const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : std::size_t{64};
        // Whole multiples of the alignment, as the standard asks.
        const std::size_t rounded = (bytes + alignment) / alignment * alignment;
        void* data = std::aligned_alloc(alignment, rounded);
        if (data == nullptr) throw std::bad_alloc();
#if defined(__linux__)
        if (alignment == huge_page) madvise(data, rounded, MADV_HUGEPAGE);  // a wish; may be refused
#endif
        return static_cast<T*>(data);
    }

    std::unique_ptr<T, Free> data_;
    std::size_t size_ = 0;
};

}  // namespace signum::triangulation
