#include <sys/sysinfo.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "page.hpp"

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

}  // namespace

std::vector<std::pair<std::string, std::string>> describe_machine() {
    struct sysinfo info = {};
    struct utsname names = {};
    const bool has_info = ::sysinfo(&info) == 0;
    const bool has_names = ::uname(&names) == 0;
    const double bytes = static_cast<double>(info.totalram) * static_cast<double>(info.mem_unit);
#if defined(__clang__)
    const char* compiler = "clang " __clang_version__;
#else
    const char* compiler = "g++ " __VERSION__;
#endif
    return {
        {"processor", processor()},
        {"cores", std::to_string(std::thread::hardware_concurrency())},
        {"memory", has_info ? fmt::format("{:.1f} GiB", bytes / 0x1p30) : "unknown"},
        {"system", has_names ? fmt::format("{} {}, {}", names.sysname, names.release, names.machine)
                             : "unknown"},
        {"compiler", compiler}};
}

}  // namespace signum::study
