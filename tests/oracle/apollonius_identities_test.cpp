// Every identity and claim of the additively weighted metric that the predicates rest on, checked
// in rationals against a direct solution: intersect a line with a cone, and look at what comes out.
#include <gtest/gtest.h>
#include <boost/multiprecision/gmp.hpp>
#include "euclidean.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using signum::Site;
using signum::oracle::Integer;
using signum::oracle::ShrunkenDiscs;
using signum::oracle::Spacing;

template <class Number>
int sign_of(const Number& x) {
    return (x > 0) - (x < 0);
}

/// The site with integer coordinates.
struct Disc {
    int x, y, r;
};

std::string text(const std::vector<Disc>& discs) {
    std::string result;
    for (const Disc& d : discs) {
        result += " {" + std::to_string(d.x) + "," + std::to_string(d.y) + "," +
                  std::to_string(d.r) + "}";
    }
    return result;
}

std::vector<Site> sites(const std::vector<Disc>& discs) {
    std::vector<Site> result;
    for (const Disc& d : discs) {
        result.push_back(
            {static_cast<double>(d.x), static_cast<double>(d.y), static_cast<double>(d.r)});
    }
    return result;
}

// ---------------------------------------------------------------------------------------------
// The closed forms, written down as the design states them.

Integer p(const Disc& a, const Disc& b) {
    const Integer x = a.x - b.x;
    const Integer y = a.y - b.y;
    const Integer r = a.r - b.r;
    return x * x + y * y - r * r;
}

Integer casey(const Integer& a, const Integer& b, const Integer& c) {
    return a * a + b * b + c * c - 2 * (a * b + b * c + c * a);
}

/// Rows relative to i.
struct Row {
    Integer x, y, r, p;
    Row(const Disc& m, const Disc& i) : x(m.x - i.x), y(m.y - i.y), r(m.r - i.r), p(::p(m, i)) {}
};

template <class Column>
Integer determinant(const Row& j, const Row& k, const Row& q, Column a, Column b, Column c) {
    return j.*a * (k.*b * q.*c - k.*c * q.*b) - j.*b * (k.*a * q.*c - k.*c * q.*a) +
           j.*c * (k.*a * q.*b - k.*b * q.*a);
}

struct Triple {
    Row j, k;
    Integer xy, xr, yr, xp, yp;
    Integer c, q, gamma, twice_ab;

    Triple(const Disc& i, const Disc& dj, const Disc& dk)
        : j(dj, i),
          k(dk, i),
          xy(minor(&Row::x, &Row::y)),
          xr(minor(&Row::x, &Row::r)),
          yr(minor(&Row::y, &Row::r)),
          xp(minor(&Row::x, &Row::p)),
          yp(minor(&Row::y, &Row::p)),
          c(xy),
          q(xr * xr + yr * yr - xy * xy),
          gamma(j.p * k.p * p(dj, dk)),
          twice_ab(xp * xr + yp * yr) {}

    Integer minor(Integer Row::*a, Integer Row::*b) const { return j.*a * k.*b - j.*b * k.*a; }

    bool exists() const {
        if (q < 0) return c > 0;
        if (q > 0) return twice_ab > 0;
        return twice_ab > 0 && c > 0;
    }
};

struct Four {
    Triple t;
    Row q;
    Integer a, l, h, xyp;

    Four(const Disc& i, const Disc& j, const Disc& k, const Disc& dq)
        : t(i, j, k),
          q(dq, i),
          a(t.xy * d(&Row::x, &Row::y, &Row::p) - t.xr * d(&Row::x, &Row::r, &Row::p) -
            t.yr * d(&Row::y, &Row::r, &Row::p)),
          l(d(&Row::x, &Row::y, &Row::r)),
          h(casey(p(i, j) * p(k, dq), p(i, k) * p(j, dq), p(i, dq) * p(j, k))),
          xyp(d(&Row::x, &Row::y, &Row::p)) {}

