#include <signum/triangulation/tie_order.hpp>

#include <algorithm>
#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cstdint>
#include <vector>

#include <signum/predicates/additive.hpp>

namespace signum::triangulation {

void rank(std::span<RankedSite> sites, std::span<const Index> original) {
    struct Entry {
        std::uint64_t key;  ///< rises as the radius falls
        Index place;
    };
    const auto site = [&](const Entry& entry) -> const Site& {
        return sites[static_cast<std::size_t>(entry.place)];
    };
    const auto number_of = [&](const Entry& entry) {
        return original[static_cast<std::size_t>(entry.place)];
    };
    std::vector<Entry> order(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        // Doubles as integers of the same order; -0 counts as 0.
        const auto bits = std::bit_cast<std::uint64_t>(sites[i].r + 0.0);
        const std::uint64_t sign = std::uint64_t{1} << 63;
        order[i] = {(bits & sign) != 0 ? bits : ~(bits | sign), static_cast<Index>(i)};
    }
    boost::sort::spreadsort::integer_sort(
        order.begin(), order.end(),
        [](const Entry& entry, unsigned shift) { return entry.key >> shift; },
        [](const Entry& a, const Entry& b) { return a.key < b.key; });
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first + 1;
        while (last < order.size() && order[last].key == order[first].key) ++last;
        const auto at = [&](std::size_t i) {
            return order.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (last - first > 1)
            std::sort(at(first), at(last), [&](const Entry& a, const Entry& b) {
                return additive::precedes(site(a), number_of(a), site(b), number_of(b));
            });
        first = last;
    }
    for (std::size_t place = 0; place < order.size(); ++place)
        sites[static_cast<std::size_t>(order[place].place)].rank = static_cast<Index>(place);
}

}  // namespace signum::triangulation
