#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "figures.hpp"
#include "thesis.hpp"

namespace signum::study {
namespace {

constexpr double thesis_step = 0.005;

double by_packing(const MotionSetting& cell) {
    return 100.0 * cell.packing;
}
double by_balls(const MotionSetting& cell) {
    return static_cast<double>(cell.balls);
}

int look_of_structure(const std::string& name) {
    return static_cast<int>(std::find(structures.begin(), structures.end(), name) -
                            structures.begin()) +
           1;
}

std::string number(double value) {
    return std::isnan(value) ? std::string("–") : fmt::format("{:.0f}", value);
}
std::string number(const std::optional<double>& value) {
    return value ? number(*value) : std::string("–");
}
std::string seconds(const std::optional<double>& value) {
    return value ? fmt::format("{:.3g}", *value) : std::string("–");
}
std::string seconds(double value) {
    return std::isnan(value) ? std::string("–") : fmt::format("{:.0f}", value);
}

/// A line of a table, whose first cell is its name.
std::string table_line(const std::string& name, const std::vector<std::string>& cells,
                       std::string_view tag = "td") {
    std::string text = fmt::format("<tr><th>{}</th>", name);
    for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", tag, cell);
    return text + "</tr>\n";
}

/// The cell of an experiment with a packing and a time step; none where it was left out.
std::optional<MotionSetting> cell_at(const std::vector<MotionSetting>& cells, double packing,
                                     double step) {
    for (const MotionSetting& cell : cells)
        if (cell.packing == packing && cell.time_step == step) return cell;
    return std::nullopt;
}

/// Whether all structures, none of which was stopped early, struck as often, and left all balls the
/// same in every bit.
bool all_strike_alike(const MotionResults& results, const std::vector<MotionSetting>& cells) {
    for (const MotionSetting& cell : cells)
        for (const std::string& name : structures)
            for (const char* const quantity : {"strikes", "digest"}) {
                const auto value = results.value(cell, name, quantity);
                if (value && value != results.value(cell, "auto", quantity)) return false;
            }
    return true;
}

/// In how many cells something holds, as words: "in 3 of 5 cells".
template <class Holds>
std::string in_cells(const MotionResults& results, const std::vector<MotionSetting>& cells,
                     const Holds& holds) {
    int all = 0;
    int held = 0;
    for (const MotionSetting& cell : cells)
        if (const auto ranks = ranking(results, cell)) {
            ++all;
            held += holds(*ranks) ? 1 : 0;
        }
    return held == all ? fmt::format("in all {} cells", all)
           : held == 0 ? fmt::format("in none of {} cells", all)
                       : fmt::format("in {} of {} cells", held, all);
}

/// The slowest of those that the thesis calls optimizations.
std::string slowest_optimization(const Ranking& ranks) {
    std::string slowest;
    for (const auto& [name, factor] : ranks.factor)
        if (name != "auto" && name != "pairs" && name != "levels" && name != "lists" &&
            (slowest.empty() || factor > ranks.factor.at(slowest)))
            slowest = name;
    return slowest;
}

bool is_faster(const Ranking& ranks, const std::string& a, const std::string& b) {
    const auto of_a = ranks.factor.find(a);
    const auto of_b = ranks.factor.find(b);
    return of_a != ranks.factor.end() && of_b != ranks.factor.end() && of_a->second < of_b->second;
}

Panel time_panel(const std::string& title, const std::string& x_label) {
    Panel panel;
    panel.title = title;
    panel.x_label = x_label;
    panel.y_label = "seconds";
    panel.y_is_log = true;
    return panel;
}

std::vector<Series> series_of(const MotionResults& results, const std::vector<MotionSetting>& cells,
                              const std::string& quantity,
                              const std::function<double(const MotionSetting&)>& where,
                              double scale = 1.0) {
    std::vector<Series> all;
    for (const std::string& name : structures)
        all.push_back({name, look_of_structure(name), true,
                       results.points(cells, name, quantity, where, scale)});
    return all;
}

std::vector<MotionSetting> with_step(std::vector<MotionSetting> cells, double step) {
    std::erase_if(cells, [&](const MotionSetting& cell) { return cell.time_step != step; });
    return cells;
}

/// The thesis's lines above ours: a table each of strikes and of times, events and checks.
std::string packing_tables(const MotionResults& results, const std::vector<MotionSetting>& cells,
                           const thesis::PackingTable& thesis) {
    const auto columns = [&](const auto& of_packing) {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < thesis::packings.size(); ++i) all.push_back(of_packing(i));
        return all;
    };
    const auto here = [&](std::size_t i, const std::string& contestant, const std::string& quantity,
                          double step) -> std::optional<double> {
        const auto cell = cell_at(cells, thesis::packings[i], step);
        return cell ? results.value(*cell, contestant, quantity) : std::nullopt;
    };
    std::string text =
        "<table>\n" + table_line("packing", columns([](std::size_t i) {
                                     return fmt::format("{:.0f} %", 100.0 * thesis::packings[i]);
                                 }),
                                 "th");
    text += table_line("radii, thesis",
                       columns([&](std::size_t i) { return std::string(thesis.radii[i]); }));
    text += table_line("strikes, thesis",
                       columns([&](std::size_t i) { return number(thesis.strikes[i]); }));
    text += table_line("strikes, steps", columns([&](std::size_t i) {
                           return number(here(i, "auto", "strikes", thesis_step));
                       }));
    text +=
        table_line("strikes, events",
                   columns([&](std::size_t i) { return number(here(i, "auto", "strikes", 0.0)); }));
    text += table_line("predictions, thesis",
                       columns([&](std::size_t i) { return number(thesis.predictions[i]); }));
    text += table_line("predictions, steps", columns([&](std::size_t i) {
                           return number(here(i, "auto", "predictions", thesis_step));
                       }));
    text +=
        "</table>\n<p>Time in seconds; own events; checks. The thesis on a Pentium 166 with "
        "steps of 0.005 s, then ours with the same steps, then from event to event.</p>\n<table "
        "class=\"wide\">\n";
    text += table_line("packing", columns([](std::size_t i) {
                           return fmt::format("{:.0f} %", 100.0 * thesis::packings[i]);
                       }),
                       "th");
    for (const std::string& name : structures) {
        for (const thesis::Line& line : thesis.lines)
            if (line.structure == name)
                text +=
                    table_line(std::string(line.name), columns([&](std::size_t i) {
                                   const thesis::Effort& effort = line.at[i];
                                   return fmt::format("{}; {}; {}", seconds(effort.seconds),
                                                      number(effort.events), number(effort.checks));
                               }));
        for (const double step : {thesis_step, 0.0})
            text += table_line(fmt::format("{}, {}", name, step > 0.0 ? "steps" : "events"),
                               columns([&](std::size_t i) {
                                   return fmt::format("{}; {}; {}",
                                                      seconds(here(i, name, "seconds", step)),
                                                      number(here(i, name, "own", step)),
                                                      number(here(i, name, "checks", step)));
                               }));
    }
    return text + "</table>\n";
}

/// What a table of the thesis claims, and whether it holds here.
std::string claims(const MotionResults& results, const std::vector<MotionSetting>& cells) {
    const auto slowest = [](const Ranking& ranks) {
        return slowest_optimization(ranks) == "delaunay";
    };
    const auto segments_win = [](const Ranking& ranks) { return ranks.fastest == "segments"; };
    const auto cells_before_tree = [](const Ranking& ranks) {
        return is_faster(ranks, "cells", "tree");
    };
    std::string text = "<ul>\n";
    for (const double step : {thesis_step, 0.0}) {
        const auto some = with_step(cells, step);
        if (some.empty()) continue;
        text += fmt::format(
            "<li>{}: <code>segments</code>, the thesis’s fastest, is the fastest of all {}; "
            "<code>delaunay</code> is the slowest of the thesis’s four structures {}, as the "
            "thesis "
            "found; <code>cells</code> is faster than <code>tree</code> {}, as in the "
            "thesis.</li>\n",
            step > 0.0 ? "With steps" : "From event to event",
            in_cells(results, some, segments_win), in_cells(results, some, slowest),
            in_cells(results, some, cells_before_tree));
    }
    return text + "</ul>\n";
}

Figure packing_figure(const MotionResults& results, const thesis::PackingTable& thesis) {
    const bool is_one = thesis.size_ratio == 1.0;
    const auto cells = results.cells(
        "packing", [&](const MotionSetting& cell) { return cell.size_ratio == thesis.size_ratio; });
    Figure figure;
    figure.plot = {is_one ? "packing_one_size" : "packing_many_sizes", 2, {}};
    if (cells.empty()) return figure;
    Panel quoted = time_panel("The thesis, steps of 0.005 s", "packing, %");
    for (const std::string& name : structures) {
        Series series{name, look_of_structure(name), true, {}};
        for (const thesis::Line& line : thesis.lines)
            for (std::size_t i = 0; i < thesis::packings.size() && line.structure == name; ++i) {
                const double y = line.at[i].seconds;
                if (!std::isnan(y)) series.points.push_back({100.0 * thesis::packings[i], y, y, y});
            }
        quoted.series.push_back(std::move(series));
    }
    figure.plot.panels.push_back(std::move(quoted));
    for (const double step : {thesis_step, 0.0}) {
        Panel panel = time_panel(step > 0.0 ? "Here, the same steps" : "Here, from event to event",
                                 "packing, %");
        panel.series = series_of(results, with_step(cells, step), "seconds", by_packing);
        figure.plot.panels.push_back(std::move(panel));
    }
    figure.title = is_one ? "Balls of one size (thesis: tables 10.4.1 and 10.4.2, figure 10.4.1)"
                          : "Balls of many sizes (thesis: tables 10.4.3 and 10.4.4, figure 10.4.2)";
    figure.text = fmt::format(
        "<p>A hundred balls {}, at rest at first, in a box 200 wide that goes up and down. {} All "
        "structures write the same log: their strikes, and all bits of the balls in the end, are "
        "{}.</p>\n{}{}",
        is_one ? "of one size" : "whose radii are 1 : 10",
        is_one ? ""
               : "Of table 10.4.4 the columns of 50 % and 70 % cannot be read, nor what the power "
                 "diagram did.",
        all_strike_alike(results, cells) ? "the same in every cell"
                                         : "<strong>not the same</strong>",
        packing_tables(results, cells, thesis), claims(results, cells));
    figure.description = "Seconds against packing by structure: the thesis, steps, events";
    return figure;
}

/// The power of the number of balls with which a time grows, over the last doubling.
std::optional<double> growth_of_time(const MotionResults& results,
                                     const std::vector<MotionSetting>& cells,
                                     const std::string& name) {
    const auto points = results.points(cells, name, "seconds", by_balls);
    if (points.empty()) return std::nullopt;
    for (const PlotPoint& point : points)
        if (2.0 * point.x <= points.back().x * 1.2 && 2.5 * point.x >= points.back().x)
            return std::log(points.back().y / point.y) / std::log(points.back().x / point.x);
    return std::nullopt;
}

Figure number_figure(const MotionResults& results) {
    const auto cells = results.cells("number");
    Figure figure;
    figure.plot = {"number", 2, {}};
    if (cells.empty()) return figure;
    for (const double step : {thesis_step, 0.0}) {
        Panel panel = time_panel(step > 0.0 ? "Steps of 0.005 s" : "From event to event", "balls");
        panel.y_is_log = false;
        panel.y_least = 0.0;
        panel.series = series_of(results, with_step(cells, step), "seconds", by_balls);
        figure.plot.panels.push_back(std::move(panel));
    }
    std::string table =
        "<table>\n" + table_line("balls",
                                 {"packing, thesis", "here", "strikes, thesis", "steps", "events",
                                  "predictions, thesis", "steps"},
                                 "th");
    for (std::size_t i = 0; i < thesis::numbers.size(); ++i) {
        std::optional<MotionSetting> stepped;
        std::optional<MotionSetting> free;
        for (const MotionSetting& cell : cells)
            if (cell.balls == thesis::numbers[i]) (cell.time_step > 0.0 ? stepped : free) = cell;
        if (!stepped || !free) continue;
        table += table_line(std::to_string(thesis::numbers[i]),
                            {fmt::format("{} %", thesis::densities[i]),
                             fmt::format("{:.1f} %", 100.0 * free->packing),
                             std::to_string(thesis::strikes_by_number[i]),
                             number(results.value(*stepped, "auto", "strikes")),
                             number(results.value(*free, "auto", "strikes")),
                             std::to_string(thesis::predictions_by_number[i]),
                             number(results.value(*stepped, "auto", "predictions"))});
    }
    table += "</table>\n";
    std::string growth;
    for (const std::string& name : structures)
        if (const auto power = growth_of_time(results, with_step(cells, thesis_step), name))
            growth +=
                fmt::format("{}<code>{}</code> {:.1f}", growth.empty() ? "" : ", ", name, *power);
    figure.title = "More balls, up to a hundred (thesis: table 10.4.5, figure 10.4.3)";
    figure.text = fmt::format(
        "<p>Radii from 5 to 10, two seconds: so many of its steps the table’s predictions are. The "
        "thesis finds that "
        "asking all pairs grows with the square of the number, and everything else in proportion "
        "to it."
        "{}</p>\n{}{}",
        growth.empty()
            ? std::string()
            : " Over the last doubling the time of steps grows here with the power " + growth + ".",
        table, claims(results, cells));
    figure.description = "Seconds against the number of balls by structure, with steps and without";
    return figure;
}

Figure large_figure(const MotionResults& results) {
    const auto cells = with_step(results.cells("large"), 0.0);
    Figure figure;
    figure.plot = {"large", 2, {}};
    if (cells.empty()) return figure;
    for (const double packing : {0.05, 0.33, 0.5, 0.7})
        for (const double ratio : {1.0, 10.0}) {
            auto some = cells;
            std::erase_if(some, [&](const MotionSetting& cell) {
                return cell.packing != packing || cell.size_ratio != ratio;
            });
            if (some.empty()) continue;
            Panel panel = time_panel(
                fmt::format("{:.0f} %, {}", 100.0 * packing, ratio == 1.0 ? "one size" : "1 : 10"),
                "balls");
            panel.y_label = "µs a strike";
            panel.x_is_log = true;
            panel.series = series_of(results, some, "seconds_per_strike", by_balls, 1e6);
            figure.plot.panels.push_back(std::move(panel));
        }
    figure.title = "A thousand balls and more";
    figure.text = fmt::format(
        "<p>What the thesis’s machine could not do: from event to event, the area of the box in "
        "proportion to the number. Balls fly when measuring "
        "begins, for in a box so high those at rest would strike nothing but the floor; they have "
        "struck "
        "five times each before. The time of a strike, for "
        "runs of equally many strikes; <code>pairs</code> and <code>delaunay</code> are stopped "
        "after a tenth of them, <code>segments</code> after a hundredth, and <code>pairs</code> "
        "runs "
        "only up to a thousand balls. <code>segments</code> "
        "is the slowest but <code>pairs</code> {}: between two strikes it exchanges the more ends "
        "of "
        "projections, the more balls there are.</p>",
        in_cells(results, cells,
                 [](const Ranking& ranks) { return slowest_optimization(ranks) == "segments"; }));
    figure.description = "Microseconds a strike against the number of balls, by structure";
    return figure;
}

Figure choice_figure(const MotionResults& results) {
    Figure figure;
    figure.plot = {"choice", 1, {}};
    double worst = 0.0;
    std::string worst_words;
    int count = 0;
    int near = 0;
    double worst_levels = 0.0;
    std::string worst_levels_words;
    int dense = 0;
    int dense_near = 0;
    std::string table;
    for (const char* experiment : {"packing", "number", "large"})
        for (const MotionSetting& cell : results.cells(experiment)) {
            const auto ranks = ranking(results, cell);
            if (!ranks) continue;
            const double factor = ranks->factor.at("auto");
            ++count;
            near += factor <= 1.2 ? 1 : 0;
            if (factor > worst) {
                worst = factor;
                worst_words = words_for(cell);
            }
            const auto levels = ranks->factor.find("levels");
            const double of_levels = levels == ranks->factor.end() ? 0.0 : levels->second;
            if (cell.size_ratio >= 10.0 && cell.packing >= 0.33 && of_levels > 0.0) {
                ++dense;
                dense_near += of_levels <= 1.1 ? 1 : 0;
                if (of_levels > worst_levels) {
                    worst_levels = of_levels;
                    worst_levels_words = words_for(cell);
                }
            }
            table += table_line(words_for(cell),
                                {ranks->fastest, ranks->chosen, fmt::format("{:.2f}", factor),
                                 of_levels > 0.0 ? fmt::format("{:.2f}", of_levels) : "–"});
        }
    if (count == 0) return figure;
    figure.title = "What auto chooses, and how near it is to the best";
    figure.text = fmt::format(
        "<p><code>auto</code> takes at most 1.2 times as long as the fastest structure in {} of {} "
        "cells. Worst is {:.2f} ({}).</p>\n",
        near, count, worst, worst_words);
    if (dense > 0)
        figure.text += fmt::format(
            "<p>Where sizes are 1 : 10 and balls fill a third or more, <code>levels</code> is the "
            "fastest or within 10 % of it in {} of {} cells. Worst is {:.2f} ({}).</p>\n",
            dense_near, dense, worst_levels, worst_levels_words);
    figure.text +=
        "<details><summary>All cells: times, as parts of the fastest "
        "structure’s</summary>\n<table>\n" +
        table_line("cell", {"fastest", "auto is", "auto", "levels"}, "th") + table +
        "</table></details>\n";
    return figure;
}

/// Of the tables' cells: in how many segments ask the fewest pairs of the thesis's structures, and
/// cells as many as all pairs are.
std::string who_asks(const MotionResults& results, const std::vector<MotionSetting>& cells) {
    int all = 0;
    int fewest = 0;
    int as_many = 0;
    for (const MotionSetting& cell : cells) {
        const auto of_segments = results.value(cell, "segments", "checks");
        const auto of_cells = results.value(cell, "cells", "checks");
        const auto of_pairs = results.value(cell, "pairs", "checks");
        if (!of_segments || !of_cells || !of_pairs) continue;
        ++all;
        fewest += *of_segments <= std::min(*of_cells, *of_pairs) ? 1 : 0;
        as_many += *of_cells >= 0.9 * *of_pairs ? 1 : 0;
    }
    return fmt::format(
        "Of the {} cells of these tables segments ask the fewest pairs in {}; <code>cells</code> "
        "ask nine tenths of what all pairs do, or all of it, in {}.",
        all, fewest, as_many);
}

/// How many times as long pairs take as the fastest, from the least to the most.
std::string cost_of_all_pairs(const MotionResults& results,
                              const std::vector<MotionSetting>& cells) {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const MotionSetting& cell : cells)
        if (const auto ranks = ranking(results, cell))
            if (const auto pairs = ranks->factor.find("pairs"); pairs != ranks->factor.end()) {
                least = std::min(least, pairs->second);
                most = std::max(most, pairs->second);
            }
    return most > 0.0 ? fmt::format("{:.2g} to {:.2g} times", least, most) : "–";
}

