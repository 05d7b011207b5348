#include "parts_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"

namespace signum::cli {
namespace {

constexpr std::string_view advice =
    "give the arguments of that call, delete the folder, or leave --resume out";

[[noreturn]] void fail_in_folder(const std::string& path) {
    const int error = errno;
    std::string message = fmt::format("cannot keep pieces in {}: {}", path, std::strerror(error));
    if (error == ENOENT || error == ENOTDIR)
        throw NameError(message + "; give a file in a directory that is there");
    throw MachineError(message);
}

/// Whether a file that is open still has its name.
bool has_name(int descriptor, const std::string& path) {
    struct stat own = {};
    struct stat named = {};
    return ::fstat(descriptor, &own) == 0 && ::stat(path.c_str(), &named) == 0 &&
           own.st_dev == named.st_dev && own.st_ino == named.st_ino;
}

std::string shown(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

PartsFolder::PartsFolder(std::string path) : path_(std::move(path)) {
    std::error_code none;
    if (std::filesystem::exists(path_, none) && !std::filesystem::exists(manifest(), none) &&
        !(std::filesystem::is_directory(path_, none) && std::filesystem::is_empty(path_, none)))
        throw CallError(fmt::format(
            "{} is there, and has no pieces; move it away, or leave --resume out", path_));
    // A process that has just finished may take folder and manifest away between two steps.
    while (descriptor_ < 0 || !has_name(descriptor_, manifest())) {
        if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
        if (::mkdir(path_.c_str(), 0777) != 0 && errno != EEXIST) fail_in_folder(path_);
        descriptor_ = ::open(manifest().c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != ENOENT) fail_in_folder(path_);
        if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) continue;
        const bool is_used = errno == EWOULDBLOCK;
        ::close(std::exchange(descriptor_, -1));
        if (!is_used) fail_in_folder(path_);
        throw MachineError(fmt::format(
            "another process works in {}; wait for its end, or give another -o", path_));
    }
    std::string text;
    std::array<char, 4096> some{};
    for (ssize_t count; (count = ::read(descriptor_, some.data(), some.size())) > 0;)
        text.append(some.data(), static_cast<std::size_t>(count));
    if (!text.empty()) there_ = nlohmann::json::parse(text, nullptr, false);
    if (!text.empty() && !there_.is_object()) {
        ::close(descriptor_);
        throw CallError(
            fmt::format("{} is damaged; delete its folder, or leave --resume out", manifest()));
    }
    remove_files(false);
}

PartsFolder::~PartsFolder() {
    if (descriptor_ < 0) return;
    if (there_.is_null())
        remove();
    else
        ::close(descriptor_);
}

void PartsFolder::require(const nlohmann::json& values) {
    asked_.update(values);
    if (there_.is_null()) return;
    std::vector<std::string> differences;
    for (const auto& [key, value] : values.items()) {
        const nlohmann::json there = there_.value(key, nlohmann::json());
        if (there != value)
            differences.push_back(
                fmt::format("{} {} there and {} here", key, shown(there), shown(value)));
    }
    if (differences.empty()) return;
    if (there_.contains("memory") && there_.contains("threads"))
        differences.push_back(fmt::format("it had --memory {} --threads {}",
                                          shown(there_["memory"]), shown(there_["threads"])));
    throw CallError(fmt::format("the pieces in {} are another call's: {}; {}", path_,
                                fmt::join(differences, ", "), advice));
}

void PartsFolder::write() {
    if (!there_.is_null()) return;
    const std::string text = asked_.dump(2) + "\n";
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count != static_cast<ssize_t>(text.size()) ||
        (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOSYS)) {
        if (count >= 0 && count < static_cast<ssize_t>(text.size())) errno = ENOSPC;
        fail_in_folder(path_);
    }
    there_ = asked_;
}

void PartsFolder::remove() noexcept {
    std::error_code ignored;
    remove_files(true);
    // The last of its files: while others are there it says what they are.
    std::filesystem::remove(manifest(), ignored);
    std::filesystem::remove(path_, ignored);
    ::close(std::exchange(descriptor_, -1));
}

void PartsFolder::remove_files(bool pieces) const noexcept {
    std::error_code ignored;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator each(path_, ignored), end; each != end;
         each.increment(ignored)) {
        const auto ending = each->path().extension();
        if (ending == ".tmp" || (pieces && ending == ".piece")) files.push_back(each->path());
    }
    for (const auto& file : files) std::filesystem::remove(file, ignored);
}

}  // namespace signum::cli
