/// A tessellation that changes, behind signum.h.

#include "../../triangulation/dynamic.hpp"

#include <vector>

#include "boundary.hpp"
#include "handles.hpp"

struct signum_dynamic {
    static constexpr const char* name = "dynamic";
    signum::DynamicTessellation sites;
};

using namespace signum;
using c::expect;
using c::with;

signum_status signum_dynamic_create(signum_metric metric, signum_weight_is weight_is,
                                    signum_dynamic** dynamic, signum_error* error) {
    return c::create(dynamic, error, [&] {
        return DynamicTessellation(c::metric_of(metric), c::weight_of(weight_is));
    });
}

void signum_dynamic_free(signum_dynamic* dynamic) {
    delete dynamic;
}

signum_status signum_dynamic_insert(signum_dynamic* dynamic, const double* site, int32_t* handle,
                                    signum_error* error) {
    return with(dynamic, error, [&] {
        expect(site, "site");
        const Index given = dynamic->sites.insert({site[0], site[1], site[2]});
        if (handle != nullptr) *handle = given;
    });
}

signum_status signum_dynamic_erase(signum_dynamic* dynamic, int32_t handle, signum_error* error) {
    return with(dynamic, error, handle, [&] { dynamic->sites.erase(handle); });
}

signum_status signum_dynamic_change(signum_dynamic* dynamic, int32_t handle, double third,
                                    signum_error* error) {
    return with(dynamic, error, handle, [&] { dynamic->sites.change(handle, third); });
}

signum_status signum_dynamic_move(signum_dynamic* dynamic, int32_t handle, const double* centre,
                                  signum_error* error) {
    return with(dynamic, error, handle, [&] {
        expect(centre, "centre");
        dynamic->sites.move(handle, {centre[0], centre[1]});
    });
}

signum_status signum_dynamic_move_all(signum_dynamic* dynamic, const double* centres, int64_t count,
                                      signum_error* error) {
    return with(dynamic, error, [&] {
        c::expect_array(centres, count, "centres");
        std::vector<Point> points;
        points.reserve(static_cast<std::size_t>(count));
        for (std::int64_t i = 0; i < count; ++i)
            points.push_back({centres[2 * i], centres[2 * i + 1]});
        dynamic->sites.move_all(points);
    });
}

int signum_dynamic_contains(const signum_dynamic* dynamic, int32_t handle) {
    return dynamic != nullptr && dynamic->sites.contains(handle);
}

int64_t signum_dynamic_size(const signum_dynamic* dynamic) {
    return dynamic == nullptr ? 0 : static_cast<std::int64_t>(dynamic->sites.size());
}

signum_status signum_dynamic_site(const signum_dynamic* dynamic, int32_t handle, double* site,
                                  signum_error* error) {
    return with(dynamic, error, handle, [&] {
        expect(site, "site");
        const Site found = dynamic->sites.site(handle);
        site[0] = found.x;
        site[1] = found.y;
        site[2] = found.r;
    });
}

signum_status signum_dynamic_tessellation(const signum_dynamic* dynamic,
                                          signum_tessellation** tessellation, signum_error* error) {
    return c::create(tessellation, error, [&] {
        expect(dynamic);
        return dynamic->sites.tessellation();
    });
}
