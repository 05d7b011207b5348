#ifndef SIGNUM_CLASSIC_H
#define SIGNUM_CLASSIC_H
/* The names of Shewchuk's predicates.c, and of what TetGen adds to them, for programs that call them: link
 * libsignum_classic in the place of predicates.o. A program that declares them itself, in C or in C++, with
 * `double*` or `const double*`, need not include this header.
 *
 * A point is an array of two doubles or, in the predicates of space, of three. Each function returns a determinant.
 * For all finite coordinates, in every rounding mode, with denormals flushed, in any number of threads at once:
 *  1. it is 0 where the determinant is 0, and nowhere else; its sign is that of the determinant;
 *  2. it is off by less than one unit in the last place: one of the two doubles beside the determinant, or that
 *     itself;
 *  3. beyond the doubles it is an infinity; below the least normal double it is the nearest double, but for 0, in
 *     whose place stands the least one.
 * With a coordinate that is infinite or NaN it is NaN. No call fails or throws; where memory for the last stage, a few
 * kilobytes, is lacking, the program ends. Time: constant but
 * where the points are within some 2^-40 of a tie, or a coordinate is beyond 2^150 or, not 0, below 2^-150.
 * Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997. */

#ifdef __cplusplus
extern "C" {
#endif

/* Does nothing: there is nothing to prepare. C programs may hand it arguments, as TetGen does. */
#ifdef __cplusplus
void exactinit(void);
#else
void exactinit();
#endif

/* Positive where a, b, c turn counterclockwise: twice the area of the triangle. */
double orient2d(const double* a, const double* b, const double* c);

/* Positive where d lies below the plane of a, b, c, which turn counterclockwise seen from above: six times the
 * volume of the tetrahedron. */
double orient3d(const double* a, const double* b, const double* c, const double* d);

/* Positive where d lies inside the circle through a, b, c, if orient2d(a, b, c) > 0. */
double incircle(const double* a, const double* b, const double* c, const double* d);

/* Positive where e lies inside the sphere through a, b, c, d, if orient3d(a, b, c, d) > 0. */
double insphere(const double* a, const double* b, const double* c, const double* d, const double* e);

/* insphere with the heights given, in whose place insphere has the squares of the distances from the origin: the
 * determinant of the rows (m - e, height of m - height of e). */
double orient4d(const double* a, const double* b, const double* c, const double* d, const double* e,
                double a_height, double b_height, double c_height, double d_height, double e_height);

/* The same determinants in other words: those above, for they are exact. */
double orient2dexact(const double* a, const double* b, const double* c);
double orient3dexact(const double* a, const double* b, const double* c, const double* d);
double incircleexact(const double* a, const double* b, const double* c, const double* d);
double insphereexact(const double* a, const double* b, const double* c, const double* d, const double* e);
double orient2dslow(const double* a, const double* b, const double* c);
double orient3dslow(const double* a, const double* b, const double* c, const double* d);
double incircleslow(const double* a, const double* b, const double* c, const double* d);
double insphereslow(const double* a, const double* b, const double* c, const double* d, const double* e);

/* The determinants in plain doubles, as the caller's environment has them: laws 1 to 3 do not hold. */
double orient2dfast(const double* a, const double* b, const double* c);
double orient3dfast(const double* a, const double* b, const double* c, const double* d);
double incirclefast(const double* a, const double* b, const double* c, const double* d);
double inspherefast(const double* a, const double* b, const double* c, const double* d, const double* e);

#ifdef __cplusplus
}
#endif
#endif
