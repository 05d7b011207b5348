#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "errors.hpp"
#include "output_file.hpp"

namespace signum {
namespace {

/// The names of unfinished files, for signal handlers; more files than slots are not protected.
std::array<std::atomic<const char*>, 64> unfinished_files = {};
static_assert(std::atomic<const char*>::is_always_lock_free);

std::size_t protect(const char* name) noexcept {
    for (std::size_t slot = 0; slot < unfinished_files.size(); ++slot) {
        const char* empty = nullptr;
        if (unfinished_files[slot].compare_exchange_strong(empty, name)) return slot;
    }
    return unfinished_files.size();
}

void unprotect(std::size_t slot) noexcept {
    if (slot < unfinished_files.size()) unfinished_files[slot] = nullptr;
}

/// Another name cures what one of these is about.
bool is_failure_of_name(int error) noexcept {
    return error == ENOENT || error == ENOTDIR || error == EISDIR || error == ENAMETOOLONG ||
           error == ELOOP;
}

[[noreturn]] void fail(std::string_view name, int error) {
    if (is_failure_of_name(error)) {
        throw NameError(fmt::format("cannot write {}: {}; give a file in a directory that is there",
                                    name, std::strerror(error)));
    }
    throw MachineError(fmt::format("cannot write {}: {}", name, std::strerror(error)));
}

}  // namespace

DescriptorBuffer::DescriptorBuffer(int descriptor, std::string name)
    : descriptor_(descriptor), name_(std::move(name)), bytes_(std::size_t{1} << 16) {
    setp(bytes_.data(), bytes_.data() + bytes_.size());
}

DescriptorBuffer::int_type DescriptorBuffer::overflow(int_type c) {
    write_all();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
        *pptr() = traits_type::to_char_type(c);
        pbump(1);
    }
    return traits_type::not_eof(c);
}

int DescriptorBuffer::sync() {
    write_all();
    return 0;
}

void DescriptorBuffer::write_all() {
    const char* next = pbase();
    const char* const end = pptr();
    // Emptied first: what a failed disk did not take must not be tried again.
    setp(bytes_.data(), bytes_.data() + bytes_.size());
    while (next != end) {
        const ssize_t count = ::write(descriptor_, next, static_cast<std::size_t>(end - next));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(name_, errno);
        next += count;
    }
}

DescriptorStream::DescriptorStream(int descriptor, std::string name)
    : std::ostream(nullptr), buffer_(descriptor, std::move(name)) {
    rdbuf(&buffer_);
    exceptions(std::ios::badbit | std::ios::failbit);
}

OutputFile::OutputFile(std::string path, const std::string& folder)
    : path_(std::move(path)), target_(path_) {
    struct stat status = {};
    const bool exists = ::stat(path_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path_, EISDIR);
    // To rename over a file that is protected against writing, its directory alone is asked.
    if (exists && ::faccessat(AT_FDCWD, path_.c_str(), W_OK, AT_EACCESS) != 0) fail(path_, errno);
    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(path_, errno);
    } else {
        std::error_code ignored;
        if (exists) target_ = std::filesystem::canonical(path_, ignored).string();
        if (target_.empty()) target_ = path_;
        const std::size_t slash = target_.rfind('/');
        const std::string directory = !folder.empty()              ? folder + "/"
                                      : slash == std::string::npos ? std::string()
                                                                   : target_.substr(0, slash + 1);
        unfinished_ =
            fmt::format("{}.signum-{:x}-{:08x}.tmp", directory, ::getpid(), std::random_device()());
        slot_ = protect(unfinished_.c_str());
        descriptor_ = ::open(unfinished_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) {
            const int error = errno;
            unprotect(slot_);
            fail(path_, error);
        }
        // The permissions of the file that is replaced, as far as they are ours to give.
        if (exists && ::fchmod(descriptor_, status.st_mode & 07777) != 0) errno = 0;
    }
    stream_ = std::make_unique<DescriptorStream>(descriptor_, path_);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (unfinished_.empty()) return;
    ::unlink(unfinished_.c_str());
    unprotect(slot_);
}

void OutputFile::finish() {
    if (descriptor_ < 0) return;
    stream_->flush();
    // A file system that cannot synchronize says EINVAL or ENOSYS; its writes have succeeded all
    // the same.
    if (!unfinished_.empty() && ::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOSYS) {
        fail(path_, errno);
    }
    if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, errno);
}

void OutputFile::publish() {
    finish();
    if (unfinished_.empty()) return;
    if (::rename(unfinished_.c_str(), target_.c_str()) != 0) fail(path_, errno);
    unprotect(slot_);
    unfinished_.clear();
}

void remove_unfinished_files() noexcept {
    const int error = errno;
    for (const std::atomic<const char*>& name : unfinished_files) {
        const char* file = name;
        if (file != nullptr) ::unlink(file);
    }
    errno = error;
}

}  // namespace signum
