#include "legend.hpp"

namespace signum {
namespace {

// Pixels, for text of 13 pixels.
constexpr double margin = 20.0;
constexpr double row_height = 22.0;
constexpr double swatch = 30.0;  // from a sample's left to its label
constexpr double letter = 6.4;   // a little more than the average
constexpr double gap = 26.0;

}  // namespace

void Legend::site(std::string_view kind, std::string label) {
    place(true, kind, std::move(label));
}

void Legend::line(std::string_view kind, std::string_view label) {
    place(false, kind, std::string(label));
}

void Legend::place(bool is_site, std::string_view kind, std::string label) {
    const double width = swatch + letter * static_cast<double>(label.size()) + gap;
    if (left_ > 0 && left_ + width - gap > width_ - 2 * margin) {
        left_ = 0;
        ++row_;
    }
    samples_.push_back({is_site, std::string(kind), std::move(label), margin + left_, row_});
    left_ += width;
}

double Legend::height() const {
    return row_height * (row_ + 1 + static_cast<double>(notes_.size())) + margin;
}

void Legend::write(SvgText& text, double top) const {
    text.add(
        "<g class=\"legend\" pointer-events=\"none\">\n<path d=\"M0 {}h{}\" stroke=\"#999\"/>\n",
        Px{top}, Px{width_});
    const auto baseline = [&](double row) { return top + row_height * (row + 1) + 4; };
    for (const auto& [is_site, kind, label, left, row] : samples_) {
        const double middle = baseline(row) - 4.5;
        if (is_site) {
            text.add(R"(<{} class="{}" )", outline_.element, kind);
            outline_.write_geometry(text, {left + 12, middle}, 8);
            text.add("/>");
        } else {
            text.add(R"(<path class="{}" d="M{} {}h24"/>)", kind, Px{left}, Px{middle});
        }
        text.add("<text x=\"{}\" y=\"{}\">{}</text>\n", Px{left + swatch}, Px{baseline(row)},
                 label);
    }
    for (std::size_t i = 0; i < notes_.size(); ++i)
        text.add("<text x=\"{}\" y=\"{}\" fill=\"#555\">{}</text>\n", Px{margin},
                 Px{baseline(row_ + 1 + static_cast<double>(i))}, notes_[i]);
    text.add("</g>\n");
}

}  // namespace signum
