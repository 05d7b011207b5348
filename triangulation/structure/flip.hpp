#pragma once
/// Flips: the two local changes that lead from one triangulation of the same sphere to another.
/// They know no coordinate.

#include <array>
#include <cstddef>

#include "../../core/index.hpp"
#include "topology.hpp"

namespace signum::triangulation {

/// Two faces for two: (a, b, c) and (d, c, b) at both sides of h, which leads from b to c, become
/// (a, b, d) and (d, c, a) in the same places. Precondition: a != d.
inline void flip(Topology& topology, HalfEdge h) {
    const HalfEdge t = topology.twin(h);
    const auto [b, c, a, d] = topology.about(h);
    const Index f = Topology::face(h);
    const Index g = Topology::face(t);
    const HalfEdge in_f = Topology::first_edge(f);
    const HalfEdge in_g = Topology::first_edge(g);
    // Where two of the four sides are each other's twins, they move along.
    const auto outside = [&](HalfEdge side) {
        const HalfEdge twin = topology.twin(side);
        if (twin == Topology::previous(h)) return in_f;  // a b
        if (twin == Topology::next(t)) return in_f + 1;  // b d
        if (twin == Topology::previous(t)) return in_g;  // d c
        if (twin == Topology::next(h)) return in_g + 1;  // c a
        return twin;
    };
    const HalfEdge ab = outside(Topology::previous(h));
    const HalfEdge bd = outside(Topology::next(t));
    const HalfEdge dc = outside(Topology::previous(t));
    const HalfEdge ca = outside(Topology::next(h));
    topology.record(f) = {{a, b, d}, topology.record(f).mark, {0, 0, 0}};
    topology.record(g) = {{d, c, a}, topology.record(g).mark, {0, 0, 0}};
    topology.glue(in_f, ab);
    topology.glue(in_f + 1, bd);
    topology.glue(in_g, dc);
    topology.glue(in_g + 1, ca);
    topology.glue(in_f + 2, in_g + 2);
}

/// One face for three: takes away the origin of h, which has three edges. The face stands where
/// that of h was; the places of the other two are vacant.
inline void remove_vertex(Topology& topology, HalfEdge h) {
    std::array<Index, 3> corners{};
    std::array<HalfEdge, 3> outside{};
    std::array<Index, 3> faces{};
    std::size_t k = 0;
    for (const HalfEdge spoke : topology.fan(h)) {
        corners[k] = topology.target(spoke);
        outside[k] = topology.twin(Topology::next(spoke));
        faces[k++] = Topology::face(spoke);
    }
    for (const Index f : {faces[1], faces[2]})
        topology.record(f) = {{Topology::vacant, Topology::vacant, Topology::vacant},
                              topology.record(f).mark,
                              {0, 0, 0}};
    const Index f = faces[0];
    topology.record(f) = {{corners[0], corners[1], corners[2]}, topology.record(f).mark, {0, 0, 0}};
    for (unsigned i = 0; i < 3; ++i) topology.glue(Topology::first_edge(f) + i, outside[i]);
}

}  // namespace signum::triangulation
