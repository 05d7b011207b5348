#pragma once
/// What stands behind the handles that several files share.

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../../triangulation/tessellation.hpp"
#include "boundary.hpp"

struct signum_tessellation {
    static constexpr const char* name = "tessellation";
    signum::Tessellation tessellation;
};

namespace signum::c {

/// Creates a handle where the caller wants it; null while it is not there. The handle is
/// Handle{make()}.
template <class Handle, class Make>
signum_status create(Handle** place, signum_error* error, Make&& make) noexcept {
    if (place != nullptr) *place = nullptr;
    return guarded(error, [&] {
        expect(place, Handle::name);
        *place = new Handle{make()};
    });
}

/// Refuses null, and a handle from the callback that its work is calling: what it would show is
/// half done.
template <class Handle>
void expect(const Handle* handle) {
    expect(handle, Handle::name);
    if constexpr (requires { handle->is_calling; })
        if (handle->is_calling)
            throw Refused("the " + std::string(Handle::name) + " is at work: this is its callback");
}
/// guarded(), where the work begins with a handle.
template <class Handle, class Work>
signum_status with(const Handle* handle, signum_error* error, std::int64_t about,
                   Work&& work) noexcept {
    return guarded(error, about, [&] {
        expect(handle);
        work();
    });
}
template <class Handle, class Work>
signum_status with(const Handle* handle, signum_error* error, Work&& work) noexcept {
    return with(handle, error, -1, std::forward<Work>(work));
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

/// Copies rows of 32-bit integers; a Row is nothing but its numbers.
template <class Row>
[[nodiscard]] std::vector<Row> rows_from(const std::int32_t* numbers, std::int64_t count) {
    std::vector<Row> rows(static_cast<std::size_t>(count));
    if (count > 0) std::memcpy(rows.data(), numbers, rows.size() * sizeof(Row));
    return rows;
}
/// Shows rows where they lie, and says how many there are.
template <class Rows, class Number>
void show(const Rows& rows, const Number*& first, std::int64_t& count) noexcept {
    first = reinterpret_cast<const Number*>(rows.data());
    count = static_cast<std::int64_t>(rows.size());
}

}  // namespace signum::c
