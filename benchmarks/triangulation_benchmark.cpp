/// Whole constructions of one thread: signum, signum with naive arithmetic (what exactness costs)
/// and CGAL, interleaved, on every distribution.
///
/// usage: triangulation_benchmark [--sites=1000000] [Google Benchmark's options]
/// A tenth of the sites in the metrics other than power.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../tool/generate/generate.hpp"
#include "../triangulation/triangulate.hpp"

#include "cgal_constructions.hpp"
#include "interleaved.hpp"

namespace signum::benchmarks {
namespace {

constexpr std::pair<const char*, Distribution> distributions[] = {{"random", Distribution::random},
                                                                  {"grid", Distribution::grid},
                                                                  {"circle", Distribution::circle},
                                                                  {"square", Distribution::square}};

/// What is built: a metric, radii, and CGAL's counterpart where there is one.
struct Kind {
    const char* name;
    const char* title;
    Metric metric;
    double radius;           ///< the largest, in mean distances of neighbours
    const char* cgal_class;  ///< empty where CGAL has none
    Construction (*cgal)(const std::vector<Site>&);
};
constexpr Kind kinds[] = {
    {"Delaunay", "Delaunay triangulation", Metric::power, 0, "Delaunay_triangulation_2",
     cgal::delaunay},
    {"regular", "Regular triangulation", Metric::power, 1, "Regular_triangulation_2",
     cgal::regular},
    {"Euclidean", "Euclidean tessellation of discs", Metric::euclidean, 1,
     "Apollonius_graph_hierarchy_2", cgal::apollonius},
    {"small", "Euclidean tessellation of small discs", Metric::euclidean, 0.1,
     "Apollonius_graph_hierarchy_2", cgal::apollonius},
    {"supremum", "Supremum tessellation of points", Metric::supremum, 0,
     "Segment_Delaunay_graph_Linf_hierarchy_2", cgal::linf},
    {"squares", "Supremum tessellation of squares", Metric::supremum, 1, "", nullptr},
    {"diamonds", "Manhattan tessellation of diamonds", Metric::manhattan, 1, "", nullptr},
};

/// How far a site is from the next one, roughly.
double spacing(Distribution distribution, std::int64_t n) {
    constexpr double side = 700.0;
    const auto count = static_cast<double>(n);
    if (distribution == Distribution::circle) return 3.14159 * side / count;
    if (distribution == Distribution::square) return 4.0 * side / count;
    return side / std::sqrt(count);
}

std::string name_of(const Kind& kind, const char* distribution, const char* contestant) {
    return fmt::format("{} {} {}", kind.name, distribution, contestant);
}

Construction construction(std::shared_ptr<const std::vector<Site>> sites, Metric metric,
                          Arithmetic arithmetic) {
    return [sites = std::move(sites), metric, arithmetic] {
        return built(triangulate(*sites, metric, {.arithmetic = arithmetic, .threads = 1}));
    };
}

/// Sites of a kind: CGAL's graphs of curved metrics take their time.
std::int64_t sites_of(const Kind& kind, std::int64_t n) {
    return kind.metric == Metric::power ? n : std::max<std::int64_t>(1, n / 10);
}

void add_all(std::int64_t all, Visible& visible) {
    for (const Kind& kind : kinds)
        for (const auto& [name, distribution] : distributions) {
            const std::int64_t n = sites_of(kind, all);
            const double radius = kind.radius * spacing(distribution, n);
            const auto sites = std::make_shared<const std::vector<Site>>(
                generate(distribution, {.count = n, .radius_to = radius, .seed = 1}));
            add(name_of(kind, name, "exact"), construction(sites, kind.metric, Arithmetic::exact),
                visible);
            add(name_of(kind, name, "naive"), construction(sites, kind.metric, Arithmetic::naive),
                visible);
            if (kind.cgal != nullptr) add(name_of(kind, name, "CGAL"), kind.cgal(*sites), visible);
        }
}

bool print_table(const Kind& kind, std::int64_t n, const Measurements& measured,
                 const Visible& visible) {
    constexpr double second = 1.0;
    const bool with_cgal = kind.cgal != nullptr;
    fmt::print("{}, {} sites, seconds ({}, one thread):\n\n", kind.title, n, SIGNUM_FLAGS);
    std::vector<std::string> header = {"sites", "signum"};
    if (kind.radius > 0.0) header.insert(header.begin() + 1, "hidden");
    if (with_cgal)
        header.insert(header.end(), {fmt::format("CGAL {} `{}`", cgal::version(), kind.cgal_class),
                                     "CGAL / signum"});
    header.insert(header.end(), {"signum, naive arithmetic", "exact / naive"});
    print_header(header);

    bool all_agree = true;
    for (const auto& [name, distribution] : distributions) {
        const std::string exact = name_of(kind, name, "exact");
        const std::string naive = name_of(kind, name, "naive");
        const std::string cgal = name_of(kind, name, "CGAL");
        std::vector<std::string> row = {name, measured.cell(exact, second)};
        if (kind.radius > 0.0) {
            const auto found = visible.find(exact);
            const double share = found == visible.end() ? 0.0
                                                        : 1.0 - static_cast<double>(found->second) /
                                                                    static_cast<double>(n);
            row.insert(row.begin() + 1, fmt::format("{:.1f} %", 100.0 * share));
        }
        if (with_cgal)
            row.insert(row.end(), {measured.cell(cgal, second), measured.ratio(cgal, exact)});
        row.insert(row.end(), {measured.cell(naive, second), measured.ratio(exact, naive)});
        print_row(row);
        all_agree &= visible.agree(fmt::format("{} {}", kind.name, name), exact, cgal);
    }
    fmt::print("\n");
    return all_agree;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum::benchmarks;
    const std::int64_t n = take_sites(argc, argv, 1'000'000);
    Visible visible;
    add_all(n, visible);
    const Measurements measured = run_interleaved(argc, argv, 7);
    bool all_agree = true;
    for (const Kind& kind : kinds)
        all_agree &= print_table(kind, sites_of(kind, n), measured, visible);
    fmt::print(
        "{} Radii: uniform from 0 to the mean distance of neighbours, to a tenth of it for small "
        "discs.\n",
        measured.footnote());
    return all_agree ? 0 : 1;
}
