#pragma once
/// Sites as a file that read_sites() reads back to the same doubles.

#include <cstdint>
#include <ostream>
#include <span>

#include "../core/site.hpp"

namespace signum {

enum class SitesFormat : std::uint8_t {
    text,  ///< x y r, one site a line
    csv,   ///< a header x,y,r, then one site a line
    json   ///< [[x, y, r], ...]
};

void write_sites(std::ostream& out, std::span<const Site> sites, SitesFormat format);

}  // namespace signum
