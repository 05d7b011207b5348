/// Peak memory of a construction, result included and input not: the resident set of a child
/// process beyond what it had with the input alone. Also tells how long the large ones take.
///
/// usage: memory_benchmark [number of sites]...

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "../tool/generate/generate.hpp"
#include "../triangulation/triangulate.hpp"

namespace signum::benchmarks {
namespace {

/// What a child process tells of its construction.
struct Usage {
    double peak_bytes = 0.0;
    double result_bytes = 0.0;
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0;
    std::int64_t hidden = 0;
    bool complete = false;
};

double peak_resident_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
#if defined(__APPLE__)
    constexpr double unit = 1.0;
#else
    constexpr double unit = 1024.0;
#endif
    return unit * static_cast<double>(usage.ru_maxrss);
}

double result_bytes(const Tessellation& tessellation) {
    return static_cast<double>(
        tessellation.sites().size_bytes() + tessellation.faces().size_bytes() +
        tessellation.neighbours().size_bytes() + tessellation.hidden().size_bytes());
}

Usage construct(Metric metric, std::int64_t n, bool equal_radii) {
    const double radius = equal_radii ? 0.0 : 700.0 / std::sqrt(static_cast<double>(n));
    const std::vector<Site> sites =
        generate(Distribution::random, {.count = n, .radius_to = radius, .seed = 1});
    Usage usage;
    const double before = peak_resident_bytes();
    const std::clock_t start = std::clock();
    const Tessellation tessellation = triangulate(sites, metric);
    usage.cpu_seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    usage.wall_seconds = tessellation.statistics().seconds;
    usage.peak_bytes = peak_resident_bytes() - before;
    usage.result_bytes = result_bytes(tessellation);
    usage.hidden = static_cast<std::int64_t>(tessellation.hidden().size());
    usage.complete =
        static_cast<std::int64_t>(tessellation.faces().size()) == 2 * (n - usage.hidden) - 2;
    return usage;
}

/// construct() in a child, whose peak is its own; not complete where the child failed.
Usage construct_in_child(Metric metric, std::int64_t n, bool equal_radii) {
    int ends[2];
    if (pipe(ends) != 0) return {};
    const pid_t child = fork();
    if (child < 0) return {};
    if (child == 0) {
        bool sent = false;
        try {
            const Usage usage = construct(metric, n, equal_radii);
            sent = write(ends[1], &usage, sizeof usage) == sizeof usage;
        } catch (const std::exception& failure) {
            fmt::print(stderr, "{}\n", failure.what());
        }
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    Usage usage;
    if (read(ends[0], &usage, sizeof usage) != sizeof usage) usage = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return usage;
}

bool print_row(Metric metric, std::int64_t n, bool equal_radii) {
    const Usage usage = construct_in_child(metric, n, equal_radii);
    if (!usage.complete) {
        fmt::print("| {} | {} | {} | did not complete | | | | |\n", name_of(metric), n,
                   equal_radii ? "equal" : "random");
        return false;
    }
    const auto count = static_cast<double>(n);
    fmt::print("| {} | {} | {} | {:.1f} % | {:.1f} | {:.1f} | {:.3f} | {:.3f} | {:.1f} |\n",
               name_of(metric), n, equal_radii ? "equal" : "random",
               100.0 * static_cast<double>(usage.hidden) / count, usage.peak_bytes / count,
               usage.result_bytes / count, usage.cpu_seconds, usage.wall_seconds,
               1e9 * usage.cpu_seconds / (count * std::log2(count)));
    std::fflush(stdout);
    return true;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum;
    std::vector<std::int64_t> counts;
    for (int i = 1; i < argc; ++i) counts.push_back(std::strtoll(argv[i], nullptr, 10));
    const bool chosen = !counts.empty();
    fmt::print(
        "Memory and growth, random sites:\n\n"
        "| metric | sites | radii | hidden | peak, bytes a site | of these the result | CPU s | "
        "wall s | CPU ns / (n log2 n) |\n|:--|--:|:--|--:|--:|--:|--:|--:|--:|\n");
    std::fflush(stdout);
    bool complete = true;
    for (const Metric metric : all_metrics) {
        if (!chosen) counts = {10'000, 100'000, 1'000'000};
        if (!chosen && metric == Metric::power) counts.push_back(10'000'000);
        for (const std::int64_t n : counts)
            for (const bool equal_radii : {true, false})
                complete &= signum::benchmarks::print_row(metric, n, equal_radii);
    }
    fmt::print("\nPeak resident set of a process beyond the input, result included.\n");
    return complete ? 0 : 1;
}
