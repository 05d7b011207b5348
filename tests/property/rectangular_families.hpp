#pragma once
/// Cubes and octahedra of space made to break the predicates of the supremum and the Manhattan
/// metric, and what rationals say of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>

#include "../../predicates/space/rectangular.hpp"
#include "../../triangulation/metric.hpp"
#include "../oracle/linear_system.hpp"
#include "../oracle/rectangular_space.hpp"
#include "ball_families.hpp"

namespace signum {

/// The functions of both metrics, under the names of the tests.
struct SupremumSpace {
    using Metric = Supremum;
    static constexpr auto metric = oracle::RectangularMetric::supremum;
    static constexpr int facets = 6;
    static constexpr int most_spheres = 2;
    static constexpr auto& spheres = supremum::spheres;
    static constexpr auto& in_sphere = supremum::in_sphere;
    static constexpr auto& in_sphere_decision = supremum::in_sphere_decision;
    static constexpr auto& hides_decision = supremum::hides_decision;
    static bool hidden(const Site3& q, const Site3& i) { return supremum::hidden(q, i); }
    /// +x, -x, +y, ...
    static int normal(int facet, int axis) {
        return facet / 2 == axis ? (facet % 2 == 0 ? 1 : -1) : 0;
    }
    static double norm(const double (&v)[3]) {
        return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
    }
};
struct ManhattanSpace {
    using Metric = Manhattan;
    static constexpr auto metric = oracle::RectangularMetric::manhattan;
    static constexpr int facets = 8;
    static constexpr int most_spheres = 6;
    static constexpr auto& spheres = manhattan::spheres;
    static constexpr auto& in_sphere = manhattan::in_sphere;
    static constexpr auto& in_sphere_decision = manhattan::in_sphere_decision;
    static constexpr auto& hides_decision = manhattan::hides_decision;
    static bool hidden(const Site3& q, const Site3& i) { return manhattan::hidden(q, i); }
    /// +++, ++-, +-+, ...
    static int normal(int facet, int axis) { return (facet >> (2 - axis) & 1) != 0 ? -1 : 1; }
    static double norm(const double (&v)[3]) {
        return std::fabs(v[0]) + std::fabs(v[1]) + std::fabs(v[2]);
    }
};

namespace rectangular_families {

using ball_families::changed;
using ball_families::each;
using ball_families::moved_all;
using ball_families::moved_once;
using ball_families::off_grid;

/// Sites that touch one sphere from outside, in facets, edges and corners.
template <class Space>
struct AroundOneSphere {
    double origin[3];
    double rho;
    int reach;

