#include "program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "errors.hpp"

extern char** environ;

namespace signum {

namespace fs = std::filesystem;

ProgramEnd run_program(const std::string& name, std::vector<std::string> arguments) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
        throw MachineError(fmt::format("cannot start {}: {}", name, std::strerror(errno)));
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::string first = name;
    std::vector<char*> words = {first.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    pid_t child = 0;
    const int error =
        ::posix_spawnp(&child, name.c_str(), &actions, nullptr, words.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    ProgramEnd end;
    char bytes[4096];
    for (;;) {
        const ssize_t count = error == 0 ? ::read(ends[0], bytes, sizeof bytes) : 0;
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        end.output.append(bytes, static_cast<std::size_t>(count));
    }
    ::close(ends[0]);
    if (error != 0)
        throw MachineError(fmt::format("cannot start {}: {}", name, std::strerror(error)));
    while (::waitpid(child, &end.status, 0) < 0 && errno == EINTR) {
    }
    return end;
}

bool has_program(const std::string& name, const std::string& argument) {
    try {
        return run_program(name, {argument}).status == 0;
    } catch (const MachineError&) {
        return false;
    }
}

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
