/// A line is split into columns, the columns are read as numbers. A header may name the columns,
/// and the caller may choose some; columns that are not taken may hold any text, and so one
/// separator alone separates then: that of the first line.

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "nearest_word.hpp"
#include "number.hpp"
#include "text_sites.hpp"

namespace signum {
namespace {

constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();
constexpr char any_separator = '\0';

bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t';
}
bool is_mark(char c) noexcept {
    return c == ',' || c == ';';
}

/// Where the numbers of a site stand, and how columns are told apart.
struct Layout {
    std::array<std::size_t, 3> columns = {0, 1, 2};  ///< of x, y, r; no_column where there is no r
    std::size_t size = 3;                            ///< columns in a line, at most
    char separator = any_separator;                  ///< the only one, or any_separator
    bool named = false;                              ///< by a header
};

class TextSites {
 public:
    TextSites(InputFile& file, const Columns& chosen) : file_(file), chosen_(chosen) {}

    SitesFile read() {
        bool first = true;
        while (file_.next_line(line_)) {
            split_at(first ? separator_of_line() : layout_.separator);
            if (columns_.empty()) continue;
            if (std::exchange(first, false) && read_layout()) continue;
            read_site();
        }
        if (result_.sites.empty()) {
            file_.fail({std::max<std::int64_t>(file_.line_number(), 1), 1},
                       first ? "no site in this file; write one site a line: x y [r]"
                             : "a header and no site; write one site a line: x y [r]");
        }
        return std::move(result_);
    }

 private:
    [[nodiscard]] Position position_of(const char* place) const {
        return {file_.line_number(), place - line_.data() + 1};
    }
    [[noreturn]] void fail(const char* place, std::string_view message) const {
        file_.fail(position_of(place), message);
    }
    [[noreturn]] void fail_at_column(std::size_t column, std::string_view message) const {
        fail(columns_[column].data(), message);
    }

    [[noreturn]] void fail_at_empty_column(std::size_t column) const {
        fail_at_column(column, "an empty column; write a number or remove the separator");
    }

    void split_at(char separator) {
        if (separator == any_separator) {
            split_at_any();
        } else {
            split_at_one(separator);
        }
    }

    /// Columns end at blanks and tabs, or at one comma or semicolon with or without blanks around
    /// it, but not at both in one line: 1,5 2 is more likely two numbers than three.
    void split_at_any() {
        columns_.clear();
        const char* place = line_.data();
        const char* const end = place + line_.size();
        const auto skip_blanks = [&] {
            while (place != end && is_blank(*place)) ++place;
        };
        const auto is_over = [&] { return place == end || *place == '#'; };
        char mark = '\0';
        bool at_blanks = false;
        const auto refuse_both = [&](std::string_view one, std::string_view other) {
            fail(place, fmt::format("{} and {} in one line; separate by one of them, and write "
                                    "fractions with a point",
                                    one, other));
        };
        const auto name_of_mark = [&] { return mark == ',' ? "commas" : "semicolons"; };
        skip_blanks();
        if (is_over()) return;
        for (;;) {
            const char* start = place;
            while (!is_over() && !is_blank(*place) && !is_mark(*place)) ++place;
            columns_.emplace_back(start, static_cast<std::size_t>(place - start));
            skip_blanks();
            if (is_over()) return;
            if (!is_mark(*place)) {
                if (mark != '\0') refuse_both(name_of_mark(), "blanks");
                at_blanks = true;
                continue;
            }
            if (mark != '\0' && mark != *place) refuse_both("commas", "semicolons");
            mark = *place;
            if (at_blanks) refuse_both(name_of_mark(), "blanks");
            ++place;
            skip_blanks();
            if (is_over()) {
                columns_.emplace_back(place, 0);
                return;
            }
        }
    }

