#include <signum/triangulation/spatial_order.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <span>

namespace signum::triangulation {
namespace {

/// The Hilbert curve as an automaton: four orientations of the curve in a cell, four bits of x and y a
/// step. An entry holds eight bits of the curve's parameter and the orientation that follows.
struct Step {
    std::uint8_t curve;
    std::uint8_t orientation;
};
using StepTable = std::array<std::array<Step, 256>, 4>;

constexpr StepTable make_steps() {
    // One bit a step: orientation o visits quadrant (x,y) as number `visit`, and turns into `turned`.
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
constexpr int bits_per_axis = 28;

/// The parameter on the curve of cell (x, y) of a 2^28 by 2^28 board.
std::uint64_t hilbert(std::uint32_t x, std::uint32_t y) noexcept {
    std::uint64_t curve = 0;
    unsigned orientation = 0;
    for (int shift = bits_per_axis - 4; shift >= 0; shift -= 4) {
        const Step step = steps[orientation][(x >> shift & 15) << 4 | (y >> shift & 15)];
        curve = curve << 8 | step.curve;
        orientation = step.orientation;
    }
    return curve;
}

struct Item {
    std::uint64_t key;
    Index site;
    bool operator<(const Item& other) const noexcept { return key < other.key; }
};

struct ItemShift {
    std::uint64_t operator()(const Item& item, unsigned offset) const noexcept {
        return item.key >> offset;
    }
};

/// A range of one coordinate, halved so that its extent cannot overflow.
struct Range {
    double least = 0x1p1023;
    double extent = 0.0;
};

template <class Coordinate>
Range range_of(std::span<const Item> items, Coordinate coordinate) {
    double least = 0x1p1023;
    double greatest = -0x1p1023;
    for (const Item& item : items) {
        const double half = 0.5 * coordinate(item.site);
        least = std::min(least, half);
        greatest = std::max(greatest, half);
    }
    return {least, greatest - least};
}

std::uint32_t quantize(double value, Range range) noexcept {
    constexpr double board = std::uint32_t{1} << bits_per_axis;
    if (!(range.extent > 0.0)) return 0;
    const double cell = (0.5 * value - range.least) / range.extent * board;
    return static_cast<std::uint32_t>(std::min(cell, board - 1.0));
}

/// Orders items by the bits that their keys have already (the round) and then along the curve over their
/// own bounding box; goes on inside the cells that hold many.
void order(std::span<Item> items, const StridedSites& sites) {
    const auto x_of = [&](Index i) { return sites[static_cast<std::size_t>(i)].x; };
    const auto y_of = [&](Index i) { return sites[static_cast<std::size_t>(i)].y; };
    const Range x = range_of(items, x_of);
    const Range y = range_of(items, y_of);
    if (!(x.extent > 0.0) && !(y.extent > 0.0)) return;
    for (Item& item : items)
        item.key |= hilbert(quantize(x_of(item.site), x), quantize(y_of(item.site), y));
    boost::sort::spreadsort::integer_sort(items.begin(), items.end(), ItemShift());

    constexpr std::size_t crowd = 64;
    for (std::size_t first = 0; first < items.size();) {
        std::size_t last = first + 1;
        while (last < items.size() && items[last].key == items[first].key) ++last;
        if (last - first > crowd) {
            const std::span<Item> cell = items.subspan(first, last - first);
            for (Item& item : cell) item.key = 0;
            if (cell.size() < items.size()) order(cell, sites);
        }
        first = last;
    }
}

/// A well-mixed function of 64 bits (the finalizer of SplitMix64, Steele, Lea and Flood 2014).
std::uint64_t mix(std::uint64_t bits) noexcept {
    bits = (bits ^ bits >> 30) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ bits >> 27) * 0x94D049BB133111EBU;
    return bits ^ bits >> 31;
}

}  // namespace

LargeArray<Index> spatial_order(const StridedSites& sites, std::uint64_t seed) {
    // A round holds an eighth of what remains for it and the earlier ones; the first about a hundred.
    int rounds = 0;
    for (std::size_t n = sites.size(); n > 1000; n /= 8) ++rounds;

    LargeArray<Item> items(sites.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::uint64_t random = mix(mix(seed) + i * 0x9E3779B97F4A7C15U);
        const int round = rounds - std::min(rounds, std::countr_zero(random) / 3);
        items[i] = {static_cast<std::uint64_t>(round) << 2 * bits_per_axis, static_cast<Index>(i)};
    }
    order(items, sites);

    LargeArray<Index> result(items.size());
    std::transform(items.begin(), items.end(), result.begin(),
                   [](const Item& item) { return item.site; });
    return result;
}

}  // namespace signum::triangulation
