#include "words.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "../results.hpp"

namespace signum::study {
namespace {

constexpr double thesis_step = 0.005;
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// A number in a table, and what stands there where it is missing.
std::string shown(const std::optional<double>& value, const char* format = "{:.0f}") {
    return value ? fmt::format(fmt::runtime(format), *value) : std::string("–");
}

std::string in_percent(double share) {
    return fmt::format("{:.3g} %", 100.0 * share);
}

/// "100 balls, 1 : 10, 33 %, steps of 0.005 s"
std::string words_for(const Setting& cell) {
    return fmt::format(
        "{} balls, {}, {}, {}", cell.count,
        cell.size_ratio == 1.0 ? "one size" : fmt::format("1 : {}", cell.size_ratio),
        in_percent(cell.packing),
        cell.time_step > 0.0 ? fmt::format("steps of {} s", cell.time_step) : "events");
}

/// Times of structures in a cell, each as a part of the least one.
struct Ranking {
    std::string fastest;
    std::string chosen;  ///< by auto
    std::map<std::string, double> factor;

    /// The slowest of those that the thesis calls optimizations.
    [[nodiscard]] std::string slowest_optimization() const {
        std::string slowest;
        for (const std::string name : {"cells", "delaunay", "segments", "tree"})
            if (factor.contains(name) && (slowest.empty() || factor.at(name) > factor.at(slowest)))
                slowest = name;
        return slowest;
    }
};

/// The rows, and the page on which they are told.
struct Motion {
    const toml::table& page;
    Results results;
    std::vector<std::string> structures = {};  ///< in the order of the legends

    Motion(const toml::table& of, const std::vector<Row>& rows) : page(of), results(rows) {
        for (const toml::node& name : *page["lists"]["contestant"].as_array())
            structures.push_back(name.value_or(std::string()));
    }

    using Which = std::function<bool(const Setting&)>;
    [[nodiscard]] Cells cells(std::string_view experiment, const Which& which = {}) const {
        return results.cells([&](const Setting& cell) {
            return cell.experiment == experiment && (!which || which(cell));
        });
    }

    /// None where no two structures were timed.
    [[nodiscard]] std::optional<Ranking> ranking(const Setting& cell) const {
        Ranking all;
        for (const std::string& name : structures) {
            if (const auto ratio = results.value(cell, name, "ratio")) all.factor[name] = *ratio;
            if (results.value(cell, "auto", "chooses_" + name)) all.chosen = name;
        }
        if (all.factor.size() < 2) return std::nullopt;
        const auto best =
            std::ranges::min_element(all.factor, {}, [](const auto& each) { return each.second; });
        all.fastest = best->first;
        const double least = best->second;
        all.factor["auto"] = 1.0;
        for (auto& [name, factor] : all.factor) factor = std::max(1.0, factor / least);
        return all;
    }

    /// In how many cells something holds, as words: "in 3 of 5 cells".
    template <class Holds>
    [[nodiscard]] std::string in_cells(const Cells& cells, const Holds& holds) const {
        int all = 0;
        int held = 0;
        for (const Setting& cell : cells)
            if (const auto ranks = ranking(cell)) {
                ++all;
                held += holds(*ranks) ? 1 : 0;
            }
        return held == all ? fmt::format("in all {} cells", all)
               : held == 0 ? fmt::format("in none of {} cells", all)
                           : fmt::format("in {} of {} cells", held, all);
    }