    Integer d(Integer Row::*a_, Integer Row::*b_, Integer Row::*c_) const {
        return determinant(t.j, t.k, q, a_, b_, c_);
    }

    /// sign(a - l sqrt(gamma)), gamma > 0.
    int difference() const {
        const int u = sign_of(a);
        const int v = -sign_of(l);
        if (u == 0 || v == 0 || u == v) return u != 0 ? u : v;
        return u * sign_of(Integer{a * a - l * l * t.gamma});
    }

    int in_circle() const {
        if (t.q != 0) return sign_of(t.q) * difference();
        return l != 0 ? sign_of(h) * sign_of(l) : sign_of(Integer{-t.c * xyp});
    }
};

/// The conflict of q with the infinite vertex of the hull edge a -> b.
int in_circle_infinite(const Disc& a, const Disc& b, const Disc& q) {
    const Row u(b, a);
    const Row w(q, a);
    const Integer rational = w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y);
    const Integer cross = u.x * w.y - u.y * w.x;
    // sign(rational - sqrt(p) cross)
    const int s = sign_of(rational);
    const int t = -sign_of(cross);
    if (s == 0 || t == 0 || s == t) return s != 0 ? s : t;
    return s * sign_of(Integer{rational * rational - u.p * cross * cross});
}

// ---------------------------------------------------------------------------------------------
// The direct solution, in numbers a + b sqrt(g).

struct Surd {
    Rational a, b, g;

    int sign() const {
        const int u = sign_of(a);
        const int v = g == 0 ? 0 : sign_of(b);
        if (u == 0 || v == 0 || u == v) return u != 0 ? u : v;
        return u * sign_of(Rational{a * a - b * b * g});
    }
    friend Surd operator+(const Surd& s, const Surd& t) { return {s.a + t.a, s.b + t.b, s.g}; }
    friend Surd operator-(const Surd& s, const Surd& t) { return {s.a - t.a, s.b - t.b, s.g}; }
    friend Surd operator*(const Surd& s, const Surd& t) {
        return {s.a * t.a + s.b * t.b * s.g, s.a * t.b + s.b * t.a, s.g};
    }
    friend Surd operator+(const Surd& s, int n) { return {s.a + n, s.b, s.g}; }
    friend Surd operator-(const Surd& s, int n) { return {s.a - n, s.b, s.g}; }
};

/// A point (X, R) of the cone |X| = |R| with |X - v| = |R + s| for j and for k, relative to i.
struct Solution {
    Surd x, y, reach;
};

std::vector<Solution> solutions(const Disc& i, const Disc& dj, const Disc& dk) {
    using Vector = std::array<Rational, 3>;
    const auto product = [](const Vector& a, const Vector& b) -> Rational {
        return a[0] * b[0] + a[1] * b[1] - a[2] * b[2];
    };
    const auto cross = [](const Vector& a, const Vector& b) {
        return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
    };
    const Vector vj{dj.x - i.x, dj.y - i.y, dj.r - i.r};
    const Vector vk{dk.x - i.x, dk.y - i.y, dk.r - i.r};
    // X·v + R s = p/2: two planes, and their line.
    const Rational pj = product(vj, vj) / 2;
    const Rational pk = product(vk, vk) / 2;
    const Vector along = cross(vj, vk);
    const Rational square = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
    if (square == 0) return {};  // parallel planes
    const Vector to_j = cross(vk, along);
    const Vector to_k = cross(along, vj);
    Vector foot;
    for (std::size_t m = 0; m < 3; ++m) foot[m] = (pj * to_j[m] + pk * to_k[m]) / square;
    const Rational a = product(along, along);
    const Rational b = product(foot, along);
    const Rational c = product(foot, foot);
    std::vector<Solution> result;
    const auto add = [&](const Rational& t, const Rational& of_root, const Rational& g) {
        const auto coordinate = [&](std::size_t m) {
            return Surd{foot[m] + t * along[m], of_root * along[m], g};
        };
        result.push_back({coordinate(0), coordinate(1), coordinate(2)});
    };
    const Rational discriminant = b * b - a * c;
    if (a != 0) {
        if (discriminant < 0) return {};
        add(-b / a, 1 / a, discriminant);
        if (discriminant > 0) add(-b / a, -1 / a, discriminant);
    } else if (b != 0) {
        add(-c / (2 * b), 0, 0);
    } else if (c == 0) {
        ADD_FAILURE() << "a line of circles:" << text({i, dj, dk});
    }
    for (const Solution& s : result) {
        const auto on_cone = [&](int x, int y, int r) {
            const Surd u = s.x - x;
            const Surd v = s.y - y;
            const Surd w = s.reach + r;
            return (u * u + v * v - w * w).sign() == 0;
        };
        if (!on_cone(0, 0, 0) || !on_cone(dj.x - i.x, dj.y - i.y, dj.r - i.r) ||
            !on_cone(dk.x - i.x, dk.y - i.y, dk.r - i.r)) {
            ADD_FAILURE() << "the direct solution is no solution:" << text({i, dj, dk});
        }
    }
    return result;
}

