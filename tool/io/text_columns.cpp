#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "nearest_word.hpp"
#include "number.hpp"
#include "text_columns.hpp"

namespace signum {
namespace {

constexpr std::string_view no_comment_here =
    "where commas, semicolons or tabs separate, a comment begins at the start of its line";
constexpr std::string_view unclosed = "a quotation mark that nothing on this line closes; close it";

bool is_blank(char c) noexcept {
    return c == ' ' || c == '\t';
}

/// Whether words between blanks are numbers, at least one.
bool are_numbers(std::string_view text) {
    bool is_one = false;
    for (std::size_t begin = 0; begin < text.size();) {
        begin = text.find_first_not_of(" \t", begin);
        if (begin == std::string_view::npos) break;
        const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
        if (parse_number(text.substr(begin, end - begin)).fault != NumberFault::none) return false;
        is_one = true;
        begin = end;
    }
    return is_one;
}

}  // namespace

bool TextColumns::next_line() {
    while (file_.next_line(line_, advice_)) {
        if (is_blank_line()) continue;
        if (at_first_) {
            first_separator_ = separator_of_line();
            is_indented_ = line_.front() == '\t';
        }
        split_at(at_first_ ? first_separator_ : separator_);
        at_first_ = false;
        return true;
    }
    return false;
}

bool TextColumns::is_blank_line() const {
    return std::ranges::all_of(line_.substr(0, line_.find('#')), is_blank);
}

/// Whether a column between tabs is empty. Where the first line has them one at a time, two in
/// another line align nothing: between them something is missing, and what follows is not it.
bool TextColumns::has_empty_column_of_tabs() const {
    if (first_separator_ != '\t') return false;
    const std::string_view text = line_.substr(0, line_.find_last_not_of(" \t") + 1);
    return text.find("\t\t") != std::string_view::npos || (text.starts_with('\t') && !is_indented_);
}

void TextColumns::split_at(char separator) {
    if (separator == any_separator && has_empty_column_of_tabs()) {
        split_at_one('\t');
    } else if (separator == any_separator) {
        split_at_any();
    } else {
        split_at_one(separator);
    }
}

/// Columns end at blanks and tabs, or at one comma or semicolon with or without blanks around
/// it, but not at both in one line: 1,5 2 is more likely two numbers than three.
void TextColumns::split_at_any() {
    columns_.clear();
    const char* place = line_.data();
    const char* const end = place + line_.size();
    const auto skip_blanks = [&] {
        while (place != end && is_blank(*place)) ++place;
    };
    char mark = '\0';
    const auto is_over = [&] { return place == end || (*place == '#' && mark == '\0'); };
    bool at_blanks = false;
    const auto refuse_both = [&](std::string_view one, std::string_view other) {
        if (*place == '#') fail(place, no_comment_here);
        fail(place, fmt::format("{} and {} in one line; separate by one of them, and write "
                                "fractions with a point",
                                one, other));
    };
    const auto name_of_mark = [&] { return mark == ',' ? "commas" : "semicolons"; };
    skip_blanks();
    if (is_over()) return;
    for (;;) {
        const char* start = place;
        bool quoted = false;
        while (quoted ? place != end : !is_over() && !is_blank(*place) && !is_mark(*place)) {
            if (*place == '"') quoted = !quoted;
            ++place;
        }
        if (quoted) fail(start, unclosed);
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
void TextColumns::split_at_one(char separator) {
    columns_.clear();
    const char* place = line_.data();
    const char* const end = place + line_.size();
    const auto skip_blanks = [&] {
        while (place != end && is_blank(*place) && *place != separator) ++place;
    };
    skip_blanks();
    if (place == end) return;
    for (;;) {
        const char* start = place;
        bool quoted = false;
        while (place != end && (quoted || *place != separator)) {
            if (*place == '"') quoted = !quoted;
            ++place;
        }
        if (quoted) fail(start, unclosed);
        const char* last = place;
        while (last != start && is_blank(last[-1])) --last;
        columns_.emplace_back(start, static_cast<std::size_t>(last - start));
        if (place == end) return;
        ++place;
        skip_blanks();
    }
}

/// The first comma or semicolon of the line, else the tab, else none in particular; what stands
/// between quotes does not count, nor what follows # behind numbers alone. Columns that are aligned
/// by several tabs have none.
char TextColumns::separator_of_line() const {
    bool quoted = false;
    bool has_tab = false;
    for (const char& c : line_) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '#' && are_numbers(line_.substr(0, static_cast<std::size_t>(&c - line_.data()))))
            break;
        if (is_mark(c)) return c;
        has_tab = has_tab || c == '\t';
    }
    const bool is_aligned = line_.find("\t\t") != std::string_view::npos;
    return has_tab && !is_aligned ? '\t' : any_separator;
}

bool TextColumns::is_header() const {
    const auto is_meant_as_number = [](std::string_view text) {
        if (parse_number(text).fault != NumberFault::word) return true;
        const std::size_t start = text.find_first_not_of("+-.\"");
        return start != std::string_view::npos &&
               std::isdigit(static_cast<unsigned char>(text[start])) != 0;
    };
    if (std::ranges::any_of(columns_, is_meant_as_number)) return false;
    refuse_control_characters();
    return true;
}

void TextColumns::refuse_control_characters() const {
    for (const char& c : line_) {
        if (static_cast<unsigned char>(c) < ' ' && !is_blank(c)) {
            fail(&c, fmt::format("a control character, so this is no text; {}", advice_));
        }
    }
}

std::string_view TextColumns::text(std::size_t column) const {
    const std::string_view whole = columns_[column];
    if (whole.size() < 2 || whole.front() != '"' || whole.back() != '"') return whole;
    return whole.substr(1, whole.size() - 2);
}

std::string TextColumns::name(std::size_t column) const {
    return in_small_letters(text(column));
}

double TextColumns::number(std::size_t column) const {
    const std::string_view digits = text(column);
    if (digits.empty()) fail_at_empty(column);
    Number number;
    if (decimal_ == ',') {
        std::string pointed(digits);
        std::ranges::replace(pointed, ',', '.');
        const bool has_point = digits.find('.') != std::string_view::npos;
        number = has_point ? Number{0.0, NumberFault::word} : parse_number(pointed);
    } else {
        number = parse_number(digits);
    }
    if (number.fault == NumberFault::none) return number.value;
    if (digits.find('#') != std::string_view::npos && number.fault == NumberFault::word)
        fail(digits.data() + digits.find('#'), no_comment_here);
    fail(digits.data(), explain(number.fault, digits, decimal_));
}

bool TextColumns::is_missing(std::size_t column) const {
    constexpr std::array<std::string_view, 8> words = {"",     "na",   "n/a",  "nan",
                                                       "null", "none", "<na>", "nodata"};
    return std::ranges::count(words, name(column)) > 0;
}

std::string TextColumns::names() const {
    constexpr std::size_t most_shown = 12;
    std::string shown;
    for (std::size_t i = 0; i < std::min(columns_.size(), most_shown); ++i)
        shown += (i > 0 ? ", " : "") + in_quotes(text(i));
    return shown + (columns_.size() > most_shown ? ", ..." : "");
}

std::size_t TextColumns::column_called(std::string_view name, std::size_t start) const {
    for (std::size_t column = start; column < columns_.size(); ++column)
        if (this->name(column) == name) return column;
    return no_column;
}

std::size_t TextColumns::chosen_column(std::string_view chosen, bool has_header) const {
    if (const auto number = parse_whole_number(chosen)) {
        if (*number >= 1 && *number <= columns_.size()) return *number - 1;
        fail_at_line(
            fmt::format("there is no column {}; columns count from 1, and this line "
                        "has {}",
                        *number, columns_.size()));
    }
    if (!has_header) {
        fail_at_line(
            fmt::format("column {} is chosen by name, and the first line is no header; choose "
                        "by number, from 1 to {}",
                        in_quotes(chosen), columns_.size()));
    }
    const std::string name = in_small_letters(chosen);
    const std::size_t found = column_called(name);
    if (found == no_column) fail_at_line(no_such_column(chosen));
    if (column_called(name, found + 1) != no_column) {
        fail_at(found,
                fmt::format("several columns are called {}; choose by number", in_quotes(chosen)));
    }
    return found;
}

std::string TextColumns::no_such_column(std::string_view chosen) const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < columns_.size(); ++i) all.emplace_back(text(i));
    const std::optional<std::string> meant = nearest_word(chosen, all);
    return fmt::format("no column is called {}{} there are {}", in_quotes(chosen),
                       meant ? "; did you mean " + in_quotes(*meant) + "?" : ";", names());
}

