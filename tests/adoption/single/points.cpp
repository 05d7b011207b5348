/// Points of many types, and the conventions of others, on single/signum_predicates.hpp alone.

#include <signum_predicates.hpp>

#include <array>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <vector>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

int failures = 0;
void expect(int said, int right, const char* what) {
    if (said == right) return;
    std::fprintf(stderr, "%s is %d, not %d\n", what, said, right);
    ++failures;
}
#define EXPECT(expression, right) expect(static_cast<int>(expression), right, #expression)

struct Named {
    float x, y;
};
class Called {
 public:
    Called(double x, double y) : x_(x), y_(y) {}
    double x() const { return x_; }
    double y() const { return y_; }

 private:
    double x_, y_;
};
struct Balls {
    std::array<short, 3> cell;
};

}  // namespace

template <>
struct signum::coordinates<std::complex<double>> {
    static double at(const std::complex<double>& p, int k) { return k == 0 ? p.real() : p.imag(); }
};
template <>
struct signum::coordinates<Balls> {
    static double at(const Balls& p, int k) { return p.cell[static_cast<std::size_t>(k)]; }
};

int main() {
    using namespace signum;
    const double origin[] = {0, 0};
    const double* const pointer = origin;
    const float right[] = {1, 0};
    const std::vector<double> up = {0, 1};
    const std::array<int, 2> corner = {1, 1};
    EXPECT(ccw(pointer, right, up), 1);
    EXPECT(ccw(origin, up, right), -1);
    EXPECT(ccw(Named{0.1F, 0.1F}, Named{0.3F, 0.3F}, Named{0.7F, 0.7F}), 0);
    EXPECT(ccw(Called(0.1, 0.1), Point{0.3, 0.3}, std::complex<double>(0.7, 0.7)), 0);
    // Of the tenths as floats and as doubles, which are not the same numbers.
    EXPECT(ccw(Named{0.1F, 0.1F}, Point{0.1, 0.1}, Point{0.3, 0.3}), 0);
    EXPECT(ccw(Named{0.1F, 0.2F}, Point{0.1, 0.2}, Point{0.3, 0.3}), 1);

    EXPECT(in_circle(origin, right, up, corner), 0);
    EXPECT(in_circle(origin, right, up, Point{0.5, 0.5}), 1);
    EXPECT(in_circle(origin, up, right, Point{0.5, 0.5}), 1);
    EXPECT(in_circle_determinant(origin, up, right, Point{0.5, 0.5}), -1);
    EXPECT(in_circle(origin, right, Point{2, 0}, corner), no_sign);
    const Point infinite{0, 1e308 * 10};
    EXPECT(ccw(origin, right, infinite), no_sign);
    EXPECT(in_circle(origin, up, right, infinite), no_sign);
    EXPECT(in_circle(origin, right, up, infinite), no_sign);
    EXPECT(shewchuk::incircle(origin, right, up, infinite), no_sign);

    const double a[] = {0, 0, 0}, b[] = {1, 0, 0}, c[] = {0, 1, 0}, d[] = {0, 0, 1};
    EXPECT(ccw(a, b, c, d), 1);
    EXPECT(in_sphere(a, b, c, d, Balls{{1, 1, 1}}), 0);
    EXPECT(in_sphere(a, b, c, d, Point3{0.5, 0.5, 0.5}), 1);
    EXPECT(in_sphere(b, a, c, d, Point3{0.5, 0.5, 0.5}), 1);
    EXPECT(in_sphere_determinant(b, a, c, d, Point3{0.5, 0.5, 0.5}), -1);
    EXPECT(in_sphere(a, b, c, corner.data()[0] == 1 ? Point3{1, 1, 0} : Point3{}, d), no_sign);

    EXPECT(shewchuk::orient3d(a, b, c, d), -1);
    EXPECT(shewchuk::insphere(b, a, c, d, Point3{0.5, 0.5, 0.5}), 1);
    EXPECT(shewchuk::insphere(a, b, c, d, Point3{0.5, 0.5, 0.5}), -1);
    EXPECT(shewchuk::incircle(origin, up, right, Point{0.5, 0.5}), -1);
    const Point3 nowhere{0, 0, 1e308 * 10};
    EXPECT(shewchuk::orient3d(a, b, c, nowhere), no_sign);
    EXPECT(shewchuk::insphere(a, b, c, d, nowhere), no_sign);
    EXPECT(in_sphere(b, a, c, d, nowhere), no_sign);
    EXPECT(shewchuk::orient2d(origin, right, up), 1);
    EXPECT(libigl::orient3d(a, b, c, d), -1);
    EXPECT(libigl::incircle(origin, right, up, Point{0.5, 0.5}), 1);
    EXPECT(geogram::orient_2d(origin, right, up), 1);
    EXPECT(geogram::orient_3d(a, b, c, d), 1);
    EXPECT(geogram::in_circle_2d(origin, up, right, Point{0.5, 0.5}), -1);
    EXPECT(geogram::in_sphere_3d(a, b, c, d, Point3{0.5, 0.5, 0.5}), 1);
    EXPECT(cgal::side_of_bounded_sphere(b, a, c, d, Point3{0.5, 0.5, 0.5}), 1);
    EXPECT(cgal::orientation(a, b, c, d), 1);
    EXPECT(cgal::side_of_oriented_circle(origin, up, right, Point{0.5, 0.5}), -1);
    EXPECT(cgal::side_of_bounded_circle(origin, up, right, Point{0.5, 0.5}), 1);
    EXPECT(cgal::side_of_oriented_sphere(b, a, c, d, Point3{0.5, 0.5, 0.5}), -1);

    // Discs: two of radius 1, one of 2 that touches both, and the line beneath them.
    const Site i{0, 0, 1}, j{4, 0, 1};
    EXPECT(Euclidean::exists(i, j, Site{2, 5, 1}), 1);
    EXPECT(Euclidean::hidden(Site{0, 0, 0.5}, i), 1);
    EXPECT(Euclidean::nearer(Point{1, 0}, i, j), 1);
    EXPECT(Power::in_circle(i, j, Site{2, 5, 1}, Balls{{2, 1, 0}}), 1);
    EXPECT(Supremum::in_circle_infinite(i, j, Site{2, -3, 0}), 1);
    EXPECT(Manhattan::hidden(Site{0, 0, 1}, Site{1, 0, 1}), 0);

#if defined(__SSE2__)
    // A float that is denormal is the same number where those are flushed.
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | 0x8040U);
    const Named corner_of_floats{0, 0}, beside{0x1p-140F, 0}, above{0, 0x1p-140F};
    EXPECT(ccw(corner_of_floats, beside, above), 1);
    _mm_setcsr(before);
#endif

    const double terms[] = {1e300, 1.0, -1e300};
    EXPECT(sign_of_sum(terms, 3), 1);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