/// Signs of the distances from the centre to those of i, j, k.
std::array<int, 3> reaches(const Solution& s, const Disc& i, const Disc& j, const Disc& k) {
    return {s.reach.sign(), (s.reach + (j.r - i.r)).sign(), (s.reach + (k.r - i.r)).sign()};
}

/// The orientation of the touching points, all distances being positive: the points are
/// (c_m - X) / (R + s_m), so it is the sign of the determinant with rows (c_m - X, R + s_m).
int turn(const Solution& s, const Disc& i, const Disc& j, const Disc& k) {
    const auto row = [&](const Disc& m) {
        const Surd zero{0, 0, s.x.g};
        return std::array{zero - (s.x - (m.x - i.x)), zero - (s.y - (m.y - i.y)),
                          s.reach + (m.r - i.r)};
    };
    const auto a = row(i);
    const auto b = row(j);
    const auto c = row(k);
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))
        .sign();
}

/// The circles that touch i, j, k counterclockwise.
std::vector<Solution> circles(const Disc& i, const Disc& j, const Disc& k) {
    std::vector<Solution> result;
    for (const Solution& s : solutions(i, j, k)) {
        if (reaches(s, i, j, k) == std::array{1, 1, 1} && turn(s, i, j, k) > 0) result.push_back(s);
    }
    return result;
}

/// +1 when q is nearer to the centre, in the metric, than i.
int nearer(const Solution& s, const Disc& i, const Disc& q) {
    const Surd reach = s.reach + (q.r - i.r);
    if (reach.sign() < 0) return -1;
    const Surd x = s.x - (q.x - i.x);
    const Surd y = s.y - (q.y - i.y);
    return (reach * reach - x * x - y * y).sign();
}

// ---------------------------------------------------------------------------------------------
// Configurations: i, j, k, q. Most families are degenerate on purpose.

