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

/// The value of Properties, which say what the columns of the frame are.
struct XyzProperties {
    std::string_view value;  ///< without quotes around it
    std::size_t column = 0;  ///< of the key, from 1
};

/// Nothing where the comment has no Properties: the frame is plain. O(bytes).
[[nodiscard]] std::optional<XyzProperties> properties_of(std::string_view comment);

}  // namespace signum
