#pragma once
/// The lines of a text file, split into columns before anybody says what these mean.
///
/// Laws:
///  1. Empty lines, and those that begin with #, do not count. Where blanks separate, neither does
///     what stands between # and the end of its line; elsewhere # is a letter like others.
///  2. Each line has columns that end at blanks and tabs, or at one comma or semicolon with or
///     without blanks around it, but not at both. Several tabs are as one only where the first line
///     has several: elsewhere a column between them is empty.
///  3. Where columns may hold any text, one separator alone separates, that of the first line, and
///     not within double quotes.
///  4. Whatever is wrong is an InputError at its place.

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "input_file.hpp"

namespace signum {

inline constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();

/// The columns of one line after the other, numbered from 0.
class TextColumns {
 public:
    /// `advice` is what to do about a file that holds no such lines: "write one site a line: ...".
    /// `decimal` is the point of numbers, or the comma, which then separates nothing; 0 is a point
    /// that nobody may choose.
    TextColumns(InputFile& file, std::string advice, char decimal = '\0')
        : file_(file), advice_(std::move(advice)), decimal_(decimal) {}

    /// Another advice, once the first line has told what the others hold.
    void advise(std::string advice) { advice_ = std::move(advice); }

    /// Goes to the next line that has columns; false at the end of the file. The first line is
    /// split at its own separator, since it may be a header; the others at any.
    [[nodiscard]] bool next_line();
    /// The file, whose lines may be read by other means from the next one on.
    [[nodiscard]] InputFile& file() const noexcept { return file_; }
    /// The only separator of the lines behind the first one, or 0.
    [[nodiscard]] char separator() const noexcept { return separator_; }

    /// To be said at the first line: the separator of it alone separates the others, too.
    void keep_separator() noexcept { separator_ = first_separator_; }
    /// Splits this line again, as the others are.
    void split_again() { split_at(separator_); }

    /// Whether this line holds no number, and nothing that was meant as one. Fails where it would
    /// be a header but for a control character.
    [[nodiscard]] bool is_header() const;

    [[nodiscard]] std::size_t size() const noexcept { return columns_.size(); }
    /// A column without blanks around it.
    [[nodiscard]] std::string_view operator[](std::size_t column) const { return columns_[column]; }
    /// A column without double quotes around it.
    [[nodiscard]] std::string_view text(std::size_t column) const;
    /// A column of a header as names are compared: without double quotes, in small letters.
    [[nodiscard]] std::string name(std::size_t column) const;
    /// The nearest double. Fails where the column is empty or holds no finite number.
    [[nodiscard]] double number(std::size_t column) const;
    /// Whether the column is empty, or says that nothing is known: NA, NaN, null, none, in any
    /// case.
    [[nodiscard]] bool is_missing(std::size_t column) const;
    /// The columns of a header, for a message: 'id', 'lat', 'lon'.
    [[nodiscard]] std::string names() const;

    /// The first column from `start` on that a header calls `name`, which is in small letters, or
    /// no_column.
    [[nodiscard]] std::size_t column_called(std::string_view name, std::size_t start = 0) const;
    /// The column that somebody chose by its name in the header, in any case, or by its number from
    /// 1. Fails where it is not there, or not the only one.
    [[nodiscard]] std::size_t chosen_column(std::string_view chosen, bool has_header) const;

    /// Whether a comma stands in this line, which may have been meant as a point.
    [[nodiscard]] bool has_comma() const;

    /// FILE:LINE of this line, with which a note begins.
    [[nodiscard]] std::string place_of_line() const;
    /// The position of a byte of this line, or of its end.
    [[nodiscard]] Position position_of(const char* place) const;

    [[noreturn]] void fail_at(std::size_t column, std::string_view message) const;
    [[noreturn]] void fail_at_empty(std::size_t column) const;
    [[noreturn]] void fail_at_line(std::string_view message) const;
    /// Fails behind the last column of this line.
    [[noreturn]] void fail_at_end_of_line(std::string_view message) const;
    /// Fails at the last line of the file, and adds the advice.
    [[noreturn]] void fail_at_end_of_file(std::string_view message) const;

 private:
    static constexpr char any_separator = '\0';

    [[nodiscard]] bool is_mark(char c) const noexcept {
        return c == ';' || (c == ',' && decimal_ != ',');
    }
    [[nodiscard]] bool is_blank_line() const;
    [[nodiscard]] bool has_empty_column_of_tabs() const;
    void split_at(char separator);
    void split_at_any();
    void split_at_one(char separator);
    [[nodiscard]] char separator_of_line() const;
    void refuse_control_characters() const;
    [[nodiscard]] std::string no_such_column(std::string_view chosen) const;
    [[noreturn]] void fail(const char* place, std::string_view message) const;

    InputFile& file_;
    std::string advice_;
    char decimal_;
    std::string_view line_;
    std::vector<std::string_view> columns_;  ///< of line_, without blanks around them
    bool is_indented_ = false;               ///< the first line begins with a tab
    bool at_first_ = true;                   ///< no line has had columns so far
    char first_separator_ = any_separator;   ///< of the first line
    char separator_ = any_separator;         ///< the only one of the others, or any_separator
};

/// What a header may call a column, in small letters.
struct ColumnNames {
    std::array<std::string_view, 3> names;  ///< some may be empty
    std::string_view second = {};           ///< what to say of a second such column
};

/// The columns of a header.
struct NamedColumns {
    std::vector<std::size_t> places;  ///< by their names; no_column where there is none
    std::vector<std::string> others;  ///< columns of other names, in quotes
};

/// Fails where two columns have names of the same.
[[nodiscard]] NamedColumns named_columns(const TextColumns& header,
                                         std::span<const ColumnNames> quantities);

}  // namespace signum