class Configurations {
 public:
    std::vector<Disc> next() {
        static constexpr std::array<std::array<int, 3>, 8> directions{{{5, 0, 5},
                                                                       {-5, 0, 5},
                                                                       {0, 5, 5},
                                                                       {0, -5, 5},
                                                                       {3, 4, 5},
                                                                       {-3, 4, 5},
                                                                       {4, -3, 5},
                                                                       {-4, -3, 5}}};
        std::vector<Disc> discs(4);
        const int family = static_cast<int>(count_++ % 10);
        const int ox = upto(5);
        const int oy = upto(5);
        const int rho = upto(4);
        const auto direction = directions[static_cast<std::size_t>(upto(7))];
        if (family == 9) return trapezium();
        for (Disc& d : discs) {
            switch (family) {
                case 0:
                    d = {upto(3), upto(3), upto(2)};
                    break;
                case 1:
                    d = {upto(6), upto(6), upto(4)};
                    break;
                case 2: {  // centres on a line, mostly
                    const int t = upto(8);
                    d = {direction[0] * t, direction[1] * t + (upto(9) == 0), upto(6)};
                    break;
                }
                case 3:
                    d = {upto(3), upto(3), 0};
                    break;
                case 4: {  // touching a common line, mostly
                    const int t = upto(4);
                    const int r = upto(2);
                    d = {-direction[1] * t + direction[0] * r, direction[0] * t + direction[1] * r,
                         5 * r - (upto(6) == 0)};
                    break;
                }
                case 5: {  // touching a common circle, mostly
                    const auto to = directions[static_cast<std::size_t>(upto(7))];
                    const int t = 1 + upto(3);
                    d = {ox + to[0] * t, oy + to[1] * t, 5 * t - rho + (upto(9) == 0)};
                    break;
                }
                case 6:
                    d = {upto(7), upto(7), upto(1)};
                    break;
                case 7:
                    d = {upto(2000), upto(2000), upto(500)};
                    break;
                default: {  // touching one another, from inside or outside
                    const auto to = directions[static_cast<std::size_t>(upto(7))];
                    const int t = upto(2);
                    d = {to[0] * t, to[1] * t, 5 * (t + (upto(3) == 0)) - 5 * upto(1)};
                    break;
                }
            }
        }
        if (family == 6 || upto(15) == 0) {  // q is large
            discs[3].r += 1 + upto(6);
        }
        return discs;
    }

 private:
    std::mt19937 random_{20240229};
    std::uint32_t count_ = 0;

    /// Symmetric to an axis, so that a circle touches all four: centres on a line, a common
    /// tangent, or neither.
    std::vector<Disc> trapezium() {
        const int a = 1 + upto(5);
        const int b = 1 + upto(5);
        const int y = upto(4);
        const int r = upto(3);
        const int kind = upto(2);
        const int more = upto(4);
        const int other_y = kind == 0 ? y : upto(6);
        const int other_r = kind == 1 ? r + other_y - y : more;
        std::vector<Disc> discs{
            {a, y, r}, {-a, y, r}, {b, other_y, other_r}, {-b, other_y, other_r}};
        std::shuffle(discs.begin(), discs.end(), random_);
        return discs;
    }
    int upto(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n + 1)); }
};

constexpr int kConfigurations = 100000;

bool apart(const std::vector<Disc>& d) {
    return p(d[0], d[1]) > 0 && p(d[0], d[2]) > 0 && p(d[1], d[2]) > 0;
}
/// i alone hides q, or q and i are equal.
bool hidden(const Disc& q, const Disc& i) {
    return q.r <= i.r && p(q, i) <= 0;
}
bool q_visible(const std::vector<Disc>& d) {
    return !hidden(d[3], d[0]) && !hidden(d[3], d[1]) && !hidden(d[3], d[2]);
}

