#pragma once
/// Lists of numbered items, each item in one of them at most; it joins and leaves in O(1).

#include <cstddef>
#include <utility>
#include <vector>

#include "../../core/contract.hpp"
#include "../../core/index.hpp"

namespace signum::triangulation {

class Lists {
 public:
    /// Room for that many; what is there stays.
    void make_room(std::size_t lists, std::size_t items) {
        first_.resize(lists, none);
        links_.resize(items);
    }
    void clear() noexcept {
        for (Index& first : first_) first = none;
        items_ = 0;
    }

    /// Where all lists are empty none is looked at.
    [[nodiscard]] bool is_empty(Index list) const noexcept {
        return items_ == 0 || first_[at(list)] == none;
    }

    /// Precondition: the item is in no list.
    void add(Index list, Index item) noexcept {
        ++items_;
        Index& first = first_[at(list)];
        links_[at(item)] = {~list, first};
        if (first != none) links_[at(first)].before = item;
        first = item;
    }
    /// Precondition: the item is in a list.
    void remove(Index item) noexcept {
        --items_;
        const auto [before, after] = links_[at(item)];
        if (after != none) links_[at(after)].before = before;
        (before < 0 ? first_[at(~before)] : links_[at(before)].after) = after;
    }
    /// Takes the items out for which `is_meant` holds, and appends them.
    template <class IsMeant>
    void extract(Index list, std::vector<Index>& items, const IsMeant& is_meant) {
        for (Index item = first_[at(list)]; item != none;) {
            const Index after = links_[at(item)].after;
            if (is_meant(item)) {
                remove(item);
                items.push_back(item);
            }
            item = after;
        }
    }
    /// Takes all items out.
    [[nodiscard]] std::vector<Index> release(Index list) {
        std::vector<Index> items;
        for (Index item = std::exchange(first_[at(list)], none); item != none;
             item = links_[at(item)].after)
            items.push_back(item);
        items_ -= items.size();
        return items;
    }

 private:
    static constexpr Index none = -1;
    struct Link {
        Index before;  ///< the item before, or of the first one the list's number, complemented
        Index after;
    };
    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }

    std::vector<Index> first_;
    std::vector<Link> links_;
    std::size_t items_ = 0;
};

}  // namespace signum::triangulation
