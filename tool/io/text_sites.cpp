/// The columns of a line are read as a site. A header may name the columns, and the caller may
/// choose some; columns that are not taken may hold any text, and so one separator alone separates
/// then: that of the first line.

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "number.hpp"
#include "text_columns.hpp"
#include "text_sites.hpp"

namespace signum {
namespace {

/// Whether the name of a column, in small letters, is not z but may have been meant so: z is a word
/// of it, as in z_um and pos.z, or one of its two characters.
bool may_mean_z(std::string_view name) {
    const auto is_letter = [&](std::size_t i) {
        return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i])) != 0;
    };
    if (name.size() < 2) return false;
    for (std::size_t i = name.find('z'); i != std::string_view::npos; i = name.find('z', i + 1))
        if (name.size() == 2 || (!is_letter(i - 1) && !is_letter(i + 1))) return true;
    return false;
}

/// Where the numbers of a site stand.
struct Layout {
    std::array<std::size_t, 3> columns = {0, 1, 2};  ///< of x, y, r; no_column where there is no r
    std::size_t size = 3;                            ///< columns in a line, at most
    bool named = false;                              ///< by a header
};

class TextSites {
 public:
    /// `lines` stands at the first one.
    TextSites(TextColumns& lines, const ReadOptions& options)
        : columns_(lines),
          chosen_(options.columns),
          may_lie_in_space_(!options.dimension),
          has_attributes_(options.attributes) {}

    SitesFile read(bool has_header) {
        read_layout(has_header);
        if (!has_header) read_site();
        while (columns_.next_line()) read_site();
        if (result_.sites.empty()) columns_.fail_at_end_of_file("a header and no site");
        missing_radii_.note_in(result_);
        result_.attributes = std::move(attributes_).attributes();
        return std::move(result_);
    }

 private:
    /// From the first line, split at its own separator, and from what the caller chose.
    void read_layout(bool has_header) {
        if (!chosen_.empty()) {
            choose(has_header);
        } else if (has_header) {
            read_header();
        } else {
            columns_.split_again();
        }
        if (!has_attributes_ || !has_header) return;
        attributes_ = AttributeColumns(columns_, layout_.columns);
        columns_.keep_separator();
    }

    /// Takes the columns that the caller chose.
    void choose(bool has_header) {
        layout_.columns = {no_column, no_column, no_column};
        for (std::size_t which = 0; which < chosen_.size(); ++which) {
            const std::size_t column = columns_.chosen_column(chosen_[which], has_header);
            if (std::ranges::count(layout_.columns, column) > 0) {
                columns_.fail_at_line(fmt::format(
                    "column {} is chosen twice; x, y and r are different columns", column + 1));
            }
            layout_.columns[which] = column;
        }
        if (has_header && layout_.columns[2] != no_column) {
            result_.third = meaning_of_column(columns_.name(layout_.columns[2]));
        }
        layout_.size = no_column;
        columns_.keep_separator();
    }

