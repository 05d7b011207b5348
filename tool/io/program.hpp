#pragma once
/// Other programs, which are started by their names, and a place for their files.

#include <string>
#include <string_view>
#include <vector>

namespace signum {

struct ProgramEnd {
    int status = 0;  ///< as waitpid() tells it; 0 is well
    std::string output;
};

/// Runs a program with these arguments until it ends; no shell reads them. What it writes to its
/// standard output comes back. Throws MachineError where it cannot be started.
[[nodiscard]] ProgramEnd run_program(const std::string& name, std::vector<std::string> arguments);

/// Whether the program can be started and `argument`, as --version, is well for it.
[[nodiscard]] bool has_program(const std::string& name, const std::string& argument);

/// A directory for files that other programs read and write, which goes with the object.
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
