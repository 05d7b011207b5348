#pragma once
/// The part of a diagram that lies in a box, and the cells' shapes there.
///
/// Laws:
///  1. The shapes of all cells tile the box: each edge is cut once, and both its cells get the same
///     parts of it. Cuts are rounded: a part in the box no longer than some 2^-46 of the largest
///     number among sites and box may be taken for none, and what lies beyond it goes to the other
///     cell.
///  2. A shape is a set of loops, counterclockwise, of edges' parts and pieces of the box's border.
///     More than one loop stands where the box cuts a cell in pieces.
///  3. Without a box the shapes are those of the bounded cells; the others have none.

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "voronoi.hpp"

namespace signum {

/// The whole plane.
inline constexpr Box no_box = {
    -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

/// The part of a cell that lies in a box.
struct CellShape {
    Index site = 0;          ///< whose cell
    bool unbounded = false;  ///< the cell itself, not its part in a box
    bool in_box = false;     ///< whether there is a box
    bool clipped = false;    ///< whether a piece of the border is among the loops
    std::vector<std::vector<Conic>>
        loops;  ///< counterclockwise, each a chain of curves that closes
};

/// Of a shape: infinite numbers where the cell is unbounded and there is no box, NaN for their
/// centroid and that of a shape without area. Areas beyond a double's range are infinite, too.
struct Measure {
    double area;       ///< square units, never below 0
    double perimeter;  ///< along arcs, and along the box where it cuts
    Point centroid;    ///< of the area
};
/// Area, length and centroid of a shape. O(its edges).
[[nodiscard]] Measure measure(const CellShape& shape);

/// The smallest box around all centres, wider by a tenth of its longer side on each side, and where
/// all centres are the same by 1, or 2^exponent of their diagram where that is less; by more where
/// doubles would not tell its sides apart. Throws std::invalid_argument without sites, and where a
/// centre is not finite.
[[nodiscard]] Box default_box(std::span<const Site> sites, int exponent = 0);

/// Whether doubles can compute with a box, its lengths divided by 2^exponent of the diagram: no
/// corner is beyond 2^500, no side shorter than 2^-500.
[[nodiscard]] bool is_of_usual_size(const Box& divided) noexcept;
/// The same for a box in the plane, whose size may be far from that of the sites.
[[nodiscard]] bool fits(const Box& box, const Voronoi& voronoi) noexcept;

/// The unit of a box and of the parts in it.
enum class Lengths : std::uint8_t {
    of_the_plane,
    divided  ///< by 2^exponent of the diagram, for those who go beyond a double's range
};

/// A diagram and a box, edge by edge and cell by cell.
class ClippedVoronoi {
 public:
    /// The diagram is not copied. Throws std::invalid_argument unless the box is no_box, or x0 < x1
    /// and y0 < y1, all finite, and it fits. The parts are the same whatever the number of threads
    /// (Options::threads). O(n).
    explicit ClippedVoronoi(const Voronoi& voronoi, const Box& box = no_box,
                            Lengths lengths = Lengths::of_the_plane, int threads = 0);

    /// The whole diagram.
    [[nodiscard]] const Voronoi& voronoi() const noexcept { return voronoi_; }
    /// The parts of an edge in the box, in its direction, each the continuation of the one before
    /// or behind a gap. Throws std::out_of_range where there is no such edge.
    [[nodiscard]] std::vector<Conic> edge(Index edge) const;
    /// A site's cell, empty where it is hidden. Throws std::out_of_range where there is no such
    /// site. O(its edges).
    [[nodiscard]] CellShape cell(Index site) const;

 private:
    /// Parts of one edge that follow each other without a gap.
    struct Run {
        std::size_t first;
        std::size_t last;
        bool begins_at_vertex;  ///< of the edge, inside the box
        bool ends_at_vertex;
    };
    using Loop = std::vector<Conic>;
    /// Of some edges, one after the other.
    struct Parts {
        std::vector<Conic> conics;
        std::vector<Run> runs;
        std::vector<std::size_t> runs_of;  ///< how many each edge has
    };

    void cut(Index edge, Parts& found) const;
    void cut_all(int threads);
    [[nodiscard]] std::vector<Conic> pieces_near_box(Index edge, bool& from_start,
                                                     bool& to_end) const;
    [[nodiscard]] bool contains(Point p) const noexcept;
    [[nodiscard]] Point on_border(Point p) const noexcept;
    [[nodiscard]] double position(Point p) const noexcept;
    [[nodiscard]] double ahead(Point from, Point to) const noexcept;
    void follow_border(Loop& loop, Point end, bool all_around) const;
    [[nodiscard]] std::vector<Loop> open_chains(Index site, std::vector<Loop>& whole) const;
    [[nodiscard]] std::vector<Loop> closed(std::vector<Loop> open) const;
    [[nodiscard]] std::vector<Loop> tiling(std::vector<Loop> open, Index site) const;
    [[nodiscard]] double rounding() const noexcept;
    [[nodiscard]] double speck() const noexcept;
    [[nodiscard]] bool runs_along_border(const Loop& chain) const;
    [[nodiscard]] bool joins(const Loop& chain, Point next) const noexcept;
    [[nodiscard]] bool is_speck(const Loop& chain) const noexcept;

    const Voronoi& voronoi_;
    Box box_;       ///< divided by 2^exponent, as all that is stored here
    int exponent_;  ///< by which results are multiplied: that of the diagram, or 0
    bool is_bounded_;
    std::vector<Conic> conics_;
    std::vector<Run> runs_;
    std::vector<std::size_t> first_run_;
    Index at_point_ = -1;  ///< the site whose cell contains some point of the box
};

/// Of the cells of all sites, in their order, whatever the number of threads (Options::threads).
/// O(n).
[[nodiscard]] std::vector<Measure> measures(const ClippedVoronoi& clipped, int threads = 0);

}  // namespace signum
