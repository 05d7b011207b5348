#pragma once
/// The vertices of the power diagram: for each finite face the point at equal power distance from
/// its three sites.

#include <vector>

#include <signum/triangulation/tessellation.hpp>

namespace signum {

/// A vertex of the diagram: centre and distance rho to its sites (the power distance in the power
/// metric). Each number is the double nearest to the exact value, halves to even; NaN where it
/// exceeds the doubles, and in all three for an infinite face.
struct DiagramVertex {
    double x;
    double y;
    double rho;
};

/// One vertex a face, in face order. Exact rationals behind a filter; O(n).
[[nodiscard]] std::vector<DiagramVertex> vertices(const Tessellation& tessellation);

}  // namespace signum
