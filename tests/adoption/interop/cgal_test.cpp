/// CGAL's triangulations on signum's predicates: the same as on CGAL's own, with CGAL's checks on;
/// each predicate beside CGAL's in exact numbers; results to CGAL and back.

#if defined(NDEBUG)
#error "CGAL's checks are to be on"
#endif

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "../../../bindings/interop/cgal.hpp"
#include "../../../triangulation/space/validate.hpp"
#include "../../../triangulation/triangulate.hpp"
#include "../../../triangulation/validate.hpp"

namespace {

using signum::Index;
using signum::Point;
using signum::Point3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = signum::cgal::Traits<Kernel>;
using Random = std::mt19937_64;

template <class K>
using Delaunay2 = CGAL::Delaunay_triangulation_2<K>;
template <class K>
using Regular2 = CGAL::Regular_triangulation_2<K>;
template <class K>
using Delaunay3 = CGAL::Delaunay_triangulation_3<K>;
template <class K>
using Regular3 = CGAL::Regular_triangulation_3<K>;

// ---- sites --------------------------------------------------------------------------------------

double uniform(Random& random) {
    return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}
double whole(Random& random, int most) {
    return std::uniform_int_distribution<int>(0, most)(random);
}

/// Coordinates of four kinds: spread, on a grid, on a circle or sphere, on a line or plane.
std::array<double, 3> place(Random& random, int kind) {
    const double x = uniform(random);
    const double y = uniform(random);
    const double z = uniform(random);
    switch (kind) {
        case 0:
            return {x, y, z};
        case 1:
            return {whole(random, 6), whole(random, 6), whole(random, 6)};
        case 2: {
            const double r = std::sqrt((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5));
            return {(x - 0.5) / r, (y - 0.5) / r, whole(random, 1)};
        }
        default: {
            const double step = whole(random, 40);
            return {step, 2.0 * step, 3.0 * step + whole(random, 1)};
        }
    }
}
constexpr int kinds = 4;

template <class S>
std::vector<S> sites(int kind, int number, std::uint64_t seed) {
    Random random(seed);
    std::vector<S> result;
    for (int i = 0; i < number; ++i) {
        const auto [x, y, z] = place(random, kind);
        S site{};
        site.x = x;
        site.y = y;
        if constexpr (requires { site.z; }) site.z = z;
        if constexpr (requires { site.w; })
            site.w = kind == 0 ? uniform(random) / 16.0 : whole(random, 2);
        result.push_back(site);
    }
    return result;
}

template <class T, class S>
std::vector<typename T::Point> points(const std::vector<S>& all) {
    std::vector<typename T::Point> result;
    for (const S& s : all) result.push_back(signum::cgal::details::theirs<typename T::Point>(s));
    return result;
}

signum::Validation judge(const signum::TessellationArrays& arrays, const auto& all) {
    return signum::validate(arrays, all);
}
template <class S>
signum::Validation judge(const signum::SpaceTessellation& arrays, const std::vector<S>& all) {
    return signum::validate(arrays, std::span<const S>(all));
}

// ---- triangulations -----------------------------------------------------------------------------

template <template <class> class Triangulation>
void expect_the_kernels_own() {
    using Theirs = Triangulation<Kernel>;
    using Ours = Triangulation<Traits>;
    using S = signum::cgal::details::SiteOf<Ours>;
    for (int kind = 0; kind < kinds; ++kind)
        for (const int number : {0, 1, 2, 3, 5, 40, 150}) {
            SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << number << " sites");
            const std::vector<S> all = sites<S>(kind, number, 7);
            const auto input = points<Ours>(all);
            const Theirs theirs(input.begin(), input.end());
            const Ours ours(input.begin(), input.end());
            ASSERT_TRUE(ours.is_valid());
            const auto arrays = signum::cgal::arrays(ours, std::span<const S>(all));
            EXPECT_EQ(arrays, signum::cgal::arrays(theirs, std::span<const S>(all)));
            const signum::Validation judged = judge(arrays, all);
            EXPECT_TRUE(judged.valid) << judged.message;
        }
}
TEST(CgalTraits, DelaunayOfThePlaneIsTheKernelsOwn) {
    expect_the_kernels_own<Delaunay2>();
}
TEST(CgalTraits, RegularOfThePlaneIsTheKernelsOwn) {
    expect_the_kernels_own<Regular2>();
}
TEST(CgalTraits, DelaunayOfSpaceIsTheKernelsOwn) {
    expect_the_kernels_own<Delaunay3>();
}
TEST(CgalTraits, RegularOfSpaceIsTheKernelsOwn) {
    expect_the_kernels_own<Regular3>();
}

