#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/program.hpp"

#include "template.hpp"

namespace signum::study {
namespace {

/// Colours that survive colour blindness, on white and on black (Okabe and Ito), and marks.
struct Style {
    std::string_view colour;
    int mark;
};
constexpr std::array<Style, 8> styles = {{{"#0072B2", 7},
                                          {"#D55E00", 5},
                                          {"#009E73", 9},
                                          {"#E69F00", 13},
                                          {"#CC79A7", 6},
                                          {"#56B4E9", 4},
                                          {"#7F7F7F", 8},
                                          {"#B8A700", 12}}};

const Style& style_of(const Series& series) {
    return styles[static_cast<std::size_t>(series.style - 1) % styles.size()];
}

std::string look_of(const Series& series) {
    const Style& style = style_of(series);
    // gnuplot warns of marks where it draws none.
    if (!series.marked) return fmt::format("lc rgb \"{}\" lw 1.6", style.colour);
    return fmt::format("lc rgb \"{}\" lw 1.6 pt {} ps 0.9", style.colour, style.mark);
}

constexpr std::string_view quoted_look = "pt 12 ps 1.6 lw 2 lc rgb \"black\"";

std::string in_quotes(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

/// A logarithmic axis has no zero: such points are not drawn.
bool is_drawn(const Panel& panel, const PlotPoint& point) {
    return (!panel.x_is_log || point.x > 0.0) && (!panel.y_is_log || point.y > 0.0);
}

std::string data_block(const Panel& panel, const std::string& name,
                       const std::vector<PlotPoint>& points) {
    // An empty line, where a point is not drawn, breaks the line that joins its neighbours.
    std::string text = fmt::format("${} << END\n", name);
    for (const PlotPoint& point : points) {
        const double low = panel.y_is_log && point.low <= 0.0 ? point.y : point.low;
        text += is_drawn(panel, point)
                    ? fmt::format("{} {} {} {}\n", point.x, point.y, low, point.high)
                    : "\n";
    }
    return text + "END\n";
}

bool is_empty(const Panel& panel, const std::vector<PlotPoint>& points) {
    return std::none_of(points.begin(), points.end(),
                        [&](const PlotPoint& point) { return is_drawn(panel, point); });
}

/// Ranges around all points, with some air; linear axes of y are left to gnuplot.
std::string ranges(const Panel& panel) {
    std::vector<PlotPoint> points = panel.quoted.points;
    for (const Series& series : panel.series)
        points.insert(points.end(), series.points.begin(), series.points.end());
    std::erase_if(points, [&](const PlotPoint& point) { return !is_drawn(panel, point); });
    if (points.empty()) return "set xrange [1:10]\nset yrange [1:10]\n";
    double left = points[0].x;
    double right = left;
    double bottom = points[0].y;
    double top = bottom;
    for (const PlotPoint& point : points) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
        bottom = std::min(bottom, point.low > 0.0 ? point.low : point.y);
        top = std::max({top, point.high, point.y});
    }
    std::string text;
    if (panel.categories.empty()) {
        const double air = 0.04 * (right - left) + (left == right ? 1.0 : 0.0);
        const double factor = left > 0.0 ? std::max(1.3, std::pow(right / left, 0.04)) : 1.0;
        text += panel.x_is_log ? fmt::format("set xrange [{}:{}]\n", left / factor, right * factor)
                               : fmt::format("set xrange [{}:{}]\n", left - air, right + air);
    }
    if (panel.y_is_log) {
        const double factor = std::max(1.3, std::pow(top / bottom, 0.05));
        text += fmt::format("set yrange [{}:{}]\n", bottom / factor, top * factor);
    } else if (top <= 0.0) {
        text += "set yrange [0:1]\n";
    }
    return text;
}

std::string axis_settings(const Panel& panel) {
    std::string text =
        fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", in_quotes(panel.title),
                    in_quotes(panel.x_label), in_quotes(panel.y_label));
    text += "unset logscale\nset autoscale\nset xtics autofreq norotate\nset ytics autofreq\n";
    const auto powers = [](char axis) {
        return fmt::format("set logscale {0}\nset format {0} \"10^{{%L}}\"\n", axis);
    };
    text += panel.x_is_log ? powers('x') : "set format x \"%g\"\n";
    text += panel.y_is_log ? powers('y') : "set format y \"%g\"\n";
    if (!panel.categories.empty()) {
        text += "set xtics (";
        for (std::size_t i = 0; i < panel.categories.size(); ++i)
            text += fmt::format("{}{} {}", i > 0 ? ", " : "", in_quotes(panel.categories[i]), i);
        text += fmt::format(") {}\nset xrange [-0.6:{}]\n",
                            panel.categories.size() > 5 ? "rotate by 25 right" : "",
                            static_cast<double>(panel.categories.size()) - 0.4);
    }
    text += ranges(panel);
    const bool is_flat = text.find("set yrange") != std::string::npos;
    if (!is_flat && (!std::isnan(panel.y_least) || !std::isnan(panel.y_most))) {
        const auto bound = [](double value) {
            return std::isnan(value) ? std::string("*") : fmt::format("{}", value);
        };
        text += fmt::format("set yrange [{}:{}]\n", bound(panel.y_least), bound(panel.y_most));
    }

