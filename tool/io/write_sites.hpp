#pragma once
/// Sites as a file that read_sites() reads back to the same doubles.

#include <cstdint>
#include <ostream>
#include <span>

#include "../../core/site.hpp"

namespace signum {

enum class SitesFormat : std::uint8_t {
    text,  ///< x y r, in space x y z r, one site a line
    csv,   ///< a header x,y,r or x,y,z,r, then one site a line
    json,  ///< [[x, y, r], ...] or [[x, y, z, r], ...]
    /// An array of NumPy's, a row a site; and the same without a head.
    npy,
    f64,
    /// Triangle's, in space TetGen's: all sites with their radius or weight as the only attribute
    /// and without boundary markers.
    node
};

/// Nodes are numbered from `first`, 0 or 1.
void write_sites(std::ostream& out, std::span<const Site> sites, SitesFormat format, int first = 0);
void write_sites(std::ostream& out, std::span<const Site3> sites, SitesFormat format,
                 int first = 0);

}  // namespace signum
