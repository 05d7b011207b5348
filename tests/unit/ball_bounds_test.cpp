/// The filters of balls are uncertain wherever the errors that their polynomials may commit could
/// have turned the sign, and of hardly more: where each begins to be certain, the number it judges
/// is set beside the sizes and the counted roundings of predicates/space/ball_filter.hpp.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../predicates/space/ball_filter.hpp"

#include "threshold.hpp"

namespace signum::euclidean::balls {
namespace {

using filters::epsilon;
using threshold::expect_first_certain;
using threshold::first_certain;

double steps_of(std::int64_t steps, double unit = epsilon) {
    return static_cast<double>(steps) * unit;
}

/// A ball of radius 2, and one that is a little smaller than what touches it from inside: p is
/// twice the difference, and the distance and the difference of the radii are 1.
TEST(BallBounds, OfPowers) {
    expect_first_certain("in space", 6 * 4 / 2, 9 * 4 / 2, [](std::int64_t steps) {
        return filter::hides<3>(Site3{0, 0, 0, 2}, Site3{0, 0, 1, 1 + steps_of(steps)})
            .is_certain();
    });
    expect_first_certain("in the plane", 5 * 4 / 2, 8 * 4 / 2, [](std::int64_t steps) {
        return filter::hides<2>(Site{0, 0, 2}, Site{0, 1, 1 + steps_of(steps)}).is_certain();
    });
}

/// Corners of a square, of which the last is a ball of radius 2^-26 k: 4Γ is -8 times its square,
/// and g is 36.
TEST(BallBounds, OfGamma) {
    const double size = std::sqrt(36.0 * 36.0 / 8);
    expect_first_certain(
        "four_gamma", std::sqrt(32) * size * 16, std::sqrt(36) * size * 16, [](std::int64_t steps) {
            return filter::exists<3>(Site3{0, 0, 0, 0}, Site3{1, 0, 0, 0}, Site3{1, 1, 0, 0},
                                     Site3{0, 1, 0, steps_of(steps, 0x1p-30)})
                .is_certain();
        });
}

/// A point and balls on the axes, as far as the root of the sum of the squares of their radii: Q =
/// 0, but for the last, whose radius is less: -324 times that. The product of the sizes is 100.
TEST(BallBounds, OfQ) {
    const double size = 100.0 * 100.0 / 324;
    expect_first_certain("q", 20 * size, 24 * size, [](std::int64_t steps) {
        return filter::exists<3>(Site3{0, 0, 0, 0}, Site3{3, 0, 0, 1}, Site3{0, 3, 0, 2},
                                 Site3{0, 0, 3, 2 - steps_of(steps)})
            .is_certain();
    });
}

/// What in_sphere judges, and the least that its errors may come to, from the same polynomials in
/// long doubles: an error is at most, times e, 2m k_A + (k_L t s + |L| k_Γ g² / s), and the
/// roundings of the root, of the product and of the difference make each k greater by two.
struct Judged {
    long double difference;
    long double least;
    long double q;

    Judged(const std::array<Site3, 4>& four, const Site3& query) {
        using Number = long double;
        const auto ball = [](const Site3& s) { return Ball<3, Number>{s.x, s.y, s.z, s.r}; };
        const std::array balls{ball(four[0]), ball(four[1]), ball(four[2]), ball(four[3])};
        const Tuple<3, Number> t(balls);
        const auto between = rows_between<3, Number>(balls);
        const Row<3, Number> to_query = row<3, Number>(ball(query), balls[0]);
        const WithQuery<3, Number> with_q(t.e, to_query);
        const auto size_of = [](const Row<3, Number>& r) {
            return std::fabs(r[0]) + std::fabs(r[1]) + std::fabs(r[2]) + std::fabs(r[3]);
        };
        const Number first = size_of(t.rows[0]);
        const Number second = size_of(t.rows[1]);
        const Number third = size_of(t.rows[2]);
        const Number of_query = size_of(to_query);
        const Number n = first * second * third;
        const Number root_of_g = first * size_of(between[2]) + second * size_of(between[1]) +
                                 third * size_of(between[0]);
        const Number g = root_of_g * root_of_g;
        const Number root = std::sqrt(four_gamma<3, Number>(t.rows, between));
        const Number l = balls::l<3, Number>(with_q);
        difference = -2 * minus_a<Number, 3, Number>(t, with_q) - l * root;
        const Number m = n * n * of_query * (first + second + third + of_query);
        least =
            epsilon * (2 * 32 * m + 15 * n * of_query * root + std::fabs(l) * 34 * g * g / root);
        q = t.q();
    }
};

/// Moves a query along a line over its sphere, from outside inwards and back, and looks where the
/// filter begins to be certain.
void expect_judged(const std::array<Site3, 4>& four, const Site3& from, const Point3& along) {
    const auto query = [&](double t) {
        return Site3{from.x + t * along.x, from.y + t * along.y, from.z + t * along.z, from.r};
    };
    double low = 0.0;
    double high = 1.0;
    const bool rises = Judged(four, query(high)).difference > 0;
    ASSERT_NE(rises, Judged(four, query(low)).difference > 0);
    for (int halvings = 0; halvings < 60; ++halvings) {
        const double middle = 0.5 * (low + high);
        ((Judged(four, query(middle)).difference > 0) == rises ? high : low) = middle;
    }
    for (const int side : {-1, 1}) {
        const auto moved = [&](std::int64_t steps) {
            return query(high + side * steps_of(steps, 0x1p-49));
        };
        const auto first = first_certain(1 << 24, [&](std::int64_t steps) {
            return filter::in_sphere<3>(moved(steps), four[0], four[1], four[2], four[3])
                .is_certain();
        });
        const Judged judged(four, moved(first));
        EXPECT_GT(std::fabs(judged.difference), 0.99L * judged.least);
        EXPECT_LT(std::fabs(judged.difference), 1.2L * judged.least);
    }
}

TEST(BallBounds, OfInSphere) {
    expect_judged({{{0, 0, 0, 0}, {1, 0, 0, 0.25}, {0, 1, 0, 0}, {0, 0, 1, 0.125}}},
                  {0.5, 0.5, 0.5, 0.0625}, {1, 1, 1});
}

/// Points, so that L is 0, two of them near together: the root of Γ is as large beside A as it may
/// be.
TEST(BallBounds, OfInSphereOfANearPair) {
    expect_judged({{{0, 0, 0, 0}, {0x1p-10, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
                  {0x1p-11, -0x1p-20, 0, 0}, {0, 0x1p-20, 0});
}

/// The query's size is far above the others'.
TEST(BallBounds, OfInSphereOfALargeQuery) {
    expect_judged({{{0, 0, 0, 0}, {1, 0, 0, 0.25}, {0, 1, 0, 0}, {0, 0, 1, 0.125}}},
                  {16, 0.5, 0.25, 16}, {2, 0, 0});
}

}  // namespace
}  // namespace signum::euclidean::balls
