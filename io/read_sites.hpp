#pragma once
/// Sites from a file, text or JSON; the format is described in README.md under "Input".
///
/// Laws:
///  1. Every number is read to the nearest double.
///  2. Whatever is not exactly a list of sites is an InputError that names file, line and column; a
///     file is read whole or not at all.
///  3. Memory beyond the sites themselves is bounded, whatever the file holds.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../core/site.hpp"
#include "../core/strided_sites.hpp"
#include "../triangulation/tessellation.hpp"
#include "errors.hpp"

namespace signum {

/// The columns that are x, y and, where there are three, r. Each is the name that a header gives
/// it, in any case, or its number from 1. Empty: what the header says, else the first three.
using Columns = std::vector<std::string>;

/// At least one site, all numbers finite; r is a radius or a weight, as the user of the file says.
struct SitesFile {
    std::vector<Site> sites;
    /// What a header calls the third column, where there is a header that says radius or weight.
    std::optional<WeightIs> third;
    /// Where the first third number below 0 stands.
    std::optional<Position> first_negative;
    /// Where the first number stands that no float reaches.
    std::optional<Position> first_beyond_single;
    /// What was left out, in a sentence, where a header has a column that may have been meant, a
    /// third one of another name or z, and nobody had said so; else empty.
    std::string note;
};

/// Reads the file `path`, or standard input for "-". Throws InputError, and MachineError where it
/// is the machine that fails. O(bytes).
[[nodiscard]] SitesFile read_sites(const std::string& path, const Columns& columns = {});

/// A view of sites whose third number is a radius or a weight, as triangulate() and validate() want
/// it.
[[nodiscard]] StridedSites strided_view(std::span<const Site> sites, WeightIs third) noexcept;

}  // namespace signum
