#pragma once
/// Runs Google Benchmark with all contestants interleaved and hands back the repetitions of each,
/// for tables that put contestants side by side.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <benchmark/benchmark.h>

#include "construction.hpp"

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

/// Numbers of visible sites, by name of the benchmark.
class Visible : public std::map<std::string, std::int64_t> {
 public:
    /// Whether both found as many, or one of them has not run; says so where they differ.
    [[nodiscard]] bool agree(const std::string& kind, const std::string& exact,
                             const std::string& cgal) const;
};

/// Registers a construction, if there is one: one each time, in milliseconds. It begins as in a new
/// process: no memory is left over from the one before. (What it takes from the system it pays for,
/// by page faults.)
void add(const std::string& name, Construction construct, Visible& visible);

/// Takes an option of ours, --NAME=VALUE, out of the arguments; empty where it is not there.
[[nodiscard]] std::string take(std::string_view option, int& argc, char** argv);
/// The number of --sites=N, taken out of them. Ends the program where it is none.
[[nodiscard]] std::int64_t take_sites(int& argc, char** argv, std::int64_t otherwise);

/// Runs everything registered, repetitions in random order. Arguments of the command line come last
/// and win (--benchmark_repetitions=..., --benchmark_filter=...). Ends the program for an unknown
/// one.
[[nodiscard]] Measurements run_interleaved(int argc, char** argv, int repetitions);

/// One row of a Markdown table, to standard output.
void print_row(const std::vector<std::string>& cells);
/// The header: the first column is aligned left, the others right.
void print_header(const std::vector<std::string>& cells);

}  // namespace signum::benchmarks
