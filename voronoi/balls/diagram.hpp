#pragma once
/// The Voronoi diagram of balls in space: of each point which ball is nearest, by the distance
/// |x - c| - r (Euclidean metric with additive weights).
///
/// Its vertices are the centres of the empty spheres that touch four balls or more from outside,
/// its edges the curves of those that touch three or more. They form no complex of simplices: four
/// balls may have two vertices, three balls several edges, an edge may be closed without any
/// vertex, and what bounds a cell need not hang together. So the result is the plain truth as
/// arrays, without a rule for ties.
///
/// Laws:
///  1. exact and complete for all finite balls: any radii, negative ones too, intersecting, nested,
///     equal; the same in every floating-point environment;
///  2. only differences of radii matter: of other radii by the same amount all arrays but the
///     spheres' radii are the same (as long as the sums are exact);
///  3. the arrays depend on the balls alone, and are sorted.
/// Source: the cell of a ball, seen from its centre, is an upper envelope of linear functions
/// (voronoi/balls/cell.hpp); Boissonnat, Wormser, Yvinec 2006; Gavrilova 1998.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "../../triangulation/arrays.hpp"
#include "../../triangulation/options.hpp"

namespace signum {

/// Lists of balls, one behind the other: list k is balls[first[k]] ... balls[first[k+1] - 1].
struct BallLists {
    std::vector<std::int64_t> first = {0};  ///< where each list begins, and where the last one ends
    std::vector<Index> balls;               ///< of all lists, one after the other

    /// How many lists.
    [[nodiscard]] std::size_t size() const noexcept { return first.size() - 1; }
    /// One of them.
    [[nodiscard]] std::span<const Index> operator[](std::size_t k) const noexcept {
        const auto begin = static_cast<std::size_t>(first[k]);
        return {balls.data() + begin, static_cast<std::size_t>(first[k + 1]) - begin};
    }
    /// Adds a list behind the others.
    void add(std::span<const Index> list) {
        balls.insert(balls.end(), list.begin(), list.end());
        first.push_back(static_cast<std::int64_t>(balls.size()));
    }
    friend bool operator==(const BallLists&, const BallLists&) = default;
};

/// The two ends of an edge, rising: vertices, or -1 for infinity. Of a closed edge both are this.
inline constexpr Index no_end = -2;

/// Hidden balls (those that lie in another one; of equal balls all but the first) occur in nothing
/// but `hidden`.
struct BallDiagram {
    std::int64_t balls = 0;  ///< how many, hidden ones included

    /// All balls that touch the sphere of a vertex, rising: four in general. Sorted as words; two
    /// vertices of the same balls are one after the other, that first whose `turn` is +1.
    BallLists vertices;
    /// The spheres, every number rounded once; the radius may be negative.
    std::vector<Site3> spheres;
    /// How the points of contact of the first four balls in the list turn that are touched by no
    /// infinite number of spheres (in general there are only four): the sign of their ccw. 0 where
    /// they lie in one plane; such a vertex may have no edges.
    std::vector<Sign> turns;

    /// All balls that touch along an edge, rising: three in general. Sorted as words, then by ends;
    /// several edges of the same balls are parts of one curve. Both ends may be one vertex, and two
    /// edges may have the same ends.
    BallLists edges;
    std::vector<std::array<Index, 2>> ends;  ///< of edges, in their order

    /// Those that are hidden, and the visible ball of the smallest number that hides each.
    std::vector<Hidden> hidden;
    friend bool operator==(const BallDiagram&, const BallDiagram&) = default;
};

/// Of the options threads, stop and progress are looked at. Throws std::invalid_argument, naming
/// the ball, for NaN or infinity, and for more than 2^28 balls; Stopped where options.stop asks for
/// it. Time: about in proportion to the result for balls spread at random, and for crystals. Where
/// m balls of equal radii touch one sphere, or have their centres in a plane, on a circle or on a
/// line, about m² steps; where m of different radii touch one sphere or one plane from one side,
/// each three and each four of them are looked at, up to m⁴. Where m balls are nearly so, but not
/// quite, about a thousand directions of each ball tell them apart, however little they are off:
/// some m² steps. A ball with m neighbours costs each of these up to m steps. Memory: about in
/// proportion to the result, and to the fours and threes that are looked at for one ball.
[[nodiscard]] BallDiagram ball_diagram(std::span<const Site3> balls, const Options& options = {});

}  // namespace signum
