/// The study of moving balls: its shaker, its table of cells, what a cell gives, and that its page
/// says what the numbers say.

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/study/measure.hpp"
#include "../../tool/study/motion/shaker.hpp"
#include "../../tool/study/page.hpp"
#include "../../tool/study/plan.hpp"
#include "../../tool/study/results.hpp"

namespace signum::study {
namespace {

Cell small_cell(Work work) {
    Cell cell;
    cell.setting = {.experiment = "packing", .count = 20, .size_ratio = 10.0, .packing = 0.4};
    cell.work = work;
    cell.simulated = 3.0;
    cell.budget = {1, 1, 0.0};
    return cell;
}

TEST(MotionStudyRows, ReadBackAsTheyWere) {
    const Row row = {{.experiment = "large",
                      .count = 1000,
                      .size_ratio = 10.0,
                      .packing = 0.33,
                      .time_step = 0.005},
                     "auto",
                     "seconds",
                     {0.1, 0.05, 0.2, 6}};
    const Row end = {row.setting, "study", std::string(end_of_cell), {1.0, 1.0, 1.0, 1}};
    const auto table = read_csv(
        csv_header(Of::balls) + csv_line(row, Of::balls) + csv_line(end, Of::balls), Of::balls);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].setting, row.setting);
    EXPECT_EQ(csv_line(table.rows[0], Of::balls), csv_line(row, Of::balls));
    // A table of tessellations is none of balls.
    EXPECT_THROW(static_cast<void>(read_csv(csv_header(), Of::balls)), std::invalid_argument);
}

TEST(MotionStudyPlan, HasEveryExperimentOnceInBothForms) {
    for (const bool quick : {false, true}) {
        std::set<Setting> seen;
        std::set<std::string> experiments;
        for (const Cell& cell : plan_motion({.quick = quick})) {
            EXPECT_TRUE(seen.insert(cell.setting).second)
                << csv_line({cell.setting, "", "", {}}, Of::balls);
            experiments.insert(cell.setting.experiment);
        }
        EXPECT_EQ(experiments,
                  (std::set<std::string>{"packing", "number", "accuracy", "time_steps", "large"}));
    }
}

TEST(MotionStudyPlan, KeepsToItsScope) {
    const std::vector<Cell> cells = plan_motion({.least_sites = 30, .most_sites = 50});
    EXPECT_FALSE(cells.empty());
    for (const Cell& cell : cells) {
        EXPECT_GE(cell.setting.count, 30);
        EXPECT_LE(cell.setting.count, 50);
    }
}

TEST(MotionStudyShaker, FillsItsBoxWithTheSizesAskedFor) {
    for (const std::int64_t balls : {1, 100, 400}) {
        const Setting setting = {.count = balls, .size_ratio = 10.0, .packing = 0.3};
        const std::vector<double> radii = radii_of(setting);
        double area = 0.0;
        for (const double radius : radii) area += std::numbers::pi * radius * radius;
        EXPECT_NEAR(area, 0.3 * std::pow(side_of_box(balls), 2), 1e-6 * area);
    }
    const std::vector<double> radii = radii_of({.count = 1000, .size_ratio = 10.0, .packing = 0.3});
    EXPECT_NEAR(radii.front() / radii.back(), 10.0, 0.5);
    EXPECT_DOUBLE_EQ(side_of_box(100), 200.0);
    EXPECT_DOUBLE_EQ(side_of_box(400), 400.0);
    // The thesis's table 10.4.1.
    EXPECT_NEAR(radii_of({.count = 100, .size_ratio = 1.0, .packing = 0.05}).front(), 2.5, 0.05);
    EXPECT_NEAR(radii_of({.count = 100, .size_ratio = 1.0, .packing = 0.7}).front(), 9.5, 0.1);
}

