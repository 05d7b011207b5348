#include "memory_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

namespace signum::fuzz {

MemoryFile::MemoryFile(Bytes bytes) : descriptor_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    must(descriptor_ >= 0, "no memory for a file");
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        must(written > 0, "no memory for a file");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

MemoryFile::MemoryFile(std::string_view text)
    : MemoryFile(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size())) {}

MemoryFile::~MemoryFile() {
    ::close(descriptor_);
}

}  // namespace signum::fuzz
