#include "line_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "number.hpp"

namespace signum {

bool LineWords::next() {
    constexpr std::string_view blanks = " \t";
    if (!file_.next_line(line_, advice_)) return false;
    line_ = line_.substr(0, line_.find(comment_));
    words_.clear();
    for (std::size_t end = 0; end < line_.size();) {
        const std::size_t begin = line_.find_first_not_of(blanks, end);
        if (begin == std::string_view::npos) break;
        end = std::min(line_.find_first_of(blanks, begin), line_.size());
        words_.push_back(line_.substr(begin, end - begin));
    }
    return true;
}

bool LineWords::next_with_words() {
    while (next())
        if (!words_.empty()) return true;
    return false;
}

double LineWords::number(std::size_t word) const {
    const Number number = parse_number(words_[word]);
    if (number.fault != NumberFault::none) fail_at(word, explain(number.fault, words_[word]));
    return number.value;
}

std::string_view LineWords::columns(std::size_t first, std::size_t last) const {
    if (line_.size() < first) return {};
    std::string_view text = line_.substr(first - 1, last - first + 1);
    const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(begin);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

double LineWords::number_in_columns(std::size_t first, std::size_t last) const {
    const std::string_view text = columns(first, last);
    if (text.empty()) {
        fail_at_column(std::min(first, line_.size() + 1),
                       fmt::format("no number in columns {} to {}; {}", first, last, advice_));
    }
    // A file that was cut off there may have lost digits; a blank would say that it has not.
    if (line_.size() < last && line_.back() != ' ') {
        fail_at_column(
            line_.size() + 1,
            fmt::format("the line ends within columns {} to {}, and the number there may "
                        "have lost digits; {}",
                        first, last, advice_));
    }
    const Number number = parse_number(text);
    if (number.fault != NumberFault::none) {
        fail_at_column(static_cast<std::size_t>(text.data() - line_.data()) + 1,
                       explain(number.fault, text));
    }
    return number.value;
}

Position LineWords::position_of(std::size_t word) const {
    const std::ptrdiff_t place = word < words_.size() ? words_[word].data() - line_.data()
                                                      : static_cast<std::ptrdiff_t>(line_.size());
    return {std::max<std::int64_t>(file_.line_number(), 1), place + 1};
}

void LineWords::fail_at(std::size_t word, std::string_view message) const {
    file_.fail(position_of(word), message);
}

void LineWords::fail_at_column(std::size_t column, std::string_view message) const {
    file_.fail({file_.line_number(), static_cast<std::int64_t>(column)}, message);
}

void LineWords::fail_at_end(std::string_view message) const {
    file_.fail({std::max<std::int64_t>(file_.line_number(), 1), 1},
               fmt::format("{}; {}", message, advice_));
}

}  // namespace signum