TEST(Apollonius, PolynomialIdentities) {
    Configurations configurations;
    for (int n = 0; n < kConfigurations; ++n) {
        const auto d = configurations.next();
        const Four f(d[0], d[1], d[2], d[3]);
        // A² - L²Γ = ¼ Q H
        ASSERT_EQ(4 * (f.a * f.a - f.l * f.l * f.t.gamma), f.t.q * f.h) << text(d);
        // (2ab)² - C²Γ = Q (E_xp² + E_yp²): the roots R have the product (E_xp² + E_yp²) / 4Q
        ASSERT_EQ(f.t.twice_ab * f.t.twice_ab - f.t.c * f.t.c * f.t.gamma,
                  f.t.q * (f.t.xp * f.t.xp + f.t.yp * f.t.yp))
            << text(d);
        // Heron: 4Q is H of the three powers
        ASSERT_EQ(4 * f.t.q, casey(p(d[0], d[1]), p(d[0], d[2]), p(d[1], d[2]))) << text(d);
        // Along the bisector of i and j: |u|² Q = W² - p_ij C², and the coordinate of a vertex,
        // which is (½ [|u|² p_ik - p_ij u·v] - R W) / C, has the rational part p_ij C e / 4Q.
        const Row& v = f.t.k;
        const Row& j = f.t.j;
        const Integer length = j.x * j.x + j.y * j.y;
        const Integer inner = j.x * v.x + j.y * v.y;
        const Integer w_minor = length * v.r - j.r * inner;
        ASSERT_EQ(length * f.t.q, w_minor * w_minor - j.p * f.t.c * f.t.c) << text(d);
        ASSERT_EQ(2 * (f.t.q * (length * v.p - j.p * inner) - w_minor * f.t.twice_ab),
                  f.t.c * f.t.c * j.p * (j.p - v.p - p(d[1], d[2])))
            << text(d);
        // The resultant of the infinite vertex
        const Row u(d[1], d[0]);
        const Row w(d[3], d[0]);
        const Integer square = u.x * u.x + u.y * u.y;
        const Integer rational = w.r * square - u.r * (u.x * w.x + u.y * w.y);
        const Integer cross = u.x * w.y - u.y * w.x;
        ASSERT_EQ(4 * (rational * rational - u.p * cross * cross),
                  square * casey(u.p, w.p, p(d[1], d[3])))
            << text(d);
    }
}

TEST(Apollonius, VerticesAndInCircle) {
    Configurations configurations;
    std::map<std::string, int> seen;
    int tested = 0;
    for (int n = 0; tested < kConfigurations; ++n) {
        const auto d = configurations.next();
        if (!apart(d)) continue;
        ++tested;
        const Triple t(d[0], d[1], d[2]);
        // The distances share one sign, because no site hides another.
        const auto all = solutions(d[0], d[1], d[2]);
        for (const Solution& s : all) {
            const auto signs = reaches(s, d[0], d[1], d[2]);
            ASSERT_NE(signs[0], 0) << text(d);
            ASSERT_EQ(signs[1], signs[0]) << text(d);
            ASSERT_EQ(signs[2], signs[0]) << text(d);
        }
        // Casey: H = 0 exactly when some circle, or anticircle, touches all four.
        const Four f(d[0], d[1], d[2], d[3]);
        if (t.q != 0) {
            bool common = false;
            for (const Solution& s : all) {
                const Surd x = s.x - (d[3].x - d[0].x);
                const Surd y = s.y - (d[3].y - d[0].y);
                const Surd w = s.reach + (d[3].r - d[0].r);
                common = common || (w * w - x * x - y * y).sign() == 0;
            }
            ASSERT_EQ(f.h == 0, common) << text(d);
        }

        const auto found = circles(d[0], d[1], d[2]);
        ASSERT_LE(found.size(), 1U) << text(d);
        ASSERT_EQ(t.exists(), found.size() == 1) << text(d);
        if (found.empty()) {
            ++seen["none"];
            continue;
        }
        const Solution& s = found.front();
        if (t.q != 0) {
            // R = (2ab - C sqrt(Γ)) / (2Q). Both sides lie in the field of sqrt(Γ): b²g = C²Γ/4Q².
            const Rational half = Rational{t.twice_ab} / Rational{Integer{2 * t.q}};
            ASSERT_EQ(s.reach.a, half) << text(d);
            ASSERT_EQ(s.reach.b * s.reach.b * s.reach.g * 4 * Rational{Integer{t.q * t.q}},
                      Rational{Integer{t.c * t.c * t.gamma}})
                << text(d);
            ASSERT_EQ(sign_of(s.reach.b), -sign_of(t.c) * sign_of(t.q)) << text(d);
            ++seen[t.q > 0 ? "Q > 0" : "Q < 0"];
        } else {
            // The limit, from the product of the roots.
            ASSERT_EQ(s.reach.a * 4 * Rational{t.twice_ab},
                      Rational{Integer{t.xp * t.xp + t.yp * t.yp}})
                << text(d);
            ++seen["Q = 0"];
        }
        if (t.c == 0) ++seen["C = 0"];

        if (!q_visible(d)) {
            ++seen["q hidden"];
            continue;
        }
        const int expected = nearer(s, d[0], d[3]);
        ASSERT_EQ(f.in_circle(), expected) << text(d) << " Q " << t.q << " H " << f.h;
        if (expected == 0) {
            ASSERT_EQ(f.h, 0) << text(d);
            ++seen["touching"];
            if (t.q == 0) ++seen["touching, Q = 0"];
        }
        if (f.h == 0) ++seen["H = 0"];
        if (t.q == 0 && f.l == 0) ++seen["Q = 0, L = 0"];
        for (int m = 0; m < 3; ++m) {
            if (hidden(d[static_cast<std::size_t>(m)], d[3])) {
                ++seen["q hides"];
                if (p(d[static_cast<std::size_t>(m)], d[3]) == 0) ++seen["q hides, touching"];
            }
        }
    }
    for (const auto& [what, times] : seen) {
        RecordProperty(what, times);
        EXPECT_GE(times, 20) << what;
    }
    EXPECT_EQ(seen.size(), 12U);
}

