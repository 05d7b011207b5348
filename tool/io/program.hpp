#pragma once
/// Other programs, which are started by their names.

#include <string>
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

}  // namespace signum
