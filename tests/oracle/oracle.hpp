#pragma once
/// The result type of the brute-force oracles: slow, obviously right, independent of the library.
/// They share nothing with it but the plain types of core/.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace signum::oracle {

/// For every site its place in the order of ties; empty for that of the tie rule.
using Ranks = std::vector<std::size_t>;

struct Tessellation {
    /// Counterclockwise triples, -1 is infinity, rotated so that the smallest number comes first,
    /// sorted. A triple can occur twice in principle: multiplicity is kept.
    std::vector<std::array<std::int32_t, 3>> faces;
    /// {site, by}, sorted by site; `by` is the visible site nearest to the hidden site's centre.
    std::vector<std::array<std::int32_t, 2>> hidden;
    friend bool operator==(const Tessellation&, const Tessellation&) = default;
};

}  // namespace signum::oracle
