/// How evenly the work of parts is spread: the processor time of the busiest of them, times their
/// number, over what the whole takes as one part. The parts come one after the other, each with its
/// answers to others, so that none waits or shares a cache.
///
/// usage: balance_benchmark [sites a part] [parts]

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../tests/property/in_parts.hpp"
#include "../triangulation/metric.hpp"

namespace signum::benchmarks {
namespace {

using namespace distributed;

/// A tenth of clustered sites is anywhere in the square or cube of side 2, the rest around 50
/// points of it, normally distributed with a deviation of 0.02.
std::vector<Placed> sites_of(std::size_t count, bool are_clustered, double greatest_radius,
                             std::size_t dimension) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::normal_distribution<double> normal(0.0, 0.02);
    std::vector<Site3> middles;
    const auto anywhere = [&] {
        const double x = uniform(random);
        const double y = uniform(random);
        return Site3{x, y, dimension == 3 ? uniform(random) : 0.0, 0.0};
    };
    for (int k = 0; k < 50; ++k) middles.push_back(anywhere());
    std::vector<Placed> sites;
    while (sites.size() < count) {
        Site3 site = anywhere();
        if (are_clustered && sites.size() % 10 != 0) {
            site = middles[random() % middles.size()];
            site.x += normal(random);
            site.y += normal(random);
            if (dimension == 3) site.z += normal(random);
        }
        site.r = greatest_radius * std::abs(uniform(random));
        sites.emplace_back(site, static_cast<std::int64_t>(sites.size()));
    }
    return sites;
}

void print_row(const Kind& kind, bool are_clustered, double radius, std::size_t each,
               std::size_t parts) {
    const std::vector<Placed> sites = sites_of(each * parts, are_clustered, radius, kind.dimension);
    const auto seconds_of = [&](std::size_t number) {
        return settle_in_parts(sites, kind, number).seconds;
    };
    const double one = seconds_of(1)[0];
    const std::vector<double> own = seconds_of(parts);
    const double busiest = *std::ranges::max_element(own);
    const auto count = static_cast<double>(parts);
    const double mean = std::accumulate(own.begin(), own.end(), 0.0) / count;
    fmt::print("| {}{} | {}{} | {:.2f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} |\n",
               name_of(kind.metric), kind.dimension == 3 ? ", space" : "",
               are_clustered ? "clusters" : "random", radius > 0.0 ? ", radii" : "", one, mean,
               busiest, busiest / mean, busiest * count / one);
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** words) {
    using namespace signum;
    try {
        const std::size_t each = count > 1 ? std::stoul(words[1]) : 250'000;
        const std::size_t parts = count > 2 ? std::stoul(words[2]) : 8;
        fmt::print("{} parts of {} sites, processor time\n\n", parts, each);
        fmt::print(
            "| metric | sites | one part, s | mean, s | busiest, s | busiest / mean | "
            "balance |\n|---|---|--:|--:|--:|--:|--:|\n");
        for (const bool are_clustered : {false, true}) {
            for (const double radius : {0.0, 0.01})
                for (const Metric metric : all_metrics)
                    benchmarks::print_row({metric, WeightIs::radius, 2}, are_clustered, radius,
                                          each, parts);
            benchmarks::print_row({Metric::power, WeightIs::radius, 3}, are_clustered, 0.0,
                                  each / 2, parts);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
    return 0;
}
