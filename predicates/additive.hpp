#pragma once
/// What the three metrics with additive weights share: distance |x-c| - r in some norm.

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>

namespace signum::additive {

/// The stages that a predicate has.
enum class Stages {
    exact,          ///< a filter, and exact arithmetic behind it
    naive,          ///< rounded arithmetic alone, whose word is taken for the truth
    multiprecision  ///< rationals alone
};

/// Whether site a (of index a_index) comes before site b in the tie rule's order: by falling
/// radius, then rising x, y and index. The first site of all is hidden by none.
[[nodiscard]] inline bool precedes(const Site& a, Index a_index, const Site& b,
                                   Index b_index) noexcept {
    if (a.r != b.r) return a.r > b.r;
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a_index < b_index;
}

}  // namespace signum::additive
