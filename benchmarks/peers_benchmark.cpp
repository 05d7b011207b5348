/// signum beside its peers in one run: time, memory, and whether the result is right. Every
/// construction runs in a process of its own, the peers take turns, and what comes back is judged:
/// by signum's validator, by the test whether any choice of ties has an edge, and by CGAL's
/// predicates where CGAL builds the same.
///
/// usage: peers_benchmark [--sites N] [--rounds N] [--delaunator COMMAND]
/// COMMAND, a shell's, reads and writes as peer_run.hpp says.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../tool/generate/generate.hpp"
#include "../tool/study/timing.hpp"
#include "../triangulation/triangulate.hpp"
#include "../triangulation/validate.hpp"
#include "../voronoi/contacts.hpp"

#include "cgal_constructions.hpp"
#include "interleaved.hpp"
#include "peer_run.hpp"

namespace signum::benchmarks {
namespace {

Prepare prepare_signum(Metric metric) {
    return [metric](const std::vector<Site>& sites) {
        return [metric, sites] { return built(triangulate(sites, metric, {.threads = 1})); };
    };
}

struct Peer {
    std::string name;
    Prepare prepare;                   ///< empty for other programs
    std::vector<std::string> command;  ///< see run()
};

/// Peers that build the same of the same sites.
struct Kind {
    std::string name;
    Metric metric;
    double radius;       ///< the largest, in mean distances of neighbours
    std::int64_t share;  ///< of the sites asked for, one in so many
    bool cgal_judges;
    std::vector<Peer> peers;
};

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

/// What signum says of it: right, or how many edges no choice of ties has, or how many are missing.
/// `contact` is that of `known`, the canonical tessellation of the same sites.
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

/// The rows of one kind in the table of a distribution.
void print_rows(const Kind& kind, Distribution distribution, std::int64_t n, int rounds) {
    const double radius = kind.radius * 700.0 / std::sqrt(static_cast<double>(n));
    std::vector<Site> sites = generate(distribution, {.count = n, .radius_to = radius, .seed = 1});
    if (kind.radius == 0.0)
        for (Site& site : sites) site.r = 0.0;  // the tangent ones have radii of their own
    std::vector<std::vector<Outcome>> outcomes(kind.peers.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t turn = 0; turn < kind.peers.size(); ++turn) {
            const std::size_t i = round % 2 == 0 ? turn : kind.peers.size() - 1 - turn;
            if (static_cast<int>(outcomes[i].size()) < round) continue;  // it failed before
            std::optional<Outcome> outcome = run(kind.peers[i].command, sites);
            if (!outcome) continue;
            if (!outcomes[i].empty()) outcome->faces = outcome->neighbours = {};
            outcomes[i].push_back(std::move(*outcome));
        }
    const Tessellation canonical = triangulate(sites, kind.metric);
    const Canonical known(canonical);
    const Contacts contact = contacts_of(known);
    for (std::size_t i = 0; i < kind.peers.size(); ++i) {
        if (static_cast<int>(outcomes[i].size()) < rounds) {
            print_row({kind.name, kind.peers[i].name, std::to_string(n), "", "", "",
                       fmt::format("failed, or not within {} s", most_seconds), ""});
            continue;
        }
        std::vector<double> seconds;
        std::vector<double> ratios;
        std::vector<double> peaks;
        for (std::size_t round = 0; round < outcomes[i].size(); ++round) {
            seconds.push_back(outcomes[i][round].seconds);
            peaks.push_back(outcomes[i][round].peak_bytes);
            if (round < outcomes[0].size())
                ratios.push_back(outcomes[i][round].seconds / outcomes[0][round].seconds);
        }
        std::string by_cgal;
#if defined(SIGNUM_WITH_CGAL)
        if (kind.cgal_judges)
            by_cgal = cgal::are_regular(outcomes[i][0].faces, sites, kind.radius > 0.0)
                          ? "right"
                          : "**wrong**";
#endif
        print_row({kind.name, kind.peers[i].name, std::to_string(n),
                   fmt::format("{:.0f} ms", 1e3 * study::median_of(seconds).median),
                   ratios.empty() ? "" : fmt::format("{:.2f}", study::median_of(ratios).median),
                   fmt::format("{:.0f}", study::median_of(peaks).median / static_cast<double>(n)),
                   judge(outcomes[i][0], known, contact), by_cgal});
        std::fflush(stdout);
    }
}

std::vector<Kind> kinds(const std::string& delaunator) {
    std::vector<Kind> all = {{"Delaunay", Metric::power, 0.0, 1, true, {}},
                             {"power", Metric::power, 1.0, 1, true, {}},
                             {"Euclidean", Metric::euclidean, 1.0, 5, false, {}},
                             {"supremum, points", Metric::supremum, 0.0, 5, false, {}}};
    for (Kind& kind : all) kind.peers.push_back({"signum", prepare_signum(kind.metric), {}});
#if defined(SIGNUM_WITH_TETGEN)
    all[0].peers.push_back({"signum on Shewchuk's predicates (TetGen)", prepare_shewchuk, {}});
#endif
#if defined(SIGNUM_WITH_CGAL)
    all[0].peers.push_back({"CGAL, Delaunay_triangulation_2", cgal::delaunay, {}});
    all[1].peers.push_back({"CGAL, Regular_triangulation_2", cgal::regular, {}});
    all[2].peers.push_back({"CGAL, Apollonius_graph_hierarchy_2", cgal::apollonius, {}});
    all[3].peers.push_back({"CGAL, Segment_Delaunay_graph_Linf_hierarchy_2", cgal::linf, {}});
#endif
#if defined(SIGNUM_WITH_QHULL)
    all[0].peers.push_back({"Qhull", prepare_qhull, {}});
#endif
    // The last: this program as a peer knows no other programs.
    if (!delaunator.empty())
        all[0].peers.push_back(
            {"Delaunator, robust-predicates (node)", {}, {"/bin/sh", "-c", delaunator}});
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t p = 0; p < all[k].peers.size(); ++p)
            if (all[k].peers[p].prepare)
                all[k].peers[p].command = {"/proc/self/exe", "--attempt",
                                           fmt::format("{} {}", k, p)};
    return all;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum;
    using namespace signum::benchmarks;
    std::map<std::string, std::string> options = {
        {"--sites", "30000"}, {"--rounds", "7"}, {"--delaunator", ""}, {"--attempt", ""}};
    for (int i = 1; i < argc; i += 2) {
        const auto option = options.find(argv[i]);
        if (option == options.end() || i + 1 == argc) {
            fmt::print(stderr,
                       "usage: peers_benchmark [--sites N] [--rounds N] [--delaunator COMMAND]\n");
            return 2;
        }
        option->second = argv[i + 1];
    }
    // This program again, as one of the peers.
    std::size_t kind = 0;
    std::size_t peer = 0;
    if (std::sscanf(options["--attempt"].c_str(), "%zu %zu", &kind, &peer) == 2)
        return attempt(kinds("").at(kind).peers.at(peer).prepare);
    std::signal(SIGPIPE, SIG_IGN);  // of a peer that ends before it has read everything
    const std::int64_t n = std::strtoll(options["--sites"].c_str(), nullptr, 10);
    const int rounds = static_cast<int>(std::strtol(options["--rounds"].c_str(), nullptr, 10));
    if (n < 100 || rounds < 1) {
        fmt::print(stderr, "--sites takes 100 or more, --rounds 1 or more\n");
        return 2;
    }
    const std::vector<Kind> all = kinds(options["--delaunator"]);
    for (const Distribution distribution : all_distributions) {
        fmt::print("{}:\n\n", name_of(distribution));
        print_header({"tessellation", "by", "sites", "time", "time / signum", "peak, bytes a site",
                      "result", "judged by CGAL"});
        for (const Kind& kind : all) print_rows(kind, distribution, n / kind.share, rounds);
        fmt::print("\n");
    }
    fmt::print("Medians of {} rounds, every construction in a process of its own, all in turn.\n",
               rounds);
    return 0;
}
