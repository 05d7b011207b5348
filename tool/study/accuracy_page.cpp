#include "accuracy_page.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "glossary.hpp"
#include "html.hpp"

namespace signum::study {
namespace {

constexpr std::string_view introduction =
    R"(<p>Programs that work with shapes decide by <em>signs</em>. Is this point left of that line? Does this
circle contain that point? Each such question is answered by whether one computed number is positive,
negative or zero.</p>
<p>Computers round. To a computer’s usual numbers 10<sup>16</sup> + 1 − 10<sup>16</sup> is 0, not 1: the sign
is wrong. Mostly the numbers are far from zero and rounding does no harm. When four points lie nearly on one circle, it
does: the program believes a wrong answer, and what it builds has wrong edges, or falls
apart.</p>
<p>signum computes these signs so that they are never wrong. This study measures what that costs, and what goes
wrong without it. Everything is built twice or more from the same points (<em>sites</em>): with plain
rounded arithmetic, and exactly. It follows the experiments of M. Gavrilova’s thesis (<em>Proximity and
Applications in General Metrics</em>, Calgary 1998) and puts its numbers beside ours.</p>
<p>Sites come in patterns: <em>random</em> in a square, on a <em>circle</em>, on the border of a <em>square</em>, on a
<em>grid</em>. The last three are degenerate: many sites lie on one circle or on one line, where signs are hardest.</p>
<p>All experiments are run six times, one pass over all of them after the other, and in each the contestants take
turns. Times are medians of the passes; a thin bar reaches from the fastest pass to the slowest, which is an interval
that holds the true median with a confidence of 95 %. Where there are four metrics, distance is measured in four ways; <em>power</em> is that of the
thesis’s experiments.</p>
)";

constexpr std::string_view own_words =
    R"(<dt>sign</dt><dd>Whether a number is positive, negative or zero.</dd>
<dt>site</dt><dd>A point with a radius: a disc, a square or a diamond.</dd>
<dt>tessellation</dt><dd>Which sites are neighbours: a network of triangles over the sites, the dual of the
Voronoi diagram. An <em>edge</em> joins two neighbours; a <em>wrong</em> edge is one that no exact computation gives.</dd>
<dt>Delaunay, power, Euclidean, Manhattan, supremum</dt><dd>Tessellations by different distances. Delaunay is
the power tessellation of sites of equal radii.</dd>
<dt>double, single precision</dt><dd>Rounded numbers of about 16 and of about 7 decimal digits.</dd>
)";

/// A picture as a part of the page, whose styles are its own.
std::string data_address(std::string_view svg) {
    std::string result = "data:image/svg+xml,";
    for (const char c : svg) {
        if (c == '%' || c == '#' || c == '"' || c == '<' || c == '>' || c == '\n')
            result += fmt::format("%{:02X}", static_cast<unsigned>(c));
        else
            result += c;
    }
    return result;
}

std::string show(const Picture& picture) {
    if (picture.svg.empty()) return {};
    return fmt::format(
        "<figure>\n<img src=\"{}\" alt=\"{} sites on a circle joined by edges, the wrong ones "
        "thick\">\n<figcaption class=\"soft\">{} sites on a circle, as single precision joins "
        "them: {} of {} edges are wrong (thick).</figcaption>\n</figure>\n",
        data_address(picture.svg), picture.sites, picture.sites, picture.wrong, picture.edges);
}

std::string thesis_table(const std::vector<Beside>& thesis) {
    if (thesis.empty()) return {};
    std::string text =
        "<h2>The thesis’s numbers beside ours</h2>\n<p>What the thesis states in its text (a 486 "
        "and a "
        "Pentium of 1996 to 1998), and what this run gave, in the power metric.</p>\n"
        "<table>\n<tr><th>what</th><th>thesis</th><th>here</th></tr>\n";
    for (const Beside& line : thesis)
        text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html_text(line.what),
                            html_text(line.thesis), html_text(line.here));
    return text + "</table>\n";
}

}  // namespace

Page accuracy_page(const std::vector<Row>& rows, const Picture& picture) {
    Page page;
    page.title = "What accuracy costs";
    page.introduction =
        std::string(introduction) + show(picture) + thesis_table(beside_the_thesis(rows));
    for (Figure& figure : figures(rows)) page.figures.push_back({std::move(figure), {}});
    page.glossary = glossary(own_words, "four sites on one circle");
    return page;
}

}  // namespace signum::study
