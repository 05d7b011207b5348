#pragma once
/// The faces of power cells in a box, one at a time. For sources only.
///
/// A face of two sites is a convex polygon: its vertices are those of the cells of the tessellation
/// around the sites' edge, in their order, so that no decision is left to rounding. Where such a
/// vertex is at infinity, or so far from the box that its own rounding would be seen, the box's
/// section along the bisecting plane is cut by the planes of the sites around the edge instead.
/// Where the box cuts what lies beyond its sides goes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../core/large_array.hpp"
#include "../spatial/triangulate.hpp"
#include "scaled_sites.hpp"

namespace signum {

/// Seen from the site whose face it is; lengths as in ScaledSites.
struct CutFace {
    Bisector plane;  ///< turned outward
    double area;
    Point3 moment;   ///< the integral of the place over the face
    bool is_narrow;  ///< law 3 of space_cells.hpp: it counts for nothing
};

class SpaceFaces {
 public:
    /// Throws std::invalid_argument as space_cells() does.
    SpaceFaces(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box);

    [[nodiscard]] const ScaledSites& sites() const noexcept { return sites_; }
    [[nodiscard]] bool is_visible(Index i) const noexcept {
        const auto s = static_cast<std::size_t>(i);
        return first_[s] < first_[s + 1];
    }

    /// A site that shares an edge with another one, and the first of the finite cells around it.
    struct Neighbour {
        Index site;
        Index cell;
    };
    /// Those of site i above `least`; valid up to the next call.
    [[nodiscard]] std::span<const Neighbour> neighbours(Index i, Index least = -1);

    /// A hint that the neighbours of a site will be asked for soon.
    void prefetch(Index i) const noexcept {
        for (const Index c : star(i)) __builtin_prefetch(&cell(c));
    }

    /// The face of site i with a neighbour of it. Nothing where none of it is in the box.
    /// Told from both sites the polygon is the same but for rounding: ask the lesser one.
    [[nodiscard]] const CutFace* cut(Index i, const Neighbour& neighbour);
    /// The part of side 0 to 5 of the box in the cell of a site that has these neighbours.
    [[nodiscard]] const CutFace* cut_side(Index i, int side, std::span<const Neighbour> neighbours);

    /// Of the face that was cut last; counterclockwise seen from beyond, in places seen from its
    /// site.
    [[nodiscard]] std::span<const Point3> polygon() const noexcept { return polygon_; }
    /// What is on the other side of the edge behind each point: a site, or a side of the box.
    [[nodiscard]] std::span<const Index> borders() const noexcept { return borders_; }
    /// The sides of the box near which the last two sites may meet it, whether or not there was a
    /// face: a bit for each.
    [[nodiscard]] unsigned touched() const noexcept { return touched_; }
    /// A point of the box in a site's cell or near it, seen from the site: a corner; where none is
    /// in the box, what is nearest there to a corner, or to the site.
    [[nodiscard]] Point3 point_near_cell(Index i) const noexcept;
    /// The corners of the box seen from a site.
    [[nodiscard]] Box3 box_from(Index i) const noexcept;

 private:
    /// A cell of the tessellation, all that is asked of it in one line of the processor's memory.
    /// Its vertex is seen from its first site; bits say where that is: `beyond` a side of the box
    /// or not, `at` it or beyond; `far` from the box, or at infinity.
    struct alignas(64) Cell {
        SpaceCell sites;
        SpaceCell neighbours;
        Point3 vertex;
        std::uint32_t where;
    };
    static constexpr std::uint32_t beyond_low_x = 1;
    static constexpr std::uint32_t beyond_any = 63;
    static constexpr std::uint32_t at_low_x = 64;
    static constexpr std::uint32_t far = 1 << 12;

    void place_vertex(Cell& cell) const;
    [[nodiscard]] static bool meet(const std::array<Point3, 3>& m, const std::array<double, 3>& h,
                                   double least, Point3& v) noexcept;
    [[nodiscard]] Point3 vertex_of(const SpaceCell& cell) const;
    [[nodiscard]] std::uint32_t where(const Point3& p) const noexcept;
    void collect_stars();
    [[nodiscard]] const Cell& cell(Index c) const noexcept {
        return cells_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] std::span<const Index> star(Index i) const noexcept {
        const auto s = static_cast<std::size_t>(i);
        return {star_.data() + first_[s], star_.data() + first_[s + 1]};
    }

    void walk_around(Index i, const Neighbour& neighbour);
    void collect_around(Index i, Index j);
    void join_vertices(Index i);
    void cut_section(Index i, Index j);
    void cut_across(Index i, Index j, Index k);
    void cut_by_box(Index i, std::uint32_t sides);
    bool cut_by(const Bisector& plane, Index beyond);
    template <class Put>
    void keep_below(Index beyond, const Put& put);
    void start_with_rectangle(const Box3& box, int axis);
    void measure();
    [[nodiscard]] bool is_narrow(bool is_cut) const noexcept;
    void turn();

    int dimension_;
    ScaledSites sites_;
    LargeArray<Cell> cells_;
    std::vector<std::size_t> first_;
    LargeArray<Index> star_;  // the finite cells around each site, in rising order
    LargeArray<std::uint32_t> seen_;
    std::uint32_t round_ = 0;
    std::vector<Neighbour> neighbours_;

    // Of the face at hand.
    std::vector<Index> ring_;    // cells
    std::vector<Index> around_;  // the site that a cell of the ring shares with the next one
    std::vector<Point3> polygon_;
    std::vector<Index> borders_;
    std::vector<Point3> points_before_;
    std::vector<Index> borders_before_;
    std::vector<double> distances_;
    CutFace face_{};
    double longest_square_ = 0.0;  // of the lines from the polygon's first point
    unsigned touched_ = 0;
};

}  // namespace signum
