#pragma once
/// A picture of numbers as data, as a script for gnuplot, and as that draws it.

#include <limits>
#include <string>
#include <vector>

namespace signum::study {

struct PlotPoint {
    double x;
    double y;
    double low;
    double high;
};

struct Series {
    std::string title;
    int style = 1;       ///< its colour and mark, from 1
    bool joined = true;  ///< by lines
    std::vector<PlotPoint> points;
    bool marked = true;  ///< each point; of a curve of many, none
};

/// A line across a panel.
struct Upright {
    double x;
    std::string words;
};

/// Numbers that others have published, drawn as black diamonds.
struct Quoted {
    std::string title;
    std::vector<PlotPoint> points;
};

struct Panel {
    std::string title;
    std::string x_label;
    std::string y_label;
    bool x_is_log = false;
    bool y_is_log = false;
    bool stacked = false;                 ///< series are parts of bars, a category of x each
    std::vector<std::string> categories;  ///< names of x = 0, 1, ...; empty where x is a number
    double y_least = std::numeric_limits<double>::quiet_NaN();  ///< NaN: as the data want
    double y_most = std::numeric_limits<double>::quiet_NaN();
    std::vector<Series> series;
    Quoted quoted;
    std::vector<Upright> uprights;
    double place_of_zero = 0.0;  ///< on a logarithmic axis of x, where there is one
};

/// Panels side by side and below each other, with one legend.
struct Plot {
    std::string name;  ///< of its files, without ending
    int columns = 1;
    std::vector<Panel> panels;
};

/// The script; gnuplot writes the SVG to its standard output.
[[nodiscard]] std::string gnuplot_script(const Plot& plot);

/// Whether gnuplot can be started.
[[nodiscard]] bool has_gnuplot();
/// What it writes to its standard output when it runs a script. Throws MachineError where it cannot
/// be started, or fails.
[[nodiscard]] std::string run_gnuplot(const std::string& script_path);
/// The same of a script that lies in no file.
[[nodiscard]] std::string drawn_by_gnuplot(const std::string& script);

/// gnuplot's SVG for the inside of a page: colours of the page for what is black, names of parts
/// that are its own, and a text for who does not see it.
[[nodiscard]] std::string inline_svg(std::string svg, const std::string& name,
                                     const std::string& description);

}  // namespace signum::study
