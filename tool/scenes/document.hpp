#pragma once
/// The text of a scene as tables that know where they stand, with what the command line sets put
/// into their place.

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "scene.hpp"
#include "units.hpp"

namespace signum {

class Document {
 public:
    /// Reads and parses the file, then each override in turn. Throws InputError, OverrideError,
    /// MachineError.
    Document(const std::string& path, std::span<const Override> overrides);

    [[nodiscard]] const toml::table& root() const noexcept { return root_; }
    [[nodiscard]] const std::string& path() const noexcept { return path_; }

    /// Throws InputError for a place in the file, OverrideError for one of an override.
    [[noreturn]] void fail(const toml::source_region& where, std::string_view message) const;
    /// The same place, for what shows later to be wrong.
    [[nodiscard]] ScenePlace place_of(const toml::source_region& where) const;

    /// In which plain numbers are meant; to be set before any is read.
    Units units;

 private:
    void merge(toml::table& into, toml::table& from, const std::string& option) const;
    [[nodiscard]] Position position_of(const toml::source_position& position) const;

    /// A place in the text.
    struct Walk {
        std::int64_t line = 1;
        std::int64_t column = 1;  ///< in code points
        std::size_t begin = 0;    ///< of the line
        std::size_t byte = 0;
    };

    std::string path_;
    std::string text_;
    toml::table root_;
    mutable Walk walk_;  ///< where the last place was found
};

}  // namespace signum
