#pragma once
/// gnuplot, which draws the figures of a study.

#include <string>

namespace signum::cli {

/// Whether it can be started.
bool has_gnuplot();

/// What it writes to its standard output when it runs a script. Throws MachineError where it cannot
/// be started, or fails.
std::string run_gnuplot(const std::string& script_path);
/// The same of a script that lies in no file.
std::string drawn_by_gnuplot(const std::string& script);

}  // namespace signum::cli
