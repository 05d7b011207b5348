#pragma once
/// What is said of a simulation when it is over: statistics, and a page.

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../motion/simulation.hpp"
#include "../io/motion_state.hpp"
#include "../scenes/checks.hpp"
#include "../scenes/energy.hpp"
#include "../scenes/pair_correlation.hpp"
#include "../scenes/run_record.hpp"
#include "../study/scene_page.hpp"

namespace signum::cli {

/// What the statistics tell beside the counts.
template <int D>
struct Summary {
    const MotionState<D>& start;
    const MotionState<D>& end;
    motion::Choice choice;
    motion::Counts counts;
    double seconds = 0.0;
};

/// Z = p V / (N k T) from the virial of the strikes; none under gravity, of no time and of no
/// motion.
template <int D>
[[nodiscard]] std::optional<double> compressibility(const Summary<D>& summary) {
    const Energy<D> before(summary.start.state, summary.start.effects, summary.start.state.time);
    const Energy<D> after(summary.end.state, summary.end.effects, summary.end.state.time);
    const double time = summary.end.state.time - summary.start.state.time;
    const double kinetic = before.kinetic + after.kinetic;
    if (summary.start.effects.gravity != motion::Vector<D>{} || !(time > 0.0) || !(kinetic > 0.0))
        return std::nullopt;
    return 1.0 + summary.counts.virial / (kinetic * time);
}

/// As JSON, one line.
template <int D>
[[nodiscard]] std::string statistics_of(const Summary<D>& summary) {
    const Energy<D> before(summary.start.state, summary.start.effects, summary.start.state.time);
    const Energy<D> after(summary.end.state, summary.end.effects, summary.end.state.time);
    const motion::Counts& counts = summary.counts;
    const std::optional<double> z = compressibility(summary);
    return fmt::format(
        "{{\"balls\": {}, \"strikes\": {}, \"checks\": {}, \"own\": {}, \"stale\": {}, \"stages\": "
        "{{\"filter\": {}, \"exact\": {}, \"multiprecision\": {}}}, \"seconds\": {}, "
        "\"structure\": \"{}\", \"why\": \"{}\", \"time\": {}, \"energy_start\": {}, "
        "\"energy_end\": {}, \"pressure\": {}}}\n",
        summary.end.state.balls.size(), counts.strikes, counts.checks, counts.own, counts.stale,
        counts.checks - std::min(counts.checks, counts.exact), counts.refined, counts.exact,
        summary.seconds, motion::name_of(summary.choice.structure), summary.choice.why,
        summary.end.state.time, before.total, after.total,
        z ? fmt::format("{}", *z) : std::string("null"));
}

/// How a run ended.
[[nodiscard]] inline std::string_view in_words(motion::Ending ending) {
    constexpr std::string_view words[] = {"the time came", "the strikes are done",
                                          "nothing meets any more", "interrupted", "a collapse"};
    static_assert(std::size(words) == static_cast<int>(motion::Ending::collapse) + 1);
    return words[static_cast<int>(ending)];
}

/// The last strike of a collapse, and what would let such balls go on, if there is something.
template <int D>
[[nodiscard]] std::string describe_collapse(const motion::Strike& last,
                                            const motion::Effects<D>& effects) {
    const bool loses =
        effects.restitution < 1.0 || effects.wall_restitution < 1.0 || effects.speed_law;
    std::string_view remedy;
    if (effects.growth)
        remedy = "; let effects.growth end earlier";
    else if (effects.contacts)
        remedy = "";
    else if (loses && effects.contact_duration == 0.0)
        remedy =
            "; with effects.contact_duration, or effects.contacts and run.time_step, such balls go "
            "on";
    else if (loses || effects.gravity != motion::Vector<D>{})
        remedy = "; with effects.contacts and run.time_step balls may lie still";
    return fmt::format(
        "at time {} ball {} and {} {} strike without end: an inelastic collapse, a jam, a gap "
        "that walls close, or a ball that lies still; the log up to there is complete{}",
        last.time, last.a, last.wall ? "wall" : "ball", last.b, remedy);
}

[[nodiscard]] inline std::string with_unit(std::string number, const std::string& unit) {
    return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

/// Lines of a table of the run.
template <int D>
[[nodiscard]] std::string table_of(const study::SceneDescription& scene,
                                   const Summary<D>& summary) {
    const auto energy = [&](const MotionState<D>& of) {
        return with_unit(
            fmt::format("{:.6g}", Energy<D>(of.state, of.effects, of.state.time).total),
            scene.energy);
    };
    std::vector<std::pair<std::string, std::string>> rows = {
        {"balls", fmt::format("{}", summary.end.state.balls.size())},
        {"strikes", fmt::format("{}", summary.counts.strikes)},
        {"structure",
         fmt::format("{}: {}", motion::name_of(summary.choice.structure), summary.choice.why)},
        {"time at the end", with_unit(fmt::format("{:.6g}", summary.end.state.time), scene.time)},
        {"seconds of computing", fmt::format("{:.3g}", summary.seconds)},
        {"energy at the start", energy(summary.start)},
        {"energy at the end", energy(summary.end)}};
    // Elsewhere strikes are not all that presses, or T is not one number.
    if (const auto z = compressibility(summary);
        z && summary.start.effects.periodic && summary.start.effects.restitution == 1.0)
        rows.push_back({"pressure, Z = pV/NkT", fmt::format("{:.4f}", *z)});
    if (summary.start.effects.contacts) {
        rows.push_back({"contacts that stand at the end",
                        fmt::format("{}", summary.end.state.contacts.size())});
        rows.push_back({"contacts that began to stand, and that ended",
                        fmt::format("{}, {}", summary.counts.joins, summary.counts.breaks)});
        rows.push_back({"time steps whose reactions stayed above the tolerance",
                        fmt::format("{}", summary.counts.unsolved)});
    }
    std::string lines;
    for (const auto& [name, value] : rows)
        lines += study::table_line({study::html_text(name), study::html_text(value)}, "th");
    return lines;
}

/// The page of a run, as HTML; without curves where gnuplot is not there, which the page says.
/// Throws MachineError where it fails.
template <int D>
[[nodiscard]] std::string page_of_run(const study::SceneDescription& scene, std::string film,
                                      const RunRecord<D>& record,
                                      std::vector<PairCorrelation::Shell> pairs,
                                      const Summary<D>& summary) {
    const motion::Effects<D>& effects = record.effects();
    std::vector<Check> checks;
    if (!record.moments().empty()) checks = check_run(record);
    study::Values values = {{"film", std::move(film)},
                            {"run", table_of(scene, summary)},
                            {"curves", ""},
                            {"without_curves", ""}};
    if (!study::has_gnuplot()) {
        values["without_curves"] =
            "gnuplot draws them, and was not there: install it (Debian: apt-get install "
            "gnuplot-nox) and run the scene again";
        return study::scene_page(scene, checks, values);
    }
    study::SceneCurves curves;
    curves.moments = record.moments();
    curves.has_spin = effects.friction.has_value();
    curves.has_height = effects.gravity != motion::Vector<D>{};
    curves.has_growth = effects.growth.has_value();
    curves.pairs = std::move(pairs);
    for (const study::Plot& plot : study::plots_of_scene(scene, curves)) {
        const std::string svg = study::inline_svg(
            study::drawn_by_gnuplot(study::gnuplot_script(plot)), plot.name,
            fmt::format("{} over {}", plot.panels[0].title, plot.panels[0].x_label));
        values["curves"] += fmt::format("<figure>\n{}\n</figure>\n", svg);
    }
    if (values["curves"].empty()) values["without_curves"] = "A curve needs two frames.";
    return study::scene_page(scene, checks, values);
}

}  // namespace signum::cli
