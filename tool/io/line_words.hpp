#pragma once
/// The lines of a text file as words between blanks, each with its place.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input_file.hpp"

namespace signum {

class LineWords {
 public:
    /// `advice` says what a line should be, as the end of an error message. What stands from
    /// `comment` on is no part of a line.
    LineWords(InputFile& file, std::string advice, char comment = '\0')
        : file_(file), advice_(std::move(advice)), comment_(comment) {}

    /// Goes to the next line, which may have no word; false at the end of the file.
    [[nodiscard]] bool next();
    /// The next line that has a word.
    [[nodiscard]] bool next_with_words();

    [[nodiscard]] std::string_view line() const noexcept { return line_; }
    [[nodiscard]] std::size_t size() const noexcept { return words_.size(); }
    [[nodiscard]] std::string_view operator[](std::size_t word) const { return words_[word]; }
    /// The nearest double. Fails where the word is no finite number.
    [[nodiscard]] double number(std::size_t word) const;
    /// The number in the columns from `first` to `last`, from 1, without the blanks around it.
    /// Fails where the line ends with the number before `last`.
    [[nodiscard]] double number_in_columns(std::size_t first, std::size_t last) const;
    /// The columns from `first` to `last`, from 1, as far as the line has them, without the blanks
    /// around them.
    [[nodiscard]] std::string_view columns(std::size_t first, std::size_t last) const;

    /// The place of the first byte of a word, or of the line's end where it has not as many.
    [[nodiscard]] Position position_of(std::size_t word) const;
    [[noreturn]] void fail_at(std::size_t word, std::string_view message) const;
    [[noreturn]] void fail_at_column(std::size_t column, std::string_view message) const;
    /// Fails at the last line of the file, and adds the advice.
    [[noreturn]] void fail_at_end(std::string_view message) const;
    /// FILE, with which a note begins.
    [[nodiscard]] const std::string& path() const noexcept { return file_.path(); }

 private:
    InputFile& file_;
    std::string advice_;
    char comment_;  ///< which no line has where nothing is a comment
    std::string_view line_;
    std::vector<std::string_view> words_;
};

}  // namespace signum
