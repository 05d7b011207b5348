// Writes docs/pictures/neighbourhood_ccw.svg or neighbourhood_in_circle.svg to standard output:
//
//     neighbourhood_pictures ccw | in_circle
//
// A point goes through 256 x 256 neighbouring doubles, and every pixel is the sign that a predicate
// has there: on the left as doubles compute it, on the right as it is. After figure 2 of Kettner,
// Mehlhorn, Pion, Schirra, Yap: Classroom examples of robustness problems in geometric
// computations, Computational Geometry 40 (2008), whose points the first picture takes.

#include <array>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <signum/predicates/ccw.hpp>
#include <signum/predicates/euclidean.hpp>
#include <signum/predicates/power.hpp>

namespace {

using signum::Point;
using signum::Sign;
using signum::Site;

constexpr int side = 256;
constexpr int gap = 16;
constexpr int line_height = 18;
/// The distance of neighbours from 1/2 to 1.
constexpr double ulp = 0x1p-53;

using Predicate = std::function<Sign(double x, double y)>;

/// A row of the picture: the corner from which the point sets out, and two opinions.
struct Experiment {
    std::string text;
    Point corner;
    Predicate rounded;
    Predicate exact;
};

Sign sign_of(double number) {
    return number > 0 ? 1 : number < 0 ? -1 : 0;
}

/// As textbooks have it.
Sign rounded_ccw(Point p, Point q, Point r) {
    return sign_of((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}
Sign rounded_in_circle(Point i, Point j, Point k, Point q) {
    const double a = i.x - q.x, b = i.y - q.y;
    const double c = j.x - q.x, d = j.y - q.y;
    const double e = k.x - q.x, f = k.y - q.y;
    return sign_of((a * a + b * b) * (c * f - d * e) + (c * c + d * d) * (e * b - f * a) +
                   (e * e + f * f) * (a * d - b * c));
}

/// The orientation of a moving point and two others.
Experiment line_through(std::string text, Point p, Point q, Point r) {
    return {std::move(text), p,
            [=](double x, double y) {
                return rounded_ccw({x, y}, q, r);
            },
            [=](double x, double y) {
                return signum::ccw({x, y}, q, r);
            }};
}

/// A moving point and the circle of three others.
Experiment circle_through(std::string text, Point q, Point i, Point j, Point k) {
    return {std::move(text), q,
            [=](double x, double y) {
                return rounded_in_circle(i, j, k, {x, y});
            },
            [=](double x, double y) {
                return signum::power::in_circle(i, j, k, Point{x, y});
            }};
}

/// A moving disc and the circle that touches three others.
Experiment circle_of_discs(std::string text, Site q, Site i, Site j, Site k) {
    using Rounded = signum::euclidean::Perturbed<signum::Arithmetic::naive>;
    return {std::move(text),
            {q.x, q.y},
            [=](double x, double y) {
                return Rounded::in_circle(i, j, k, {x, y, q.r}, {0, 1, 2, 3}).sign;
            },
            [=](double x, double y) {
                return signum::euclidean::in_circle(i, j, k, {x, y, q.r});
            }};
}

/// All pixels of one sign as one path, a stretch of a row after the other.
std::string path_of(const Experiment& experiment, const Predicate& predicate, Sign sign) {
    std::string path;
    for (int j = 0; j < side; ++j) {
        // The picture's y points down.
        const double y = experiment.corner.y + (side - 1 - j) * ulp;
        for (int i = 0; i < side;) {
            const int from = i;
            while (i < side && predicate(experiment.corner.x + i * ulp, y) == sign) ++i;
            if (i > from)
                path += "M" + std::to_string(from) + " " + std::to_string(j) + "h" +
                        std::to_string(i - from);
            else
                ++i;
        }
    }
    return path;
}

void write_panel(const Experiment& experiment, const Predicate& predicate, int left, int top) {
    std::cout << "<g transform=\"translate(" << left << " " << top << ")\">\n"
              << "<rect class=\"left\" width=\"" << side << "\" height=\"" << side << "\"/>\n"
              << "<g transform=\"translate(0 .5)\">\n"
              << "<path class=\"on\" d=\"" << path_of(experiment, predicate, 0) << "\"/>\n"
              << "<path class=\"right\" d=\"" << path_of(experiment, predicate, -1)
              << "\"/>\n</g>\n</g>\n";
}

void write_picture(std::string_view title, const std::array<std::string_view, 3>& legend,
                   const std::vector<Experiment>& experiments) {
    const int row = side + 2 * line_height;
    const int width = 2 * side + 3 * gap;
    const int height = gap + 2 * line_height + static_cast<int>(experiments.size()) * row + gap;
    std::cout << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << width << R"(" height=")"
              << height << R"(" viewBox="0 0 )" << width << " " << height << R"(">
<title>)" << title
              << R"(</title>
<style>
text { font: 13px sans-serif; fill: #222 }
path { stroke-width: 1; fill: none; shape-rendering: crispEdges }
.left { fill: #0072b2 }
.on { stroke: #f0e442; fill: none }
.right { stroke: #d55e00; fill: none }
rect.on { fill: #f0e442; stroke: none }
rect.right { fill: #d55e00; stroke: none }
</style>
<rect width="100%" height="100%" fill="#fff"/>
)";
    constexpr std::array classes = {"left", "on", "right"};
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const int x = gap + static_cast<int>(i) * (width - gap) / 3;
        std::cout << "<rect class=\"" << classes[i] << "\" x=\"" << x << "\" y=\"" << gap - 4
                  << "\" width=\"14\" height=\"14\"/><text x=\"" << x + 20 << "\" y=\"" << gap + 8
                  << "\">" << legend[i] << "</text>\n";
    }
    int top = gap + line_height;
    std::cout << "<text x=\"" << gap << "\" y=\"" << top + 14 << "\">in doubles</text><text x=\""
              << 2 * gap + side << "\" y=\"" << top + 14 << "\">signum</text>\n";
    top += line_height + 4;
    for (const Experiment& experiment : experiments) {
        write_panel(experiment, experiment.rounded, gap, top);
        write_panel(experiment, experiment.exact, 2 * gap + side, top);
        std::cout << "<text x=\"" << gap << "\" y=\"" << top + side + line_height << "\">"
                  << experiment.text << "</text>\n";
        top += row;
    }
    std::cout << "</svg>\n";
}

void write_ccw() {
    write_picture(
        "The orientation of p + (i, j) ulps, q and r, in doubles and exactly",
        {"left turn", "on a line", "right turn"},
        {line_through("p from (0.5, 0.5), q = (12, 12), r = (24, 24)", {0.5, 0.5}, {12, 12},
                      {24, 24}),
         line_through(
             "p from (0.50000000000002531, 0.5000000000000171), q = (17.3, 17.3), r near 24",
             {0.50000000000002531, 0.5000000000000171}, {17.300000000000001, 17.300000000000001},
             {24.00000000000005, 24.0000000000000517765}),
         line_through("p from (0.5, 0.5), q = (8.8, 8.8), r = (12.1, 12.1)", {0.5, 0.5},
                      {8.8000000000000007, 8.8000000000000007}, {12.1, 12.1})});
}

void write_in_circle() {
    // The middle of the picture, 128 ulps from its corner, is on every circle: the fourth corner of
    // a rectangle, or of discs at distances 20, 26, 25 and 25 from the middle of a circle of
    // radius 20.
    const double o = 0.5 + 0x1p-46;
    write_picture(
        "Whether q + (i, j) ulps is in the circle of three others, in doubles and exactly",
        {"inside", "on the circle", "outside"},
        {circle_through("q near (0.5, 0.5), a corner of a square; the opposite one is (24.5, 24.5)",
                        {0.5, 0.5}, {24.5, o}, {24.5, 24.5}, {o, 24.5}),
         circle_through(
             "q near (0.5, 0.5), a corner of a rectangle; the opposite one is (17.3, 8.8)",
             {0.5, 0.5}, {17.3, o}, {17.3, 8.8}, {o, 8.8}),
         circle_of_discs(
             "the disc q of radius 5 near (0.5, 0.5) and three discs of radii 0, 6 and 5",
             {0.5, 0.5, 5}, {o + 35, o + 20, 0}, {o + 25, o + 44, 6}, {o - 9, o + 27, 5})});
}

}  // namespace

int main(int count, char** words) {
    const std::string_view which = count == 2 ? words[1] : "";
    if (which == "ccw")
        write_ccw();
    else if (which == "in_circle")
        write_in_circle();
    else
        std::cerr << "neighbourhood_pictures ccw | in_circle\n";
    return which == "ccw" || which == "in_circle" ? 0 : 2;
}
