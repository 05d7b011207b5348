#include "space_page.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "glossary.hpp"
#include "results.hpp"

namespace signum::study {
namespace {

constexpr std::string_view space_introduction =
    R"(<p>Who is whose neighbour in space? The power tessellation answers with tetrahedra (<em>cells</em>) between
sites, which are balls; where all radii are equal it is Delaunay’s. It is built by signs: on which side of the plane through
three points does a fourth one lie? Does the sphere of four sites contain a fifth one?</p>
<p>Computers round, and where five sites lie nearly on one sphere a rounded sign may be wrong. Then cells are wrong, or nothing fits
together any more: the structure <em>breaks</em>. signum computes these signs so that they are never wrong. This study measures what that
costs, and what goes wrong without it: everything is built from the same sites in plain doubles, and exactly. The study of the plane
(<code>signum study</code>) has more contestants, and the numbers of M. Gavrilova’s thesis beside ours.</p>
<p>Sites come in patterns: <em>random</em> in a cube, on a <em>sphere</em>, on the border of a <em>cube</em>, on a <em>grid</em>.
The last three are degenerate: many sites lie on one sphere or in one plane, where signs are hardest. The cube is 700 wide.</p>
<p>What is timed is run six times, one pass over all experiments after the other, and in each the contestants take turns. Times
are medians of the passes; a thin bar reaches from the fastest pass to the slowest, an interval that holds the true median with a
confidence of 95 %.</p>
)";

constexpr std::string_view own_words =
    R"(<dt>site</dt><dd>A point with a radius: a ball.</dd>
<dt>cell</dt><dd>A tetrahedron between four sites that are neighbours. A <em>wrong</em> cell is one that no tessellation of these sites
has, however ties are decided.</dd>
<dt>breaks</dt><dd>Rounded signs contradict one another so that there is no tessellation.</dd>
)";

const Names patterns = {"random", "sphere", "cube", "grid"};

/// A curve a pattern: of one contestant, a quantity against what `where` says.
std::vector<Series> a_curve_a_pattern(const Results& results, const std::string& experiment,
                                      const std::string& contestant, const std::string& quantity,
                                      const Where& where) {
    std::vector<Series> curves;
    for (std::size_t i = 0; i < patterns.size(); ++i)
        curves.push_back(
            {patterns[i], static_cast<int>(i) + 1, true,
             results.points({experiment, "", patterns[i], contestant, quantity}, where)});
    return curves;
}

/// A panel of percentages on a logarithmic axis of x.
Panel panel_of_percentages(const std::string& title, const std::string& x_label,
                           std::vector<Series> series) {
    Panel panel;
    panel.title = title;
    panel.x_label = x_label;
    panel.y_label = "%";
    panel.x_is_log = true;
    panel.y_least = 0.0;
    panel.series = std::move(series);
    return panel;
}

/// Wrong cells and broken structures of plain doubles, side by side.
Plot errors_of_doubles(const Results& results, const std::string& name,
                       const std::string& experiment, const std::string& x_label,
                       const Where& where) {
    return {name,
            2,
            {panel_of_percentages(
                 "Wrong cells", x_label,
                 a_curve_a_pattern(results, experiment, "naive", "wrong_percent", where)),
             panel_of_percentages("Sets that break", x_label,
                                  a_curve_a_pattern(results, experiment, "naive",
                                                    std::string(broken_percent), where))}};
}

Figure wrong_cells_by_sites(const Results& results) {
    return {
        errors_of_doubles(results, "space_wrong_by_sites", "sites", "sites", by_sites),
        "What doubles get wrong",
        "<p>Left the share of the cells that plain doubles get wrong, where they build anything; "
        "right the share of the sets on which the structure breaks. Random sites do not need "
        "exactness. On a sphere, and on a grid whose coordinates are rounded, doubles hardly "
        "build anything: signs that contradict one another leave no way on.</p>",
        "Percentages of wrong cells and of broken sets against the number of sites"};
}

Figure wrong_cells_by_perturbation(const Results& results) {
    return {
        errors_of_doubles(results, "space_wrong_by_perturbation", "perturbation", "perturbation",
                          by_perturbation),
        "The same against the perturbation",
        "<p>300 sites that were moved by chance, by up to the perturbation. What is moved farther "
        "than doubles round comes out right.</p>",
        "Percentages of wrong cells and of broken sets against the perturbation"};
}

Figure first_error_in_space(const Results& results) {
    Panel panel;
    panel.title = "Greatest perturbation with an error";
    panel.x_label = "sites";
    panel.y_label = "perturbation";
    panel.x_is_log = true;
    panel.y_is_log = true;
    panel.series = a_curve_a_pattern(results, "first_error", "naive", "first_error", by_sites);
    return {{"space_first_error", 1, {std::move(panel)}},
            "When do doubles first err?",
            "<p>The greatest power of ten at which a perturbed pattern still came out with a wrong "
            "cell, or broke: above the line none did on these sets. No mark: no error at any "
            "perturbation.</p>",
            "The greatest perturbation at which doubles err, against the number of sites"};
}

Figure cost_by_sites(const Results& results) {
    Panel ratio;
    ratio.title = "Time, exact to plain";
    ratio.x_label = "sites";
    ratio.y_label = "ratio";
    ratio.x_is_log = true;
    ratio.y_least = 0.0;
    ratio.series = a_curve_a_pattern(results, "sites", "exact", "ratio", by_sites);
    Panel seconds = ratio;
    seconds.title = "Time, exact";
    seconds.y_label = "seconds";
    seconds.y_is_log = true;
    seconds.y_least = Panel().y_least;
    seconds.series = a_curve_a_pattern(results, "sites", "exact", "seconds", by_sites);
    return {
        {"space_ratio_by_sites", 2, {std::move(ratio), std::move(seconds)}},
        "What exactness costs",
        "<p>Left the time of the exact construction divided by that in plain doubles, on the sets "
        "that doubles build: 1 is no cost at all. Right the time itself, on all sets where they "
        "build none.</p>",
        "Ratio of times, and seconds of exact constructions, against sites"};
}

