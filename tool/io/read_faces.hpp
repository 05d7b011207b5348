#pragma once
/// Triangles and tetrahedra as other programs write them: rows of numbers of points.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/index.hpp"

namespace signum {

/// Whether a file of that ending is a table or a mesh of faces, and no JSON.
[[nodiscard]] bool is_ending_of_faces(std::string_view ending) noexcept;

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
