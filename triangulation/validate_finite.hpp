#pragma once
/// Judges triangulations as other programs give them: finite triangles or tetrahedra alone, in any
/// order and orientation.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../core/index.hpp"
#include "../core/strided_sites.hpp"
#include "validate.hpp"

namespace signum {

/// What may be wrong with a triangle or a tetrahedron ("face").
enum class FiniteFault : std::uint8_t {
    number,   ///< it names a site that there is not, or one twice
    flat,     ///< its sites lie on a line, in space in a plane
    overlap,  ///< three faces have one edge (facet), or two lie on the same side of theirs
    conflict  ///< the site beyond an edge (facet) lies in its circle (sphere)
};

/// The judgement of faces without infinity.
struct FiniteValidation {
    bool valid = false;  ///< whether they are a Delaunay, or a regular, triangulation
    /// What is wrong, and where: faces by their places in the input. Empty where nothing is.
    std::string message;
    /// A face that is at fault.
    struct Fault {
        std::int64_t face;  ///< its place in the input
        FiniteFault fault;  ///< the first of its faults, in the order of the enumerators
    };
    std::vector<Fault> faults;  ///< by rising places
    /// An edge of one face alone that is not on the hull of the sites: behind it faces are missing.
    struct OpenEdge {
        std::int64_t face;             ///< its place in the input
        std::array<Index, 2> between;  ///< the sites that it joins, rising
    };
    /// Known where no face is at fault by number, flat or overlap; of the plane alone.
    std::vector<OpenEdge> open;
    /// Sites of no face that have a place in the triangulation: not hidden by their weights, and
    /// not at the place of one that is a vertex. Rising.
    std::vector<std::int64_t> missing;
};

/// Whether the faces are a Delaunay triangulation of the points or, where sites have third numbers,
/// a regular one (power metric), whichever of those that ties allow. Of sites at one place and of
/// one weight any one may be the vertex. No face at all is right where all sites lie on a line
/// (in a plane). Throws std::invalid_argument for a site that is not
/// finite; Stopped where options.stop asks for it. O(n log n), and a walk of some √n faces for each
/// site of no face; where they are not valid, a triangulation more, to say what is missing. The
/// message counts sites and faces from `numbered_from`.
[[nodiscard]] FiniteValidation validate_finite(std::span<const std::array<Index, 3>> faces,
                                               StridedSites sites,
                                               const ValidationOptions& options = {},
                                               int numbered_from = 0);
/// The same in space.
[[nodiscard]] FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                               std::span<const Point3> sites,
                                               const ValidationOptions& options = {},
                                               int numbered_from = 0);
/// The same of balls, whose weight is the square of the radius.
[[nodiscard]] FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                               std::span<const Site3> sites,
                                               const ValidationOptions& options = {},
                                               int numbered_from = 0);
/// The same of sites that say their weight.
[[nodiscard]] FiniteValidation validate_finite(std::span<const std::array<Index, 4>> cells,
                                               std::span<const power::Site3> sites,
                                               const ValidationOptions& options = {},
                                               int numbered_from = 0);

}  // namespace signum
