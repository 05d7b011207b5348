// Ten million questions whether a site conflicts with the sphere of four others in the power
// metric, of points, of sites that carry a weight and of balls: raw bit patterns, exact ties, and
// ties moved by a few units in the last place. The hyperplane through the four lifted sites is
// found in integers of any size, and many queries are compared with it. It is compared with the
// oracle.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../predicates/space/in_sphere.hpp"
#include "../oracle/power_space.hpp"
#include "../property/raw_doubles.hpp"

namespace signum {
namespace {

// ---- the reference: integers -------------------------------------------------------------------

/// (x, y, z, |x|² - w), in units so small that all are integers.
using Lifted = std::array<mpz_class, 4>;

template <class S>
std::vector<Lifted> lifted(const std::vector<S>& sites) {
    int scale = -1023;
    for (const S& s : sites) {
        scale = std::max({scale, -last_bit(s.x), -last_bit(s.y), -last_bit(s.z)});
        if constexpr (requires { s.r; }) scale = std::max(scale, -last_bit(s.r));
        if constexpr (requires { s.w; }) scale = std::max(scale, -last_bit(s.w) / 2 + 1);
    }
    std::vector<Lifted> result;
    for (const S& s : sites) {
        Lifted& m = result.emplace_back();
        m = {scaled(s.x, scale), scaled(s.y, scale), scaled(s.z, scale), 0};
        m[3] = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
        if constexpr (requires { s.r; }) m[3] -= scaled(s.r, scale) * scaled(s.r, scale);
        if constexpr (requires { s.w; }) m[3] -= scaled(s.w, 2 * scale);
    }
    return result;
}

/// Through the first four.
class Hyperplane {
 public:
    explicit Hyperplane(const std::vector<Lifted>& sites) : start_(sites[0]) {
        std::array<Lifted, 3> to;
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 4; ++k) to[m][k] = sites[m + 1][k] - start_[k];
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t u = k == 0 ? 1 : 0, v = k <= 1 ? 2 : 1, w = k <= 2 ? 3 : 2;
            const auto minor = [&](std::size_t x, std::size_t y) -> mpz_class {
                return to[1][x] * to[2][y] - to[1][y] * to[2][x];
            };
            normal_[k] = to[0][u] * minor(v, w) - to[0][v] * minor(u, w) + to[0][w] * minor(u, v);
            if (k % 2 == 0) normal_[k] = -normal_[k];
        }
    }

    /// The orientation of the four centres.
    [[nodiscard]] int turn() const { return sgn(normal_[3]); }
    /// q conflicts where it lies below: +1, 0 on the hyperplane.
    [[nodiscard]] int conflict(const Lifted& q) const {
        mpz_class sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += normal_[k] * (q[k] - start_[k]);
        return -sgn(sum) * turn();
    }

 private:
    Lifted start_;
    Lifted normal_;
};

// ---- inputs ------------------------------------------------------------------------------------

/// The last is a radius or a weight, or not looked at.
struct Numbers {
    double x[3];
    double last;
};
using Draw = std::vector<Numbers> (*)(Random&);

template <class S>
inline constexpr bool is_weight = std::is_same_v<S, power::Site3>;

template <class S>
std::vector<S> sites_of(const std::vector<Numbers>& numbers) {
    std::vector<S> sites;
    for (const auto& [x, last] : numbers) {
        if constexpr (std::is_same_v<S, Point3>)
            sites.push_back({x[0], x[1], x[2]});
        else
            sites.push_back({x[0], x[1], x[2], last});
    }
    return sites;
}

constexpr int drawn = 24;
template <class One>
std::vector<Numbers> some(const One& one) {
    std::vector<Numbers> numbers;
    for (int m = 0; m < drawn; ++m) numbers.push_back(one());
    return numbers;
}
template <class Change>
void change(std::vector<Numbers>& numbers, const Change& change) {
    for (Numbers& n : numbers)
        for (double* number : {&n.x[0], &n.x[1], &n.x[2], &n.last}) *number = change(*number);
}
/// In another unit; a weight is an area.
template <class S>
void scale(std::vector<Numbers>& numbers, double unit) {
    for (Numbers& n : numbers) {
        for (double& x : n.x) x *= unit;
        n.last *= is_weight<S> ? unit * unit : unit;
    }
}

