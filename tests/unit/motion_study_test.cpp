/// The study of moving balls: its shaker, its table of cells, what a cell gives, and that its page
/// says what the numbers say.

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/study/motion/measure.hpp"
#include "../../tool/study/motion/page.hpp"
#include "../../tool/study/motion/plan.hpp"
#include "../../tool/study/motion/results.hpp"
#include "../../tool/study/motion/shaker.hpp"

namespace signum::study {
namespace {

MotionCell small_cell(MotionWork work) {
    MotionCell cell;
    cell.setting = {"packing", 20, 10.0, 0.4, 0.0};
    cell.work = work;
    cell.simulated = 3.0;
    cell.budget = {1, 1, 0.0};
    return cell;
}

TEST(MotionStudyRows, ReadBackAsTheyWere) {
    const MotionRow row = {
        {"large", 1000, 10.0, 0.33, 0.005}, "auto", "seconds", {0.1, 0.05, 0.2, 6}};
    const MotionRow end = {row.setting, "study", std::string(end_of_cell), {1.0, 1.0, 1.0, 1}};
    const auto table =
        read_csv<MotionSetting>(csv_header<MotionSetting>() + csv_line(row) + csv_line(end));
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].setting, row.setting);
    EXPECT_EQ(csv_line(table.rows[0]), csv_line(row));
    // A table of tessellations is none of balls.
    EXPECT_THROW(static_cast<void>(read_csv<MotionSetting>(csv_header<Setting>())),
                 std::invalid_argument);
}

TEST(MotionStudyPlan, HasEveryExperimentOnceInBothForms) {
    for (const bool quick : {false, true}) {
        std::set<std::string> seen;
        std::set<std::string> experiments;
        for (const MotionCell& cell : plan_motion({.quick = quick})) {
            EXPECT_TRUE(seen.insert(key_of(cell.setting)).second) << key_of(cell.setting);
            experiments.insert(cell.setting.experiment);
        }
        EXPECT_EQ(experiments,
                  (std::set<std::string>{"packing", "number", "accuracy", "time_steps", "large"}));
    }
}

TEST(MotionStudyPlan, KeepsToItsScope) {
    const std::vector<MotionCell> cells = plan_motion({.least_balls = 30, .most_balls = 50});
    EXPECT_FALSE(cells.empty());
    for (const MotionCell& cell : cells) {
        EXPECT_GE(cell.setting.balls, 30);
        EXPECT_LE(cell.setting.balls, 50);
    }
}

TEST(MotionStudyShaker, FillsItsBoxWithTheSizesAskedFor) {
    for (const std::int64_t balls : {1, 100, 400}) {
        const MotionSetting setting = {"", balls, 10.0, 0.3, 0.0};
        const std::vector<double> radii = radii_of(setting);
        double area = 0.0;
        for (const double radius : radii) area += std::numbers::pi * radius * radius;
        EXPECT_NEAR(area, 0.3 * std::pow(side_of_box(balls), 2), 1e-6 * area);
    }
    const std::vector<double> radii = radii_of({"", 1000, 10.0, 0.3, 0.0});
    EXPECT_NEAR(radii.front() / radii.back(), 10.0, 0.5);
    EXPECT_DOUBLE_EQ(side_of_box(100), 200.0);
    EXPECT_DOUBLE_EQ(side_of_box(400), 400.0);
    // The thesis's table 10.4.1.
    EXPECT_NEAR(radii_of({"", 100, 1.0, 0.05, 0.0}).front(), 2.5, 0.05);
    EXPECT_NEAR(radii_of({"", 100, 1.0, 0.7, 0.0}).front(), 9.5, 0.1);
}

TEST(MotionStudyMeasure, AllStructuresRunTheSameShaker) {
    for (const double step : {0.0, 0.05}) {
        MotionCell cell = small_cell(MotionWork::structures);
        cell.setting.time_step = step;
        cell.contestants = {"auto", "pairs", "cells", "segments", "levels", "lists", "delaunay"};
        const std::vector<MotionRow> rows = measure(cell);
        EXPECT_EQ(rows.back().quantity, end_of_cell);
        const MotionResults results(rows);
        const auto strikes = results.value(cell.setting, "auto", "strikes");
        ASSERT_TRUE(strikes);
        EXPECT_GT(*strikes, 20.0);
        for (const std::string& name : cell.contestants) {
            EXPECT_EQ(results.value(cell.setting, name, "strikes"), strikes) << name;
            EXPECT_GT(results.value(cell.setting, name, "seconds").value_or(0.0), 0.0) << name;
        }
        EXPECT_LT(results.value(cell.setting, "segments", "checks"),
                  results.value(cell.setting, "pairs", "checks"));
        const double predictions = step > 0.0 ? 20.0 * 3.0 / step : 0.0;
        EXPECT_NEAR(*results.value(cell.setting, "auto", "predictions"), predictions, 20.0);
    }
}

