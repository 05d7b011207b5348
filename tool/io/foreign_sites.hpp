#pragma once
/// Formats that may be taken for lines of sites, known by their first lines.

#include <string>
#include <string_view>

namespace signum {

/// What the file is that begins so, and what to do, as a message; empty where it may be lines of
/// sites.
[[nodiscard]] std::string other_format(std::string_view beginning);

}  // namespace signum
