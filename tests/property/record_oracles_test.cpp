// The fast oracles of the record (fuzz/record), in integers, against the slow ones of tests/oracle,
// in rationals: two that know nothing of one another, on small degenerate patterns.

#include <array>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../fuzz/record/euclidean_oracle.hpp"
#include "../../fuzz/record/narrow.hpp"
#include "../../fuzz/record/rectangular_space_oracle.hpp"
#include "../../fuzz/record/sites.hpp"
#include "../oracle/balls_space.hpp"
#include "../oracle/rectangular_space.hpp"
#include "../thoroughness.hpp"

namespace signum::fuzz {
namespace {

const int trials = is_fast ? 300 : 30;

template <std::size_t d>
oracle::SpaceBall<static_cast<int>(d)> rational(const Ball<d>& ball) {
    return oracle::exact_ball(site_of<std::conditional_t<d == 2, Site, Site3>>(ball));
}
template <std::size_t d>
oracle::BallTuple<static_cast<int>(d)> tuple_of(const std::array<Ball<d>, d + 2>& balls) {
    oracle::BallTuple<static_cast<int>(d)> tuple;
    for (std::size_t m = 0; m <= d; ++m) tuple[m] = rational(balls[m]);
    return tuple;
}
template <std::size_t d>
void make(hard::Moves<d>& moves, Kind kind, std::array<Ball<d>, d + 2>& balls, int trial) {
    if (trial % 3 == 0)
        moves.lattice(kind, balls);
    else if (trial % 3 == 1)
        moves.tangent(kind, balls);
    else
        moves.in_line(kind, balls);
    if (trial % 2 == 0) moves.move_by_ulps(kind, balls, 2, 1);
}

template <std::size_t d>
void expect_euclidean() {
    constexpr int dimension = static_cast<int>(d);
    hard::Moves<d> moves(31);
    int exist = 0;
    int touch = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::array<Ball<d>, d + 2> balls;
        make(moves, Kind::euclidean, balls, trial);
        const Scaled<d, d + 2> scaled(Kind::euclidean, balls);
        std::array<std::size_t, d + 1> at;
        for (std::size_t m = 0; m <= d; ++m) at[m] = m;
        const euclidean_oracle::Sphere<d> sphere(chosen<d, d + 1>(scaled, at));
        const auto all = oracle::touching_spheres<dimension>(tuple_of<d>(balls));
        // det[direction, 1] has another sign in space than the turn of the points has.
        const int positive = d == 2 ? 1 : -1;
        const oracle::TouchingSphere<dimension>* found = nullptr;
        for (const auto& each : all.spheres)
            if (each.orientation == positive) found = &each;
        ASSERT_EQ(sphere.exists(), found != nullptr) << "trial " << trial;
        if (found == nullptr) continue;
        ++exist;
        const int right = -oracle::side<dimension>(*found, rational(balls[d + 1]));
        EXPECT_EQ(sphere.conflict(scaled.balls[d + 1]), right) << "trial " << trial;
        touch += right == 0 ? 1 : 0;
    }
    EXPECT_GT(exist, trials / 8);
    EXPECT_GT(touch, trials / 30);
}
TEST(RecordOracles, OfTheEuclideanMetricAgree) {
    expect_euclidean<2>();
    expect_euclidean<3>();
}

template <bool octahedron>
void expect_rectangular() {
    constexpr Kind kind = octahedron ? Kind::manhattan : Kind::supremum;
    constexpr auto metric =
        octahedron ? oracle::RectangularMetric::manhattan : oracle::RectangularMetric::supremum;
    hard::Moves<3> moves(32);
    int finite = 0;
    int infinite = 0;
    // The slow one takes its time.
    for (int trial = 0; trial < trials / 10; ++trial) {
        std::array<Ball<3>, 5> balls;
        make(moves, kind, balls, trial);
        const Units units = units_of(balls);
        std::array<rectangular_oracle::Ball3<Integer>, 5> exact;
        for (std::size_t m = 0; m < 5; ++m) {
            for (std::size_t k = 0; k < 3; ++k)
                exact[m].c[k] = number_of<Integer>(digits_of(balls[m].centre[k]), units.lowest, 0);
            exact[m].r = number_of<Integer>(digits_of(balls[m].size), units.lowest, 0);
        }
        using Spheres = rectangular_oracle::SpaceSpheres<Integer, octahedron>;
        const Spheres fast({exact[0], exact[1], exact[2], exact[3]});
        const auto slow = oracle::touching_spheres<3>(metric, tuple_of<3>(balls));
        ASSERT_EQ(fast.infinitely_many(), slow.infinitely_many) << "trial " << trial;
        (slow.infinitely_many ? infinite : finite) += 1;
        if (slow.infinitely_many) continue;
        ASSERT_EQ(fast.spheres().size(), slow.spheres.size()) << "trial " << trial;
        // In another order: how many of each sign.
        int fast_signs[3] = {};
        int slow_signs[3] = {};
        for (const auto& sphere : fast.spheres())
            ++fast_signs[1 + Spheres::gap(sphere, exact[4]).sign()];
        for (const auto& sphere : slow.spheres)
            ++slow_signs[1 + oracle::side<3>(metric, sphere, rational(balls[4]))];
        for (int s = 0; s < 3; ++s) EXPECT_EQ(fast_signs[s], slow_signs[s]) << "trial " << trial;
    }
    if (is_fast) {
        EXPECT_GT(finite, 5);
        EXPECT_GT(infinite, 2);
    }
}
TEST(RecordOracles, OfCubesAndOctahedraAgree) {
    expect_rectangular<false>();
    expect_rectangular<true>();
}

}  // namespace
}  // namespace signum::fuzz