    /// Columns end at `separator`; a column in double quotes may contain it.
    void split_at_one(char separator) {
        columns_.clear();
        const char* place = line_.data();
        const char* const end = place + line_.size();
        const auto is_over = [&] { return place == end || *place == '#'; };
        const auto skip_blanks = [&] {
            while (place != end && is_blank(*place) && *place != separator) ++place;
        };
        skip_blanks();
        if (is_over()) return;
        for (;;) {
            const char* start = place;
            bool quoted = false;
            while (place != end && (quoted || (*place != separator && *place != '#'))) {
                if (*place == '"') quoted = !quoted;
                ++place;
            }
            if (quoted) fail(start, "a quotation mark that nothing on this line closes; close it");
            const char* last = place;
            while (last != start && is_blank(last[-1])) --last;
            columns_.emplace_back(start, static_cast<std::size_t>(last - start));
            if (is_over()) return;
            ++place;
            skip_blanks();
        }
    }

    /// The first comma or semicolon of the line, else the tab, else none in particular; what stands
    /// between quotes does not count. Columns that are aligned by several tabs have none.
    [[nodiscard]] char separator_of_line() const {
        bool quoted = false;
        bool has_tab = false;
        for (const char c : line_) {
            if (c == '"') quoted = !quoted;
            if (quoted) continue;
            if (c == '#') break;
            if (is_mark(c)) return c;
            has_tab = has_tab || c == '\t';
        }
        const bool is_aligned = line_.find("\t\t") != std::string_view::npos;
        return has_tab && !is_aligned ? '\t' : any_separator;
    }

    /// From the first line, split at its own separator, and from what the caller chose. Returns
    /// whether the line is a header.
    bool read_layout() {
        const bool has_header = is_header();
        if (has_header) refuse_control_characters();
        if (!chosen_.empty()) {
            choose(has_header);
        } else if (has_header) {
            read_header();
        } else {
            split_at(layout_.separator);
        }
        return has_header;
    }

    /// A header holds no number, and nothing that was meant as one.
    [[nodiscard]] bool is_header() const {
        return std::none_of(columns_.begin(), columns_.end(), [](std::string_view text) {
            if (parse_number(text).fault != NumberFault::word) return true;
            const std::size_t start = text.find_first_not_of("+-.\"");
            return start != std::string_view::npos &&
                   std::isdigit(static_cast<unsigned char>(text[start])) != 0;
        });
    }

    void refuse_control_characters() const {
        for (const char& c : line_) {
            if (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) {
                fail(&c, "a control character, so this is no text; write one site a line: x y [r]");
            }
        }
    }

    /// Takes the columns that the caller chose.
    void choose(bool has_header) {
        layout_.columns = {no_column, no_column, no_column};
        for (std::size_t which = 0; which < chosen_.size(); ++which) {
            const std::size_t column = chosen_column(chosen_[which], has_header);
            if (std::ranges::count(layout_.columns, column) > 0) {
                fail(line_.data(), fmt::format("column {} is chosen twice; x, y and r are "
                                               "different columns",
                                               column + 1));
            }
            layout_.columns[which] = column;
        }
        if (has_header && layout_.columns[2] != no_column) {
            result_.third = meaning_of(plain_name(columns_[layout_.columns[2]]));
        }
        layout_.size = no_column;
        layout_.separator = separator_of_line();
    }

    [[nodiscard]] std::size_t chosen_column(std::string_view chosen, bool has_header) const {
        if (const auto number = parse_whole_number(chosen)) {
            if (*number >= 1 && *number <= columns_.size()) return *number - 1;
            fail(line_.data(), fmt::format("there is no column {}; columns count from 1, and this "
                                           "line has {}",
                                           *number, columns_.size()));
        }
        if (!has_header) {
            fail(line_.data(), fmt::format("column {} is chosen by name, and the first line is no "
                                           "header; choose by number, from 1 to {}",
                                           in_quotes(chosen), columns_.size()));
        }
        const auto is_chosen = [&](std::string_view text) {
            return plain_name(text) == in_small_letters(chosen);
        };
        const auto found = std::ranges::find_if(columns_, is_chosen);
        if (found == columns_.end()) fail(line_.data(), no_such_column(chosen));
        if (std::ranges::count_if(columns_, is_chosen) > 1) {
            fail_at_column(
                static_cast<std::size_t>(found - columns_.begin()),
                fmt::format("several columns are called {}; choose by number", in_quotes(chosen)));
        }
        return static_cast<std::size_t>(found - columns_.begin());
    }