/// Integer points, all of them at one power distance from the origin; of points, on one sphere.
template <class S>
std::vector<Numbers> around_one_sphere(Random& g) {
    static constexpr int squares[] = {14, 26, 29, 41};
    const int power = std::is_same_v<S, Point3> ? g.any(squares) : g.between(-10, 40);
    std::vector<Numbers> all;
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y)
            for (int z = -5; z <= 5; ++z) {
                const int weight = x * x + y * y + z * z - power;
                const double radius = std::sqrt(std::max(weight, 0));
                const Numbers n = {{1.0 * x, 1.0 * y, 1.0 * z}, is_weight<S> ? weight : radius};
                if (std::is_same_v<S, Point3>
                        ? weight == 0
                        : is_weight<S> || (weight >= 0 && std::floor(radius) == radius))
                    all.push_back(n);
            }
    double origin[3];
    for (double& x : origin) x = g.below(3) == 0 ? g.between(-1000, 1000) * 0x1p20 : 0.0;
    const double unit = g.coin() ? 1 : g.between(1, 1 << 20);
    auto numbers =
        some([&] { return all[static_cast<std::size_t>(g.below(static_cast<int>(all.size())))]; });
    scale<S>(numbers, unit);
    for (Numbers& n : numbers)
        for (int k = 0; k < 3; ++k) n.x[k] += origin[k];
    return numbers;
}
std::vector<Numbers> lattice(Random& g) {
    const double far = 0x1p40 * g.below(2);
    const int most = g.coin() ? 2 : 1 << 18;
    const auto one = [&] { return far + g.between(0, most); };
    return some([&] { return Numbers{{one(), one(), one()}, 1.0 * g.between(-1, 1)}; });
}
/// Corners of a box whose sides are no integers, of one weight, but for a few.
std::vector<Numbers> box_corners(Random& g) {
    double corner[2][3];
    for (auto& point : corner)
        for (double& x : point) x = g.coin() ? g.between(1, 9) * 0.1 : g.real();
    const double last = g.real();
    const bool are_equal = g.coin();
    return some([&] {
        return Numbers{{corner[g.below(2)][0], corner[g.below(2)][1], corner[g.below(2)][2]},
                       are_equal || g.below(4) != 0 ? last : g.real()};
    });
}
/// Few places, and fewer weights.
std::vector<Numbers> duplicates(Random& g) {
    Numbers places[5];
    for (Numbers& n : places) n = {{g.real(), g.real(), g.real()}, g.real()};
    return some([&] {
        Numbers n = g.any(places);
        if (g.below(4) == 0) n.last = places[0].last;
        return n;
    });
}
template <class S>
std::vector<Numbers> ties(Random& g) {
    switch (g.below(6)) {
        case 0:
            return lattice(g);
        case 1:
            return box_corners(g);
        case 2:
            return duplicates(g);
        default:
            return around_one_sphere<S>(g);
    }
}
/// In units so small, or large, that double-doubles are not asked, now and then.
template <class S>
std::vector<Numbers> rescaled(Random& g, std::vector<Numbers> numbers) {
    if (g.below(4) == 0) scale<S>(numbers, std::ldexp(1.0, g.between(-400, 400)));
    return numbers;
}
template <class S>
std::vector<Numbers> ties_moved_by_ulps(Random& g) {
    auto numbers = ties<S>(g);
    const bool is_sparse = g.coin();
    change(numbers, [&](double v) { return is_sparse && g.coin() ? v : moved(g, v); });
    return rescaled<S>(g, numbers);
}
/// Multiples of a rounded unit.
template <class S>
std::vector<Numbers> ties_off_the_grid(Random& g) {
    auto numbers = ties<S>(g);
    scale<S>(numbers, g.below(3) == 0 ? 0.75 : g.coin() ? 0.1 : g.real());
    return rescaled<S>(g, numbers);
}
double raw(Random& g) {
    const auto bits = [&] { return static_cast<std::uint64_t>(g.below(1 << 30)); };
    for (;;) {
        const double value = std::bit_cast<double>(bits() << 34 ^ bits() << 17 ^ bits());
        if (std::isfinite(value)) return value;
    }
}
/// Any exponent, or few of them.
std::vector<Numbers> raw_bits(Random& g) {
    if (g.below(4) == 0) return some([&] { return Numbers{{raw(g), raw(g), raw(g)}, raw(g)}; });
    const double values[] = {raw(g), raw(g), raw(g), raw(g)};
    const int kinds = g.between(1, 4);
    const auto pick = [&] {
        const double v = g.below(5) == 0 ? 0.0 : values[g.below(kinds)];
        const double times = g.below(3) == 0 ? v * g.between(1, 3) : v;
        return g.sign() * (std::isfinite(times) ? times : v);
    };
    return some([&] { return Numbers{{pick(), pick(), pick()}, pick()}; });
}

// ---- questions ---------------------------------------------------------------------------------

constexpr std::size_t even_orders[][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 0, 3, 2},
                                          {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 0, 1, 3}, {2, 1, 3, 0},
                                          {2, 3, 0, 1}, {3, 0, 2, 1}, {3, 1, 0, 2}, {3, 2, 1, 0}};

template <class S>
std::string text(const S& s) {
    double last = 0.0;
    if constexpr (requires { s.r; }) last = s.r;
    if constexpr (requires { s.w; }) last = s.w;
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a, %a} ", s.x, s.y, s.z, last);
    return buffer;
}

