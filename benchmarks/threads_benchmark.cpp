/// Several threads against one, in turn in one run: constructions of the plane in every metric, and
/// of space. The results are compared; where one differs the program says so, and ends with 1.
///
/// usage: threads_benchmark [SITES [THREADS [ROUNDS]]]      1000000 sites, all cores, 7 rounds

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../core/parallel.hpp"
#include "../tool/generate/generate.hpp"
#include "../triangulation/space/triangulate.hpp"
#include "../triangulation/triangulate.hpp"

namespace signum::benchmarks {
namespace {

struct Times {
    std::vector<double> seconds;
    [[nodiscard]] double at(double share) {
        std::ranges::sort(seconds);
        return seconds[static_cast<std::size_t>(share * static_cast<double>(seconds.size() - 1))];
    }
};

/// A row of the table; whether both told the same.
template <class Construct>
bool compare(std::string_view name, int threads, int rounds, const Construct& construct) {
    Times one, many;
    bool are_equal = true;
    for (int round = 0; round < rounds; ++round) {
        const auto timed = [&](Times& times, int count) {
            const auto begin = std::chrono::steady_clock::now();
            auto result = construct(count);
            times.seconds.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            return result;
        };
        const auto expected = timed(one, 1);
        are_equal = are_equal && timed(many, threads) == expected;
    }
    fmt::print("| {} | {:.3f} ({:.3f}–{:.3f}) | {:.3f} ({:.3f}–{:.3f}) | {:.2f} |{}\n", name,
               one.at(0.5), one.at(0.0), one.at(1.0), many.at(0.5), many.at(0.0), many.at(1.0),
               one.at(0.5) / many.at(0.5), are_equal ? "" : " the results differ");
    return are_equal;
}

int run(std::int64_t count, int threads, int rounds) {
    fmt::print("| {} sites | one thread, s | {} threads | ratio |\n|:--|--:|--:|--:|\n", count,
               threads);
    bool are_equal = true;
    for (const Distribution distribution : {Distribution::random, Distribution::grid}) {
        const std::vector<Site> sites = generate(
            distribution,
            {.count = count, .radius_to = distribution == Distribution::random ? 0.3 : 0.0});
        for (const Metric metric : all_metrics)
            are_equal &= compare(
                fmt::format("{}, {}", name_of(metric), name_of(distribution)), threads, rounds,
                [&](int n) { return triangulate(sites, metric, {.threads = n}).arrays(); });
    }
    return are_equal ? 0 : 1;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** arguments) {
    const auto number = [&](int place, int otherwise) {
        return place < count ? std::atoi(arguments[place]) : otherwise;
    };
    return signum::benchmarks::run(number(1, 1'000'000), number(2, signum::usable_cores()),
                                   number(3, 7));
}
