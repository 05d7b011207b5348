#pragma once
/// The files of -o: checked, opened before the work, complete or not there.

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "../io/output_file.hpp"

namespace signum::cli {

/// Adds the option -o, which may be given several times. `formats` says what each ending writes.
void add_output(CLI::App& command, std::vector<std::string>& paths, const std::string& formats);

/// The ending of a path with its point, in small letters; empty where there is none.
std::string ending_of(const std::string& path);

/// Throws CallError where an ending is none of `endings`, a file is named twice, or is the input.
void check_outputs(const std::vector<std::string>& paths, const std::string& input,
                   const std::vector<std::string_view>& endings);

class Outputs {
 public:
    /// Opens them all: a directory that cannot be written should not cost minutes.
    explicit Outputs(const std::vector<std::string>& paths);

    /// Writes and publishes each; to standard output where there is none, as what `fallback` ends
    /// with.
    void write(const std::function<void(std::ostream& out, const std::string& ending)>& write_one,
               const std::string& fallback) const;

 private:
    std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace signum::cli
