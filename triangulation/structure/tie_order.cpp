#include "tie_order.hpp"

#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstdint>
#include <vector>

namespace signum::triangulation {

namespace {

struct Entry {
    std::uint64_t key;
    Index place;
};

/// Doubles as integers of the same order; -0 counts as 0.
std::uint64_t rising(double value) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
    const std::uint64_t sign = std::uint64_t{1} << 63;
    return (bits & sign) != 0 ? ~bits : bits | sign;
}

/// The numbers that the order compares, one after the other.
std::uint64_t key_of(const Site& site, Index original, int level) noexcept {
    switch (level) {
        case 0:
            return ~rising(site.r);
        case 1:
            return rising(site.x);
        case 2:
            return rising(site.y);
        default:
            return static_cast<std::uint64_t>(original);
    }
}

}  // namespace

void rank(std::span<RankedSite> sites, std::span<const Index> original) {
    std::vector<Entry> order(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i].place = static_cast<Index>(i);
    // By the first number; then those that are equal by the next one, as long as there are any.
    const auto sort = [&](auto self, std::span<Entry> entries, int level) -> void {
        for (Entry& entry : entries) {
            const auto place = static_cast<std::size_t>(entry.place);
            entry.key = key_of(sites[place], original[place], level);
        }
        boost::sort::spreadsort::integer_sort(
            entries.begin(), entries.end(),
            [](const Entry& entry, unsigned shift) { return entry.key >> shift; },
            [](const Entry& a, const Entry& b) { return a.key < b.key; });
        for (std::size_t first = 0; first < entries.size();) {
            std::size_t last = first + 1;
            while (last < entries.size() && entries[last].key == entries[first].key) ++last;
            if (last - first > 1) self(self, entries.subspan(first, last - first), level + 1);
            first = last;
        }
    };
    sort(sort, order, 0);
    for (std::size_t place = 0; place < order.size(); ++place)
        sites[static_cast<std::size_t>(order[place].place)].rank = static_cast<Index>(place);
}

}  // namespace signum::triangulation
