/// A line is split into columns, the columns are read as numbers. A header may name the columns;
/// when it names others besides x, y and r, these may hold any text, and so the header's separator
/// alone separates.

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "number.hpp"
#include "text_sites.hpp"

namespace signum {
namespace {

constexpr std::size_t no_column = static_cast<std::size_t>(-1);
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
    explicit TextSites(InputFile& file) : file_(file) {}

    SitesFile read() {
        bool first = true;
        while (file_.next_line(line_)) {
            if (layout_.separator == any_separator) {
                split_at_any();
            } else {
                split_at(layout_.separator);
            }
            if (columns_.empty()) continue;
            if (std::exchange(first, false) && is_header()) {
                read_header();
            } else {
                read_site();
            }
        }
        if (result_.sites.empty()) {
            file_.fail({std::max<std::int64_t>(file_.line_number(), 1), 1},
                       first ? "no site in this file; write one site a line: x y [r]"
                             : "a header and no site; write one site a line: x y [r]");
        }
        return std::move(result_);
    }

 private:
    [[noreturn]] void fail(const char* place, std::string_view message) const {
        file_.fail({file_.line_number(), place - line_.data() + 1}, message);
    }
    [[noreturn]] void fail_at_column(std::size_t column, std::string_view message) const {
        fail(columns_[column].data(), message);
    }

    [[noreturn]] void fail_at_empty_column(std::size_t column) const {
        fail_at_column(column, "an empty column; write a number or remove the separator");
    }

    /// Columns end at blanks, at tabs, or at one comma or semicolon with or without blanks around
    /// it.
    void split_at_any() {
        columns_.clear();
        const char* place = line_.data();
        const char* const end = place + line_.size();
        const auto skip_blanks = [&] {
            while (place != end && is_blank(*place)) ++place;
        };
        const auto is_over = [&] { return place == end || *place == '#'; };
        char mark = '\0';
        skip_blanks();
        if (is_over()) return;
        for (;;) {
            const char* start = place;
            while (!is_over() && !is_blank(*place) && !is_mark(*place)) ++place;
            columns_.emplace_back(start, static_cast<std::size_t>(place - start));
            skip_blanks();
            if (is_over()) return;
            if (!is_mark(*place)) continue;
            if (mark != '\0' && mark != *place) {
                fail(place,
                     "commas and semicolons in one line; separate by one of them, and write "
                     "fractions with a point");
            }
            mark = *place++;
            skip_blanks();
            if (is_over()) {
                columns_.emplace_back(place, 0);
                return;
            }
        }
    }

    /// Columns end at `separator`; a column in double quotes may contain it.
    void split_at(char separator) {
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
            const char* last = place;
            while (last != start && is_blank(last[-1])) --last;
            columns_.emplace_back(start, static_cast<std::size_t>(last - start));
            if (is_over()) return;
            ++place;
            skip_blanks();
        }
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

    /// Finds x, y and r among the names; a header with none of these names is only skipped.
    void read_header() {
        std::array<std::size_t, 3> found = {no_column, no_column, no_column};
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            for (const char& c : columns_[column]) {
                if (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) {
                    fail(&c,
                         "a control character, so this is no text; write one site a line: x y [r]");
                }
            }
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
            if (name == "radius") result_.third = WeightIs::radius;
            if (name == "weight") result_.third = WeightIs::weight;
        }
        if (found == std::array{no_column, no_column, no_column}) return;
        if (found[0] == no_column || found[1] == no_column) {
            fail_at_column(0,
                           "the header does not name both x and y; name the columns x, y and r "
                           "(or radius, weight)");
        }
        if (found[2] == no_column && columns_.size() > 2) {
            fail_at_column(0,
                           "the header names x and y and other columns, but no r; name one column "
                           "r, radius or weight, or leave only x and y");
        }
        layout_ = {found, columns_.size(), any_separator, true};
        if (columns_.size() > 3) layout_.separator = separator_of_header();
    }

    /// The comma or semicolon of the line, else a tab, else none in particular.
    [[nodiscard]] char separator_of_header() const {
        for (const char separator : {',', ';', '\t'}) {
            if (line_.substr(0, line_.find('#')).find(separator) != std::string_view::npos) {
                return separator;
            }
        }
        return any_separator;
    }

    static std::string plain_name(std::string_view text) {
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
            text = text.substr(1, text.size() - 2);
        }
        std::string name(text);
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return name;
    }

    void read_site() {
        if (columns_.size() > layout_.size) {
            if (columns_[layout_.size].empty()) fail_at_empty_column(layout_.size);
            fail_at_column(
                layout_.size,
                layout_.named
                    ? fmt::format("{} columns, but the header names {}; write as many",
                                  columns_.size(), layout_.size)
                    : std::string("more than three columns; a site is x y [r], or name the columns "
                                  "x, y and r (or radius, weight) in a first line"));
        }
        Site site;
        site.x = read_column(layout_.columns[0]);
        site.y = read_column(layout_.columns[1]);
        if (layout_.columns[2] < columns_.size()) site.r = read_column(layout_.columns[2]);
        result_.sites.push_back(site);
    }

    double read_column(std::size_t column) const {
        if (column >= columns_.size()) {
            const std::string_view last = columns_.back();
            fail(last.data() + last.size(),
                 columns_.size() == 1 ? "one column; a site has at least two: x y [r]"
                                      : "the line ends before the columns x and y; write both");
        }
        const std::string_view text = columns_[column];
        const Number number = parse_number(text);
        if (number.fault == NumberFault::none) return number.value;
        if (text.empty()) fail_at_empty_column(column);
        fail(text.data(), explain(number.fault, text));
    }

    InputFile& file_;
    std::string_view line_;
    std::vector<std::string_view> columns_;  ///< of line_, without blanks around them
    Layout layout_;
    SitesFile result_;
};

}  // namespace

SitesFile read_text_sites(InputFile& file) {
    return TextSites(file).read();
}

}  // namespace signum