Figure cost_by_perturbation(const Results& results) {
    Panel panel;
    panel.title = "Time, exact to plain";
    panel.x_label = "perturbation";
    panel.y_label = "ratio";
    panel.x_is_log = true;
    panel.y_least = 0.0;
    panel.series = a_curve_a_pattern(results, "perturbation", "exact", "ratio", by_perturbation);
    return {
        {"space_ratio_by_perturbation", 1, {std::move(panel)}},
        "What exactness costs against the perturbation",
        "<p>The same ratio for 300 sites that were moved by chance. The nearer to a sphere or a "
        "grid, the more signs need more than doubles.</p>",
        "Ratio of times against the perturbation of 300 sites"};
}

Figure radii_in_space(const Results& results) {
    Panel ratio;
    ratio.title = "Cost";
    ratio.x_label = "radii from 0 to";
    ratio.y_label = "time, exact to plain";
    ratio.y_least = 0.0;
    ratio.series = {
        {"random", 1, true, results.points({"radii", "", "", "exact", "ratio"}, by_radius)}};
    Panel hidden = ratio;
    hidden.title = "Hidden sites";
    hidden.y_label = "hidden, % of the sites";
    hidden.series = {
        {"random", 1, true, results.points({"radii", "", "", "exact", "hidden"}, by_radius)}};
    for (PlotPoint& point : hidden.series[0].points)
        point.low = point.high = point.y /= 10.0;  // of 1000
    return {
        {"space_radii", 2, {std::move(ratio), std::move(hidden)}},
        "Radii",
        "<p>1000 random sites whose mean distance is 70. With radii beyond that they intersect, "
        "and some have no cell of their own.</p>",
        "Ratio of times, and share of hidden sites, against the radii"};
}

/// The names of the stages in rows, and in words.
struct StageWords {
    std::string_view name;
    std::string_view words;
    int style;
};
constexpr std::array<StageWords, 4> stages_in_space = {{{"filter", "filter", 6},
                                                        {"refine", "refined", 4},
                                                        {"exact", "exact", 2},
                                                        {"multiprecision", "rationals", 5}}};

Figure stages_answered(const Results& results) {
    Panel shares;
    shares.title = "Who decides";
    shares.y_label = "% of the calls";
    shares.stacked = true;
    shares.categories = patterns;
    shares.y_least = 0.0;
    shares.y_most = 100.0;
    Panel costs;
    costs.title = "What a call costs";
    costs.y_label = "nanoseconds a call";
    costs.y_is_log = true;
    for (const auto& [name, words, style] : stages_in_space) {
        Series part{std::string(words), style, false, {}};
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            const auto count = [&](const std::string& quantity) {
                return results.at({"stage_cost", "", patterns[i], "exact", quantity}).value_or(0.0);
            };
            const double all = count("in_sphere");
            const double y = all > 0.0 ? 100.0 * count("calls_" + std::string(name)) / all : 0.0;
            part.points.push_back({static_cast<double>(i), y, y, y});
        }
        shares.series.push_back(std::move(part));
        costs.categories.emplace_back(words);
    }
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        Series series{patterns[i], static_cast<int>(i) + 1, false, {}};
        for (std::size_t s = 0; s < stages_in_space.size(); ++s)
            for (const char* quantity : {"ns_per_call", "ns_per_call_forced"})
                for (PlotPoint point :
                     results.points({"stage_cost", "", patterns[i],
                                     std::string(stages_in_space[s].name), quantity},
                                    by_sites)) {
                    point.x = static_cast<double>(s);
                    series.points.push_back(point);
                }
        costs.series.push_back(std::move(series));
    }
    if (results.all({"stage_cost", "", "", "", ""}).empty()) return {};
    return {
        {"space_stages", 2, {std::move(shares), std::move(costs)}},
        "Who decides, and what that costs",
        "<p>signum asks cheap arithmetic first, and that says whether it is certain. The "
        "<em>filter</em> is a plain evaluation with a bound on its error; what it leaves goes to a "
        "<em>refined</em> one, then to <em>exact</em> arithmetic without rounding, and in the "
        "extreme to <em>rationals</em>. Asked are the facets of finished tessellations: does the "
        "site beyond conflict with the sphere of the cell? A stage that decides fewer than 16 of a "
        "pattern is not drawn on the right. Rationals are there for numbers so large or small that "
        "the other stages would overflow, which these are not: drawn is what they take for calls "
        "of "
        "the stage before.</p>",
        "The share of calls that each stage decided, and nanoseconds a call, by pattern"};
}

}  // namespace

std::vector<Figure> space_figures(const std::vector<Row>& rows) {
    const Results results(rows);
    std::vector<Figure> all;
    for (const auto make : {wrong_cells_by_sites, wrong_cells_by_perturbation, first_error_in_space,
                            cost_by_sites, cost_by_perturbation, radii_in_space, stages_answered}) {
        Figure figure = make(results);
        if (has_points(figure.plot)) all.push_back(std::move(figure));
    }
    return all;
}

Page space_page(const std::vector<Row>& rows) {
    Page page;
    page.title = "What accuracy costs in space";
    page.introduction = space_introduction;
    for (Figure& figure : space_figures(rows)) page.figures.push_back({std::move(figure), {}});
    page.glossary = glossary(own_words, "five sites on one sphere");
    return page;
}

}  // namespace signum::study
