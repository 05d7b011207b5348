#include "scene_page.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "template.hpp"

namespace signum::study {
namespace {

std::string with_unit(std::string_view name, const std::string& unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

struct JudgementWords {
    Judgement judgement;
    const char* name;
    const char* words;
};
constexpr std::array<JudgementWords, 3> judgements = {
    {{Judgement::good, "good", "good"},
     {Judgement::not_good, "not_good", "not good"},
     {Judgement::not_told, "not_told", "not told: too few data"}}};

}  // namespace

std::vector<Plot> plots_of_scene(const SceneDescription& scene, const SceneCurves& curves) {
    std::vector<Plot> plots;
    const std::span<const Moment> all = curves.moments;
    if (all.size() < 2) return plots;
    constexpr std::size_t most = 500;
    std::size_t every = 1;
    while (all.size() / every > most) every *= 2;
    std::vector<Moment> moments;
    for (std::size_t i = 0; i < all.size(); i += every) moments.push_back(all[i]);
    const std::string time = with_unit("time", scene.time);

    const auto plot = [&](std::string name, std::string x, std::string title) -> Panel& {
        Panel& panel = plots.emplace_back(Plot{std::move(name), 1, {Panel{}}}).panels.front();
        panel.x_label = std::move(x);
        panel.title = std::move(title);
        return panel;
    };
    const auto add = [](Panel& panel, std::string title, std::vector<PlotPoint> points) {
        const int style = static_cast<int>(panel.series.size()) + 1;
        panel.series.push_back({std::move(title), style, true, std::move(points), false});
    };
    const auto over_time = [&](const std::function<double(const Moment&)>& value) {
        std::vector<PlotPoint> points;
        for (const Moment& moment : moments) {
            const double y = value(moment);
            points.push_back({moment.time, y, y, y});
        }
        return points;
    };

    Panel& energies = plot("energies", time, with_unit("energy", scene.energy));
    add(energies, "kinetic", over_time([](const Moment& each) { return each.kinetic; }));
    if (curves.has_spin)
        add(energies, "rotational", over_time([](const Moment& each) { return each.spin; }));
    if (curves.has_height)
        add(energies, "potential",
            over_time([](const Moment& each) { return each.total - each.kinetic - each.spin; }));
    if (energies.series.size() > 1)
        add(energies, "total", over_time([](const Moment& each) { return each.total; }));
    // What falls by powers of ten shows it on a logarithmic axis; what stays, on one from 0.
    const auto [least, largest] = std::ranges::minmax(moments, {}, &Moment::kinetic);
    constexpr double much = 100.0;
    if (!curves.has_height && least.kinetic > 0.0 && largest.kinetic > much * least.kinetic)
        energies.y_is_log = true;
    else if (!curves.has_height)
        energies.y_least = 0.0;

    Panel& strikes = plot(
        "strikes", time,
        scene.time.empty() ? "strikes a unit of time" : fmt::format("strikes in 1 {}", scene.time));
    std::vector<PlotPoint> rates;
    for (std::size_t i = 1; i < moments.size(); ++i) {
        const double span = moments[i].time - moments[i - 1].time;
        if (!(span > 0.0)) continue;
        const double rate = static_cast<double>(moments[i].strikes - moments[i - 1].strikes) / span;
        rates.push_back({moments[i].time - 0.5 * span, rate, rate, rate});
    }
    add(strikes, "strikes", std::move(rates));
    strikes.y_least = 0.0;

    if (!curves.pairs.empty()) {
        Panel& pairs = plot("pairs", with_unit("distance r", scene.length),
                            "pair correlation g(r): pairs at a distance, 1 at random");
        std::vector<PlotPoint> points;
        for (const auto& [r, g] : curves.pairs) points.push_back({r, g, g, g});
        add(pairs, "second half of the run", std::move(points));
        pairs.y_least = 0.0;
    }
    if (curves.has_growth && moments.front().packing > 0.0) {
        Panel& packing = plot("packing", time, "packing: the share of the box that balls fill");
        add(packing, "packing", over_time([](const Moment& each) { return each.packing; }));
    }
    return plots;
}

std::string scene_page(const SceneDescription& scene, const std::vector<Check>& checks,
                       Values values) {
    values["all"] = std::to_string(checks.size());
    for (const auto& [judgement, name, words] : judgements) {
        const auto count = std::ranges::count(checks, judgement, &Check::judgement);
        values[name] = count > 0 || judgement == Judgement::good ? std::to_string(count) : "";
    }
    std::string& lines = values["checks"];
    for (const Check& check : checks) {
        const auto* const judged =
            std::ranges::find(judgements, check.judgement, &JudgementWords::judgement);
        lines += html_of("check", {{"what", html_text(check.what)},
                                   {"expected", html_text(check.expected)},
                                   {"found", html_text(check.found)},
                                   {"deviation", html_text(check.deviation)},
                                   {"name", judged->name},
                                   {"words", judged->words}});
    }
    values["title"] = html_text(scene.title.empty() ? "Balls that move and strike" : scene.title);
    values["head"] = html_of("head", {{"title", values["title"]}});
    values["explanation"] = html_text(scene.explanation);
    return html_of("scene", values);
}

}  // namespace signum::study