TEST(Apollonius, InfiniteVertex) {
    Configurations configurations;
    int tested = 0;
    int touching = 0;
    int steep = 0;
    while (tested < kConfigurations) {
        const auto d = configurations.next();
        const Disc& a = d[0];
        const Disc& b = d[1];
        const Disc& q = d[3];
        if (p(a, b) <= 0) continue;
        ++tested;
        // The unit normal n to the left: n·u = s, and n turned clockwise points from a to b.
        const Rational ux = b.x - a.x;
        const Rational uy = b.y - a.y;
        const Rational s = b.r - a.r;
        const Rational square = ux * ux + uy * uy;
        const Rational g = square - s * s;
        const Surd nx{s * ux / square, -uy / square, g};
        const Surd ny{s * uy / square, ux / square, g};
        const Surd one = nx * nx + ny * ny;
        ASSERT_EQ((one - 1).sign(), 0);
        const auto times = [](const Surd& n, const Rational& f) {
            return Surd{n.a * f, n.b * f, n.g};
        };
        ASSERT_EQ((times(nx, ux) + times(ny, uy) - Surd{s, 0, g}).sign(), 0);
        ASSERT_EQ((times(ny, ux) - times(nx, uy)).sign(), 1);
        const int expected =
            -(times(nx, q.x - a.x) + times(ny, q.y - a.y) - Surd{q.r - a.r, 0, g}).sign();
        ASSERT_EQ(in_circle_infinite(a, b, q), expected) << text({a, b, q});
        touching += expected == 0;
        steep += s != 0;
        if (expected == 0) {
            ASSERT_EQ(casey(p(a, b), p(a, q), p(b, q)), 0);
        }
    }
    EXPECT_GE(touching, 1000);
    EXPECT_GE(steep, 10000);
}

