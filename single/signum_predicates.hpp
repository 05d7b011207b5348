// signum: signs of geometric predicates that are never wrong.
// Made by single/make.py of version 0.1.0: edit the rooms that it names, not this file.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The signum authors
#ifndef SIGNUM_PREDICATES_HPP
#define SIGNUM_PREDICATES_HPP
#if defined(__cplusplus) && __cplusplus < 201703L
#error "signum needs C++17: compile with -std=c++17"
#endif
/* Compile signum_predicates.cpp beside your program: g++ -O2 mine.cpp signum_predicates.cpp. There
 * is no library to link, and nothing to start or to free. Everything is exact for all finite doubles, in every
 * rounding mode, with denormals flushed, in any number of threads.
 *
 * C, Rust, Fortran and others call the functions of C below. C++17 has points of any type beside
 * them, at the end of this file. */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t signum_metric;
enum {
    SIGNUM_POWER = 0,      ///< |p - c|^2 - r^2; points have Delaunay's triangulation
    SIGNUM_EUCLIDEAN = 1,  ///< |p - c| - r
    SIGNUM_MANHATTAN = 2,  ///< the same in the norm |x| + |y|
    SIGNUM_SUPREMUM = 3    ///< the same in the norm max(|x|, |y|)
};


// ---- predicates --------------------------------------------------------------------------------
//
// They answer -1, 0 or +1, or yes (1) and no (0), exactly for all finite doubles; and
// SIGNUM_NO_SIGN for a null pointer, a number that is not finite, a metric that there is not. O(1).
// The last stages claim a few kilobytes; where there are none the program ends.
//
// A site is {x, y, r}, in space {x, y, z, r}. Names that end in _points take {x, y} and {x, y, z},
// those that end in _weights {x, y, w} and {x, y, z, w}, both in the power metric.

#define SIGNUM_NO_SIGN (-2)

/// +1 where a, b, c turn counterclockwise, 0 where they are collinear, -1 otherwise.
int signum_ccw(const double a[2], const double b[2], const double c[2]);
/// Whether a circle (diamond, square) touches i, j, k counterclockwise, ties decided by the tie
/// rule; in the power metric whether ccw of their centres is +1.
int signum_exists(signum_metric metric, const double i[3], const double j[3], const double k[3]);
/// +1 where q conflicts with the vertex of i, j, k (is nearer than they are), 0 where it touches,
/// -1 otherwise. Preconditions: signum_exists(i, j, k), and q is hidden by none of them. Where they
/// do not hold any sign may be told; a library built with assertions ends the program, here and
/// below.
int signum_in_circle(signum_metric metric, const double i[3], const double j[3], const double k[3],
                     const double q[3]);
int signum_in_circle_points(const double i[2], const double j[2], const double k[2],
                            const double q[2]);
int signum_in_circle_weights(const double i[3], const double j[3], const double k[3],
                             const double q[3]);
/// The same at the hull edge a -> b, all other sites on its left. Preconditions: neither of a and b
/// hides the other; in the power metric their centres differ.
int signum_in_circle_infinite(signum_metric metric, const double a[3], const double b[3],
                              const double q[3]);
int signum_in_circle_infinite_points(const double a[2], const double b[2], const double q[2]);
int signum_in_circle_infinite_weights(const double a[3], const double b[3], const double q[3]);
/// signum_in_circle under the tie rule, never 0; q may be hidden. `ranks` are the places of i, j, k
/// and q in the rule's order: falling radius (power metric: weight, the square of it), rising x, y,
/// index. Only their order counts.
int signum_in_circle_perturbed(signum_metric metric, const double i[3], const double j[3],
                               const double k[3], const double q[3], const int32_t ranks[4]);
int signum_in_circle_infinite_perturbed(signum_metric metric, const double a[3], const double b[3],
                                        const double q[3], const int32_t ranks[3]);
