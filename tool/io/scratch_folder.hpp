#pragma once
/// A directory for files that other programs read and write, which goes with the object.

#include <string>
#include <string_view>

namespace signum {

class ScratchFolder {
 public:
    /// Among the system's temporary ones; `purpose` is a part of its name. Throws MachineError.
    explicit ScratchFolder(std::string_view purpose);
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder();

    /// The path of a file in it.
    [[nodiscard]] std::string file(std::string_view name) const;

 private:
    std::string path_;
};

}  // namespace signum