// The points of the bisector of i and j, seen from c_i: 1/R = 2 (u·v + s) / p for a unit vector u.
TEST(Apollonius, PartOfTheBisectorNearerToAThird) {
    std::vector<std::array<Rational, 2>> circle;
    for (int n = -40; n <= 40; ++n) {
        const Rational t = Rational{n * n * n} / 4000 + Rational{n} / 40;
        circle.push_back({(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)});
    }
    Configurations configurations;
    int tested = 0;
    std::map<std::string, int> seen;
    while (tested < 5000) {
        const auto d = configurations.next();
        if (!apart(d)) continue;
        ++tested;
        const auto inverse = [&](const std::array<Rational, 2>& u, const Disc& m) -> Rational {
            const Row row(m, d[0]);
            return 2 * (u[0] * Rational{row.x} + u[1] * Rational{row.y} + Rational{row.r}) /
                   Rational{row.p};
        };
        // Counterclockwise around c_i, beginning at a direction in which there is no bisector.
        const auto away = std::find_if(circle.begin(), circle.end(),
                                       [&](const auto& u) { return inverse(u, d[1]) <= 0; });
        if (away == circle.end()) continue;
        std::vector<std::array<Rational, 2>> around(away, circle.end());
        around.insert(around.end(), circle.begin(), away);
        std::vector<bool> inside;
        for (const auto& u : around) {
            const Rational at = inverse(u, d[1]);
            if (at > 0) {
                const Rational other = inverse(u, d[2]);
                if (at != other) inside.push_back(at < other);
            }
        }
        int rises = 0;
        int falls = 0;
        for (std::size_t n = 1; n < inside.size(); ++n) {
            rises += !inside[n - 1] && inside[n];
            falls += inside[n - 1] && !inside[n];
        }
        // Starts at (i,j,k), ends at (j,i,k).
        ASSERT_LE(rises, static_cast<int>(Triple(d[0], d[1], d[2]).exists())) << text(d);
        ASSERT_LE(falls, static_cast<int>(Triple(d[1], d[0], d[2]).exists())) << text(d);
        if (rises == 1 && falls == 1) ++seen[inside.front() ? "both ends" : "interval"];
        if (rises + falls == 1) ++seen["ray"];
    }
    EXPECT_GE(seen["interval"], 20);
    EXPECT_GE(seen["ray"], 20);
    // k may hold both ends of the bisector and leave an interval: the part wraps around infinity.
    EXPECT_GE(seen["both ends"], 20);
}

// ---------------------------------------------------------------------------------------------
// Ties. Sites are ordered by falling radius, then rising x, y, index; the closed rules here look
// only at that order and at powers, the oracle really shrinks the discs.

bool before(const std::vector<Disc>& d, std::size_t a, std::size_t b) {
    if (d[a].r != d[b].r) return d[a].r > d[b].r;
    if (d[a].x != d[b].x) return d[a].x < d[b].x;
    if (d[a].y != d[b].y) return d[a].y < d[b].y;
    return a < b;
}
std::size_t last(const std::vector<Disc>& d, std::initializer_list<std::size_t> names) {
    return *std::max_element(names.begin(), names.end(),
                             [&](std::size_t a, std::size_t b) { return before(d, a, b); });
}

/// in_circle = 0 at (0, 1, 2); query 3.
bool tie_conflict(const std::vector<Disc>& d) {
    const std::size_t m = last(d, {0, 1, 2, 3});
    if (m == 3) return false;
    const std::size_t a = (m + 1) % 3;
    const std::size_t b = (m + 2) % 3;
    const Integer opposite = p(d[m], d[3]) * p(d[a], d[b]);
    return !(opposite > p(d[a], d[3]) * p(d[m], d[b]) && opposite > p(d[b], d[3]) * p(d[m], d[a]));
}

/// in_circle_infinite = 0 at the hull edge 0 -> 1; query 3.
bool infinite_tie_conflict(const std::vector<Disc>& d) {
    const std::size_t m = last(d, {0, 1, 3});
    if (m == 3) return false;
    const Integer opposite = p(d[m], d[3]);
    return !(opposite > p(d[1 - m], d[3]) && opposite > p(d[0], d[1]));
}

