#pragma once
/// What stands behind the handles that several files share.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "../../triangulation/tessellation.hpp"
#include "boundary.hpp"

struct signum_tessellation {
    signum::Tessellation tessellation;
};

namespace signum::c {

/// Creates a handle where the caller wants it; null while it is not there. The handle is
/// Handle{make()}.
template <class Handle, class Make>
signum_status create(Handle** place, const char* name, signum_error* error, Make&& make) noexcept {
    if (place != nullptr) *place = nullptr;
    return guarded(error, [&] {
        expect(place, name);
        *place = new Handle{make()};
    });
}

/// Refuses null, and a handle from the callback that its work is calling: what it would show is
/// half done.
template <class Handle>
void expect_at_rest(const Handle* handle, const char* name) {
    expect(handle, name);
    if (handle->is_calling)
        throw Refused("the " + std::string(name) + " is at work: this is its callback");
}
/// Frees a handle; one at work stays.
template <class Handle>
void free_at_rest(Handle* handle) noexcept {
    if (handle != nullptr && !handle->is_calling) delete handle;
}

/// While it lives a callback is running, or may be.
class Calling {
 public:
    explicit Calling(bool& flag) noexcept : flag_(flag) { flag_ = true; }
    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;
    ~Calling() { flag_ = false; }

 private:
    bool& flag_;
};

}  // namespace signum::c