    explicit AroundOneSphere(Random& g) : rho(g.between(-3, 30)), reach(g.coin() ? 2 : 40) {
        for (double& x : origin) x = g.below(3) == 0 ? g.between(-1000, 1000) * 0x1p20 : 0.0;
    }
    [[nodiscard]] AnyBall draw(Random& g) const {
        double v[3];
        for (double& x : v) x = g.between(-reach, reach);
        if (g.below(4) == 0) v[g.below(3)] = std::copysign(v[g.below(3)], g.sign());
        return {{origin[0] + v[0], origin[1] + v[1], origin[2] + v[2]}, Space::norm(v) - rho};
    }
};
template <class Space>
AnyBalls tangent(Random& g, int) {
    const AroundOneSphere<Space> sphere(g);
    return each([&] { return sphere.draw(g); });
}
/// Sites that hide others, touch them from inside, or are equal.
template <class Space>
AnyBalls nested(Random& g, int d) {
    AnyBalls balls = g.coin() ? tangent<Space>(g, d) : ball_families::lattice(g, d);
    for (std::size_t m = 1; m < 5; ++m) {
        if (g.below(3) == 0) continue;
        AnyBall ball = balls[static_cast<std::size_t>(g.below(static_cast<int>(m)))];
        double v[3];
        for (double& x : v) x = g.between(-2, 2);
        for (int k = 0; k < 3; ++k) ball.x[k] += v[k];
        ball.r -= Space::norm(v);
        if (g.below(4) == 0) ball.r -= g.between(-1, 1);
        balls[m] = ball;
    }
    return balls;
}
/// Numbers of 1, 2 and 4 units: ties everywhere.
inline AnyBalls cramped(Random& g, int) {
    const auto one = [&] { return 1.0 * g.below(2); };
    return each([&] { return AnyBall{{one(), one(), one()}, 0.5 * g.below(3)}; });
}
/// Small radii differ, coordinates are shared.
inline AnyBalls sharing(Random& g, int d) {
    AnyBalls balls = ball_families::random_balls(g, d);
    for (std::size_t m = 1; m < 5; ++m)
        for (int k = 0; k < 3; ++k)
            if (g.coin()) balls[m].x[k] = balls[m - 1].x[k];
    if (g.coin())
        for (AnyBall& b : balls) b.r = balls[0].r;
    return balls;
}
template <class Space>
AnyBalls rescaled_tangent(Random& g, int d) {
    return ball_families::rescaled(g, tangent<Space>(g, d));
}

/// Where denormals begin, which some environments read as zero.
template <class Space>
AnyBalls half_denormal(Random& g, int d) {
    const AnyBalls balls =
        g.coin() ? ball_families::random_balls(g, d) : off_grid(tangent<Space>(g, d));
    const int exponent = g.between(-1026, -1019);
    return changed(balls, [&](double v) { return std::ldexp(v, exponent); });
}

struct Family {
    const char* name;
    AnyBalls (*draw)(Random&, int dimension);
    double share;  // of the trials
};
inline void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

template <class Space>
inline constexpr Family families[] = {
    {"random", ball_families::random_balls, 1},
    {"lattice", ball_families::lattice, 1},
    {"cramped", cramped, 1},
    {"sharing", sharing, 1},
    {"wide_lattice", ball_families::wide_lattice, 1},
    {"nearly_lattice", [](Random& g, int d) { return moved_all(g, ball_families::lattice(g, d)); },
     1},
    {"equal_radii", ball_families::equal_radii, 1},
    {"tangent", tangent<Space>, 2},
    {"tangent_moved_once", [](Random& g, int d) { return moved_once(g, tangent<Space>(g, d)); }, 2},
    {"nearly_tangent", [](Random& g, int d) { return moved_all(g, tangent<Space>(g, d)); }, 1},
    {"nearly_tangent_off_grid",
     [](Random& g, int d) { return moved_all(g, off_grid(tangent<Space>(g, d))); }, 1},
    {"nested", nested<Space>, 1},
    {"nearly_nested", [](Random& g, int d) { return moved_all(g, nested<Space>(g, d)); }, 1},
    {"mixed", ball_families::mixed, 0.5},
    {"raw", ball_families::raw, 0.3},
    {"huge", ball_families::huge, 0.5},
    {"denormal", ball_families::denormal, 1},
    {"half_denormal", half_denormal<Space>, 1},
    {"random_rescaled",
     [](Random& g, int d) { return ball_families::rescaled(g, ball_families::random_balls(g, d)); },
     0.5},
    {"tangent_rescaled", rescaled_tangent<Space>, 0.5},
    {"nearly_tangent_rescaled",
     [](Random& g, int d) { return moved_all(g, rescaled_tangent<Space>(g, d)); }, 0.5},
};

}  // namespace rectangular_families

// ---- in rationals ------------------------------------------------------------------------------

/// The sphere whose facets the sites of the contacts pin: n·c + rho = n·c_m - r_m.
template <class Space>
oracle::RectangularSphere<3> sphere_of(const rectangular::Contacts& contacts,
                                       const oracle::BallTuple<3>& sites) {
    std::vector<oracle::RationalVector> rows;
    for (std::size_t t = 0; t < 4; ++t) {
        const auto& site = sites[contacts.sites[t]];
        oracle::RationalVector& row = rows.emplace_back();
        oracle::Rational value = -site.r;
        for (int axis = 0; axis < 3; ++axis) {
            const int n = Space::normal(contacts.facets[t], axis);
            row.emplace_back(n);
            value += n * site.c[static_cast<std::size_t>(axis)];
        }
        row.emplace_back(1);
        row.push_back(value);
    }
    const auto flat = oracle::solutions(std::move(rows), 4);
    if (!flat || !flat->directions.empty()) throw std::logic_error("contacts of no sphere");
    return {{flat->point[0], flat->point[1], flat->point[2]}, flat->point[3]};
}

/// The facets in which a site touches the sphere; the first is the highest of the bits.
template <class Space>
unsigned touched_facets(const oracle::RectangularSphere<3>& sphere,
                        const oracle::SpaceBall<3>& site) {
    unsigned set = 0;
    for (int facet = 0; facet < Space::facets; ++facet) {
        oracle::Rational sum = -site.r - sphere.rho;
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            sum += Space::normal(facet, axis) * (site.c[k] - sphere.c[k]);
        }
        set = set << 1U | static_cast<unsigned>(sum.is_zero());
    }
    return set;
}
template <class Space>
unsigned touched_facets(const oracle::RectangularSphere<3>& sphere,
                        const oracle::BallTuple<3>& sites) {
    unsigned set = 0;
    for (const auto& site : sites) set |= touched_facets<Space>(sphere, site);
    return set;
}

}  // namespace signum
