/* A program in C that calls every classic name: with the header, or as old programs declare them. */

#include <stdio.h>

#ifdef WITH_HEADER
#include <signum/classic.h>
#else
#define REAL double
void exactinit();
REAL orient2d(REAL *, REAL *, REAL *);
REAL orient2dfast(REAL *, REAL *, REAL *);
REAL orient2dexact(REAL *, REAL *, REAL *);
REAL orient2dslow(REAL *, REAL *, REAL *);
REAL orient3d(REAL *, REAL *, REAL *, REAL *);
REAL orient3dfast(REAL *, REAL *, REAL *, REAL *);
REAL orient3dexact(REAL *, REAL *, REAL *, REAL *);
REAL orient3dslow(REAL *, REAL *, REAL *, REAL *);
REAL incircle(REAL *, REAL *, REAL *, REAL *);
REAL incirclefast(REAL *, REAL *, REAL *, REAL *);
REAL incircleexact(REAL *, REAL *, REAL *, REAL *);
REAL incircleslow(REAL *, REAL *, REAL *, REAL *);
REAL insphere(REAL *, REAL *, REAL *, REAL *, REAL *);
REAL inspherefast(REAL *, REAL *, REAL *, REAL *, REAL *);
REAL insphereexact(REAL *, REAL *, REAL *, REAL *, REAL *);
REAL insphereslow(REAL *, REAL *, REAL *, REAL *, REAL *);
REAL orient4d(REAL *, REAL *, REAL *, REAL *, REAL *, REAL, REAL, REAL, REAL, REAL);
#endif

static int faults = 0;

static void expect(const char *name, double value, double expected) {
    if (value == expected) return;
    ++faults;
    printf("%s: %g instead of %g\n", name, value, expected);
}

int main(void) {
    /* Counterclockwise seen from above; d lies below their plane, e inside of the sphere of all four. */
    double a[3] = {0, 0, 0}, b[3] = {2, 0, 0}, c[3] = {0, 2, 0}, d[3] = {0, 0, -2}, e[3] = {1, 1, -1};
    double inside[2] = {1, 1};
    exactinit();
    exactinit();
    expect("orient2d", orient2d(a, b, c), 4);
    expect("orient2dfast", orient2dfast(a, b, c), 4);
    expect("orient2dexact", orient2dexact(a, c, b), -4);
    expect("orient2dslow", orient2dslow(a, b, b), 0);
    expect("orient3d", orient3d(a, b, c, d), 8);
    expect("orient3dfast", orient3dfast(a, b, c, d), 8);
    expect("orient3dexact", orient3dexact(a, c, b, d), -8);
    expect("orient3dslow", orient3dslow(a, b, c, c), 0);
    expect("incircle", incircle(a, b, c, inside), 8);
    expect("incirclefast", incirclefast(a, b, c, inside), 8);
    expect("incircleexact", incircleexact(a, c, b, inside), -8);
    expect("incircleslow", incircleslow(a, b, c, c), 0);
    expect("insphere", insphere(a, b, c, d, e), 24);
    expect("inspherefast", inspherefast(a, b, c, d, e), 24);
    expect("insphereexact", insphereexact(a, c, b, d, e), -24);
    expect("insphereslow", insphereslow(a, b, c, d, d), 0);
    expect("orient4d", orient4d(a, b, c, d, e, 0, 4, 4, 4, 3), 24);
    expect("orient4d, above", orient4d(a, b, c, d, e, 0, 4, 4, 4, 6), 0);
    return faults != 0;
}