    /// What a table of the thesis claims, and whether it holds here.
    [[nodiscard]] std::string claims(const Cells& cells) const {
        std::string text;
        for (const double step : {thesis_step, 0.0}) {
            Cells some = cells;
            std::erase_if(some, [&](const Setting& cell) { return cell.time_step != step; });
            if (some.empty()) continue;
            const auto segments_win = [](const Ranking& ranks) {
                return ranks.fastest == "segments";
            };
            const auto is_slowest = [](const Ranking& ranks) {
                return ranks.slowest_optimization() == "delaunay";
            };
            const auto cells_before_tree = [](const Ranking& ranks) {
                return ranks.factor.contains("cells") && ranks.factor.contains("tree") &&
                       ranks.factor.at("cells") < ranks.factor.at("tree");
            };
            text += filled(page["claim"].value_or(""),
                           {{"way", step > 0.0 ? "With steps" : "From event to event"},
                            {"segments_win", in_cells(some, segments_win)},
                            {"delaunay_is_slowest", in_cells(some, is_slowest)},
                            {"cells_before_tree", in_cells(some, cells_before_tree)}})
                        .value();
        }
        return text;
    }
};

Values packing_words(const Motion& motion, double size_ratio) {
    const Cells cells =
        motion.cells("packing", [&](const Setting& cell) { return cell.size_ratio == size_ratio; });
    if (cells.empty()) return {};
    const auto value = [&](double packing, const char* experiment, double step,
                           const std::string& contestant, const char* quantity) {
        return motion.results.value({.experiment = experiment,
                                     .count = 100,
                                     .size_ratio = size_ratio,
                                     .packing = packing,
                                     .time_step = step},
                                    contestant, quantity);
    };
    const auto line = [&](std::string name, const auto& of_packing, const char* tag = "td") {
        std::vector<std::string> text = {std::move(name)};
        for (const toml::node& each : *motion.page["thesis_packings"].as_array())
            text.push_back(of_packing(each.value_or(0.0)));
        return table_line(text, "th", tag);
    };
    const auto counts = [&](const char* name, const char* experiment, double step,
                            const char* quantity) {
        return line(name, [&](double packing) {
            return shown(value(packing, experiment, step, "auto", quantity));
        });
    };
    const auto efforts = [&](const std::string& name, const char* experiment, double step,
                             const std::string& structure, const char* format) {
        return line(name, [&](double packing) {
            const auto in_words = [&](const char* quantity, const char* as) {
                return shown(value(packing, experiment, step, structure, quantity), as);
            };
            return fmt::format("{}; {}; {}", in_words("seconds", format), in_words("own", "{:.0f}"),
                               in_words("checks", "{:.0f}"));
        });
    };
    Values values = {{"packings", line("packing", in_percent, "th")},
                     {"claims", motion.claims(cells)}};
    std::size_t number = 0;
    const toml::array& radii =
        *motion.page["thesis_radii"][size_ratio == 1.0 ? "one_size" : "many_sizes"].as_array();
    values["counts"] =
        line("radii, thesis", [&](double) { return radii[number++].value_or(std::string()); }) +
        counts("strikes, thesis", "thesis", thesis_step, "strikes") +
        counts("strikes, steps", "packing", thesis_step, "strikes") +
        counts("strikes, events", "packing", 0.0, "strikes") +
        counts("predictions, thesis", "thesis", thesis_step, "predictions") +
        counts("predictions, steps", "packing", thesis_step, "predictions");
    for (const std::string& name : motion.structures) {
        if (const auto theirs = motion.page["thesis_names"][name].value<std::string>())
            values["efforts"] += efforts(*theirs, "thesis", thesis_step, name, "{:.0f}");
        values["efforts"] += efforts(name + ", steps", "packing", thesis_step, name, "{:.3g}") +
                             efforts(name + ", events", "packing", 0.0, name, "{:.3g}");
    }
    // None of them was stopped early.
    bool are_alike = true;
    for (const Setting& cell : cells)
        for (const std::string& name : motion.structures)
            for (const char* const quantity : {"strikes", "digest"}) {
                const auto of_one = motion.results.value(cell, name, quantity);
                are_alike &= !of_one || of_one == motion.results.value(cell, "auto", quantity);
            }
    values["alike"] = are_alike ? "the same in every cell" : "<strong>not the same</strong>";
    return values;
}

/// The power of the number of balls with which the time of steps grows, over the last doubling.
std::optional<double> growth_of_time(const Motion& motion, const std::string& structure) {
    std::map<double, double> seconds;  // by the number of balls
    for (const Setting& cell : motion.cells("number"))
        if (const auto value = motion.results.value(cell, structure, "seconds");
            value && cell.time_step == thesis_step)
            seconds[static_cast<double>(cell.count)] = *value;
    for (const auto& [balls, value] : seconds) {
        const auto& [most, last] = *seconds.rbegin();
        if (2.0 * balls <= most * 1.2 && 2.5 * balls >= most)
            return std::log(last / value) / std::log(most / balls);
    }
    return std::nullopt;
}

Values number_words(const Motion& motion) {
    const Cells cells = motion.cells("number");
    if (cells.empty()) return {};
    Values values = {{"lines", ""}, {"growth", ""}, {"claims", motion.claims(cells)}};
    for (const Setting& thesis : motion.cells("thesis numbers")) {
        std::optional<Setting> stepped;
        std::optional<Setting> free;
        for (const Setting& cell : cells)
            if (cell.count == thesis.count) (cell.time_step > 0.0 ? stepped : free) = cell;
        if (!stepped || !free) continue;
        const auto count = [&](const Setting& cell, const char* quantity) {
            return shown(motion.results.value(cell, "auto", quantity));
        };
        values["lines"] +=
            table_line({fmt::format("{}", thesis.count), fmt::format("{} %", thesis.packing),
                        fmt::format("{:.1f} %", 100.0 * free->packing), count(thesis, "strikes"),
                        count(*stepped, "strikes"), count(*free, "strikes"),
                        count(thesis, "predictions"), count(*stepped, "predictions")},
                       "th");
    }
    std::string& growth = values["growth"];
    for (const std::string& name : motion.structures)
        if (const auto power = growth_of_time(motion, name))
            growth +=
                fmt::format("{}<code>{}</code> {:.1f}", growth.empty() ? "" : ", ", name, *power);
    return values;
}

Values large_words(const Motion& motion) {
    const Cells cells =
        motion.cells("large", [](const Setting& cell) { return cell.time_step == 0.0; });
    if (cells.empty()) return {};
    return {{"segments_are_slowest", motion.in_cells(cells, [](const Ranking& ranks) {
                 return ranks.slowest_optimization() == "segments";
             })}};
}

/// Of cells how many are near to the best, and which one is the worst.
struct Nearness {
    int all = 0;
    int near = 0;
    double worst = 0.0;
    std::string worst_cell;

