// CGAL: the kernel of exact predicates.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
static Kernel::Point_2 flat(const double* p) {
    return {p[0], p[1]};
}
static Kernel::Point_3 solid(const double* p) {
    return {p[0], p[1], p[2]};
}
extern "C" {
int orient2d(const double* a, const double* b, const double* c) {
    return CGAL::orientation(flat(a), flat(b), flat(c));
}
int incircle(const double* a, const double* b, const double* c, const double* d) {
    return CGAL::side_of_oriented_circle(flat(a), flat(b), flat(c), flat(d));
}
int orient3d(const double* a, const double* b, const double* c, const double* d) {
    return CGAL::orientation(solid(a), solid(b), solid(c), solid(d));
}
int insphere(const double* a, const double* b, const double* c, const double* d, const double* e) {
    return CGAL::side_of_oriented_sphere(solid(a), solid(b), solid(c), solid(d), solid(e));
}
}
