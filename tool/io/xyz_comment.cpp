#include <algorithm>

#include "nearest_word.hpp"
#include "xyz_comment.hpp"

namespace signum {
namespace {

/// What stands in quotes from `begin` on, or else up to a blank or to the = behind a key. A quote
/// that nothing closes is a letter. `begin` goes behind it.
std::string_view next_word(std::string_view text, std::size_t& begin, std::string_view ends) {
    const char first = text[begin];
    const std::size_t closing =
        first == '"' || first == '\'' ? text.find(first, begin + 1) : std::string_view::npos;
    if (closing != std::string_view::npos) {
        const std::string_view word = text.substr(begin + 1, closing - begin - 1);
        begin = closing + 1;
        return word;
    }
    const std::string_view word =
        text.substr(begin, std::min(text.find_first_of(ends, begin), text.size()) - begin);
    begin += word.size();
    return word;
}

}  // namespace

std::optional<XyzValue> value_in_comment(std::string_view comment, std::string_view key) {
    constexpr std::string_view blanks = " \t";
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        at = std::min(comment.find_first_not_of(blanks, at), comment.size());
    };
    for (skip_blanks(); at < comment.size(); skip_blanks()) {
        const std::size_t begin = at;
        const std::string_view word = next_word(comment, at, " \t=");
        skip_blanks();
        if (at == comment.size() || comment[at] != '=') continue;
        ++at;
        skip_blanks();
        const std::string_view value =
            at < comment.size() ? next_word(comment, at, blanks) : std::string_view();
        if (comment[begin] != '"' && comment[begin] != '\'' && in_small_letters(word) == key)
            return XyzValue{value, begin + 1};
    }
    return std::nullopt;
}

}  // namespace signum
