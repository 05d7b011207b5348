#include "gnuplot.hpp"

#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/program.hpp"

namespace signum::cli {

bool has_gnuplot() {
    return has_program("gnuplot", "--version");
}

std::string run_gnuplot(const std::string& script_path) {
    ProgramEnd end = run_program("gnuplot", {script_path});
    if (end.status != 0) throw MachineError(fmt::format("gnuplot failed on {}", script_path));
    return std::move(end.output);
}

std::string drawn_by_gnuplot(const std::string& script) {
    const ScratchFolder folder("curves");
    const std::string path = folder.file("curves.gnuplot");
    std::ofstream(path, std::ios::binary) << script;
    return run_gnuplot(path);
}

}  // namespace signum::cli
