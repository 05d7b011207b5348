// artem-ogre/CDT: its adaptive predicates.
#include <CDT/CDT/include/predicates.h>

extern "C" {
double orient2d(const double* a, const double* b, const double* c) {
    return predicates::adaptive::orient2d(a[0], a[1], b[0], b[1], c[0], c[1]);
}
double incircle(const double* a, const double* b, const double* c, const double* d) {
    return predicates::adaptive::incircle(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]);
}
}
