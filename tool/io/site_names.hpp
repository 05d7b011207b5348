#pragma once
/// How sites are named in a table of some of them, who are others' in the whole.

#include <cstdint>
#include <span>

#include "../../core/index.hpp"

namespace signum {

/// Of all sites, by their places, where nothing is said.
struct SiteNames {
    std::span<const std::int64_t> numbers = {};  ///< by site, its number
    std::span<const char> written = {};          ///< by site, whether it has a row

    [[nodiscard]] std::int64_t number(Index site) const noexcept {
        return numbers.empty() || site < 0 ? site : numbers[static_cast<std::size_t>(site)];
    }
    [[nodiscard]] bool is_written(Index site) const noexcept {
        return written.empty() || written[static_cast<std::size_t>(site)] != 0;
    }
};

}  // namespace signum
