#pragma once
/// What stands behind the handles that several files share.

#include <cstdint>
#include <memory>
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

}  // namespace signum::c
