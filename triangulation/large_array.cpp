#include <signum/triangulation/large_array.hpp>

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace signum::triangulation {

void* allocate_pages(std::size_t bytes) {
    constexpr std::size_t huge_page = std::size_t{1} << 21;
    const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : std::size_t{64};
    // Whole multiples of the alignment, as the standard asks, and at least one.
    const std::size_t rounded = (bytes / alignment + 1) * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (memory == nullptr) throw std::bad_alloc();
#if defined(__linux__)
    if (alignment == huge_page) madvise(memory, rounded, MADV_HUGEPAGE);  // a wish; may be refused
#endif
    return memory;
}

void free_pages(void* memory) noexcept { std::free(memory); }

}  // namespace signum::triangulation
