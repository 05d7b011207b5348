#include <fmt/format.h>

#include "json_events.hpp"
#include "number.hpp"

namespace signum {
namespace {

bool is_structure(char c) noexcept {
    return std::string_view("[]{},:").find(c) != std::string_view::npos;
}

/// As much of a value as a message can show, and one byte more, so that it shows where it cuts.
constexpr std::size_t shown = 41;

bool is_space(char c) noexcept {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

}  // namespace

void JsonCursor::advance() {
    const char c = block_[next_];
    if (in_string_) {
        ++value_size_;
        if (value_text_.size() < shown) value_text_ += c;
        if (!escaped_ && c == '"') {
            in_string_ = false;
            value_size_ = 0;
        }
        escaped_ = !escaped_ && c == '\\';
    } else if (is_structure(c)) {
        structure_ = position_;
        value_size_ = 0;
    } else if (is_space(c)) {
        value_size_ = 0;
    } else {
        if (value_size_++ == 0) {
            value_ = position_;
            value_text_.clear();
        }
        if (value_text_.size() < shown) value_text_ += c;
        in_string_ = c == '"';
    }
    if (value_size_ > InputFile::longest_line) {
        file_.fail(value_, fmt::format("a value of more than {} bytes; write shorter ones",
                                       InputFile::longest_line));
    }
    if (c == '\n') {
        ++position_.line;
        position_.column = 1;
    } else {
        ++position_.column;
    }
    if (++next_ == block_.size()) {
        block_ = file_.next_block();
        next_ = 0;
    }
}

void JsonEvents::parse() {
    nlohmann::json::sax_parse(JsonIterator(cursor_), JsonIterator(), this);
}

void JsonEvents::fail(Position position, std::string_view what) const {
    cursor_.file().fail(position, fmt::format("{}; {}", what, expected_));
}

bool JsonEvents::parse_error(std::size_t /*position*/, const std::string& last_token,
                             const nlohmann::detail::exception& error) {
    constexpr int number_overflow = 406;
    const std::string_view reason = error.what();
    const bool is_no_token = reason.find("; last read: ") != std::string_view::npos;
    if (error.id == number_overflow) {
        cursor_.file().fail(cursor_.value(),
                            explain(NumberFault::out_of_range, cursor_.value_text()));
    }
    if (cursor_.is_in_string() && !cursor_.at_end()) {
        fail_at_value("a string that is not valid JSON");
    }
    if (cursor_.is_in_string() || reason.find("unexpected end of input") != reason.npos) {
        fail(cursor_.position(), "the file ends too early");
    }
    if (!is_no_token && !last_token.empty() && is_structure(last_token.back())) {
        fail_at_structure(fmt::format("'{}' cannot stand here", last_token.back()));
    }
    // The parser stops in the middle of a word.
    while (cursor_.is_in_value() && !cursor_.at_end()) cursor_.advance();
    fail_at_value(fmt::format("{} cannot stand here", in_quotes(cursor_.value_text())));
}

}  // namespace signum