TEST(MotionStudyMeasure, AllStructuresRunTheSameShaker) {
    for (const double step : {0.0, 0.05}) {
        Cell cell = small_cell(Work::structures);
        cell.setting.time_step = step;
        cell.contestants = {"auto", "pairs", "cells", "segments", "levels", "lists", "delaunay"};
        const std::vector<Row> rows = measure(cell);
        EXPECT_EQ(rows.back().quantity, end_of_cell);
        const Results results(rows);
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
    Cell cell = small_cell(Work::rounding);
    cell.simulated = 10.0;
    cell.contestants = {"naive", "exact"};
    const Results results(measure(cell));
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
    Cell cell = small_cell(Work::time_steps);
    cell.simulated = 0.5;
    cell.sets = 3;
    const auto energy = [&](double step) {
        cell.setting.time_step = step;
        return Results(measure(cell)).value(cell.setting, "auto", "energy_at_0.5").value();
    };
    const double exact = energy(0.0);
    EXPECT_GT(exact, 0.0);
    EXPECT_NEAR(energy(1.0 / 512), exact, 0.01 * exact);
}

/// A cell in which structures took so long.
std::vector<Row> timed(const Setting& cell,
                       const std::vector<std::pair<std::string, double>>& ratios) {
    std::vector<Row> rows = {{cell, "auto", "chooses_lists", {1.0, 1.0, 1.0, 1}},
                             {cell, "auto", "strikes", {7.0, 7.0, 7.0, 1}}};
    for (const auto& [name, ratio] : ratios)
        for (const char* quantity : {"seconds", "ratio"})
            rows.push_back({cell, name, quantity, {ratio, ratio, ratio, 6}});
    return rows;
}

std::string text_of(const Page& page, const std::string& name) {
    for (const Figure& figure : page.figures)
        if (figure.plot.name == name) return figure.text;
    ADD_FAILURE() << "the page lacks " << name;
    return {};
}

TEST(MotionStudyPage, SaysWhatTheNumbersSay) {
    const Setting cell = {
        .experiment = "packing", .count = 100, .size_ratio = 10.0, .packing = 0.7};
    const Page first =
        page_of("motion",
                timed(cell, {{"cells", 2.0}, {"lists", 1.0}, {"segments", 0.5}, {"levels", 0.54}}));
    EXPECT_NE(text_of(first, "packing_many_sizes").find("the fastest of all in all 1 cells"),
              std::string::npos);
    EXPECT_NE(text_of(first, "choice").find("in 0 of 1 cells. Worst is 2.00"), std::string::npos);
    EXPECT_NE(text_of(first, "choice").find("in 1 of 1 cells. Worst is 1.08"), std::string::npos);
    const Page second =
        page_of("motion",
                timed(cell, {{"cells", 2.0}, {"lists", 1.0}, {"segments", 3.0}, {"levels", 1.5}}));
    EXPECT_NE(text_of(second, "packing_many_sizes").find("the fastest of all in none of 1 cells"),
              std::string::npos);
    EXPECT_NE(text_of(second, "choice").find("in 1 of 1 cells. Worst is 1.00"), std::string::npos);
    EXPECT_NE(text_of(second, "choice").find("in 0 of 1 cells. Worst is 1.50"), std::string::npos);
}

TEST(MotionStudyPage, SaysWhereStructuresDisagree) {
    const Setting cell = {
        .experiment = "packing", .count = 100, .size_ratio = 1.0, .packing = 0.05};
    std::vector<Row> rows = timed(cell, {{"cells", 2.0}, {"lists", 1.0}});
    rows.push_back({cell, "cells", "strikes", {7.0, 7.0, 7.0, 1}});
    EXPECT_EQ(text_of(page_of("motion", rows), "packing_one_size").find("not the same"),
              std::string::npos);
    rows.push_back({cell, "lists", "strikes", {8.0, 8.0, 8.0, 1}});
    EXPECT_NE(text_of(page_of("motion", rows), "packing_one_size").find("not the same"),
              std::string::npos);
}

TEST(MotionStudyPage, NeedsRows) {
    EXPECT_TRUE(page_of("motion", {}).figures.empty());
}

}  // namespace
}  // namespace signum::study
