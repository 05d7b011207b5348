#pragma once
/// Point location by a visibility walk.

#include <limits>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../predicates/additive.hpp"
#include "../options.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// A face whose closure contains the centre of q, or an infinite one whose hull edge strictly sees
/// it, walking from face `start`. From each face the walk crosses an edge that separates it from q;
/// in a regular triangulation such a walk visits no face twice (Edelsbrunner 1989), so that one
/// which takes more steps than there are faces was led astray by its arithmetic.
template <class Kernel>
[[nodiscard]] Index locate(const Topology& topology, Kernel& kernel, Index start, Index q) {
    HalfEdge h = topology.is_infinite(start) ? topology.twin(topology.finite_edge(start))
                                             : Topology::first_edge(start);
    // An edge that the walk has crossed has q on its left. The first one is not crossed: which side
    // q is on is asked.
    if (kernel.ccw(topology.origin(h), topology.target(h), q) < 0) h = topology.twin(h);
    for (Index steps = topology.faces(); Kernel::is_exact || steps >= 0; --steps) {
        const Index apex = topology.apex(h);
        if (apex == infinite) return Topology::face(h);
        // Both sides are asked before either answer is looked at: which edge to cross is anybody's
        // guess, and selecting is cheaper than guessing wrong.
        const Sign after = kernel.ccw(topology.target(h), apex, q);
        const Sign before = kernel.ccw(apex, topology.origin(h), q);
        if ((after | before) >= 0) return Topology::face(h);
        // The next edge where `after` is -1, the previous one otherwise, by a mask: compilers make
        // a branch of a choice.
        const HalfEdge previous = Topology::previous(h);
        h = topology.twin(previous ^
                          ((previous ^ Topology::next(h)) & static_cast<HalfEdge>(after >> 1)));
    }
    throw BrokenStructure("the walk to a site went in circles");
}

/// Where a walk to the site nearest to a centre came to.
struct Approach {
    HalfEdge spoke;   ///< out of the site reached, to the neighbour that comes next, roughly
    bool is_nearest;  ///< all neighbours were asked: none is nearer
};

/// How many neighbours of a site are asked before other means are tried. On random sites hardly one
/// in a million has more, and asking them all is the cheapest; but a giant among small sites has
/// nearly all of them for neighbours.
inline constexpr int few_neighbours = 24;

/// Where a walk begins: a half-edge out of a site, and how far that is from the centre of q.
struct WalkStart {
    HalfEdge spoke;
    additive::Distance distance;
};

/// The corner of a face nearest to the centre of q, roughly: where a walk best begins, for cells
/// may be long and thin, and another corner be a thousand sites away.
template <class Kernel>
[[nodiscard]] WalkStart nearest_corner(const Topology& topology, const Kernel& kernel, Index face,
                                       Index q) {
    HalfEdge first = Topology::first_edge(face);
    if (topology.origin(first) == infinite) first = Topology::next(first);
    WalkStart nearest = {first, kernel.distance(q, topology.origin(first))};
    for (const HalfEdge corner : {Topology::next(first), Topology::previous(first)}) {
        if (topology.origin(corner) == infinite) continue;
        const additive::Distance distance = kernel.distance(q, topology.origin(corner));
        if (distance.to_centre - distance.radius <
            nearest.distance.to_centre - nearest.distance.radius)
            nearest = {corner, distance};
    }
    return nearest;
}

/// Walks toward the site nearest to the centre of q; as far as asking few neighbours of each site
/// on the way leads. As cells are star-shaped, every site but the nearest has a neighbour that is
/// nearer: the one whose cell the segment to q's centre enters.
template <class Kernel>
[[nodiscard]] Approach locate_nearest(const Topology& topology, Kernel& kernel,
                                      const WalkStart& from, Index q) {
    // Not a fan: the walk goes on around the next site from where it came, which is not asked
    // again.
    HalfEdge h = from.spoke;
    HalfEdge first = h;
    HalfEdge next = h;
    Index nearest = topology.origin(h);
    additive::Distance least = from.distance;
    double to_next = std::numeric_limits<double>::infinity();
    int asked = 0;
    for (Index steps = topology.faces(); Kernel::is_exact || steps >= 0;) {
        const Index v = topology.target(h);
        if (v != infinite) {
            const auto distance = kernel.distance(q, v);
            if (kernel.is_nearer(q, v, distance, nearest, least)) {
                h = first = next = topology.twin(h);
                to_next = least.to_centre - least.radius;
                nearest = v;
                least = distance;
                asked = 0;
                --steps;
            } else if (distance.to_centre - distance.radius < to_next) {
                to_next = distance.to_centre - distance.radius;
                next = h;
            }
        }
        h = topology.around_origin(h);
        if (h == first) return {next, true};
        if (asked++ == few_neighbours) [[unlikely]]
            return {next, false};
    }
    throw BrokenStructure("the walk to a site went in circles");
}

}  // namespace signum::triangulation
