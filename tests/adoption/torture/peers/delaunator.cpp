// delfrrr/delaunator-cpp: inside, or not; a point on the circle may be either for a triangulation,
// so that ties are answered as they are.
#include <delaunator-cpp/include/delaunator.hpp>

#include <signum_predicates.hpp>

extern "C" int incircle(const double* a, const double* b, const double* c, const double* d) {
    if (signum::in_circle_determinant(a, b, c, d) == 0) return 0;
    const bool inside = delaunator::in_circle(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]);
    return inside ? -1 : 1;
}
