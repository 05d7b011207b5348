#include "outputs.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "commands.hpp"

namespace signum::cli {
namespace {

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat first = {};
    struct stat second = {};
    return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 &&
           S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

/// ".a, .b or .c"
std::string listed(const std::vector<std::string_view>& endings) {
    std::string text;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        if (i > 0) text += i + 1 < endings.size() ? ", " : " or ";
        text += endings[i];
    }
    return text;
}

}  // namespace

void add_output(CLI::App& command, std::vector<std::string>& paths, const std::string& formats) {
    command
        .add_option("-o,--output", paths,
                    "Where the result goes, by its ending:\n" + formats +
                        "Several are allowed; without it JSON goes to\nstandard output")
        ->type_name("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

std::string ending_of(const std::string& path) {
    const std::size_t point = path.rfind('.');
    if (point == std::string::npos || path.find('/', point) != std::string::npos) return "";
    std::string ending = path.substr(point);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

void check_outputs(const std::vector<std::string>& paths, const std::string& input,
                   const std::vector<std::string_view>& endings) {
    for (auto path = paths.begin(); path != paths.end(); ++path) {
        if (std::find(endings.begin(), endings.end(), ending_of(*path)) == endings.end()) {
            throw CallError(fmt::format("-o {}: the ending says what to write; give it {}", *path,
                                        listed(endings)));
        }
        if (std::find(paths.begin(), path, *path) != path) {
            throw CallError(fmt::format("-o {} is given twice; give it once", *path));
        }
        if (is_same_file(input, *path)) {
            throw CallError(
                fmt::format("-o {} would overwrite the input; give another name", *path));
        }
    }
}

Outputs::Outputs(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) files_.push_back(std::make_unique<OutputFile>(path));
}

void Outputs::write(
    const std::function<void(std::ostream& out, const std::string& ending)>& write_one,
    const std::string& fallback) const {
    for (const auto& file : files_) {
        write_one(file->stream(), ending_of(file->path()));
        file->finish();
    }
    for (const auto& file : files_) file->publish();
    if (files_.empty()) {
        DescriptorStream out(1, "standard output");
        write_one(out, fallback);
        out.flush();
    }
}

}  // namespace signum::cli