/// signum's result as CGAL's, which finds it valid; and back.
template <template <class> class Triangulation>
void expect_to_cgal_and_back() {
    using Ours = Triangulation<Traits>;
    using S = signum::cgal::details::SiteOf<Ours>;
    for (int kind = 0; kind < kinds; ++kind)
        for (const int number : {0, 1, 2, 3, 5, 40, 150}) {
            SCOPED_TRACE(testing::Message() << "kind " << kind << ", " << number << " sites");
            const std::vector<S> all = sites<S>(kind, number, 11);
            const std::span<const S> span(all);
            const auto result = [&] {
                if constexpr (signum::cgal::details::is_planar<Ours>)
                    return signum::triangulate(all, signum::Power{}).arrays();
                else
                    return signum::triangulate(span);
            }();
            Ours triangulation;
            const auto vertices = signum::cgal::assign(triangulation, result, span);
            ASSERT_TRUE(triangulation.is_valid());
            ASSERT_EQ(vertices.size(), all.size());
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (vertices[i] == typename Ours::Vertex_handle()) continue;  // CGAL's hidden ones
                const S there = signum::cgal::details::ours(vertices[i]->point());
                EXPECT_EQ(there.x, all[i].x);
                EXPECT_EQ(there.y, all[i].y);
            }
            const auto back = signum::cgal::arrays(triangulation, span);
            // Where weights are equal CGAL chooses among ties as signum does; where they are not,
            // hidden sites that touch may come out of hiding.
            if (kind == 0 || !signum::cgal::details::is_weighted<Ours>) {
                EXPECT_EQ(back, result);
            }
            const signum::Validation judged = judge(back, all);
            EXPECT_TRUE(judged.valid) << judged.message;
        }
}
TEST(CgalConversion, OfDelaunayOfThePlane) {
    expect_to_cgal_and_back<Delaunay2>();
}
TEST(CgalConversion, OfRegularOfThePlane) {
    expect_to_cgal_and_back<Regular2>();
}
TEST(CgalConversion, OfDelaunayOfSpace) {
    expect_to_cgal_and_back<Delaunay3>();
}
TEST(CgalConversion, OfRegularOfSpace) {
    expect_to_cgal_and_back<Regular3>();
}

/// Of equal weights CGAL's ties are signum's: what CGAL builds is what triangulate() does.
TEST(CgalConversion, DelaunayOfCgalIsCanonical) {
    for (int kind = 0; kind < kinds; ++kind) {
        SCOPED_TRACE(kind);
        const auto plane = sites<Point>(kind, 150, 3);
        const auto in_plane = points<Delaunay2<Traits>>(plane);
        const Delaunay2<Traits> two(in_plane.begin(), in_plane.end());
        EXPECT_EQ(signum::cgal::arrays(two, std::span<const Point>(plane)),
                  signum::triangulate(plane, signum::Power{}).arrays());
        const auto space = sites<Point3>(kind, 150, 3);
        const auto in_space = points<Delaunay3<Traits>>(space);
        const Delaunay3<Traits> three(in_space.begin(), in_space.end());
        EXPECT_EQ(signum::cgal::arrays(three, std::span<const Point3>(space)),
                  signum::triangulate(std::span<const Point3>(space)));
    }
}

