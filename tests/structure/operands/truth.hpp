#pragma once
/// What the predicates of operands.cpp should have answered, in rationals. Compiled with the
/// project's own flags and out of line, so that operands arrive as doubles.

#include "../../../core/sign.hpp"
#include "../../../core/site.hpp"

namespace truth {

using signum::Point;
using signum::Point3;
using signum::Sign;
using signum::Site;
using signum::Site3;

/// For Point, power::Site and Site.
template <class S>
Sign ccw(const S& a, const S& b, const S& c);
template <class S>
Sign in_circle(const S& i, const S& j, const S& k, const S& q);
template <class S>
Sign in_circle_infinite(const S& a, const S& b, const S& q);
template <class S>
Sign nearer(const Point& p, const S& a, const S& b);

/// For Point3, power::Site3 and Site3.
template <class S>
Sign ccw(const S& a, const S& b, const S& c, const S& d);
template <class S>
Sign in_sphere(const S& i, const S& j, const S& k, const S& l, const S& q);

/// The predicates of a metric with additive weights, all of them perturbed; the sites come in the
/// order of their ranks. Metric: what the library calls Perturbed<Arithmetic::exact>.
template <class Metric>
struct Additive {
    static bool hides(const Site& i, const Site& q);
    static bool nearer(const Point& p, const Site& a, const Site& b);
    static bool exists(const Site& i, const Site& j, const Site& k);
    static bool exists_twice(const Site& i, const Site& j, const Site& k);
    static bool precedes_on_bisector(const Site& i, const Site& j, const Site& q, const Site& k);
    static bool in_circle(const Site& i, const Site& j, const Site& k, const Site& q);
    static bool in_circle_infinite(const Site& a, const Site& b, const Site& q);
};

}  // namespace truth
