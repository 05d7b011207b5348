/// The columns of a line are read as a site of the plane or of space. A header may name the
/// columns, and the caller may choose some; columns that are not taken may hold any text, and so
/// one separator alone separates then: that of the first line.

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "number.hpp"
#include "plain_lines.hpp"
#include "sites_readers.hpp"
#include "text_columns.hpp"

namespace signum {
namespace {

constexpr std::string_view second_third =
    "a second column of radii or weights; name one column r, radius or weight";
constexpr std::array<ColumnNames, 4> quantities_in_space = {
    {{{"x"}}, {{"y"}}, {{"z"}}, {{"r", "radius", "weight"}, second_third}}};
constexpr std::array<ColumnNames, 3> quantities_in_plane = {
    {{{"x"}}, {{"y"}}, {{"r", "radius", "weight"}, second_third}}};

/// What messages say of a site of the plane, and of one of space.
struct Words {
    std::string_view columns;        ///< of a site
    std::string_view chosen;         ///< those that --columns names, as an example
    std::string_view site;           ///< a line without a header
    std::string_view too_many;       ///< columns in it
    std::string_view ends_too_soon;  ///< a line before its coordinates
};
constexpr Words words_of_plane = {"x, y and r", "1,2", "a site is x y [r]",
                                  "more than three columns",
                                  "the line ends before the columns x and y; write both"};
constexpr Words words_of_space = {"x, y, z and r", "1,2,3", "a site in space is x y z [r]",
                                  "more than four columns",
                                  "the line ends before the columns x, y and z; write all three"};

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

bool is_x_of_geographers(std::string_view name) {
    return name == "lon" || name == "lng" || name == "longitude" || name == "easting";
}
bool is_y_of_geographers(std::string_view name) {
    return name == "lat" || name == "latitude" || name == "northing";
}

/// What the name of a column of radii or weights, in small letters, says about its numbers.
std::optional<WeightIs> meaning_of_column(std::string_view name) {
    if (name == "radius") return WeightIs::radius;
    if (name == "weight") return WeightIs::weight;
    return std::nullopt;
}

/// The option that chooses these columns, but for those that are not there.
std::string option_for(std::initializer_list<std::size_t> columns) {
    std::string text = "--columns ";
    for (const std::size_t column : columns)
        if (column != no_column)
            text += fmt::format("{}{}", text.ends_with(' ') ? "" : ",", column + 1);
    return text;
}

class TextSites {
 public:
    /// `lines` stands at the first one.
    TextSites(TextColumns& lines, const ReadOptions& options, bool in_space)
        : lines_(lines),
          options_(options),
          words_(in_space ? words_of_space : words_of_plane),
          radius_(in_space ? 3 : 2),
          most_(radius_ + 1),
          may_lie_in_space_(!options.dimension) {
        result_.dimension = in_space ? 3 : 2;
    }

    SitesFile read(bool has_header) {
        read_layout(has_header);
        if (!has_header) read_site();
        read_sites();
        const std::size_t sites = result_.sites.size() + result_.in_space.size();
        if (sites == 0) lines_.fail_at_end_of_file("a header and no site");
        if (without_radius_ > 0)
            result_.note += fmt::format(
                "{}{}: the line ends before its {}, which is 0 then ({} of {} lines)",
                result_.note.empty() ? "" : "; ", first_without_radius_,
                result_.third == WeightIs::weight ? "weight" : "radius", without_radius_, sites);
        result_.attributes = std::move(attributes_).attributes();
        return std::move(result_);
    }

 private:
    [[nodiscard]] bool in_space() const noexcept { return radius_ == 3; }

    /// From the first line, split at its own separator, and from what the caller chose.
    void read_layout(bool has_header) {
        if (!options_.columns.empty()) {
            choose(has_header);
        } else if (!has_header) {
            lines_.split_again();
        } else if (in_space()) {
            read_header_in_space();
        } else {
            read_header_in_plane();
        }
        if (has_header && places_[radius_] != no_column)
            result_.third = meaning_of_column(lines_.name(places_[radius_]));
        if (!options_.attributes || !has_header) return;
        attributes_ = AttributeColumns(lines_, std::span(places_).first(radius_ + 1));
        lines_.keep_separator();
    }

    /// Takes the columns that the caller chose.
    void choose(bool has_header) {
        places_.fill(no_column);
        for (std::size_t which = 0; which < options_.columns.size(); ++which) {
            const std::size_t column = lines_.chosen_column(options_.columns[which], has_header);
            if (std::ranges::count(places_, column) > 0) {
                lines_.fail_at_line(
                    fmt::format("column {} is chosen twice; {} are different columns", column + 1,
                                words_.columns));
            }
            places_[which] = column;
        }
        is_told_ = true;
        most_ = no_column;
        lines_.keep_separator();
    }

    /// What the columns are by their names; gives those of other names.
    std::vector<std::string> take_named(std::span<const ColumnNames> quantities) {
        NamedColumns named = named_columns(lines_, quantities);
        std::ranges::copy(named.places, places_.begin());
        is_told_ = is_named_ = true;
        most_ = lines_.size();
        return std::move(named.others);
    }

