#pragma once
/// The legend below a picture: samples in a row, then notes; in more rows where they do not fit.

#include "shapes.hpp"
#include "svg_text.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace signum {

class Legend {
 public:
    Legend(double width, const Outline& outline) : width_(width), outline_(outline) {}

    /// A sample site or a sample line of a style class, and what it stands for. Sites of the
    /// classes dot and hidden-dot have no outline.
    void site(std::string_view kind, std::string label);
    void line(std::string_view kind, std::string_view label);

    template <typename... Values>
    void note(fmt::format_string<Values...> format, Values&&... values) {
        break_into_rows(fmt::format(format, std::forward<Values>(values)...));
    }

    [[nodiscard]] double height() const;
    /// Writes it below `top`.
    void write(SvgText& text, double top) const;

 private:
    struct Sample {
        bool is_site;
        std::string kind;
        std::string label;
        double left;
        int row;
    };
    void place(bool is_site, std::string_view kind, std::string label);
    void break_into_rows(std::string_view note);

    double width_;
    const Outline& outline_;
    std::vector<Sample> samples_;
    std::vector<std::string> notes_;  // a row each
    double left_ = 0.0;               // where the next sample goes, before the margin
    int row_ = 0;
};

}  // namespace signum
