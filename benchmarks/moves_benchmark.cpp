/// All sites of a tessellation move a little: DynamicTessellation::move_all() beside triangulate()
/// of the same sites, taking turns; medians of their times and of the ratios.
///
/// usage: moves_benchmark [sites [metric]]
/// A displacement is the farthest that a coordinate changes, in mean distances of neighbours; the
/// sites come in no order, and their first move, which builds all anew, is not counted.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../tool/generate/generate.hpp"
#include "../triangulation/dynamic.hpp"
#include "../triangulation/triangulate.hpp"
#include "measuring.hpp"

namespace signum::benchmarks {
namespace {

struct Kind {
    const char* name;
    Metric metric;
    double radius;  ///< the largest, in mean distances of neighbours
};
constexpr Kind kinds[] = {
    {"power, weights", Metric::power, 0.5},       {"power, one weight", Metric::power, 0.0},
    {"Euclidean, radii", Metric::euclidean, 0.3}, {"Euclidean, one radius", Metric::euclidean, 0.0},
    {"Manhattan, radii", Metric::manhattan, 0.3}, {"supremum, radii", Metric::supremum, 0.3}};

/// Whether the two agree.
bool measure(const Kind& kind, std::int64_t count) {
    constexpr int rounds = 7;
    const double spacing = 700.0 / std::sqrt(static_cast<double>(count));
    std::vector<Site> sites =
        generate(Distribution::random, {.count = count, .radius_to = kind.radius * spacing});
    std::vector<Point> centres(sites.size());
    std::mt19937_64 random(1);
    const auto displace = [&](double most) {
        const auto uniform = [&] { return 0x1p-52 * static_cast<double>(random() >> 11) - 1.0; };
        for (std::size_t i = 0; i < sites.size(); ++i) {
            sites[i].x += most * uniform();
            sites[i].y += most * uniform();
            centres[i] = {sites[i].x, sites[i].y};
        }
    };
    DynamicTessellation dynamic(kind.metric);
    for (const Site& site : sites) static_cast<void>(dynamic.insert(site));
    displace(0.0);
    dynamic.move_all(centres);

    for (const double displacement : {0.0, 0.001, 0.01, 0.02, 0.05, 0.1}) {
        Turns turns;
        const Moves before = dynamic.moves();
        for (int round = 0; round < rounds; ++round) {
            displace(displacement * spacing);
            const double moving = seconds_of([&] { dynamic.move_all(centres); });
            turns.add(moving, seconds_of([&] {
                          static_cast<void>(triangulate(sites, kind.metric, {.threads = 1}));
                      }));
        }
        const Moves after = dynamic.moves();
        fmt::print("| {} | {} | {:.3f} | {:.3f} | {} | {} | {} | {} |\n", kind.name, displacement,
                   median(turns.first), median(turns.second), median_and_range(turns.ratios),
                   after.kept - before.kept, after.mended - before.mended,
                   after.built - before.built);
        std::fflush(stdout);
    }
    return dynamic.tessellation().arrays() == triangulate(sites, kind.metric).arrays();
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    using namespace signum;
    const std::int64_t sites = count > 1 ? std::strtoll(words[1], nullptr, 10) : 1'000'000;
    const std::string_view metric = count > 2 ? words[2] : "";
    if (sites < 1 || sites > max_sites) return 2;
    fmt::print(
        "{} random sites\n\n| sites | displacement | move_all, s | triangulate, s | ratio | kept | "
        "mended | built |\n| --- | --: | --: | --: | --: | --: | --: | --: |\n",
        sites);
    for (const benchmarks::Kind& kind : benchmarks::kinds) {
        if (!metric.empty() && name_of(kind.metric) != metric) continue;
        if (!benchmarks::measure(kind, sites)) {
            fmt::print(stderr, "{}: not what a fresh build makes\n", kind.name);
            return 1;
        }
    }
    return 0;
}
