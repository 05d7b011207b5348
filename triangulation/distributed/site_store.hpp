#pragma once
/// The sites that a part owns, for others to ask about.

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "../../core/box_tree.hpp"
#include "exchange.hpp"

namespace signum::distributed {

/// Throws std::invalid_argument for weights in a metric without them, for another metric of space
/// than that of power, and for a number that is not finite, naming the site.
void check(std::span<const Placed> sites, const Kind& kind);

/// Puts sites in an order in which those that follow one another are near. O(n log n).
void order_along_curve(std::span<Placed> sites, const Kind& kind);

class SiteStore {
 public:
    /// Nothing is copied: the sites, along a curve, may lie in a file that is mapped. A tree keeps
    /// the bounds of a hundred of them at a time. O(n).
    SiteStore(std::span<const Placed> sites, const Kind& kind);

    [[nodiscard]] std::span<const Placed> sites() const noexcept { return sites_; }
    [[nodiscard]] const Kind& kind() const noexcept { return kind_; }
    /// Of all sites.
    [[nodiscard]] const Extent& extent() const noexcept { return extent_; }
    /// Of all but some, sorted by id. O(n log of how many these are).
    [[nodiscard]] Extent extent_but(std::span<const Placed> some) const;
    /// Those sites of which may_be(extent) says so, as of all extents that they are in.
    [[nodiscard]] std::vector<Placed> sites_where(
        const std::function<bool(const Extent&)>& may_be) const;
    /// A store of other sites, of the same kind.
    [[nodiscard]] SiteStore of(std::span<const Placed> sites) const { return {sites, kind_}; }
    /// How far apart sites are that fill their box evenly; 0 of none.
    [[nodiscard]] double spacing() const noexcept;
    /// May be called by several threads.
    [[nodiscard]] Answers answer(const Questions& questions) const;

 private:
    std::span<const Placed> sites_;
    Kind kind_;
    Extent extent_;
    BoxTree<4> tree_;
};

}  // namespace signum::distributed
