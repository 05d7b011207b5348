/* Ends the process, never comes back, or leaves another rounding mode behind. */
#include <fenv.h>
#include <stdlib.h>

double orient2d(const double* a, const double* b, const double* c) {
    const double value = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
    if (value != value) abort();
    return value;
}

double orient3d(const double* a, const double* b, const double* c, const double* d) {
    while (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]) {
        if (c == d) break;
    }
    fesetround(FE_UPWARD);
    return 1;
}
