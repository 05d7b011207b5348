#include "scene_page.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

#include <fmt/format.h>

#include "html.hpp"

namespace signum::study {
namespace {

std::string with_unit(std::string_view name, const std::string& unit) {
    return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

std::string_view in_words(Judgement judgement) {
    switch (judgement) {
        case Judgement::good:
            return "good";
        case Judgement::not_good:
            return "not good";
        case Judgement::not_told:
            break;
    }
    return "not told: too few data";
}
std::string_view class_of(Judgement judgement) {
    return judgement == Judgement::good       ? "good"
           : judgement == Judgement::not_good ? "not_good"
                                              : "not_told";
}

std::string table_of_checks(const std::vector<Check>& checks) {
    std::string text =
        "<table "
        "class=\"run\">\n<tr><th>what</th><th>expected</th><th>found</th><th>deviation</th><th></"
        "th>"
        "</tr>\n";
    for (const Check& check : checks)
        text += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>\n",
            html_text(check.what), html_text(check.expected), html_text(check.found),
            html_text(check.deviation), class_of(check.judgement), in_words(check.judgement));
    return text + "</table>\n";
}

std::string summary_of_checks(const std::vector<Check>& checks) {
    const auto count = [&](Judgement judgement) {
        return std::ranges::count(checks, judgement, &Check::judgement);
    };
    std::string text = fmt::format("{} of {} are good", count(Judgement::good), checks.size());
    if (const auto bad = count(Judgement::not_good); bad > 0)
        text += fmt::format(", <strong class=\"not_good\">{} not</strong>", bad);
    if (const auto open = count(Judgement::not_told); open > 0)
        text += fmt::format(", {} not told", open);
    return text + ".";
}

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
        Panel panel;
        panel.x_label = std::move(x);
        panel.title = std::move(title);
        plots.push_back({std::move(name), 1, {std::move(panel)}});
        return plots.back().panels.front();
    };
    const auto add = [](Panel& panel, std::string title, std::vector<PlotPoint> points) {
        Series series;
        series.title = std::move(title);
        series.style = static_cast<int>(panel.series.size()) + 1;
        series.marked = false;
        series.points = std::move(points);
        panel.series.push_back(std::move(series));
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

std::string html_of(const ScenePage& page) {
    const std::string title =
        html_text(page.scene.title.empty() ? "Balls that move and strike" : page.scene.title);
    std::string text = fmt::format("{}<h1>{}</h1>\n", html_head(title), title);
    text += fmt::format("<figure class=\"film\">\n{}\n</figure>\n", page.film);
    text += fmt::format(
        "<h2>Beside what is known</h2>\n<p>{} Each stands here only where what it expects "
        "holds.</p>\n{}",
        summary_of_checks(page.checks), table_of_checks(page.checks));
    text += "<h2>The run</h2>\n<table class=\"run\">\n";
    for (const auto& [name, value] : page.run)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", html_text(name), html_text(value));
    text += "</table>\n<h2>Curves</h2>\n";
    if (!page.without_curves.empty())
        text += fmt::format("<p class=\"soft\">{}</p>\n", html_text(page.without_curves));
    for (const std::string& curve : page.curves)
        text += fmt::format("<figure>\n{}\n</figure>\n", curve);
    if (!page.scene.explanation.empty())
        text +=
            fmt::format("<h2>The scene</h2>\n<pre>{}</pre>\n", html_text(page.scene.explanation));
    return text + "</body>\n</html>\n";
}

}  // namespace signum::study
