/// The signs behind CGAL's traits, without CGAL: whichever way the points turn, on grids, beside
/// them, and where offsets have just as many bits as doubles have room for.

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../bindings/interop/cgal/signs.hpp"
#include "../oracle/linear_system.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::cgal::details {
namespace {

using oracle_test::Random;

/// Of the determinant of all sites but the last one, as seen from that, with heights or without.
template <bool lifted, class S, std::size_t n>
int exact_sign(const std::array<S, n>& sites) {
    using oracle::Rational;
    const S& q = sites[n - 1];
    std::vector<oracle::RationalVector> rows;
    for (std::size_t m = 0; m + 1 < n; ++m) {
        const S& s = sites[m];
        oracle::RationalVector row = {Rational(s.x) - q.x, Rational(s.y) - q.y};
        if constexpr (requires { s.z; }) row.push_back(Rational(s.z) - q.z);
        Rational height = 0;
        for (const Rational& offset : row) height += offset * offset;
        if constexpr (requires { s.w; }) height -= Rational(s.w) - q.w;
        if (lifted) row.push_back(height);
        rows.push_back(std::move(row));
    }
    return oracle::determinant(std::move(rows)).sign();
}

/// Integers of so many bits times a power of two, about a place on either side of 0, of which some
/// are moved by an ulp; often the same ones again, or beside them, so that sites are collinear,
/// cocircular or equal, or nearly so.
class Coordinates {
 public:
    explicit Coordinates(Random& random) : random_(random) {
        bits_ = 1 + random.below(30);
        scale_ = std::ldexp(random.below(2) == 0 ? 1.0 : -1.0, random.below(160) - 80);
        // Where doubles are as far apart as the grid, or half or twice that.
        const double far = std::ldexp(1.0 + random.unit(), 50 + random.below(4));
        origin_ = random.below(3) == 0   ? 0.0
                  : random.below(2) == 0 ? std::floor(far)
                                         : std::ldexp(1.0, random.below(40));
        if (random.below(2) == 0) origin_ = -origin_;
        is_moved_ = random.below(4) == 0;
    }
    double operator()() {
        const double most = std::ldexp(1.0, bits_);
        double x = std::floor(most * random_.unit());
        if (random_.below(3) == 0) x = most - 1.0 - random_.below(3);
        if (random_.below(3) == 0) x = last_ + random_.below(3) - 1;
        if (random_.below(6) == 0) x = 0.0;
        last_ = x;
        x = scale_ * (origin_ + x);
        return is_moved_ && random_.below(8) == 0 ? std::nextafter(x, 1e300) : x;
    }

