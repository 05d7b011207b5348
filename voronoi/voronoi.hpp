#pragma once
/// The Voronoi diagram: the cells of the points that are nearest to a site, with the edges between
/// them and the vertices where edges meet; the dual of the tessellation, in every metric.
///
/// Laws:
///  1. Every face without infinity has a vertex, but those on a common tangent line of their
///     three sites or beyond the doubles. Every edge of the tessellation between two sites has an
///     edge. It leads along the bisector of its sites with the first on its left; where it ends
///     at no vertex it runs to infinity.
///  2. Every visible site has a cell. Its boundary, walked counterclockwise, is a cyclic
///     sequence of steps along edges. Where one step ends at infinity the next one begins there.
///  3. Faces whose circles are the same (degenerate input: grids, circles) have vertices at the
///     same place, joined by edges of no length. They stay apart unless they are merged.
/// Source: thesis, chapter 3; geometry of the curves: curve.hpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "../core/handle.hpp"
#include "../core/index.hpp"
#include "../core/site.hpp"
#include "../triangulation/tessellation.hpp"
#include "../triangulation/vertices.hpp"
#include "conic.hpp"
#include "curve.hpp"

namespace signum {

class Workers;

/// No vertex: the edge runs to infinity, or beyond the doubles.
inline constexpr Index at_infinity = -1;

/// An edge, from vertex to vertex; by index, as all that belongs to it.
struct VoronoiEdge {
    Index left;       ///< the site whose cell lies on the left
    Index right;      ///< and on the right
    Index from;       ///< a vertex, or at_infinity
    Index to;         ///< a vertex, or at_infinity
    Index from_face;  ///< the faces of the tessellation on whose circles the edge ends
    Index to_face;    ///< the same at its other end
};

/// A step along the boundary of a cell.
struct VoronoiStep {
    Index edge;    ///< its number
    bool forward;  ///< whether the cell's site is the edge's left one
};

/// What an edge looks like.
enum class EdgeKind : std::uint8_t {
    point,     ///< no length: its ends are the same vertex, or both at infinity on the same side
    segment,   ///< straight, with two ends
    ray,       ///< straight, with one end
    line,      ///< straight, without ends
    polyline,  ///< two or three straight pieces, the outer ones rays where the edge has no end
    hyperbola  ///< an arc of a hyperbola
};
/// The name by which files know it.
[[nodiscard]] std::string_view name_of(EdgeKind kind) noexcept;

/// The geometry of an edge: a stretch of a curve. Lengths are those of the plane divided by
/// 2^exponent, which is 0 unless coordinates are of extreme size.
struct EdgeGeometry {
    EdgeKind kind;  ///< what it looks like
    Curve curve;    ///< what it is a stretch of
    double from;    ///< parameters on the curve, infinite where the edge does not end
    double to;      ///< the parameter at the other end
    Point start;    ///< the points there; not finite where the edge does not end
    Point end;      ///< the point there
};

/// How to make a diagram.
struct VoronoiOptions {
    /// One vertex for all neighbouring faces whose circles are the same; edges between them vanish.
    bool merge = false;
    /// How many threads work, as Options::threads; the diagram is the same.
    int threads = 0;
};

/// The diagram of one tessellation.
class Voronoi {
 public:
    /// Takes the tessellation over. Throws std::invalid_argument where its neighbours are missing.
    /// O(n).
    explicit Voronoi(Tessellation tessellation, const VoronoiOptions& options = {});

    /// What it is the dual of.
    [[nodiscard]] const Tessellation& tessellation() const noexcept { return tessellation_; }

    /// Centre and distance of every vertex, each number the double nearest to the exact one.
    /// Without merging they come in the order of their faces.
    [[nodiscard]] std::span<const DiagramVertex> vertices() const noexcept { return vertices_; }
    /// The vertex of every face, at_infinity for those that have none.
    [[nodiscard]] std::span<const Index> vertex_of_face() const noexcept { return vertex_of_face_; }
    /// In the order of the faces where they end.
    [[nodiscard]] std::span<const VoronoiEdge> edges() const noexcept { return edges_; }

    /// The boundary of a site's cell, counterclockwise; it begins behind infinity where the cell is
    /// unbounded. Empty for a hidden site, and for one that is alone. This and what follows throws
    /// std::out_of_range where there is no such site or edge.
    [[nodiscard]] std::span<const VoronoiStep> cell(Index site) const {
        const std::size_t s = checked("site", site, hidden_.size());
        return {steps_.data() + first_step_[s], first_step_[s + 1] - first_step_[s]};
    }
    /// Whether the site has no cell.
    [[nodiscard]] bool is_hidden(Index site) const {
        return hidden_[checked("site", site, hidden_.size())];
    }
    /// Whether the cell of a site reaches to infinity.
    [[nodiscard]] bool is_unbounded(Index site) const;

    /// The geometry of an edge; nothing where its sites lie too near to each other for a direction.
    /// Near `focus` the least is lost; without one near the edge's own ends. It must be finite
    /// (std::invalid_argument).
    [[nodiscard]] std::optional<EdgeGeometry> geometry(
        Index edge, std::optional<Point> focus = std::nullopt) const;

    /// The exponent of two by which geometry() divides all lengths, so that their products are
    /// within a double's range.
    [[nodiscard]] int exponent() const noexcept { return exponent_; }

 private:
    void number_vertices(bool merge, const Workers& workers);
    void number_edges(const Workers& workers);
    void collect_cells(const Workers& workers);

    Tessellation tessellation_;
    std::vector<DiagramVertex> vertices_;
    /// The same divided by 2^exponent_, where that is more than the plane's denormals can tell.
    std::vector<Point> divided_vertices_;
    std::vector<Index> vertex_of_face_;
    std::vector<VoronoiEdge> edges_;
    std::vector<Index> edge_of_;  ///< of every face and the corner it lies across from; -1: none
    std::vector<VoronoiStep> steps_;
    std::vector<std::size_t> first_step_;
    std::vector<bool> hidden_;
    int exponent_ = 0;
};

/// The diagram of a tessellation. O(n).
[[nodiscard]] inline Voronoi voronoi(Tessellation tessellation,
                                     const VoronoiOptions& options = {}) {
    return Voronoi(std::move(tessellation), options);
}

}  // namespace signum
