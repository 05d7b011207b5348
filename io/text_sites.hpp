#pragma once
/// Sites as text, one a line: x y [r].

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// Reads all sites of an open file. Throws InputError.
[[nodiscard]] SitesFile read_text_sites(InputFile& file, const Columns& columns);

}  // namespace signum
