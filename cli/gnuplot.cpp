#include "gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "../io/errors.hpp"

extern char** environ;

namespace signum::cli {
namespace {

struct Ending {
    int status = 0;
    std::string output;
};

/// Runs gnuplot with one argument; its output and its exit status.
Ending spawn(const std::string& argument) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw MachineError(fmt::format("cannot start gnuplot: {}", std::strerror(errno)));
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::string name = "gnuplot";
    std::string word = argument;
    char* words[] = {name.data(), word.data(), nullptr};
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, words, environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    Ending ending;
    char bytes[4096];
    for (;;) {
        const ssize_t count = error == 0 ? ::read(ends[0], bytes, sizeof bytes) : 0;
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        ending.output.append(bytes, static_cast<std::size_t>(count));
    }
    ::close(ends[0]);
    if (error != 0)
        throw MachineError(fmt::format("cannot start gnuplot: {}", std::strerror(error)));
    while (::waitpid(child, &ending.status, 0) < 0 && errno == EINTR) {
    }
    return ending;
}

}  // namespace

bool has_gnuplot() {
    try {
        return spawn("--version").status == 0;
    } catch (const MachineError&) {
        return false;
    }
}

std::string run_gnuplot(const std::string& script_path) {
    Ending ending = spawn(script_path);
    if (ending.status != 0) throw MachineError(fmt::format("gnuplot failed on {}", script_path));
    return std::move(ending.output);
}

}  // namespace signum::cli
