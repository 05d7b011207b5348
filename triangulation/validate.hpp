#pragma once
/// Certifies a tessellation from scratch, whoever made it, with the multiprecision kernel alone.

#include <string>

#include <signum/core/strided_sites.hpp>
#include <signum/triangulation/tessellation.hpp>

namespace signum {

/// The judgement: a tessellation is valid when it is a power triangulation of the sites, canonical
/// when it is moreover the one that the tie rule chooses, with the arrays in canonical order.
struct Validation {
    bool valid = false;
    bool canonical = false;
    /// What is wrong and where (face, site), empty where nothing is: first the reason for not being
    /// valid, otherwise the reason for not being canonical.
    std::string message;
};

/// Checks that the arrays are a power triangulation of the sites: adjacency and Euler's counts,
/// every finite face counterclockwise, every star and the hull winding exactly once, every edge
/// locally regular, every hidden site truly hidden by others and nearest to the site it names. The
/// arrays may be in any order and hold any numbers; `neighbours` may be empty. O(n log n).
[[nodiscard]] Validation validate(const TessellationArrays& arrays, StridedSites sites);

}  // namespace signum