template <class S>
class LargePowerSpace : public testing::Test {
 protected:
    /// Each query is asked about in another order of the four that turns the same way. Every sign
    /// is said, and the stages that `answer` are asked.
    void judge_until(long questions, Draw draw, std::initializer_list<Stage> answer) {
        std::array<long, 3> said = {};
        std::array<long, stage_count> by = {};
        for (long asked = 0; asked < questions;) {
            auto sites = sites_of<S>(draw(random_));
            const std::vector<Lifted> exact = lifted(sites);
            const Hyperplane hyperplane(exact);
            if (hyperplane.turn() == 0) continue;
            if (hyperplane.turn() < 0) std::swap(sites[0], sites[1]);
            for (std::size_t query = 4; query < sites.size(); ++query, ++asked) {
                const auto& order = even_orders[asked % std::ssize(even_orders)];
                const S& i = sites[order[0]];
                const S& j = sites[order[1]];
                const S& k = sites[order[2]];
                const S& l = sites[order[3]];
                const S& q = sites[query];
                const Decision decision = power::in_sphere_decision(i, j, k, l, q);
                const int expected = hyperplane.conflict(exact[query]);
                ASSERT_EQ(decision.sign, expected) << name_of(decision.stage) << ": " << text(i)
                                                   << text(j) << text(k) << text(l) << text(q);
                ++said[static_cast<std::size_t>(expected + 1)];
                ++by[static_cast<std::size_t>(decision.stage)];
            }
        }
        for (const long times : said) EXPECT_GT(times, questions / 1000);
        for (const Stage stage : answer)
            EXPECT_GT(by[static_cast<std::size_t>(stage)], questions / 1000) << name_of(stage);
    }

    Random random_{2031};
};

using Kinds = testing::Types<Point3, power::Site3, Site3>;
TYPED_TEST_SUITE(LargePowerSpace, Kinds);

const long million = static_cast<long>(1'000'000 * effort * effort);

TYPED_TEST(LargePowerSpace, Ties) {
    const Draw draw = [](Random& g) { return rescaled<TypeParam>(g, ties<TypeParam>(g)); };
    this->judge_until(million / 2, draw, {Stage::filter, Stage::exact, Stage::multiprecision});
}
TYPED_TEST(LargePowerSpace, TiesMovedByUlps) {
    this->judge_until(3 * million / 2, ties_moved_by_ulps<TypeParam>,
                      {Stage::filter, Stage::refine, Stage::exact, Stage::multiprecision});
}
TYPED_TEST(LargePowerSpace, TiesOffTheGrid) {
    this->judge_until(million / 2, ties_off_the_grid<TypeParam>,
                      {Stage::filter, Stage::refine, Stage::exact, Stage::multiprecision});
}
TYPED_TEST(LargePowerSpace, RawBits) {
    this->judge_until(million, raw_bits, {Stage::filter, Stage::multiprecision});
}

// ---- the reference and the oracle --------------------------------------------------------------

/// Whether q conflicts with four sites: always where they are no cell of the tessellation, never
/// where they are one; where they touch it is the last in the order of ties that tells.
int conflict_by_oracle(const std::vector<power::Site3>& five) {
    std::vector<oracle::SpaceSite<3>> sites;
    for (const auto& [x, y, z, w] : five) sites.push_back({{x, y, z}, w});
    int cells = 0;
    for (std::size_t last = 0; last < 5; ++last) {
        oracle::Ranks ranks = {0, 1, 2, 3, 4};
        std::swap(ranks[last], ranks[4]);
        const auto found = oracle::power_space<3>(sites, ranks).cells;
        cells += std::count(found.begin(), found.end(), oracle::SpaceTuple<4>{0, 1, 2, 3}) > 0;
    }
    return cells == 0 ? 1 : cells == 5 ? -1 : 0;
}

TEST(LargePowerSpaceReference, IsTheOracles) {
    Random random(2032);
    std::array<int, 3> said = {};
    const Draw draws[] = {ties<power::Site3>, ties_moved_by_ulps<power::Site3>,
                          ties_off_the_grid<power::Site3>, raw_bits};
    for (int trial = 0; trial < 4000 * effort; ++trial) {
        auto sites = sites_of<power::Site3>(draws[trial % 4](random));
        sites.resize(5);
        const std::vector<Lifted> exact = lifted(sites);
        const Hyperplane hyperplane(exact);
        if (hyperplane.turn() == 0) continue;
        const int expected = conflict_by_oracle(sites);
        ASSERT_EQ(hyperplane.conflict(exact[4]), expected)
            << text(sites[0]) << text(sites[1]) << text(sites[2]) << text(sites[3])
            << text(sites[4]);
        ++said[static_cast<std::size_t>(expected + 1)];
    }
    for (const int times : said) EXPECT_GT(times, 100 * effort);
}

}  // namespace
}  // namespace signum
