#pragma once
/// Point location by a visibility walk.

#include <signum/core/index.hpp>
#include <signum/triangulation/topology.hpp>
#include <signum/triangulation/triangulate.hpp>

namespace signum::triangulation {

/// A face whose closure contains the centre of q, or an infinite one whose hull edge strictly sees it,
/// walking from face `start`. From each face the walk crosses an edge that separates it from q; in a
/// regular triangulation such a walk visits no face twice (Edelsbrunner 1989), so that one which
/// takes more steps than there are faces was led astray by its arithmetic.
template <class Kernel>
[[nodiscard]] Index locate(const Topology& topology, Kernel& kernel, Index start, Index q) {
    HalfEdge h = topology.is_infinite(start) ? topology.twin(topology.finite_edge(start))
                                             : Topology::first_edge(start);
    // Of the edges through which the walk comes it knows that q lies on their left; of this one not.
    if (kernel.ccw(topology.origin(h), topology.target(h), q) < 0) h = topology.twin(h);
    for (Index steps = topology.faces(); Kernel::is_exact || steps >= 0; --steps) {
        const Index apex = topology.apex(h);
        if (apex == infinite) return Topology::face(h);
        if (kernel.ccw(topology.target(h), apex, q) < 0) {
            h = topology.twin(Topology::next(h));
        } else if (kernel.ccw(apex, topology.origin(h), q) < 0) {
            h = topology.twin(Topology::previous(h));
        } else {
            return Topology::face(h);
        }
    }
    throw BrokenStructure("the walk to a site went in circles");
}

}  // namespace signum::triangulation
