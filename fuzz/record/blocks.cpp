#include "blocks.hpp"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <istream>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace signum::fuzz {
namespace {

/// Of the name (FNV) and the number, mixed (SplitMix): seeds that have nothing in common.
[[nodiscard]] std::uint64_t seed_of(const Metric& metric, std::uint64_t block) {
    std::uint64_t seed = 0xcbf29ce484222325U;
    for (const char letter : metric.name)
        seed = (seed ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
    seed += (block + 1) * 0x9e3779b97f4a7c15U;
    seed = (seed ^ seed >> 30) * 0xbf58476d1ce4e5b9U;
    seed = (seed ^ seed >> 27) * 0x94d049bb133111ebU;
    return seed ^ seed >> 31;
}

void ask(const Metric& metric, const Configuration<2>& given, Ledger& ledger) {
    metric.ask_plane(given, ledger);
}
void ask(const Metric& metric, const Configuration<3>& given, Ledger& ledger) {
    metric.ask_space(given, ledger);
}

/// METRIC KIND and the numbers of all balls in hexadecimal.
template <std::size_t d>
[[nodiscard]] std::string text_of(const Metric& metric, const Configuration<d>& given) {
    std::string text = std::string(metric.name) + " " + std::string(name_of(given.kind));
    const auto add = [&](double number) {
        char digits[40];
        std::snprintf(digits, sizeof digits, " %a", number);
        text += digits;
    };
    for (const Ball<d>& ball : given.balls) {
        for (const double x : ball.centre) add(x);
        add(ball.size);
    }
    return text;
}

template <std::size_t d>
[[nodiscard]] bool complain(const Metric& metric, const Configuration<d>& given, Ledger& ledger,
                            std::ostream& complaints) {
    Ledger::Wrong wrong;
    if (!ledger.take_wrong(wrong)) return false;
    complaints << "wrong: " << name_of(wrong.predicate, d) << " is " << wrong.right << ", not "
               << wrong.said << ": " << text_of(metric, given) << "\n";
    return true;
}

template <std::size_t d>
void ask_block(const Metric& metric, std::uint64_t seed, std::uint64_t calls, Ledger& ledger,
               std::ostream& complaints, const std::string& corpus) {
    Mix<d> mix(seed, metric.shares);
    hard::Moves<d> moves(seed);
    Configuration<d> given;
    for (std::size_t turn = 0; ledger.calls() < calls; ++turn) {
        bool is_made = false;
        if constexpr (d == 3) {
            is_made = metric.make_space != nullptr;
            if (is_made) metric.make_space(moves, given);
        }
        if (!is_made) mix.make(metric.kinds[turn % metric.kinds.size()], given);
        ask(metric, given, ledger);
        if (complain(metric, given, ledger, complaints)) {
            std::ofstream file(corpus, std::ios::app);
            file << text_of(metric, given) << "\n";
        }
    }
}

template <std::size_t d>
[[nodiscard]] bool replay_one(const Metric& metric, Kind kind, std::istream& numbers,
                              std::ostream& complaints) {
    Configuration<d> given;
    given.kind = kind;
    // Streams do not read what they write in hexadecimal.
    const auto read = [&](double& number) {
        std::string text;
        char* end = nullptr;
        if (numbers >> text) number = std::strtod(text.c_str(), &end);
        if (end == nullptr || end == text.c_str() || *end != '\0')
            throw std::runtime_error("a corpus line lacks a number");
    };
    for (Ball<d>& ball : given.balls) {
        for (double& x : ball.centre) read(x);
        read(ball.size);
    }
    Ledger ledger;
    ask(metric, given, ledger);
    return complain(metric, given, ledger, complaints);
}

std::vector<Metric> made_metrics() {
    constexpr Shares cheap = {32, 32, 64};
    constexpr Shares dear = {256, 32, 128, 20};
    constexpr Shares dearer = {1024, 32, 256, 8};
    constexpr Shares extreme = {1, 1, 1, 0, true};
    const std::vector<Kind> power = {Kind::points, Kind::weights, Kind::radii};
    const std::vector<Stage> of_power = {Stage::filter, Stage::refine, Stage::exact,
                                         Stage::multiprecision};
    const std::vector<Stage> of_euclidean = {Stage::filter, Stage::exact, Stage::multiprecision};
    const std::vector<Stage> of_sums = {Stage::filter, Stage::exact, Stage::essa};
    std::vector<Metric> all = {
        {"power", 2, power, of_power, cheap, ask_power, nullptr},
        {"euclidean", 2, {Kind::euclidean}, of_euclidean, dear, ask_euclidean, nullptr},
        {"supremum", 2, {Kind::supremum}, of_sums, cheap, ask_supremum, nullptr},
        {"manhattan", 2, {Kind::manhattan}, of_sums, cheap, ask_manhattan, nullptr},
        {"space-euclidean", 3, {Kind::euclidean}, of_euclidean, dearer, nullptr, ask_euclidean},
        {"space-supremum", 3, {Kind::supremum}, of_sums, cheap, nullptr, ask_supremum},
        {"space-manhattan", 3, {Kind::manhattan}, of_sums, cheap, nullptr, ask_manhattan},
        {"space-power", 3, power, of_power, cheap, nullptr, ask_power},
        {"space-meeting",
         3,
         {Kind::euclidean},
         {Stage::exact},
         cheap,
         nullptr,
         ask_meeting,
         make_meeting},
    };
    // Each of them but meetings again, of extremes.
    for (std::size_t m = 0, metrics = all.size(); m < metrics; ++m) {
        if (all[m].make_space != nullptr) continue;
        Metric again = all[m];
        again.name += "-extremes";
        again.shares = extreme;
        all.push_back(std::move(again));
    }
    return all;
}

}  // namespace

const std::vector<Metric>& all_metrics() {
    static const std::vector<Metric> all = made_metrics();
    return all;
}

const Metric* metric_of(std::string_view name) {
    for (const Metric& metric : all_metrics())
        if (metric.name == name) return &metric;
    return nullptr;
}

std::vector<Line> lines_of(std::istream& text) {
    std::vector<Line> lines;
    std::string one;
    while (std::getline(text, one)) {
        if (one.empty() || one[0] == '#') continue;
        std::istringstream words(one);
        Line line;
        std::string end;
        words >> line.metric >> line.predicate >> line.block >> line.seed >> line.count.calls;
        for (std::uint64_t& stage : line.count.stages) words >> stage;
        words >> line.count.ties >> line.count.wrong >> line.seconds >> line.library >> end;
        if (words && end == ".") lines.push_back(std::move(line));
    }
    return lines;
}

Block run_block(const Metric& metric, std::uint64_t block, std::uint64_t calls,
                std::ostream& complaints, const std::string& corpus, const std::string& library) {
    Block result;
    const std::uint64_t seed = seed_of(metric, block);
    const std::clock_t start = std::clock();
    if (metric.dimension == 2)
        ask_block<2>(metric, seed, calls, result.ledger, complaints, corpus);
    else
        ask_block<3>(metric, seed, calls, result.ledger, complaints, corpus);
    double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::ostringstream text;
    for (std::size_t p = 0; p < predicate_count; ++p) {
        const Count& count = result.ledger.counts()[p];
        if (count.calls == 0) continue;
        text << metric.name << " " << name_of(static_cast<Predicate>(p), metric.dimension) << " "
             << block << " " << seed << " " << count.calls;
        for (const std::uint64_t stage : count.stages) text << " " << stage;
        text << " " << count.ties << " " << count.wrong << " " << seconds << " " << library
             << " .\n";
        seconds = 0.0;
        result.wrong += count.wrong;
    }
    result.lines = text.str();
    return result;
}

std::uint64_t replay_calls(std::istream& corpus, std::ostream& complaints) {
    std::uint64_t wrong = 0;
    std::string one;
    while (std::getline(corpus, one)) {
        if (one.empty() || one[0] == '#') continue;
        std::istringstream words(one);
        std::string name;
        std::string kind_name;
        words >> name >> kind_name;
        const Metric* const metric = metric_of(name);
        const auto kind = std::ranges::find_if(
            hard::all_kinds, [&](Kind each) { return name_of(each) == kind_name; });
        if (metric == nullptr || kind == hard::all_kinds.end())
            throw std::runtime_error("no metric or kind of sites: " + name + " " + kind_name);
        const bool is_wrong = metric->dimension == 2
                                  ? replay_one<2>(*metric, *kind, words, complaints)
                                  : replay_one<3>(*metric, *kind, words, complaints);
        wrong += static_cast<std::uint64_t>(is_wrong);
    }
    return wrong;
}

void print_summary(std::span<const Line> lines, std::ostream& out) {
    struct Sum {
        Count count;
        double seconds = 0.0;
        std::map<std::uint64_t, bool> blocks;
        void add(const Line& line) {
            count.calls += line.count.calls;
            for (std::size_t s = 0; s < stage_count; ++s) count.stages[s] += line.count.stages[s];
            count.ties += line.count.ties;
            count.wrong += line.count.wrong;
            seconds += line.seconds;
            blocks[line.block] = true;
        }
    };
    std::map<std::string, Sum> libraries;
    std::map<std::string, Sum> metrics;
    std::map<std::pair<std::string, std::string>, Sum> predicates;
    Sum all;
    // A block that two processes have asked counts once.
    std::set<std::tuple<std::string, std::string, std::uint64_t>> known;
    for (const Line& line : lines) {
        if (!known.emplace(line.metric, line.predicate, line.block).second) continue;
        libraries[line.library].add(line);
        metrics[line.metric].add(line);
        predicates[{line.metric, line.predicate}].add(line);
        all.add(line);
    }
    const auto numbers = [&](const Sum& sum) {
        out << sum.count.calls;
        for (const std::uint64_t stage : sum.count.stages) out << " | " << stage;
        out << " | " << sum.count.ties << " | " << sum.count.wrong << " |";
    };
    const auto head = [&](std::string_view first, bool times) {
        out << "| " << first << " | calls";
        for (int s = 0; s < stage_count; ++s) out << " | " << name_of(static_cast<Stage>(s));
        out << " | ties | wrong |" << (times ? " blocks | seconds |" : "") << "\n| ---";
        for (int s = 0; s < stage_count + 3 + (times ? 2 : 0); ++s) out << " | ---:";
        out << " |\n";
    };
    const auto times = [&](const Sum& sum, std::size_t blocks) {
        char seconds[40];
        std::snprintf(seconds, sizeof seconds, " %zu | %.0f |", blocks, sum.seconds);
        out << seconds << "\n";
    };
    out << "| library as of | calls | wrong | seconds |\n| --- | ---: | ---: | ---: |\n";
    for (const auto& [library, sum] : libraries)
        out << "| " << library << " | " << sum.count.calls << " | " << sum.count.wrong << " | "
            << static_cast<std::uint64_t>(sum.seconds) << " |\n";
    out << "\n";
    head("metric", true);
    std::size_t blocks = 0;
    for (const Metric& metric : all_metrics()) {
        const auto found = metrics.find(std::string(metric.name));
        if (found == metrics.end()) continue;
        out << "| " << metric.name << " | ";
        numbers(found->second);
        times(found->second, found->second.blocks.size());
        blocks += found->second.blocks.size();
    }
    out << "| all | ";
    numbers(all);
    times(all, blocks);
    out << "\n";
    head("predicate", false);
    for (const Metric& metric : all_metrics())
        for (std::size_t p = 0; p < predicate_count; ++p) {
            const std::string name(name_of(static_cast<Predicate>(p), metric.dimension));
            const auto found = predicates.find({std::string(metric.name), name});
            if (found == predicates.end()) continue;
            out << "| " << metric.name << " " << name << " | ";
            numbers(found->second);
            out << "\n";
        }
}

}  // namespace signum::fuzz
