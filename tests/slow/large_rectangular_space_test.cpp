// Ten million questions a metric whether a site conflicts with a cube (octahedron) that touches
// four others: raw bit patterns and ties moved by a few units in the last place. The sphere is
// solved for in rationals, and touches its sites there; many queries are compared with it, each of
// which is asked about in several orders of the four.

#include <gtest/gtest.h>

#include "../property/rectangular_families.hpp"

namespace signum {
namespace {

/// Forty sites or so, of which the first four are the spheres'.
template <class Space, class Draw>
void judge_until(long questions, const Draw& draw) {
    Random random(2029);
    std::array<long, 3> said = {};
    for (long asked = 0; asked < questions;) {
        const std::vector<AnyBall> balls = draw(random);
        std::array<Site3, 4> four;
        oracle::BallTuple<3> tuple;
        for (std::size_t m = 0; m < 4; ++m) {
            four[m] = site_of(balls[m], Site3());
            tuple[m] = oracle::exact_ball(four[m]);
        }
        const auto found = Space::spheres(four[0], four[1], four[2], four[3]);
        for (std::uint8_t n = 0; n < found.count; ++n) {
            const auto sphere = sphere_of<Space>(found.spheres[n], tuple);
            for (const auto& site : tuple)
                ASSERT_EQ(oracle::side<3>(Space::metric, sphere, site), 0);
            for (std::size_t query = 4; query < balls.size(); ++query) {
                const Site3 q = site_of(balls[query], Site3());
                const int expected = -oracle::side<3>(Space::metric, sphere, oracle::exact_ball(q));
                for (int order = 0; order < 4; ++order) {
                    const auto& [i, j, k, l] = four;
                    ASSERT_EQ(Space::in_sphere(i, j, k, l, q, n), expected)
                        << text_of<Site3>({i, j, k, l, q});
                    std::rotate(four.begin(), four.begin() + 1 + order % 2, four.end());
                    std::swap(four[0], four[static_cast<std::size_t>(order)]);
                }
                const auto& contacts = found.spheres[n];
                const auto site = [&](std::size_t m) { return site_of(balls[m], Site3()); };
                ASSERT_EQ(
                    Space::in_sphere_decision(site(0), site(1), site(2), site(3), contacts, q).sign,
                    expected);
                asked += 5;
                said[static_cast<std::size_t>(expected + 1)] += 5;
            }
        }
    }
    for (const long times : said) EXPECT_GT(times, questions / 200);
}

template <class Space>
std::vector<AnyBall> around_one_sphere(Random& g) {
    const rectangular_families::AroundOneSphere<Space> sphere(g);
    std::vector<AnyBall> balls;
    for (int m = 0; m < 40; ++m) balls.push_back(sphere.draw(g));
    return balls;
}
template <class Change>
void change(std::vector<AnyBall>& balls, const Change& change) {
    for (AnyBall& b : balls)
        for (double* number : {&b.x[0], &b.x[1], &b.x[2], &b.r}) *number = change(*number);
}

const long million = static_cast<long>(1'000'000 * effort * effort);

template <class Space>
void test_ties() {
    judge_until<Space>(2 * million, [](Random& g) { return around_one_sphere<Space>(g); });
}
template <class Space>
void test_ties_moved_by_ulps() {
    judge_until<Space>(4 * million, [](Random& g) {
        auto balls = around_one_sphere<Space>(g);
        const bool sparse = g.coin();
        change(balls, [&](double v) { return sparse && g.coin() ? v : moved(g, v); });
        return balls;
    });
}
/// Multiples of a rounded unit: many ties, some of them missed by the roundings.
template <class Space>
void test_ties_off_the_grid() {
    judge_until<Space>(3 * million, [](Random& g) {
        auto balls = around_one_sphere<Space>(g);
        const double unit = g.below(3) == 0 ? 0.75 : 0.1;
        change(balls, [&](double v) { return v * unit; });
        return balls;
    });
}
template <class Space>
void test_raw_bits() {
    judge_until<Space>(million, [](Random& g) {
        std::vector<AnyBall> balls;
        const bool any_exponent = g.below(32) == 0;
        for (int draw = 0; draw < 5; ++draw)
            for (const AnyBall& b :
                 any_exponent ? ball_families::raw(g, 3) : ball_families::mixed(g, 3))
                balls.push_back(b);
        return balls;
    });
}

TEST(LargeCubes, Ties) {
    test_ties<SupremumSpace>();
}
TEST(LargeCubes, TiesMovedByUlps) {
    test_ties_moved_by_ulps<SupremumSpace>();
}
TEST(LargeCubes, TiesOffTheGrid) {
    test_ties_off_the_grid<SupremumSpace>();
}
TEST(LargeCubes, RawBits) {
    test_raw_bits<SupremumSpace>();
}
TEST(LargeOctahedra, Ties) {
    test_ties<ManhattanSpace>();
}
TEST(LargeOctahedra, TiesMovedByUlps) {
    test_ties_moved_by_ulps<ManhattanSpace>();
}
TEST(LargeOctahedra, TiesOffTheGrid) {
    test_ties_off_the_grid<ManhattanSpace>();
}
TEST(LargeOctahedra, RawBits) {
    test_raw_bits<ManhattanSpace>();
}

}  // namespace
}  // namespace signum