    if (panel.place_of_zero > 0.0)
        text += fmt::format("set xtics add (\"0\" {})\n", panel.place_of_zero);
    text += "unset arrow\nunset label\n";
    for (const Upright& upright : panel.uprights)
        text += fmt::format(
            "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead dt 2 lc rgb "
            "\"#909090\"\nset label {1} at first {0}, graph 1.0 offset character 0.4,-0.6 left "
            "font \",12\" tc rgb \"#909090\"\n",
            upright.x, in_quotes(upright.words));
    return text;
}

/// Where a mark of categories stands beside those of the other series.
double shift_of(const Panel& panel, std::size_t series) {
    if (panel.categories.empty() || panel.stacked) return 0.0;
    const auto count = static_cast<double>(panel.series.size());
    return (static_cast<double>(series) - 0.5 * (count - 1.0)) * std::min(0.12, 0.7 / count);
}

std::string panel_script(const Panel& panel, std::size_t number) {
    std::string data;
    std::string plots;
    const auto add_plot = [&](const std::string& text) {
        plots += (plots.empty() ? "plot " : ", \\\n     ") + text + " notitle";
    };
    if (panel.stacked) {
        // A part of a bar is a box from the sum of the parts below.
        std::vector<double> base(panel.categories.size(), 0.0);
        for (std::size_t s = 0; s < panel.series.size(); ++s) {
            const std::string name = fmt::format("p{}s{}", number, s);
            data += fmt::format("${} << END\n", name);
            for (const PlotPoint& point : panel.series[s].points) {
                double& from = base[static_cast<std::size_t>(point.x)];
                data += fmt::format("{} {} {} {} {} {}\n", point.x, from, point.x - 0.36,
                                    point.x + 0.36, from, from + point.y);
                from += point.y;
            }
            data += "END\n";
            add_plot(
                fmt::format("${} using 1:2:3:4:5:6 with boxxyerror fs solid 1 noborder lc rgb "
                            "\"{}\"",
                            name, style_of(panel.series[s]).colour));
        }
    } else {
        for (std::size_t s = 0; s < panel.series.size(); ++s) {
            const Series& series = panel.series[s];
            if (is_empty(panel, series.points)) continue;
            const std::string name = fmt::format("p{}s{}", number, s);
            data += data_block(panel, name, series.points);
            if (series.marked)
                add_plot(fmt::format("${} using ($1+{}):2:3:4 with yerrorbars {}", name,
                                     shift_of(panel, s), look_of(series)));
            if (series.joined)
                add_plot(fmt::format("${} using 1:2 with {} {}", name,
                                     series.marked ? "linespoints" : "lines", look_of(series)));
        }
        if (!is_empty(panel, panel.quoted.points)) {
            const std::string name = fmt::format("p{}q", number);
            data += data_block(panel, name, panel.quoted.points);
            add_plot(fmt::format("${} using 1:2 with points {}", name, quoted_look));
        }
    }
    if (data.empty()) add_plot("$nothing with dots lc rgb \"#ff000000\"");
    return data + axis_settings(panel) + plots + "\n";
}

/// A plot of its own below all panels, of nothing but names: gnuplot gives a legend the width of
/// its plot.
std::string legend_script(const Plot& plot, double height) {
    const Panel& first = plot.panels.front();
    std::vector<std::string> entries;
    for (const Series& series : first.series)
        entries.push_back(fmt::format(
            "keyentry with {} title {}",
            first.stacked ? fmt::format("boxes fs solid 1 lc rgb \"{}\"", style_of(series).colour)
                          : fmt::format("{} {}",
                                        !series.joined  ? "points"
                                        : series.marked ? "linespoints"
                                                        : "lines",
                                        look_of(series)),
            in_quotes(series.title)));
    for (const Panel& panel : plot.panels)
        if (!is_empty(panel, panel.quoted.points)) {
            entries.push_back(fmt::format("keyentry with points {} title {}", quoted_look,
                                          in_quotes(panel.quoted.title)));
            break;
        }
    std::string text = fmt::format(
        "unset border\nunset tics\nunset grid\nunset logscale\nunset arrow\nunset label\nset title "
        "\"\"\nset xlabel \"\"\nset ylabel \"\"\nset xrange [1:10]\nset yrange [1:10]\n"
        "set lmargin at screen 0.02\nset rmargin at screen 0.98\nset bmargin at screen 0\nset "
        "tmargin at screen {}\n"
        "set key on\nset key at screen 0.5,screen {} center bottom horizontal maxrows {} Left "
        "reverse "
        "samplen 2\n",
        60.0 / height, 8.0 / height, entries.size() > 4 ? 2 : 1);
    text += "plot $nothing with dots lc rgb \"#ff000000\" notitle";
    for (const std::string& entry : entries) text += ", \\\n     " + entry;
    return text + "\n";
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

}  // namespace

std::string gnuplot_script(const Plot& plot) {
    // In pixels: what a panel takes, and what lies between its frame and its neighbours.
    const bool alone = plot.columns == 1;
    const double across = alone ? 860.0 : 440.0;
    const double down = alone ? 420.0 : 360.0;
    const double legend = 60.0;
    const auto count = static_cast<int>(plot.panels.size());
    const int rows = (count + plot.columns - 1) / plot.columns;
    const double width = across * plot.columns;
    const double height = down * rows + legend;
    std::string text = fmt::format(
        "set terminal svg size {},{} dynamic font \"sans-serif,14\" name \"{}\" background rgb "
        "\"#ffffff00\"\n",
        width, height, plot.name);
    text +=
        "set border 3\nset tics nomirror out\nset grid ytics lc rgb \"#909090\" lw 0.4 dt 3\n"
        "set xlabel offset 0,0.4\nset title offset 0,-0.3 font \",15\"\nset bars 0.6\nset "
        "multiplot\n";
    // gnuplot refuses to draw nothing: a dot that does not show.
    text += "set key off\n$nothing << END\n1 1\nEND\n";
    for (int i = 0; i < count; ++i) {
        const double left = across * (i % plot.columns);
        const double top = height - down * (i / plot.columns);
        text += fmt::format(
            "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset "
            "bmargin at screen {}\n",
            (left + 84.0) / width, (left + across - 16.0) / width, (top - 44.0) / height,
            (top - down + 66.0) / height);
        text += panel_script(plot.panels[static_cast<std::size_t>(i)], static_cast<std::size_t>(i));
    }
    if (count > 0) text += legend_script(plot, height);
    return text + "unset multiplot\n";
}

bool has_gnuplot() {
    return has_program("gnuplot", "--version");
}

std::string run_gnuplot(const std::string& script_path) {
    ProgramEnd end = run_program("gnuplot", {script_path});
    if (end.status != 0) throw MachineError(fmt::format("gnuplot failed on {}", script_path));
    return std::move(end.output);
}

std::string drawn_by_gnuplot(const std::string& script) {
    const ScratchFolder folder("curves");
    const std::string path = folder.file("curves.gnuplot");
    std::ofstream(path, std::ios::binary) << script;
    return run_gnuplot(path);
}

std::string inline_svg(std::string svg, const std::string& name, const std::string& description) {
    const std::size_t start = svg.find("<svg");
    if (start != std::string::npos) svg.erase(0, start);
    replace_all(svg, "color=\"black\" ", "");
    replace_all(svg, "color=\"white\" ", "");
    replace_all(svg, "color='white'", "style='color: var(--paper, white)'");
    replace_all(svg, "'black'", "'currentColor'");
    replace_all(svg, "\"black\"", "\"currentColor\"");
    replace_all(svg, "rgb(  0,   0,   0)", "currentColor");
    for (const std::string_view part : {"gpDot", "gpPt", "textbox", "greybox", "gnuplot_canvas"})
        replace_all(svg, part, name + "_" + std::string(part));
    replace_all(svg, "<svg ",
                fmt::format("<svg role=\"img\" aria-label=\"{}\" ", html_text(description)));
    const std::size_t title = svg.find("<title>");
    const std::size_t end = svg.find("</desc>");
    if (title != std::string::npos && end != std::string::npos)
        svg.replace(title, end + 7 - title, "<title>" + html_text(description) + "</title>");
    return svg;
}

}  // namespace signum::study
