#pragma once
/// Enumerators by the names that files and the command line have for them: what name_of() says.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace signum {

/// In their order.
template <class Values>
[[nodiscard]] std::vector<std::string> names_of(const Values& values) {
    std::vector<std::string> names;
    for (const auto value : values) names.emplace_back(name_of(value));
    return names;
}

/// The one of that name, if there is one.
template <class Values>
[[nodiscard]] auto named(const Values& values, std::string_view name)
    -> std::optional<typename Values::value_type> {
    for (const auto value : values)
        if (name_of(value) == name) return value;
    return std::nullopt;
}

}  // namespace signum
