#pragma once
/// Runs Google Benchmark with all contestants interleaved and hands back the repetitions of each,
/// for tables that put contestants side by side.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

namespace signum::benchmarks {

/// The repetitions of one benchmark: CPU seconds of one iteration.
struct Times {
    double median = 0.0;
    double least = 0.0;
    double greatest = 0.0;
};

/// What was measured, by name of the benchmark.
class Measurements : public benchmark::BenchmarkReporter {
 public:
    bool ReportContext(const Context& /*context*/) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override;

    /// Whether every repetition succeeded, and there was one.
    [[nodiscard]] bool has(const std::string& name) const;
    /// Precondition: has(name).
    [[nodiscard]] Times times(const std::string& name) const;
    /// median (least–greatest) in units of `unit` seconds, or what went wrong.
    [[nodiscard]] std::string cell(const std::string& name, double unit) const;
    /// Median over median, or a dash.
    [[nodiscard]] std::string ratio(const std::string& dividend, const std::string& divisor) const;
    /// Whether the times can be trusted: how many repetitions, and how much longer than the CPU
    /// time the clock on the wall ran.
    [[nodiscard]] std::string footnote() const;

 private:
    std::map<std::string, std::vector<double>> seconds_;
    std::map<std::string, std::string> errors_;
    double wall_seconds_ = 0.0;
    double cpu_seconds_ = 0.0;
};

/// Runs everything registered, repetitions in random order. Arguments of the command line come last
/// and win (--benchmark_repetitions=..., --benchmark_filter=...). Ends the program for an unknown
/// one.
[[nodiscard]] Measurements run_interleaved(int argc, char** argv, int repetitions);

/// One row of a Markdown table, to standard output.
void print_row(const std::vector<std::string>& cells);
/// The header: the first column is aligned left, the others right.
void print_header(const std::vector<std::string>& cells);

}  // namespace signum::benchmarks