TEST(MotionStudyMeasure, RoundingWritesAnotherLogAndExactArithmeticLosesNobody) {
    MotionCell cell = small_cell(MotionWork::accuracy);
    cell.simulated = 10.0;
    cell.contestants = {"naive", "exact"};
    const MotionResults results(measure(cell));
    EXPECT_EQ(results.value(cell.setting, "exact", "broken_percent"), 0.0);
    EXPECT_EQ(results.value(cell.setting, "exact", "lost"), 0.0);
    EXPECT_LT(*results.value(cell.setting, "exact", "overlap"), 1e-12);
    EXPECT_LT(*results.value(cell.setting, "exact", "wall_overlap"), 1e-12);
    ASSERT_TRUE(results.value(cell.setting, "naive", "first_other_bits"));
    EXPECT_LE(*results.value(cell.setting, "naive", "first_other_bits"),
              results.value(cell.setting, "naive", "first_other_strike").value_or(1e9));
    EXPECT_EQ(results.value(cell.setting, "naive", "ratio"), 1.0);
}

TEST(MotionStudyMeasure, ShortStepsAreNearlyEvents) {
    MotionCell cell = small_cell(MotionWork::time_steps);
    cell.simulated = 0.5;
    cell.seeds = 3;
    const auto energy = [&](double step) {
        cell.setting.time_step = step;
        return MotionResults(measure(cell)).value(cell.setting, "auto", "energy_at_0.5").value();
    };
    const double exact = energy(0.0);
    EXPECT_GT(exact, 0.0);
    EXPECT_NEAR(energy(1.0 / 512), exact, 0.01 * exact);
}

/// A cell in which structures took so long.
std::vector<MotionRow> timed(const MotionSetting& cell,
                             const std::vector<std::pair<std::string, double>>& ratios) {
    std::vector<MotionRow> rows = {{cell, "auto", "chooses_lists", {1.0, 1.0, 1.0, 1}},
                                   {cell, "auto", "strikes", {7.0, 7.0, 7.0, 1}}};
    for (const auto& [name, ratio] : ratios)
        for (const char* quantity : {"seconds", "ratio"})
            rows.push_back({cell, name, quantity, {ratio, ratio, ratio, 6}});
    return rows;
}

std::string text_of(const Page& page, const std::string& name) {
    for (const DrawnFigure& drawn : page.figures)
        if (drawn.figure.plot.name == name) return drawn.figure.text;
    ADD_FAILURE() << "the page lacks " << name;
    return {};
}

TEST(MotionStudyPage, SaysWhatTheNumbersSay) {
    const MotionSetting cell = {"packing", 100, 10.0, 0.7, 0.0};
    const Page first = motion_page(
        timed(cell, {{"cells", 2.0}, {"lists", 1.0}, {"segments", 0.5}, {"levels", 0.54}}));
    EXPECT_NE(text_of(first, "packing_many_sizes").find("the fastest of all in all 1 cells"),
              std::string::npos);
    EXPECT_NE(text_of(first, "choice").find("in 0 of 1 cells. Worst is 2.00"), std::string::npos);
    EXPECT_NE(text_of(first, "choice").find("in 1 of 1 cells. Worst is 1.08"), std::string::npos);
    const Page second = motion_page(
        timed(cell, {{"cells", 2.0}, {"lists", 1.0}, {"segments", 3.0}, {"levels", 1.5}}));
    EXPECT_NE(text_of(second, "packing_many_sizes").find("the fastest of all in none of 1 cells"),
              std::string::npos);
    EXPECT_NE(text_of(second, "choice").find("in 1 of 1 cells. Worst is 1.00"), std::string::npos);
    EXPECT_NE(text_of(second, "choice").find("in 0 of 1 cells. Worst is 1.50"), std::string::npos);
}

TEST(MotionStudyPage, SaysWhereStructuresDisagree) {
    const MotionSetting cell = {"packing", 100, 1.0, 0.05, 0.0};
    std::vector<MotionRow> rows = timed(cell, {{"cells", 2.0}, {"lists", 1.0}});
    rows.push_back({cell, "cells", "strikes", {7.0, 7.0, 7.0, 1}});
    EXPECT_EQ(text_of(motion_page(rows), "packing_one_size").find("not the same"),
              std::string::npos);
    rows.push_back({cell, "lists", "strikes", {8.0, 8.0, 8.0, 1}});
    EXPECT_NE(text_of(motion_page(rows), "packing_one_size").find("not the same"),
              std::string::npos);
}

TEST(MotionStudyPage, NeedsRows) {
    EXPECT_TRUE(motion_page({}).figures.empty());
}

}  // namespace
}  // namespace signum::study
