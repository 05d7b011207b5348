#pragma once
/// The tie rule's order of sites that come, go and move.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../predicates/additive.hpp"
#include "../structure/tie_order.hpp"

namespace signum::triangulation {

/// Places in the tie rule's order that leave room between them: only their order counts.
///
/// Law: the sites stand in order_ or, after all have moved, in sorted_; the other one is empty. A
/// tree is made when a site comes or goes, and not before: to make one takes longer than to sort.
class Ranks {
 public:
    /// originals[i] is what the rule knows site i by. None is copied.
    Ranks(std::vector<RankedSite>& sites, const std::vector<Index>& originals)
        : sites_(sites), originals_(originals), order_(Before{&sites, &originals}) {}

    void insert(Index site) {
        grow_tree();
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
    void erase(Index site) {
        grow_tree();
        order_.erase(site);
    }

    /// The same sites at other centres: those of `moved`, an array like that of the sites, which
    /// takes their place next. They get their ranks there. O(n) where the order has not changed.
    void renew(std::vector<RankedSite>& moved) {
        if (sorted_.empty()) sorted_.assign(order_.begin(), order_.end());
        order_.clear();
        if (std::ranges::is_sorted(sorted_, Before{&moved, &originals_})) return;
        // Places that no site has are ranked along with the others.
        rank(moved, originals_, Workers(1));
        std::vector<Index> by_rank(moved.size(), -1);
        for (const Index site : sorted_) by_rank[at(moved[at(site)].rank)] = site;
        std::erase(by_rank, -1);
        sorted_ = std::move(by_rank);
    }
    /// Other numbers for the sites: the first `count` are there.
    void restart(std::size_t count) {
        order_.clear();
        const std::span sites = std::span(sites_).first(count);
        rank(sites, std::span(originals_).first(count), Workers(1));
        sorted_.resize(count);
        for (std::size_t i = 0; i < count; ++i) sorted_[at(sites[i].rank)] = static_cast<Index>(i);
    }

 private:
    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    struct Before {
        const std::vector<RankedSite>* sites;
        const std::vector<Index>* originals;
        bool operator()(Index a, Index b) const {
            return additive::precedes((*sites)[at(a)], (*originals)[at(a)], (*sites)[at(b)],
                                      (*originals)[at(b)]);
        }
    };
    void grow_tree() {
        for (const Index site : sorted_) order_.insert(order_.end(), site);
        sorted_.clear();
    }
    void spread() {
        const std::int64_t step =
            std::numeric_limits<Index>::max() / static_cast<std::int64_t>(order_.size() + 1);
        std::int64_t rank = 0;
        for (const Index site : order_) sites_[at(site)].rank = static_cast<Index>(rank += step);
    }

    std::vector<RankedSite>& sites_;
    const std::vector<Index>& originals_;
    std::set<Index, Before> order_;
    std::vector<Index> sorted_;
};

}  // namespace signum::triangulation
