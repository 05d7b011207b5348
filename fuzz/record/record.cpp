/// The record of predicate calls: blocks of a million calls, each judged by an oracle, and a line
/// for each predicate of a block appended to a file.

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "blocks.hpp"

namespace {

using namespace signum;
using namespace signum::fuzz;

constexpr const char* usage =
    "record run FILE --library COMMIT [--metric NAME]... [--from BLOCK] [--step BLOCKS]\n"
    "           [--blocks N] [--calls N]\n"
    "           asks blocks of calls that FILE has not yet, a million each (--calls), and appends\n"
    "           lines to it; without --blocks for ever. Several processes may share a FILE: each\n"
    "           takes its own blocks, --from 0 --step 2 and --from 1 --step 2. COMMIT, a word,\n"
    "           says in each line which library was asked.\n"
    "record summary FILE...\n"
    "           prints the table of all calls in the files\n"
    "record replay FILE...\n"
    "           asks the configurations of corpus files again; exit 1 where a sign is wrong\n"
    "record metrics\n"
    "           prints the names of the metrics\n";

[[noreturn]] void refuse(const std::string& what) {
    std::cerr << "record: " << what << "\n" << usage;
    std::exit(2);
}

template <class Number>
[[nodiscard]] Number number_of(std::string_view text) {
    Number number{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || end != text.data() + text.size())
        refuse("no whole number: " + std::string(text));
    return number;
}

/// The blocks of each metric that a file has already. A block's lines are written at once, and a
/// last one that was cut off does not count.
[[nodiscard]] std::map<std::string, std::map<std::uint64_t, bool>> blocks_in(
    const std::string& file) {
    std::map<std::string, std::map<std::uint64_t, bool>> blocks;
    std::ifstream text(file);
    for (const Line& line : lines_of(text)) blocks[line.metric][line.block] = true;
    return blocks;
}

int run(std::span<const std::string> arguments) {
    if (arguments.empty()) refuse("run needs a FILE");
    const std::string& file = arguments[0];
    std::vector<const Metric*> chosen;
    std::uint64_t from = 0;
    std::uint64_t step = 1;
    std::uint64_t most = ~std::uint64_t{0};
    std::uint64_t calls = 1'000'000;
    std::string library;
    for (std::size_t n = 1; n < arguments.size(); n += 2) {
        if (n + 1 == arguments.size()) refuse("no value after " + arguments[n]);
        const std::string& value = arguments[n + 1];
        if (arguments[n] == "--metric") {
            const Metric* const metric = metric_of(value);
            if (metric == nullptr) refuse("no metric " + value);
            chosen.push_back(metric);
        } else if (arguments[n] == "--from") {
            from = number_of<std::uint64_t>(value);
        } else if (arguments[n] == "--step") {
            step = number_of<std::uint64_t>(value);
        } else if (arguments[n] == "--blocks") {
            most = number_of<std::uint64_t>(value);
        } else if (arguments[n] == "--library") {
            if (value.empty() || value.find_first_of(" \t\n") != std::string::npos)
                refuse("no word: '" + value + "'");
            library = value;
        } else if (arguments[n] == "--calls") {
            calls = number_of<std::uint64_t>(value);
        } else {
            refuse("no option " + arguments[n]);
        }
    }
    if (library.empty()) refuse("run needs --library, the commit that is asked");
    if (chosen.empty())
        for (const Metric& metric : all_metrics()) chosen.push_back(&metric);
    auto blocks = blocks_in(file);
    int status = 0;
    for (std::uint64_t n = 0; n < most; ++n) {
        const std::uint64_t block = from + n * step;
        for (const Metric* metric : chosen) {
            if (blocks[std::string(metric->name)].contains(block)) continue;
            const Block result =
                run_block(*metric, block, calls, std::cerr, file + ".wrong", library);
            if (result.wrong != 0) status = 1;
            // One write: lines of several processes do not mix.
            std::FILE* const out = std::fopen(file.c_str(), "a");
            if (out == nullptr ||
                std::fwrite(result.lines.data(), 1, result.lines.size(), out) !=
                    result.lines.size() ||
                std::fclose(out) != 0)
                throw std::runtime_error("cannot write to " + file);
        }
    }
    return status;
}

int replay(std::span<const std::string> files) {
    int status = 0;
    for (const std::string& file : files) {
        std::ifstream text(file);
        if (!text) refuse("cannot read " + file);
        status |= replay_calls(text, std::cerr) == 0 ? 0 : 1;
    }
    return status;
}

}  // namespace

int main(int count, char** values) {
    const std::vector<std::string> arguments(values + 1, values + count);
    if (arguments.empty()) refuse("no command");
    const std::span<const std::string> rest = std::span(arguments).subspan(1);
    try {
        if (arguments[0] == "run") return run(rest);
        if (arguments[0] == "replay") return replay(rest);
        if (arguments[0] == "summary") {
            std::vector<Line> all;
            for (const std::string& file : rest) {
                std::ifstream text(file);
                if (!text) refuse("cannot read " + file);
                for (Line& line : lines_of(text)) all.push_back(std::move(line));
            }
            print_summary(all, std::cout);
            return 0;
        }
        if (arguments[0] == "metrics") {
            for (const Metric& metric : all_metrics()) std::cout << metric.name << "\n";
            return 0;
        }
    } catch (const std::exception& error) {
        std::cerr << "record: " << error.what() << "\n";
        return 3;
    }
    refuse("no command " + arguments[0]);
}
