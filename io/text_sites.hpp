#pragma once
/// Sites as text, one a line: x y [r].

#include <signum/io/input_file.hpp>
#include <signum/io/read_sites.hpp>

namespace signum {

/// Reads all sites of an open file. Throws InputError.
[[nodiscard]] SitesFile read_text_sites(InputFile& file);

}  // namespace signum