bool TextColumns::has_comma() const {
    const char* const first = columns_.front().data();
    const char* const last = columns_.back().data();
    return std::find(first, last, ',') != last;
}

std::string TextColumns::place_of_line() const {
    return fmt::format("{}:{}", file_.path(), file_.line_number());
}

Position TextColumns::position_of(const char* place) const {
    return {file_.line_number(), place - line_.data() + 1};
}

void TextColumns::fail(const char* place, std::string_view message) const {
    file_.fail(position_of(place), message);
}

void TextColumns::fail_at(std::size_t column, std::string_view message) const {
    fail(columns_[column].data(), message);
}

void TextColumns::fail_at_empty(std::size_t column) const {
    fail_at(column, "an empty column; write a number or remove the separator");
}

void TextColumns::fail_at_line(std::string_view message) const {
    fail(line_.data(), message);
}

void TextColumns::fail_at_end_of_line(std::string_view message) const {
    fail(columns_.back().data() + columns_.back().size(), message);
}

void TextColumns::fail_at_end_of_file(std::string_view message) const {
    file_.fail({std::max<std::int64_t>(file_.line_number(), 1), 1},
               fmt::format("{}; {}", message, advice_));
}

NamedColumns named_columns(const TextColumns& header, std::span<const ColumnNames> quantities) {
    NamedColumns result = {std::vector(quantities.size(), no_column), {}};
    for (std::size_t column = 0; column < header.size(); ++column) {
        const std::string name = header.name(column);
        const auto quantity = std::ranges::find_if(quantities, [&](const ColumnNames& each) {
            return !name.empty() && std::ranges::count(each.names, name) > 0;
        });
        if (quantity == quantities.end()) {
            result.others.push_back(in_quotes(header.text(column)));
            continue;
        }
        std::size_t& place = result.places[static_cast<std::size_t>(quantity - quantities.begin())];
        if (place != no_column)
            header.fail_at(column, quantity->second.empty()
                                       ? fmt::format("a second column {}; name one", name)
                                       : std::string(quantity->second));
        place = column;
    }
    return result;
}

}  // namespace signum
