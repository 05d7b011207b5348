#pragma once
/// The sections of a scene file and their keys: what is not in this table is refused, and
/// docs/scenes.md has a row for each.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace signum {

struct SectionKeys {
    std::string section;  ///< "balls.region"; empty for the file itself
    std::vector<std::string_view> keys;
};

[[nodiscard]] std::span<const SectionKeys> all_sections();
/// Precondition: there is such a section.
[[nodiscard]] std::span<const std::string_view> keys_of(std::string_view section);

}  // namespace signum