/// Whether i alone hides q: covers it, the same place and size included.
int signum_hidden(signum_metric metric, const double q[3], const double i[3]);
int signum_hidden_weights(const double q[3], const double i[3]);
/// +1 where the point p is nearer to a than to b, -1 where it is not; where both are as near 0 in
/// the power metric, elsewhere as the tie rule says.
int signum_nearer(signum_metric metric, const double p[2], const double a[3], const double b[3]);
int signum_nearer_weights(const double p[2], const double a[3], const double b[3]);

/// +1 where det(b-a, c-a, d-a) > 0, 0 where the four are coplanar, -1 otherwise.
int signum_ccw_space(const double a[3], const double b[3], const double c[3], const double d[3]);

/// In the power metric, without a look at whether it exists: the precondition is that
/// signum_ccw_space(i, j, k, l) is +1.
int signum_in_sphere_points(const double i[3], const double j[3], const double k[3],
                            const double l[3], const double q[3]);
int signum_in_sphere_weights(const double i[4], const double j[4], const double k[4],
                             const double l[4], const double q[4]);
/// In the power metric: +1 where the point p is nearer to a than to b, 0 where both are as near, -1
/// otherwise.
int signum_nearer_space(const double p[3], const double a[4], const double b[4]);

/// signs[m] = signum_ccw of row m of a, b and c, for `count` rows of two numbers each, by vectors
/// where the library has them. SIGNUM_NO_SIGN, and nothing is written, for a null pointer or a
/// number that is not finite; 0 otherwise. O(count).
int signum_ccw_batch(const double* a, const double* b, const double* c, size_t count,
                     int8_t* signs);
/// The same of signum_in_circle_points.
int signum_in_circle_points_batch(const double* i, const double* j, const double* k,
                                  const double* q, size_t count, int8_t* signs);

/// The sign of terms[0] + terms[1] + ..., fewer than 2^32 of them. O(count log count) at most;
/// allocates only above 512 terms, and where it cannot the program ends.
int signum_sign_of_sum(const double* terms, size_t count);

#ifdef __cplusplus
}

#include <type_traits>

