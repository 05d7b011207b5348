#include "machine.hpp"

#include <sys/sysinfo.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include <fmt/format.h>

namespace signum::study {
namespace {

/// What /proc/cpuinfo calls the processor.
std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos)
            return line.substr(colon + 2);
    }
    return "unknown";
}

std::string memory() {
    struct sysinfo info = {};
    if (::sysinfo(&info) != 0) return "unknown";
    const double bytes = static_cast<double>(info.totalram) * static_cast<double>(info.mem_unit);
    return fmt::format("{:.1f} GiB", bytes / 0x1p30);
}

std::string system() {
    struct utsname names = {};
    if (::uname(&names) != 0) return "unknown";
    return fmt::format("{} {}, {}", names.sysname, names.release, names.machine);
}

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
    return {{"processor", processor()},
            {"cores", std::to_string(std::thread::hardware_concurrency())},
            {"memory", memory()},
            {"system", system()},
            {"compiler", compiler()}};
}

}  // namespace signum::study
