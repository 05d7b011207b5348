#include "spatial_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <span>

#include "insertion_rounds.hpp"

namespace signum::triangulation {
namespace {

/// The Hilbert curve as an automaton: four orientations of the curve in a cell, four bits of x and
/// y a step. An entry holds eight bits of the curve's parameter and the orientation that follows.
struct Step {
    std::uint8_t curve;
    std::uint8_t orientation;
};
using StepTable = std::array<std::array<Step, 256>, 4>;

constexpr StepTable make_steps() {
    // One bit a step: orientation o visits quadrant (x,y) as number `visit`, and turns into
    // `turned`.
    struct Bit {
        std::uint8_t visit;
        std::uint8_t turned;
    };
    constexpr Bit bits[4][4] = {{{0, 1}, {1, 0}, {3, 3}, {2, 0}},
                                {{0, 0}, {3, 2}, {1, 1}, {2, 1}},
                                {{2, 2}, {3, 1}, {1, 2}, {0, 3}},
                                {{2, 3}, {1, 3}, {3, 0}, {0, 2}}};
    StepTable table{};
    for (unsigned orientation = 0; orientation < 4; ++orientation)
        for (unsigned cell = 0; cell < 256; ++cell) {
            const unsigned x = cell >> 4;
            const unsigned y = cell & 15;
            unsigned now = orientation;
            unsigned curve = 0;
            for (int bit = 3; bit >= 0; --bit) {
                const Bit step = bits[now][2 * (x >> bit & 1) + (y >> bit & 1)];
                curve = curve << 2 | step.visit;
                now = step.turned;
            }
            table[orientation][cell] = {static_cast<std::uint8_t>(curve),
                                        static_cast<std::uint8_t>(now)};
        }
    return table;
}

constexpr StepTable steps = make_steps();
constexpr int bits_per_step = 4;

/// The parameter on the curve of cell (x, y) of a board of 2^bits cells a side.
std::uint64_t hilbert(std::uint32_t x, std::uint32_t y, int bits) noexcept {
    std::uint64_t curve = 0;
    unsigned orientation = 0;
    for (int shift = bits - bits_per_step; shift >= 0; shift -= bits_per_step) {
        const Step step = steps[orientation][(x >> shift & 15) << 4 | (y >> shift & 15)];
        curve = curve << 8 | step.curve;
        orientation = step.orientation;
    }
    return curve;
}

/// What is sorted: round, place on the curve and site in one number, from high bits to low. The
/// site takes as many bits as the number of sites asks, the round four, the curve the rest.
struct Layout {
    explicit Layout(std::size_t sites)
        : site_bits(static_cast<int>(std::bit_width(sites))),
          axis_bits((60 - site_bits) / 2 / bits_per_step * bits_per_step) {}

    [[nodiscard]] std::size_t site(std::uint64_t item) const noexcept {
        return item & ((std::uint64_t{1} << site_bits) - 1);
    }
    [[nodiscard]] std::uint64_t key(std::uint64_t item) const noexcept { return item >> site_bits; }

    int site_bits;
    int axis_bits;
};

/// Orders items by the round that they carry and along the curve over their own bounding box; goes
/// on inside the cells that hold many.
void order(std::span<std::uint64_t> items, const Layout& layout, const StridedSites& sites) {
    AxisRange x;
    AxisRange y;
    for (const std::uint64_t item : items) {
        const Site site = sites[layout.site(item)];
        x.include(site.x);
        y.include(site.y);
    }
    if (x.is_point() && y.is_point()) return;
    for (std::uint64_t& item : items) {
        const Site site = sites[layout.site(item)];
        item |= hilbert(x.cell(site.x, layout.axis_bits), y.cell(site.y, layout.axis_bits),
                        layout.axis_bits)
                << layout.site_bits;
    }
    boost::sort::spreadsort::integer_sort(items.begin(), items.end());

    constexpr std::size_t crowd = 64;
    for (std::size_t first = 0; first < items.size();) {
        const std::uint64_t key = layout.key(items[first]);
        std::size_t last = first + 1;
        while (last < items.size() && layout.key(items[last]) == key) ++last;
        // The corners of a bounding box lie in different cells, so that a cell holds fewer.
        if (last - first > crowd && last - first < items.size()) {
            const std::span<std::uint64_t> cell = items.subspan(first, last - first);
            for (std::uint64_t& item : cell) item = layout.site(item);
            order(cell, layout, sites);
        }
        first = last;
    }
}

}  // namespace

LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed) {
    const InsertionRounds rounds(sites.size(), seed);
    const Layout layout(sites.size());
    LargeArray<std::uint64_t> items(sites.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        items[i] = static_cast<std::uint64_t>(rounds.of(i)) << 60 | i;
    }
    order({items.data(), items.size()}, layout, sites);

    LargeArray<Index> result(items.size());
    for (std::size_t i = 0; i < items.size(); ++i)
        result[i] = static_cast<Index>(layout.site(items[i]));
    return result;
}

}  // namespace signum::triangulation
