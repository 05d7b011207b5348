#pragma once
/// Certifies a tessellation from scratch, whoever made it, with the multiprecision kernel alone.

#include <string>

#include "../core/strided_sites.hpp"
#include "tessellation.hpp"

namespace signum {

/// The judgement: a tessellation is valid when it is a tessellation of the sites in its metric,
/// canonical when it is moreover the one that the tie rule chooses, with the arrays in canonical
/// order.
struct Validation {
    bool valid = false;
    bool canonical = false;
    /// What is wrong and where (face, site), empty where nothing is: first the reason for not being
    /// valid, otherwise the reason for not being canonical.
    std::string message;
};

/// Checks that the arrays are a tessellation of the sites in their metric: adjacency and Euler's
/// counts, every vertex of the diagram existing in its orientation, every edge locally right, the
/// hull winding once (in the power metric every star), every hidden site truly hidden and nearest
/// to the site it names. The arrays may be in any order and hold any numbers; `neighbours` may be
/// empty where no two sites share several edges. In the metrics with additive weights a vertex must
/// exist under the tie rule: one that would only under another choice counts as wrong. Throws
/// std::invalid_argument for a site that is not finite. O(n log n).
[[nodiscard]] Validation validate(const TessellationArrays& arrays, StridedSites sites);

}  // namespace signum
