#include "large_array.hpp"

#include <cstdint>
#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace signum::triangulation {
namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;

}  // namespace

void* allocate_pages(std::size_t bytes) {
    const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : std::size_t{64};
    // Whole multiples of the alignment, as the standard asks, and at least one.
    const std::size_t rounded = (bytes / alignment + 1) * alignment;
    void* memory = std::aligned_alloc(alignment, rounded);
    if (memory == nullptr) throw std::bad_alloc();
    prefer_huge_pages(memory, rounded);
    return memory;
}

void prefer_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    // Whole pages inside the array; the ends are shared with others.
    auto* const begin = static_cast<std::byte*>(memory);
    const std::size_t skip =
        (huge_page - reinterpret_cast<std::uintptr_t>(begin) % huge_page) % huge_page;
    if (bytes < skip + huge_page) return;
    madvise(begin + skip, (bytes - skip) / huge_page * huge_page, MADV_HUGEPAGE);  // may be refused
#endif
}

void free_pages(void* memory) noexcept {
    std::free(memory);
}

}  // namespace signum::triangulation
