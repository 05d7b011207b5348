/// The pages of the studies from rows that a formula makes: every figure's script and all words, by
/// a hash, which a change of code alone must not move.

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/study/page.hpp"
#include "../../tool/study/plan.hpp"

namespace signum::study {
namespace {

using Names = std::vector<std::string>;

const Names stages = {"filter", "refine", "exact", "essa", "multiprecision"};

Names operator+(Names names, const Names& more) {
    names.insert(names.end(), more.begin(), more.end());
    return names;
}
Names with(const std::string& prefix, const Names& names) {
    Names all;
    for (const std::string& name : names) all.push_back(prefix + name);
    return all;
}

Names contestants_of(const Cell& cell) {
    if (cell.work == Work::stage_cost) return stages;
    if (cell.work == Work::margin) return {"exact"};
    if (cell.work == Work::time_steps) return {"auto"};
    return cell.contestants;
}

Names quantities_of(const Cell& cell) {
    switch (cell.work) {
        case Work::construction:
            return Names{"broken_percent", "wrong_percent", "wrong_or_different_percent",
                         "hidden",         "swaps",         "seconds",
                         "ratio"} +
                   with("calls_", stages);
        case Work::deletion:
            return {"ns_per_site"};
        case Work::stage_cost:
            return Names{"ns_per_call", "in_sphere"} + with("calls_", stages);
        case Work::first_error:
            return {"first_error"};
        case Work::margin:
            return with("margin_", {"ties", "1e-0", "1e-1", "1e-7", "1e-15", "1e-20", "least"});
        case Work::structures:
            return {"strikes",     "digest",  "own",   "checks",
                    "predictions", "seconds", "ratio", "seconds_per_strike"};
        case Work::rounding:
            return {"broken_percent",
                    "strikes",
                    "first_other_strike",
                    "first_other_strike_time",
                    "overlap",
                    "wall_overlap",
                    "lost",
                    "ratio"};
        case Work::time_steps:
            break;
    }
    const Names times = {"0.2", "0.4", "0.6", "0.8", "1", "1.2", "1.4", "1.6", "1.8", "2"};
    return with("strikes_at_", times) + with("energy_at_", times) +
           Names{"all_strikes", "mean_energy"};
}

/// Numbers of no pattern, from 0 to 1.
std::vector<Row> rows_of(const std::vector<Cell>& cells) {
    std::vector<Row> rows;
    std::uint64_t state = 1998;
    for (const Cell& cell : cells) {
        for (const std::string& name : contestants_of(cell))
            for (const std::string& quantity : quantities_of(cell)) {
                state = state * 6364136223846793005U + 1442695040888963407U;
                const double value = static_cast<double>(state >> 44) * 0x1p-20;
                // Of what is counted there is one number.
                const bool is_counted = quantity == "hidden" || quantity.starts_with("margin_");
                const double spread = is_counted ? 1.0 : 2.0;
                rows.push_back(
                    {cell.setting, name, quantity, {value, value / spread, value * spread, 6}});
            }
        if (cell.work == Work::structures)
            rows.push_back({cell.setting, "auto", "chooses_lists", {1, 1, 1, 1}});
    }
    return rows;
}

std::string hash_of(Page page) {
    for (Figure& figure : page.figures)
        if (!figure.plot.panels.empty())
            figure.svg = inline_svg("<svg \n>" + gnuplot_script(figure.plot) + "</svg>",
                                    figure.plot.name, figure.description);
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char c : html_report(page, {"1.2.3", "signum study", {{"cores", "2"}}, 3, 5, 240.0}))
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    return std::to_string(hash);
}

TEST(StudyPages, HaveAPanelOfEveryMetric) {
    const Page page = page_of("plane", rows_of(plan({.quick = true})));
    EXPECT_EQ(page.figures.at(0).plot.panels.size(), all_metrics.size());
}

TEST(StudyPages, AreWhatTheyWere) {
    EXPECT_EQ(hash_of(page_of("plane", rows_of(plan({.quick = true})))), "17280393612217300266");
    EXPECT_EQ(hash_of(page_of("space", rows_of(plan_in_space({.quick = true})))),
              "16832412426086088971");
    EXPECT_EQ(hash_of(page_of("motion", rows_of(plan_motion({.quick = true})))),
              "13330807469960437602");
}

}  // namespace
}  // namespace signum::study
