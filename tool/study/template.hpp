#pragma once
/// Words that stand in the pages' files, filled in.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signum::study {

/// What stands in a text by name, as HTML.
using Values = std::map<std::string, std::string>;

/// The text with every {name} replaced by its value. A part in [brackets] is left out where a value
/// in it is empty or not there; none where one outside of them is not there.
[[nodiscard]] std::optional<std::string> filled(std::string_view text, const Values& values);

/// The text of that name in pages/html.toml with its values. Precondition: they are all there.
[[nodiscard]] std::string html_of(std::string_view name, const Values& values);

/// The text with what has a meaning of its own in HTML, in attributes too, written so that it has
/// none.
[[nodiscard]] std::string html_text(std::string_view text);

/// A line of a table, with the tag of its first cell and that of the others.
[[nodiscard]] std::string table_line(const std::vector<std::string>& cells,
                                     std::string_view first = "td", std::string_view others = "td");

}  // namespace signum::study
