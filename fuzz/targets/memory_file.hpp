#pragma once
/// Bytes as a file that is read by its name and lies in memory.

#include <string>
#include <string_view>

#include "target.hpp"

namespace signum::fuzz {

class MemoryFile {
 public:
    explicit MemoryFile(Bytes bytes);
    explicit MemoryFile(std::string_view text);
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
    int descriptor_;
    std::string path_;
};

}  // namespace signum::fuzz