    void add(double factor, double near_enough, const Setting& cell) {
        ++all;
        near += factor <= near_enough ? 1 : 0;
        if (factor > worst) worst_cell = words_for(cell);
        worst = std::max(worst, factor);
    }
    void put(Values& values, const std::string& of) const {
        if (all == 0) return;
        values[of + "_cells"] = std::to_string(all);
        values[of + "_near"] = std::to_string(near);
        values[of + "_worst"] = fmt::format("{:.2f}", worst);
        values[of + "_worst_cell"] = worst_cell;
    }
};

Values choice_words(const Motion& motion) {
    Nearness of_auto;
    Nearness of_levels;  // where sizes are many and balls dense
    Values values;
    for (const char* experiment : {"packing", "number", "large"})
        for (const Setting& cell : motion.cells(experiment)) {
            const auto ranks = motion.ranking(cell);
            if (!ranks) continue;
            of_auto.add(ranks->factor.at("auto"), 1.2, cell);
            std::optional<double> levels;
            if (ranks->factor.contains("levels")) levels = ranks->factor.at("levels");
            if (levels && cell.size_ratio >= 10.0 && cell.packing >= 0.33)
                of_levels.add(*levels, 1.1, cell);
            values["lines"] +=
                table_line({words_for(cell), ranks->fastest, ranks->chosen,
                            shown(ranks->factor.at("auto"), "{:.2f}"), shown(levels, "{:.2f}")},
                           "th");
        }
    of_auto.put(values, "auto");
    of_levels.put(values, "levels");
    return values;
}

Values why_words(const Motion& motion) {
    const Cells cells = motion.cells("packing");
    if (cells.empty()) return {};
    const Cells thesis = motion.cells("thesis");
    const auto difference = [&](const char* quantity) {
        return *motion.results.value(thesis[0], "pairs", quantity) -
               *motion.results.value(thesis[0], "segments", quantity);
    };
    const double of_check = difference("seconds") / difference("checks");
    // In how many cells segments ask the fewest pairs of the thesis's structures, and cells as many
    // as all pairs are.
    int all = 0;
    int fewest = 0;
    int as_many = 0;
    // How many times as long pairs take as the fastest, from the least to the most.
    std::map<bool, std::pair<double, double>> times = {{false, {unbounded, 0.0}},
                                                       {true, {unbounded, 0.0}}};
    for (const Setting& cell : cells) {
        const auto checks = [&](const char* name) {
            return motion.results.value(cell, name, "checks");
        };
        if (const auto a = checks("segments"), b = checks("cells"), c = checks("pairs");
            a && b && c) {
            ++all;
            fewest += *a <= std::min(*b, *c) ? 1 : 0;
            as_many += *b >= 0.9 * *c ? 1 : 0;
        }
        const auto ranks = motion.ranking(cell);
        if (!ranks || !ranks->factor.contains("pairs")) continue;
        auto& [least, most] = times[cell.time_step > 0.0];
        least = std::min(least, ranks->factor.at("pairs"));
        most = std::max(most, ranks->factor.at("pairs"));
    }
    const auto in_words = [&](bool with_steps) {
        const auto& [least, most] = times[with_steps];
        return most > 0.0 ? fmt::format("{:.2g} to {:.2g} times", least, most) : "–";
    };
    return {{"microseconds", fmt::format("{:.0f}", 1e6 * of_check)},
            {"cycles", fmt::format("{:.0f}", 166e6 * of_check)},
            {"cells", std::to_string(all)},
            {"fewest", std::to_string(fewest)},
            {"as_many", std::to_string(as_many)},
            {"times_of_events", in_words(false)},
            {"times_of_steps", in_words(true)}};
}

Values cost_words(const Motion& motion) {
    double least = unbounded;
    double most = 0.0;
    for (const Setting& cell : motion.cells("accuracy"))
        if (const auto ratio = motion.results.value(cell, "exact", "ratio")) {
            least = std::min(least, *ratio);
            most = std::max(most, *ratio);
        }
    return {{"least", fmt::format("{:.2f}", least)}, {"most", fmt::format("{:.2f}", most)}};
}

Values wrong_words(const Motion& motion) {
    const Cells cells = motion.cells("accuracy");
    if (cells.empty()) return {};
    std::string lines;
    int other = 0;
    int broken = 0;
    int lost = 0;
    double deepest_exact = 0.0;
    double deepest_naive = 0.0;
    for (const Setting& cell : cells) {
        const auto value = [&](const char* contestant, const std::string& quantity) {
            return motion.results.value(cell, contestant, quantity);
        };
        const bool is_broken = value("naive", std::string(broken_percent)).value_or(0.0) > 0.0;
        other += value("naive", "first_other_strike") ? 1 : 0;
        broken += is_broken ? 1 : 0;
        lost += value("naive", "lost").value_or(0.0) > 0.0 ? 1 : 0;
        for (const char* quantity : {"overlap", "wall_overlap"}) {
            deepest_exact = std::max(deepest_exact, value("exact", quantity).value_or(0.0));
            deepest_naive = std::max(deepest_naive, value("naive", quantity).value_or(0.0));
        }
        const char* brief = "{:.2g}";
        lines += table_line({words_for(cell) + (is_broken ? ", plain does not end" : ""),
                             shown(value("exact", "strikes")), shown(value("naive", "strikes")),
                             shown(value("naive", "first_other_strike")),
                             shown(value("naive", "first_other_strike_time"), brief),
                             shown(value("exact", "overlap"), brief),
                             shown(value("naive", "overlap"), brief),
                             shown(value("exact", "wall_overlap"), brief),
                             shown(value("naive", "wall_overlap"), brief),
                             shown(value("exact", "lost")), shown(value("naive", "lost"))});
    }
    return {{"other", std::to_string(other)},
            {"cells", std::to_string(cells.size())},
            {"broken", std::to_string(broken)},
            {"lost", std::to_string(lost)},
            {"deepest_exact", fmt::format("{:.2g}", deepest_exact)},
            {"deepest_naive", fmt::format("{:.2g}", deepest_naive)},
            {"lines", lines}};
}

Values time_step_words(const Motion& motion) {
    std::map<double, Cells> cells;  // by packing
    for (const Setting& cell : motion.cells("time_steps")) cells[cell.packing].push_back(cell);
    if (cells.empty()) return {};
    std::string lines;
    int within = 0;
    int finest_cells = 0;
    for (const auto& [packing, some] : cells) {
        const auto free = std::ranges::find(some, 0.0, &Setting::time_step);
        if (free == some.end()) continue;
        double finest = 1.0;
        for (const Setting& cell : some)
            if (cell.time_step > 0.0) finest = std::min(finest, cell.time_step);
        for (const Setting& cell : some) {
            const bool has_steps = cell.time_step > 0.0;
            std::vector<std::string> line = {in_percent(packing),
                                             has_steps ? fmt::format("{}", cell.time_step) : "–"};
            for (const char* quantity : {"all_strikes", "mean_energy"}) {
                const auto value = motion.results.interval(cell, "auto", quantity);
                const auto base = motion.results.interval(*free, "auto", quantity);
                if (!value || !base) continue;
                const double difference = value->median - base->median;
                const double error =
                    0.5 * std::hypot(value->high - value->low, base->high - base->low);
                if (cell.time_step == finest) {
                    ++finest_cells;
                    within += std::fabs(difference) <= 2.0 * error ? 1 : 0;
                }
                line.push_back(fmt::format("{:.4g} ± {:.2g}", value->median,
                                           0.5 * (value->high - value->low)));
                line.push_back(has_steps ? fmt::format("{:+.2g} ± {:.2g}", difference, error) : "");
            }
            lines += table_line(line);
        }
    }
    return {{"within", std::to_string(within)},
            {"finest_cells", std::to_string(finest_cells)},
            {"lines", lines}};
}

}  // namespace

std::vector<Row> thesis_rows(const toml::table& page) {
    std::vector<Row> rows;
    const auto add = [&](const Setting& cell, const std::string& contestant,
                         const std::string& quantity, double value) {
        rows.push_back({cell, contestant, quantity, {value, value, value, 1}});
    };
    Setting cell = {"thesis", "", "", 100};
    cell.time_step = thesis_step;
    for (const toml::node& each : *page["thesis"].as_array()) {
        const toml::array& line = *each.as_array();
        cell.size_ratio = line[0].value_or(0.0);
        for (std::size_t i = 3; i < line.size(); ++i) {
            cell.packing = page["thesis_packings"][i - 3].value_or(0.0);
            add(cell, line[1].value_or(""), line[2].value_or(""), line[i].value_or(0.0));
        }
    }
    cell.experiment = "thesis numbers";
    for (const toml::node& each : *page["thesis_numbers"].as_array()) {
        const toml::array& line = *each.as_array();
        cell.count = line[0].value_or(std::int64_t{0});
        cell.packing = line[1].value_or(0.0);
        add(cell, "auto", "strikes", line[2].value_or(0.0));
        add(cell, "auto", "predictions", line[3].value_or(0.0));
    }
    return rows;
}

Values words_of(const std::string& figure, const toml::table& page, const std::vector<Row>& rows) {
    const Motion motion(page, rows);
    if (figure == "packing_one_size") return packing_words(motion, 1.0);
    if (figure == "packing_many_sizes") return packing_words(motion, 10.0);
    using Words = Values (*)(const Motion&);
    static const std::map<std::string, Words> all = {
        {"number", number_words},       {"large", large_words},
        {"choice", choice_words},       {"why", why_words},
        {"cost", cost_words},           {"wrong", wrong_words},
        {"time_steps", time_step_words}};
    const auto found = all.find(figure);
    return found == all.end() ? Values() : found->second(motion);
}

}  // namespace signum::study