    /// Finds x, y and r among the names. Where neither x nor y is there, the first two columns that
    /// are not r stand for them.
    void read_header() {
        std::array<std::size_t, 3> found = {no_column, no_column, no_column};
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const std::string name = columns_.name(column);
            const bool is_third = name == "r" || name == "radius" || name == "weight";
            const std::size_t which = name == "x" ? 0 : name == "y" ? 1 : is_third ? 2 : no_column;
            if (which == no_column) continue;
            if (found[which] != no_column) {
                columns_.fail_at(column, which == 2
                                             ? "a second column of radii or weights; name one "
                                               "column r, radius or weight"
                                             : "a second column " + name + "; name one");
            }
            found[which] = column;
            if (which == 2) result_.third = meaning_of_column(name);
        }
        if (found[0] == no_column && found[1] == no_column) {
            if (columns_.size() > 3) {
                columns_.fail_at(
                    0,
                    fmt::format("a header of more than three columns, and none is called x or y; "
                                "choose them with --columns, as in --columns 1,2{}",
                                may_lie_in_space_ ? ", or --columns 1,2,3,4 for x, y, z and r in "
                                                    "space"
                                                  : ""));
            }
            std::size_t column = 0;
            for (std::size_t which = 0; which < 2; ++which) {
                if (column == found[2]) ++column;
                found[which] = column++;
            }
            for (; column < columns_.size(); ++column)
                if (is_x_of_geographers(columns_.name(column)) ||
                    is_y_of_geographers(columns_.name(column)))
                    columns_.fail_at(
                        column, fmt::format("{} stands behind the first two columns, which would "
                                            "be x and y; choose them with --columns, as in "
                                            "--columns 2,3",
                                            in_quotes(columns_.text(column))));
        }
        if (found[0] == no_column || found[1] == no_column) {
            columns_.fail_at(0,
                             "the header does not name both x and y; name the columns x, y and r "
                             "(or radius, weight)");
        }
        if (found[2] == no_column && columns_.size() > 3) {
            columns_.fail_at(
                0, fmt::format(
                       "the header names x and y and several other columns, but no r; name "
                       "one column r, radius or weight, or choose with --columns, as in "
                       "--columns x,y{}",
                       may_lie_in_space_ ? "; where one is called z, sites lie in space" : ""));
        }
        layout_ = {found, columns_.size(), true};
        if (found[2] == no_column && columns_.size() == 3) {
            leave_out(3 - found[0] - found[1]);
        } else if (found[1] < columns_.size() && is_y_of_geographers(columns_.name(found[0]))) {
            say_which_is_x();
        }
        if (found[2] != no_column) leave_out_height();
        if (columns_.size() > 3 || !result_.note.empty()) columns_.keep_separator();
    }

    static bool is_x_of_geographers(std::string_view name) {
        return name == "lon" || name == "lng" || name == "longitude" || name == "easting";
    }
    static bool is_y_of_geographers(std::string_view name) {
        return name == "lat" || name == "latitude" || name == "northing";
    }

    /// Columns without names of ours go by their place, which those of geographers do not.
    void say_which_is_x() {
        const auto& [x, y, third] = layout_.columns;
        result_.note = fmt::format(
            "{}: {} is x and {} is y. --columns {},{}{} takes them the other way",
            columns_.place_of_line(), in_quotes(columns_.text(x)), in_quotes(columns_.text(y)),
            y + 1, x + 1, third == no_column ? "" : fmt::format(",{}", third + 1));
    }

    /// A third column without a name that makes it one is no radius.
    void leave_out(std::size_t column) {
        const auto& [x, y, none] = layout_.columns;
        const bool is_height = columns_.name(column) == "z";
        if (may_lie_in_space_ && may_mean_z(columns_.name(column))) {
            result_.note = fmt::format(
                "{}: {} is x, {} is y, and {} is left out: sites lie in space where it is called "
                "z. --dimension 3 --columns {},{},{} takes it for z, --columns {},{} leaves it out "
                "without a word",
                columns_.place_of_line(), in_quotes(columns_.text(x)), in_quotes(columns_.text(y)),
                in_quotes(columns_.text(column)), x + 1, y + 1, column + 1, x + 1, y + 1);
            return;
        }
        result_.note = fmt::format(
            "{}: {} is x, {} is y, and {} is left out: {}. --columns {},{},{} takes it for {}, "
            "--columns {},{} leaves it out without a word",
            columns_.place_of_line(), in_quotes(columns_.text(x)), in_quotes(columns_.text(y)),
            in_quotes(columns_.text(column)),
            is_height ? "sites lie in the plane here"
                      : "no radius, or it would be called r, radius or weight",
            x + 1, y + 1, column + 1, is_height ? "a radius" : "one", x + 1, y + 1);
    }

    /// Other columns beside x, y and r say something about a site; z says that it lies in space.
    void leave_out_height() {
        const std::size_t height = columns_.column_called("z");
        if (height == no_column) return leave_out_what_may_be_height();
        const auto& [x, y, third] = layout_.columns;
        result_.note = fmt::format(
            "{}: {} is left out: sites lie in the plane. --columns {},{},{} leaves it out "
            "without a word",
            columns_.place_of_line(), in_quotes(columns_.text(height)), x + 1, y + 1, third + 1);
    }

    void leave_out_what_may_be_height() {
        if (!may_lie_in_space_) return;
        const auto& [x, y, third] = layout_.columns;
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            if (column == x || column == y || column == third) continue;
            if (!may_mean_z(columns_.name(column))) continue;
            result_.note = fmt::format(
                "{}: {} is left out: sites lie in space where it is called z. --columns "
                "{},{},{},{} takes it for z, --columns {},{},{} leaves it out without a word",
                columns_.place_of_line(), in_quotes(columns_.text(column)), x + 1, y + 1,
                column + 1, third + 1, x + 1, y + 1, third + 1);
            return;
        }
    }

    void read_site() {
        if (columns_.size() > layout_.size) fail_at_surplus();
        Site site;
        site.x = read_column(layout_.columns[0]);
        site.y = read_column(layout_.columns[1]);
        if (layout_.columns[2] < columns_.size()) {
            site.r = read_column(layout_.columns[2]);
            result_.third_may_be_z = may_lie_in_space_ && !layout_.named && chosen_.empty();
            if (site.r < 0.0 && !result_.first_negative) {
                result_.first_negative = columns_.position_of(columns_[layout_.columns[2]].data());
            }
        } else if (layout_.columns[2] != no_column && (layout_.named || !chosen_.empty())) {
            missing_radii_.add(columns_);
        }
        result_.sites.push_back(site);
        attributes_.read(columns_);
    }

    [[noreturn]] void fail_at_surplus() const {
        if (columns_[layout_.size].empty()) columns_.fail_at_empty(layout_.size);
        if (layout_.named) {
            columns_.fail_at(
                layout_.size,
                fmt::format("{} columns, but the header names {}; write as many, or choose with "
                            "--columns, as in --columns 1,2",
                            columns_.size(), layout_.size));
        }
        columns_.fail_at(layout_.size,
                         fmt::format("more than three columns; a site is x y [r]{}, or name the "
                                     "columns x, y and r (or radius, weight) in a first line, or "
                                     "choose with --columns, as in --columns 1,2{}",
                                     columns_.has_comma() ? ", a fraction has a point" : "",
                                     may_lie_in_space_ ? "; --dimension 3 reads x y z [r]" : ""));
    }

    double read_column(std::size_t column) {
        if (column >= columns_.size()) {
            columns_.fail_at_end_of_line(
                columns_.size() == 1 ? "one column; a site has at least two: x y [r]"
                                     : "the line ends before the columns x and y; write both");
        }
        const double value = columns_.number(column);
        if (is_beyond_single(value) && !result_.first_beyond_single)
            result_.first_beyond_single = columns_.position_of(columns_.text(column).data());
        return value;
    }

    TextColumns& columns_;
    const Columns& chosen_;
    bool may_lie_in_space_;  ///< nobody has said that the sites lie in the plane
    bool has_attributes_;    ///< which are to be read
    Layout layout_;
    AttributeColumns attributes_;
    MissingRadii missing_radii_;
    SitesFile result_;
};

