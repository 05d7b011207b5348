#pragma once
/// The order of the tie rule in the additive metrics: by falling radius, then rising x, y, index.

#include <algorithm>
#include <vector>

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>
#include <signum/predicates/additive.hpp>

namespace signum::triangulation {

/// A site with its place in the order: together, for who asks about the one needs the other.
struct alignas(32) RankedSite : Site {
    Index rank;
};

/// Gives every site its place in the order. number_of(i) is the input's number of site i.
template <class Sites, class NumberOf>
void rank(Sites& sites, NumberOf number_of) {
    std::vector<RankedSite> order(sites.begin(), sites.end());
    for (std::size_t i = 0; i < order.size(); ++i) order[i].rank = static_cast<Index>(i);
    std::sort(order.begin(), order.end(), [&](const RankedSite& a, const RankedSite& b) {
        return additive::precedes(a, number_of(a.rank), b, number_of(b.rank));
    });
    for (std::size_t place = 0; place < order.size(); ++place)
        sites[static_cast<std::size_t>(order[place].rank)].rank = static_cast<Index>(place);
}

}  // namespace signum::triangulation
