#pragma once
/// The vertices of the diagram: for each finite face the point at equal distance from its three
/// sites.

#include <vector>

#include "tessellation.hpp"

namespace signum {

/// A vertex of the diagram: centre and distance rho to its sites, in the metric (the power distance
/// in the power metric; elsewhere negative where the sites overlap). Each number is the double
/// nearest to the exact value, halves to even; NaN where it exceeds the doubles. NaN in all three
/// for an infinite face, and for a finite one whose vertex lies at infinity: in the Euclidean
/// metric three discs on a common tangent line may have a face by the tie rule alone. Where the tie
/// rule chooses one of many squares, it is the one that its infinitesimals tend to.
struct DiagramVertex {
    double x;    ///< the first coordinate of the centre
    double y;    ///< the second
    double rho;  ///< the distance
};

/// One vertex a face, in face order, whatever the number of threads (Options::threads). Exact
/// rationals behind a filter; O(n).
[[nodiscard]] std::vector<DiagramVertex> vertices(const Tessellation& tessellation,
                                                  int threads = 0);

}  // namespace signum