    void read_header_in_space() {
        const std::vector<std::string> others = take_named(quantities_in_space);
        if (std::ranges::count(std::span(places_).first(radius_), no_column) > 0) {
            lines_.fail_at(
                0,
                "the header does not name x, y and z; name the columns x, y, z and r (or "
                "radius, weight), or choose with --columns, as in --columns 1,2,3");
        }
        if (others.empty()) return;
        lines_.keep_separator();
        // Beside a radius they say something about a site; without one they may have been meant.
        if (places_[radius_] != no_column) return;
        constexpr std::size_t most_shown = 12;
        const auto& [x, y, z, none] = places_;
        result_.note = fmt::format(
            "{}: {}{} {} left out: no radius, or it would be called r, radius or weight. {} leaves "
            "out all others without a word",
            lines_.place_of_line(),
            fmt::join(std::span(others).first(std::min(others.size(), most_shown)), ", "),
            others.size() > most_shown ? " and more" : "", others.size() == 1 ? "is" : "are",
            option_for({x, y, z}));
    }

    /// Where neither x nor y is among the names, the first two columns that are not r stand for
    /// them.
    void read_header_in_plane() {
        take_named(quantities_in_plane);
        auto& [x, y, third, none] = places_;
        if (x == no_column && y == no_column) take_first_two();
        if (x == no_column || y == no_column) {
            lines_.fail_at(0,
                           "the header does not name both x and y; name the columns x, y and r "
                           "(or radius, weight)");
        }
        if (third == no_column && most_ > 3) {
            lines_.fail_at(
                0, fmt::format(
                       "the header names x and y and several other columns, but no r; name "
                       "one column r, radius or weight, or choose with --columns, as in "
                       "--columns x,y{}",
                       may_lie_in_space_ ? "; where one is called z, sites lie in space" : ""));
        }
        if (third == no_column && most_ == 3) {
            leave_out(3 - x - y);
        } else if (y < most_ && is_y_of_geographers(lines_.name(x))) {
            // Columns without names of ours go by their place, which those of geographers do not.
            result_.note = fmt::format("{}: {} is x and {} is y. {} takes them the other way",
                                       lines_.place_of_line(), quoted(x), quoted(y),
                                       option_for({y, x, third}));
        }
        if (third != no_column) leave_out_height();
        if (most_ > 3 || !result_.note.empty()) lines_.keep_separator();
    }

    void take_first_two() {
        if (most_ > 3) {
            lines_.fail_at(
                0,
                fmt::format(
                    "a header of more than three columns, and none is called x or y; "
                    "choose them with --columns, as in --columns 1,2{}",
                    may_lie_in_space_ ? ", or --columns 1,2,3,4 for x, y, z and r in space" : ""));
        }
        std::size_t column = 0;
        for (std::size_t which = 0; which < 2; ++which) {
            if (column == places_[radius_]) ++column;
            places_[which] = column++;
        }
        for (; column < most_; ++column)
            if (is_x_of_geographers(lines_.name(column)) ||
                is_y_of_geographers(lines_.name(column)))
                lines_.fail_at(column, fmt::format("{} stands behind the first two columns, which "
                                                   "would be x and y; choose them with --columns, "
                                                   "as in --columns 2,3",
                                                   quoted(column)));
    }

    [[nodiscard]] std::string quoted(std::size_t column) const {
        return in_quotes(lines_.text(column));
    }

    static constexpr std::string_view where_called_z = "sites lie in space where it is called z";

    /// A third column without a name that makes it one is no radius.
    void leave_out(std::size_t column) {
        const auto& [x, y, third, none] = places_;
        const bool is_height = lines_.name(column) == "z";
        const bool may_be_height = may_lie_in_space_ && may_mean_z(lines_.name(column));
        result_.note = fmt::format(
            "{}: {} is x, {} is y, and {} is left out: {}. {}{} takes it for {}, {} leaves it out "
            "without a word",
            lines_.place_of_line(), quoted(x), quoted(y), quoted(column),
            may_be_height ? where_called_z
            : is_height   ? "sites lie in the plane here"
                          : "no radius, or it would be called r, radius or weight",
            may_be_height ? "--dimension 3 " : "", option_for({x, y, column}),
            may_be_height ? "z"
            : is_height   ? "a radius"
                          : "one",
            option_for({x, y}));
    }

    /// Other columns beside x, y and r say something about a site; z says that it lies in space.
    void leave_out_height() {
        const auto& [x, y, third, none] = places_;
        std::size_t height = lines_.column_called("z");
        const bool is_height = height != no_column;
        for (std::size_t column = 0; !is_height && may_lie_in_space_ && column < most_; ++column) {
            if (column == x || column == y || column == third) continue;
            if (height == no_column && may_mean_z(lines_.name(column))) height = column;
        }
        if (height == no_column) return;
        result_.note = fmt::format(
            "{}: {} is left out: {}. {}{} leaves it out without a word", lines_.place_of_line(),
            quoted(height), is_height ? "sites lie in the plane" : where_called_z,
            is_height ? "" : option_for({x, y, height, third}) + " takes it for z, ",
            option_for({x, y, third}));
    }