TEST(CgalConversion, RefusesWhatDoesNotBelongTogether) {
    const std::vector<Point> all = {{0, 0}, {1, 0}, {0, 1}};
    const std::vector<Point> others = {{0, 0}, {1, 0}, {0, 2}};
    const auto input = points<Delaunay2<Traits>>(all);
    Delaunay2<Traits> triangulation(input.begin(), input.end());
    EXPECT_THROW((void)signum::cgal::arrays(triangulation, std::span<const Point>(others)),
                 std::invalid_argument);
    const auto result = signum::cgal::arrays(triangulation, std::span<const Point>(all));
    EXPECT_THROW(signum::cgal::assign(triangulation, result, std::span(all).first(2)),
                 std::invalid_argument);
}

// ---- predicates, beside CGAL's in exact numbers -------------------------------------------------

using Exact = Kernel::Exact_kernel;
using ToExact = Kernel::C2E;

/// Coordinates of one kind each: small integers; neighbours of one double; any finite bits; the
/// largest and the smallest; large ones beside such as vanish next to them. With ties among all of
/// them.
double number(Random& random, int kind) {
    switch (kind) {
        case 0:
            return whole(random, 3);
        case 1:
            return 0.1 + 0x1p-56 * whole(random, 3);
        case 2: {
            for (;;) {
                const auto value = std::bit_cast<double>(random());
                if (std::isfinite(value)) return value;
            }
        }
        case 3:
            return std::array{1.7e308, -1.7e308, 5e-324,
                              0.0}[static_cast<std::size_t>(whole(random, 3))];
        case 4:
            return std::array{
                0.0, 5e-324, 1e-300, 0x1p32, 0x1p33, 0x1p34, -0x1p33}[static_cast<std::size_t>(
                random() % 7)];
        default:
            return 0.1 * whole(random, 3);
    }
}
constexpr int number_kinds = 6;

struct Drawn {
    Random random;
    int kind;
    double operator()() { return number(random, kind); }
    Kernel::Point_2 point_2() {
        const double x = (*this)();
        return {x, (*this)()};
    }
    Kernel::Point_3 point_3() {
        const double x = (*this)();
        const double y = (*this)();
        return {x, y, (*this)()};
    }
    Kernel::Weighted_point_2 site_2() {
        const auto p = point_2();
        return {p, (*this)()};
    }
    Kernel::Weighted_point_3 site_3() {
        const auto p = point_3();
        return {p, (*this)()};
    }
};

template <class Theirs, class Ours, class... P>
void expect_same(const Theirs& theirs, const Ours& ours, const P&... points) {
    const ToExact exact{};
    EXPECT_EQ(static_cast<int>(theirs(exact(points)...)), static_cast<int>(ours(points...)));
}

template <class Test>
void for_all_kinds(int rounds, Test test) {
    for (int kind = 0; kind < number_kinds; ++kind) {
        SCOPED_TRACE(testing::Message() << "numbers of kind " << kind);
        Drawn drawn{Random(5), kind};
        for (int i = 0; i < rounds; ++i) test(drawn);
    }
}

TEST(CgalPredicates, OfThePlaneAreExact) {
    const Exact exact{};
    const Traits ours{};
    for_all_kinds(200, [&](Drawn& drawn) {
        const auto p = drawn.point_2(), q = drawn.point_2(), r = drawn.point_2(),
                   t = drawn.point_2();
        expect_same(exact.orientation_2_object(), ours.orientation_2_object(), p, q, r);
        expect_same(exact.side_of_oriented_circle_2_object(),
                    ours.side_of_oriented_circle_2_object(), p, q, r, t);
        expect_same(exact.compare_distance_2_object(), ours.compare_distance_2_object(), p, q, r);
        const auto a = drawn.site_2(), b = drawn.site_2(), c = drawn.site_2(), d = drawn.site_2();
        const auto theirs_of_sites = exact.power_side_of_oriented_power_circle_2_object();
        const auto of_sites = ours.power_side_of_oriented_power_circle_2_object();
        expect_same(theirs_of_sites, of_sites, a, b, c, d);
        expect_same(theirs_of_sites, of_sites, a, b);
        expect_same(exact.compare_power_distance_2_object(), ours.compare_power_distance_2_object(),
                    p, a, b);
        if (exact.orientation_2_object()(ToExact()(a.point()), ToExact()(b.point()),
                                         ToExact()(c.point())) == CGAL::COLLINEAR &&
            a.point() != b.point())
            expect_same(theirs_of_sites, of_sites, a, b, c);
    });
}

