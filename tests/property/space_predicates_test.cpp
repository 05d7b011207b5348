// The predicates of space against integers of any size, on inputs made to break them, in every
// rounding mode, with and without flushing of denormals. Shares no code with predicates/.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include "../../predicates/space.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "environments.hpp"
#include "raw_doubles.hpp"

namespace signum {
namespace {

// ---- the reference: integers -------------------------------------------------------------------

/// A site in units so small that all its numbers are integers.
struct Exact {
    mpz_class x[3];
    mpz_class w;
};

template <class S, std::size_t n>
std::array<Exact, n> exactly(const std::array<S, n>& sites) {
    int scale = -1023;
    for (const S& s : sites) {
        scale = std::max({scale, -last_bit(s.x), -last_bit(s.y), -last_bit(s.z)});
        if constexpr (requires { s.r; }) scale = std::max(scale, -last_bit(s.r));
        if constexpr (requires { s.w; }) scale = std::max(scale, -last_bit(s.w) / 2 + 1);
    }
    std::array<Exact, n> result;
    for (std::size_t i = 0; i < n; ++i) {
        const S& s = sites[i];
        result[i] = {{scaled(s.x, scale), scaled(s.y, scale), scaled(s.z, scale)}, 0};
        if constexpr (requires { s.r; }) result[i].w = scaled(s.r, scale) * scaled(s.r, scale);
        if constexpr (requires { s.w; }) result[i].w = scaled(s.w, 2 * scale);
    }
    return result;
}

/// Of n rows, by the first column, one minor after the other.
mpz_class determinant(const std::vector<std::vector<mpz_class>>& rows) {
    if (rows.size() == 1) return rows[0][0];
    mpz_class sum = 0;
    for (std::size_t skipped = 0; skipped < rows.size(); ++skipped) {
        std::vector<std::vector<mpz_class>> minor;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (i != skipped) minor.emplace_back(rows[i].begin() + 1, rows[i].end());
        const mpz_class term = rows[skipped][0] * determinant(minor);
        sum += skipped % 2 == 0 ? term : mpz_class(-term);
    }
    return sum;
}
/// |m|² - w_m relative to an origin.
mpz_class lifted(const Exact& m, const Exact& origin) {
    mpz_class height = origin.w - m.w;
    for (int k = 0; k < 3; ++k) height += (m.x[k] - origin.x[k]) * (m.x[k] - origin.x[k]);
    return height;
}
std::vector<mpz_class> row(const Exact& m, const Exact& origin) {
    return {m.x[0] - origin.x[0], m.x[1] - origin.x[1], m.x[2] - origin.x[2]};
}
int side(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
    return sgn(determinant({row(b, a), row(c, a), row(d, a)}));
}
/// Whether q's lifted point lies below the hyperplane of the others: their lifted simplex with q
/// turns the other way than their own.
int conflict(const std::array<Exact, 5>& e) {
    std::vector<std::vector<mpz_class>> rows;
    for (std::size_t m = 1; m < 5; ++m) {
        rows.push_back(row(e[m], e[0]));
        rows.back().push_back(lifted(e[m], e[0]));
    }
    return -sgn(determinant(rows)) * side(e[0], e[1], e[2], e[3]);
}

// ---- inputs ------------------------------------------------------------------------------------

using Sites = std::array<Site3, 5>;

template <class Draw>
Sites each(const Draw& draw) {
    Sites sites;
    for (Site3& s : sites) s = draw();
    return sites;
}
template <class Change>
Sites changed(Sites sites, const Change& change) {
    for (Site3& s : sites)
        for (double* number : {&s.x, &s.y, &s.z, &s.r}) *number = change(*number);
    return sites;
}
double finite(double value) {
    return std::isfinite(value) ? value : std::copysign(std::numeric_limits<double>::max(), value);
}

Sites random_sites(Random& g) {
    const auto one = [&] { return 2 * g.real() - 1; };
    return each([&] { return Site3{one(), one(), one(), one() / 2}; });
}
Sites lattice(Random& g) {
    const auto one = [&] { return 1.0 * g.below(3); };
    return each([&] { return Site3{one(), one(), one(), 1.0 * g.between(-1, 1)}; });
}
Sites wide_lattice(Random& g) {
    const double far = 0x1p40 * g.below(2);
    const auto one = [&] { return far + g.between(-(1 << 18), 1 << 18); };
    return each([&] { return Site3{one(), one(), one(), 1.0 * g.between(-1, 1)}; });
}
/// Exact ties: integer points of one sphere, 9² = 81, equal radii; a huge origin now and then.
Sites cospherical(Random& g) {
    static constexpr int points[][3] = {{9, 0, 0}, {8, 4, 1}, {7, 4, 4}, {6, 6, 3}};
    const double radius = g.below(3);
    double origin[3];
    for (double& x : origin) x = g.below(3) == 0 ? g.between(-1000, 1000) * 0x1p20 : 0.0;
    return each([&] {
        int p[3];
        std::copy_n(points[g.below(4)], 3, p);
        std::swap(p[0], p[g.below(3)]);
        std::swap(p[1], p[1 + g.below(2)]);
        return Site3{origin[0] + g.sign() * p[0], origin[1] + g.sign() * p[1],
                     origin[2] + g.sign() * p[2], g.sign() * radius};
    });
}
/// In a plane, or on a line.
Sites coplanar(Random& g) {
    static constexpr double units[] = {1.0, 0.1, 1.0 / 3.0, 3.0, 0x1p40 + 1, 1e-9};
    double u[3];
    double v[3];
    double origin[3];
    for (int k = 0; k < 3; ++k) {
        u[k] = g.any(units) * g.between(-3, 3);
        v[k] = g.coin() ? u[k] : g.any(units) * g.between(-3, 3);
        origin[k] = g.coin() ? 0.0 : g.real();
    }
    return each([&] {
        const double s = g.between(-8, 8);
        const double t = g.between(-8, 8);
        return Site3{origin[0] + s * u[0] + t * v[0], origin[1] + s * u[1] + t * v[1],
                     origin[2] + s * u[2] + t * v[2], 0.5 * g.below(3)};
    });
}
/// Corners of a box whose sides are no integers: five of them are always on one sphere.
Sites box_corners(Random& g) {
    double corner[2][3];
    for (auto& point : corner)
        for (double& x : point) x = g.coin() ? g.between(1, 9) * 0.1 : g.real();
    const double radius = g.real();
    return each([&] {
        return Site3{corner[g.below(2)][0], corner[g.below(2)][1], corner[g.below(2)][2], radius};
    });
}
/// Where a sum and a difference of radii are both inexact, tiny beside huge weights, equal ones.
Sites odd_radii(Random& g) {
    static constexpr double radii[] = {0.0,     1.0,     -1.0,        0x1p-60,         0x1p-70,
                                       2.0,     0x1p-30, 1 + 0x1p-52, 0x1.fffffffffp0, 0x1p30,
                                       0x1p100, 5.0,     -0x1p-60,    0x1p100 - 0x1p48};
    const double first = g.any(radii);
    const double second = g.any(radii);
    const auto one = [&] { return 1.0 * g.between(-2, 2); };
    return each([&] {
        const double r = g.below(4) == 0 ? g.any(radii) : g.coin() ? first : second;
        return Site3{one(), one(), one(), r};
    });
}
/// Raw bit patterns, a few exponents.
Sites mixed(Random& g) {
    static constexpr int exponents[] = {-1074, -1073, -1023, -1022, -600, -301, -300, -252, -203,
                                        -202,  -201,  -151,  -150,  -149, -120, -53,  0,    1,
                                        53,    120,   149,   150,   151,  200,  300,  1022, 1023};
    const int kinds = g.between(1, 4);
    std::array<double, 4> values;
    for (double& v : values) v = g.sign() * std::ldexp(g.significand(), g.any(exponents));
    const auto pick = [&] {
        const double v = g.below(5) == 0 ? 0.0 : values[static_cast<std::size_t>(g.below(kinds))];
        return finite(g.sign() * (g.below(3) == 0 ? v * g.between(1, 3) : v));
    };
    return each([&] { return Site3{pick(), pick(), pick(), pick()}; });
}
Sites huge(Random& g) {
    const auto pick = [&] { return g.sign() * std::ldexp(g.significand(), g.between(997, 1023)); };
    return each([&] { return Site3{pick(), pick(), pick(), g.coin() ? 0.0 : pick()}; });
}
Sites denormal(Random& g) {
    const auto pick = [&] { return g.between(-4, 4) * 0x1p-1074; };
    return each([&] { return Site3{pick(), pick(), pick(), pick()}; });
}
/// Every number times a power of two, near the places where something happens.
Sites rescaled(Random& g, const Sites& sites) {
    static constexpr int places[] = {-1060, -1022, -600, -400, -301, -252, -215, -202,
                                     -200,  -152,  -150, -148, -100, 100,  148,  150,
                                     152,   200,   300,  340,  600,  1000, 1013};
    const int exponent = g.any(places) + g.between(-1, 1);
    return changed(sites, [&](double v) { return finite(std::ldexp(v, exponent)); });
}
Sites moved_all(Random& g, const Sites& sites) {
    return changed(sites, [&](double v) { return moved(g, v); });
}
Sites off_grid(const Sites& sites) {
    return changed(sites, [](double v) { return v * 0.1; });
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
    {"lattice", lattice, 1},
    {"wide_lattice", wide_lattice, 1},
    {"nearly_lattice", [](Random& g) { return moved_all(g, lattice(g)); }, 1},
    {"cospherical", cospherical, 1},
    {"nearly_cospherical", [](Random& g) { return moved_all(g, cospherical(g)); }, 2},
    {"nearly_cospherical_off_grid",
     [](Random& g) { return moved_all(g, off_grid(cospherical(g))); }, 1},
    {"coplanar", coplanar, 1},
    {"nearly_coplanar", [](Random& g) { return moved_all(g, coplanar(g)); }, 1},
    {"box_corners", box_corners, 1},
    {"nearly_box_corners", [](Random& g) { return moved_all(g, box_corners(g)); }, 1},
    {"odd_radii", odd_radii, 1},
    {"mixed", mixed, 1},
    {"huge", huge, 0.3},
    {"denormal", denormal, 0.3},
    {"random_rescaled", [](Random& g) { return rescaled(g, random_sites(g)); }, 0.5},
    {"lattice_rescaled", [](Random& g) { return rescaled(g, lattice(g)); }, 0.5},
    {"cospherical_rescaled", [](Random& g) { return rescaled(g, cospherical(g)); }, 0.5},
    {"nearly_cospherical_rescaled",
     [](Random& g) { return rescaled(g, moved_all(g, cospherical(g))); }, 0.5},
    {"odd_radii_rescaled", [](Random& g) { return rescaled(g, odd_radii(g)); }, 0.3},
};

int trials(int count, const Family& family) {
    return static_cast<int>(count * family.share * effort) + 1;
}

template <class S, std::size_t n>
std::string text(const std::array<S, n>& sites) {
    std::string result;
    for (const S& s : sites) {
        double last = 0.0;
        if constexpr (requires { s.r; }) last = s.r;
        if constexpr (requires { s.w; }) last = s.w;
        char buffer[160];
        std::snprintf(buffer, sizeof buffer, "{%a, %a, %a, %a} ", s.x, s.y, s.z, last);
        result += buffer;
    }
    return result;
}
template <class S, std::size_t n>
std::array<S, n> first(const Sites& sites) {
    std::array<S, n> result;
    for (std::size_t i = 0; i < n; ++i) {
        const Site3& s = sites[i];
        if constexpr (std::is_same_v<S, Point3>)
            result[i] = {s.x, s.y, s.z};
        else
            result[i] = {s.x, s.y, s.z, s.r};
    }
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

class SpacePredicates : public testing::TestWithParam<Family> {
 protected:
    Random random_{2026};
    [[nodiscard]] Sites draw() { return GetParam().draw(random_); }

    template <class S>
    void test_in_sphere(int count) {
        for (int trial = trials(count, GetParam()); trial > 0; --trial) {
            auto sites = first<S, 5>(draw());
            auto e = exactly(sites);
            const int turn = side(e[0], e[1], e[2], e[3]);
            if (turn == 0) continue;
            if (turn < 0) {
                std::swap(sites[0], sites[1]);
                std::swap(e[0], e[1]);
            }
            const int expected = conflict(e);
            ASSERT_TRUE(says(sites, expected, [](const auto& s) {
                return power::in_sphere_decision(s[0], s[1], s[2], s[3], s[4]);
            }));
            if (trial % 8 != 0) continue;
            ASSERT_TRUE(says(sites, expected, [](const auto& s) {
                return predicates::decide<Arithmetic::multiprecision, power::InSphere>(
                    s[0], s[1], s[2], s[3], s[4]);
            }));
        }
    }
};

TEST_P(SpacePredicates, Ccw) {
    for (int trial = trials(10000, GetParam()); trial > 0; --trial) {
        const auto p = first<Point3, 4>(draw());
        const auto e = exactly(p);
        const int expected = side(e[0], e[1], e[2], e[3]);
        ASSERT_TRUE(
            says(p, expected, [](const auto& q) { return ccw_decision(q[0], q[1], q[2], q[3]); }));
        EXPECT_EQ(ccw(p[1], p[0], p[2], p[3]), -expected);
        EXPECT_EQ(ccw(p[0], p[1], p[3], p[2]), -expected);
        if (trial % 8 != 0) continue;
        ASSERT_TRUE(says(p, expected, [](const auto& q) {
            return predicates::decide<Arithmetic::multiprecision, predicates::Ccw3>(q[0], q[1],
                                                                                    q[2], q[3]);
        }));
    }
}
TEST_P(SpacePredicates, InSphereOfPoints) {
    test_in_sphere<Point3>(5000);
}
TEST_P(SpacePredicates, InSphereOfWeights) {
    test_in_sphere<power::Site3>(5000);
}
TEST_P(SpacePredicates, InSphereOfRadii) {
    test_in_sphere<Site3>(5000);
}

INSTANTIATE_TEST_SUITE_P(Families, SpacePredicates, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

/// Which stages answer, of what.
template <class S>
std::map<Stage, int> stages_of(Sites (*draw)(Random&)) {
    Random random(7);
    std::map<Stage, int> count;
    for (int trial = 0; trial < 2000; ++trial) {
        auto s = first<S, 5>(draw(random));
        const Sign turn = ccw(centre3(s[0]), centre3(s[1]), centre3(s[2]), centre3(s[3]));
        if (turn == 0) continue;
        if (turn < 0) std::swap(s[0], s[1]);
        ++count[power::in_sphere_decision(s[0], s[1], s[2], s[3], s[4]).stage];
    }
    return count;
}
TEST(SpaceStages, TheFilterTellsNearlyAll) {
    EXPECT_GE(stages_of<Point3>(random_sites)[Stage::filter], 1995);
    EXPECT_GE(stages_of<Site3>(random_sites)[Stage::filter], 1995);
}
TEST(SpaceStages, IntegersTellTies) {
    const auto tenths = [](Random& g) { return off_grid(lattice(g)); };
    for (const auto& count : {stages_of<Point3>(cospherical), stages_of<Point3>(tenths),
                              stages_of<Site3>(lattice), stages_of<power::Site3>(lattice)}) {
        EXPECT_GT(count.at(Stage::exact), 100);
        EXPECT_LT(count.contains(Stage::multiprecision) ? count.at(Stage::multiprecision) : 0, 10);
    }
}
TEST(SpaceStages, CornersOfABoxNeedNoNumbers) {
    auto count = stages_of<Point3>(box_corners);
    EXPECT_GT(count[Stage::exact], 100);
    EXPECT_EQ(count[Stage::multiprecision], 0);
}
TEST(SpaceStages, DoubleDoublesTellWhatIsNearlyTied) {
    const auto count =
        stages_of<Site3>([](Random& g) { return moved_all(g, off_grid(cospherical(g))); });
    EXPECT_GT(count.at(Stage::refine), 100);
}
TEST(SpaceStages, RationalsTellTheRest) {
    EXPECT_GT(stages_of<Point3>(mixed)[Stage::multiprecision], 20);
    const auto ties = stages_of<Point3>(
        [](Random& g) { return changed(box_corners(g), [](double v) { return v * 0x1p-400; }); });
    EXPECT_GT(ties.at(Stage::multiprecision), 100);
}

}  // namespace
}  // namespace signum
