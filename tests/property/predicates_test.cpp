// The predicates of the power metric against integers of any size, on inputs made to break them, in
// every rounding mode, with and without flushing of denormals. Shares no code with predicates/.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "../../predicates/power.hpp"
#include "../../triangulation/kernels/power_kernel.hpp"
#include "environments.hpp"
#include "raw_doubles.hpp"

namespace signum {
namespace {

template <class S>
using Judging = triangulation::PowerSigns<S, Arithmetic::judging>;
template <class S>
using BySums = triangulation::PowerSigns<S, Arithmetic::sum>;

// ---- the reference: integers -------------------------------------------------------------------

/// A site in units so small that all its numbers are integers.
struct Exact {
    mpz_class x;
    mpz_class y;
    mpz_class w;
};

int third_scale(const Point&) {
    return -1023;
}
int third_scale(const Site& s) {
    return -last_bit(s.r);
}
int third_scale(const power::Site& s) {
    return -last_bit(s.w) / 2 + 1;
}
mpz_class weight(const Point&, int) {
    return 0;
}
mpz_class weight(const Site& s, int scale) {
    const mpz_class r = scaled(s.r, scale);
    return r * r;
}
mpz_class weight(const power::Site& s, int scale) {
    return scaled(s.w, 2 * scale);
}

/// The least k that makes all numbers of the sites integers times 2^-k, weights times 2^-2k.
template <class S, std::size_t n>
int scale_of(const std::array<S, n>& sites) {
    int scale = -1023;
    for (const S& s : sites)
        scale = std::max({scale, -last_bit(s.x), -last_bit(s.y), third_scale(s)});
    return scale;
}

template <class S, std::size_t n>
std::array<Exact, n> exactly(const std::array<S, n>& sites) {
    const int scale = scale_of(sites);
    std::array<Exact, n> result;
    for (std::size_t i = 0; i < n; ++i)
        result[i] = {scaled(sites[i].x, scale), scaled(sites[i].y, scale), weight(sites[i], scale)};
    return result;
}

mpz_class area(const Exact& a, const Exact& b, const Exact& c) {
    const mpz_class ux = b.x - a.x;
    const mpz_class uy = b.y - a.y;
    const mpz_class vx = c.x - a.x;
    const mpz_class vy = c.y - a.y;
    return ux * vy - uy * vx;
}

/// |m|² - w_m, the height of the lifted site, with i for origin.
mpz_class lifted(const Exact& m, const Exact& i) {
    const mpz_class x = m.x - i.x;
    const mpz_class y = m.y - i.y;
    return x * x + y * y - m.w + i.w;
}

/// q conflicts if its lifted point lies below the plane of the others, i for origin.
mpz_class below_plane(const Exact& i, const Exact& j, const Exact& k, const Exact& q) {
    return -(lifted(q, i) * area(i, j, k) + lifted(j, i) * area(i, k, q) +
             lifted(k, i) * area(i, q, j));
}

int sign_in_segment(const Exact& a, const Exact& b, const Exact& q) {
    const bool by_x = a.x != b.x;
    const mpz_class ab = by_x ? mpz_class(b.x - a.x) : mpz_class(b.y - a.y);
    const mpz_class aq = by_x ? mpz_class(q.x - a.x) : mpz_class(q.y - a.y);
    const mpz_class above = lifted(b, a) * aq - lifted(q, a) * ab;
    return sgn(above) * sgn(ab);
}

int sign_nearer(const Exact& p, const Exact& a, const Exact& b) {
    const auto distance = [&p](const Exact& s) {
        const mpz_class x = p.x - s.x;
        const mpz_class y = p.y - s.y;
        return mpz_class(x * x + y * y - s.w);
    };
    return sgn(distance(b) - distance(a));
}

// ---- inputs ------------------------------------------------------------------------------------

using Sites = std::array<Site, 4>;

Sites random_sites(Random& random) {
    Sites sites;
    for (Site& s : sites)
        s = {2 * random.real() - 1, 2 * random.real() - 1, random.sign() * random.real() / 2};
    return sites;
}

Sites grid(Random& random) {
    Sites sites;
    for (Site& s : sites)
        s = {1.0 * random.below(4), 1.0 * random.below(4), 1.0 * random.between(-1, 2)};
    return sites;
}

/// Exact ties: Pythagorean points of one circle, equal radii.
Sites cocircular(Random& random) {
    static constexpr int points[][2] = {{63, 16}, {16, 63}, {56, 33}, {33, 56}, {60, 25},
                                        {25, 60}, {52, 39}, {39, 52}, {65, 0},  {0, 65}};
    Sites sites;
    const double radius = random.below(3);
    const double x = random.below(3) == 0 ? random.between(-1000, 1000) * 0x1p20 : 0.0;
    const double y = random.below(3) == 0 ? random.between(-1000, 1000) * 0x1p20 : 0.0;
    for (Site& s : sites) {
        const auto& p = points[random.below(10)];
        s = {x + random.sign() * p[0], y + random.sign() * p[1], random.sign() * radius};
    }
    return sites;
}

Sites moved_all(Random& random, Sites sites) {
    for (Site& s : sites) s = {moved(random, s.x), moved(random, s.y), moved(random, s.r)};
    return sites;
}

Sites collinear(Random& random) {
    static constexpr double units[] = {1.0, 0.1, 1.0 / 3.0, 3.0, 0x1p40 + 1, 1e-9};
    const double dx = random.any(units) * random.between(-3, 3);
    const double dy = random.any(units) * random.between(-3, 3);
    const double x = random.coin() ? 0.0 : random.real();
    const double y = random.coin() ? 0.0 : 12.0;
    Sites sites;
    for (Site& s : sites) {
        const double t = random.between(-8, 8);
        s = {x + t * dx, y + t * dy, 0.5 * random.below(3)};
    }
    return sites;
}

/// Where a sum and a difference of radii are both inexact, tiny beside huge weights, equal ones.
Sites odd_radii(Random& random) {
    static constexpr double radii[] = {0.0,     1.0,     -1.0,        0x1p-60,         0x1p-70,
                                       2.0,     0x1p-30, 1 + 0x1p-52, 0x1.fffffffffp0, 0x1p30,
                                       0x1p100, 5.0,     -0x1p-60,    0x1p100 - 0x1p48};
    Sites sites;
    const double first = random.any(radii);
    const double second = random.any(radii);
    for (Site& s : sites)
        s = {1.0 * random.between(-2, 2), 1.0 * random.between(-2, 2),
             random.below(4) == 0 ? random.any(radii)
             : random.coin()      ? first
                                  : second};
    return sites;
}

/// Large enough that a difference overflows, or small in one coordinate and large in the other.
Sites opposite_ends(Random& random) {
    Sites sites;
    const double small = std::ldexp(1.0, random.between(-1000, 0));
    const bool by_y = random.coin();
    for (Site& s : sites) {
        const double large = random.sign() * random.real() * std::numeric_limits<double>::max();
        const double other = random.sign() * random.real() * small;
        s = {by_y ? other : large, by_y ? large : other, 0.0};
        if (random.below(4) == 0) s.r = other;
        if (random.below(4) == 0) s.x = s.y;
    }
    return sites;
}

Sites mixed(Random& random) {
    static constexpr int exponents[] = {
        -1074, -1073, -1023, -1022, -1021, -538, -537, -270, -252, -201, -200, -199, -120, -53, 0,
        1,     53,    120,   199,   200,   201,  255,  256,  399,  511,  512,  1021, 1022, 1023};
    Sites sites;
    const int kinds = random.between(1, 4);
    std::array<double, 4> values;
    for (double& v : values)
        v = random.sign() * std::ldexp(random.significand(), random.any(exponents));
    const auto pick = [&] {
        const double v =
            random.below(5) == 0 ? 0.0 : values[static_cast<std::size_t>(random.below(kinds))];
        return random.sign() * (random.below(3) == 0 ? v * random.between(1, 3) : v);
    };
    for (Site& s : sites) {
        s = {pick(), pick(), pick()};
        for (double* v : {&s.x, &s.y, &s.r})
            if (!std::isfinite(*v)) *v = std::numeric_limits<double>::max();
    }
    return sites;
}

Sites huge(Random& random) {
    Sites sites;
    for (Site& s : sites) {
        const auto pick = [&] {
            return random.sign() * std::ldexp(random.significand(), random.between(997, 1023));
        };
        s = {pick(), pick(), random.coin() ? 0.0 : pick()};
    }
    return sites;
}

Sites denormal(Random& random) {
    Sites sites;
    for (Site& s : sites)
        s = {random.between(-5, 5) * 0x1p-1074, random.between(-5, 5) * 0x1p-1074,
             random.between(-2, 2) * 0x1p-1074};
    return sites;
}

/// Every number times a power of two, near the places where something happens.
Sites rescaled(Random& random, Sites sites) {
    static constexpr int places[] = {
        -1060, -1022, -600, -537, -511, -350, -270, -262, -256, -252, -209, -206, -200, -100, 100,
        190,   194,   197,  200,  240,  244,  247,  248,  249,  250,  251,  252,  253,  254,  255,
        256,   257,   300,  340,  500,  505,  508,  509,  510,  511,  512,  600,  1000, 1013, 1016};
    const int exponent = random.any(places) + random.between(-1, 1);
    for (Site& s : sites)
        for (double* v : {&s.x, &s.y, &s.r}) {
            *v = std::ldexp(*v, exponent);
            if (!std::isfinite(*v)) *v = std::copysign(std::numeric_limits<double>::max(), *v);
        }
    return sites;
}

struct Family {
    const char* name;
    Sites (*draw)(Random&);
    double share;  // of the trials; those that mostly end in rationals get fewer
};

void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

const Family families[] = {
    {"random", random_sites, 1},
    {"grid", grid, 1},
    {"cocircular", cocircular, 1},
    {"nearly_cocircular", [](Random& g) { return moved_all(g, cocircular(g)); }, 2},
    {"nearly_cocircular_off_grid",
     [](Random& g) {
         Sites sites = cocircular(g);
         for (Site& s : sites) s = {s.x * 0.1, s.y * 0.1, s.r};
         return moved_all(g, sites);
     },
     1},
    {"collinear", collinear, 1},
    {"nearly_collinear", [](Random& g) { return moved_all(g, collinear(g)); }, 1},
    {"nearly_grid", [](Random& g) { return moved_all(g, grid(g)); }, 1},
    {"odd_radii", odd_radii, 2},
    {"opposite_ends", opposite_ends, 0.5},
    {"mixed", mixed, 1},
    {"huge", huge, 0.3},
    {"denormal", denormal, 0.3},
    {"random_rescaled", [](Random& g) { return rescaled(g, random_sites(g)); }, 0.5},
    {"grid_rescaled", [](Random& g) { return rescaled(g, grid(g)); }, 0.7},
    {"cocircular_rescaled", [](Random& g) { return rescaled(g, cocircular(g)); }, 0.7},
    {"nearly_cocircular_rescaled",
     [](Random& g) { return rescaled(g, moved_all(g, cocircular(g))); }, 0.7},
    {"collinear_rescaled", [](Random& g) { return rescaled(g, collinear(g)); }, 0.3},
    {"odd_radii_rescaled", [](Random& g) { return rescaled(g, odd_radii(g)); }, 0.3},
};

int trials(int count, const Family& family) {
    return static_cast<int>(count * family.share * effort) + 1;
}

std::string text(double x, double y, const char* third, double z) {
    char buffer[120];
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %s %a} ", x, y, third, z);
    return buffer;
}
std::string text(const Point& s) {
    return text(s.x, s.y, "", 0.0);
}
std::string text(const Site& s) {
    return text(s.x, s.y, "r", s.r);
}
std::string text(const power::Site& s) {
    return text(s.x, s.y, "w", s.w);
}
template <class S, std::size_t n>
std::string text(const std::array<S, n>& sites) {
    std::string result;
    for (const S& s : sites) result += text(s);
    return result;
}

template <class S>
S as(const Site& s) {
    if constexpr (std::is_same_v<S, Point>) {
        return {s.x, s.y};
    } else {
        return {s.x, s.y, s.r};
    }
}
template <class S, std::size_t n>
std::array<S, n> first(const Sites& sites) {
    std::array<S, n> result;
    for (std::size_t i = 0; i < n; ++i) result[i] = as<S>(sites[i]);
    return result;
}

/// Asserts that the predicate says `expected` of the sites in every environment.
template <class S, std::size_t n, class Predicate>
[[nodiscard]] testing::AssertionResult says(const std::array<S, n>& sites, int expected,
                                            const Predicate& predicate) {
    for (int e = 0; e < environments; ++e) {
        const Decision d = within(e, [&] { return predicate(sites); });
        if (d.sign != expected)
            return testing::AssertionFailure()
                   << d.sign << " by " << name_of(d.stage) << ", not " << expected << ", rounding "
                   << name_of_environment(e) << ": " << text(sites);
    }
    return testing::AssertionSuccess();
}

class Predicates : public testing::TestWithParam<Family> {
 protected:
    Random random_{2024};
    [[nodiscard]] Sites draw() { return GetParam().draw(random_); }
};

TEST_P(Predicates, Ccw) {
    for (int trial = trials(20000, GetParam()); trial > 0; --trial) {
        const auto p = first<Point, 3>(draw());
        const auto e = exactly(p);
        ASSERT_TRUE(says(p, sgn(area(e[0], e[1], e[2])),
                         [](const auto& q) { return ccw_decision(q[0], q[1], q[2]); }));
        if (trial % 8 != 0) continue;
        ASSERT_TRUE(says(p, sgn(area(e[0], e[1], e[2])),
                         [](const auto& q) { return BySums<Point>::ccw(q[0], q[1], q[2]); }));
        ASSERT_TRUE(says(p, sgn(area(e[0], e[1], e[2])),
                         [](const auto& q) { return Judging<Point>::ccw(q[0], q[1], q[2]); }));
    }
}

template <class S>
void test_in_circle(Random& random, const Family& family, int count) {
    for (int trial = trials(count, family); trial > 0; --trial) {
        auto sites = first<S, 4>(family.draw(random));
        auto e = exactly(sites);
        const int side = sgn(area(e[0], e[1], e[2]));
        if (side == 0) continue;
        if (side < 0) {
            std::swap(sites[0], sites[1]);
            std::swap(e[0], e[1]);
        }
        const int expected = sgn(below_plane(e[0], e[1], e[2], e[3]));
        ASSERT_TRUE(says(sites, expected, [](const auto& s) {
            return power::in_circle_decision(s[0], s[1], s[2], s[3]);
        }));
        if (trial % 8 != 0) continue;
        ASSERT_TRUE(says(sites, expected, [](const auto& s) {
            return BySums<S>::in_circle(s[0], s[1], s[2], s[3]);
        }));
        ASSERT_TRUE(says(sites, expected, [](const auto& s) {
            return Judging<S>::in_circle(s[0], s[1], s[2], s[3]);
        }));
    }
}

TEST_P(Predicates, InCircleOfPoints) {
    test_in_circle<Point>(random_, GetParam(), 10000);
}
TEST_P(Predicates, InCircleOfWeights) {
    test_in_circle<power::Site>(random_, GetParam(), 10000);
}
TEST_P(Predicates, InCircleOfRadii) {
    test_in_circle<Site>(random_, GetParam(), 10000);
}

/// Three sites on a line, exactly: along an axis, a diagonal, or a lattice direction.
template <class S>
std::array<S, 3> on_line(Random& random, const Sites& sites) {
    auto result = first<S, 3>(sites);
    const int kind = random.below(4);
    const double dx = random.between(-3, 3);
    const double dy = random.between(-3, 3);
    for (S& s : result) {
        if (kind == 0) s.y = result[0].y;
        if (kind == 1) s.x = result[0].x;
        if (kind == 2) s.y = -s.x;
        if (kind == 3) {
            const double t = random.between(-9, 9);
            s.x = t * dx;
            s.y = t * dy;
        }
    }
    return result;
}

template <class S>
void test_in_segment(Random& random, const Family& family) {
    for (int trial = trials(6000, family); trial > 0; --trial) {
        const auto sites = on_line<S>(random, family.draw(random));
        const auto e = exactly(sites);
        if (e[0].x == e[1].x && e[0].y == e[1].y) continue;
        ASSERT_EQ(area(e[0], e[1], e[2]), 0);
        const int expected = sign_in_segment(e[0], e[1], e[2]);
        ASSERT_TRUE(says(sites, expected, [](const auto& s) {
            return power::in_segment_decision(s[0], s[1], s[2]);
        }));
        if (trial % 8 == 0) {
            ASSERT_TRUE(says(sites, expected, [](const auto& s) {
                return BySums<S>::in_segment(s[0], s[1], s[2]);
            }));
            ASSERT_TRUE(says(sites, expected, [](const auto& s) {
                return Judging<S>::in_segment(s[0], s[1], s[2]);
            }));
        }
        ASSERT_TRUE(says(sites, expected, [](const auto& s) {
            return Decision{power::in_circle_infinite(s[0], s[1], s[2]), Stage::exact};
        }));
    }
}

TEST_P(Predicates, InSegment) {
    test_in_segment<Point>(random_, GetParam());
    test_in_segment<power::Site>(random_, GetParam());
    test_in_segment<Site>(random_, GetParam());
}

template <class S>
void test_nearer(Random& random, const Family& family) {
    for (int trial = trials(8000, family); trial > 0; --trial) {
        auto sites = first<S, 3>(family.draw(random));
        const int kind = random.below(4);
        if (kind == 0) sites[0] = sites[1];
        if (kind == 1) sites[1] = {sites[0].y, sites[0].x};
        const auto e = exactly(sites);
        ASSERT_TRUE(says(sites, sign_nearer(e[0], e[1], e[2]), [](const auto& s) {
            return power::nearer_decision({s[0].x, s[0].y}, s[1], s[2]);
        }));
        if (trial % 8 == 0) {
            ASSERT_TRUE(says(sites, sign_nearer(e[0], e[1], e[2]), [](const auto& s) {
                return BySums<S>::nearer({s[0].x, s[0].y}, s[1], s[2]);
            }));
            ASSERT_TRUE(says(sites, sign_nearer(e[0], e[1], e[2]), [](const auto& s) {
                return Judging<S>::nearer({s[0].x, s[0].y}, s[1], s[2]);
            }));
        }
        if (kind == 0) {
            const bool same = e[1].x == e[2].x && e[1].y == e[2].y;
            ASSERT_TRUE(says(sites, same && e[2].w >= e[1].w ? 1 : 0, [](const auto& s) {
                return Decision{power::hidden(s[1], s[2]) ? 1 : 0, Stage::exact};
            }));
        }
    }
}

TEST_P(Predicates, Nearer) {
    test_nearer<Point>(random_, GetParam());
    test_nearer<power::Site>(random_, GetParam());
    test_nearer<Site>(random_, GetParam());
}

TEST_P(Predicates, CcwUnderPermutations) {
    static constexpr int orders[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                         {1, 0, 2, -1}, {0, 2, 1, -1}, {2, 1, 0, -1}};
    for (int trial = trials(1500, GetParam()); trial > 0; --trial) {
        const auto p = first<Point, 3>(draw());
        const Sign sign = ccw(p[0], p[1], p[2]);
        for (const auto& o : orders)
            ASSERT_EQ(ccw(p[static_cast<std::size_t>(o[0])], p[static_cast<std::size_t>(o[1])],
                          p[static_cast<std::size_t>(o[2])]),
                      o[3] * sign)
                << text(p);
    }
}

TEST_P(Predicates, InCircleUnderRotationsAndMirrorings) {
    for (int trial = trials(1000, GetParam()); trial > 0; --trial) {
        auto s = first<Site, 4>(draw());
        const Sign side = ccw(power::centre(s[0]), power::centre(s[1]), power::centre(s[2]));
        if (side == 0) continue;
        if (side < 0) std::swap(s[0], s[1]);
        const Sign sign = power::in_circle(s[0], s[1], s[2], s[3]);
        ASSERT_EQ(power::in_circle(s[1], s[2], s[0], s[3]), sign) << text(s);
        ASSERT_EQ(power::in_circle(s[2], s[0], s[1], s[3]), sign) << text(s);
        const auto mirrored = [](const Site& p) { return Site{-p.x, p.y, -p.r}; };
        const auto turned = [](const Site& p) { return Site{-p.y, p.x, p.r}; };
        ASSERT_EQ(power::in_circle(mirrored(s[1]), mirrored(s[0]), mirrored(s[2]), mirrored(s[3])),
                  sign)
            << text(s);
        ASSERT_EQ(power::in_circle(turned(s[0]), turned(s[1]), turned(s[2]), turned(s[3])), sign)
            << text(s);
        // q and i exchanged: where q, j, k turn counterclockwise, the answer too, otherwise not.
        const Sign other = ccw(power::centre(s[3]), power::centre(s[1]), power::centre(s[2]));
        if (other > 0) {
            ASSERT_EQ(power::in_circle(s[3], s[1], s[2], s[0]), -sign) << text(s);
        }
        if (other < 0) {
            ASSERT_EQ(power::in_circle(s[1], s[3], s[2], s[0]), sign) << text(s);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Predicates, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PredicateIdentities, TranslationsThatAreExactChangeNothing) {
    Random random(5);
    for (int trial = 0; trial < static_cast<int>(20000 * effort); ++trial) {
        // Multiples of 2^-20 below 2^10 moved by multiples of 2^-20 below 2^30: exact.
        std::array<Site, 4> s;
        for (Site& site : s)
            site = {std::ldexp(random.between(-1 << 20, 1 << 20), -random.below(20)),
                    std::ldexp(random.between(-4, 4), 0), std::ldexp(random.below(5), -2)};
        const double dx = std::ldexp(random.between(-1 << 29, 1 << 29), -random.below(20));
        const double dy = std::ldexp(random.between(-1 << 29, 1 << 29), -random.below(20));
        auto t = s;
        for (Site& site : t) site = {site.x + dx, site.y + dy, site.r};
        const Sign side = ccw(power::centre(s[0]), power::centre(s[1]), power::centre(s[2]));
        ASSERT_EQ(ccw(power::centre(t[0]), power::centre(t[1]), power::centre(t[2])), side);
        if (side == 0) continue;
        if (side < 0) {
            std::swap(s[0], s[1]);
            std::swap(t[0], t[1]);
        }
        ASSERT_EQ(power::in_circle(t[0], t[1], t[2], t[3]),
                  power::in_circle(s[0], s[1], s[2], s[3]))
            << text(s);
    }
}

/// §2 of the geometry: centres moved by (p, q), weights raised by 2px + p² + 2qy + q².
TEST(PredicateIdentities, TheShiftOfWeightsChangesNothing) {
    Random random(6);
    for (int trial = 0; trial < static_cast<int>(20000 * effort); ++trial) {
        std::array<power::Site, 4> s;
        for (auto& site : s)
            site = {1.0 * random.between(-99, 99), 1.0 * random.between(-99, 99),
                    1.0 * random.between(-50, 50)};
        const Sign side = ccw(power::centre(s[0]), power::centre(s[1]), power::centre(s[2]));
        if (side == 0) continue;
        if (side < 0) std::swap(s[0], s[1]);
        const double p = random.between(-1 << 20, 1 << 20);
        const double q = random.between(-1 << 20, 1 << 20);
        auto t = s;
        for (auto& site : t)
            site = {site.x + p, site.y + q,
                    site.w + 2 * p * site.x + p * p + 2 * q * site.y + q * q};
        ASSERT_EQ(power::in_circle(t[0], t[1], t[2], t[3]),
                  power::in_circle(s[0], s[1], s[2], s[3]));
    }
}

// ---- the bounds of the filters -----------------------------------------------------------------

/// A determinant and the bound on its error, as a filter computes them.
struct Estimate {
    double determinant;
    double bound;
};

/// (The filter itself takes |left + right|: where that is less, the determinant does not cancel.)
Estimate estimate_ccw(const std::array<Point, 3>& p) {
    const double left = (p[0].x - p[2].x) * (p[1].y - p[2].y);
    const double right = (p[0].y - p[2].y) * (p[1].x - p[2].x);
    return {left - right, predicates::ccw_error * (std::fabs(left) + std::fabs(right)) + 0x1p-1000};
}

template <class S>
Estimate estimate_in_circle(const std::array<S, 4>& sites) {
    const auto a = power::row(sites[0], sites[3]);
    const auto b = power::row(sites[1], sites[3]);
    const auto c = power::row(sites[2], sites[3]);
    const auto height = [](const power::Row<double>& row) {
        return (row.x * row.x + row.y * row.y) + std::fabs(row.weight);
    };
    const double s = height(a) + height(b) + height(c);
    return {power::in_circle_determinant(a, b, c),
            s * (5 * filters::epsilon * s + 0x1p-1000) + 0x1p-1000};
}

bool is_moderate(const Point& s) {
    return std::fabs(s.x) < 0x1p200 && std::fabs(s.y) < 0x1p200;
}
bool is_moderate(const Site& s) {
    return is_moderate(power::centre(s)) && std::fabs(s.r) < 0x1p200;
}
bool is_moderate(const power::Site& s) {
    return is_moderate(power::centre(s)) && std::fabs(s.w) < 0x1p400;
}

/// Of small numbers any, of large ones only those that cannot overflow: of these no filter is sure.
template <class S, std::size_t n>
bool is_moderate(const std::array<S, n>& sites) {
    return std::all_of(sites.begin(), sites.end(), [](const S& s) { return is_moderate(s); });
}

/// |estimate - exact · 2^-scale| <= bound.
template <class S, std::size_t n>
[[nodiscard]] testing::AssertionResult holds(const Estimate& e, const mpz_class& exact, int scale,
                                             const std::array<S, n>& sites) {
    mpq_class error(exact);
    if (scale >= 0) {
        mpq_div_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(scale));
    } else {
        mpq_mul_2exp(error.get_mpq_t(), error.get_mpq_t(), static_cast<mp_bitcnt_t>(-scale));
    }
    error -= mpq_class(e.determinant);
    if (abs(error) > mpq_class(e.bound))
        return testing::AssertionFailure() << "error " << error.get_d() << " beyond the bound "
                                           << e.bound << ": " << text(sites);
    return testing::AssertionSuccess();
}

class FilterBounds : public testing::TestWithParam<Family> {};

TEST_P(FilterBounds, Ccw) {
    Random random(77);
    for (int trial = trials(3000, GetParam()); trial > 0; --trial) {
        const auto p = first<Point, 3>(GetParam().draw(random));
        if (!is_moderate(p)) continue;
        const int scale = scale_of(p);
        const auto e = exactly(p);
        const mpz_class exact = area(e[0], e[1], e[2]);
        for (int environment = 0; environment < 4; ++environment) {
            const Estimate estimate = within(environment, [&] { return estimate_ccw(p); });
            ASSERT_TRUE(holds(estimate, exact, 2 * scale, p)) << name_of_environment(environment);
        }
    }
}

template <class S>
void test_in_circle_bound(Random& random, const Family& family) {
    for (int trial = trials(1500, family); trial > 0; --trial) {
        const auto sites = first<S, 4>(family.draw(random));
        if (!is_moderate(sites)) continue;
        const int scale = scale_of(sites);
        const auto e = exactly(sites);
        const mpz_class exact = below_plane(e[0], e[1], e[2], e[3]);
        for (int environment = 0; environment < 4; ++environment) {
            const Estimate estimate =
                within(environment, [&] { return estimate_in_circle(sites); });
            ASSERT_TRUE(holds(estimate, exact, 4 * scale, sites))
                << name_of_environment(environment);
        }
    }
}

TEST_P(FilterBounds, InCircle) {
    Random random(78);
    test_in_circle_bound<Point>(random, GetParam());
    test_in_circle_bound<power::Site>(random, GetParam());
    test_in_circle_bound<Site>(random, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Families, FilterBounds, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace signum
