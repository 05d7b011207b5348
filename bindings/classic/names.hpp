// The classic names for points that are SIGNUM_POINT; included once for every way in which a
// program may have declared them, and so without a guard.

#define SIGNUM_THREE(name) double name(SIGNUM_POINT a, SIGNUM_POINT b, SIGNUM_POINT c)
#define SIGNUM_FOUR(name) \
    double name(SIGNUM_POINT a, SIGNUM_POINT b, SIGNUM_POINT c, SIGNUM_POINT d)
#define SIGNUM_FIVE(name) \
    double name(SIGNUM_POINT a, SIGNUM_POINT b, SIGNUM_POINT c, SIGNUM_POINT d, SIGNUM_POINT e)

// clang-format off
SIGNUM_THREE(orient2d) { return signum::classic::rounded(signum::classic::Orient2d{a, b, c}); }
SIGNUM_FOUR(orient3d) { return signum::classic::rounded(signum::classic::Orient3d{a, b, c, d}); }
SIGNUM_FOUR(incircle) { return signum::classic::rounded(signum::classic::Incircle{a, b, c, d}); }
SIGNUM_FIVE(insphere) { return signum::classic::rounded(signum::classic::Insphere{a, b, c, d, e}); }
double orient4d(SIGNUM_POINT a, SIGNUM_POINT b, SIGNUM_POINT c, SIGNUM_POINT d, SIGNUM_POINT e,
                double a_height, double b_height, double c_height, double d_height, double e_height) {
    return signum::classic::rounded(signum::classic::Orient4d{
        a, b, c, d, e, {a_height, b_height, c_height, d_height, e_height}});
}

SIGNUM_THREE(orient2dexact) { return orient2d(a, b, c); }
SIGNUM_FOUR(orient3dexact) { return orient3d(a, b, c, d); }
SIGNUM_FOUR(incircleexact) { return incircle(a, b, c, d); }
SIGNUM_FIVE(insphereexact) { return insphere(a, b, c, d, e); }
SIGNUM_THREE(orient2dslow) { return orient2d(a, b, c); }
SIGNUM_FOUR(orient3dslow) { return orient3d(a, b, c, d); }
SIGNUM_FOUR(incircleslow) { return incircle(a, b, c, d); }
SIGNUM_FIVE(insphereslow) { return insphere(a, b, c, d, e); }

SIGNUM_THREE(orient2dfast) { return signum::classic::Orient2d{a, b, c}.determinant<double>(); }
SIGNUM_FOUR(orient3dfast) { return signum::classic::Orient3d{a, b, c, d}.determinant<double>(); }
SIGNUM_FOUR(incirclefast) { return signum::classic::Incircle{a, b, c, d}.determinant<double>(); }
SIGNUM_FIVE(inspherefast) { return signum::classic::Insphere{a, b, c, d, e}.determinant<double>(); }
// clang-format on

#undef SIGNUM_THREE
#undef SIGNUM_FOUR
#undef SIGNUM_FIVE
