#pragma once
/// Blocks of calls: each begins anew from its number, so that they may be asked in any order, by
/// any number of processes, and again.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ledger.hpp"
#include "mix.hpp"

namespace signum::fuzz {

/// A metric of the plane or of space: one of the two functions is there.
struct Metric {
    std::string name;
    std::size_t dimension;
    std::vector<Kind> kinds;
    std::vector<Stage> stages;  ///< those that it has
    Shares shares;
    void (*ask_plane)(const Configuration<2>&, Ledger&) = nullptr;
    void (*ask_space)(const Configuration<3>&, Ledger&) = nullptr;
    /// Makes the configurations, in the place of Mix; of space alone.
    void (*make_space)(hard::Moves<3>&, Configuration<3>&) = nullptr;
};

[[nodiscard]] const std::vector<Metric>& all_metrics();
/// Null where there is none of that name.
[[nodiscard]] const Metric* metric_of(std::string_view name);

/// A line of a record: one predicate in one block.
struct Line {
    std::string metric;
    std::string predicate;
    std::uint64_t block = 0;
    std::uint64_t seed = 0;
    Count count;
    double seconds = 0.0;  ///< of the processor, for the whole block: in its first line, else 0
    std::string library;   ///< the commit that was asked
};
/// Incomplete lines are left out.
[[nodiscard]] std::vector<Line> lines_of(std::istream& text);

struct Block {
    std::string lines;
    std::uint64_t wrong = 0;
    Ledger ledger;
};
/// Wrong calls go to `complaints`, and their configurations are appended to the file `corpus`.
/// `library` is the commit that is asked, a word; each line ends with it.
[[nodiscard]] Block run_block(const Metric& metric, std::uint64_t block, std::uint64_t calls,
                              std::ostream& complaints, const std::string& corpus,
                              const std::string& library);

/// How many of the calls of a corpus file are wrong. Throws std::runtime_error where it is none.
[[nodiscard]] std::uint64_t replay_calls(std::istream& corpus, std::ostream& complaints);

/// The tables. Lines of one block count once, however often they are there.
void print_summary(std::span<const Line> lines, std::ostream& out);

}  // namespace signum::fuzz
