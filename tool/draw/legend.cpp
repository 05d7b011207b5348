#include "legend.hpp"
#include "paths.hpp"
#include "style.hpp"

namespace signum {
namespace {

// Pixels.
constexpr double legend_margin = 24.0;
constexpr double row_height = 1.5 * font_size;
constexpr double swatch = 44.0;              // from a sample's left to its label
constexpr double letter = 0.48 * font_size;  // a little more than the average
constexpr double gap = 24.0;

}  // namespace

void Legend::site(std::string_view kind, std::string label) {
    place(true, kind, std::move(label));
}

void Legend::line(std::string_view kind, std::string_view label) {
    place(false, kind, std::string(label));
}

void Legend::place(bool is_site, std::string_view kind, std::string label) {
    const double width = swatch + letter * static_cast<double>(label.size()) + gap;
    if (left_ > 0 && left_ + width - gap > width_ - 2 * legend_margin) {
        left_ = 0;
        ++row_;
    }
    samples_.push_back({is_site, std::string(kind), std::move(label), legend_margin + left_, row_});
    left_ += width;
}

void Legend::break_into_rows(std::string_view note) {
    const auto longest = static_cast<std::size_t>((width_ - 2 * legend_margin) / (0.5 * font_size));
    while (note.size() > longest) {
        const std::size_t end = note.rfind(' ', longest);
        if (end == note.npos) break;
        notes_.emplace_back(note.substr(0, end));
        note.remove_prefix(end + 1);
    }
    notes_.emplace_back(note);
}

double Legend::height() const {
    return row_height * (row_ + 1 + static_cast<double>(notes_.size())) + legend_margin;
}

void Legend::write(SvgText& text, double top) const {
    text.add("<g class=\"legend\" pointer-events=\"none\">\n");
    const auto baseline = [&](double row) { return top + row_height * (row + 1); };
    for (const auto& [is_site, kind, label, left, row] : samples_) {
        const double middle = baseline(row) - 0.36 * font_size;
        if (is_site) {
            if (kind != "dot" && kind != "hidden-dot") {
                text.add(R"(<{} class="{}" )", outline_.element, kind);
                outline_.write_geometry(text, {left + 17, middle}, 13);
                text.add("/>");
            }
            if (kind.starts_with("hidden"))
                Paths(text, "crosses").cross({left + 17, middle}, 5);
            else
                text.add(R"(<circle class="dot" cx="{}" cy="{}" r="3.5"/>)", Px{left + 17},
                         Px{middle});
        } else {
            text.add(R"(<path class="{}" d="M{} {}h34"/>)", kind, Px{left}, Px{middle});
        }
        text.add("<text x=\"{}\" y=\"{}\">{}</text>\n", Px{left + swatch}, Px{baseline(row)},
                 label);
    }
    for (std::size_t i = 0; i < notes_.size(); ++i)
        text.add("<text x=\"{}\" y=\"{}\" fill=\"#333\">{}</text>\n", Px{legend_margin},
                 Px{baseline(row_ + 1 + static_cast<double>(i))}, notes_[i]);
    text.add("</g>\n");
}

}  // namespace signum
