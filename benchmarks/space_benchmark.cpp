/// Whole constructions in space, of one thread: signum, signum with naive arithmetic (what
/// exactness costs) and CGAL, interleaved, and their peaks of memory; with --compare cell for cell
/// beside CGAL's instead.
///
/// usage: space_benchmark [--sites=1000000] [--compare] [Google Benchmark's options]

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../tool/generate/generate.hpp"
#include "../triangulation/space/triangulate.hpp"

#include "cgal_constructions.hpp"
#include "interleaved.hpp"

namespace signum::benchmarks {
namespace {

using Sites = std::vector<Site3>;

/// Integer points of a cube: exact ties everywhere.
Sites lattice(std::int64_t n) {
    const std::int64_t side = std::llround(std::cbrt(static_cast<double>(n)));
    Sites sites;
    for (std::int64_t i = 0; i < side * side * side; ++i)
        sites.push_back({static_cast<double>(i % side), static_cast<double>(i / side % side),
                         static_cast<double>(i / side / side), 0.0});
    return sites;
}
/// Radii are up to the mean distance of neighbours.
template <SpaceDistribution distribution, bool has_radii>
Sites generated(std::int64_t n) {
    const double spacing = 700.0 / std::cbrt(static_cast<double>(n));
    return generate(distribution, {.count = n, .radius_to = has_radii ? spacing : 0.0, .seed = 1});
}

struct Kind {
    const char* name;
    Sites (*sites)(std::int64_t);
    bool is_regular = false;
};
constexpr Kind kinds[] = {{"random, Delaunay", generated<SpaceDistribution::random, false>},
                          {"random, regular", generated<SpaceDistribution::random, true>, true},
                          {"lattice of integers, Delaunay", lattice},
                          {"rounded grid, Delaunay", generated<SpaceDistribution::grid, false>},
                          {"sphere, Delaunay", generated<SpaceDistribution::sphere, false>}};

/// Points where all weights are equal: Delaunay.
SpaceTessellation tessellate(const Sites& sites, bool is_regular, const Options& options) {
    if (is_regular) return triangulate(std::span(sites), Power{}, options);
    std::vector<Point3> points;
    points.reserve(sites.size());
    for (const Site3& site : sites) points.push_back({site.x, site.y, site.z});
    return triangulate(std::span<const Point3>(points), Power{}, options);
}

Construction construction(std::shared_ptr<const Sites> sites, bool is_regular,
                          Arithmetic arithmetic) {
    return [sites = std::move(sites), is_regular, arithmetic] {
        Options options;
        options.threads = 1;
        options.arithmetic = arithmetic;
        const auto result =
            std::make_shared<SpaceTessellation>(tessellate(*sites, is_regular, options));
        return Built{result->sites - static_cast<std::int64_t>(result->hidden.size()), result, {}};
    };
}

std::string name_of(const Kind& kind, const char* contestant) {
    return fmt::format("{} {}", kind.name, contestant);
}

bool measure(std::int64_t n, int argc, char** argv) {
    Visible visible;
    for (const Kind& kind : kinds) {
        const auto sites = std::make_shared<const Sites>(kind.sites(n));
        add(name_of(kind, "exact"), construction(sites, kind.is_regular, Arithmetic::exact),
            visible);
        add(name_of(kind, "naive"), construction(sites, kind.is_regular, Arithmetic::naive),
            visible);
        add(name_of(kind, "CGAL"), cgal::in_space(*sites, kind.is_regular), visible);
    }
    const Measurements measured = run_interleaved(argc, argv, 7);
    constexpr double second = 1.0;
    fmt::print("Power tessellations of space, {} sites, seconds ({}, one thread):\n\n", n,
               SIGNUM_FLAGS);
    std::vector<std::string> header = {"sites", "signum", "signum, naive arithmetic",
                                       "exact / naive"};
    if (cgal::is_there)
        header.insert(header.end(), {fmt::format("CGAL {}", cgal::version()), "CGAL / signum"});
    print_header(header);
    bool all_agree = true;
    for (const Kind& kind : kinds) {
        const std::string exact = name_of(kind, "exact");
        const std::string naive = name_of(kind, "naive");
        const std::string other = name_of(kind, "CGAL");
        std::vector<std::string> row = {kind.name, measured.cell(exact, second),
                                        measured.cell(naive, second), measured.ratio(exact, naive)};
        if (cgal::is_there)
            row.insert(row.end(), {measured.cell(other, second), measured.ratio(other, exact)});
        all_agree &= visible.agree(kind.name, exact, other);
        print_row(row);
    }
    fmt::print("\n{} Radii of regular ones: uniform from 0 to the mean distance of neighbours.\n",
               measured.footnote());
    return all_agree;
}

/// Finite cells beside CGAL's, of sets up to n sites. Equal weights with all ties; untied others.
bool compare(std::int64_t n) {
    bool all_agree = true;
    for (const Kind& kind : kinds)
        for (std::int64_t size = 10; size <= n; size *= 10) {
            const Sites sites = kind.sites(size);
            std::vector<std::array<Index, 4>> ours;
            for (SpaceCell cell : tessellate(sites, kind.is_regular, {}).cells) {
                if (cell[0] < 0) continue;
                std::ranges::sort(cell);
                ours.push_back(cell);
            }
            std::ranges::sort(ours);
            const auto theirs = cgal::cells(sites, kind.is_regular);
            fmt::print("{}, {} sites: {} cells, {}\n", kind.name, sites.size(), ours.size(),
                       ours == theirs ? "CGAL's" : "not CGAL's");
            all_agree &= ours == theirs;
        }
    return all_agree;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum::benchmarks;
    const std::int64_t n = take_sites(argc, argv, 1'000'000);
    if (take("--compare", argc, argv).empty()) return measure(n, argc, argv) ? 0 : 1;
    if (cgal::is_there) return compare(n) ? 0 : 1;
    fmt::print(stderr, "there is no CGAL to compare with\n");
    return 2;
}
