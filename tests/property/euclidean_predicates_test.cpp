// The predicates of the Euclidean metric: the tessellation that they choose by brute force against
// the oracle's, every stage against rationals, all floating-point environments, and the order of
// intervals on a bisector against the vertices themselves.

#include "../../predicates/euclidean.hpp"

#include <boost/multiprecision/gmp.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "../oracle/euclidean.hpp"
#include "../thoroughness.hpp"
#include "../unit/exact_reference.hpp"
#include "additive_brute_force.hpp"
#include "degenerate_sites.hpp"

namespace {

using signum::Arithmetic;
using signum::Decision;
using signum::Index;
using signum::Site;
using signum::Stage;
using signum::brute_force::Degenerate;
using signum::brute_force::expect_oracle;
using signum::brute_force::ranks_of;
using signum::brute_force::Sites;
using signum::euclidean::Perturbed;
using signum::oracle::ShrunkenDiscs;
using signum::oracle::Spacing;
using signum::reference::Random;
using Exact = Perturbed<Arithmetic::exact>;
using Multiprecision = Perturbed<Arithmetic::multiprecision>;
using Judging = Perturbed<signum::Arithmetic::judging>;

/// Of the trials one in so many: rationals take long there.
const int share = signum::is_fast ? 1 : 10;

std::string text(const Site* first, std::size_t count) {
    std::string result;
    for (const Site* s = first; s != first + count; ++s)
        result += "{" + testing::PrintToString(s->x) + ", " + testing::PrintToString(s->y) + ", " +
                  testing::PrintToString(s->r) + "} ";
    return result;
}

TEST(EuclideanPredicates, ChooseTheTessellationOfTheOracle) {
    Degenerate degenerate(7);
    Random& random = degenerate.random();
    for (int trial = 0; trial < 3000 / share; ++trial) {
        Sites sites(static_cast<std::size_t>(random.between(2, trial % 10 == 0 ? 7 : 5)));
        degenerate.fill(trial % Degenerate::families, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(expect_oracle<Exact>(sites, signum::oracle::euclidean(sites)));
    }
    std::uniform_real_distribution<double> place(0, 10);
    for (int trial = 0; trial < 300 / share; ++trial) {
        Sites sites(static_cast<std::size_t>(random.between(2, 7)));
        for (Site& site : sites)
            site = {place(random.engine()), place(random.engine()), place(random.engine()) / 5};
        ASSERT_NO_FATAL_FAILURE(expect_oracle<Exact>(sites, signum::oracle::euclidean(sites)));
    }
}

/// Each question by itself, also about sites that others would hide.
TEST(EuclideanPredicates, AnswerWhatIsTrueOfShrunkenDiscs) {
    Degenerate degenerate(13);
    int twice = 0;
    int twice_tied = 0;
    int vertices_tied = 0;
    int hiding = 0;
    for (int trial = 0; trial < 5'000 / share; ++trial) {
        Site s[4];
        degenerate.fill(trial % Degenerate::families, s, 4);
        const auto r = ranks_of(s);
        const ShrunkenDiscs discs(Sites{s, s + 4}, Spacing::powers);
        const auto sign = [](bool answer) { return answer ? 1 : -1; };
        bool apart[4][4] = {};
        for (const Index a : {0, 1, 2, 3})
            for (const Index b : {0, 1, 2, 3}) {
                if (a == b) continue;
                const std::array<Index, 2> ranks = {r[static_cast<std::size_t>(a)],
                                                    r[static_cast<std::size_t>(b)]};
                ASSERT_EQ(Exact::hides(s[a], s[b], ranks).sign, sign(discs.hides(a, b)))
                    << text(s, 4) << a << b;
                apart[a][b] = !discs.hides(a, b) && !discs.hides(b, a);
                if (a == 3) continue;
                ASSERT_EQ(Exact::nearer({s[3].x, s[3].y}, s[a], s[b], ranks).sign,
                          sign(discs.nearer(a, b, 3)))
                    << text(s, 4) << a << b;
            }
        const std::array<Index, 3> first = {r[0], r[1], r[2]};
        if (apart[0][1]) {
            ASSERT_EQ(Exact::in_circle_infinite(s[0], s[1], s[2], first).sign,
                      sign(discs.crosses(0, 1, 2)))
                << text(s, 3);
        }
        const bool three = apart[0][1] && apart[1][2] && apart[2][0];
        const bool exists = three && discs.exists(0, 1, 2);
        ASSERT_EQ(Exact::exists(s[0], s[1], s[2], first).sign, sign(exists)) << text(s, 3);
        const bool both = exists && discs.exists(1, 0, 2);
        const Decision given = Exact::exists_twice(s[0], s[1], s[2], first);
        ASSERT_EQ(given.sign, sign(both)) << text(s, 3);
        twice += static_cast<int>(both);
        twice_tied += static_cast<int>(both && given.tied);
        if (!exists) continue;
        const Decision conflict = Exact::in_circle(s[0], s[1], s[2], s[3], r);
        ASSERT_EQ(conflict.sign, sign(discs.conflicts(0, 1, 2, 3))) << text(s, 4);
        vertices_tied += static_cast<int>(conflict.tied);
        for (const Index m : {0, 1, 2})
            hiding += static_cast<int>(conflict.tied && discs.hides(3, m));
    }
    EXPECT_GT(twice, 100 / share);
    EXPECT_GT(twice_tied, 10 / share);
    EXPECT_GT(vertices_tied, 150 / share);
    EXPECT_GT(hiding, 10 / share);
}

/// All answers about four sites; 0 where a precondition of the tie rule fails.
template <class Predicates>
std::array<int, 10> answers(const Site (&s)[4], const std::array<Index, 4>& r) {
    const std::array<Index, 3> first = {r[0], r[1], r[2]};
    const int hides = Predicates::hides(s[0], s[1], {r[0], r[1]}).sign;
    const int exists = Predicates::exists(s[0], s[1], s[2], first).sign;
    const bool apart = hides < 0 && Predicates::hides(s[1], s[0], {r[1], r[0]}).sign < 0;
    return {hides,
            exists,
            Predicates::exists_twice(s[0], s[1], s[2], first).sign,
            Predicates::precedes_on_bisector(s[0], s[1], s[2], s[3], r).sign,
            exists > 0 ? Predicates::in_circle(s[0], s[1], s[2], s[3], r).sign : 0,
            apart ? Predicates::in_circle_infinite(s[0], s[1], s[2], first).sign : 0,
            Predicates::nearer({s[0].x, s[0].y}, s[1], s[2], {r[1], r[2]}).sign,
            Predicates::nearer({s[0].x, s[0].r}, s[2], s[3], {r[2], r[3]}).sign,
            Predicates::in_order_at_infinity(s[0], s[1], s[2], s[3], false, r).sign,
            Predicates::in_order_at_infinity(s[0], s[1], s[2], s[3], true, r).sign};
}

/// Sites that hurt: any doubles, a few again and again, and degenerate ones that are scaled,
/// moved, and off by a rounding.
void hurt(Degenerate& degenerate, int trial, Site (&s)[4]) {
    Random& random = degenerate.random();
    if (trial % 4 == 0) {
        const double some[4] = {random.finite(), random.finite(), random.finite(), 0.0};
        const int binades = random.coin() ? 500 : 40;
        for (Site& site : s)
            for (double* value : {&site.x, &site.y, &site.r})
                *value = trial % 12 == 0   ? random.finite()
                         : trial % 12 == 4 ? some[random.between(0, 3)]
                                           : random.in_binades(-binades, binades);
        return;
    }
    if (trial % 4 == 1) {
        // A circle or a line that touches all four, but for the roundings.
        std::uniform_real_distribution<double> any(0, 1);
        const auto next = [&] { return any(random.engine()); };
        const double rho = next();
        const double direction = next();
        const bool line = random.coin();
        // Close to one another they nearly touch from inside.
        const double range = std::pow(10, -random.below(6));
        for (Site& site : s) {
            const double angle = 2 * std::numbers::pi * (direction + (line ? 0 : range * next()));
            const double r = next() * 0.3 * random.between(-1, 3);
            const double reach = line ? r : rho + r;
            const double far = line ? 10 * next() : 0.0;
            site = {reach * std::cos(angle) + far * std::sin(angle),
                    reach * std::sin(angle) - far * std::cos(angle), r};
        }
    } else {
        degenerate.fill(random.below(Degenerate::families), s, 4);
    }
    const int kind = random.below(8);
    const double scale = kind == 0   ? 0x1p-1060
                         : kind == 1 ? 0x1p990
                         : kind == 2 ? std::ldexp(1.0, -random.between(100, 560))
                         : kind == 3 ? std::ldexp(1.0, random.between(100, 350))
                                     : 1.0 + 0x1p-30 * random.below(9);
    const double away = random.below(4) == 0 ? scale * random.in_binades(0, 30) : 0.0;
    for (Site& site : s) {
        for (double* value : {&site.x, &site.y, &site.r}) {
            *value = *value * scale + away;
            if (random.below(8) == 0)
                *value = std::nextafter(*value, random.coin() ? 0x1p1023 : -0x1p1023);
        }
    }
}

TEST(EuclideanPredicates, AgreeWithRationalsForEveryDoubleInEveryEnvironment) {
    Degenerate degenerate(11);
    int vertices = 0;
    int twice = 0;
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        Site s[4];
        hurt(degenerate, trial, s);
        const std::array<Index, 4> r = ranks_of(s);
        const auto expected = answers<Multiprecision>(s, r);
        const auto given = signum::reference::in_environment(
            trial % signum::reference::Hostile::modes, [&] { return answers<Exact>(s, r); });
        ASSERT_EQ(given, expected) << trial << ": " << text(s, 4);
        // In the default one, too, where the filters decide.
        ASSERT_EQ(answers<Exact>(s, r), expected) << trial << ": " << text(s, 4);
        const auto judged = signum::reference::in_environment(
            trial % signum::reference::Hostile::modes, [&] { return answers<Judging>(s, r); });
        ASSERT_EQ(judged, expected) << trial << ": " << text(s, 4);
        ASSERT_EQ(answers<Judging>(s, r), expected) << trial << ": " << text(s, 4);
        vertices += static_cast<int>(expected[4] != 0);
        twice += static_cast<int>(expected[2] > 0);
        // Sums are slow: one in eight.
        if (trial % 8 != 0) continue;
        const auto in_hostile = [&](auto question) {
            return signum::reference::in_environment(trial / 8 % signum::reference::Hostile::modes,
                                                     question);
        };
        ASSERT_EQ(in_hostile([&] { return answers<Perturbed<Arithmetic::sum>>(s, r); }), expected)
            << trial << ": " << text(s, 4);
        ASSERT_EQ(in_hostile([&] { return answers<Perturbed<Arithmetic::interval>>(s, r); }),
                  expected)
            << trial << ": " << text(s, 4);
    }
    EXPECT_GT(vertices, 5000 / share);
    EXPECT_GT(twice, 500 / share);
}

TEST(EuclideanPredicates, NaiveOnesAlwaysReturn) {
    Degenerate degenerate(12);
    for (int trial = 0; trial < 20'000 / share; ++trial) {
        Site s[4];
        hurt(degenerate, trial, s);
        for (const int sign : answers<Perturbed<Arithmetic::naive>>(s, ranks_of(s)))
            ASSERT_LE(std::abs(sign), 1);
    }
    // Integers are not rounded: nothing is wrong, ties included.
    for (int trial = 0; trial < 20'000 / share; ++trial) {
        Site s[4];
        degenerate.fill(trial % Degenerate::families, s, 4);
        const auto r = ranks_of(s);
        ASSERT_EQ(answers<Perturbed<Arithmetic::naive>>(s, r), answers<Multiprecision>(s, r))
            << text(s, 4);
    }
}

TEST(EuclideanPredicates, SayWhichStageAnsweredAndWhetherATieWasMet) {
    const auto ask = [](const Site& q) {
        return Exact::in_circle({0, -5, 1}, {6, 0, 2}, {-3, 4, 1}, q, {1, 0, 3, 2});
    };
    EXPECT_EQ(ask({-7, 0, 1}).stage, Stage::filter);
    EXPECT_FALSE(ask({-7, 0, 1}).tied);
    EXPECT_EQ(ask({-5, 0, 1}).stage, Stage::exact);
    EXPECT_TRUE(ask({-5, 0, 1}).tied);
    // More bits than fit into the processor's integers, more than fit into those of fixed size.
    for (const double bits : {0x1p-50, 0x1p-100, 0x1p-300, 0x1p-1000}) {
        const Decision below = ask({-5 - bits, 0x1p-1 * bits, 1 - bits});
        const Decision off = ask({-5, bits, 1});
        EXPECT_EQ(off.stage, bits < 0x1p-400 ? Stage::multiprecision : Stage::exact);
        EXPECT_EQ(off.sign, -1);
        EXPECT_FALSE(off.tied);
        EXPECT_LT(below.sign, 0);
    }
    EXPECT_EQ(Multiprecision::in_circle({0, -5, 1}, {6, 0, 2}, {-3, 4, 1}, {-7, 0, 1}, {1, 0, 3, 2})
                  .stage,
              Stage::multiprecision);
    // ESSA as far as doubles hold all terms: numbers of 240 bits; then integers, then rationals.
    const auto sum = [](double bits) {
        return Perturbed<Arithmetic::sum>::in_circle({0, -5, 1}, {6, 0, 2}, {-3, 4, 1},
                                                     {-5, bits, 1}, {1, 0, 3, 2});
    };
    for (const double bits : {0.0, 0x1p-50, 0x1p-237}) EXPECT_EQ(sum(bits).stage, Stage::essa);
    for (const double bits : {0x1p-238, 0x1p-397}) EXPECT_EQ(sum(bits).stage, Stage::exact);
    EXPECT_EQ(sum(0x1p-398).stage, Stage::multiprecision);
    EXPECT_TRUE(sum(0.0).tied);
    for (const double bits : {0x1p-50, 0x1p-237, 0x1p-238, 0x1p-398}) {
        EXPECT_EQ(sum(bits).sign, -1);
        EXPECT_FALSE(sum(bits).tied);
    }

    const Site equal{3, 4, 5};
    EXPECT_TRUE(Exact::hides(equal, equal, {0, 1}).tied);
    EXPECT_EQ(Exact::hides(equal, equal, {0, 1}).sign, 1);
    EXPECT_EQ(Exact::hides(equal, equal, {1, 0}).sign, -1);
    EXPECT_TRUE(Exact::hides(equal, {3, 5, 4}, {0, 1}).tied);
    EXPECT_EQ(Exact::nearer({0, 0}, {5, 0, 1}, {3, 4, 1}, {1, 0}).sign, -1);
    EXPECT_TRUE(Exact::nearer({0, 0}, {5, 0, 1}, {3, 4, 1}, {1, 0}).tied);
    EXPECT_EQ(Exact::nearer({0, 0}, {5, 0, 2}, {3, 4, 1}, {1, 0}).stage, Stage::filter);
    // A common tangent line: the last one between the others makes a circle of it.
    EXPECT_EQ(Exact::exists({0, 2, 2}, {5, 1, 1}, {10, 2, 2}, {0, 2, 1}).sign, 1);
    EXPECT_TRUE(Exact::exists({0, 2, 2}, {5, 1, 1}, {10, 2, 2}, {0, 2, 1}).tied);
    EXPECT_TRUE(Exact::exists_twice({0, 2, 2}, {5, 1, 1}, {10, 2, 2}, {0, 2, 1}).tied);
    EXPECT_EQ(Exact::exists_twice({0, 2, 2}, {50, 2, 2}, {20, 30, 2}, {0, 2, 1}).stage,
              Stage::filter);
}

TEST(EuclideanPredicates, WithoutTheTieRuleATouchIsZero) {
    const auto finite = [](double x) {
        return signum::euclidean::in_circle_decision({0, -5, 1}, {6, 0, 2}, {-3, 4, 1}, {x, 0, 1},
                                                     {1, 0, 3, 2})
            .sign;
    };
    EXPECT_EQ(finite(-5), 0);
    EXPECT_EQ(finite(std::nextafter(-5, -6)), -1);
    EXPECT_EQ(finite(std::nextafter(-5, -4)), 1);
    const auto infinite = [](double y) {
        return signum::euclidean::in_circle_infinite_decision({0, 2, 2}, {9, 1, 1}, {4, y, 1}).sign;
    };
    EXPECT_EQ(infinite(1), 0);
    EXPECT_EQ(infinite(std::nextafter(1, 0)), 1);
    EXPECT_EQ(infinite(std::nextafter(1, 2)), -1);
    // A vertex that the tie rule alone makes.
    const auto at_infinity = [](double y) {
        return signum::euclidean::in_circle_decision({0, 2, 2}, {10, 2, 2}, {5, 1, 1}, {4, y, 2},
                                                     {0, 2, 3, 1})
            .sign;
    };
    EXPECT_EQ(at_infinity(2), 0);
    EXPECT_EQ(at_infinity(std::nextafter(2, 0)), 1);
    EXPECT_EQ(at_infinity(std::nextafter(2, 3)), -1);
}

// ---- the order on a bisector -------------------------------------------------------------------

using Float = boost::multiprecision::number<boost::multiprecision::gmp_float<1500>,
                                            boost::multiprecision::et_off>;

/// A disc of integers, its radius made smaller as the oracle does: the last of n sites in the order
/// loses e = 2^-500, the one before it e², and so on.
struct Disc {
    Float x, y, r;
};
template <std::size_t n>
std::array<Disc, n> shrunken(const Site (&s)[n]) {
    const std::vector<Index> ranks = ranks_of(Sites{s, s + n});
    std::array<Disc, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {s[m].x, s[m].y,
                     Float(s[m].r) - ldexp(Float(1), -500 * (static_cast<int>(n) - ranks[m]))};
    return result;
}

/// The centre of a circle that touches i, j, k counterclockwise: of the two intersections of a line
/// and a cone, the one that does.
std::optional<std::array<Float, 2>> vertex(const Disc& i, const Disc& j, const Disc& k) {
    using Vector = std::array<Float, 3>;
    const auto product = [](const Vector& a, const Vector& b) -> Float {
        return a[0] * b[0] + a[1] * b[1] - a[2] * b[2];
    };
    const auto cross = [](const Vector& a, const Vector& b) {
        return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
    };
    const Vector u{j.x - i.x, j.y - i.y, j.r - i.r};
    const Vector v{k.x - i.x, k.y - i.y, k.r - i.r};
    const Vector along = cross(u, v);
    const Vector to_u = cross(v, along);
    const Vector to_v = cross(along, u);
    const Float square = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
    if (square == 0) return {};
    Vector foot;
    for (std::size_t m = 0; m < 3; ++m)
        foot[m] = (product(u, u) * to_u[m] + product(v, v) * to_v[m]) / (2 * square);
    const Float a = product(along, along);
    const Float b = product(foot, along);
    const Float discriminant = b * b - a * product(foot, foot);
    if (discriminant < 0 || a == 0) return {};
    for (const int sign : {1, -1}) {
        const Float t = (sign * sqrt(discriminant) - b) / a;
        const Float x = foot[0] + t * along[0];
        const Float y = foot[1] + t * along[1];
        const Float reach = foot[2] + t * along[2];
        if (reach <= 0 || reach + u[2] <= 0 || reach + v[2] <= 0) continue;
        // The touching points lie in the directions (c_m - X) / (distance).
        const std::array<Float, 2> p = {-x / reach, -y / reach};
        const std::array<Float, 2> q = {(u[0] - x) / (reach + u[2]), (u[1] - y) / (reach + u[2])};
        const std::array<Float, 2> s = {(v[0] - x) / (reach + v[2]), (v[1] - y) / (reach + v[2])};
        if ((q[0] - p[0]) * (s[1] - p[1]) - (q[1] - p[1]) * (s[0] - p[0]) > 0)
            return std::array<Float, 2>{x + i.x, y + i.y};
    }
    return {};
}

/// Where a point of the bisector of i and j lies on it, walked with i on the left.
Float coordinate(const Disc& i, const Disc& j, const std::array<Float, 2>& point) {
    return (j.x - i.x) * (point[1] - i.y) - (j.y - i.y) * (point[0] - i.x);
}

/// The ends of the part of the bisector that is nearer to m, where there are two; through infinity
/// where the first is the greater one.
std::optional<std::array<Float, 2>> part(const Disc& i, const Disc& j, const Disc& m) {
    const auto begin = vertex(i, j, m);
    const auto end = vertex(j, i, m);
    if (!begin || !end) return {};
    return std::array<Float, 2>{coordinate(i, j, *begin), coordinate(i, j, *end)};
}

/// A point of the bisector of i and j by its coordinate t: relative to c_i it is
/// t n + h u / |u|² for u = c_j - c_i and its normal n, and |X|·2s = p - 2 X·u.
std::array<Float, 2> point_at(const Disc& i, const Disc& j, const Float& t) {
    const Float ux = j.x - i.x;
    const Float uy = j.y - i.y;
    const Float s = j.r - i.r;
    const Float square = ux * ux + uy * uy;
    const Float p = square - s * s;
    // With h = X·u: 4 s² (h² + t²) = |u|² (p - 2h)², of whose solutions one has (p - 2h) s > 0.
    const Float a = 4 * (square - s * s);
    const Float b = 2 * p * square;
    const Float c = square * p * p - 4 * s * s * t * t;
    const Float root = sqrt(Float(b * b - a * c));
    Float h = (b - root) / a;
    if ((p - 2 * h) * s < 0) h = (b + root) / a;
    return {i.x + (h * ux - t * uy) / square, i.y + (h * uy + t * ux) / square};
}

bool is_nearer(const std::array<Float, 2>& point, const Disc& a, const Disc& b) {
    const auto distance = [&](const Disc& d) -> Float {
        const Float x = point[0] - d.x;
        const Float y = point[1] - d.y;
        return sqrt(Float(x * x + y * y)) - d.r;
    };
    return distance(a) < distance(b);
}

/// Two sites, and others that have a little of their bisector, a lot of it, or nearly reach
/// infinity on it.
void fill_bisector(Degenerate& degenerate, int trial, Site (&s)[4]) {
    Random& random = degenerate.random();
    if (trial % 4 == 0) {
        degenerate.fill(trial / 4 % Degenerate::families, s, 4);
        return;
    }
    const auto number = [&](int from, int to) {
        return static_cast<double>(random.between(from, to));
    };
    s[0] = {0, 0, 5};
    s[1] = {40, number(-1, 1) * number(0, 6), 5};
    // Lines touch both discs at y = ±5.
    if (random.coin())
        s[1] = {40, 0, 5};
    else if (random.coin())
        s[1] = {40, s[1].y, 5 - s[1].y};
    for (Site& m : {std::ref(s[2]), std::ref(s[3])}) {
        if (random.coin()) {  // touches such a line, or nearly so
            const double a = number(-4, 20);
            m = {number(-5, 45), 5 + a, -a + number(-1, 1) * number(0, 1)};
            if (random.coin()) m.y = -m.y;
        } else if (random.coin()) {  // reaches a point of the plane near the bisector, and not far
            m = {number(15, 25), number(-60, 60), 0};
            m.r = 5 - std::floor(std::hypot(m.x, m.y)) + number(1, 6);
        } else {  // covers all but a part
            m = {number(-60, 60), number(-60, 60), 0};
            m.r = 5 + std::floor(std::hypot(m.x, m.y) * number(5, 9) / 10);
        }
    }
}

TEST(EuclideanPredicates, OrderIntervalsOnABisectorAsTheirEnds) {
    Degenerate degenerate(17);
    Random& random = degenerate.random();
    std::array<int, 2> rests{};
    std::array<int, 3> ties{};
    std::array<int, 2> answers{};
    for (int trial = 0; trial < 20'000 / share; ++trial) {
        Site s[4];  // i, j, q, k
        fill_bisector(degenerate, trial, s);
        if (random.coin()) std::swap(s[0], s[1]);
        const auto r = ranks_of(s);
        const Decision of_q = Exact::exists_twice(s[0], s[1], s[2], {r[0], r[1], r[2]});
        const Decision of_k = Exact::exists_twice(s[0], s[1], s[3], {r[0], r[1], r[3]});
        if (of_q.sign < 0 || of_k.sign < 0) continue;
        const auto d = shrunken(s);
        auto q = part(d[0], d[1], d[2]);
        const auto k = part(d[0], d[1], d[3]);
        ASSERT_TRUE(q && k) << text(s, 4);
        // From the begin to the end, perhaps through infinity, m is nearer.
        for (const auto& [m, ends] : {std::pair(d[2], *q), std::pair(d[3], *k)}) {
            const bool bounded = ends[0] < ends[1];
            ASSERT_EQ(is_nearer(point_at(d[0], d[1], (ends[0] + ends[1]) / 2), m, d[0]), bounded)
                << text(s, 4);
            const Float beyond = 2 * abs(ends[0]) + 2 * abs(ends[1]) + 1;
            ASSERT_EQ(is_nearer(point_at(d[0], d[1], beyond), m, d[0]), !bounded) << text(s, 4);
        }
        if ((*k)[0] > (*k)[1]) continue;
        const bool rest = (*q)[0] > (*q)[1];
        if (rest) std::swap((*q)[0], (*q)[1]);
        const bool before = (*q)[1] <= (*k)[0];
        if (!before && (*k)[1] > (*q)[0]) continue;
        const Decision given = Exact::precedes_on_bisector(s[0], s[1], s[2], s[3], r);
        ASSERT_EQ(given.sign, before ? 1 : -1) << text(s, 4);
        ++rests[rest ? 1 : 0];
        ++ties[(of_q.tied ? 1U : 0U) + (of_k.tied ? 1U : 0U)];
        ++answers[before ? 1 : 0];
        ASSERT_EQ(given.tied, of_q.tied || of_k.tied);
    }
    for (const int count : rests) EXPECT_GT(count, 50 / share);
    for (const int count : ties) EXPECT_GT(count, 10 / share);
    for (const int count : answers) EXPECT_GT(count, 50 / share);
}

TEST(EuclideanPredicates, OrderArcsAtInfinityAsTheirMiddles) {
    Degenerate degenerate(19);
    Random& random = degenerate.random();
    constexpr double turn = 2 * std::numbers::pi;
    std::array<int, 2> rests{};
    std::array<int, 2> answers{};
    int opposite = 0;
    struct Arc {
        double middle, half;
    };
    for (int trial = 0; trial < 100'000 / share; ++trial) {
        Site s[4];
        if (trial % 4 == 0) {
            degenerate.fill(trial % Degenerate::families, s, 4);
        } else {
            // Narrow arcs, and wide ones: the cosine of half an arc is (r_s - r_m) / (5 d).
            s[0] = {0, 0, 0};
            for (std::size_t m = 1; m < 4; ++m) {
                const auto [x, y] = degenerate.of_length_5();
                const int d = random.between(1, 3);
                const int reach = 5 * d - random.between(1, 4);
                s[m] = {static_cast<double>(x * d), static_cast<double>(y * d),
                        static_cast<double>(m == 2 && random.coin() ? reach : -reach)};
            }
        }
        const auto r = ranks_of(s);
        bool apart = true;
        for (std::size_t m = 1; m < 4; ++m)
            apart = apart && Exact::hides(s[0], s[m], {r[0], r[m]}).sign < 0 &&
                    Exact::hides(s[m], s[0], {r[m], r[0]}).sign < 0;
        if (!apart) continue;
        const auto arc = [&](const Site& m) -> Arc {
            const double x = m.x - s[0].x;
            const double y = m.y - s[0].y;
            return {std::atan2(y, x), std::acos((s[0].r - m.r) / std::hypot(x, y))};
        };
        for (const bool rest : {false, true}) {
            Arc arcs[3] = {arc(s[1]), arc(s[2]), arc(s[3])};
            if (rest) arcs[1] = {arcs[1].middle + turn / 2, turn / 2 - arcs[1].half};
            const auto ahead = [&](const Arc& a, const Arc& b) {
                return std::fmod(b.middle - a.middle + 2 * turn, turn);
            };
            bool disjoint = true;
            for (std::size_t m = 0; m < 3; ++m) {
                const Arc& a = arcs[m];
                const Arc& b = arcs[(m + 1) % 3];
                const double gap = std::min(ahead(a, b), ahead(b, a));
                disjoint = disjoint && gap >= a.half + b.half - 1e-9;
            }
            if (!disjoint) continue;
            const bool ordered = ahead(arcs[0], arcs[1]) < ahead(arcs[0], arcs[2]);
            for (const Decision& given :
                 {Exact::in_order_at_infinity(s[0], s[1], s[2], s[3], rest, r),
                  Multiprecision::in_order_at_infinity(s[0], s[1], s[2], s[3], rest, r)})
                ASSERT_EQ(given.sign, ordered ? 1 : -1) << text(s, 4) << rest;
            ++rests[rest ? 1 : 0];
            ++answers[ordered ? 1 : 0];
            for (std::size_t m = 0; m < 3; ++m)
                opposite += std::abs(ahead(arcs[m], arcs[(m + 1) % 3]) - turn / 2) < 1e-9;
        }
    }
    for (const int count : rests) EXPECT_GT(count, 100 / share);
    for (const int count : answers) EXPECT_GT(count, 100 / share);
    EXPECT_GT(opposite, 100 / share);
}

}  // namespace