TEST(CgalPredicates, OfSpaceAreExact) {
    const Exact exact{};
    const Traits ours{};
    for_all_kinds(200, [&](Drawn& drawn) {
        const auto p = drawn.point_3(), q = drawn.point_3(), r = drawn.point_3(),
                   s = drawn.point_3(), t = drawn.point_3();
        expect_same(exact.orientation_3_object(), ours.orientation_3_object(), p, q, r, s);
        expect_same(exact.side_of_oriented_sphere_3_object(),
                    ours.side_of_oriented_sphere_3_object(), p, q, r, s, t);
        expect_same(exact.coplanar_orientation_3_object(), ours.coplanar_orientation_3_object(), p,
                    q, r);
        expect_same(exact.compare_distance_3_object(), ours.compare_distance_3_object(), p, q, r);
        const auto a = drawn.site_3(), b = drawn.site_3(), c = drawn.site_3(), d = drawn.site_3(),
                   e = drawn.site_3();
        const auto theirs_of_sites = exact.power_side_of_oriented_power_sphere_3_object();
        const auto of_sites = ours.power_side_of_oriented_power_sphere_3_object();
        expect_same(theirs_of_sites, of_sites, a, b, c, d, e);
        expect_same(theirs_of_sites, of_sites, a, b);
        expect_same(exact.compare_power_distance_3_object(), ours.compare_power_distance_3_object(),
                    p, a, b);
    });
}

/// Of what is asked of points in one plane or on one line only: a plane along two axes, at any
/// place along the third; lines along an axis and along the diagonal.
TEST(CgalPredicates, OfFlatPointsOfSpaceAreExact) {
    const Exact exact{};
    const Traits ours{};
    for_all_kinds(100, [&](Drawn& drawn) {
        const double height = drawn();
        const int axis = std::uniform_int_distribution<int>(0, 2)(drawn.random);
        const auto flat = [&] {
            std::array<double, 3> x = {drawn(), drawn(), drawn()};
            x[static_cast<std::size_t>(axis)] = height;
            return Kernel::Weighted_point_3({x[0], x[1], x[2]}, drawn());
        };
        const auto a = flat(), b = flat(), c = flat(), d = flat();
        if (!CGAL::collinear(ToExact()(a.point()), ToExact()(b.point()), ToExact()(c.point()))) {
            expect_same(exact.coplanar_orientation_3_object(), ours.coplanar_orientation_3_object(),
                        a.point(), b.point(), c.point(), d.point());
            expect_same(exact.coplanar_side_of_bounded_circle_3_object(),
                        ours.coplanar_side_of_bounded_circle_3_object(), a.point(), b.point(),
                        c.point(), d.point());
            // CGAL's takes a projection in which the lifted points are no plane's, and its
            // orientation there, which may be 0: so beside the exact circle of raised points.
            const auto raise = [](const Kernel::Weighted_point_3& m) {
                return Kernel::Weighted_point_3(m.point(), 0.0);
            };
            EXPECT_EQ(static_cast<int>(ours.power_side_of_oriented_power_sphere_3_object()(
                          raise(a), raise(b), raise(c), raise(d))),
                      static_cast<int>(exact.coplanar_side_of_bounded_circle_3_object()(
                          ToExact()(a.point()), ToExact()(b.point()), ToExact()(c.point()),
                          ToExact()(d.point()))));
        }
        const auto on_line = [&] {
            const double x = drawn();
            std::array<double, 3> along = {x, x, x};
            along[static_cast<std::size_t>(axis)] = height;
            return Kernel::Weighted_point_3({along[0], along[1], along[2]}, drawn());
        };
        const auto i = on_line(), j = on_line(), k = on_line();
        if (i.point() != j.point())
            expect_same(exact.power_side_of_oriented_power_sphere_3_object(),
                        ours.power_side_of_oriented_power_sphere_3_object(), i, j, k);
    });
}

}  // namespace
