/// The filters of space are uncertain wherever the errors that their formulas may commit could have
/// turned the sign, and of hardly more.

#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "../../predicates/space/in_sphere.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../../predicates/space/rectangular_forms.hpp"

#include "threshold.hpp"

namespace signum {
namespace {

using filters::epsilon;
using threshold::expect_first_certain;

/// Turned so that the first axis becomes another one: an even permutation.
Point3 turned(const Point3& p, int axes) {
    return axes == 0 ? p : axes == 1 ? Point3{p.z, p.x, p.y} : Point3{p.y, p.z, p.x};
}

/// The corners (0,0,0), (1,0,s), (0,1,s), (1,1,2s + 2kes): the determinant is 2kes.
struct NearlyFlat {
    std::array<Point3, 4> corners;

    NearlyFlat(int axes, double size, std::int64_t steps)
        : corners{turned({0, 0, 0}, axes), turned({1, 0, size}, axes), turned({0, 1, size}, axes),
                  turned({1, 1, size * (2.0 + 2.0 * static_cast<double>(steps) * epsilon)}, axes)} {
    }
};

TEST(SpaceBounds, OfCcwInSpace) {
    for (const int axes : {0, 1, 2})
        for (const double size : {0x1p-40, 1.0, 0x1p40}) {
            // Six times the product of the largest coordinates, 2s: 8 roundings of counted ones.
            expect_first_certain("ccw_filter", 8 * 6, 10 * 6, [&](std::int64_t steps) {
                const auto& [a, b, c, d] = NearlyFlat(axes, size, steps).corners;
                return predicates::ccw_filter(a, b, c, d).is_certain();
            });
            // The magnitude itself, 4s.
            expect_first_certain("behind the filter", 8 * 2, 10 * 2, [&](std::int64_t steps) {
                const auto& [a, b, c, d] = NearlyFlat(axes, size, steps).corners;
                return predicates::Ccw3::of_points<Arithmetic::exact>(a, b, c, d).stage ==
                       Stage::filter;
            });
        }
}

/// Four sites and the origin, to which all are s and 1 away, but weights make the heights 1, 1, 1
/// and 3, linear in the coordinates: a tie. The first one's weight is kes² greater: the determinant
/// is s times that.
struct NearlyTied {
    std::array<power::Site3, 5> sites;

