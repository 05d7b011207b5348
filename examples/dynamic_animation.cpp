// Writes docs/pictures/dynamic.svg to standard output: the Euclidean diagram of sites that grow,
// shrink, go and come, as an animation (SMIL). Every frame is the tessellation after one more
// change.

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include <signum/tool/draw/frame.hpp>
#include <signum/tool/draw/lines.hpp>
#include <signum/tool/draw/svg_text.hpp>
#include <signum/triangulation/dynamic.hpp>
#include <signum/voronoi/voronoi.hpp>

namespace {

using namespace signum;

constexpr double seconds_a_frame = 0.35;
constexpr std::size_t still = 10;  // the frame that shows where nothing moves

const Box box = {0, 0, 120, 90};
const Frame frame(box, 520);

/// One state of the diagram: cells, discs, hidden ones dashed, and what is happening.
std::string drawn(const DynamicTessellation& live, std::string_view what) {
    SvgText svg;
    const Tessellation& tessellation = live.tessellation();
    std::vector<bool> hidden(tessellation.sites().size());
    for (const Hidden& h : tessellation.hidden()) hidden[static_cast<std::size_t>(h.site)] = true;
    for (const bool of_hidden : {false, true})
        for (std::size_t i = 0; i < hidden.size(); ++i) {
            if (hidden[i] != of_hidden) continue;
            const Site& site = tessellation.sites()[i];
            const Point c = frame.at(Point{site.x, site.y});
            svg.add("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>", Px{c.x}, Px{c.y},
                    Px{frame.length(site.r)},
                    of_hidden ? " stroke-dasharray=\"3\" fill=\"none\"" : "");
        }
    svg.add("<path fill=\"none\" stroke=\"#000\" stroke-width=\"1.6\" d=\"");
    for (const Conic& conic : cell_edges(Voronoi(tessellation), frame)) {
        svg.add("M{} {}", Px{conic.from.x}, Px{conic.from.y});
        write_stretch(svg, conic);
    }
    svg.add("\"/><text x=\"10\" y=\"20\" stroke=\"none\" fill=\"#000\">{}</text>", what);
    return std::string(svg.view());
}

}  // namespace

int main() {
    DynamicTessellation live(Metric::euclidean);
    for (const Site& site :
         {Site{18, 20, 4}, Site{44, 16, 3}, Site{78, 22, 5}, Site{104, 40, 4}, Site{92, 70, 6},
          Site{60, 76, 3}, Site{28, 66, 5}, Site{12, 48, 3}, Site{72, 54, 2}})
        live.insert(site);
    const auto growing = live.insert({54, 44, 1});

    std::vector<std::string> frames = {drawn(live, "ten sites")};
    for (int radius = 3; radius <= 27; radius += 2) {
        live.change(growing, radius);
        frames.push_back(drawn(live, "one grows, and hides another"));
    }
    for (int radius = 23; radius >= 1; radius -= 4) {
        live.change(growing, radius);
        frames.push_back(drawn(live, "it shrinks"));
    }
    live.erase(growing);
    frames.insert(frames.end(), 4, drawn(live, "it goes"));
    for (const Site& site : {Site{40, 44, 2}, Site{58, 30, 4}, Site{50, 58, 1}}) {
        live.insert(site);
        frames.insert(frames.end(), 3, drawn(live, "others come"));
    }

    SvgText svg;
    svg.add(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
        R"(font-family="system-ui, sans-serif" font-size="13">
<title>A Euclidean diagram whose sites grow, shrink, go and come</title>
<rect width="100%" height="100%" fill="#fff"/><g fill="#cbe6f7" stroke="#0072b2">
)",
        Px{frame.width()}, Px{frame.height()});
    for (std::size_t f = 0; f < frames.size(); ++f) {
        std::string shown;
        for (std::size_t t = 0; t < frames.size(); ++t)
            shown += t == 0 ? (t == f ? "inline" : "none") : (t == f ? ";inline" : ";none");
        svg.add(R"(<g display="{}">{}<animate attributeName="display" values="{}" )"
                R"(calcMode="discrete" dur="{}s" repeatCount="indefinite"/></g>
)",
                f == still ? "inline" : "none", frames[f], shown,
                seconds_a_frame * static_cast<double>(frames.size()));
    }
    svg.add("</g>\n</svg>\n");
    std::cout << svg.view();
}
