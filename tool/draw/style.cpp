#include "style.hpp"

#include <algorithm>
#include <array>

namespace signum {

const char* ball_colour(std::size_t number) noexcept {
    constexpr std::array<const char*, 6> colours = {"#0072b2", "#e69f00", "#009e73",
                                                    "#cc79a7", "#56b4e9", "#d55e00"};
    return colours[number % colours.size()];
}

Pens::Pens(double spacing)
    : cell(std::clamp(spacing / 32, 0.4, 2.2)),
      edge(std::clamp(spacing / 60, 0.3, 1.1)),
      wrong(std::max(3 * edge, 2.5)),
      dot(std::clamp(spacing / 32, 0.4, 3.2)),
      hatch(std::clamp(spacing / 8, 1.5, 6.0)) {}

// Okabe and Ito's colours, which colour blindness keeps apart, and a magenta for what is wrong.
// What crosses differs in lightness or width too, what is hidden is hatched, and what is different
// is dashed, for print in grey. In the legend lines are never too thin to show their colour.
void write_style(SvgText& text, const Pens& pens) {
    text.add(R"svg(<style>
* {{ vector-effect: non-scaling-stroke; }}
path {{ fill: none; pointer-events: none; stroke-linecap: round; stroke-linejoin: round; }}
.site {{ fill: #56b4e9; fill-opacity: 0.35; stroke: #0072b2; pointer-events: auto; }}
.hidden {{ fill: url(#hatch); stroke: #444; stroke-dasharray: 5 3; pointer-events: auto; }}
.dot {{ fill: #000; stroke: none; }}
.hidden-dot {{ fill: #fff; fill-opacity: 0; stroke: none; }}
.site:hover, .hidden:hover, .dot:hover, .hidden-dot:hover {{ fill: #f0e442; fill-opacity: 0.8; }}
.site, .hidden, .edge {{ stroke-width: {0}; }}
.edge {{ stroke: #000; }}
.cell {{ stroke: #e69f00; stroke-width: {1}; }}
.border {{ stroke: #333; stroke-width: {1}; }}
.tint {{ pointer-events: auto; }}
.tint0 {{ fill: #dcebf7; }}
.tint1 {{ fill: #fdeacb; }}
.tint2 {{ fill: #d9efe6; }}
.tint3 {{ fill: #f6dfeb; }}
.tint4 {{ fill: #fbf8cf; }}
.tint5 {{ fill: #e9e9ee; }}
.tint:hover {{ fill: #f0e442; }}
.wrong, .flipped {{ stroke: #d0007f; stroke-width: {2}; }}
.flipped {{ stroke: #009e73; }}
.different {{ stroke: #009e73; stroke-width: {8}; stroke-dasharray: 7 5; }}
.dots {{ stroke: #000; stroke-width: {3}; }}
.crosses {{ stroke: #000; stroke-width: {9}; }}
.number, .hidden-number {{ pointer-events: none; text-anchor: middle; vector-effect: none; stroke: #fff; stroke-width: 4; stroke-linejoin: round; paint-order: stroke; }}
.hidden-number {{ fill: #333; font-style: italic; }}
.axes path {{ stroke: #555; stroke-width: 1; }}
.legend .site, .legend .hidden, .legend .edge {{ stroke-width: {4}; }}
.legend .cell, .legend .border {{ stroke-width: {5}; }}
</style>
<defs>
<pattern id="hatch" width="{6}" height="{6}" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
<rect width="{6}" height="{6}" fill="#fff" fill-opacity="0.35"/>
<rect width="{7}" height="{6}" fill="#444"/>
</pattern>
</defs>
)svg",
             Px{pens.edge}, Px{pens.cell}, Px{pens.wrong}, Px{2 * pens.dot},
             Px{std::max(pens.edge, 1.1)}, Px{std::max(pens.cell, 2.2)}, Px{pens.hatch},
             Px{pens.hatch / 5}, Px{std::max(2 * pens.edge, 1.5)}, Px{std::max(pens.dot / 2, 0.4)});
}

}  // namespace signum
