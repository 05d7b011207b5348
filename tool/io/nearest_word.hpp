#pragma once
/// What a mistyped word was meant to be.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace signum {

/// The one of `words` that is fewest slips away from `word`: letters left out, put in, exchanged
/// for others or with their neighbours, capital or not. Nothing where the nearest needs more
/// than one slip for every three letters of `word`, rounded; of several that one whose beginning is
/// the same for longest. O(letters * letters of all words).
[[nodiscard]] std::optional<std::string> nearest_word(std::string_view word,
                                                      std::span<const std::string> words);

/// The text with ASCII letters in small ones.
[[nodiscard]] std::string in_small_letters(std::string_view text);

}  // namespace signum
