#include "outline.hpp"

namespace signum {

Outline disc_outline() noexcept {
    return {"circle", [](SvgText& text, Point centre, double radius) {
                text.add(R"(cx="{}" cy="{}" r="{}")", Px{centre.x}, Px{centre.y}, Px{radius});
            }};
}

Outline square_outline() noexcept {
    return {"rect", [](SvgText& text, Point centre, double radius) {
                text.add(R"(x="{0}" y="{1}" width="{2}" height="{2}")", Px{centre.x - radius},
                         Px{centre.y - radius}, Px{2 * radius});
            }};
}

Outline diamond_outline() noexcept {
    return {"polygon", [](SvgText& text, Point centre, double radius) {
                text.add(R"(points="{0},{1} {2},{3} {0},{4} {5},{3}")", Px{centre.x},
                         Px{centre.y - radius}, Px{centre.x + radius}, Px{centre.y},
                         Px{centre.y + radius}, Px{centre.x - radius});
            }};
}

}  // namespace signum
