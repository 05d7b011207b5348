#pragma once
/// The second line of a frame in extended XYZ: words, and values of the form key=value.
///
/// Laws:
///  1. A key is a word of its own, in any case; blanks may stand around the =.
///  2. A value ends at a blank, or at the quote that it begins with. What stands in quotes is no
///     key.

#include <cstddef>
#include <optional>
#include <string_view>

namespace signum {

struct XyzValue {
    std::string_view value;  ///< without quotes around it
    std::size_t column = 0;  ///< of the key, from 1
};

/// The first value of a key, which is in small letters; nothing where the comment does not have it.
/// Without `properties`, which say what the columns are, the frame is plain. O(bytes).
[[nodiscard]] std::optional<XyzValue> value_in_comment(std::string_view comment,
                                                       std::string_view key);

}  // namespace signum
