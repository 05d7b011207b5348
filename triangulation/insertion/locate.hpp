#pragma once
/// Point location by a visibility walk.

#include <limits>
#include <utility>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
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
    // Of the edges through which the walk comes it knows that q lies on their left; of this one
    // not.
    if (kernel.ccw(topology.origin(h), topology.target(h), q) < 0) h = topology.twin(h);
    for (Index steps = topology.faces(); Kernel::is_exact || steps >= 0; --steps) {
        const Index apex = topology.apex(h);
        if (apex == infinite) return Topology::face(h);
        // Both sides are asked before either answer is looked at: which edge to cross is anybody's
        // guess, and selecting is cheaper than guessing wrong.
        const Sign after = kernel.ccw(topology.target(h), apex, q);
        const Sign before = kernel.ccw(apex, topology.origin(h), q);
        if ((after | before) >= 0) return Topology::face(h);
        h = topology.twin(after < 0 ? Topology::next(h) : Topology::previous(h));
    }
    throw BrokenStructure("the walk to a site went in circles");
}

/// A half-edge out of the site nearest to the centre of q, leading to the neighbour that comes
/// next, roughly; from a face where the walk starts. As cells are star-shaped, every site but the
/// nearest has a neighbour that is nearer: the one whose cell the segment to q's centre enters.
template <class Kernel>
[[nodiscard]] HalfEdge locate_nearest(const Topology& topology, Kernel& kernel, Index start,
                                      Index q) {
    // From the nearest corner of the face, roughly: cells may be long and thin, and a neighbour of
    // the site inserted last then be a thousand sites away.
    HalfEdge first = Topology::first_edge(start);
    if (topology.origin(first) == infinite) first = Topology::next(first);
    auto least = kernel.distance(q, topology.origin(first));
    for (const HalfEdge corner : {Topology::next(first), Topology::previous(first)}) {
        if (topology.origin(corner) == infinite) continue;
        const auto distance = kernel.distance(q, topology.origin(corner));
        if (distance.to_centre - distance.radius >= least.to_centre - least.radius) continue;
        first = corner;
        least = distance;
    }
    Index nearest = topology.origin(first);
    Index before = infinite;
    HalfEdge next = first;
    double to_next = std::numeric_limits<double>::infinity();
    for (Index steps = topology.faces(); Kernel::is_exact || steps >= 0; --steps) {
        const Index start = nearest;
        for (const HalfEdge h : topology.fan(first)) {
            const Index v = topology.target(h);
            if (v == infinite || v == before) continue;
            const auto distance = kernel.distance(q, v);
            if (kernel.is_nearer(q, v, distance, nearest, least)) {
                first = next = topology.twin(h);
                to_next = least.to_centre - least.radius;
                before = std::exchange(nearest, v);
                least = distance;
                break;
            }
            if (distance.to_centre - distance.radius < to_next) {
                to_next = distance.to_centre - distance.radius;
                next = h;
            }
        }
        if (nearest == start) return next;
    }
    throw BrokenStructure("the walk to a site went in circles");
}

}  // namespace signum::triangulation
