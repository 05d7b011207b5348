#pragma once
/// The faces of power cells in a box, one at a time. For sources only.
///
/// A face of two sites is a convex polygon: its corners are the vertices of the cells of the
/// tessellation around the sites' edge, in their order, and where these are at infinity, points in
/// known directions there. Of it the box cuts what lies beyond its sides, and of each corner, also
/// of those that a side has made, it is exact whether it does: a corner is known by what lies
/// behind the two edges that meet there, and so are its place and all that is asked of it. What
/// lies in a side counts as outside, as if the box were smaller by next to nothing, by side 5 much
/// more than by side 4 and so on; so faces agree, and leave on the box's sides the edges of closed
/// polygons.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "../../core/large_array.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../box_edges.hpp"
#include "../scaled_sites.hpp"

namespace signum {

/// Seen from the eye of the site whose face it is; lengths as in ScaledSites.
struct CutFace {
    Point3 normal;  ///< of length 1, outward
    double area;
    Point3 moment;   ///< the integral of the place over the face
    bool is_narrow;  ///< law 3 of cells.hpp: it counts for nothing
};

/// A step along the rim of a cell's part of a side of the box.
struct SideStep {
    Index site;
    int side;
    Point3 from;
    Point3 to;
};

class SpaceFaces {
 public:
    /// Throws std::invalid_argument as space_cells() does. Threads place vertices.
    SpaceFaces(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box,
               int threads = 1);
    /// Another one of the same cells, for another thread.
    [[nodiscard]] SpaceFaces another() const { return SpaceFaces(all_); }

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
    /// Whether the last face ends at the box.
    [[nodiscard]] bool is_at_box() const noexcept { return !corners_.empty(); }
    /// The area, moment and width of a polygon in a side, counterclockwise seen from beyond; its
    /// steps in any order.
    [[nodiscard]] static CutFace on_side(Side side, std::span<const SideStep> steps);

    /// Of the face that was cut last; counterclockwise seen from beyond, in places seen from its
    /// site's eye.
    [[nodiscard]] std::span<const Point3> polygon() const noexcept { return polygon_; }
    /// What is on the other side of the edge behind each point: a site, or a side of the box.
    [[nodiscard]] std::span<const Index> borders() const noexcept { return borders_; }
    /// The ends that the last face, of sites i and j, makes of parts of the box's edges, seen from
    /// the eye of site i, as ends of its part: of the part of site j each is the other end.
    template <class Put>
    void for_ends_on_edges(Index i, Index j, const Put& put) const {
        if (corners_.empty()) return;
        for (std::size_t k = 0; k < borders_.size(); ++k) {
            const Index before = borders_[k > 0 ? k - 1 : borders_.size() - 1];
            if (!is_box_side(before) || !is_box_side(borders_[k])) continue;
            const BoxEdge edge(Side::named(before), Side::named(borders_[k]));
            put(EdgeEnd{edge.number, sites_.sign_of_offset(i, j, edge.axis()) > 0, k, polygon_[k]});
        }
    }
    /// The site in whose cell the box is, where no face cuts it.
    [[nodiscard]] Index owner_of_box() const;
    /// The corners of the box seen from a site's eye.
    [[nodiscard]] Box3 box_from(Index i) const noexcept;

 private:
    /// A cell of the tessellation, all that is asked of it in one line of the processor's memory.
    /// Its vertex is seen from its first site's eye; bits say which sides of the box that is not
    /// inside of, or that it is at infinity.
    struct alignas(64) Cell {
        SpaceCell sites;
        SpaceCell neighbours;
        Point3 vertex;
        std::uint32_t where;
    };
    static constexpr std::uint32_t all_sides = 63;
    static constexpr std::uint32_t infinite = 64;

    /// A corner of the face that is being cut, and what lies behind the edge that leaves it. What
    /// is known of its place depends on what lies behind the edge before, and this one:
    /// sites, of a vertex of the tessellation; a side and a site, or two sides, in the box; a
    /// site and infinity, or a side and infinity, in the direction in which their line goes there.
    struct FaceCorner {
        Index border;
        Index cell;  ///< of a vertex, or `no_cell`, or a direction
        Corner known{};
    };
    static constexpr Index at_infinity = -7;
    static constexpr Index no_cell = -1;
    /// Between infinity and infinity: across an axis and the way between the sites.
    static constexpr Index direction(int axis, bool is_positive) noexcept {
        return static_cast<Index>(-2 - 2 * axis - static_cast<int>(is_positive));
    }

    /// What several threads read.
    struct All {
        int dimension;
        ScaledSites sites;
        LargeArray<Cell> cells;
        std::vector<std::size_t> first;
        LargeArray<Index> star;  ///< the finite cells around each site, in rising order

        All(const SpaceTessellation& tessellation, const AnySites3& sites, const Box3& box,
            int threads);
        void place_vertex(Cell& cell) const;
        void collect_stars();
    };
    explicit SpaceFaces(std::shared_ptr<const All> all);

    [[nodiscard]] const Cell& cell(Index c) const noexcept {
        return cells_[static_cast<std::size_t>(c)];
    }
    [[nodiscard]] std::span<const Index> star(Index i) const noexcept {
        const auto s = static_cast<std::size_t>(i);
        return {star_.data() + first_[s], star_.data() + first_[s + 1]};
    }

    void walk_around(Index i, const Neighbour& neighbour);
    void collect_around(Index i, const Neighbour& neighbour);
    void join_vertices(Index i);
    void start();
    void start_flat(Index i, Index j);
    void cut_by(Index i, Index j, Side side);
    enum class Where : std::uint8_t { inside, outside, either };
    [[nodiscard]] Where where_is(Index i, Index j, std::size_t corner, Side side) const;
    [[nodiscard]] Sign sign_at_infinity(Index i, Index j, Index before, const FaceCorner& corner,
                                        int axis) const;
    [[nodiscard]] FaceCorner made(Index i, Index j, Index before, Index border) const;
    void measure();
    [[nodiscard]] bool is_narrow(bool is_cut) const noexcept;

    std::shared_ptr<const All> all_;
    int dimension_ = all_->dimension;
    const ScaledSites& sites_ = all_->sites;
    const LargeArray<Cell>& cells_ = all_->cells;
    const std::vector<std::size_t>& first_ = all_->first;
    const LargeArray<Index>& star_ = all_->star;
    LargeArray<std::uint32_t> seen_;
    std::uint32_t round_ = 0;
    std::vector<Neighbour> neighbours_;

    // Of the face at hand.
    std::vector<Index> ring_;    // cells
    std::vector<Index> around_;  // the site that a cell of the ring shares with the next one
    std::vector<Point3> polygon_;
    std::vector<Index> borders_;
    std::vector<FaceCorner> corners_;  // of one at the box
    std::vector<FaceCorner> corners_before_;
    std::vector<Where> where_;
    CutFace face_{};
    double longest_square_ = 0.0;  // of the lines from the polygon's first point
};

}  // namespace signum
