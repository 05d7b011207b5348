#pragma once
/// What the tests that read the project's own sources share.

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace signum {

namespace fs = std::filesystem;

inline const fs::path root = SIGNUM_SOURCES;

/// All that stands in a file.
inline std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace signum
