#pragma once
/// Who hides whom, settled at the end: the visible site nearest to each hidden site's centre.

#include <algorithm>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../options.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// A face at every visible vertex, -1 for the hidden ones.
[[nodiscard]] inline std::vector<Index> faces_of_vertices(const Topology& topology,
                                                          std::size_t sites) {
    std::vector<Index> result(sites, -1);
    for (Index f = 0; f < topology.faces(); ++f)
        for (const Index v : topology.vertices(f))
            if (v >= 0) result[static_cast<std::size_t>(v)] = f;
    return result;
}

/// The visible vertex nearest to a point, from any visible vertex: the distance has no local
/// minimum on the tessellation but the global one, so going to a nearer neighbour as long as there
/// is one suffices. Rounded distances may lead around in circles; more steps than there are sites
/// are a proof of it.
template <class Kernel>
[[nodiscard]] Index nearest_vertex(const Topology& topology, const Kernel& kernel,
                                   std::span<const Index> face_of, Point point, Index start) {
    Index nearest = start;
    std::size_t steps = face_of.size();
    for (bool improved = true; improved;) {
        improved = false;
        if constexpr (!Kernel::is_exact)
            if (steps-- == 0) throw BrokenStructure("the walk to a hidden site went in circles");
        const Index f = face_of[static_cast<std::size_t>(nearest)];
        if (f < 0) break;  // the only visible site
        for (const HalfEdge h : topology.fan(topology.spoke(f, nearest))) {
            const Index v = topology.target(h);
            if (v != infinite && kernel.nearer(point, v, nearest)) {
                nearest = v;
                improved = true;
                break;
            }
        }
    }
    return nearest;
}

/// Replaces every entry of hidden_by that is not -1, some site met during the construction, by the
/// visible site nearest to the hidden one's centre.
template <class Kernel>
void settle_hiders(const Topology& topology, const Kernel& kernel, std::span<Index> hidden_by) {
    if (std::all_of(hidden_by.begin(), hidden_by.end(), [](Index by) { return by < 0; })) return;
    const std::vector<Index> face_of = faces_of_vertices(topology, hidden_by.size());
    // Hiders may have become hidden in their turn, by sites inserted later. Those chains end, and
    // settling a site shortens the chains that lead through it.
    for (std::size_t i = 0; i < hidden_by.size(); ++i) {
        if (hidden_by[i] < 0) continue;
        Index start = hidden_by[i];
        while (hidden_by[static_cast<std::size_t>(start)] >= 0)
            start = hidden_by[static_cast<std::size_t>(start)];
        hidden_by[i] =
            nearest_vertex(topology, kernel, face_of, kernel.centre(static_cast<Index>(i)), start);
    }
}

}  // namespace signum::triangulation
