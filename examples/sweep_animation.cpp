// Writes docs/pictures/sweep.svg to standard output: the Manhattan diagram of a few diamonds as the
// sweep uncovers it, as an animation (SMIL).
//
// Behind the front every point is nearer to its site than to the line. At height x it is the
// highest of the tents (line + top - |x - centre|) / 2 of the waves that reach x; see
// predicates/rectangular/front.hpp. It is drawn from these formulas alone, and the diagram from the
// tessellation: that the edges come out where the front turns is a picture of the proof.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <signum/tool/draw/frame.hpp>
#include <signum/tool/draw/lines.hpp>
#include <signum/tool/draw/svg_text.hpp>
#include <signum/triangulation/triangulate.hpp>
#include <signum/voronoi/voronoi.hpp>

namespace {

using namespace signum;

constexpr double width = 520;  // of the picture, in pixels
constexpr double step = 3;     // from sample to sample of the front
constexpr int frames = 72;
constexpr int still = 25;  // the frame that shows where nothing moves
constexpr double seconds = 14;

/// Two intersect, and one lies within another.
const std::vector<Site> sites = {{20, 38, 6},  {44, 24, 10}, {70, 46, 4}, {88, 30, 7},  {32, 66, 5},
                                 {56, 72, 12}, {66, 84, 7},  {60, 77, 2}, {84, 70, 5},  {12, 88, 4},
                                 {38, 100, 6}, {76, 104, 3}, {60, 54, 2}, {100, 92, 5}, {8, 58, 3}};
const Box box = {-4, 4, 112, 116};

/// What lies behind the front, as the points of a polygon.
std::string swept(const Frame& frame, double line) {
    std::string points;
    const auto add = [&](double x, double y) {
        points += fmt::format("{},{} ", Px{x}, Px{std::min(y, frame.height() + 9)});
    };
    for (double pixel = -step; pixel <= width + step; pixel += step) {
        const double x = box.x0 + (box.x1 - box.x0) * pixel / width;
        double front = -1e6;
        for (const Site& site : sites) {
            const double across = std::abs(x - site.x);
            if (across <= line - (site.y - site.r))
                front = std::max(front, (line + site.y + site.r - across) / 2);
        }
        add(pixel, frame.at(Point{x, std::max(front, -1e3)}).y);
    }
    add(width + step, frame.height() + 9);
    add(-step, frame.height() + 9);
    points.pop_back();
    return points;
}

}  // namespace

int main() {
    Options options;
    options.method = Method::sweep;
    const Voronoi voronoi(triangulate(sites, Manhattan{}, options));
    const Frame frame(box, width);
    const double last = 230;
    const auto line_at = [&](int f) { return last * f / (frames - 1); };
    const std::string animation = fmt::format(R"(dur="{}s" repeatCount="indefinite"/>)", seconds);

    SvgText svg;
    svg.add(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
        R"(font-family="system-ui, sans-serif" font-size="12" text-anchor="middle">
<title>The Manhattan diagram of fifteen diamonds, uncovered by a sweep</title>
<defs><polygon id="swept" points="{2}"><animate attributeName="points" values=")",
        Px{frame.width()}, Px{frame.height()}, swept(frame, line_at(still)));
    for (int f = 0; f < frames; ++f) svg.add("{}{}", f == 0 ? "" : ";", swept(frame, line_at(f)));
    svg.add(R"svg(" {}</polygon><clipPath id="behind"><use href="#swept"/></clipPath></defs>
<rect width="100%" height="100%" fill="#fff"/>
<g fill="#f2e6d9" stroke="#b08d5b">
)svg",
            animation);
    const auto diamond = [&](const Site& site) {
        const Point c = frame.at(Point{site.x, site.y});
        const double r = frame.length(site.r);
        svg.add("<path d=\"M{} {}l{} {} {} {} {} {}z\"/>\n", Px{c.x}, Px{c.y - r}, Px{r}, Px{r},
                Px{-r}, Px{r}, Px{-r}, Px{-r});
    };
    for (const Site& site : sites) diamond(site);
    svg.add(R"svg(</g>
<use href="#swept" fill="#0072b2" fill-opacity=".13" stroke="#0072b2" stroke-width="1.5"/>
<g clip-path="url(#behind)" fill="none" stroke="#000" stroke-width="1.6" stroke-linecap="round">
<path d=")svg");
    for (const Conic& conic : cell_edges(voronoi, frame)) {
        svg.add("M{} {}", Px{conic.from.x}, Px{conic.from.y});
        write_stretch(svg, conic);
    }
    svg.add("\"/></g>\n");
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Point c = frame.at(Point{sites[i].x, sites[i].y});
        svg.add("<text x=\"{}\" y=\"{}\">{}</text>\n", Px{c.x}, Px{c.y + 4}, i);
    }
    const auto pixel = [&](int f) { return Px{frame.at(Point{0, line_at(f)}).y}; };
    svg.add(
        R"svg(<path d="M0 0h{}" transform="translate(0 {})" stroke="#d55e00" stroke-width="2">)svg"
        R"svg(<animateTransform attributeName="transform" type="translate" values="0 {};0 {}" {}</path>
</svg>
)svg",
        Px{frame.width()}, pixel(still), pixel(0), pixel(frames - 1), animation);
    std::cout << svg.view();
}