 private:
    Random& random_;
    int bits_;
    double scale_;
    double origin_;
    double last_ = 0.0;
    bool is_moved_;
};

/// (n, n-1) and (n-1, n-2) turn by -1, which is beside products of 54 bits; and where doubles are
/// half of that apart.
TEST(CgalSigns, OfTurnsByTheLeastThereIs) {
    for (const double n : {0x1p26 - 1, 0x1p27 - 1, 0x1p28 - 1})
        for (const double o : {0.0, 0x1p51, 0x1p52 + 0x1p30 + 1, 0x1p53 - 0x1p30})
            for (const double side : {1.0, -1.0}) {
                const auto at = [&](double x, double y) {
                    return Point{side * (o + x), side * (o + y)};
                };
                const std::array s = {at(n, n - 1), at(n - 1, n - 2), at(0, 0)};
                EXPECT_EQ(turn(s[0], s[1], s[2]), (exact_sign<false>(s)))
                    << n << ' ' << o << ' ' << side;
            }
}

/// The fourth corner of a parallelogram lies in the plane of the others: three products of ever
/// more bits cancel.
TEST(CgalSigns, OfParallelogramsInSpaceAreZero) {
    Random random(73);
    for (int trial = 0; trial < 4000; ++trial) {
        const double most = std::ldexp(1.0, 12 + trial % 10);
        const auto number = [&] { return std::floor(most * (random.unit() - 0.5)); };
        const Point3 a{number(), number(), number()};
        const Point3 b{number(), number(), number()};
        const Point3 c{a.x + b.x, a.y + b.y, a.z + b.z};
        ASSERT_EQ(turn(Point3{0, 0, 0}, a, b, c), 0) << trial;
    }
}

TEST(CgalSigns, OfThePlaneAreExact) {
    Random random(71);
    int ties = 0;
    for (int trial = 0; trial < 40000; ++trial) {
        Coordinates next(random);
        std::array<Point, 4> s;
        for (Point& p : s) p = {next(), next()};
        // The fourth corner of a rectangle.
        if (trial % 3 == 0)
            s = {{{s[0].x, s[0].y}, {s[1].x, s[0].y}, {s[0].x, s[1].y}, {s[1].x, s[1].y}}};
        const std::array three = {s[0], s[1], s[2]};
        ASSERT_EQ(turn(s[0], s[1], s[2]), (exact_sign<false>(three))) << trial;
        const int side = exact_sign<true>(s);
        ASSERT_EQ(side_of_circle(s[0], s[1], s[2], s[3]), side) << trial;
        ties += side == 0 ? 1 : 0;
    }
    EXPECT_GT(ties, 10000);
}

TEST(CgalSigns, OfSpaceAreExact) {
    Random random(72);
    int ties = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        Coordinates next(random);
        std::array<Point3, 5> s;
        for (Point3& p : s) p = {next(), next(), next()};
        // Corners of a box.
        if (trial % 3 == 0)
            for (std::size_t m = 2; m < 5; ++m) s[m] = {s[m & 1].x, s[m / 2 & 1].y, s[m / 4].z};
        const std::array four = {s[0], s[1], s[2], s[3]};
        // det(b - a, c - a, d - a), of rows from d: the opposite.
        ASSERT_EQ(turn(s[0], s[1], s[2], s[3]), (-exact_sign<false>(four))) << trial;
        const int side = -exact_sign<true>(s);
        ASSERT_EQ(side_of_sphere(s[0], s[1], s[2], s[3], s[4]), side) << trial;
        ties += side == 0 ? 1 : 0;
    }
    EXPECT_GT(ties, 5000);
}

/// Nearly always the same weight, so that a grid's ties are left by one that differs.
TEST(CgalSigns, OfWeightsAreExact) {
    Random random(74);
    int ties = 0;
    int differing = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        Coordinates next(random);
        std::array<power::Site, 4> plane;
        std::array<power::Site3, 5> space;
        const double weight = next();
        const auto other = [&] { return random.below(8) == 0 ? next() : weight; };
        for (power::Site& s : plane) s = {next(), next(), other()};
        for (power::Site3& s : space) s = {next(), next(), next(), other()};
        if (trial % 3 != 0) {
            for (std::size_t m = 2; m < 4; ++m)
                plane[m] = {plane[m & 1].x, plane[1 - (m & 1)].y, plane[m].w};
            for (std::size_t m = 2; m < 5; ++m)
                space[m] = {space[m & 1].x, space[m / 2 & 1].y, space[m / 4].z, space[m].w};
        }
        const int circle = exact_sign<true>(plane);
        ASSERT_EQ(side_of_circle(plane[0], plane[1], plane[2], plane[3]), circle) << trial;
        const int sphere = -exact_sign<true>(space);
        ASSERT_EQ(side_of_sphere(space[0], space[1], space[2], space[3], space[4]), sphere)
            << trial;
        ties += circle == 0 ? 1 : 0;
        differing += !weigh_the_same(plane) && circle != 0 ? 1 : 0;
    }
    EXPECT_GT(ties, 1000);
    EXPECT_GT(differing, 1000);
}

}  // namespace
}  // namespace signum::cgal::details
