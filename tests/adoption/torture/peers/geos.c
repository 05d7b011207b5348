/* GEOS: its orientation index, of coordinates in pairs. */
#define GEOS_USE_ONLY_R_API
#include <geos_c.h>

int orient2d(const double* a, const double* b, const double* c) {
    static GEOSContextHandle_t handle;
    if (!handle) handle = GEOS_init_r();
    return GEOSOrientationIndex_r(handle, a[0], a[1], b[0], b[1], c[0], c[1]);
}
