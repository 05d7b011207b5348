#pragma once
/// The edges of the diagram, one by one, whatever their shape.

#include <signum/draw/frame.hpp>
#include <signum/triangulation/tessellation.hpp>
#include <signum/triangulation/vertices.hpp>

#include <cstddef>
#include <vector>

namespace signum {

/// An end of an edge of the diagram.
struct CellCorner {
    Point at;          ///< in pixels; not finite where it lies beyond the doubles or at infinity
    const Site* apex;  ///< the third site that touches; null for the vertex at infinity
};

/// The edge between the cells of a and b: it leads along their bisector, a on the left, from the
/// face on the right of the edge a -> b (below) to the face on the left (above). Two sites may
/// share several.
struct CellEdge {
    Index a;
    Index b;
    CellCorner below;
    CellCorner above;
};

inline double dot(Point a, Point b) noexcept {
    return a.x * b.x + a.y * b.y;
}
inline Point minus(Point a, Point b) noexcept {
    return {a.x - b.x, a.y - b.y};
}
/// a + times · b.
inline Point plus(Point a, Point b, double times) noexcept {
    return {a.x + times * b.x, a.y + times * b.y};
}

/// Calls visit(edge) once for every edge of the diagram.
template <typename Visit>
void for_each_cell_edge(const Tessellation& tessellation, const Frame& frame, Visit visit) {
    const auto faces = tessellation.faces();
    const std::vector<DiagramVertex> corners = vertices(tessellation);
    const auto corner = [&](std::size_t f, Index a, Index b) -> CellCorner {
        const Site* apex = nullptr;
        for (const Index v : faces[f])
            if (v != a && v != b && v != infinite)
                apex = &tessellation.sites()[static_cast<std::size_t>(v)];
        return {frame.at({corners[f].x, corners[f].y}), apex};
    };
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto g = static_cast<std::size_t>(tessellation.neighbours()[f][k]);
            const Index a = faces[f][(k + 1) % 3];
            const Index b = faces[f][(k + 2) % 3];
            if (f < g && a != infinite && b != infinite)
                visit(CellEdge{a, b, corner(g, a, b), corner(f, a, b)});
        }
}

/// From a to b, and the difference of two radii, in pixels: subtracted in the plane, so that little
/// is lost where sites lie closely together.
inline Point pixels_between(const Frame& frame, const Site& a, const Site& b) noexcept {
    return {2 * frame.length(b.x / 2 - a.x / 2), 2 * frame.length(a.y / 2 - b.y / 2)};
}
inline double radius_difference(const Frame& frame, const Site& a, const Site& b) noexcept {
    return 2 * frame.length(a.r / 2 - b.r / 2);
}

}  // namespace signum
