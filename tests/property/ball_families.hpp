#pragma once
/// Balls made to break the predicates of the metric |x-c| - r, in the plane and in space, and what
/// the oracle says of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

#include "../../core/site.hpp"
#include "../oracle/balls_space.hpp"
#include "raw_doubles.hpp"

namespace signum {

/// Coordinates, of which the plane looks at the first two, and the radius.
struct AnyBall {
    double x[3];
    double r;
};
/// d+1 balls and a query; in the plane the last but one is left out.
using AnyBalls = std::array<AnyBall, 5>;

template <class S>
inline constexpr int dimension_of = std::is_same_v<S, Site3> ? 3 : 2;
template <class S>
using SitesOf = std::array<S, dimension_of<S> + 2>;

inline Site site_of(const AnyBall& b, Site) {
    return {b.x[0], b.x[1], b.r};
}
inline Site3 site_of(const AnyBall& b, Site3) {
    return {b.x[0], b.x[1], b.x[2], b.r};
}
/// The query is the last.
template <class S>
SitesOf<S> sites_of(const AnyBalls& balls) {
    SitesOf<S> sites;
    for (std::size_t m = 0; m + 1 < sites.size(); ++m) sites[m] = site_of(balls[m], S());
    sites.back() = site_of(balls.back(), S());
    return sites;
}

namespace ball_families {

template <class Draw>
AnyBalls each(const Draw& draw) {
    AnyBalls balls;
    for (AnyBall& b : balls) b = draw();
    return balls;
}
template <class Change>
AnyBalls changed(AnyBalls balls, const Change& change) {
    for (AnyBall& b : balls)
        for (double* number : {&b.x[0], &b.x[1], &b.x[2], &b.r}) *number = change(*number);
    return balls;
}
inline double finite(double value) {
    return std::isfinite(value) ? value : std::copysign(std::numeric_limits<double>::max(), value);
}
inline AnyBalls moved_all(Random& g, const AnyBalls& balls) {
    return changed(balls, [&](double v) { return moved(g, v); });
}
/// One number of one ball, by one step.
inline AnyBalls moved_once(Random& g, AnyBalls balls) {
    AnyBall& b = balls[static_cast<std::size_t>(g.below(5))];
    double* const numbers[] = {&b.x[0], &b.x[1], &b.x[2], &b.r};
    double& number = *numbers[g.below(4)];
    number = finite(std::nextafter(number, g.coin() ? HUGE_VAL : -HUGE_VAL));
    return balls;
}
inline AnyBalls off_grid(const AnyBalls& balls) {
    return changed(balls, [](double v) { return v * 0.1; });
}

inline AnyBalls random_balls(Random& g, int) {
    const double most = g.coin() ? 0.3 : 1.0;
    const auto one = [&] { return 2 * g.real() - 1; };
    return each([&] { return AnyBall{{one(), one(), one()}, most * one()}; });
}
inline AnyBalls lattice(Random& g, int) {
    const auto one = [&] { return 1.0 * g.below(4); };
    return each([&] { return AnyBall{{one(), one(), one()}, 0.5 * g.between(-1, 1)}; });
}
inline AnyBalls wide_lattice(Random& g, int) {
    const double far = 0x1p40 * g.below(2);
    const auto one = [&] { return far + g.between(-(1 << 18), 1 << 18); };
    return each([&] { return AnyBall{{one(), one(), one()}, 1.0 * g.between(-9, 9)}; });
}
inline AnyBalls equal_radii(Random& g, int d) {
    AnyBalls balls = g.coin() ? lattice(g, d) : random_balls(g, d);
    for (AnyBall& b : balls) b.r = balls[0].r;
    return balls;
}
/// An integer vector of integer length.
struct Pythagorean {
    double x[3];
    double length;
};
inline Pythagorean pythagorean(Random& g, int d) {
    static constexpr Pythagorean in_plane[] = {{{1, 0, 0}, 1},   {{3, 4, 0}, 5},
                                               {{5, 12, 0}, 13}, {{8, 15, 0}, 17},
                                               {{7, 24, 0}, 25}, {{20, 21, 0}, 29}};
    static constexpr Pythagorean in_space[] = {{{1, 0, 0}, 1}, {{2, 2, 1}, 3},  {{8, 4, 1}, 9},
                                               {{7, 4, 4}, 9}, {{6, 3, 2}, 7},  {{6, 6, 3}, 9},
                                               {{3, 4, 0}, 5}, {{9, 6, 2}, 11}, {{7, 6, 6}, 11}};
    Pythagorean v = d == 2 ? g.any(in_plane) : g.any(in_space);
    std::swap(v.x[0], v.x[g.below(d)]);
    if (d == 3) std::swap(v.x[1], v.x[1 + g.below(2)]);
    for (double& x : v.x) x *= g.sign();
    return v;
}
/// Exact ties: balls that touch one sphere from outside at points with rational coordinates.
struct AroundOneSphere {
    double origin[3];
    double rho;
    int dimension;

