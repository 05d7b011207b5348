#include "interleaved.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <fmt/format.h>

#include "../core/index.hpp"
#include "../triangulation/options.hpp"

namespace signum::benchmarks {

void Measurements::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) continue;
        const std::string& name = run.run_name.function_name;
        if (run.error_occurred) {
            errors_[name] = run.error_message;
            continue;
        }
        wall_seconds_ += run.real_accumulated_time;
        cpu_seconds_ += run.cpu_accumulated_time;
        seconds_[name].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
}

bool Measurements::has(const std::string& name) const {
    return seconds_.contains(name) && !errors_.contains(name);
}

Times Measurements::times(const std::string& name) const {
    std::vector<double> sorted = seconds_.at(name);
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    const double median =
        sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2.0;
    return {median, sorted.front(), sorted.back()};
}

std::string Measurements::cell(const std::string& name, double unit) const {
    if (const auto error = errors_.find(name); error != errors_.end()) return error->second;
    if (!has(name)) return "–";
    const Times t = times(name);
    // Three digits, whatever the magnitude.
    const double median = t.median / unit;
    const int decimals = median >= 99.95 ? 0 : median >= 9.995 ? 1 : 2;
    return fmt::format("{:.{}f} ({:.{}f}–{:.{}f})", median, decimals, t.least / unit, decimals,
                       t.greatest / unit, decimals);
}

std::string Measurements::ratio(const std::string& dividend, const std::string& divisor) const {
    if (!has(dividend) || !has(divisor)) return "–";
    return fmt::format("{:.2f}", times(dividend).median / times(divisor).median);
}

std::string Measurements::footnote() const {
    std::size_t repetitions = 0;
    for (const auto& [name, seconds] : seconds_)
        repetitions = std::max(repetitions, seconds.size());
    const double waiting = std::max(0.0, wall_seconds_ / cpu_seconds_ - 1.0);
    return fmt::format(
        "CPU time: median of {} interleaved repetitions (least–greatest); {:.1f} % of it was spent "
        "waiting for the processor.",
        repetitions, 100.0 * waiting);
}

bool Visible::agree(const std::string& kind, const std::string& exact,
                    const std::string& cgal) const {
    const auto ours = find(exact);
    const auto theirs = find(cgal);
    if (ours == end() || theirs == end() || ours->second == theirs->second) return true;
    fmt::print(stderr, "{}: CGAL finds another number of visible sites\n", kind);
    return false;
}

void add(const std::string& name, Construction construct, Visible& visible) {
    if (!construct) return;
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 128 * 1024);  // once set, it no longer grows with what is freed
#endif
    benchmark::RegisterBenchmark(
        name.c_str(),
        [name, construct = std::move(construct), &visible](benchmark::State& state) {
#if defined(__GLIBC__)
            malloc_trim(0);
#endif
            Built built;
            try {
                for (auto _ : state) built = construct();
                visible[name] = built.visible;
            } catch (const BrokenStructure&) {
                state.SkipWithError("breaks");
            }
        })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

std::string take(std::string_view option, int& argc, char** argv) {
    std::string value;
    const auto is_ours = [&](const char* argument) {
        if (!std::string_view(argument).starts_with(option)) return false;
        value = argument;
        return true;
    };
    argc = static_cast<int>(std::remove_if(argv + 1, argv + argc, is_ours) - argv);
    return value;
}
std::int64_t take_sites(int& argc, char** argv, std::int64_t otherwise) {
    constexpr std::string_view option = "--sites=";
    const std::string sites = take(option, argc, argv);
    const std::int64_t n =
        sites.empty() ? otherwise : std::strtoll(sites.c_str() + option.size(), nullptr, 10);
    if (n > 0 && n <= max_sites) return n;
    fmt::print(stderr, "--sites needs a positive number\n");
    std::exit(2);
}

Measurements run_interleaved(int argc, char** argv, int repetitions) {
    std::vector<std::string> defaults = {
        "--benchmark_enable_random_interleaving=true",
        "--benchmark_min_time=0.05",
        fmt::format("--benchmark_repetitions={}", repetitions),
    };
    std::vector<char*> arguments = {argv[0]};
    for (std::string& argument : defaults) arguments.push_back(argument.data());
    arguments.insert(arguments.end(), argv + 1, argv + argc);
    auto count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) std::exit(EXIT_FAILURE);
    Measurements measurements;
    benchmark::RunSpecifiedBenchmarks(&measurements);
    return measurements;
}

void print_row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& cell : cells) line += fmt::format(" {} |", cell);
    fmt::print("{}\n", line);
}

void print_header(const std::vector<std::string>& cells) {
    print_row(cells);
    std::string line = "|:--|";
    for (std::size_t i = 1; i < cells.size(); ++i) line += "--:|";
    fmt::print("{}\n", line);
}

}  // namespace signum::benchmarks
