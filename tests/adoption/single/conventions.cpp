/// The namespaces of single/signum_predicates.hpp against those whose names and signs they take:
/// the same questions to both, of lattices, of lattices moved by ulps and of random points.
///
/// usage: single_conventions QUESTIONS

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <signum_predicates.hpp>

#if defined(SIGNUM_WITH_CGAL)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif
#if defined(SIGNUM_WITH_GEOGRAM)
#include <geogram/basic/environment.h>
#include <geogram/basic/logger.h>
#include <geogram/numerics/predicates.h>
#endif
#if defined(SIGNUM_WITH_TETGEN)
void exactinit(int, int, int, double, double, double);
double orient3d(double* a, double* b, double* c, double* d);
double insphere(double* a, double* b, double* c, double* d, double* e);
#endif

namespace {

std::uint64_t asked = 0;
std::uint64_t different = 0;

[[maybe_unused]] void compare(int said, int right, const char* what) {
    ++asked;
    if (said == right) return;
    if (++different <= 10) std::fprintf(stderr, "%s is %d, not %d\n", what, said, right);
}

[[maybe_unused]] int sign(double value) {
    return (value > 0.0) - (value < 0.0);
}

}  // namespace

int main(int count, char** words) {
#if !defined(SIGNUM_WITH_CGAL) && !defined(SIGNUM_WITH_TETGEN) && !defined(SIGNUM_WITH_GEOGRAM)
    std::puts("no peer is here");
    return 77;
#endif
    const std::uint64_t wanted = count > 1 ? std::strtoull(words[1], nullptr, 10) : 100'000;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
#if defined(SIGNUM_WITH_TETGEN)
    exactinit(0, 0, 0, 1.0, 1.0, 1.0);
#endif
#if defined(SIGNUM_WITH_GEOGRAM)
    GEO::Environment::instance();
    GEO::Logger::initialize();
    GEO::PCK::initialize();
    GEO::PCK::set_SOS_mode(GEO::PCK::SOS_LEXICO);
#endif
    double p[5][3];
    std::uint64_t turn = 0;
    while (asked < wanted) {
        const std::uint64_t kind = ++turn % 3;
        for (auto& point : p)
            for (double& x : point) {
                x = kind == 2 ? uniform(random) : 0.1 * static_cast<double>(random() % 5);
                // Not 0, beside which products underflow: that Shewchuk does not promise.
                if (kind == 1 && x != 0.0 && random() % 4 == 0)
                    x = std::nextafter(x, uniform(random));
            }
#if defined(SIGNUM_WITH_CGAL)
        using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
        namespace ours = signum::cgal;
        const auto flat = [&](int m) { return Kernel::Point_2(p[m][0], p[m][1]); };
        const auto solid = [&](int m) { return Kernel::Point_3(p[m][0], p[m][1], p[m][2]); };
        compare(ours::orientation(p[0], p[1], p[2]), CGAL::orientation(flat(0), flat(1), flat(2)),
                "CGAL's orientation");
        compare(ours::side_of_oriented_circle(p[0], p[1], p[2], p[3]),
                CGAL::side_of_oriented_circle(flat(0), flat(1), flat(2), flat(3)),
                "CGAL's side_of_oriented_circle");
        if (signum::ccw(p[0], p[1], p[2]) != 0)
            compare(ours::side_of_bounded_circle(p[0], p[1], p[2], p[3]),
                    CGAL::side_of_bounded_circle(flat(0), flat(1), flat(2), flat(3)),
                    "CGAL's side_of_bounded_circle");
        compare(ours::orientation(p[0], p[1], p[2], p[3]),
                CGAL::orientation(solid(0), solid(1), solid(2), solid(3)),
                "CGAL's orientation in space");
        compare(ours::side_of_oriented_sphere(p[0], p[1], p[2], p[3], p[4]),
                CGAL::side_of_oriented_sphere(solid(0), solid(1), solid(2), solid(3), solid(4)),
                "CGAL's side_of_oriented_sphere");
        if (signum::ccw(p[0], p[1], p[2], p[3]) != 0)
            compare(ours::side_of_bounded_sphere(p[0], p[1], p[2], p[3], p[4]),
                    CGAL::side_of_bounded_sphere(solid(0), solid(1), solid(2), solid(3), solid(4)),
                    "CGAL's side_of_bounded_sphere");
#endif
#if defined(SIGNUM_WITH_TETGEN)
        compare(signum::shewchuk::orient3d(p[0], p[1], p[2], p[3]),
                sign(orient3d(p[0], p[1], p[2], p[3])), "Shewchuk's orient3d");
        compare(signum::shewchuk::insphere(p[0], p[1], p[2], p[3], p[4]),
                sign(insphere(p[0], p[1], p[2], p[3], p[4])), "Shewchuk's insphere");
#endif
#if defined(SIGNUM_WITH_GEOGRAM)
        namespace pck = GEO::PCK;
        const int turn_2d = signum::geogram::orient_2d(p[0], p[1], p[2]);
        const int turn_3d = signum::geogram::orient_3d(p[0], p[1], p[2], p[3]);
        compare(turn_2d, pck::orient_2d(p[0], p[1], p[2]), "Geogram's orient_2d");
        compare(turn_3d, pck::orient_3d(p[0], p[1], p[2], p[3]), "Geogram's orient_3d");
        // It gives ties a side, and wants positive turns.
        const int circle = signum::geogram::in_circle_2d(p[0], p[1], p[2], p[3]);
        const int sphere = signum::geogram::in_sphere_3d(p[0], p[1], p[2], p[3], p[4]);
        if (turn_2d > 0 && circle != 0)
            compare(circle, pck::in_circle_2d_SOS(p[0], p[1], p[2], p[3]),
                    "Geogram's in_circle_2d_SOS");
        if (turn_3d > 0 && sphere != 0)
            compare(sphere, pck::in_sphere_3d_SOS(p[0], p[1], p[2], p[3], p[4]),
                    "Geogram's in_sphere_3d_SOS");
#endif
    }
    std::printf("%llu questions, %llu answered otherwise\n", static_cast<unsigned long long>(asked),
                static_cast<unsigned long long>(different));
    return different == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
