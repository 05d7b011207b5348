#include "peer_judge.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "../triangulation/validate.hpp"

namespace signum::benchmarks {
namespace {

/// Pairs of sites joined by an edge, the smaller number first.
std::vector<Edge> edges_of(const std::vector<Face>& faces) {
    std::vector<Edge> edges;
    for (const Face& face : faces)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = face[k];
            const Index b = face[(k + 1) % 3];
            if (a != infinite && b != infinite && a != b)
                edges.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace

std::string judge(const Outcome& outcome, const Canonical& known, const Contacts& contact) {
    const Tessellation& canonical = known.tessellation();
    const std::vector<Site> sites(canonical.sites().begin(), canonical.sites().end());
    TessellationArrays arrays;
    arrays.metric = canonical.metric();
    arrays.sites = static_cast<std::int64_t>(sites.size());
    arrays.faces = outcome.faces;
    arrays.neighbours = outcome.neighbours;
    std::vector<char> is_there(sites.size(), 0);
    for (const Face& face : arrays.faces)
        for (const Index v : face)
            if (v != infinite) is_there[static_cast<std::size_t>(v)] = 1;
    // Which site hides another is signum's to say; peers that say it have other ways.
    for (Index i = 0; i < static_cast<Index>(sites.size()); ++i)
        if (!is_there[static_cast<std::size_t>(i)])
            arrays.hidden.push_back({i, known.hidden_by(i)});
    if (validate(arrays, sites).valid) return "right";

    const std::vector<Edge> expected =
        edges_of(std::vector<Face>(canonical.faces().begin(), canonical.faces().end()));
    const std::vector<Edge> edges = edges_of(outcome.faces);
    const auto wrong = std::count_if(edges.begin(), edges.end(), [&](const Edge& edge) {
        return !std::binary_search(expected.begin(), expected.end(), edge) &&
               !contact(edge[0], edge[1]);
    });
    if (wrong > 0) return fmt::format("**{} of {} edges wrong**", wrong, edges.size());
    const auto missing =
        static_cast<std::int64_t>(expected.size()) - static_cast<std::int64_t>(edges.size());
    if (missing > 0) return fmt::format("**{} of {} edges missing**", missing, expected.size());
    // With additive weights validate() knows vertices of its own tie rule alone.
    if (canonical.metric() != Metric::power) return "right, ties otherwise";
    return "**not a triangulation**";
}

}  // namespace signum::benchmarks
