#pragma once
/// A call of the tool, from outside.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "io_scratch.hpp"

namespace signum::test {

using Words = std::vector<std::string>;

struct Outcome {
    int code = 0;  ///< exit code; minus the signal when one ended the tool
    std::string out;
    std::string err;
};

/// Where the tool's standard streams lead, and other circumstances of a call.
struct Circumstances {
    std::string in = "/dev/null";
    std::string out = {};  ///< a file of its own when empty
    rlim_t file_size = RLIM_INFINITY;
    int signal_after_ms = 0;  ///< SIGINT then, when not 0
    /// Asked each millisecond; once it is true the tool is killed.
    std::function<bool()> kill_when = {};
};

inline Outcome run(const Words& words, const Circumstances& circumstances = {}) {
    const Scratch scratch;
    const std::string out = circumstances.out.empty() ? scratch.path("out") : circumstances.out;
    const std::string err = scratch.path("err");
    const pid_t child = ::fork();
    if (child == 0) {
        const auto redirect = [](const std::string& path, int flags, int descriptor) {
            const int opened = ::open(path.c_str(), flags, 0600);
            if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(99);
            ::close(opened);
        };
        redirect(circumstances.in, O_RDONLY, 0);
        redirect(out, O_WRONLY | O_CREAT, 1);
        redirect(err, O_WRONLY | O_CREAT, 2);
        const rlimit limit = {circumstances.file_size, circumstances.file_size};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(99);
        std::vector<char*> arguments;
        std::string name = SIGNUM_TOOL;
        arguments.push_back(name.data());
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        ::execv(arguments[0], arguments.data());
        ::_exit(98);
    }
    if (circumstances.signal_after_ms > 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(circumstances.signal_after_ms));
        ::kill(child, SIGINT);
    }
    int status = 0;
    if (circumstances.kill_when) {
        while (::waitpid(child, &status, WNOHANG) == 0) {
            if (circumstances.kill_when()) ::kill(child, SIGKILL);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    } else {
        ::waitpid(child, &status, 0);
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            circumstances.out.empty() ? contents(out) : "", contents(err)};
}

}  // namespace signum::test
