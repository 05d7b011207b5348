#pragma once
/// The vertices of the diagram of balls, and the curves that none lies on. For sources only.

#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../triangulation/arrays.hpp"
#include "../../triangulation/options.hpp"
#include "set.hpp"

namespace signum::balls {

/// A sphere that touches four balls. The positive one of b0, b1, b2, b3 where turn is 1, of b0, b2,
/// b1, b3 where it is -1; where it is 0, `flat`.
struct BallVertex {
    Quadruple four;
    Sign turn;
    std::vector<Index> touching;  // all, where they are more than the four
    Site3 sphere;

    [[nodiscard]] std::span<const Index> all() const noexcept {
        if (touching.empty()) return four;
        return touching;
    }
};

/// Three balls, or more, whose curve meets no vertex.
struct FreeCurve {
    std::vector<Index> touching;
    bool is_loop;
};

struct BallVertices {
    std::vector<BallVertex> vertices;  // in the order of the arrays
    std::vector<FreeCurve> free_curves;
    std::vector<char> may_be_unbounded;  // the cell of each ball
};

/// Throws Stopped where options.stop asks for it.
[[nodiscard]] BallVertices find_vertices(const BallSet& balls, std::span<const Hidden> hidden,
                                         const Options& options);

}  // namespace signum::balls
