#include "compare.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "../core/parallel.hpp"
#include "../exact/floating_environment.hpp"
#include "contacts.hpp"

namespace signum {
namespace {

/// The edges between sites, the smaller number first, sorted.
std::vector<Edge> edges_between_sites(const Tessellation& tessellation, const Workers& workers) {
    const auto faces = tessellation.faces();
    const auto edge = [&](std::size_t corner) -> Edge {
        const Face& face = faces[corner / 3];
        return {face[(corner + 1) % 3], face[(corner + 2) % 3]};
    };
    // Dealt by their smaller site, so that one bucket is sorted beside another.
    const std::size_t buckets = workers.range_count(faces.size());
    const std::size_t sites = tessellation.sites().size();
    std::vector<Edge> edges;
    const std::vector<std::size_t> begins = deal(
        workers, 3 * faces.size(), buckets,
        [&](std::size_t corner) {
            const auto [from, to] = edge(corner);
            // Listed by that of its two faces in which it runs from smaller to larger.
            const bool is_listed = from != infinite && from < to;
            return is_listed ? static_cast<std::size_t>(from) * buckets / sites : buckets;
        },
        [&](std::size_t count) { make_room(workers, count, edges); },
        [&](std::size_t corner, std::size_t place) { edges[place] = edge(corner); });
    workers.each(buckets, [&](std::size_t b) {
        std::sort(edges.data() + begins[b], edges.data() + begins[b + 1]);
    });
    return edges;
}

void require_same_sites(const Tessellation& a, const Tessellation& b) {
    if (a.metric() != b.metric() || a.weight_is() != b.weight_is())
        throw std::invalid_argument("two tessellations to be compared are of different metrics");
    if (!std::equal(a.sites().begin(), a.sites().end(), b.sites().begin(), b.sites().end()))
        throw std::invalid_argument("two tessellations to be compared have different sites");
}

}  // namespace

EdgeComparison compare_edges(const Tessellation& tessellation, const Tessellation& canonical,
                             int threads) {
    const exact::IeeeEnvironment environment;
    require_same_sites(tessellation, canonical);
    const Workers workers(threads, canonical.faces().size());
    const std::vector<Edge> compared = edges_between_sites(tessellation, workers);
    const std::vector<Edge> expected = edges_between_sites(canonical, workers);
    std::vector<Edge> unexpected;
    std::set_difference(compared.begin(), compared.end(), expected.begin(), expected.end(),
                        std::back_inserter(unexpected));

    EdgeComparison result;
    result.edges = static_cast<std::int64_t>(compared.size());
    if (unexpected.empty()) return result;
    const Canonical known(canonical);
    const Contacts may_share_edge = contacts_of(known);
    std::vector<char> are_valid(unexpected.size());
    workers.each_range(unexpected.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
            const Edge& edge = unexpected[e];
            const bool is_as_before = e > begin && unexpected[e - 1] == edge;
            are_valid[e] = is_as_before ? are_valid[e - 1]
                                        : std::ranges::binary_search(expected, edge) ||
                                              may_share_edge(edge[0], edge[1]);
        }
    });
    for (std::size_t e = 0; e < unexpected.size(); ++e)
        (are_valid[e] != 0 ? result.different : result.wrong).push_back(unexpected[e]);
    return result;
}

}  // namespace signum
