#pragma once
/// The cells of cells.hpp as polyhedra: for pictures, files, and what asks for corners.
///
/// Laws:
///  1. A polyhedron is closed: of every edge there are two faces, which run along it in opposite
///     directions, and corners - edges + faces = 2. It is convex but for the rounding of corners.
///     Closed it is by construction: a corner is known by the three planes that meet there, and the
///     exact tessellation and exact comparisons with the box say which do.
///  2. Where the same three planes meet is one corner, and so are corners nearer to one another
///  than
///     2^-44 of the cell, or than 2^-47 of the box and its coordinates, as long as what they leave
///     is closed; a face that has fewer than three is left out. One that is too narrow to be among
///     the cell's faces stays where its corners do.

#include <span>
#include <vector>

#include "cells.hpp"

namespace signum {

/// A cell as a solid.
struct SpacePolyhedron {
    Index site = 0;                   ///< whose cell
    std::vector<Point3> corners;      ///< each once
    std::vector<Index> beyond;        ///< by face: as in SpaceFace, in that order
    std::vector<Index> first_corner;  ///< by face, and one more
    std::vector<Index> face_corners;  ///< counterclockwise seen from outside

    /// The corners of a face, by their places in `corners`, counterclockwise from outside.
    [[nodiscard]] std::span<const Index> corners_of(std::size_t face) const {
        return {face_corners.data() + first_corner.at(face),
                face_corners.data() + first_corner.at(face + 1)};
    }
    friend bool operator==(const SpacePolyhedron&, const SpacePolyhedron&) = default;
};

/// Those of the sites in `which`, in that order; one without volume has no corners. Throws as
/// space_cells() does, and std::out_of_range where there is no such site. O(n), and of each cell as
/// long as it takes to sort its corners.
[[nodiscard]] std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                                           std::span<const Point3> sites,
                                                           const Box3& box,
                                                           std::span<const Index> which);
/// The same of balls.
[[nodiscard]] std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                                           std::span<const Site3> sites,
                                                           const Box3& box,
                                                           std::span<const Index> which);
/// The same of sites with weights.
[[nodiscard]] std::vector<SpacePolyhedron> space_polyhedra(const SpaceTessellation& tessellation,
                                                           std::span<const power::Site3> sites,
                                                           const Box3& box,
                                                           std::span<const Index> which);

}  // namespace signum
