#pragma once
/// Vectors whose memory comes in large pages where there is much of it: of very many balls nearly
/// every access would otherwise wait for the table of pages, too.

#include <cstddef>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace signum::motion {

template <class T>
class LargePages {
 public:
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>& /*other*/) noexcept {}

    [[nodiscard]] T* allocate(std::size_t number) {
        const std::size_t bytes = number * sizeof(T);
        void* const memory = ::operator new(bytes, alignment(bytes));
#if defined(__linux__)
        // A wish; what the system makes of it does not matter.
        if (bytes >= much) ::madvise(memory, bytes, MADV_HUGEPAGE);
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t number) noexcept {
        ::operator delete(memory, alignment(number * sizeof(T)));
    }
    friend bool operator==(const LargePages&, const LargePages&) {
        return true;
    }

 private:
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::size_t much = page;

    static std::align_val_t alignment(std::size_t bytes) noexcept {
        return std::align_val_t{bytes >= much ? page : alignof(T) > 16 ? alignof(T) : 16};
    }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace signum::motion