/// What a header, or the columns that were chosen, say where nobody has said it.
bool lie_in_space(const TextColumns& lines, const Columns& chosen, bool has_header) {
    if (chosen.size() == 4) return true;
    if (chosen.size() == 3)
        return has_header && lines.name(lines.chosen_column(chosen[2], has_header)) == "z";
    return chosen.empty() && has_header && lines.column_called("x") != no_column &&
           lines.column_called("y") != no_column && lines.column_called("z") != no_column;
}

std::string advice_of(bool in_space) {
    return fmt::format("write one site a line: {}", in_space ? "x y z [r]" : "x y [r]");
}

/// What holds atoms, too, and may have been taken for text.
void refuse_other_formats(const TextColumns& lines) {
    if (lines.size() != 1 || !lines.name(0).starts_with("data_")) return;
    lines.fail_at(0,
                  "this is mmCIF, which is not read; give the atoms as PDB, PQR or XYZ, or their "
                  "coordinates as lines x,y,z,r below this header");
}

}  // namespace

void MissingRadii::note_in(SitesFile& file) const {
    if (count_ == 0) return;
    file.note += fmt::format("{}{}: the line ends before its {}, which is 0 then ({} of {} lines)",
                             file.note.empty() ? "" : "; ", place_,
                             file.third == WeightIs::weight ? "weight" : "radius", count_,
                             file.sites.size() + file.in_space.size());
}

std::optional<WeightIs> meaning_of_column(std::string_view name) {
    if (name == "radius") return WeightIs::radius;
    if (name == "weight") return WeightIs::weight;
    return std::nullopt;
}

SitesFile read_text_sites(InputFile& file, const ReadOptions& options) {
    const std::optional<int> dimension = options.dimension;
    TextColumns lines(file, advice_of(dimension == 3));
    if (!lines.next_line()) lines.fail_at_end_of_file("no site in this file");
    refuse_other_formats(lines);
    const bool has_header = lines.is_header();
    const bool in_space =
        dimension ? *dimension == 3 : lie_in_space(lines, options.columns, has_header);
    lines.advise(advice_of(in_space));
    return in_space ? read_text_sites_in_space(lines, options, has_header)
                    : TextSites(lines, options).read(has_header);
}

}  // namespace signum