Figure why_figure(const MotionResults& results) {
    Figure figure;
    figure.plot = {"why", 1, {}};
    const auto cells = results.cells("packing");
    if (cells.empty()) return figure;
    const thesis::Effort& pairs = thesis::one_size.at_packing("pairs", 0);
    const thesis::Effort& segments = thesis::one_size.at_packing("segments", 0);
    const double of_check = (pairs.seconds - segments.seconds) / (pairs.checks - segments.checks);
    figure.title = "Why the order is another one than in the thesis";
    figure.text = fmt::format(
        "<p><strong>Segments.</strong> The thesis finds that its segment tree wins everywhere. "
        "There "
        "a check is dear: {:.0f} µs, as its first table tells, or {:.0f} cycles of a Pentium 166. "
        "Here "
        "four pairs are asked at a time without a branch, while an exchange of ends still is an "
        "event "
        "with its own time and its place in a queue. {}</p>\n"
        "<p><strong>All pairs.</strong> In the thesis they take some ten times as long as the "
        "rest. Here, a "
        "hundred balls, {} as long as the fastest from event to event, for only those that strike "
        "are "
        "asked about a hundred others; {} with time steps, where pairs are asked that were noted "
        "some steps before, whichever structure proposed them.</p>\n"
        "<p><strong>The power diagram.</strong> It is slow for the thesis’s reason: its events are "
        "roots "
        "of polynomials of degree 4, which here are isolated exactly. With steps every certificate "
        "of "
        "a ball that is kicked is found anew.</p>\n"
        "<p><strong>Cells and one large ball.</strong> Cells are as wide as the largest ball. As "
        "sizes "
        "spread and balls get denser there are ever fewer of them, as in the thesis. Levels have "
        "cells for "
        "each size.</p>\n",
        1e6 * of_check, 166e6 * of_check, who_asks(results, cells),
        cost_of_all_pairs(results, with_step(cells, 0.0)),
        cost_of_all_pairs(results, with_step(cells, thesis_step)));
    return figure;
}

}  // namespace

std::vector<Figure> structure_figures(const MotionResults& results) {
    std::vector<Figure> all;
    for (Figure& figure :
         std::vector<Figure>{packing_figure(results, thesis::one_size),
                             packing_figure(results, thesis::many_sizes), number_figure(results),
                             large_figure(results), choice_figure(results), why_figure(results)})
        if (!figure.title.empty()) all.push_back(std::move(figure));
    return all;
}

}  // namespace signum::study
