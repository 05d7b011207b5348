#include "space_view.hpp"

#include <array>
#include <utility>

#include "style.hpp"

namespace signum {

void write_directions(SvgText& text, double height) {
    constexpr double arm = 34.0;
    const Point from = {-44.0, height - 30.0};
    text.add("<g class=\"axes\" font-size=\"{}\" text-anchor=\"middle\">\n", Px{font_size});
    constexpr std::array<std::pair<Point3, char>, 3> axes = {
        {{{1.0, 0.0, 0.0}, 'x'}, {{0.0, 1.0, 0.0}, 'y'}, {{0.0, 0.0, 1.0}, 'z'}}};
    for (const auto& [axis, name] : axes) {
        const Point tip = {from.x + arm * dot_product(axis, to_the_right),
                           from.y - arm * dot_product(axis, upward)};
        const Point label = {from.x + 1.3 * (tip.x - from.x), from.y + 1.3 * (tip.y - from.y)};
        text.add("<path d=\"M{} {}L{} {}\"/><text x=\"{}\" y=\"{}\">{}</text>\n", Px{from.x},
                 Px{from.y}, Px{tip.x}, Px{tip.y}, Px{label.x}, Px{label.y + 0.3 * font_size},
                 name);
    }
    text.add("</g>\n");
}

}  // namespace signum
