/// Sites of space as text. A header names x, y and z, and r, radius or weight where there is one;
/// columns of other names are left out, and may hold any text.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "number.hpp"
#include "text_columns.hpp"
#include "text_sites.hpp"

namespace signum {
namespace {

class TextSitesInSpace {
 public:
    TextSitesInSpace(TextColumns& lines, const ReadOptions& options)
        : lines_(lines), chosen_(options.columns), has_attributes_(options.attributes) {
        result_.dimension = 3;
    }

    SitesFile read(bool has_header) {
        if (!chosen_.empty()) {
            choose(has_header);
        } else if (has_header) {
            read_header();
        } else {
            lines_.split_again();
        }
        if (has_attributes_ && has_header) {
            attributes_ = AttributeColumns(lines_, places_);
            lines_.keep_separator();
        }
        if (!has_header) read_site();
        while (lines_.next_line()) read_site();
        if (result_.in_space.empty()) lines_.fail_at_end_of_file("a header and no site");
        missing_radii_.note_in(result_);
        result_.attributes = std::move(attributes_).attributes();
        return std::move(result_);
    }

 private:
    static constexpr std::size_t radius = 3;
    static constexpr std::array<std::string_view, 4> names = {"x", "y", "z", "r"};

    void choose(bool has_header) {
        places_.fill(no_column);
        for (std::size_t which = 0; which < chosen_.size(); ++which) {
            const std::size_t column = lines_.chosen_column(chosen_[which], has_header);
            if (std::ranges::count(places_, column) > 0) {
                lines_.fail_at_line(fmt::format(
                    "column {} is chosen twice; x, y, z and r are different columns", column + 1));
            }
            places_[which] = column;
        }
        if (has_header && places_[radius] != no_column)
            result_.third = meaning_of_column(lines_.name(places_[radius]));
        most_ = no_column;
        lines_.keep_separator();
    }

    static std::size_t quantity_called(std::string_view name) {
        if (name == "radius" || name == "weight") return radius;
        return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    }

    void read_header() {
        places_.fill(no_column);
        std::vector<std::string> left_out;
        for (std::size_t column = 0; column < lines_.size(); ++column) {
            const std::string name = lines_.name(column);
            const std::size_t which = quantity_called(name);
            if (which == names.size()) {
                left_out.push_back(in_quotes(lines_.text(column)));
                continue;
            }
            if (places_[which] != no_column) {
                lines_.fail_at(column, which == radius
                                           ? "a second column of radii or weights; name one column "
                                             "r, radius or weight"
                                           : fmt::format("a second column {}; name one", name));
            }
            places_[which] = column;
            if (which == radius) result_.third = meaning_of_column(name);
        }
        const auto coordinates = std::span(places_).first(radius);
        if (std::ranges::count(coordinates, no_column) > 0) {
            lines_.fail_at(
                0,
                "the header does not name x, y and z; name the columns x, y, z and r (or "
                "radius, weight), or choose with --columns, as in --columns 1,2,3");
        }
        named_ = true;
        most_ = lines_.size();
        if (left_out.empty()) return;
        lines_.keep_separator();
        // Beside a radius they say something about a site; without one they may have been meant.
        if (places_[radius] == no_column) leave_out(left_out);
    }

    void leave_out(const std::vector<std::string>& names_left_out) {
        constexpr std::size_t most_shown = 12;
        const auto shown =
            std::span(names_left_out).first(std::min(names_left_out.size(), most_shown));
        const auto& [x, y, z, none] = places_;
        result_.note = fmt::format(
            "{}: {}{} {} left out: no radius, or it would be called r, radius or weight. --columns "
            "{},{},{} leaves out all others without a word",
            lines_.place_of_line(), fmt::join(shown, ", "),
            names_left_out.size() > most_shown ? " and more" : "",
            names_left_out.size() == 1 ? "is" : "are", x + 1, y + 1, z + 1);
    }

    void read_site() {
        if (lines_.size() > most_) fail_at_surplus();
        Site3 site = {read_coordinate(0), read_coordinate(1), read_coordinate(2), 0.0};
        if (places_[radius] < lines_.size()) {
            site.r = lines_.number(places_[radius]);
            if (site.r < 0.0 && !result_.first_negative)
                result_.first_negative = lines_.position_of(lines_[places_[radius]].data());
        } else if (places_[radius] != no_column && (named_ || !chosen_.empty())) {
            missing_radii_.add(lines_);
        }
        result_.in_space.push_back(site);
        attributes_.read(lines_);
    }

    double read_coordinate(std::size_t which) {
        const std::size_t column = places_[which];
        if (column < lines_.size()) return lines_.number(column);
        lines_.fail_at_end_of_line(
            named_ || !chosen_.empty()
                ? "the line ends before the columns x, y and z; write all three"
                : fmt::format("{}; a site in space has at least three: x y z [r]",
                              lines_.size() == 1 ? "one column" : "two columns"));
    }

    [[noreturn]] void fail_at_surplus() const {
        if (lines_[most_].empty()) lines_.fail_at_empty(most_);
        if (named_) {
            lines_.fail_at(
                most_,
                fmt::format("{} columns, but the header names {}; write as many, or choose with "
                            "--columns, as in --columns 1,2,3",
                            lines_.size(), most_));
        }
        lines_.fail_at(
            most_,
            fmt::format("more than four columns; a site in space is x y z [r]{}, or name the "
                        "columns x, y, z and r (or radius, weight) in a first line, or choose "
                        "with --columns, as in --columns 1,2,3",
                        lines_.has_comma() ? ", a fraction has a point" : ""));
    }

    TextColumns& lines_;
    const Columns& chosen_;
    std::array<std::size_t, 4> places_ = {0, 1, 2, 3};  ///< of x, y, z and r
    std::size_t most_ = 4;                              ///< columns in a line
    bool named_ = false;                                ///< by a header
    bool has_attributes_;                               ///< which are to be read
    AttributeColumns attributes_;
    MissingRadii missing_radii_;
    SitesFile result_;
};

}  // namespace

SitesFile read_text_sites_in_space(TextColumns& lines, const ReadOptions& options,
                                   bool has_header) {
    return TextSitesInSpace(lines, options).read(has_header);
}

}  // namespace signum