    AroundOneSphere(Random& g, int d) : rho(g.between(-3, 30)), dimension(d) {
        for (double& x : origin) x = g.below(3) == 0 ? g.between(-1000, 1000) * 0x1p20 : 0.0;
    }
    [[nodiscard]] AnyBall draw(Random& g) const {
        const Pythagorean v = pythagorean(g, dimension);
        const double times = g.below(8) == 0 ? 0 : g.between(1, 5);
        return {
            {origin[0] + times * v.x[0], origin[1] + times * v.x[1], origin[2] + times * v.x[2]},
            times * v.length - rho};
    }
};
inline AnyBalls tangent(Random& g, int d) {
    const AroundOneSphere sphere(g, d);
    return each([&] { return sphere.draw(g); });
}
/// The same, but the query, and others now and then, on the other half of the cone: |c - c_q| =
/// -(rho + r_q). Every ball hides it, and may touch it.
inline AnyBalls other_half(Random& g, int d) {
    const AroundOneSphere sphere(g, d);
    AnyBalls balls = each([&] { return sphere.draw(g); });
    const auto opposite = [&](AnyBall b) {
        for (int k = 0; k < 3; ++k) b.x[k] = 2 * sphere.origin[k] - b.x[k];
        b.r = -b.r - 2 * sphere.rho;
        return b;
    };
    balls[4] = opposite(balls[static_cast<std::size_t>(g.below(5))]);
    AnyBall& other = balls[static_cast<std::size_t>(g.below(4))];
    if (g.below(4) == 0) other = opposite(other);
    return balls;
}
/// Balls that touch one another from inside, are equal, or lie in one another.
inline AnyBalls nested(Random& g, int d) {
    AnyBalls balls = g.coin() ? tangent(g, d) : lattice(g, d);
    for (std::size_t m = 1; m < 5; ++m) {
        if (g.below(3) == 0) continue;
        const Pythagorean v = pythagorean(g, d);
        const int times = g.between(-1, 3);
        const AnyBall& outer = balls[static_cast<std::size_t>(g.below(static_cast<int>(m)))];
        AnyBall ball = outer;
        for (int k = 0; k < 3; ++k) ball.x[k] += times * v.x[k];
        ball.r -= std::abs(times) * v.length;
        if (g.below(4) == 0) ball.r -= g.between(-1, 1);
        balls[m] = ball;
    }
    return balls;
}
/// Centres on one line; radii along it, too, now and then.
inline AnyBalls coaxial(Random& g, int d) {
    const Pythagorean v = pythagorean(g, d);
    const int slope = g.between(-2, 2);
    return each([&] {
        const double s = g.between(-4, 4);
        const double r = g.coin() ? slope * s * v.length / 2 : 1.0 * g.between(-5, 5);
        return AnyBall{{s * v.x[0], s * v.x[1], s * v.x[2]}, r};
    });
}
/// Centre and radius in a plane of the space of both: where spheres are none, or infinitely many.
inline AnyBalls flat(Random& g, int d) {
    const Pythagorean u = pythagorean(g, d);
    const Pythagorean v = pythagorean(g, d);
    const double height_u = g.coin() ? u.length : g.between(-2, 2);
    const double height_v = g.coin() ? -v.length : g.between(-2, 2);
    const int kind = g.below(3);
    return each([&] {
        double s = g.between(-3, 3);
        double t = g.between(-3, 3);
        if (kind == 0) (g.coin() ? s : t) = 0;  // on two lines
        if (kind == 1) t = s * s;               // on a parabola
        return AnyBall{{s * u.x[0] + t * v.x[0], s * u.x[1] + t * v.x[1], s * u.x[2] + t * v.x[2]},
                       s * height_u + t * height_v};
    });
}
/// A common tangent plane: one root is at infinity.
inline AnyBalls on_floor(Random& g, int d) {
    return each([&] {
        AnyBall b{{1.0 * g.between(-5, 5), 1.0 * g.between(-5, 5), 1.0 * g.between(-5, 5)}, 0};
        const double r = g.between(0, 4);
        b.x[d - 1] = r;
        b.r = r;
        return b;
    });
}
/// The same, the query free.
inline AnyBalls over_floor(Random& g, int d) {
    AnyBalls balls = on_floor(g, d);
    balls[4] = lattice(g, d)[4];
    return balls;
}
/// Raw bit patterns, or nearly so: any exponent.
inline AnyBalls raw(Random& g, int) {
    const auto pick = [&] {
        return finite(g.sign() * std::ldexp(g.significand(), g.between(-1074, 1023)));
    };
    return each([&] { return AnyBall{{pick(), pick(), pick()}, pick()}; });
}
/// The same, a few exponents.
inline AnyBalls mixed(Random& g, int) {
    static constexpr int exponents[] = {-1074, -1073, -1023, -1022, -600, -301, -150, -82, -81,
                                        -80,   -79,   -53,   0,     1,    53,   78,   79,  80,
                                        81,    120,   150,   300,   600,  1022, 1023};
    const int kinds = g.between(1, 4);
    std::array<double, 4> values;
    for (double& v : values) v = g.sign() * std::ldexp(g.significand(), g.any(exponents));
    const auto pick = [&] {
        const double v = g.below(5) == 0 ? 0.0 : values[static_cast<std::size_t>(g.below(kinds))];
        return finite(g.sign() * (g.below(3) == 0 ? v * g.between(1, 3) : v));
    };
    return each([&] { return AnyBall{{pick(), pick(), pick()}, g.coin() ? 0.0 : pick()}; });
}
inline AnyBalls huge(Random& g, int) {
    const auto pick = [&] { return g.sign() * std::ldexp(g.significand(), g.between(1018, 1023)); };
    return each([&] { return AnyBall{{pick(), pick(), pick()}, g.coin() ? 0.0 : pick() / 8}; });
}
inline AnyBalls denormal(Random& g, int) {
    const auto pick = [&] { return g.between(-4, 4) * 0x1p-1074; };
    return each([&] { return AnyBall{{pick(), pick(), pick()}, pick() / 2}; });
}
/// Every number times a power of two, near the places where something happens.
inline AnyBalls rescaled(Random& g, const AnyBalls& balls) {
    static constexpr int places[] = {-1060, -1022, -600, -301, -178, -170, -153, -134, -132,
                                     -127,  -107,  -100, -84,  -82,  -80,  -78,  70,   74,
                                     76,    78,    80,   100,  300,  600,  1000, 1013};
    const int exponent = g.any(places) + g.between(-1, 1);
    return changed(balls, [&](double v) { return finite(std::ldexp(v, exponent)); });
}

struct Family {
    const char* name;
    AnyBalls (*draw)(Random&, int dimension);
    double share;  // of the trials; those that mostly end in rationals get fewer
};
inline void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

inline constexpr Family families[] = {
    {"random", random_balls, 1},
    {"lattice", lattice, 1},
    {"wide_lattice", wide_lattice, 1},
    {"nearly_lattice", [](Random& g, int d) { return moved_all(g, lattice(g, d)); }, 1},
    {"equal_radii", equal_radii, 1},
    {"tangent", tangent, 2},
    {"tangent_moved_once", [](Random& g, int d) { return moved_once(g, tangent(g, d)); }, 2},
    {"nearly_tangent", [](Random& g, int d) { return moved_all(g, tangent(g, d)); }, 1},
    {"nearly_tangent_off_grid",
     [](Random& g, int d) { return moved_all(g, off_grid(tangent(g, d))); }, 1},
    {"other_half", other_half, 1},
    {"nearly_other_half", [](Random& g, int d) { return moved_all(g, off_grid(other_half(g, d))); },
     0.5},
    {"nested", nested, 1},
    {"nearly_nested", [](Random& g, int d) { return moved_all(g, nested(g, d)); }, 1},
    {"coaxial", coaxial, 1},
    {"flat", flat, 1},
    {"nearly_flat", [](Random& g, int d) { return moved_all(g, flat(g, d)); }, 1},
    {"on_floor", on_floor, 1},
    {"over_floor", over_floor, 1},
    {"nearly_on_floor", [](Random& g, int d) { return moved_all(g, on_floor(g, d)); }, 1},
    {"mixed", mixed, 0.5},
    {"raw", raw, 0.3},
    {"huge", huge, 0.3},
    {"denormal", denormal, 0.5},
    {"random_rescaled", [](Random& g, int d) { return rescaled(g, random_balls(g, d)); }, 0.5},
    {"tangent_rescaled", [](Random& g, int d) { return rescaled(g, tangent(g, d)); }, 0.5},
    {"nearly_tangent_rescaled",
     [](Random& g, int d) { return rescaled(g, moved_all(g, tangent(g, d))); }, 0.5},
    {"nested_rescaled", [](Random& g, int d) { return rescaled(g, nested(g, d)); }, 0.3},
};

}  // namespace ball_families

// ---- the oracle --------------------------------------------------------------------------------

/// All but the query.
template <class S>
oracle::BallTuple<dimension_of<S>> tuple_of(const SitesOf<S>& sites) {
    oracle::BallTuple<dimension_of<S>> tuple;
    for (std::size_t m = 0; m < tuple.size(); ++m) tuple[m] = oracle::exact_ball(sites[m]);
    return tuple;
}
/// The orientation as ccw has it, of which the oracle's is the opposite in space.
template <int d>
int turn_of(const oracle::TouchingSphere<d>& sphere) {
    return d == 2 ? sphere.orientation : -sphere.orientation;
}
/// The one whose points of contact are positively oriented, if there is one.
template <int d>
const oracle::TouchingSphere<d>* positive(const oracle::TouchingSpheres<d>& spheres) {
    for (const auto& sphere : spheres.spheres)
        if (turn_of(sphere) > 0) return &sphere;
    return nullptr;
}

template <class S>
std::string text_of(const SitesOf<S>& sites) {
    std::string result;
    for (const S& s : sites) {
        double z = 0.0;
        if constexpr (requires { s.z; }) z = s.z;
        char buffer[160];
        std::snprintf(buffer, sizeof buffer, "{%a, %a, %a, %a} ", s.x, s.y, z, s.r);
        result += buffer;
    }
    return result;
}

}  // namespace signum