    [[nodiscard]] std::string no_such_column(std::string_view chosen) const {
        constexpr std::size_t most_shown = 12;
        std::vector<std::string> names;
        for (const std::string_view column : columns_) names.emplace_back(unquoted(column));
        const std::optional<std::string> meant = nearest_word(chosen, names);
        std::string shown;
        for (std::size_t i = 0; i < std::min(names.size(), most_shown); ++i)
            shown += (i > 0 ? ", " : "") + in_quotes(names[i]);
        return fmt::format("no column is called {}{} there are {}{}", in_quotes(chosen),
                           meant ? "; did you mean " + in_quotes(*meant) + "?" : ";", shown,
                           names.size() > most_shown ? ", ..." : "");
    }

    /// What the name of a third column says about its numbers.
    static std::optional<WeightIs> meaning_of(std::string_view name) {
        if (name == "radius") return WeightIs::radius;
        if (name == "weight") return WeightIs::weight;
        return std::nullopt;
    }

    /// Finds x, y and r among the names. Where neither x nor y is there, the first two columns that
    /// are not r stand for them.
    void read_header() {
        std::array<std::size_t, 3> found = {no_column, no_column, no_column};
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const std::string name = plain_name(columns_[column]);
            const bool is_third = name == "r" || name == "radius" || name == "weight";
            const std::size_t which = name == "x" ? 0 : name == "y" ? 1 : is_third ? 2 : no_column;
            if (which == no_column) continue;
            if (found[which] != no_column) {
                fail_at_column(column, which == 2 ? "a second column of radii or weights; name one "
                                                    "column r, radius or weight"
                                                  : "a second column " + name + "; name one");
            }
            found[which] = column;
            if (which == 2) result_.third = meaning_of(name);
        }
        if (found[0] == no_column && found[1] == no_column) {
            if (columns_.size() > 3) {
                fail_at_column(0,
                               "a header of more than three columns, and none is called x or y; "
                               "choose them with --columns, as in --columns 1,2");
            }
            std::size_t column = 0;
            for (std::size_t which = 0; which < 2; ++which) {
                if (column == found[2]) ++column;
                found[which] = column++;
            }
        }
        if (found[0] == no_column || found[1] == no_column) {
            fail_at_column(0,
                           "the header does not name both x and y; name the columns x, y and r "
                           "(or radius, weight)");
        }
        if (found[2] == no_column && columns_.size() > 3) {
            fail_at_column(0,
                           "the header names x and y and several other columns, but no r; name one "
                           "column r, radius or weight, or choose with --columns, as in --columns "
                           "x,y");
        }
        layout_ = {found, columns_.size(), any_separator, true};
        if (found[2] == no_column && columns_.size() == 3) {
            leave_out(3 - found[0] - found[1]);
        } else if (is_y_of_geographers(plain_name(columns_[found[0]]))) {
            say_which_is_x();
        }
        if (found[2] != no_column) leave_out_height();
        if (columns_.size() > 3 || !result_.note.empty()) layout_.separator = separator_of_line();
    }

    static bool is_y_of_geographers(std::string_view name) {
        return name == "lat" || name == "latitude" || name == "northing";
    }

    /// Columns without names of ours go by their place, which those of geographers do not.
    void say_which_is_x() {
        const auto& [x, y, third] = layout_.columns;
        result_.note = fmt::format(
            "{}:{}: {} is x and {} is y. --columns {},{}{} takes them the other way", file_.path(),
            file_.line_number(), in_quotes(unquoted(columns_[x])), in_quotes(unquoted(columns_[y])),
            y + 1, x + 1, third == no_column ? "" : fmt::format(",{}", third + 1));
    }

