#pragma once
/// A file that all ranks write, beside its place until it is complete on all of them.

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "../../mpi/communicator.hpp"
#include "../io/errors.hpp"

namespace signum::mpi {

/// The file beside its place.
[[nodiscard]] inline std::string unfinished(const std::string& name) {
    return name + ".unfinished";
}

[[noreturn]] inline void fail(const std::string& name, int error) {
    throw MachineError(fmt::format("cannot write {}: {}", name, std::strerror(error)));
}

/// Bytes at places of one file.
class SharedFile {
 public:
    enum class Opened : std::uint8_t { anew, as_it_is };

    SharedFile(Communicator& ranks, const std::string& name, Opened opened = Opened::anew)
        : name_(name) {
        const int flags = O_WRONLY | O_CLOEXEC;
        ranks.together([&] {
            if (ranks.rank() == 0) open(opened == Opened::anew ? flags | O_CREAT | O_TRUNC : flags);
        });
        ranks.together([&] {
            if (ranks.rank() != 0) open(flags);
        });
    }
    SharedFile(const SharedFile&) = delete;
    SharedFile& operator=(const SharedFile&) = delete;
    ~SharedFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    void write(std::uint64_t place, const void* bytes, std::size_t size) const {
        const char* from = static_cast<const char*>(bytes);
        while (size > 0) {
            const ssize_t count = ::pwrite(descriptor_, from, size, static_cast<off_t>(place));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) fail(name_, errno);
            from += count;
            place += static_cast<std::uint64_t>(count);
            size -= static_cast<std::size_t>(count);
        }
    }
    void finish() {
        if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(name_, errno);
        if (::close(std::exchange(descriptor_, -1)) != 0) fail(name_, errno);
    }

 private:
    void open(int flags) {
        descriptor_ = ::open(unfinished(name_).c_str(), flags, 0666);
        if (descriptor_ < 0) fail(name_, errno);
    }
    std::string name_;
    int descriptor_ = -1;
};

/// Calls work(), which writes unfinished(name) on some rank, and renames that; nothing is left of a
/// failure. Collective.
template <class Work>
void complete(Communicator& ranks, const std::string& name, const Work& work) {
    try {
        work();
        ranks.together([&] {
            if (ranks.rank() == 0 && std::rename(unfinished(name).c_str(), name.c_str()) != 0)
                fail(name, errno);
        });
    } catch (...) {
        if (ranks.rank() == 0) ::unlink(unfinished(name).c_str());
        throw;
    }
}

}  // namespace signum::mpi
