#include "scratch_folder.hpp"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "errors.hpp"

namespace signum {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(std::string_view purpose) {
    const fs::path name = fmt::format("signum-{}-XXXXXX", purpose);
    path_ = (fs::temp_directory_path() / name).string();
    if (::mkdtemp(path_.data()) == nullptr)
        throw MachineError(fmt::format("cannot make a directory {}", path_));
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string ScratchFolder::file(std::string_view name) const {
    return fmt::format("{}/{}", path_, name);
}

}  // namespace signum