namespace signum {

/// How a type of yours tells its coordinates, where it has neither x and y, nor x() and y(), nor
/// [0] and [1]:
///     template <> struct signum::coordinates<Mine> {
///         static double at(const Mine& p, int k) { return ...; }   // k is 0, 1 or 2
///     };
template <class P, class = void>
struct coordinates;

// Beside the library, whose functions have these names, too.
inline namespace alone {

/// -1, 0 or +1.
using Sign = int;

struct Point {
    double x, y;
};
struct Point3 {
    double x, y, z;
};
/// A disc (diamond, square). In the power metric its weight is r^2.
struct Site {
    double x, y, r;
};

namespace reading {

template <class P, class = void>
struct Told : std::false_type {};
template <class P>
struct Told<P, std::void_t<decltype(coordinates<P>::at(std::declval<const P&>(), 0))>>
    : std::true_type {};
#define SIGNUM_READABLE(Name, expression) \
    template <class P, class = void>      \
    struct Name : std::false_type {};     \
    template <class P>                    \
    struct Name<P, std::void_t<decltype(expression)>> : std::true_type {};
SIGNUM_READABLE(Named, std::declval<const P&>().x + std::declval<const P&>().y)
SIGNUM_READABLE(Called, std::declval<const P&>().x() + std::declval<const P&>().y())
SIGNUM_READABLE(Indexed, std::declval<const P&>()[0] + 0)
SIGNUM_READABLE(WithRadius, std::declval<const P&>().r + 0)
#undef SIGNUM_READABLE

/// The number itself, as a double; what a double cannot hold does not compile.
template <class Number>
[[nodiscard]] inline double exact_double(Number number) noexcept {
    static_assert(
        std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>,
        "signum: a coordinate must be a float, a double or an integer of at most 32 bits");
    static_assert(!std::is_floating_point_v<Number> || sizeof(Number) <= sizeof(double),
                  "signum: a long double would be rounded to a double, and the sign be another "
                  "one's");
    static_assert(
        !std::is_integral_v<Number> || sizeof(Number) <= 4,
        "signum: integers of 64 bits may be no doubles: convert those that are below 2^53");
    if constexpr (std::is_same_v<Number, float>) {
        // Where denormals are flushed a conversion would read one as 0.
        uint32_t bits = 0;
        memcpy(&bits, &number, sizeof bits);
        if ((bits & 0x7f800000U) == 0) {
            const double size = static_cast<double>(static_cast<int32_t>(bits & 0x7fffffU)) * 0x1p-149;
            return (bits >> 31U) != 0 ? -size : size;
        }
    }
    return static_cast<double>(number);
}
template <class P>
[[nodiscard]] double coordinate(const P& p, int k) noexcept {
    if constexpr (Told<P>::value) {
        return exact_double(coordinates<P>::at(p, k));
    } else if constexpr (Named<P>::value) {
        return exact_double(k == 0 ? p.x : p.y);
    } else if constexpr (Called<P>::value) {
        return exact_double(k == 0 ? p.x() : p.y());
    } else {
        static_assert(Indexed<P>::value,
                      "signum: a point needs members x and y, x() and y(), or [0] and [1], or a "
                      "specialization of signum::coordinates");
        return exact_double(p[k]);
    }
}
template <class P>
[[nodiscard]] double third(const P& p) noexcept {
    if constexpr (Told<P>::value) {
        return exact_double(coordinates<P>::at(p, 2));
    } else if constexpr (Named<P>::value) {
        return exact_double(p.z);
    } else if constexpr (Called<P>::value) {
        return exact_double(p.z());
    } else {
        return exact_double(p[2]);
    }
}
struct Two {
    double numbers[2];
    template <class P>
    Two(const P& p) noexcept : numbers{coordinate(p, 0), coordinate(p, 1)} {}
};
struct Three {
    double numbers[3];
    template <class P>
    Three(const P& p) noexcept : numbers{coordinate(p, 0), coordinate(p, 1), third(p)} {}
};
/// x, y and the radius: r, or [2].
struct Disc {
    double numbers[3];
    template <class P>
    Disc(const P& p) noexcept : numbers{coordinate(p, 0), coordinate(p, 1), radius(p)} {}
    template <class P>
    [[nodiscard]] static double radius(const P& p) noexcept {
        if constexpr (WithRadius<P>::value) {
            return exact_double(p.r);
        } else {
            static_assert(Told<P>::value || (!Named<P>::value && !Called<P>::value),
                          "signum: a site needs a member r, its radius");
            return third(p);
        }
    }
};

}  // namespace reading

// ---- points of any type ----

// Preconditions: finite coordinates. Otherwise signs are no_sign, and exists and hidden are false.
inline constexpr int no_sign = SIGNUM_NO_SIGN;

namespace reading {
/// The sign, or with the way -1 its opposite.
[[nodiscard]] constexpr Sign turned(Sign way, Sign sign) noexcept {
    return sign == no_sign ? sign : way * sign;
}
}  // namespace reading

/// +1 where a, b, c turn counterclockwise (c lies left of the line from a to b), 0 where they are
/// collinear, -1 otherwise.
template <class A, class B, class C>
[[nodiscard]] Sign ccw(const A& a, const B& b, const C& c) noexcept {
    return signum_ccw(reading::Two(a).numbers, reading::Two(b).numbers, reading::Two(c).numbers);
}
/// The sign of det(b-a, c-a, d-a): +1 where a, b, c turn counterclockwise seen from d, 0 where the
/// four lie in a plane, -1 otherwise.
template <class A, class B, class C, class D>
[[nodiscard]] Sign ccw(const A& a, const B& b, const C& c, const D& d) noexcept {
    return signum_ccw_space(reading::Three(a).numbers, reading::Three(b).numbers,
                            reading::Three(c).numbers, reading::Three(d).numbers);
}
/// The sign of the determinant of the rows (m - q, |m - q|^2), m = i, j, k: +1 where q lies inside
/// the circle and i, j, k turn counterclockwise, or outside and they turn clockwise.
template <class I, class J, class K, class Q>
[[nodiscard]] Sign in_circle_determinant(const I& i, const J& j, const K& k, const Q& q) noexcept {
    return signum_in_circle_points(reading::Two(i).numbers, reading::Two(j).numbers,
                                   reading::Two(k).numbers, reading::Two(q).numbers);
}
/// +1 where q lies inside the circle through i, j, k, whichever way they turn, 0 where it lies on
/// it, -1 where it lies outside; no_sign where they are collinear.
template <class I, class J, class K, class Q>
[[nodiscard]] Sign in_circle(const I& i, const J& j, const K& k, const Q& q) noexcept {
    const Sign turn = ccw(i, j, k);
    return turn == 1 || turn == -1 ? reading::turned(turn, in_circle_determinant(i, j, k, q))
                                   : no_sign;
}
/// The same in space: minus the determinant of the rows (m - q, |m - q|^2), m = i, j, k, l. +1
/// where q lies inside the sphere and ccw(i, j, k, l) > 0, or outside and it is < 0.
template <class I, class J, class K, class L, class Q>
[[nodiscard]] Sign in_sphere_determinant(const I& i, const J& j, const K& k, const L& l,
                                         const Q& q) noexcept {
    return signum_in_sphere_points(reading::Three(i).numbers, reading::Three(j).numbers,
                                   reading::Three(k).numbers, reading::Three(l).numbers,
                                   reading::Three(q).numbers);
}
/// +1 where q lies inside the sphere through i, j, k, l, whichever way they turn, 0 on it, -1
/// outside; no_sign where they lie in a plane.
template <class I, class J, class K, class L, class Q>
[[nodiscard]] Sign in_sphere(const I& i, const J& j, const K& k, const L& l, const Q& q) noexcept {
    const Sign turn = ccw(i, j, k, l);
    return turn == 1 || turn == -1 ? reading::turned(turn, in_sphere_determinant(i, j, k, l, q))
                                   : no_sign;
}
/// The exact sign of terms[0] + ... + terms[count - 1].
[[nodiscard]] inline Sign sign_of_sum(const double* terms, size_t count) noexcept {
    return signum_sign_of_sum(terms, count);
}

// ---- sites of any type, in four metrics ----

// A site has x, y and r, or [0], [1] and [2]. The functions of C above say what is answered.

/// The predicates of a metric.
template <signum_metric metric>
struct In {
    template <class I, class J, class K>
    [[nodiscard]] static bool exists(const I& i, const J& j, const K& k) noexcept {
        return signum_exists(metric, of(i), of(j), of(k)) == 1;
    }
    template <class I, class J, class K, class Q>
    [[nodiscard]] static Sign in_circle(const I& i, const J& j, const K& k, const Q& q) noexcept {
        return signum_in_circle(metric, of(i), of(j), of(k), of(q));
    }
    template <class A, class B, class Q>
    [[nodiscard]] static Sign in_circle_infinite(const A& a, const B& b, const Q& q) noexcept {
        return signum_in_circle_infinite(metric, of(a), of(b), of(q));
    }
    template <class Q, class I>
    [[nodiscard]] static bool hidden(const Q& q, const I& i) noexcept {
        return signum_hidden(metric, of(q), of(i)) == 1;
    }
    template <class P, class A, class B>
    [[nodiscard]] static Sign nearer(const P& p, const A& a, const B& b) noexcept {
        return signum_nearer(metric, reading::Two(p).numbers, of(a), of(b));
    }

 private:
    /// Its numbers last as long as the call.
    struct Numbers : reading::Disc {
        using Disc::Disc;
        operator const double*() const noexcept { return numbers; }
    };
    template <class S>
    [[nodiscard]] static Numbers of(const S& site) noexcept {
        return Numbers(site);
    }
};
using Power = In<SIGNUM_POWER>;
using Euclidean = In<SIGNUM_EUCLIDEAN>;
using Manhattan = In<SIGNUM_MANHATTAN>;
using Supremum = In<SIGNUM_SUPREMUM>;

// ---- the conventions of others ----

// Their names, their order of arguments, the signs that they give: -1, 0 or +1, or no_sign.

/// Shewchuk's predicates.c, and so Triangle, TetGen, libigl and others. insphere is positive inside
/// where orient3d(a, b, c, d) > 0, incircle where orient2d(a, b, c) > 0.
namespace shewchuk {
template <class A, class B, class C>
[[nodiscard]] Sign orient2d(const A& a, const B& b, const C& c) noexcept {
    return ccw(a, b, c);
}
/// Positive where d lies below the plane of a, b, c, which turn counterclockwise seen from above.
template <class A, class B, class C, class D>
[[nodiscard]] Sign orient3d(const A& a, const B& b, const C& c, const D& d) noexcept {
    return reading::turned(-1, ccw(a, b, c, d));
}
template <class A, class B, class C, class D>
[[nodiscard]] Sign incircle(const A& a, const B& b, const C& c, const D& d) noexcept {
    return in_circle_determinant(a, b, c, d);
}
template <class A, class B, class C, class D, class E>
[[nodiscard]] Sign insphere(const A& a, const B& b, const C& c, const D& d, const E& e) noexcept {
    return reading::turned(-1, in_sphere_determinant(a, b, c, d, e));
}
}  // namespace shewchuk

/// igl::predicates, which calls Shewchuk's.
namespace libigl {
using shewchuk::incircle;
using shewchuk::insphere;
using shewchuk::orient2d;
using shewchuk::orient3d;
}  // namespace libigl

namespace cgal {
/// +1 LEFT_TURN, POSITIVE.
template <class P, class Q, class R>
[[nodiscard]] Sign orientation(const P& p, const Q& q, const R& r) noexcept {
    return ccw(p, q, r);
}
template <class P, class Q, class R, class S>
[[nodiscard]] Sign orientation(const P& p, const Q& q, const R& r, const S& s) noexcept {
    return ccw(p, q, r, s);
}
/// +1 ON_POSITIVE_SIDE: inside, where p, q, r turn counterclockwise.
template <class P, class Q, class R, class T>
[[nodiscard]] Sign side_of_oriented_circle(const P& p, const Q& q, const R& r,
                                           const T& t) noexcept {
    return in_circle_determinant(p, q, r, t);
}
/// +1 ON_BOUNDED_SIDE: inside.
template <class P, class Q, class R, class T>
[[nodiscard]] Sign side_of_bounded_circle(const P& p, const Q& q, const R& r, const T& t) noexcept {
    return in_circle(p, q, r, t);
}
template <class P, class Q, class R, class S, class T>
[[nodiscard]] Sign side_of_oriented_sphere(const P& p, const Q& q, const R& r, const S& s,
                                           const T& t) noexcept {
    return in_sphere_determinant(p, q, r, s, t);
}
template <class P, class Q, class R, class S, class T>
[[nodiscard]] Sign side_of_bounded_sphere(const P& p, const Q& q, const R& r, const S& s,
                                          const T& t) noexcept {
    return in_sphere(p, q, r, s, t);
}
}  // namespace cgal

/// GEO::PCK. Its in_circle_2d_SOS and in_sphere_3d_SOS, whose triangle and tetrahedron turn
/// positively, give ties a side; here a tie is 0.
namespace geogram {
template <class A, class B, class C>
[[nodiscard]] Sign orient_2d(const A& a, const B& b, const C& c) noexcept {
    return ccw(a, b, c);
}
template <class A, class B, class C, class D>
[[nodiscard]] Sign orient_3d(const A& a, const B& b, const C& c, const D& d) noexcept {
    return ccw(a, b, c, d);
}
template <class A, class B, class C, class D>
[[nodiscard]] Sign in_circle_2d(const A& a, const B& b, const C& c, const D& d) noexcept {
    return in_circle_determinant(a, b, c, d);
}
template <class A, class B, class C, class D, class E>
[[nodiscard]] Sign in_sphere_3d(const A& a, const B& b, const C& c, const D& d,
                                const E& e) noexcept {
    return in_sphere_determinant(a, b, c, d, e);
}
}  // namespace geogram

}  // namespace alone
}  // namespace signum

#endif
#endif
