#include "numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace signum {
namespace {

constexpr double digit_width = 0.62 * font_size;
constexpr double digit_height = 0.74 * font_size;
constexpr double covered_centre = 300;  // costs as much as so many pixels of lines

struct Placed {
    Box box;
    double cost;
};

bool overlap(const Box& a, const Box& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

/// How much of a line lies in the box; an arc counts as two straight pieces.
double length_inside(const Conic& line, const Box& box) {
    const Point middle = line.at(0.5);
    double length = 0;
    for (const Conic& piece :
         {Conic::straight(line.from, middle), Conic::straight(middle, line.to)})
        for (const auto& [first, last] : parts_inside(piece, box))
            length +=
                (last - first) * std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y);
    return length;
}

}  // namespace

void write_numbers(SvgText& text, Legend& legend, const DrawnSites& sites, const Frame& frame,
                   const Pens& pens, std::initializer_list<std::span<const Conic>> lines) {
    const std::vector<Index> shown = sites.centred_in_picture();
    if (shown.size() > most_numbers) return;

    // Eight places around the centre, the first ones preferred.
    constexpr std::array<Point, 8> sides = {
        {{1, -1}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}, {-1, 0}, {0, -1}, {0, 1}}};
    std::vector<Box> taken;
    for (const Index site : shown) {
        const Point centre = sites.centre(site);
        const double width = digit_width * static_cast<double>(fmt::formatted_size("{}", site));
        const double reach = pens.cross() + 2;
        Placed best = {{}, std::numeric_limits<double>::infinity()};
        for (const Point side : sides) {
            const Point at = {centre.x + side.x * (width / 2 + reach),
                              centre.y + side.y * (digit_height / 2 + reach)};
            const Box box = {at.x - width / 2, at.y - digit_height / 2, at.x + width / 2,
                             at.y + digit_height / 2};
            if (box.x0 < 2 || box.y0 < 2 || box.x1 > frame.width() - 2 ||
                box.y1 > frame.height() - 2 ||
                std::ranges::any_of(taken, [&](const Box& other) { return overlap(box, other); }))
                continue;
            double cost = 0;
            for (const Index other : shown) {
                const Point mark = sites.centre(other);
                const Box around = {mark.x - reach, mark.y - reach, mark.x + reach, mark.y + reach};
                if (other != site && overlap(box, around)) cost += covered_centre;
            }
            for (const auto& kind : lines)
                for (const Conic& line : kind) cost += length_inside(line, box);
            if (cost < best.cost) best = {box, cost};
        }
        if (!std::isfinite(best.cost)) continue;
        taken.push_back(best.box);
        text.add("<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n",
                 sites.is_hidden(static_cast<std::size_t>(site)) ? "hidden-number" : "number",
                 Px{(best.box.x0 + best.box.x1) / 2}, Px{best.box.y1}, site);
    }
    if (taken.size() < shown.size())
        legend.note("numbers of {} sites, where there is room for them", taken.size());
}

}  // namespace signum