    NearlyTied(int axes, double s, std::int64_t steps) {
        const double square = s * s;
        const double more = static_cast<double>(steps) * epsilon * square;
        const auto site = [&](const Point3& p, double weight) {
            const auto [x, y, z] = turned(p, axes);
            return power::Site3{x, y, z, weight};
        };
        sites = {site({s, 0, 0}, square - 1.0 + more), site({0, 1, 0}, 0), site({0, 0, 1}, 0),
                 site({s, 1, 1}, square - 1.0), site({0, 0, 0}, 0)};
    }
};

TEST(SpaceBounds, OfInSphere) {
    for (const int axes : {0, 1, 2})
        for (const double s : {1.0, 16.0}) {
            // 24 times the product of the largest coordinates, s, and the largest height.
            const double size = 24 * (2 * s * s + 1) / (s * s);
            expect_first_certain("in_sphere_filter", 17 * size, 19 * size, [&](std::int64_t steps) {
                const auto& [i, j, k, l, q] = NearlyTied(axes, s, steps).sites;
                return power::in_sphere_filter(i, j, k, l, q).is_certain();
            });
            // The magnitude itself: the heights s² + |s² - 1|, 1, 1 and 2s² + 1 times minors of s,
            // s, s and s.
            const double magnitude = (4 * s * s + 2) / (s * s);
            expect_first_certain(
                "in_sphere behind the filter", 17 * magnitude, 19 * magnitude,
                [&](std::int64_t steps) {
                    const auto& [i, j, k, l, q] = NearlyTied(axes, s, steps).sites;
                    return power::InSphere::behind<Arithmetic::exact>(i, j, k, l, q).stage ==
                           Stage::filter;
                });
        }
}

/// What is proved of lifted_row() holds of what the filter computes.
template <class S>
void expect_rows_are_the_same(const S& m, const S& q) {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const power::LiftedRow<double> one =
            power::lifted_row(filters::pinned(m), filters::pinned(q));
        const power::LiftedRow<double> two = power::paired_row(m, power::pinned_row(q));
        std::fesetround(FE_TONEAREST);
        EXPECT_EQ(one.offset.x, two.offset.x);
        EXPECT_EQ(one.offset.y, two.offset.y);
        EXPECT_EQ(one.offset.z, two.offset.z);
        if (one.weight == one.weight)
            EXPECT_EQ(one.weight, two.weight);
        else
            EXPECT_NE(two.weight, two.weight);
    }
}

TEST(SpaceBounds, OfInSphereAreOfTheRowsThatItComputes) {
    std::mt19937_64 random(75);
    const auto number = [&] {
        static constexpr std::array scales = {0x1p-1074, 0x1p-600, 1.0, 0x1p600, 0x1.8p1023};
        return scales[random() % scales.size()] *
               (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
    };
    for (int trial = 0; trial < 20000; ++trial) {
        const std::array<double, 8> n = {number(), number(), number(), number(),
                                         number(), number(), number(), number()};
        expect_rows_are_the_same(Point3{n[0], n[1], n[2]}, Point3{n[4], n[5], n[6]});
        expect_rows_are_the_same(Site3{n[0], n[1], n[2], n[3]}, Site3{n[4], n[5], n[6], n[7]});
        expect_rows_are_the_same(power::Site3{n[0], n[1], n[2], n[3]},
                                 power::Site3{n[4], n[5], n[6], n[7]});
    }
}

/// The bound is 2^43 times smaller than what the determinant's sums may come to.
TEST(SpaceBounds, OfInSphereWhereItsSumsOverflow) {
    const double unit = 0x1p1022;
    const auto ask = [](const auto& i, const auto& j, const auto& k, const auto& l, const auto& q) {
        EXPECT_FALSE(power::in_sphere_filter(i, j, k, l, q).is_certain());
        EXPECT_EQ(power::in_sphere(i, j, k, l, q), -1);
    };
    ask(power::Site3{1, 1, 1, -1.5 * unit}, power::Site3{-1, -1, 1, 0.45 * unit},
        power::Site3{-1, 1, -1, 0.9 * unit}, power::Site3{1, -1, -1, 0.45 * unit},
        power::Site3{0, 0, 0, 0});
    const double far = 0x1p149;
    const double weight = 0x1p575;
    ask(power::Site3{far, far, far, -1.5 * weight}, power::Site3{-far, -far, far, 0.45 * weight},
        power::Site3{-far, far, -far, 0.9 * weight}, power::Site3{far, -far, -far, 0.45 * weight},
        power::Site3{0, 0, 0, 0});
    ask(Site3{0x1p-64, -0x1p+81, 0x1.0000000000001p+27, 0x1.1db6a63a9cf2bp+489},
        Site3{0x1p-64, 0x1p+81, 0, 0x1.4666602971e7bp+488},
        Site3{0x1.0000000000003p-64, -0x1p+81, -0x1p+27, 0x1.96f4b94f28b4cp+489},
        Site3{-0x1p-64, -0x1p+81, -0x1p+27, -0x1.1b8288f125b29p+488}, Site3{0, 0, 0, 0});
}

/// The last site alone is the farthest along an axis: (s,1,2), of height 4.
TEST(SpaceBounds, OfInSphereWhereTheLastSiteIsFarthest) {
    for (const int axes : {0, 1, 2})
        for (const double s : {1.0, 16.0}) {
            const double square = s * s;
            const double size = 24 * 2 * (2 * square + 6) / square;
            expect_first_certain("in_sphere_filter", 17 * size, 19 * size, [&](std::int64_t steps) {
                auto sites = NearlyTied(axes, s, steps).sites;
                const auto [x, y, z] = turned({s, 1, 2}, axes);
                sites[3] = {x, y, z, square + 1.0};
                const auto& [i, j, k, l, q] = sites;
                return power::in_sphere_filter(i, j, k, l, q).is_certain();
            });
        }
}

TEST(SpaceBounds, OfNearer) {
    const auto expect = [](double to_a, double to_b, double weight) {
        const double size = to_a * to_a + to_b * to_b + weight;
        expect_first_certain("nearer_filter", 7 * size, 10 * size, [&](std::int64_t steps) {
            const power::Site3 a{to_a, 0, 0, weight + static_cast<double>(steps) * epsilon};
            const power::Site3 b{0, to_b, 0, 0};
            return power::nearer_filter({0, 0, 0}, a, b).is_certain();
        });
    };
    expect(1, 1, 0);
    expect(1, 0, 1);
}

TEST(SpaceBounds, OfFormsInSpace) {
    using rectangular::bound_of;
    EXPECT_GE(bound_of<rectangular::Cube>(1.0), 6 * 4 * epsilon);
    EXPECT_LE(bound_of<rectangular::Cube>(1.0), 8 * 4 * epsilon);
    EXPECT_GE(bound_of<rectangular::Octahedron>(1.0), 8 * 6 * epsilon);
    EXPECT_LE(bound_of<rectangular::Octahedron>(1.0), 10 * 6 * epsilon);
    EXPECT_EQ(bound_of<rectangular::Cube>(0x1p1000), HUGE_VAL);
    EXPECT_EQ(rectangular::size_of({1, -2, 4, -8}), 15);
}

}  // namespace
}  // namespace signum
