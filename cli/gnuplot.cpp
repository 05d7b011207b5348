#include "gnuplot.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
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
    namespace fs = std::filesystem;
    std::string folder = (fs::temp_directory_path() / "signum-curves-XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr)
        throw MachineError(fmt::format("cannot make a directory {}", folder));
    struct Remover {
        const std::string& folder;
        ~Remover() {
            std::error_code ignored;
            fs::remove_all(folder, ignored);
        }
    } const remover{folder};
    const std::string path = folder + "/curves.gnuplot";
    std::ofstream(path, std::ios::binary) << script;
    return run_gnuplot(path);
}

}  // namespace signum::cli
