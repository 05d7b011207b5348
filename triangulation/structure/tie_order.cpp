#include "tie_order.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstdint>
#include <vector>

#include "../../core/insertion_rounds.hpp"
#include "../../core/large_array.hpp"

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

void rank(std::span<RankedSite> sites, std::span<const Index> original, const Workers& workers) {
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
    // Dealt into buckets by samples first, for each to be sorted by itself.
    const auto key = [&](std::size_t i) {
        return std::array{key_of(sites[i], original[i], 0), key_of(sites[i], original[i], 1),
                          key_of(sites[i], original[i], 2), key_of(sites[i], original[i], 3)};
    };
    const std::size_t buckets = workers.range_count(sites.size());
    std::vector<std::array<std::uint64_t, 4>> samples(buckets > 1 ? 64 * buckets : 0);
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = key(mix(k) % sites.size());
    std::sort(samples.begin(), samples.end());
    std::vector<std::array<std::uint64_t, 4>> bounds;
    for (std::size_t b = 1; b < buckets; ++b) bounds.push_back(samples[64 * b]);
    LargeArray<std::uint16_t> bucket(sites.size());
    workers.each_range(sites.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            bucket[i] = static_cast<std::uint16_t>(
                std::upper_bound(bounds.begin(), bounds.end(), key(i)) - bounds.begin());
    });
    LargeArray<Entry> order;
    const std::vector<std::size_t> begins = deal(
        workers, sites.size(), buckets, [&](std::size_t i) { return bucket[i]; },
        [&](std::size_t all) { order = LargeArray<Entry>(all); },
        [&](std::size_t i, std::size_t place) { order[place].place = static_cast<Index>(i); });
    workers.each(buckets, [&](std::size_t b) {
        sort(sort, std::span(order).subspan(begins[b], begins[b + 1] - begins[b]), 0);
        for (std::size_t place = begins[b]; place < begins[b + 1]; ++place)
            sites[static_cast<std::size_t>(order[place].place)].rank = static_cast<Index>(place);
    });
}

}  // namespace signum::triangulation
