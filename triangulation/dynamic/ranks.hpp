#pragma once
/// The tie rule's order of sites that come and go.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

#include "../../core/index.hpp"
#include "../../predicates/additive.hpp"
#include "../structure/tie_order.hpp"

namespace signum::triangulation {

/// Places in the tie rule's order that leave room between them: only their order counts.
class Ranks {
 public:
    explicit Ranks(std::vector<RankedSite>& sites) : sites_(sites), order_(Before{&sites}) {}

    void insert(Index site) {
        const auto place = order_.insert(site).first;
        const std::int64_t below =
            place == order_.begin() ? -1 : sites_[at(*std::prev(place))].rank;
        const std::int64_t above = std::next(place) == order_.end()
                                       ? std::numeric_limits<Index>::max()
                                       : sites_[at(*std::next(place))].rank;
        if (above - below < 2) {
            spread();
        } else {
            sites_[at(site)].rank = static_cast<Index>(below + (above - below) / 2);
        }
    }
    void erase(Index site) { order_.erase(site); }

 private:
    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    struct Before {
        const std::vector<RankedSite>* sites;
        bool operator()(Index a, Index b) const {
            return additive::precedes((*sites)[at(a)], a, (*sites)[at(b)], b);
        }
    };
    void spread() {
        const std::int64_t step =
            std::numeric_limits<Index>::max() / static_cast<std::int64_t>(order_.size() + 1);
        std::int64_t rank = 0;
        for (const Index site : order_) sites_[at(site)].rank = static_cast<Index>(rank += step);
    }

    std::vector<RankedSite>& sites_;
    std::set<Index, Before> order_;
};

}  // namespace signum::triangulation
