#pragma once
/// The power cells of space in a box: volumes, surfaces, centroids, and who shares how large a face
/// with whom; the dual of the tessellation, for equal weights Voronoi's. As polyhedra:
/// polyhedra.hpp.
///
/// Laws:
///  1. The cells tile the box. A hidden site and one whose cell does not reach into the box have no
///     volume and no face.
///  2. A face between two cells has one area, told to both. A cell's faces come in the order of
///     the sites beyond, then of the box's sides from -1 to -6.
///  3. Who may share a face the exact tessellation says, and what of it the box cuts is decided
///     exactly, too: what lies in a side is the side's, and what lies a rounding beside it is not.
///     A face narrower than 2^-40 of its corners' distance from the site, or from the point of the
///     box that is nearest to it, is none: where more than four cells meet in a point, as in
///     lattices, the rounding of coordinates makes such faces. Nor is what the box leaves of a
///     face, or a cell's part of a side, narrower than 2^-45 of the box's longest side.
///  4. Numbers are doubles, finite but beyond a double's range, and never negative. Volumes, areas
///     and places are in error by about 1e-12 of those of a cell as large as the distance of the
///     corners from the site, or from the point of the box that is nearest to it, however nearly
///     planes coincide; what is smaller by a factor has the fewer right digits.
/// Faces are convex polygons around the edges of the tessellation, so that no cell is cut from the
/// box plane by plane; volumes are sums of cones over faces. A corner is the meeting of three
/// planes: in doubles where they do it well, in rationals where they do not.

#include <cstdint>
#include <span>
#include <vector>

#include "../../core/handle.hpp"
#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../triangulation/space/triangulate.hpp"

namespace signum {

/// All points from the one corner to the other.
struct Box3 {
    Point3 low;   ///< the corner of least coordinates
    Point3 high;  ///< the opposite corner
    friend bool operator==(const Box3&, const Box3&) = default;
};

/// The sides of the box, as they stand among sites: -1 where x is least, -2 where it is greatest,
/// -3 and -4 the same for y, -5 and -6 for z.
[[nodiscard]] constexpr bool is_box_side(Index beyond) noexcept {
    return beyond < 0;
}

/// A face of a cell.
struct SpaceFace {
    Index beyond;  ///< the site on the other side, or a side of the box
    double area;   ///< square units
    friend bool operator==(const SpaceFace&, const SpaceFace&) = default;
};

/// What a cell measures in the box.
struct SpaceMeasure {
    double volume = 0.0;  ///< cubic units
    double area = 0.0;    ///< of the whole surface
    /// In the box. Where there is no volume, the point of the box nearest to the site's centre.
    Point3 centroid;
    friend bool operator==(const SpaceMeasure&, const SpaceMeasure&) = default;
};

/// The cells as plain arrays.
struct SpaceCells {
    Box3 box;                              ///< what the cells are cut to
    std::vector<SpaceMeasure> measures;    ///< by site
    std::vector<std::int64_t> first_face;  ///< by site, and one more: where its faces begin
    std::vector<SpaceFace> faces;          ///< of all cells, one after the other

    /// Those of a site. Throws std::out_of_range where there is no such site.
    [[nodiscard]] std::span<const SpaceFace> faces_of(Index site) const {
        const std::size_t s = checked("site", site, measures.size());
        return {faces.data() + first_face[s], faces.data() + first_face[s + 1]};
    }
    friend bool operator==(const SpaceCells&, const SpaceCells&) = default;
};

/// By site, whether its cell has no end: of flat sites that of every visible one. A tessellation
/// that is valid. O(n).
[[nodiscard]] std::vector<bool> unbounded_cells(const SpaceTessellation& tessellation);

/// The smallest box around all centres, wider by a tenth of its longest side on each side, and
/// where all centres are the same by 1; by more where doubles would not tell its sides apart, and
/// no farther than doubles reach. Throws std::invalid_argument without sites, and where a centre is
/// not finite. O(n).
[[nodiscard]] Box3 default_box(std::span<const Point3> sites);
/// The same of balls.
[[nodiscard]] Box3 default_box(std::span<const Site3> sites);
/// The same of sites with weights.
[[nodiscard]] Box3 default_box(std::span<const power::Site3> sites);

/// `tessellation` is that of the sites, which is the caller's word. Throws std::invalid_argument
/// where it has another number of sites, unless the box's corners are finite and low < high along
/// all axes, and where a number of a site or a corner is beyond 2^200 of the box's longest side.
/// The same whatever the number of threads (Options::threads). O(n), where no site has neighbours
/// without bound.
[[nodiscard]] SpaceCells space_cells(const SpaceTessellation& tessellation,
                                     std::span<const Point3> sites, const Box3& box,
                                     int threads = 0);
/// The same of balls.
[[nodiscard]] SpaceCells space_cells(const SpaceTessellation& tessellation,
                                     std::span<const Site3> sites, const Box3& box,
                                     int threads = 0);
/// The same of sites with weights.
[[nodiscard]] SpaceCells space_cells(const SpaceTessellation& tessellation,
                                     std::span<const power::Site3> sites, const Box3& box,
                                     int threads = 0);

}  // namespace signum