    /// A third column without a name that makes it one is no radius.
    void leave_out(std::size_t column) {
        const auto& [x, y, none] = layout_.columns;
        result_.note = fmt::format(
            "{}:{}: {} is x, {} is y, and {} is left out: no radius, or it would be called r, "
            "radius or weight. --columns {},{},{} takes it for one, --columns {},{} leaves it out "
            "without a word",
            file_.path(), file_.line_number(), in_quotes(unquoted(columns_[x])),
            in_quotes(unquoted(columns_[y])), in_quotes(unquoted(columns_[column])), x + 1, y + 1,
            column + 1, x + 1, y + 1);
    }

    /// Other columns beside x, y and r say something about a site; z says that it lies in space.
    void leave_out_height() {
        const auto is_height = [](std::string_view text) { return plain_name(text) == "z"; };
        const auto found = std::ranges::find_if(columns_, is_height);
        if (found == columns_.end()) return;
        const auto& [x, y, third] = layout_.columns;
        result_.note = fmt::format(
            "{}:{}: {} is left out: sites lie in the plane. --columns {},{},{} leaves it out "
            "without a word",
            file_.path(), file_.line_number(), in_quotes(unquoted(*found)), x + 1, y + 1,
            third + 1);
    }

    /// A column without the double quotes around it.
    static std::string_view unquoted(std::string_view text) {
        if (text.size() < 2 || text.front() != '"' || text.back() != '"') return text;
        return text.substr(1, text.size() - 2);
    }
    static std::string plain_name(std::string_view text) {
        return in_small_letters(unquoted(text));
    }

    void read_site() {
        if (columns_.size() > layout_.size) fail_at_surplus();
        Site site;
        site.x = read_column(layout_.columns[0]);
        site.y = read_column(layout_.columns[1]);
        if (layout_.columns[2] < columns_.size()) {
            site.r = read_column(layout_.columns[2]);
            if (site.r < 0.0 && !result_.first_negative) {
                result_.first_negative = position_of(columns_[layout_.columns[2]].data());
            }
        }
        result_.sites.push_back(site);
    }

    [[noreturn]] void fail_at_surplus() const {
        if (columns_[layout_.size].empty()) fail_at_empty_column(layout_.size);
        if (layout_.named) {
            fail_at_column(
                layout_.size,
                fmt::format("{} columns, but the header names {}; write as many, or choose with "
                            "--columns, as in --columns 1,2",
                            columns_.size(), layout_.size));
        }
        const bool has_comma = line_.substr(0, line_.find('#')).find(',') != std::string_view::npos;
        fail_at_column(layout_.size,
                       fmt::format("more than three columns; a site is x y [r]{}, or name the "
                                   "columns x, y and r (or radius, weight) in a first line, or "
                                   "choose with --columns, as in --columns 1,2",
                                   has_comma ? ", a fraction has a point" : ""));
    }

    double read_column(std::size_t column) {
        if (column >= columns_.size()) {
            const std::string_view last = columns_.back();
            fail(last.data() + last.size(),
                 columns_.size() == 1 ? "one column; a site has at least two: x y [r]"
                                      : "the line ends before the columns x and y; write both");
        }
        const std::string_view text = unquoted(columns_[column]);
        const Number number = parse_number(text);
        if (number.fault == NumberFault::none) {
            if (is_beyond_single(number.value) && !result_.first_beyond_single)
                result_.first_beyond_single = position_of(text.data());
            return number.value;
        }
        if (text.empty()) fail_at_empty_column(column);
        fail(text.data(), explain(number.fault, text));
    }

    InputFile& file_;
    const Columns& chosen_;
    std::string_view line_;
    std::vector<std::string_view> columns_;  ///< of line_, without blanks around them
    Layout layout_;
    SitesFile result_;
};

}  // namespace

SitesFile read_text_sites(InputFile& file, const Columns& columns) {
    return TextSites(file, columns).read();
}

}  // namespace signum
