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

#include "coordinate_names.hpp"
#include "foreign_sites.hpp"
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
            add_to_note(
                fmt::format("{}: the line ends before its radius, which is 0 then ({} of {} lines)",
                            first_without_radius_, without_radius_, sites));
        if (missing_ > 0)
            add_to_note(fmt::format("{}: a number is missing; {} of {} lines are passed over",
                                    first_missing_, missing_, missing_ + sites));
        if (result_.third_may_be_z)
            add_to_note(
                fmt::format("{}: three numbers a line are x, y and r; --dimension 3 takes "
                            "them for x, y and z, --columns 1,2 leaves the third out",
                            lines_.file().path()));
        result_.attributes = std::move(attributes_).attributes();
        return std::move(result_);
    }

 private:
    [[nodiscard]] bool in_space() const noexcept { return radius_ == 3; }
    void add_to_note(std::string_view sentence) {
        result_.note += fmt::format("{}{}", result_.note.empty() ? "" : "; ", sentence);
    }

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
        if (has_header) {
            columns_of_header_ = lines_.size();
            if (places_[radius_] != no_column)
                result_.third = meaning_of_column(lines_.name(places_[radius_]));
            result_.are_degrees =
                !in_space() && is_of(NameFamily::geographic, 0) && is_of(NameFamily::geographic, 1);
        }
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
        most_ = has_header ? lines_.size() : no_column;
        lines_.keep_separator();
    }

    /// What the columns are by their names; gives those of other names.
    std::vector<std::string> take_named(std::span<const ColumnNames> quantities) {
        NamedColumns named = named_columns(lines_, quantities);
        std::ranges::copy(named.places, places_.begin());
        is_told_ = true;
        most_ = lines_.size();
        return std::move(named.others);
    }

    void read_header_in_space() {
        const std::vector<std::string> others = take_named(quantities_in_space);
        if (std::ranges::count(std::span(places_).first(radius_), no_column) > 0) {
            lines_.fail_at(0,
                           fmt::format("the header does not name x, y and z, but {}; choose them "
                                       "with --columns, as in --columns 1,2,3",
                                       lines_.names()));
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

    /// Whether the column of x (0) or y (1) has a name of that family.
    [[nodiscard]] bool is_of(NameFamily family, int axis) const {
        const std::size_t column = places_[static_cast<std::size_t>(axis)];
        return column < lines_.size() &&
               coordinate_named(lines_.text(column)) == CoordinateName{family, axis};
    }

    void read_header_in_plane() {
        take_named(quantities_in_plane);
        auto& [x, y, third, none] = places_;
        const bool are_called_so = x != no_column && y != no_column;
        if (x == no_column && y == no_column && !take_known_names()) take_first_two();
        if (x == no_column || y == no_column) {
            lines_.fail_at(0, fmt::format("the header does not name both x and y, but {}; choose "
                                          "them with --columns, as in --columns 1,2",
                                          lines_.names()));
        }
        if (!are_called_so)
            add_to_note(fmt::format(
                "{}: {} is x and {} is y{}", lines_.place_of_line(), quoted(x), quoted(y),
                is_of(NameFamily::geographic, 0) ? ", degrees that are taken for a plane's" : ""));
        leave_others_out();
        if (most_ > 3 || !result_.note.empty()) lines_.keep_separator();
    }

    /// What programs call x and y: POINT_X, easting, Longitude. False where none is there.
    bool take_known_names() {
        constexpr std::array families = {NameFamily::letters, NameFamily::projected,
                                         NameFamily::geographic, NameFamily::initials};
        std::array<std::array<std::vector<std::size_t>, 2>, families.size()> found;
        for (std::size_t column = 0; column < most_; ++column) {
            const auto name = coordinate_named(lines_.text(column));
            if (column != places_[radius_] && name && name->axis < 2)
                found[static_cast<std::size_t>(name->family)][static_cast<std::size_t>(name->axis)]
                    .push_back(column);
        }
        const auto are_two = [](const auto& of) { return !of[0].empty() && !of[1].empty(); };
        const auto count = std::ranges::count_if(found, are_two);
        if (count == 0) return false;
        const auto& [of_x, of_y] = *std::ranges::find_if(found, are_two);
        if (count > 1 || of_x.size() > 1 || of_y.size() > 1)
            lines_.fail_at(
                of_x.front(),
                fmt::format("several columns may be x and y among {}; choose with "
                            "--columns, as in --columns {},{}",
                            lines_.names(), lines_.text(of_x.front()), lines_.text(of_y.front())));
        places_[0] = of_x.front();
        places_[1] = of_y.front();
        return true;
    }

    /// Of names that say nothing, where there are no more than three; what numbers the rows is no
    /// coordinate.
    void take_first_two() {
        std::vector<std::size_t> free;
        bool has_half = false;
        for (std::size_t column = 0; column < most_; ++column) {
            const auto name = coordinate_named(lines_.text(column));
            has_half |= name && name->family != NameFamily::initials;
            if (column != places_[radius_] && !is_name_of_identifier(lines_.text(column)))
                free.push_back(column);
        }
        if (most_ > 3 || free.size() < 2 || has_half)
            lines_.fail_at(0,
                           fmt::format("none of the columns {} is called x or y; choose them with "
                                       "--columns, as in --columns 1,2{}",
                                       lines_.names(),
                                       may_lie_in_space_ && most_ > 3
                                           ? ", or --columns 1,2,3,4 for x, y, z and r in space"
                                           : ""));
        places_[0] = free[0];
        places_[1] = free[1];
    }

    [[nodiscard]] std::string quoted(std::size_t column) const {
        return in_quotes(lines_.text(column));
    }

    /// A column without a name that makes it one is no radius; z says that sites lie in space.
    void leave_others_out() {
        constexpr std::size_t most_shown = 12;
        const auto& [x, y, third, none] = places_;
        std::vector<std::string> names;
        std::size_t height = no_column;
        std::size_t first = no_column;
        for (std::size_t column = 0; column < most_; ++column) {
            if (column == x || column == y || column == third) continue;
            const bool is_height = lines_.name(column) == "z" ||
                                   (may_lie_in_space_ && may_mean_z(lines_.name(column)));
            if (is_height && height == no_column) height = column;
            // Beside a radius other columns say something about a site.
            if (third != no_column && !is_height) continue;
            if (is_name_of_identifier(lines_.text(column))) continue;
            if (first == no_column) first = column;
            if (names.size() < most_shown) names.push_back(quoted(column));
        }
        if (names.empty()) return;
        const bool is_z = height != no_column && lines_.name(height) == "z";
        const bool is_one = names.size() == 1;
        const std::string why = height == no_column
                                    ? "no radius, or it would be called r, radius or weight"
                                : is_z ? std::string("sites lie in the plane here")
                                       : std::string("sites lie in space where it is called z");
        const std::size_t meant = height == no_column ? first : height;
        const std::string taken =
            third != no_column && is_z ? ""
            : height == no_column      ? option_for({x, y, meant}) + " takes it for one, "
            : is_z                     ? option_for({x, y, meant}) + " takes it for a radius, "
                   : "--dimension 3 " + option_for({x, y, meant, third}) + " takes it for z, ";
        add_to_note(fmt::format(
            "{}: {} {} {}: {}. {}{} leaves {} out without a word", lines_.place_of_line(),
            fmt::join(names, ", "), is_one ? "is" : "are",
            options_.attributes ? "carried along" : "left out", why, is_one ? taken : std::string(),
            option_for({x, y, third}), is_one ? "it" : "them"));
    }

    /// Block after block: plain lines at once, and what is not plain in a block line by line.
    void read_sites() {
        constexpr std::size_t block = is_for_small_files ? 2000 : std::size_t{1} << 23;
        for (;;) {
            std::int64_t others = std::numeric_limits<std::int64_t>::max();
            if (!options_.attributes && options_.decimal == '.') {
                const std::string_view ahead = lines_.file().lines_ahead(block);
                const PlainLines plain = read_plain_lines(
                    ahead, {.places = places_,
                            .coordinates = radius_,
                            .least = columns_of_header_,
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
        if (lines_.size() < columns_of_header_)
            lines_.fail_at_end_of_line(
                fmt::format("{} column{}, but the header names {}; write as many", lines_.size(),
                            lines_.size() == 1 ? "" : "s", columns_of_header_));
        if (options_.skips_missing && has_missing()) {
            if (missing_++ == 0) first_missing_ = lines_.place_of_line();
            return;
        }
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

    [[nodiscard]] bool has_missing() const {
        return std::ranges::any_of(std::span(places_).first(radius_ + 1), [&](std::size_t column) {
            return column < lines_.size() && lines_.is_missing(column);
        });
    }

    [[noreturn]] void fail_at_surplus() const {
        if (columns_of_header_ == 0 && lines_[most_].empty()) lines_.fail_at_empty(most_);
        if (columns_of_header_ > 0)
            lines_.fail_at(most_, fmt::format("{} columns, but the header names {}; write as many",
                                              lines_.size(), columns_of_header_));
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
    std::size_t columns_of_header_ = 0;  ///< 0 where there is none
    bool may_lie_in_space_;  ///< nobody has said where the sites lie
    AttributeColumns attributes_;
    /// Sites whose lines end before a column of radii or weights that a header names, or that the
    /// caller chose.
    std::size_t without_radius_ = 0;
    std::string first_without_radius_;  ///< its place
    std::size_t missing_ = 0;           ///< lines that lack a number, and are passed over
    std::string first_missing_;         ///< the place of the first
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

}  // namespace

SitesFile read_text_sites(InputFile& file, const ReadOptions& options) {
    const std::optional<int> dimension = options.dimension;
    if (options.skipped_lines == 0)
        if (const std::string other = other_format(file.first_bytes()); !other.empty())
            file.fail({1, 1}, other);
    TextColumns lines(file, advice_of(dimension == 3), options.decimal);
    std::string_view passed;
    for (std::int64_t line = 0; line < options.skipped_lines; ++line)
        if (!file.next_line(passed, advice_of(dimension == 3))) break;
    if (!lines.next_line()) lines.fail_at_end_of_file("no site in this file");
    const bool has_header = lines.is_header();
    const bool in_space =
        dimension ? *dimension == 3 : lie_in_space(lines, options.columns, has_header);
    lines.advise(advice_of(in_space));
    return TextSites(lines, options, in_space).read(has_header);
}

}  // namespace signum
