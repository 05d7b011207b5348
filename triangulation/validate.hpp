#pragma once
/// Certifies a tessellation from scratch, whoever made it. Signs are believed where a
/// floating-point filter proves them, otherwise in exact numbers that are the judge's own; the
/// numbers that constructions have behind the filters are never asked.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include "../core/strided_sites.hpp"
#include "arrays.hpp"
#include "tessellation.hpp"

namespace signum {

/// The judgement: a tessellation is valid when it is a tessellation of the sites in its metric,
/// canonical when it is moreover the one that the tie rule chooses, with the arrays in canonical
/// order.
struct Validation {
    bool valid = false;      ///< a tessellation of the sites
    bool canonical = false;  ///< the one that the tie rule chooses
    /// What is wrong and where (face, site), empty where nothing is: first the reason for not being
    /// valid, otherwise the reason for not being canonical.
    std::string message;
    std::uint64_t filtered = 0;        ///< questions that floating-point filters decided
    std::uint64_t multiprecision = 0;  ///< questions that took exact numbers
};

/// For those who wait.
struct ValidationOptions {
    /// Checked every few thousand faces; a stopped validation throws Stopped.
    std::stop_token stop = {};
    /// Called now and then with the share of the work done, from 0 to 1, by the calling thread.
    std::function<void(double)> progress = {};
    /// How many threads work, as Options::threads. The judgement and its counts depend on it no
    /// more than a tessellation does.
    int threads = 0;
};

/// Checks that the arrays are a tessellation of the sites in their metric: adjacency and Euler's
/// counts, every vertex of the diagram existing in its orientation, every edge locally right, the
/// hull winding once, every hidden site truly hidden and nearest to the site it names. The arrays
/// may be in any order and hold any numbers; `neighbours` may be empty where no two sites share
/// several edges. In the metrics with additive weights a vertex must exist under the tie rule: one
/// that would only under another choice counts as wrong. Throws std::invalid_argument for a site
/// that is not finite.
///
/// O(n log n) where few sites are as near to a hidden one's centre as the site that hides it.
/// Random sites, grids and other sets full of ties take from a quarter to some three times as long
/// as their construction, mostly about as long. Source: the heads of check/additive_check.hpp and
/// any_dimension/check.hpp.
[[nodiscard]] Validation validate(const TessellationArrays& arrays, StridedSites sites,
                                  const ValidationOptions& options = {});
/// The same for a tessellation and its own sites.
[[nodiscard]] inline Validation validate(const Tessellation& tessellation,
                                         const ValidationOptions& options = {}) {
    return validate(tessellation.arrays(),
                    {tessellation.sites(), tessellation.weight_is() == WeightIs::weight}, options);
}

}  // namespace signum
