#pragma once
/// Triangles and tetrahedra as other programs write them: rows of numbers of points.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/index.hpp"

namespace signum {

/// Of files that are no plain rows.
inline constexpr std::array<std::string_view, 6> endings_of_faces = {"npy", "json", "ele",
                                                                     "obj", "ply",  "vtk"};

struct FacesFile {
    /// One of the two: faces of the plane, or cells of space. The points are numbered from 0.
    std::vector<std::array<Index, 3>> faces;
    std::vector<std::array<Index, 4>> cells;
    bool are_from_one = false;  ///< the file numbers its points from 1
    [[nodiscard]] std::size_t size() const noexcept { return faces.size() + cells.size(); }
};

/// By the ending: .json (rows, or an object with "simplices", "faces" or "cells"), .npy (whole
/// numbers), .ele (Triangle, TetGen), .obj, .ply (of text) and .vtk (of text); any other holds
/// three or four numbers a line, with or without a head. In .ele and .obj points are numbered as
/// these formats say, elsewhere from 0. Throws InputError, with line and column where it has them,
/// and MachineError.
[[nodiscard]] FacesFile read_faces(const std::string& path);

}  // namespace signum