/// Where Q = 0 and no circle exists, all three touch a line; the last of them between the others
/// makes that line a circle of infinite radius.
bool exists_at_infinity(const std::vector<Disc>& d) {
    const Triple t(d[0], d[1], d[2]);
    if (t.q != 0 || t.exists()) return false;
    const std::size_t m = last(d, {0, 1, 2});
    const std::size_t a = (m + 1) % 3;
    const std::size_t b = (m + 2) % 3;
    const Integer opposite = p(d[a], d[b]);
    if (opposite <= p(d[m], d[a]) || opposite <= p(d[m], d[b])) return false;
    return sign_of(t.c) * sign_of(t.twice_ab) < 0;
}

TEST(Apollonius, Ties) {
    Configurations configurations;
    std::map<std::string, int> seen;
    for (int n = 0; n < 50000; ++n) {
        const auto d = configurations.next();
        const ShrunkenDiscs discs(sites(d), Spacing::powers);
        const auto meet = [&](std::int32_t a, std::int32_t b) {
            const bool either = discs.hides(a, b) || discs.hides(b, a);
            EXPECT_EQ(either,
                      p(d[static_cast<std::size_t>(a)], d[static_cast<std::size_t>(b)]) <= 0)
                << text(d);
            return either;
        };
        if (meet(0, 1)) continue;
        const bool hidden_below = discs.hides(0, 3) || discs.hides(1, 3);
        const int infinite = in_circle_infinite(d[0], d[1], d[3]);
        if (infinite != 0) {
            ASSERT_EQ(infinite > 0, discs.crosses(0, 1, 3)) << text(d);
        } else if (!hidden_below) {
            ASSERT_EQ(infinite_tie_conflict(d), discs.crosses(0, 1, 3)) << text(d);
            ++seen["infinite tie"];
            ++seen["infinite tie, last is " + std::to_string(last(d, {0, 1, 3}))];
        }
        if (meet(0, 2) || meet(1, 2)) continue;
        const Triple t(d[0], d[1], d[2]);
        if (t.q == 0 || n % 8 == 0) {
            ASSERT_EQ(t.exists() || exists_at_infinity(d), discs.exists(0, 1, 2)) << text(d);
            ++seen["exists"];
        }
        if (hidden_below || discs.hides(2, 3)) continue;
        if (t.exists()) {
            const int in_circle = Four(d[0], d[1], d[2], d[3]).in_circle();
            if (in_circle == 0) {
                ASSERT_EQ(tie_conflict(d), discs.conflicts(0, 1, 2, 3)) << text(d);
                ++seen["tie"];
                ++seen["tie, last is " + std::to_string(last(d, {0, 1, 2, 3}))];
                if (t.q == 0) ++seen["tie, Q = 0"];
                if (t.c == 0) ++seen["tie, C = 0"];
                const bool inside = p(d[0], d[3]) == 0 || p(d[1], d[3]) == 0 || p(d[2], d[3]) == 0;
                if (inside) ++seen["tie, q hides and touches"];
                const ShrunkenDiscs again(sites(d), Spacing::steps, 2);
                ASSERT_EQ(again.conflicts(0, 1, 2, 3), tie_conflict(d)) << text(d);
            } else if (n % 8 == 0) {
                ASSERT_EQ(in_circle > 0, discs.conflicts(0, 1, 2, 3)) << text(d);
                ++seen["no tie"];
            }
        } else if (exists_at_infinity(d)) {
            const std::size_t m = last(d, {0, 1, 2});
            const int in_circle = in_circle_infinite(d[(m + 1) % 3], d[(m + 2) % 3], d[3]);
            const bool conflict = in_circle != 0 ? in_circle > 0 : tie_conflict(d);
            ASSERT_EQ(conflict, discs.conflicts(0, 1, 2, 3)) << text(d);
            ++seen["vertex at infinity"];
            if (in_circle == 0) ++seen["vertex at infinity, tie"];
        }
    }
    for (const auto& [what, times] : seen) {
        RecordProperty(what, times);
        EXPECT_GE(times, 20) << what;
    }
    EXPECT_EQ(seen.size(), 16U);
}

}  // namespace
