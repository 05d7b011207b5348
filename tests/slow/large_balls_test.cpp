// Ten million questions whether a ball conflicts with a sphere that touches four others: raw bit
// patterns and ties moved by a few units in the last place. The oracle solves for the sphere in
// rationals, for many balls; each is asked about in every order of the four that turns the same
// way.

#include <gtest/gtest.h>

#include "../../predicates/space/euclidean.hpp"
#include "../property/ball_families.hpp"

namespace signum {
namespace {

constexpr int even_orders[][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 0, 3, 2},
                                  {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 0, 1, 3}, {2, 1, 3, 0},
                                  {2, 3, 0, 1}, {3, 0, 2, 1}, {3, 1, 0, 2}, {3, 2, 1, 0}};
constexpr long orders = std::size(even_orders);

/// Twenty balls or so, of which the first four are the sphere's.
template <class Draw>
void judge_until(long questions, const Draw& draw) {
    Random random(2027);
    for (long asked = 0; asked < questions;) {
        std::vector<AnyBall> balls = draw(random);
        AnyBalls five;
        std::copy_n(balls.begin(), 5, five.begin());
        auto sites = sites_of<Site3>(five);
        auto spheres = oracle::touching_spheres<3>(tuple_of<Site3>(sites));
        if (spheres.spheres.empty()) continue;
        if (positive(spheres) == nullptr) {
            std::swap(sites[0], sites[1]);
            spheres = oracle::touching_spheres<3>(tuple_of<Site3>(sites));
            if (positive(spheres) == nullptr) continue;
        }
        for (std::size_t query = 4; query < balls.size(); ++query) {
            const Site3 q = sites[4] = site_of(balls[query], Site3());
            const int expected = -oracle::side<3>(*positive(spheres), oracle::exact_ball(q));
            for (const auto& order : even_orders) {
                const Site3& i = sites[static_cast<std::size_t>(order[0])];
                const Site3& j = sites[static_cast<std::size_t>(order[1])];
                const Site3& k = sites[static_cast<std::size_t>(order[2])];
                const Site3& l = sites[static_cast<std::size_t>(order[3])];
                ASSERT_EQ(euclidean::in_sphere(i, j, k, l, q), expected) << text_of<Site3>(sites);
            }
            asked += orders;
        }
    }
}

std::vector<AnyBall> around_one_sphere(Random& g) {
    const ball_families::AroundOneSphere sphere(g, 3);
    std::vector<AnyBall> balls;
    for (int m = 0; m < 20; ++m) balls.push_back(sphere.draw(g));
    return balls;
}
/// From 0 the next double is 1074 bits away, and the oracle takes its time; raw bits go so far.
double moved_but_zero(Random& g, double v) {
    return v == 0.0 ? v : moved(g, v);
}
template <class Change>
void change(std::vector<AnyBall>& balls, const Change& change) {
    for (AnyBall& b : balls)
        for (double* number : {&b.x[0], &b.x[1], &b.x[2], &b.r}) *number = change(*number);
}

const long million = static_cast<long>(1'000'000 * effort * effort);

TEST(LargeBalls, TiesMovedByUlps) {
    judge_until(9 * million / 2, [](Random& g) {
        auto balls = around_one_sphere(g);
        change(balls, [&](double v) { return moved_but_zero(g, v); });
        return balls;
    });
}
TEST(LargeBalls, TiesOffTheGridMovedByUlps) {
    judge_until(9 * million / 2, [](Random& g) {
        auto balls = around_one_sphere(g);
        change(balls, [&](double v) { return moved_but_zero(g, v * 0.1); });
        return balls;
    });
}
TEST(LargeBalls, RawBits) {
    judge_until(million, [](Random& g) {
        std::vector<AnyBall> balls;
        const bool any_exponent = g.below(32) == 0;
        for (int draw = 0; draw < 5; ++draw)
            for (const AnyBall& b :
                 any_exponent ? ball_families::raw(g, 3) : ball_families::mixed(g, 3))
                balls.push_back(b);
        return balls;
    });
}

}  // namespace
}  // namespace signum
