#pragma once
/// Sites as JSON: [[x, y, r], [x, y], ...].

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// Reads all sites of an open file. Throws InputError.
[[nodiscard]] SitesFile read_json_sites(InputFile& file, const Columns& columns);

}  // namespace signum
