#pragma once
/// The order of the tie rule in the additive metrics: by falling radius, then rising x, y, index.

#include <algorithm>
#include <numeric>
#include <vector>

#include <signum/core/index.hpp>
#include <signum/predicates/additive.hpp>

namespace signum::triangulation {

/// The place of every site in the order. number_of(i) is the input's number of site i.
template <class Sites, class NumberOf>
[[nodiscard]] std::vector<Index> ranks_of(const Sites& sites, NumberOf number_of) {
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    std::vector<Index> order(sites.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return additive::precedes(sites[at(a)], number_of(a), sites[at(b)], number_of(b));
    });
    std::vector<Index> ranks(sites.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        ranks[at(order[place])] = static_cast<Index>(place);
    return ranks;
}

/// The same for sites in the order of the input.
template <class Sites>
[[nodiscard]] std::vector<Index> ranks_of(const Sites& sites) {
    return ranks_of(sites, [](Index i) { return i; });
}

}  // namespace signum::triangulation
