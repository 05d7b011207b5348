#include "order.hpp"

#include <algorithm>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <span>
#include <vector>

#include "../../core/pages.hpp"
#include "../structure/insertion_rounds.hpp"

namespace signum::spatial {
namespace {

using triangulation::AxisRange;

constexpr int bits = 10;  // of each coordinate in a key

/// A cell of a cube of 2^bits cells a side, by its place on the curve; without a branch, for nobody
/// could foretell it. Source: Skilling, Programming the Hilbert curve, AIP Conference Proceedings
/// 707, 2004.
std::uint32_t hilbert(std::array<std::uint32_t, 3> x) noexcept {
    // All bits where a bit is set, none elsewhere.
    const auto all_if = [](std::uint32_t number, int bit) { return 0U - (number >> bit & 1U); };
    for (int bit = bits - 1; bit > 0; --bit) {
        const std::uint32_t low = (1U << bit) - 1;
        for (std::uint32_t& axis : x) {
            const std::uint32_t is_set = all_if(axis, bit);
            const std::uint32_t exchanged = (x[0] ^ axis) & low & ~is_set;
            x[0] ^= exchanged | (low & is_set);
            axis ^= exchanged;
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    std::uint32_t turned = 0;
    for (int bit = bits - 1; bit > 0; --bit) turned ^= ((1U << bit) - 1) & all_if(x[2], bit);
    for (std::uint32_t& axis : x) axis ^= turned;
    std::uint32_t curve = 0;
    for (int bit = bits - 1; bit >= 0; --bit)
        for (const std::uint32_t axis : x) curve = curve << 1 | (axis >> bit & 1U);
    return curve;
}

using Items = std::span<std::uint64_t>;

/// An item is a key and the number of a site, 32 bits each.
void order(Items items, const std::function<Point3(Index)>& place) {
    std::array<AxisRange, 3> ranges;
    for (const std::uint64_t item : items) {
        const Point3 p = place(static_cast<Index>(item & 0xFFFF'FFFF));
        ranges[0].include(p.x);
        ranges[1].include(p.y);
        ranges[2].include(p.z);
    }
    if (std::ranges::all_of(ranges, &AxisRange::is_point)) return;
    for (std::uint64_t& item : items) {
        const std::uint64_t number = item & 0xFFFF'FFFF;
        const Point3 p = place(static_cast<Index>(number));
        const std::uint32_t key = hilbert(
            {ranges[0].cell(p.x, bits), ranges[1].cell(p.y, bits), ranges[2].cell(p.z, bits)});
        item = std::uint64_t{key} << 32 | number;
    }
    boost::sort::spreadsort::integer_sort(items.begin(), items.end());
    // Cells that hold many are ordered again, on a scale of their own. The corners of a bounding
    // box lie in different cells, so that a cell holds fewer.
    constexpr std::size_t crowd = 64;
    for (std::size_t first = 0; first < items.size();) {
        std::size_t last = first + 1;
        while (last < items.size() && items[last] >> 32 == items[first] >> 32) ++last;
        if (last - first > crowd && last - first < items.size())
            order(items.subspan(first, last - first), place);
        first = last;
    }
}

}  // namespace

LargeArray<Index> insertion_order(std::size_t sites, const std::function<Point3(Index)>& place,
                                  std::uint64_t seed) {
    const triangulation::InsertionRounds rounds(sites, seed);
    // The sites of each round, one round after the other.
    std::vector<std::size_t> sizes(static_cast<std::size_t>(rounds.last()) + 1);
    const auto round_of = [&](std::size_t i) { return static_cast<std::size_t>(rounds.of(i)); };
    for (std::size_t i = 0; i < sites; ++i) ++sizes[round_of(i)];
    std::vector<std::size_t> begins(sizes.size());
    for (std::size_t r = 1; r < sizes.size(); ++r) begins[r] = begins[r - 1] + sizes[r - 1];
    LargeArray<std::uint64_t> items(sites);
    expect_writes(items);
    std::vector<std::size_t> next = begins;
    for (std::size_t i = 0; i < sites; ++i) items[next[round_of(i)]++] = i;
    for (std::size_t r = 0; r < sizes.size(); ++r)
        if (sizes[r] > 0) order(Items(items.data() + begins[r], sizes[r]), place);
    LargeArray<Index> result(sites);
    for (std::size_t i = 0; i < sites; ++i) result[i] = static_cast<Index>(items[i] & 0xFFFF'FFFF);
    return result;
}

}  // namespace signum::spatial
