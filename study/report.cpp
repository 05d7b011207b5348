#include "report.hpp"

#include <string_view>

#include <fmt/format.h>

#include "html.hpp"

namespace signum::study {
namespace {

constexpr std::string_view head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>What accuracy costs: a study by signum</title>
<style>
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fdfdfb; --soft: #5c6066; --line: #d8d8d2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e4e0; --paper: #17191c; --soft: #a0a4aa; --line: #3a3d42; }
}
body { margin: 0 auto; padding: 2rem 1.2rem 5rem; max-width: 56rem; color: var(--ink);
       background: var(--paper); font: 1.05rem/1.6 Georgia, "Liberation Serif", serif; }
h1 { font-size: 2rem; line-height: 1.2; }
h2 { font-size: 1.35rem; margin-top: 3.2rem; }
p, ul, dl, table { max-width: 44rem; }
sup { line-height: 0; }
figure { margin: 1.2rem 0 0; }
img { display: block; width: 30rem; max-width: 100%; background: #fff; }
svg { display: block; width: 100%; height: auto; }
svg text, svg tspan { font-family: "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
table { border-collapse: collapse; font-size: .95rem; }
th, td { text-align: left; padding: .35rem 1rem .35rem 0; border-bottom: 1px solid var(--line);
         vertical-align: top; }
dt { font-weight: bold; margin-top: .7rem; }
dd { margin: 0; }
code { font-size: .92em; overflow-wrap: anywhere; }
.soft { color: var(--soft); }
</style>
</head>
<body>
)";

constexpr std::string_view introduction = R"(<h1>What accuracy costs</h1>
<p>Programs that work with shapes decide by <em>signs</em>. Is this point left of that line? Does this
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

constexpr std::string_view glossary = R"(<h2>Words</h2>
<dl>
<dt>sign</dt><dd>Whether a number is positive, negative or zero.</dd>
<dt>site</dt><dd>A point with a radius: a disc, a square or a diamond.</dd>
<dt>tessellation</dt><dd>Which sites are neighbours: a network of triangles over the sites, the dual of the
Voronoi diagram. An <em>edge</em> joins two neighbours; a <em>wrong</em> edge is one that no exact computation gives.</dd>
<dt>Delaunay, power, Euclidean, Manhattan, supremum</dt><dd>Tessellations by different distances. Delaunay is
the power tessellation of sites of equal radii.</dd>
<dt>double, single precision</dt><dd>Rounded numbers of about 16 and of about 7 decimal digits.</dd>
<dt>plain, naive</dt><dd>Computed in doubles, whose word is taken for the truth.</dd>
<dt>exact</dt><dd>With a sign that is never wrong, for all doubles.</dd>
<dt>filter</dt><dd>Plain arithmetic that also bounds its own error, and so knows when to ask for
better.</dd>
<dt>tie</dt><dd>A sign that is exactly zero: four sites on one circle. One rule decides it, so that there is one result.</dd>
<dt>perturbation</dt><dd>A random number from 0 to it is added to each coordinate.</dd>
<dt>hidden site</dt><dd>One whose cell is empty, because others cover it.</dd>
</dl>
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

std::string account_of(const Account& account) {
    std::string text = fmt::format(
        "<h2>How this was made</h2>\n<p><code>{}</code> with signum {}, in {} of "
        "measuring. All numbers stand in <code>results.csv</code> and <code>results.json</code> "
        "beside this page, those of each pass in <code>measurements.csv</code>, the pictures and "
        "their scripts in <code>figures/</code>.</p>\n",
        html_text(account.command), html_text(account.version),
        account.seconds < 120.0 ? fmt::format("{:.0f} seconds", account.seconds)
                                : fmt::format("{:.0f} minutes", account.seconds / 60.0));
    if (account.measured < account.planned)
        text += fmt::format(
            "<p><strong>Not complete:</strong> {} of {} measurements. The same command goes "
            "on.</p>\n",
            account.measured, account.planned);
    text += "<table>\n";
    for (const auto& [name, value] : account.machine)
        text += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", html_text(name), html_text(value));
    return text + "</table>\n";
}

}  // namespace

std::string html_report(const Account& account, const Picture& picture,
                        const std::vector<DrawnFigure>& figures,
                        const std::vector<Beside>& thesis) {
    std::string page(head);
    page += introduction;
    page += show(picture);
    page += thesis_table(thesis);
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const Figure& figure = figures[i].figure;
        page += fmt::format(
            "<section id=\"{}\">\n<h2>{}. {}</h2>\n{}\n<figure>\n{}\n</figure>\n</section>\n",
            figure.plot.name, i + 1, figure.title, figure.text, figures[i].svg);
    }
    page += glossary;
    page += account_of(account);
    return page + "</body>\n</html>\n";
}

}  // namespace signum::study
