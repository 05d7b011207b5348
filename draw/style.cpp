#include "style.hpp"

#include <algorithm>

namespace signum {

Pens::Pens(double spacing)
    : cell(std::clamp(spacing / 32, 0.3, 2.2)),
      edge(std::clamp(spacing / 60, 0.2, 1.1)),
      wrong(std::max(3 * edge, 1.5)),
      dot(std::clamp(spacing / 32, 0.4, 2.5)),
      hatch(std::clamp(spacing / 8, 1.5, 5.0)) {}

// Okabe and Ito's colours, which colour blindness keeps apart; layers that cross differ in
// lightness too, for print. In the legend lines are never too thin to show their colour.
void write_style(SvgText& text, const Pens& pens) {
    text.add(R"svg(<style>
* {{ vector-effect: non-scaling-stroke; }}
path {{ fill: none; pointer-events: none; stroke-linecap: round; stroke-linejoin: round; }}
.site {{ fill: #56b4e9; fill-opacity: 0.35; stroke: #0072b2; }}
.hidden {{ fill: url(#hatch); stroke: #a03a78; }}
.dot {{ fill: #000; stroke: none; }}
.hidden-dot {{ fill: #cc79a7; stroke: #a03a78; }}
.site:hover, .hidden:hover, .dot:hover, .hidden-dot:hover {{ fill: #f0e442; fill-opacity: 0.8; }}
.site, .hidden, .hidden-dot, .edge {{ stroke-width: {0}; }}
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
.wrong, .flipped {{ stroke: #d55e00; stroke-width: {2}; }}
.flipped {{ stroke: #009e73; }}
.different {{ stroke: #009e73; stroke-width: {8}; }}
.dots, .hidden-dots {{ stroke: #000; stroke-width: {3}; }}
.hidden-dots {{ stroke: #cc79a7; }}
.legend .site, .legend .hidden, .legend .edge {{ stroke-width: {4}; }}
.legend .cell, .legend .border {{ stroke-width: {5}; }}
</style>
<defs>
<pattern id="hatch" width="{6}" height="{6}" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
<rect width="{6}" height="{6}" fill="#fff" fill-opacity="0.35"/>
<rect width="{7}" height="{6}" fill="#a03a78"/>
</pattern>
</defs>
)svg",
             Px{pens.edge}, Px{pens.cell}, Px{pens.wrong}, Px{2 * pens.dot},
             Px{std::max(pens.edge, 0.9)}, Px{std::max(pens.cell, 1.8)}, Px{pens.hatch},
             Px{pens.hatch / 4}, Px{std::max(2 * pens.edge, 0.9)});
}

}  // namespace signum
