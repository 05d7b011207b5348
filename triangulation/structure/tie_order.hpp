#pragma once
/// The order of the tie rule in the additive metrics: by falling radius, then rising x, y, index.

#include <span>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../core/site.hpp"

namespace signum::triangulation {

/// A site with its place in the order: together, for who asks about the one needs the other.
struct alignas(32) RankedSite : Site {
    Index rank;
};

/// Gives every site its place in the order; original[i] is the input's number of site i. O(n log
/// n).
void rank(std::span<RankedSite> sites, std::span<const Index> original, const Workers& workers);

}  // namespace signum::triangulation

namespace signum {
template <>
inline constexpr bool begins_with_value<triangulation::RankedSite> = false;
}  // namespace signum
