/// A power tessellation whose sites move, behind signum.h.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "boundary.hpp"
#include "handles.hpp"

struct signum_kinetic {
    static constexpr const char* name = "kinetic";
    signum::KineticTessellation sites;
    std::vector<signum::Face> faces{};  ///< those that were shown last
    bool is_calling = false;            ///< on_edge
};

namespace signum::c {
namespace {

[[nodiscard]] MovingSite moving(const signum_moving_site& site) noexcept {
    return {site.x, site.y, site.vx, site.vy, site.r, site.time};
}

}  // namespace
}  // namespace signum::c

using namespace signum;
using c::expect;
using c::with;

signum_status signum_kinetic_create(const signum_moving_site* sites, int64_t count, double start,
                                    const double* fall, signum_kinetic** kinetic,
                                    signum_error* error) {
    return c::create(kinetic, error, [&] {
        c::expect_array(sites, count, "sites");
        std::vector<MovingSite> copy;
        copy.reserve(static_cast<std::size_t>(count));
        for (std::int64_t i = 0; i < count; ++i) {
            const signum_moving_site& s = sites[i];
            for (const double number : {s.x, s.y, s.vx, s.vy, s.r, s.time})
                if (!std::isfinite(number))
                    throw c::Refused("site " + std::to_string(i) + " is not finite", i);
            copy.push_back(c::moving(s));
        }
        return KineticTessellation(copy, start, fall == nullptr ? Fall{} : Fall{fall[0], fall[1]});
    });
}

void signum_kinetic_free(signum_kinetic* kinetic) {
    c::free_at_rest(kinetic);
}

signum_status signum_kinetic_insert(signum_kinetic* kinetic, const signum_moving_site* site,
                                    int32_t* handle, signum_error* error) {
    return with(kinetic, error, [&] {
        expect(site, "site");
        const Index given = kinetic->sites.insert(c::moving(*site));
        if (handle != nullptr) *handle = given;
    });
}

signum_status signum_kinetic_erase(signum_kinetic* kinetic, int32_t handle, signum_error* error) {
    return with(kinetic, error, handle, [&] { kinetic->sites.erase(handle); });
}

signum_status signum_kinetic_change(signum_kinetic* kinetic, int32_t handle,
                                    const signum_moving_site* site, signum_error* error) {
    return with(kinetic, error, handle, [&] {
        expect(site, "site");
        kinetic->sites.change(handle, c::moving(*site));
    });
}

int signum_kinetic_contains(const signum_kinetic* kinetic, int32_t handle) {
    return kinetic != nullptr && kinetic->sites.contains(handle);
}

int64_t signum_kinetic_size(const signum_kinetic* kinetic) {
    return kinetic == nullptr ? 0 : static_cast<std::int64_t>(kinetic->sites.size());
}

signum_status signum_kinetic_site(const signum_kinetic* kinetic, int32_t handle,
                                  signum_moving_site* site, signum_error* error) {
    return with(kinetic, error, handle, [&] {
        expect(site, "site");
        const MovingSite found = kinetic->sites.site(handle);
        *site = {found.x, found.y, found.vx, found.vy, found.r, found.time};
    });
}

signum_status signum_kinetic_time(const signum_kinetic* kinetic, double* time,
                                  signum_error* error) {
    return with(kinetic, error, [&] {
        expect(time, "time");
        *time = kinetic->sites.time();
    });
}

signum_status signum_kinetic_next_event(const signum_kinetic* kinetic, double* time,
                                        signum_error* error) {
    return with(kinetic, error, [&] {
        expect(time, "time");
        *time = kinetic->sites.next_event().value_or(std::numeric_limits<double>::infinity());
    });
}

signum_status signum_kinetic_advance(signum_kinetic* kinetic, double time, signum_error* error) {
    return with(kinetic, error, [&] { kinetic->sites.advance(time); });
}

signum_status signum_kinetic_faces(signum_kinetic* kinetic, const int32_t** faces, int64_t* count,
                                   signum_error* error) {
    return with(kinetic, error, [&] {
        expect(faces, "faces");
        expect(count, "count");
        kinetic->faces = kinetic->sites.faces();
        c::show(kinetic->faces, *faces, *count);
    });
}

signum_status signum_kinetic_tessellation(const signum_kinetic* kinetic,
                                          signum_tessellation** tessellation, signum_error* error) {
    return c::create(tessellation, error, [&] {
        expect(kinetic);
        return kinetic->sites.tessellation();
    });
}

signum_status signum_kinetic_watch(signum_kinetic* kinetic,
                                   void (*on_edge)(int32_t, int32_t, int, void*), void* user,
                                   signum_error* error) {
    return with(kinetic, error, [&] {
        if (on_edge == nullptr) return kinetic->sites.watch({});
        kinetic->sites.watch([=](Index a, Index b, bool comes) {
            const c::Calling calling(kinetic->is_calling);
            on_edge(a, b, static_cast<int>(comes), user);
        });
    });
}
