#pragma once
/// Sites as JSON: [[x, y, r], [x, y], ...], in space [[x, y, z, r], [x, y, z], ...].

#include <optional>

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// Reads all sites of an open file, of 2 or 3 dimensions or of those that the first site tells: it
/// lies in space where it has four numbers. Throws InputError.
[[nodiscard]] SitesFile read_json_sites(InputFile& file, const Columns& columns,
                                        std::optional<int> dimension);

}  // namespace signum
