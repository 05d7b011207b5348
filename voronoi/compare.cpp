#include "compare.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "../exact/floating_environment.hpp"
#include "contacts.hpp"

namespace signum {
namespace {

/// The edges between sites, the smaller number first, sorted.
std::vector<Edge> edges_between_sites(const Tessellation& tessellation) {
    std::vector<Edge> edges = tessellation.edges();
    std::erase_if(edges, [](const Edge& edge) { return edge[0] == infinite; });
    return edges;
}

void require_same_sites(const Tessellation& a, const Tessellation& b) {
    if (a.metric() != b.metric() || a.weight_is() != b.weight_is())
        throw std::invalid_argument("two tessellations to be compared are of different metrics");
    if (!std::equal(a.sites().begin(), a.sites().end(), b.sites().begin(), b.sites().end()))
        throw std::invalid_argument("two tessellations to be compared have different sites");
}

}  // namespace

EdgeComparison compare_edges(const Tessellation& tessellation, const Tessellation& canonical) {
    const exact::IeeeEnvironment environment;
    require_same_sites(tessellation, canonical);
    const std::vector<Edge> compared = edges_between_sites(tessellation);
    const std::vector<Edge> expected = edges_between_sites(canonical);
    std::vector<Edge> unexpected;
    std::set_difference(compared.begin(), compared.end(), expected.begin(), expected.end(),
                        std::back_inserter(unexpected));

    EdgeComparison result;
    result.edges = static_cast<std::int64_t>(compared.size());
    if (unexpected.empty()) return result;
    const Canonical known(canonical);
    const Contacts may_share_edge = contacts_of(known);
    for (std::size_t first = 0, next = 0; first < unexpected.size(); first = next) {
        const Edge edge = unexpected[first];
        while (next < unexpected.size() && unexpected[next] == edge) ++next;
        const bool valid = std::binary_search(expected.begin(), expected.end(), edge) ||
                           may_share_edge(edge[0], edge[1]);
        auto& kind = valid ? result.different : result.wrong;
        kind.insert(kind.end(), next - first, edge);
    }
    return result;
}

}  // namespace signum
