/// The parts of a study that can be told without a clock: its table, its plan, its plots.

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/study/measure.hpp"
#include "../../tool/study/page.hpp"
#include "../../tool/study/plan.hpp"
#include "../../tool/study/plot.hpp"
#include "../../tool/study/rows.hpp"

namespace signum::study {
namespace {

Row row(const std::string& quantity, double value) {
    return {{"sites", "power", "circle", 100, 1e-9, 1.0, 10.0},
            "exact",
            quantity,
            {value, 0.1 * value, 3.0 * value, 7}};
}

TEST(StudyRows, ReadBackAsTheyWere) {
    const std::string text = csv_header() + csv_line(row("seconds", 0.1)) +
                             csv_line(row(std::string(end_of_cell), 1.0 / 3.0));
    const auto table = read_csv(text);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.bytes, text.size());
    EXPECT_EQ(table.rows[0].setting, row("seconds", 0.1).setting);
    EXPECT_EQ(table.rows[0].value.high, 3.0 * 0.1);
    EXPECT_EQ(table.rows[1].value.median, 1.0 / 3.0);
    EXPECT_EQ(table.rows[1].value.runs, 7U);
    EXPECT_EQ(csv_line(table.rows[1]), csv_line(row(std::string(end_of_cell), 1.0 / 3.0)));
}

TEST(StudyRows, LeaveOutWhatIsNoCompleteCell) {
    const std::string whole =
        csv_header() + csv_line(row("seconds", 0.1)) + csv_line(row(std::string(end_of_cell), 1.0));
    const std::string text = whole + csv_line(row("ratio", 2.0)) + csv_line(row("edges", 3.0));
    // Wherever the writer was cut off, what is read is what was complete.
    for (std::size_t size = 0; size <= text.size(); ++size) {
        const auto table = read_csv(text.substr(0, size));
        const bool has_cell = size >= whole.size();
        EXPECT_EQ(table.rows.size(), has_cell ? 2U : 0U);
        EXPECT_EQ(table.bytes, has_cell                      ? whole.size()
                               : size >= csv_header().size() ? csv_header().size()
                                                             : 0U);
    }
}

TEST(StudyRows, PassesAreCombined) {
    std::vector<Row> passes;
    for (const double seconds : {3.0, 1.0, 2.0, 6.0, 5.0, 4.0}) {
        if (passes.empty()) passes.push_back(row("edges", 10.0));
        passes.push_back(row("seconds", seconds));
        passes.push_back(row(std::string(end_of_cell), seconds));
    }
    const std::vector<Row> rows = combined(passes);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(csv_line(rows[0]), csv_line(row("edges", 10.0)));  // counted once
    EXPECT_EQ(rows[1].quantity, "seconds");
    EXPECT_EQ(rows[1].value.median, 3.5);
    EXPECT_EQ(rows[1].value.low, 1.0);
    EXPECT_EQ(rows[1].value.high, 6.0);
    EXPECT_EQ(rows[1].value.runs, 6U);
    EXPECT_EQ(rows[2].value.median, 21.0);
}

TEST(StudyRows, RefuseWhatIsNone) {
    EXPECT_THROW(static_cast<void>(read_csv("x,y\n1,2\n")), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(read_csv(csv_header() + "1,2,3\n")), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(read_csv(csv_header() + csv_line(row("a,b", 1.0)))),
                 std::invalid_argument);
}

/// Every cell once: a resumed study knows a cell by its setting.
template <class Cells>
void expect_distinct(const Cells& cells) {
    std::set<Setting> seen;
    for (const auto& cell : cells)
        EXPECT_TRUE(seen.insert(cell.setting).second) << csv_line({cell.setting, "", "", {}});
}

TEST(StudyPlan, HasEveryExperimentInBothForms) {
    for (const bool quick : {false, true}) {
        Scope scope;
        scope.quick = quick;
        const std::vector<Cell> cells = plan(scope);
        expect_distinct(cells);
        std::set<std::string> experiments;
        for (const Cell& cell : cells) experiments.insert(cell.setting.experiment);
        EXPECT_EQ(experiments,
                  (std::set<std::string>{"margin", "first_error", "perturbation", "radii",
                                         "kernels", "stages", "stage_cost", "flips", "flips_scaled",
                                         "sweep", "deletion", "hard", "sites"}));
    }
}

TEST(StudyPlan, KeepsToItsScope) {
    Scope scope;
    scope.metrics = {Metric::supremum};
    scope.least_sites = 200;
    scope.most_sites = 1000;
    const std::vector<Cell> cells = plan(scope);
    EXPECT_FALSE(cells.empty());
    for (const Cell& cell : cells) {
        EXPECT_EQ(cell.setting.metric, "supremum");
        EXPECT_GE(cell.setting.count, 200);
        EXPECT_LE(cell.setting.count, 1000);
    }
}

TEST(StudyPlan, OfSpaceHasEveryExperimentInBothForms) {
    for (const bool quick : {false, true}) {
        Scope scope;
        scope.quick = quick;
        const std::vector<Cell> cells = plan_in_space(scope);
        expect_distinct(cells);
        std::set<std::string> experiments;
        for (const Cell& cell : cells) {
            experiments.insert(cell.setting.experiment);
            EXPECT_EQ(cell.dimension, 3);
            EXPECT_EQ(cell.setting.metric, "power");
        }
        EXPECT_EQ(experiments, (std::set<std::string>{"first_error", "perturbation", "radii",
                                                      "stage_cost", "sites"}));
    }
}

/// The first row of a contestant and a quantity; fails where there is none.
double value_of(const std::vector<Row>& rows, const std::string& contestant,
                const std::string& quantity) {
    for (const Row& each : rows)
        if (each.contestant == contestant && each.quantity == quantity) return each.value.median;
    ADD_FAILURE() << contestant << " has no " << quantity;
    return 0.0;
}

TEST(StudyMeasure, CountsWhatSingleGetsWrong) {
    Cell cell;
    cell.setting = {"sites", "power", "circle", 200, 0.0, 1.0, 1.0};
    cell.contestants = {"naive", "exact", "single"};
    cell.sets = 2;
    cell.budget = {1, 1, 0.0};
    const std::vector<Row> rows = measure(cell);
    EXPECT_EQ(value_of(rows, "exact", "wrong_percent"), 0.0);
    EXPECT_EQ(value_of(rows, "exact", "different_percent"), 0.0);
    EXPECT_GT(value_of(rows, "single", "wrong_percent"), value_of(rows, "naive", "wrong_percent"));
    EXPECT_EQ(value_of(rows, "naive", "ratio"), 1.0);
    EXPECT_GT(value_of(rows, "exact", "seconds"), 0.0);
    EXPECT_EQ(rows.back().quantity, end_of_cell);
}

TEST(StudyMeasure, LaterPassesTakeTimesAlone) {
    Cell cell;
    cell.setting = {"sites", "manhattan", "grid", 100, 0.0, 1.0, 1.0};
    cell.contestants = {"naive", "exact"};
    cell.budget = {1, 1, 0.0};
    for (const bool breaks : {false, true}) {
        const std::vector<Row> rows = measure(cell, {2, breaks});
        ASSERT_EQ(rows.size(), 5U);
        EXPECT_EQ(rows[0].quantity, "seconds");
        EXPECT_EQ(rows[3].quantity, "ratio");
    }
}

TEST(StudyMeasure, EveryKindOfWork) {
    for (const Work work : {Work::deletion, Work::stage_cost, Work::first_error, Work::margin}) {
        Cell cell;
        cell.setting = {"x", "supremum", "grid", 100, 0.0, 1.0, 1.0};
        cell.work = work;
        cell.contestants = work == Work::deletion
                               ? std::vector<std::string>{"build", "insert", "erase"}
                               : std::vector<std::string>{"naive", "single"};
        cell.budget = {1, 1, 0.0};
        EXPECT_GE(measure(cell).size(), 2U) << static_cast<int>(work);
    }
}

/// Whether the contestant has the quantity.
bool has(const std::vector<Row>& rows, const std::string& contestant, const std::string& quantity) {
    for (const Row& each : rows)
        if (each.contestant == contestant && each.quantity == quantity) return true;
    return false;
}

Cell cell_in_space(const std::string& distribution, std::int64_t sites) {
    Cell cell;
    cell.setting = {"sites", "power", distribution, sites, 0.0, 1.0, 1.0};
    cell.dimension = 3;
    cell.contestants = {"naive", "exact"};
    cell.budget = {1, 1, 0.0};
    return cell;
}

TEST(StudyMeasure, CountsCellsInSpace) {
    Cell cell = cell_in_space("sphere", 300);
    cell.setting.perturbation = 1e-9;
    cell.sets = 20;
    const std::vector<Row> rows = measure(cell);
    EXPECT_GT(value_of(rows, "naive", "wrong_percent"), 0.0);
    EXPECT_EQ(value_of(rows, "exact", "wrong_percent"), 0.0);
    EXPECT_EQ(value_of(rows, "exact", "different_percent"), 0.0);
    EXPECT_GT(value_of(rows, "exact", "cells"), 800.0);
    EXPECT_EQ(value_of(rows, "naive", "ratio"), 1.0);
    EXPECT_GT(value_of(rows, "exact", "ratio"), 0.0);
    EXPECT_FALSE(has(rows, "exact", "edges"));
    EXPECT_FALSE(has(rows, "exact", "calls_filter"));  // a construction counts none
    EXPECT_EQ(rows.back().quantity, end_of_cell);
}

TEST(StudyMeasure, TimesTheOthersWhereTheFirstBuildsNothing) {
    const Cell cell = cell_in_space("sphere", 1000);
    const std::vector<Row> rows = measure(cell);
    EXPECT_EQ(value_of(rows, "naive", "broken_percent"), 100.0);
    EXPECT_GT(value_of(rows, "exact", "seconds"), 0.0);
    EXPECT_FALSE(has(rows, "naive", "seconds"));
    EXPECT_FALSE(has(rows, "exact", "ratio"));
    const std::vector<Row> later = measure(cell, {2, true});
    ASSERT_EQ(later.size(), 2U);
    EXPECT_EQ(later[0].quantity, "seconds");
    EXPECT_EQ(later[0].contestant, "exact");
}

TEST(StudyMeasure, TellsWhoDecidesInSpace) {
    Cell cell = cell_in_space("grid", 64);
    cell.work = Work::stage_cost;
    const std::vector<Row> rows = measure(cell);
    const double all = value_of(rows, "exact", "in_sphere");
    EXPECT_GT(all, 100.0);
    double decided = 0.0;
    for (const char* stage : {"filter", "refine", "exact", "essa", "multiprecision"})
        decided += value_of(rows, "exact", std::string("calls_") + stage);
    EXPECT_EQ(decided, all);
    EXPECT_GT(value_of(rows, "exact", "ties"), 0.0);
    EXPECT_GT(value_of(rows, "filter", "ns_per_call"), 0.0);
    EXPECT_GT(value_of(rows, "multiprecision", "ns_per_call_forced"), 0.0);
    EXPECT_FALSE(has(measure(cell, {2, true}), "exact", "in_sphere"));
}

TEST(StudyMeasure, FindsTheFirstErrorInSpace) {
    Cell cell = cell_in_space("sphere", 100);
    cell.work = Work::first_error;
    const double sphere = value_of(measure(cell), "naive", "first_error");
    EXPECT_GT(sphere, 0.0);
    EXPECT_LT(sphere, 1e-3);
}

TEST(StudyPlot, ScriptHasItsDataAndEscapesItsWords) {
    Panel panel;
    panel.title = "a \"word\"";
    panel.y_is_log = true;
    panel.series = {{"first", 1, true, {{1, 2, 1.5, 2.5}, {2, 0, 0, 0}}}, {"second", 2, true, {}}};
    const std::string script = gnuplot_script({"name", 1, {panel}});
    EXPECT_NE(script.find("a \\\"word\\\""), std::string::npos);
    EXPECT_NE(script.find("\n1 2 1.5 2.5\n\nEND\n"),
              std::string::npos);  // a gap: no 0 on this axis
    EXPECT_NE(script.find("title \"second\""), std::string::npos);
}

TEST(StudyReport, TakesTheColoursOfThePage) {
    const std::string svg = inline_svg(
        "<?xml?>\n<svg \n viewBox=\"0 0 1 1\">\n<title>t</title>\n<desc>d</desc>\n<g "
        "color=\"black\" "
        "stroke=\"currentColor\"><use xlink:href='#gpPt1' color='white'/><path "
        "stroke='black'/></g></svg>",
        "name", "what <it> shows");
    EXPECT_TRUE(svg.starts_with("<svg"));
    EXPECT_EQ(svg.find("black"), std::string::npos);
    EXPECT_EQ(svg.find("'white'"), std::string::npos);
    EXPECT_NE(svg.find("#name_gpPt1"), std::string::npos);
    EXPECT_NE(svg.find("what &lt;it> shows"), std::string::npos);
}

TEST(StudyReport, SaysWhatItIsAndWhatIsMissing) {
    Account account;
    account.version = "1.2.3";
    account.command = "signum study --quick";
    account.machine = {{"processor", "A & B"}};
    account.measured = 3;
    account.planned = 5;
    const std::string page = html_report(page_of("plane", {}), account);
    EXPECT_NE(page.find("3 of 5"), std::string::npos);
    EXPECT_NE(page.find("A &amp; B"), std::string::npos);
    EXPECT_NE(page.find("<h1>What accuracy costs</h1>"), std::string::npos);
    EXPECT_NE(page.find("signum study --quick"), std::string::npos);
}

TEST(StudyReport, ExplainsTheSameWordsOfThePlaneAndOfSpace) {
    const std::string plane = page_of("plane", {}).glossary;
    const std::string space = page_of("space", {}).glossary;
    for (const char* word : {"site", "plain, naive", "exact", "filter", "tie", "perturbation"}) {
        const std::string entry = "<dt>" + std::string(word) + "</dt>";
        EXPECT_NE(plane.find(entry), std::string::npos) << word;
        EXPECT_NE(space.find(entry), std::string::npos) << word;
    }
    EXPECT_NE(plane.find("four sites on one circle. One rule"), std::string::npos);
    EXPECT_NE(space.find("five sites on one sphere. One rule"), std::string::npos);
    for (const std::string& all : {plane, space}) {
        EXPECT_TRUE(all.starts_with("<h2>Words</h2>\n<dl>\n<dt>"));
        EXPECT_TRUE(all.ends_with("</dd>\n</dl>\n"));
    }
}

TEST(StudyFigures, NeedRows) {
    EXPECT_TRUE(page_of("plane", {}).figures.empty());
    EXPECT_TRUE(page_of("space", {}).figures.empty());
}

TEST(StudyFigures, OfSpaceComeFromItsRows) {
    const Setting sites = {"sites", "power", "grid", 100, 0.0, 1.0, 1.0};
    const Setting calls = {"stage_cost", "power", "grid", 100, 0.0, 1.0, 1.0};
    const std::vector<Row> rows = {{sites, "exact", "ratio", {1.5, 1.5, 1.5, 1}},
                                   {{"first_error", "power", "grid", 100, 0.0, 1.0, 1.0},
                                    "naive",
                                    "first_error",
                                    {1e-9, 1e-9, 1e-9, 1}},
                                   {calls, "exact", "in_sphere", {8, 8, 8, 1}},
                                   {calls, "exact", "calls_exact", {2, 2, 2, 1}}};
    const std::vector<Figure> drawn = page_of("space", rows).figures;
    ASSERT_EQ(drawn.size(), 3U);
    EXPECT_EQ(drawn[0].plot.name, "space_first_error");
    EXPECT_EQ(drawn[0].plot.panels.at(0).series.at(3).points.at(0).y, 1e-9);
    EXPECT_EQ(drawn[1].plot.name, "space_ratio_by_sites");
    EXPECT_EQ(drawn[1].plot.panels.at(0).series.at(3).points.at(0).y, 1.5);
    EXPECT_EQ(drawn[2].plot.name, "space_stages");
    EXPECT_EQ(drawn[2].plot.panels.at(0).series.at(2).points.at(3).y, 25.0);
    for (const Figure& figure : drawn)
        for (const Panel& panel : figure.plot.panels) EXPECT_NE(panel.title, "");
}

}  // namespace
}  // namespace signum::study
