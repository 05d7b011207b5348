#pragma once
/// Numbers of sites, faces and edges that a caller gives: checked in release builds, too.

#include <cstddef>
#include <stdexcept>
#include <string>

#include "index.hpp"

namespace signum {

/// Throws std::out_of_range, naming the handle.
[[noreturn, gnu::cold, gnu::noinline]] inline void refuse_handle(const char* kind, Index handle,
                                                                 std::size_t count) {
    throw std::out_of_range("there is no " + std::string(kind) + " " + std::to_string(handle) +
                            ", of " + std::to_string(count));
}

/// The handle as a place in an array. Throws std::out_of_range unless 0 <= handle < count.
[[nodiscard]] inline std::size_t checked(const char* kind, Index handle, std::size_t count) {
    const auto place = static_cast<std::size_t>(handle);  // of a negative one it is huge
    if (place >= count) [[unlikely]]
        refuse_handle(kind, handle, count);
    return place;
}

}  // namespace signum
