#pragma once
/// Paths of one class, chunk by chunk.

#include "lines.hpp"
#include "svg_text.hpp"

#include <cstddef>
#include <string_view>

namespace signum {

class Paths {
 public:
    Paths(SvgText& text, std::string_view kind) : text_(text), kind_(kind) {}
    Paths(const Paths&) = delete;
    Paths& operator=(const Paths&) = delete;
    ~Paths() {
        if (drawn_ > 0) text_.add("\"/>\n");
    }

    void line(const Conic& line) {
        begin();
        text_.add("M{} {}", Px{line.from.x}, Px{line.from.y});
        write_stretch(text_, line);
    }
    void dot(Point at) {
        begin();
        text_.add("M{} {}h0", Px{at.x}, Px{at.y});
    }
    /// An x, `arm` to each side.
    void cross(Point at, double arm) {
        begin();
        text_.add("M{0} {1}l{2} {2}m0 {3}l{3} {2}", Px{at.x - arm}, Px{at.y - arm}, Px{2 * arm},
                  Px{-2 * arm});
    }
    [[nodiscard]] std::size_t drawn() const noexcept { return drawn_; }

 private:
    // Browsers stroke many short paths faster than a long one.
    static constexpr std::size_t lines_in_a_path = 500;

    void begin() {
        if (drawn_ % lines_in_a_path == 0)
            text_.add(R"({}<path class="{}" d=")", drawn_ == 0 ? "" : "\"/>\n", kind_);
        ++drawn_;
    }

    SvgText& text_;
    std::string_view kind_;
    std::size_t drawn_ = 0;
};

}  // namespace signum
