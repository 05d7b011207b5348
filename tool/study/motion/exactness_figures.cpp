#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "figures.hpp"

namespace signum::study {
namespace {

Figure cost_figure(const MotionResults& results) {
    const auto cells = results.cells("accuracy");
    Figure figure;
    figure.plot = {"cost", 1, {}};
    if (cells.empty()) return figure;
    Panel panel;
    panel.x_label = "packing, %";
    panel.y_label = "time, exact to plain";
    panel.y_least = 0.0;
    std::set<std::pair<std::int64_t, double>> kinds;
    for (const MotionSetting& cell : cells) kinds.emplace(cell.balls, cell.size_ratio);
    int style = 0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const auto& [balls, ratio] : kinds) {
        auto some = cells;
        std::erase_if(some, [&, number = balls, sizes = ratio](const MotionSetting& cell) {
            return cell.balls != number || cell.size_ratio != sizes;
        });
        auto points = results.points(
            some, "exact", "ratio", [](const MotionSetting& cell) { return 100.0 * cell.packing; });
        for (const PlotPoint& point : points) {
            least = std::min(least, point.y);
            most = std::max(most, point.y);
        }
        panel.series.push_back(
            {fmt::format("{} balls, {}", balls,
                         ratio == 1.0 ? "one size" : fmt::format("1 : {}", ratio)),
             ++style, true, std::move(points)});
    }
    figure.plot.panels.push_back(std::move(panel));
    figure.title = "What accuracy costs";
    figure.text = fmt::format(
        "<p>The time of a strike in exact arithmetic divided by that in plain doubles, "
        "<code>auto</code>, from event to event: from {:.2f} to {:.2f}. A hundred balls begin at "
        "rest, "
        "more of them flying.</p>",
        least, most);
    figure.description = "Ratio of times, exact to plain, against packing";
    return figure;
}

Figure wrong_figure(const MotionResults& results) {
    Figure figure;
    figure.plot = {"wrong", 1, {}};
    const auto cells = results.cells("accuracy");
    if (cells.empty()) return figure;
    std::string table =
        "<table>\n<tr><th>cell</th><th>strikes, exact</th><th>plain</th><th>another pair strikes "
        "from strike</th><th>at second</th><th>deepest overlap of balls, "
        "exact</th><th>plain</th><th>with a "
        "side, exact</th><th>plain</th><th>lost, exact</th><th>plain</th></tr>\n";
    int other = 0;
    int broken = 0;
    int lost = 0;
    double deepest_exact = 0.0;
    double deepest_naive = 0.0;
    for (const MotionSetting& cell : cells) {
        const auto text_of = [&](const char* contestant, const char* quantity, bool brief) {
            const auto value = results.value(cell, contestant, quantity);
            if (!value) return std::string("–");
            return brief ? fmt::format("{:.2g}", *value) : fmt::format("{:.0f}", *value);
        };
        const auto value_of = [&](const char* contestant, const char* quantity) {
            return results.value(cell, contestant, quantity).value_or(0.0);
        };
        other += results.value(cell, "naive", "first_other_strike") ? 1 : 0;
        broken += value_of("naive", "broken_percent") > 0.0 ? 1 : 0;
        lost += value_of("naive", "lost") > 0.0 ? 1 : 0;
        for (const char* quantity : {"overlap", "wall_overlap"}) {
            deepest_exact = std::max(deepest_exact, value_of("exact", quantity));
            deepest_naive = std::max(deepest_naive, value_of("naive", quantity));
        }
        table += fmt::format(
            "<tr><td>{}{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</"
            "td><td>{}"
            "</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            words_for(cell),
            value_of("naive", "broken_percent") > 0.0 ? ", plain does not end" : "",
            text_of("exact", "strikes", false), text_of("naive", "strikes", false),
            text_of("naive", "first_other_strike", false),
            text_of("naive", "first_other_strike_time", true), text_of("exact", "overlap", true),
            text_of("naive", "overlap", true), text_of("exact", "wall_overlap", true),
            text_of("naive", "wall_overlap", true), text_of("exact", "lost", false),
            text_of("naive", "lost", false));
    }
    figure.title = "What goes wrong without it";
    figure.text = fmt::format(
        "<p>The same shakers in plain doubles, whose order and times are rounded: in {} of {} the "
        "log names another pair before the end, and from there on it is another history; in {} "
        "plain "
        "arithmetic lost its way (more than twenty times the strikes, or an error), in {} balls "
        "left the box. Overlaps are the "
        "deepest of ten times, in radii of the smallest ball: at most {:.2g} exactly, where each "
        "strike rounds once, and {:.2g} in plain doubles.</p>\n",
        other, cells.size(), broken, lost, deepest_exact, deepest_naive);
    figure.text += table + "</table>\n";
    return figure;
}

std::vector<PlotPoint> over_time(const MotionResults& results, const MotionSetting& cell,
                                 const std::string& prefix, double scale) {
    std::vector<PlotPoint> points;
    // Tenths of ten seconds, or of two.
    for (const double length : {10.0, 2.0}) {
        points.clear();
        for (int part = 1; part <= 10; ++part) {
            const double time = length * part / 10;
            const auto found = results.interval(cell, "auto", fmt::format("{}{}", prefix, time));
            if (!found) break;
            const double factor = prefix == "strikes_at_" ? scale * 10.0 / length : scale;
            points.push_back(
                {time, factor * found->median, factor * found->low, factor * found->high});
        }
        if (points.size() == 10) break;
    }
    return points;
}

std::string with_error(const Interval& value) {
    return fmt::format("{:.4g} ± {:.2g}", value.median, 0.5 * (value.high - value.low));
}

Figure time_step_figure(const MotionResults& results) {
    Figure figure;
    figure.plot = {"time_steps", 2, {}};
    const auto cells = results.cells("time_steps");
    if (cells.empty()) return figure;
    std::set<double> packings;
    for (const MotionSetting& cell : cells) packings.insert(cell.packing);
    std::string table =
        "<table>\n<tr><th>packing</th><th>step, s</th><th>strikes</th><th>more than from event to "
        "event</th><th>mean energy of a "
        "unit of mass</th><th>more than from event to event</th></tr>\n";
    int within = 0;
    int finest_cells = 0;
    for (const double packing : packings) {
        Panel strikes;
        strikes.title = fmt::format("{:.0f} %", 100.0 * packing);
        strikes.x_label = "seconds";
        strikes.y_label = "strikes a second";
        Panel energies = strikes;
        energies.y_label = "energy of a unit of mass";
        std::optional<MotionSetting> free;
        double finest = 1.0;
        for (const MotionSetting& cell : cells)
            if (cell.packing == packing) {
                if (cell.time_step == 0.0)
                    free = cell;
                else
                    finest = std::min(finest, cell.time_step);
            }
        if (!free) continue;
        int style = 0;
        for (const MotionSetting& cell : cells) {
            if (cell.packing != packing) continue;
            const std::string words =
                cell.time_step > 0.0 ? fmt::format("{} s", cell.time_step) : std::string("events");
            strikes.series.push_back(
                {words, ++style, true, over_time(results, cell, "strikes_at_", 1.0)});
            energies.series.push_back(
                {words, style, true, over_time(results, cell, "energy_at_", 1.0)});
            std::string line = fmt::format(
                "<tr><td>{:.0f} %</td><td>{}</td>", 100.0 * packing,
                cell.time_step > 0.0 ? fmt::format("{}", cell.time_step) : std::string("–"));
            for (const char* quantity : {"all_strikes", "mean_energy"}) {
                const auto value = results.interval(cell, "auto", quantity);
                const auto base = results.interval(*free, "auto", quantity);
                if (!value || !base) continue;
                const double difference = value->median - base->median;
                const double error =
                    0.5 * std::hypot(value->high - value->low, base->high - base->low);
                if (cell.time_step == finest) {
                    ++finest_cells;
                    within += std::fabs(difference) <= 2.0 * error ? 1 : 0;
                }
                line += fmt::format("<td>{}</td><td>{}</td>", with_error(*value),
                                    cell.time_step > 0.0
                                        ? fmt::format("{:+.2g} ± {:.2g}", difference, error)
                                        : std::string());
            }
            table += line + "</tr>\n";
        }
        figure.plot.panels.push_back(std::move(strikes));
        figure.plot.panels.push_back(std::move(energies));
    }
    figure.title = "Time steps against events";
    figure.text = fmt::format(
        "<p>With steps gravity acts by kicks, between which balls fly straight; the strikes "
        "between "
        "two kicks are found exactly, so nothing passes through anything. As steps get shorter the "
        "motion should become that from event to event: at the shortest one {} of {} means of "
        "strikes "
        "and energy lie within two standard errors of it. Means over seeds; bars are a standard "
        "deviation of seeds, "
        "errors in the table standard errors.</p>\n",
        within, finest_cells);
    figure.text += table + "</table>\n";
    figure.description = "Strikes a second and energy over time, by time step";
    return figure;
}

}  // namespace

std::vector<Figure> exactness_figures(const MotionResults& results) {
    std::vector<Figure> all;
    for (Figure& figure : std::vector<Figure>{cost_figure(results), wrong_figure(results),
                                              time_step_figure(results)})
        if (!figure.title.empty()) all.push_back(std::move(figure));
    return all;
}

}  // namespace signum::study
