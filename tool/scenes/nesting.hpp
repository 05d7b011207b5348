#pragma once
/// How deep a text of TOML goes, before it is parsed: the parser takes dotted keys of any depth,
/// and tables within tables are destroyed one within the other, which takes the stack.

#include <cstddef>
#include <optional>
#include <string_view>

namespace signum {

/// More than anyone writes: tables, arrays and parts of dotted keys, one within the other.
inline constexpr std::size_t deepest_nesting = 100;

/// The byte at which a text is nested deeper than that; nothing where it is not, or where it is no
/// TOML before. O(bytes).
[[nodiscard]] std::optional<std::size_t> too_deep_at(std::string_view toml);

}  // namespace signum
