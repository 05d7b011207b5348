#include "figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "../../triangulation/metric.hpp"

#include "results.hpp"

namespace signum::study {
namespace {

const Names four = {"random", "circle", "square", "grid"};
const Names eight = {"random", "circle", "square", "grid", "lattice", "rings", "offset", "tangent"};
const Names hard = {"random", "circle", "rings", "lattice", "offset", "tangent"};
const Names metrics = [] {
    Names names;
    for (const Metric metric : all_metrics) names.emplace_back(name_of(metric));
    return names;
}();

/// A distribution, a metric and an arithmetic look the same in all figures.
int style_of(const std::string& name) {
    static const std::array<Names, 3> families = {
        eight, metrics, Names{"exact", "naive", "single", "interval", "sum", "multiprecision"}};
    for (const Names& family : families) {
        const auto found = std::find(family.begin(), family.end(), name);
        if (found != family.end()) return static_cast<int>(found - family.begin()) + 1;
    }
    return 1;
}

std::string capital(std::string name) {
    if (!name.empty()) name[0] = static_cast<char>(std::toupper(name[0]));
    return name;
}

/// Two columns of panels, a metric a row: the same quantity of two contestants.
struct Column {
    std::string contestant;
    std::string title;
    std::vector<PlotPoint> thesis;  ///< in the power metric
};

struct Pair {
    std::string name;
    std::string experiment;
    std::string quantity;
    std::string x_label;
    std::string y_label;
    Where where;
    Names distributions;
    std::array<Column, 2> columns;
    bool y_is_log = false;
};

Plot pairs_of_panels(const Results& results, const Pair& pair) {
    Plot plot{pair.name, 2, {}};
    for (const std::string& metric : results.present(pair.experiment, metrics))
        for (const Column& column : pair.columns) {
            Panel panel;
            panel.title = capital(metric) + ": " + column.title;
            panel.x_label = pair.x_label;
            panel.y_label = pair.y_label;
            panel.x_is_log = true;
            panel.y_is_log = pair.y_is_log;
            if (!pair.y_is_log) panel.y_least = 0.0;
            for (const std::string& distribution : pair.distributions) {
                const Query query = {pair.experiment, metric, distribution, column.contestant,
                                     pair.quantity};
                panel.series.push_back({distribution, style_of(distribution), true,
                                        results.points(query, pair.where)});
            }
            // The thesis counts every edge that the exact result does not have.
            if (pair.quantity == "wrong_percent")
                panel.series.push_back(
                    {"grid with ties", 8, true,
                     results.points({pair.experiment, metric, "grid", column.contestant,
                                     "wrong_or_different_percent"},
                                    pair.where)});
            if (metric == "power") panel.quoted = {"the thesis", column.thesis};
            plot.panels.push_back(std::move(panel));
        }
    return plot;
}

PlotPoint quoted(double x, double y) {
    return {x, y, y, y};
}

Figure margin(const Results& results) {
    Plot plot{"margin", 2, {}};
    constexpr std::string_view prefix = "margin_1e";
    constexpr double zero = 1e-23;
    for (const std::string& metric : results.present("margin", metrics)) {
        Panel panel;
        panel.title = capital(metric);
        panel.x_label = "distance from zero, relative";
        panel.y_label = "% of the questions";
        panel.x_is_log = true;
        panel.y_is_log = true;
        panel.place_of_zero = zero;
        panel.uprights = {{1e-15, "doubles"}, {1e-6, "single"}};
        for (const std::string& distribution : eight) {
            Series series{distribution, style_of(distribution), true, {}};
            for (const Row* row : results.all({"margin", metric, distribution, "", ""})) {
                const double y = row->value.median;
                double x = zero;
                if (row->quantity.starts_with(prefix))
                    x = std::pow(10.0, std::stod(row->quantity.substr(prefix.size())) - 0.5);
                else if (row->quantity != "margin_ties")
                    continue;
                series.points.push_back({x, y, y, y});
            }
            std::sort(series.points.begin(), series.points.end(),
                      [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
            panel.series.push_back(std::move(series));
        }
        plot.panels.push_back(std::move(panel));
    }
    return {std::move(plot), "The margin of truth: how near to zero?",
            "<p>Every question about a circle is the sign of one number. For the edges of exact "
            "tessellations it was computed without rounding, and divided by the size of its terms: "
            "1 is as far "
            "from zero as can be. What lies left of a dashed line can get the wrong sign in that "
            "arithmetic: in doubles below about 10<sup>−15</sup>, in single precision below about "
            "10<sup>−6</sup>. Exact zeros stand at the left end.</p>"
            "<p><strong>Do you need exactness?</strong> If your input looks like <em>random</em>, "
            "doubles mostly do. If it "
            "looks like any other curve, they do not.</p>",
            "Histograms of the determinants' relative distance from zero, by distribution"};
}

Figure first_error(const Results& results) {
    Plot plot =
        pairs_of_panels(results, {"first_error",
                                  "first_error",
                                  "first_error",
                                  "sites",
                                  "perturbation",
                                  by_sites,
                                  four,
                                  {{{"naive", "doubles", {}}, {"single", "single precision", {}}}},
                                  true});
    return {
        std::move(plot), "When does plain arithmetic first err?",
        "<p>Sites in a perfect pattern are moved by chance, by up to the perturbation. The "
        "larger it is, the farther from zero are the determinants. Drawn is the greatest "
        "power of ten at which plain arithmetic still made a wrong edge: above the line it made "
        "none on these sets. The square is 700 wide. No mark: no error at any "
        "perturbation.</p>",
        "The greatest perturbation at which rounded arithmetic errs, against the number of "
        "sites"};
}

Figure wrong_by_sites(const Results& results) {
    Plot plot = pairs_of_panels(
        results, {"wrong_by_sites",
                  "sites",
                  "wrong_percent",
                  "sites",
                  "wrong edges, %",
                  by_sites,
                  four,
                  {{{"single", "single precision", {quoted(1000, 1), quoted(1000, 30)}},
                    {"naive", "doubles", {}}}}});
    return {
        std::move(plot), "Wrong edges against the number of sites (thesis: figure 4.7.3)",
        "<p>How many edges of the tessellation are wrong when its signs are computed with "
        "rounding. "
        "Left in single precision, the arithmetic of the thesis’s time; right in doubles. The "
        "thesis states about 1 % for random sites and 30 % for the circle. It computes with the "
        "coordinates as they are; here differences to one of the sites are taken first, which "
        "spares random sites nearly all errors.</p><p>On a grid "
        "every square is a tie, and either of its diagonals is right. Only one is what the tie "
        "rule chooses; the thesis counts the other one as wrong, and a line of its own does so "
        "here. The bars reach from "
        "the least to the greatest of several sets. Where arithmetic lost its way altogether, "
        "nothing is drawn.</p>",
        "Percentage of wrong edges against sites, circle above square and grid above random"};
}

Figure wrong_by_perturbation(const Results& results) {
    Plot plot = pairs_of_panels(
        results,
        {"wrong_by_perturbation",
         "perturbation",
         "wrong_percent",
         "perturbation",
         "wrong edges, %",
         by_perturbation,
         four,
         {{{"single", "single precision", {quoted(1e-9, 50)}}, {"naive", "doubles", {}}}}});
    return {
        std::move(plot), "Wrong edges against the perturbation (thesis: figure 4.7.5)",
        "<p>The same for 100 sites that were moved by chance. The thesis: almost "
        "50 % on the circle at a perturbation of 10<sup>−9</sup>. What is moved farther than the "
        "arithmetic rounds comes out right.</p>",
        "Percentage of wrong edges against the perturbation of 100 sites"};
}

Figure ratio_by_sites(const Results& results) {
    Plot plot = pairs_of_panels(
        results,
        {"ratio_by_sites",
         "sites",
         "ratio",
         "sites",
         "time, exact to plain",
         by_sites,
         four,
         {{{"interval", "the thesis's scheme", {quoted(1000, 4)}}, {"exact", "signum", {}}}}});
    return {
        std::move(plot), "What exactness costs against the number of sites (figure 4.7.2)",
        "<p>The time of the exact construction divided by that in plain doubles: 1 is no cost at "
        "all. Left the scheme of the thesis, interval arithmetic and exact arithmetic behind it; "
        "right "
        "signum’s stages. The thesis states that the ratio tends to 4 for random sites, and is "
        "much "
        "higher for the circle than for all others. There a sum of up to 288 terms stood behind "
        "the intervals; here "
        "what stands behind them is cheap, so that on the left the intervals themselves are what "
        "costs, and patterns differ less. Random discs keep radii of 1 to 10 in a square 700 wide: "
        "of "
        "100 000 most are hidden.</p>",
        "Ratio of times against sites, for the thesis's scheme and for signum"};
}

Figure ratio_by_perturbation(const Results& results) {
    Plot plot = pairs_of_panels(
        results, {"ratio_by_perturbation",
                  "perturbation",
                  "ratio",
                  "perturbation",
                  "time, exact to plain",
                  by_perturbation,
                  four,
                  {{{"interval", "the thesis's scheme", {}}, {"exact", "signum", {}}}}});
    return {std::move(plot), "What exactness costs against the perturbation (figure 4.7.4)",
            "<p>The same ratio for 100 sites that were moved by chance. The thesis: practically "
            "constant once "
            "the perturbation reaches 10<sup>−6</sup>, and the circle always dearest.</p>",
            "Ratio of times against the perturbation of 100 sites"};
}

Figure radii(const Results& results) {
    Plot plot{"radii", 2, {}};
    Panel ratio;
    ratio.title = "Cost";
    ratio.x_label = "radii from 0 to";
    ratio.y_label = "time, exact to plain";
    ratio.y_least = 0.0;
    Panel hidden = ratio;
    hidden.title = "Hidden sites";
    hidden.y_label = "hidden, % of the sites";
    for (const std::string& metric : results.present("radii", metrics)) {
        ratio.series.push_back(
            {metric, style_of(metric), true,
             results.points({"radii", metric, "", "exact", "ratio"}, by_radius)});
        Series share{metric, style_of(metric), true,
                     results.points({"radii", metric, "", "exact", "hidden"}, by_radius)};
        for (PlotPoint& point : share.points) point.low = point.high = point.y /= 10.0;  // of 1000
        hidden.series.push_back(std::move(share));
    }
    plot.panels = {std::move(ratio), std::move(hidden)};
    return {std::move(plot), "Radii",
            "<p>1000 random sites whose mean distance is 22. With radii of that size they "
            "intersect, and many have no cell of their own: they are hidden. The cost of "
            "exactness hardly depends on it.</p>",
            "Ratio of times, and share of hidden sites, against the radii"};
}

/// The names of the stages in rows, and in words.
const std::array<std::pair<std::string, std::string>, 5> stages = {
    {{"filter", "filter"},
     {"refine", "refined"},
     {"exact", "exact"},
     {"essa", "ESSA"},
     {"multiprecision", "rationals"}}};

Figure stage_shares(const Results& results) {
    Plot plot{"stages", 2, {}};
    for (const std::string& metric : results.present("stages", metrics)) {
        Panel panel;
        panel.title = capital(metric);
        panel.y_label = "% of the calls";
        panel.stacked = true;
        panel.categories = eight;
        panel.y_least = 0.0;
        panel.y_most = 100.0;
        const std::int64_t sites = results.most_sites({"stages", metric, "", "", ""});
        std::array<double, 8> all{};
        const auto calls = [&](std::size_t place, const std::string& stage) {
            return results.at({"stages", metric, eight[place], "exact", "calls_" + stage}, sites)
                .value_or(0.0);
        };
        for (std::size_t i = 0; i < eight.size(); ++i)
            for (const auto& [stage, word] : stages) all[i] += calls(i, stage);
        int style = 0;
        for (const auto& [stage, word] : stages) {
            constexpr std::array looks = {6, 4, 2, 3, 5};
            Series series{word, looks[static_cast<std::size_t>(style++)], false, {}};
            for (std::size_t i = 0; i < eight.size(); ++i) {
                const double y = all[i] > 0.0 ? 100.0 * calls(i, stage) / all[i] : 0.0;
                series.points.push_back({static_cast<double>(i), y, y, y});
            }
            panel.series.push_back(std::move(series));
        }
        plot.panels.push_back(std::move(panel));
    }
    return {
        std::move(plot), "Who decides?",
        "<p>signum asks cheap arithmetic first, and that says whether it is certain. The "
        "<em>filter</em> is a "
        "plain evaluation with a bound on its error; what it leaves goes to a <em>refined</em> "
        "one, "
        "then to <em>exact</em> arithmetic without rounding or to <em>ESSA</em>, the exact sign "
        "of a sum, and in the extreme to <em>rationals</em>. "
        "The share of the calls that each decided, while a tessellation was built.</p>",
        "Stacked bars: the share of calls that each stage decided, by distribution"};
}

Figure stage_costs(const Results& results) {
    Plot plot{"stage_cost", 2, {}};
    for (const std::string& metric : results.present("stage_cost", metrics)) {
        Panel panel;
        panel.title = capital(metric);
        panel.y_label = "nanoseconds a call";
        panel.y_is_log = true;
        std::vector<std::string> deciding;
        for (const auto& [stage, word] : stages) {
            if (results.all({"stage_cost", "", "", stage, ""}).empty()) continue;
            deciding.push_back(stage);
            panel.categories.push_back(word);
        }
        for (const std::string& distribution : eight) {
            Series series{distribution, style_of(distribution), false, {}};
            for (std::size_t s = 0; s < deciding.size(); ++s)
                for (const char* quantity : {"ns_per_call", "ns_per_call_forced"})
                    for (PlotPoint point :
                         results.points({"stage_cost", metric, distribution, deciding[s], quantity},
                                        by_sites)) {
                        point.x = static_cast<double>(s);
                        series.points.push_back(point);
                    }
            panel.series.push_back(std::move(series));
        }
        plot.panels.push_back(std::move(panel));
    }
    return {
        std::move(plot), "What a call costs",
        "<p>A call that the filter decides takes a few nanoseconds. What goes on to exact "
        "arithmetic "
        "takes ten to a thousand times as long, and so the shares above decide what a "
        "tessellation costs. Circle questions of finished tessellations, by the stage that decides "
        "them; a stage that decides fewer than 16 of a distribution is not drawn. Rationals are "
        "there "
        "for numbers so large or small that the other stages would overflow, which these are not: "
        "drawn is what they take for the calls of the stage before.</p>",
        "Nanoseconds a call by stage and distribution, on a logarithmic scale"};
}

Figure kernels(const Results& results) {
    Plot plot{"kernels", 2, {}};
    const Names arithmetics = {"exact", "naive", "single", "interval", "sum", "multiprecision"};
    for (const std::string& metric : results.present("kernels", metrics)) {
        Panel panel;
        panel.title = capital(metric);
        panel.y_label = "time, to plain doubles";
        panel.y_is_log = true;
        panel.categories = four;
        const std::int64_t sites = results.most_sites({"kernels", metric, "", "", ""});
        for (const std::string& arithmetic : arithmetics) {
            Series series{arithmetic, style_of(arithmetic), false, {}};
            for (std::size_t i = 0; i < four.size(); ++i)
                for (const Row* row :
                     results.all({"kernels", metric, four[i], arithmetic, "ratio"})) {
                    if (row->setting.sites != sites) continue;
                    series.points.push_back({static_cast<double>(i), row->value.median,
                                             row->value.low, row->value.high});
                }
            panel.series.push_back(std::move(series));
        }
        plot.panels.push_back(std::move(panel));
    }
    return {
        std::move(plot), "Six arithmetics side by side",
        "<p>The same construction on six arithmetics. <em>naive</em> and <em>single</em> round, "
        "and may be wrong; the others never are: <em>exact</em> is signum’s, "
        "<em>interval</em> the scheme of the thesis, <em>sum</em> its exact sum without a filter, "
        "<em>multiprecision</em> fractions of integers for every single question. "
        "An arithmetic that lost its way is not drawn.</p>",
        "Time of six arithmetics relative to plain doubles, on a logarithmic scale"};
}

Panel against_sites(const std::string& title, const std::string& y_label) {
    Panel panel;
    panel.title = title;
    panel.x_label = "sites";
    panel.y_label = y_label;
    panel.x_is_log = true;
    panel.y_is_log = true;
    return panel;
}

Figure swaps(const Results& results) {
    Panel panel = against_sites("", "swaps");
    for (const std::string& distribution : four)
        panel.series.push_back(
            {distribution, style_of(distribution), true,
             results.points({"flips", "power", distribution, "flips", "swaps"}, by_sites)});
    panel.series.push_back(
        {"random, shrinking radii", 7, true,
         results.points({"flips_scaled", "power", "random", "flips", "swaps"}, by_sites)});
    panel.quoted = {"the thesis", {quoted(100, 4), quoted(3000, 150)}};
    return {
        {"swaps", 1, {std::move(panel)}},
        "Swaps from Delaunay to power (thesis: figure 6.7.1)",
        "<p>A Delaunay triangulation becomes the power tessellation by swapping edges one by one. "
        "Radii lie between 0.01 and 10, as in the thesis, in a square 700 wide: the more sites, "
        "the "
        "more of the discs intersect, and the more swaps a site takes. Grey: random sites whose "
        "radii shrink as the distances do; there swaps are proportional to the sites, as "
        "the thesis found. It states 4 swaps for 100 circles and 150 for 3000.</p>",
        "Number of swaps against sites"};
}

Figure swap_times(const Results& results) {
    Panel panel = against_sites("", "seconds");
    for (const std::string& distribution : four)
        panel.series.push_back(
            {distribution, style_of(distribution), true,
             results.points({"flips", "power", distribution, "flips", "seconds"}, by_sites)});
    panel.series.push_back(
        {"random, inserted", 7, true,
         results.points({"flips", "power", "random", "incremental", "seconds"}, by_sites)});
    return {{"swap_times", 1, {std::move(panel)}},
            "The time that swapping takes (thesis: figure 6.7.2)",
            "<p>The whole way: Delaunay triangulation, then swaps. Grey: the same result by "
            "inserting site after site. Straight lines of slope 1 on these scales are times "
            "proportional to the number of sites, which is what the thesis found.</p>",
            "Seconds of construction by flips against sites"};
}

Figure sweep(const Results& results) {
    Plot plot{"sweep", 2, {}};
    for (const std::string& metric : results.present("sweep", metrics)) {
        Panel panel = against_sites(capital(metric), "seconds");
        for (const std::string& distribution : four)
            panel.series.push_back(
                {distribution, style_of(distribution), true,
                 results.points({"sweep", metric, distribution, "sweep", "seconds"}, by_sites)});
        panel.series.push_back(
            {"random, inserted", 7, true,
             results.points({"sweep", metric, "random", "incremental", "seconds"}, by_sites)});
        panel.quoted = {"the thesis", {quoted(1000, 1), quoted(10000, 34), quoted(10000, 27)}};
        plot.panels.push_back(std::move(panel));
    }
    return {
        std::move(plot), "The sweep (thesis: figure 5.7.2)",
        "<p>A line sweeps over the plane and leaves the finished tessellation behind. The thesis, "
        "on a Pentium 166: 1 second for 1000 sites; for 10 000 sites 34 on random sites and "
        "grid, 27 on circle and square. Grey: by insertion.</p>",
        "Seconds of the sweep against sites, in two metrics"};
}

Figure deletion(const Results& results) {
    Plot plot{"deletion", 2, {}};
    const std::array<std::pair<std::string, std::string>, 3> works = {
        {{"build", "all at once"}, {"insert", "one by one"}, {"erase", "taken out again"}}};
    for (const std::string& metric : results.present("deletion", metrics)) {
        Panel panel = against_sites(capital(metric), "nanoseconds a site");
        int style = 0;
        for (const auto& [work, words] : works)
            panel.series.push_back(
                {words, ++style, true,
                 results.points({"deletion", metric, "", work, "ns_per_site"}, by_sites)});
        plot.panels.push_back(std::move(panel));
    }
    return {std::move(plot), "Sites come and go",
            "<p>A tessellation that changes: what a site costs when all are built at once, when "
            "sites come one by one in no order, and when they are taken out again. All of "
            "it is exact.</p>",
            "Nanoseconds a site for building, inserting and deleting"};
}

Figure hard_inputs(const Results& results) {
    Plot plot{"hard", 2, {}};
    for (const std::string& metric : results.present("hard", metrics)) {
        const std::array<std::array<std::string, 3>, 2> columns = {
            {{"exact", "ratio", "time, exact to plain"},
             {"naive", "wrong_percent", "wrong edges of plain doubles, %"}}};
        for (const auto& [contestant, quantity, label] : columns) {
            Panel panel = against_sites(capital(metric), label);
            panel.y_is_log = false;
            panel.y_least = 0.0;
            for (const std::string& distribution : hard)
                panel.series.push_back(
                    {distribution == "circle" ? "circle (soon random)" : distribution,
                     style_of(distribution), true,
                     results.points({"hard", metric, distribution, contestant, quantity},
                                    by_sites)});
            plot.panels.push_back(std::move(panel));
        }
    }
    return {
        std::move(plot), "Inputs that stay hard at any size",
        "<p>The more doubles lie on one circle, the nearer they are to each other, and the "
        "rounding of "
        "their own coordinates moves them off it by more than neighbours bend: a circle of a "
        "million doubles is nearly random to a filter. These inputs stay hard: <em>lattice</em>, "
        "integer points exactly on circles, 192 on each; <em>rings</em>, circles of a thousand "
        "side by side; "
        "<em>offset</em>, a fine grid far from the origin; <em>tangent</em>, discs that touch a "
        "circle exactly.</p>",
        "Ratio of times and wrong edges on inputs that stay hard, against sites"};
}

std::string percent(std::optional<double> value) {
    return value ? fmt::format("{:.3g} %", *value) : std::string();
}

}  // namespace

std::vector<Figure> figures(const std::vector<Row>& rows) {
    const Results results(rows);
    std::vector<Figure> all;
    for (const auto make : {margin, first_error, wrong_by_sites, wrong_by_perturbation,
                            ratio_by_sites, ratio_by_perturbation, radii, stage_shares, stage_costs,
                            kernels, swaps, swap_times, sweep, deletion, hard_inputs}) {
        Figure figure = make(results);
        if (has_points(figure.plot)) all.push_back(std::move(figure));
    }
    return all;
}

std::vector<Beside> beside_the_thesis(const std::vector<Row>& rows) {
    const Results results(rows);
    std::vector<Beside> table;
    const auto add = [&](const char* what, const char* thesis, const std::string& here) {
        if (!here.empty()) table.push_back({what, thesis, here});
    };
    const auto wrong = [&](const char* distribution, const char* arithmetic) {
        return results.at({"sites", "power", distribution, arithmetic, "wrong_percent"}, 1000);
    };
    const auto ratio = [&](const char* distribution, const char* arithmetic) {
        const auto value = results.at({"sites", "power", distribution, arithmetic, "ratio"}, 1000);
        return value ? fmt::format("{:.2f}", *value) : std::string();
    };
    const auto seconds = [&](const char* distribution, std::int64_t sites) {
        const auto value =
            results.at({"sweep", "supremum", distribution, "sweep", "seconds"}, sites);
        return value ? fmt::format("{:.3g} s", *value) : std::string();
    };
    const auto count = [&](std::int64_t sites) {
        const auto value = results.at({"flips", "power", "random", "flips", "swaps"}, sites);
        return value ? fmt::format("{:.0f}", *value) : std::string();
    };
    add("wrong edges, 1000 random sites, single precision", "about 1 %",
        percent(wrong("random", "single")));
    add("wrong edges, 1000 random sites, doubles", "", percent(wrong("random", "naive")));
    add("wrong edges, 1000 sites on a circle, single precision", "30 %",
        percent(wrong("circle", "single")));
    add("wrong edges, 1000 sites on a circle, doubles", "", percent(wrong("circle", "naive")));
    add("wrong edges or ties decided otherwise, 1000 sites on a grid, single precision", "",
        percent(
            results.at({"sites", "power", "grid", "single", "wrong_or_different_percent"}, 1000)));
    add("wrong edges, 100 sites on a circle, perturbation 1e-9, single precision", "almost 50 %",
        percent(
            results.at({"perturbation", "power", "circle", "single", "wrong_percent"}, 100, 1e-9)));
    add("time ratio, 1000 random sites, the thesis's scheme", "tends to 4",
        ratio("random", "interval"));
    add("time ratio, 1000 random sites, signum", "", ratio("random", "exact"));
    add("time ratio, 1000 sites on a circle, the thesis's scheme", "much higher",
        ratio("circle", "interval"));
    add("time ratio, 1000 sites on a circle, signum", "", ratio("circle", "exact"));
    add("swaps, 100 random discs", "4", count(100));
    add("swaps, 3000 random discs", "150", count(3000));
    add("sweep, 1000 sites", "about 1 s", seconds("random", 1000));
    add("sweep, 10 000 random sites", "34 s", seconds("random", 10000));
    add("sweep, 10 000 sites on a circle", "27 s", seconds("circle", 10000));
    return table;
}

}  // namespace signum::study
