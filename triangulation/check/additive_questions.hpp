#pragma once
/// What a judge asks of a face, and of an edge, in the metrics with additive weights: see
/// additive_check.hpp.

#include <array>
#include <cstdint>
#include <utility>

#include "../insertion/edge_interior.hpp"
#include "../structure/judgement.hpp"

namespace signum::triangulation {

/// Asked by one loop, and noted. Names: what messages call a site by its number, the face, and the
/// face across the edge.
template <class Kernel>
struct AdditiveQuestions : Notes {
    AdditiveQuestions(const Notes& notes, Kernel judging)
        : Notes(notes), kernel(std::move(judging)) {}

    Kernel kernel;
    std::uint64_t intervals = 0;  ///< questions that intervals decided

    /// Throws if the question is answered yes; where nothing but the tie rule does so, notes it.
    /// Whether the answer is no. Reasons are given by a function, for they are seldom needed.
    template <class Question, class Why>
    bool forbid(Question question, Why why) {
        const auto before = kernel.tally().ties;
        if (!question()) [[likely]]
            return true;
        if (kernel.tally().ties == before) throw Invalid{why()};
        note("by the tie rule " + why());
        return false;
    }

    /// The face has its vertex: a circle that touches the three, or at infinity two sites of which
    /// neither hides the other.
    template <class Names>
    void judge_vertex(const std::array<Index, 3>& v, const Names& names) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (v[k] != infinite) continue;
            const Index i = v[(k + 1) % 3];
            const Index j = v[(k + 2) % 3];
            if (kernel.hides(i, j) || kernel.hides(j, i))
                throw Invalid{names.of_face() + " joins a site to one it hides"};
            return;
        }
        if (!kernel.exists(v[0], v[1], v[2]))
            throw Invalid{"no circle touches the sites of " + names.of_face() +
                          " counterclockwise"};
    }

    /// The edge has its stretch: its end at the face lies no nearer to the site across, and on the
    /// way between its ends the bisector does not pass through infinity. `about`: see
    /// Topology::about().
    template <class Names>
    void judge_edge(const std::array<Index, 4>& about, const Names& names) {
        const auto [i, j, k, l] = about;
        const bool apart =
            k == l ||
            forbid([&, i = i, j = j, k = k,
                    l = l] { return ExtendedKernel(kernel).conflicts(i, j, k, l); },
                   [&, l = l] { return names.of(l) + " is in conflict with " + names.of_face(); });
        if (apart && i < j && i != infinite && k != infinite && l != infinite &&
            !runs_forward(kernel, i, j, k, l))
            throw Invalid{"the edge of " + names.of_face() + " and " + names.of_face_across() +
                          " would pass through infinity"};
    }
};

}  // namespace signum::triangulation
