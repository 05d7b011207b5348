/// Bands and charts of directions: halves cover what they halve, and bounds hold.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "../../voronoi/balls/bands.hpp"
#include "../../voronoi/vector3.hpp"

namespace signum::balls {
namespace {

using Vector = Point3;

double real(std::mt19937_64& g) {
    return static_cast<double>(g() >> 11) * 0x1p-52 - 1.0;
}
Vector unit(const Vector& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    return {v.x / length, v.y / length, v.z / length};
}
Vector any_vector(std::mt19937_64& g) {
    return {real(g), real(g), real(g)};
}

struct Ball {
    Site3 site;
    FineForm form;
};

/// f from the definition, of a direction that is a unit vector but for rounding.
long double value_of(const Site3& i, const Site3& j, const Vector& u) {
    const auto difference = [](double a, double b) {
        return static_cast<long double>(a) - static_cast<long double>(b);
    };
    const std::array x{difference(j.x, i.x), difference(j.y, i.y), difference(j.z, i.z)};
    const long double r = difference(j.r, i.r);
    long double along = 0, square = 0, length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const long double of_u = u.*axes_of_space[k];
        along += x[k] * of_u;
        square += x[k] * x[k];
        length += of_u * of_u;
    }
    return 2 * (along / std::sqrt(length) + r) / (square - r * r);
}

/// Of halves of halves some always hold u: there all forms are as near to that in the middle as it
/// says, but for what long doubles cannot tell.
template <class Region>
void expect_bounds(Region region, const Frame& frame, const Site3& i,
                   const std::vector<Ball>& balls, const Vector& u, long double scale,
                   std::mt19937_64& g) {
    const auto holds = [&](const Region& one) {
        return std::ranges::all_of(balls, [&](const Ball& ball) {
            const FineForm f = frame.of(ball.form);
            const DoubleDouble value = one.value(f);
            const long double off = static_cast<long double>(value.high) + value.low -
                                    scale * value_of(i, ball.site, u);
            const double size = std::fabs(f.x.high) + std::fabs(f.y.high) + std::fabs(f.z.high) +
                                std::fabs(f.b.high);
            return std::fabs(off) <=
                   one.change(f.x.high, f.y.high, f.z.high, f.b.high) + f.error + 0x1p-58L * size;
        });
    };
    std::vector<Region> regions{region};
    for (int step = 0; step < 60; ++step) {
        const int interval = static_cast<int>(g() % 2);
        std::vector<Region> halves;
        for (const Region& each : regions) {
            if (!each.has_halves(interval)) return;
            for (const int number : {0, 1})
                if (const Region half = each.half(interval, number); holds(half))
                    halves.push_back(half);
        }
        ASSERT_FALSE(halves.empty()) << step;
        // Where a half says little, its neighbours hold as well.
        if (halves.size() > 200) return;
        regions = std::move(halves);
    }
}

TEST(BallBands, HalvesCoverAndBoundsHold) {
    std::mt19937_64 g(1);
    for (int trial = 0; trial < 2000; ++trial) {
        const Site3 i{real(g), real(g), real(g), 0.25 * real(g)};
        std::vector<Ball> balls;
        while (balls.size() < 6) {
            const Site3 j{real(g), real(g), real(g), 0.25 * real(g)};
            if (const std::optional<FineForm> f = fine_form(i, j)) balls.push_back({j, *f});
        }
        const Vector v = unit(any_vector(g));
        const double delta = std::ldexp(1.0, -3 - static_cast<int>(g() % 12)) * 0.99;
        Vector u = any_vector(g);
        u = unit(plus(v, u, 0.57 * delta));
        const double off = std::hypot(u.x - v.x, u.y - v.y, u.z - v.z);
        if (off > delta) continue;
        const Frame of_band(any_vector(g), v);
        expect_bounds(Band(v, delta, of_band), of_band, i, balls, u, 1.0L, g);
        const Frame of_chart(v, any_vector(g));
        const long double along = static_cast<long double>(u.x) * of_chart.e.x +
                                  static_cast<long double>(u.y) * of_chart.e.y +
                                  static_cast<long double>(u.z) * of_chart.e.z;
        expect_bounds(Chart(v, delta, of_chart), of_chart, i, balls, u, 1.0L / along, g);
        if (HasFatalFailure()) FAIL() << trial;
    }
}

TEST(BallBands, FormsAreThoseOfTheDefinition) {
    // X = (2, 0, 0), R = 1: P = 3, a = (4/3, 0, 0), b = 2/3.
    const std::optional<FineForm> f = fine_form({0, 0, 0, 0.25}, {2, 0, 0, 1.25});
    ASSERT_TRUE(f.has_value());
    EXPECT_EQ(f->x.high, 4.0 / 3.0);
    EXPECT_EQ(f->x.low, std::fma(-3.0, 4.0 / 3.0, 4.0) / 3.0);
    EXPECT_EQ(f->b.high, 2.0 / 3.0);
    EXPECT_EQ(f->y.high, 0.0);
    // One that hides the other, one that nearly does, and one too near.
    EXPECT_FALSE(fine_form({0, 0, 0, 0}, {1, 0, 0, 2}).has_value());
    EXPECT_FALSE(fine_form({0, 0, 0, 0}, {1, 0, 0, 1 - 0x1p-50}).has_value());
    EXPECT_FALSE(fine_form({0, 0, 0, 0}, {0x1p-500, 0, 0, 0}).has_value());
}

}  // namespace
}  // namespace signum::balls