    /// Block after block: plain lines at once, and what is not plain in a block line by line.
    void read_sites() {
        constexpr std::size_t block = is_for_small_files ? 2000 : std::size_t{1} << 23;
        for (;;) {
            std::int64_t others = std::numeric_limits<std::int64_t>::max();
            if (!options_.attributes) {
                const std::string_view ahead = lines_.file().lines_ahead(block);
                const PlainLines plain = read_plain_lines(
                    ahead, {.places = places_,
                            .coordinates = radius_,
                            .most = most_,
                            .separator = lines_.separator(),
                            .has_radius = is_told_ && places_[radius_] != no_column,
                            .may_be_negative = result_.first_negative.has_value(),
                            .may_be_beyond_single = result_.first_beyond_single.has_value()});
                for (const std::array<double, 4>& numbers : plain.sites)
                    result_.add(numbers, [](std::size_t) { return Position(); });
                if (plain.has_radii) note_radius();
                lines_.file().skip_lines(plain.bytes, plain.lines);
                if (plain.bytes == ahead.size() && plain.bytes > 0) continue;
                others = std::ranges::count(ahead.substr(plain.bytes), '\n') + 1;
            }
            for (; others > 0; --others) {
                if (!lines_.next_line()) return;
                read_site();
            }
        }
    }
    void note_radius() { result_.third_may_be_z = !in_space() && may_lie_in_space_ && !is_told_; }

    void read_site() {
        if (lines_.size() > most_) fail_at_surplus();
        std::array<double, 4> numbers = {};
        for (std::size_t which = 0; which < radius_; ++which)
            numbers[which] = read_column(places_[which]);
        const std::size_t last = places_[radius_];
        if (last < lines_.size()) {
            numbers[radius_] = read_column(last);
            note_radius();
        } else if (last != no_column && is_told_ && without_radius_++ == 0) {
            first_without_radius_ = lines_.place_of_line();
        }
        result_.add(numbers, [&](std::size_t which) {
            return lines_.position_of(lines_[places_[which]].data());
        });
        attributes_.read(lines_);
    }

    [[noreturn]] void fail_at_surplus() const {
        if (lines_[most_].empty()) lines_.fail_at_empty(most_);
        if (is_named_) {
            lines_.fail_at(
                most_,
                fmt::format("{} columns, but the header names {}; write as many, or choose with "
                            "--columns, as in --columns {}",
                            lines_.size(), most_, words_.chosen));
        }
        lines_.fail_at(
            most_,
            fmt::format("{}; {}{}, or name the columns {} (or radius, weight) in a first "
                        "line, or choose with --columns, as in --columns {}{}",
                        words_.too_many, words_.site,
                        lines_.has_comma() ? ", a fraction has a point" : "", words_.columns,
                        words_.chosen,
                        !in_space() && may_lie_in_space_ ? "; --dimension 3 reads x y z [r]" : ""));
    }

    double read_column(std::size_t column) {
        if (column >= lines_.size()) fail_at_end();
        const double value = lines_.number(column);
        // Of the number itself, where it stands in quotes.
        if (is_beyond_single(value) && !result_.first_beyond_single)
            result_.first_beyond_single = lines_.position_of(lines_.text(column).data());
        return value;
    }

    [[noreturn]] void fail_at_end() const {
        const bool is_short = in_space() ? !is_told_ : lines_.size() == 1;
        if (!is_short) lines_.fail_at_end_of_line(words_.ends_too_soon);
        lines_.fail_at_end_of_line(fmt::format(
            "{}; a site {}", lines_.size() == 1 ? "one column" : "two columns",
            in_space() ? "in space has at least three: x y z [r]" : "has at least two: x y [r]"));
    }

    TextColumns& lines_;
    const ReadOptions& options_;
    const Words& words_;
    std::array<std::size_t, 4> places_ = {0, 1, 2, 3};  ///< of x, y, in space z, and r
    std::size_t radius_;                                ///< among them
    std::size_t most_;                                  ///< columns in a line
    bool is_told_ = false;   ///< which columns there are, by a header or by the caller
    bool is_named_ = false;  ///< by a header
    bool may_lie_in_space_;  ///< nobody has said where the sites lie
    AttributeColumns attributes_;
    /// Sites whose lines end before a column of radii or weights that a header names, or that the
    /// caller chose.
    std::size_t without_radius_ = 0;
    std::string first_without_radius_;  ///< its place
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

SitesFile read_text_sites(InputFile& file, const ReadOptions& options) {
    const std::optional<int> dimension = options.dimension;
    TextColumns lines(file, advice_of(dimension == 3));
    if (!lines.next_line()) lines.fail_at_end_of_file("no site in this file");
    refuse_other_formats(lines);
    const bool has_header = lines.is_header();
    const bool in_space =
        dimension ? *dimension == 3 : lie_in_space(lines, options.columns, has_header);
    lines.advise(advice_of(in_space));
    return TextSites(lines, options, in_space).read(has_header);
}

}  // namespace signum
