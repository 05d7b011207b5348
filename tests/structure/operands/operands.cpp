/// A careless user's program. It computes the operands of predicates in the very expressions that
/// ask them, and changes the floating-point environment between two questions; operands.cmake
/// compiles it with every liberty that is not refused. Every answer must be right for the doubles
/// that the operands are. Prints the wrong ones.

#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "../../../bindings/interop/cgal/signs.hpp"
#include "../../../motion/ball.hpp"
#include "../../../predicates/euclidean.hpp"
#include "../../../predicates/manhattan.hpp"
#include "../../../predicates/power.hpp"
#include "../../../predicates/space.hpp"
#include "../../../predicates/supremum.hpp"
#include "truth.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

using signum::Point;
using signum::Point3;
using signum::Site;
using signum::Site3;

int asked = 0;
int wrong = 0;

[[gnu::noinline]] void expect(const char* what, int given, int right) {
    ++asked;
    if (given == right) return;
    ++wrong;
    std::printf("%s: %d instead of %d\n", what, given, right);
}

/// Numbers in [1, 2) with all their bits, and small integers.
class Random {
 public:
    std::uint64_t bits() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        return state_ ^= state_ << 17;
    }
    double number() { return 1.0 + static_cast<double>(bits() >> 12) * 0x1p-52; }
    int below(int bound) { return static_cast<int>((bits() >> 20) % static_cast<unsigned>(bound)); }

 private:
    std::uint64_t state_ = 88172645463325252;
};
Random generator;

/// The double that a number is, in memory.
[[gnu::noinline]] double stored(double value) {
    volatile double result = value;
    return result;
}

// How a caller comes by a coordinate. Each is off its unrounded value by half an ulp or less.

struct Product {
    double u = generator.number();
    double v = generator.number();
    double value() const { return u * v; }
};
struct Sum {
    double u = generator.number();
    double v = generator.number() * 0x1p-40;
    double value() const { return u + v; }
};
struct Between {
    double a = generator.number();
    double b = generator.number();
    double share = generator.number() * 0.5;
    double value() const { return a + share * (b - a); }
};

/// A site of any kind of its numbers.
template <class S>
S made(double x, double y, double z, double last) {
    if constexpr (std::same_as<S, Point>) {
        return {x, y};
    } else if constexpr (std::same_as<S, Point3>) {
        return {x, y, z};
    } else if constexpr (requires { S::z; }) {
        return {x, y, z, last};
    } else {
        return {x, y, last};
    }
}

/// A site whose numbers the caller computes.
template <class S, class Number>
struct Computed {
    Number x, y, z, last;
    S site() const { return made<S>(x.value(), y.value(), z.value(), last.value()); }
};

/// The same with the sites given, a little off or not at all.
double off(double value) {
    return stored(value + (generator.below(3) - 1) * (generator.below(2) == 0 ? 0x1p-52 : 0x1p-30));
}
template <class S>
S twin(const S& s) {
    double z = 0.0;
    double last = 0.0;
    if constexpr (requires { s.z; }) z = off(s.z);
    if constexpr (requires { s.r; }) last = off(s.r);
    if constexpr (requires { s.w; }) last = off(s.w);
    return made<S>(off(s.x), off(s.y), z, last);
}
/// The site that the caller means, computed elsewhere: were its numbers computed beside the
/// question, compilers would not take them apart for it.
template <class S, class Number>
[[gnu::noinline]] S meant(const Computed<S, Number>& computed) {
    S site = computed.site();
    asm volatile("" : "+m"(site));
    return site;
}
template <class S>
S anywhere() {
    return meant(Computed<S, Product>());
}

/// One question in a function of its own, which computes the operand for it alone: then a compiler
/// is free to take it apart.
template <class Question, class S, class Number, class... Sites>
[[gnu::noinline, gnu::flatten]] int answer(Question question, const Computed<S, Number>& computed,
                                           const Sites&... sites) {
    return question(computed.site(), sites...);
}

/// What a filter says, if it says anything, must be right.
constexpr int uncertain = 2;
int said(signum::filters::Verdict verdict) {
    return verdict.is_certain() ? verdict.sign() : uncertain;
}
void expect_if_certain(const char* what, int given, int right) {
    expect(what, given == uncertain ? right : given, right);
}

template <class S, class Number>
void power_of_computed() {
    using namespace signum::power;
    const Computed<S, Number> computed;
    const S c = meant(computed);
    const S near = twin(c);
    const S j = anywhere<S>();
    const S k = anywhere<S>();
    const Point p = anywhere<Point>();
    const auto turn = [](const S& a, const S& b, const S& q) { return signum::ccw(a, b, q); };
    expect("ccw of a computed first", answer(turn, computed, j, near), truth::ccw(c, j, near));
    expect("ccw of a computed last",
           answer([](const S& q, const S& a, const S& b) { return signum::ccw(a, b, q); }, computed,
                  near, j),
           truth::ccw(near, j, c));
    expect_if_certain(
        "ccw_filter",
        answer([](const S& a, const S& b,
                  const S& q) { return said(signum::predicates::ccw_filter(a, b, q)); },
               computed, j, near),
        truth::ccw(c, j, near));
    expect("power nearer",
           answer([](const S& a, const S& b, const Point& q) { return nearer(q, a, b); }, computed,
                  near, p),
           truth::nearer(p, c, near));
    expect("power hidden",
           answer([](const S& i, const S& q) { return static_cast<int>(hidden(q, i)); }, computed,
                  near),
           near.x == c.x && near.y == c.y && truth::nearer({c.x, c.y}, near, c) <= 0);
    const auto conflict = [](const S& a, const S& b, const S& q, const S& m) {
        return in_circle(a, b, q, m);
    };
    const auto filtered = [](const S& a, const S& b, const S& q, const S& m) {
        return said(in_circle_filter(a, b, q, m));
    };
    if (truth::ccw(c, j, k) > 0) {
        const int right = truth::in_circle(c, j, k, near);
        expect("power in_circle", answer(conflict, computed, j, k, near), right);
        expect_if_certain("power in_circle_filter", answer(filtered, computed, j, k, near), right);
    }
    if (truth::ccw(near, j, k) > 0)
        expect("power in_circle of a computed query",
               answer([](const S& q, const S& a, const S& b,
                         const S& m) { return in_circle(a, b, m, q); },
                      computed, near, j, k),
               truth::in_circle(near, j, k, c));
    if (c.x != j.x || c.y != j.y)
        expect(
            "power in_circle_infinite",
            answer([](const S& a, const S& b, const S& q) { return in_circle_infinite(a, b, q); },
                   computed, j, near),
            truth::in_circle_infinite(c, j, near));
}

template <class S, class Number>
void space_of_computed() {
    namespace power = signum::power;
    const Computed<S, Number> computed;
    const S c = meant(computed);
    const S near = twin(c);
    const S j = anywhere<S>();
    const S k = anywhere<S>();
    const S l = anywhere<S>();
    const auto turn = [](const S& m, const S& n, const S& p, const S& q) {
        return signum::ccw(m, n, p, q);
    };
    expect("ccw of space", answer(turn, computed, near, j, k), truth::ccw(c, near, j, k));
    expect_if_certain(
        "ccw_filter of space",
        answer([](const S& m, const S& n, const S& p,
                  const S& q) { return said(signum::predicates::ccw_filter(m, n, p, q)); },
               computed, near, j, k),
        truth::ccw(c, near, j, k));
    if (truth::ccw(c, j, k, l) <= 0) return;
    const int right = truth::in_sphere(c, j, k, l, near);
    expect("in_sphere",
           answer([](const S& m, const S& n, const S& o, const S& p,
                     const S& q) { return power::in_sphere(m, n, o, p, q); },
                  computed, j, k, l, near),
           right);
    expect_if_certain(
        "in_sphere_filter",
        answer([](const S& m, const S& n, const S& o, const S& p,
                  const S& q) { return said(power::in_sphere_filter(m, n, o, p, q)); },
               computed, j, k, l, near),
        right);
    if (truth::ccw(near, j, k, l) > 0)
        expect_if_certain(
            "in_sphere_filter of a computed query",
            answer([](const S& q, const S& m, const S& n, const S& o,
                      const S& p) { return said(power::in_sphere_filter(m, n, o, p, q)); },
                   computed, near, j, k, l),
            truth::in_sphere(near, j, k, l, c));
}

/// Beside a line by steps of half an ulp, and in space beside a plane: off the grid on which
/// determinants in doubles would be exact.
void cgal_signs_beside_lines() {
    for (int m = 0; m < 64; ++m)
        for (int n = 0; n < 64; ++n) {
            const double x = stored(0.5 + m * 0x1p-53);
            const double y = stored(0.5 + n * 0x1p-53);
            const Point p = {x, y};
            const Point a = {12.0, 12.0};
            const Point b = {24.0, 24.0};
            expect("turn", signum::cgal::details::turn(p, a, b), truth::ccw(p, a, b));
            const Point3 p3 = {x, y, 0.5};
            const Point3 a3 = {12.0, 12.0, 12.0};
            const Point3 b3 = {24.0, 24.0, 24.0};
            const Point3 c3 = {24.0, 24.0, 12.0};
            expect("turn in space", signum::cgal::details::turn(p3, a3, b3, c3),
                   truth::ccw(p3, a3, b3, c3));
            const Point corners[] = {{0.0, 1.0}, {1.0, 0.0}, {0.0, 0.0}};
            const Point q = {stored(1.0 + m * 0x1p-52), stored(1.0 - n * 0x1p-53)};
            // These turn clockwise.
            expect("side_of_circle",
                   signum::cgal::details::side_of_circle(corners[0], corners[1], corners[2], q),
                   -truth::in_circle(corners[1], corners[0], corners[2], q));
        }
}

/// What log and structures of moving balls take from headers.
void integers_beside() {
    for (int round = 0; round < 1000; ++round) {
        const double x = stored((generator.number() - 1.5) * 2000.0);
        expect("nearest_integer", static_cast<int>(signum::motion::nearest_integer(x)),
               static_cast<int>(std::nearbyint(x)));
    }
}

/// A third point on the line of two others, but for the rounding.
template <class Number>
void ccw_of_aligned() {
    Computed<Point, Number> computed;
    const Point a = {computed.x.a, computed.y.a};
    const Point b = {computed.x.b, computed.y.b};
    computed.y.share = computed.x.share;
    const Point c = meant(computed);
    expect(
        "ccw of a computed point on the line",
        answer([](const Point& q, const Point& m, const Point& n) { return signum::ccw(m, n, q); },
               computed, a, b),
        truth::ccw(a, b, c));
}

template <class Metric, class Number>
void additive_of_computed() {
    using Truth = truth::Additive<Metric>;
    const Computed<Site, Number> computed;
    const Site c = meant(computed);
    const Site near = twin(c);
    const Site j = anywhere<Site>();
    const Site k = anywhere<Site>();
    const Point p = anywhere<Point>();
    expect("hides",
           answer(
               [](const Site& i, const Site& q) {
                   return static_cast<int>(Metric::hides(i, q, {0, 1}).sign > 0);
               },
               computed, near),
           Truth::hides(c, near));
    expect("nearer",
           answer(
               [](const Site& a, const Site& b, const Point& q) {
                   return static_cast<int>(Metric::nearer(q, a, b, {0, 1}).sign > 0);
               },
               computed, near, p),
           Truth::nearer(p, c, near));
    expect("exists",
           answer(
               [](const Site& a, const Site& b, const Site& q) {
                   return static_cast<int>(Metric::exists(a, b, q, {0, 1, 2}).sign > 0);
               },
               computed, j, near),
           Truth::exists(c, j, near));
    expect("exists_twice",
           answer(
               [](const Site& a, const Site& b, const Site& q) {
                   return static_cast<int>(Metric::exists_twice(a, b, q, {0, 1, 2}).sign > 0);
               },
               computed, j, near),
           Truth::exists_twice(c, j, near));
    if (Truth::exists_twice(c, j, near) && Truth::exists_twice(c, j, k))
        expect("precedes_on_bisector",
               answer(
                   [](const Site& a, const Site& b, const Site& q, const Site& m) {
                       return static_cast<int>(
                           Metric::precedes_on_bisector(a, b, q, m, {0, 1, 2, 3}).sign > 0);
                   },
                   computed, j, near, k),
               Truth::precedes_on_bisector(c, j, near, k));
    const auto conflict = [](const Site& a, const Site& b, const Site& m, const Site& q) {
        return static_cast<int>(Metric::in_circle(a, b, m, q, {0, 1, 2, 3}).sign > 0);
    };
    if (Truth::exists(c, j, k))
        expect("in_circle", answer(conflict, computed, j, k, near),
               Truth::in_circle(c, j, k, near));
    if (!Truth::hides(c, j) && !Truth::hides(j, c))
        expect("in_circle_infinite",
               answer(
                   [](const Site& a, const Site& b, const Site& q) {
                       return static_cast<int>(Metric::in_circle_infinite(a, b, q, {0, 1, 2}).sign >
                                               0);
                   },
                   computed, j, near),
               Truth::in_circle_infinite(c, j, near));
}

/// The filters alone: behind a public predicate stands a call that wants the operands in memory,
/// which makes compilers compute them once.
template <class Number>
void euclidean_filters_of_computed() {
    namespace filter = signum::euclidean::filter;
    using Truth = truth::Additive<signum::euclidean::Perturbed<>>;
    const Computed<Site, Number> computed;
    const Site c = meant(computed);
    const Site near = twin(c);
    const Site j = anywhere<Site>();
    const Site k = anywhere<Site>();
    const Point p = anywhere<Point>();
    const auto sign = [](bool yes) { return yes ? 1 : -1; };
    expect_if_certain("filter::hides",
                      answer([](const Site& i, const Site& q) { return said(filter::hides(i, q)); },
                             computed, near),
                      sign(Truth::hides(c, near)));
    expect_if_certain("filter::nearer",
                      answer([](const Site& a, const Site& b,
                                const Point& q) { return said(filter::nearer(q, a, b)); },
                             computed, near, p),
                      sign(Truth::nearer(p, c, near)));
    expect_if_certain("filter::exists",
                      answer([](const Site& a, const Site& b,
                                const Site& q) { return said(filter::exists(a, b, q)); },
                             computed, j, near),
                      sign(Truth::exists(c, j, near)));
    expect_if_certain("filter::exists_twice",
                      answer([](const Site& a, const Site& b,
                                const Site& q) { return said(filter::exists_twice(a, b, q)); },
                             computed, j, near),
                      sign(Truth::exists_twice(c, j, near)));
    if (Truth::exists_twice(c, j, near) && Truth::exists_twice(c, j, k))
        expect_if_certain(
            "filter::precedes_on_bisector",
            answer([](const Site& a, const Site& b, const Site& q,
                      const Site& m) { return said(filter::precedes_on_bisector(a, b, q, m)); },
                   computed, j, near, k),
            sign(Truth::precedes_on_bisector(c, j, near, k)));
    if (Truth::exists(c, j, k))
        expect_if_certain("filter::in_circle",
                          answer([](const Site& a, const Site& b, const Site& m,
                                    const Site& q) { return said(filter::in_circle(a, b, m, q)); },
                                 computed, j, k, near),
                          sign(Truth::in_circle(c, j, k, near)));
    if (!Truth::hides(c, j) && !Truth::hides(j, c))
        expect_if_certain(
            "filter::in_circle_infinite",
            answer([](const Site& a, const Site& b,
                      const Site& q) { return said(filter::in_circle_infinite(a, b, q)); },
                   computed, j, near),
            sign(Truth::in_circle_infinite(c, j, near)));
}

template <class Number>
void of_computed() {
    for (int round = 0; round < 250; ++round) {
        power_of_computed<Point, Number>();
        power_of_computed<signum::power::Site, Number>();
        power_of_computed<Site, Number>();
        space_of_computed<Point3, Number>();
        space_of_computed<signum::power::Site3, Number>();
        space_of_computed<Site3, Number>();
        euclidean_filters_of_computed<Number>();
        additive_of_computed<signum::euclidean::Perturbed<>, Number>();
        additive_of_computed<signum::supremum::Perturbed<>, Number>();
        additive_of_computed<signum::manhattan::Perturbed<>, Number>();
    }
}

// The environment changes between two questions in one function.

struct TowardZero {
    static void enter() { std::fesetround(FE_TOWARDZERO); }
    static void leave() { std::fesetround(FE_TONEAREST); }
};
struct Upward {
    static void enter() { std::fesetround(FE_UPWARD); }
    static void leave() { std::fesetround(FE_TONEAREST); }
};
#if defined(__SSE2__)
struct Flushing {
    static void enter() { _mm_setcsr(_mm_getcsr() | 0x8040); }
    static void leave() { _mm_setcsr(_mm_getcsr() & ~0x8040U); }
};
#endif

/// What is certain to be a mistake ends the program. Promised of numbers up to 2^100.
struct Trapping {
    static constexpr int traps = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    static void enter() {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(traps);
    }
    static void leave() { fedisableexcept(traps); }
};

/// Asks in an environment, in the default one, and in it again. The sites are copies that nobody
/// else knows, so that compilers know that they stay what they are. What the caller computed of
/// them before, in the other environment, must not serve either.
template <class Environment, class Own, class Ask, class... Operands>
[[gnu::noinline]] void ask_around(const char* what, int right, Own own, Ask ask,
                                  Operands... operands) {
    Environment::enter();
    volatile double computed = own(operands...);
    const int there = ask(operands...);
    Environment::leave();
    computed = own(operands...);
    const int here = ask(operands...);
    Environment::enter();
    const int again = ask(operands...);
    Environment::leave();
    static_cast<void>(computed);
    expect(what, there, right);
    expect(what, here, right);
    expect(what, again, right);
}

/// From one end of the doubles to the other, two binades at either end above all.
struct Extreme {
    static double number() {
        const double scales[] = {0x1p-1073, 0x1p-1072, 0x1p1022, 0x1p1023, 0x1p-100, 0x1p500, 0.0};
        const double sign = generator.below(2) == 0 ? 1.0 : -1.0;
        return stored(sign * generator.number() * scales[generator.below(7)] * 0.999);
    }
};
/// Small integers, which are tied and tangent often, and what is off them by little.
struct Ordinary {
    static double number() {
        const double scale = generator.below(8) == 0 ? 0x1p96 : 1.0;
        const double error = generator.below(4) == 0 ? generator.number() * 0x1p-50 : 0.0;
        return stored(scale * (generator.below(13) - 6 + error));
    }
};
template <class S, class Numbers>
S some_site() {
    return made<S>(Numbers::number(), Numbers::number(), Numbers::number(), Numbers::number());
}

/// Nothing, or what the filters begin with.
constexpr auto nothing = [](const auto&...) { return 0.0; };
constexpr auto difference = [](const auto& i, const auto& j, const auto&...) { return j.x - i.x; };
constexpr auto product = [](const auto& a, const auto& b, const auto& c, const auto&...) {
    return (a.x - c.x) * (b.y - c.y);
};

template <class Environment, class Numbers, class S>
void power_around() {
    const S i = some_site<S, Numbers>();
    const S j = some_site<S, Numbers>();
    const S k = some_site<S, Numbers>();
    const S q = some_site<S, Numbers>();
    const Point p = some_site<Point, Numbers>();
    ask_around<Environment>(
        "ccw around a change", truth::ccw(i, j, k), product,
        [](const S& a, const S& b, const S& c) { return signum::ccw(a, b, c); }, i, j, k);
    if (truth::ccw(i, j, k) > 0)
        ask_around<Environment>(
            "power in_circle around a change", truth::in_circle(i, j, k, q), difference,
            [](const S& a, const S& b, const S& c, const S& d) {
                return signum::power::in_circle(a, b, c, d);
            },
            i, j, k, q);
    if (i.x != j.x || i.y != j.y)
        ask_around<Environment>(
            "power in_circle_infinite around a change", truth::in_circle_infinite(i, j, q),
            difference,
            [](const S& a, const S& b, const S& c) {
                return signum::power::in_circle_infinite(a, b, c);
            },
            i, j, q);
    ask_around<Environment>(
        "power nearer around a change", truth::nearer(p, i, j), difference,
        [](const Point& a, const S& b, const S& c) { return signum::power::nearer(a, b, c); }, p, i,
        j);
}

template <class Environment, class Numbers, class S>
void space_around() {
    const S i = some_site<S, Numbers>();
    const S j = some_site<S, Numbers>();
    const S k = some_site<S, Numbers>();
    const S l = some_site<S, Numbers>();
    const S q = some_site<S, Numbers>();
    const int side = truth::ccw(i, j, k, l);
    ask_around<Environment>(
        "ccw of space around a change", side, product,
        [](const S& a, const S& b, const S& c, const S& d) { return signum::ccw(a, b, c, d); }, i,
        j, k, l);
    if (side > 0)
        ask_around<Environment>(
            "in_sphere around a change", truth::in_sphere(i, j, k, l, q), difference,
            [](const S& a, const S& b, const S& c, const S& d, const S& e) {
                return signum::power::in_sphere(a, b, c, d, e);
            },
            i, j, k, l, q);
}

template <class Environment, class Numbers, class Metric>
void additive_around() {
    using Truth = truth::Additive<Metric>;
    const Site i = some_site<Site, Numbers>();
    const Site j = some_site<Site, Numbers>();
    const Site k = some_site<Site, Numbers>();
    const Site q = some_site<Site, Numbers>();
    const Point p = some_site<Point, Numbers>();
    const auto ask = [](const char* what, bool right, auto question, auto... sites) {
        ask_around<Environment>(what, right, difference, question, sites...);
    };
    ask(
        "hides around a change", Truth::hides(i, j),
        [](const Site& a, const Site& b) {
            return Metric::hides(a, b, {0, 1}).sign > 0;
        },
        i, j);
    ask(
        "nearer around a change", Truth::nearer(p, i, j),
        [](const Point& point, const Site& a, const Site& b) {
            return Metric::nearer(point, a, b, {0, 1}).sign > 0;
        },
        p, i, j);
    ask(
        "exists around a change", Truth::exists(i, j, k),
        [](const Site& a, const Site& b, const Site& c) {
            return Metric::exists(a, b, c, {0, 1, 2}).sign > 0;
        },
        i, j, k);
    ask(
        "exists_twice around a change", Truth::exists_twice(i, j, k),
        [](const Site& a, const Site& b, const Site& c) {
            return Metric::exists_twice(a, b, c, {0, 1, 2}).sign > 0;
        },
        i, j, k);
    if (Truth::exists_twice(i, j, k) && Truth::exists_twice(i, j, q))
        ask(
            "precedes_on_bisector around a change", Truth::precedes_on_bisector(i, j, q, k),
            [](const Site& a, const Site& b, const Site& c, const Site& d) {
                return Metric::precedes_on_bisector(a, b, c, d, {0, 1, 2, 3}).sign > 0;
            },
            i, j, q, k);
    if (Truth::exists(i, j, k))
        ask(
            "in_circle around a change", Truth::in_circle(i, j, k, q),
            [](const Site& a, const Site& b, const Site& c, const Site& d) {
                return Metric::in_circle(a, b, c, d, {0, 1, 2, 3}).sign > 0;
            },
            i, j, k, q);
    if (!Truth::hides(i, j) && !Truth::hides(j, i))
        ask(
            "in_circle_infinite around a change", Truth::in_circle_infinite(i, j, q),
            [](const Site& a, const Site& b, const Site& c) {
                return Metric::in_circle_infinite(a, b, c, {0, 1, 2}).sign > 0;
            },
            i, j, q);
}

/// The Euclidean filters take roots; they trap nothing even where sites are tangent or hidden, and
/// there is no circle or line to ask about.
void euclidean_filters_under_traps() {
    namespace filter = signum::euclidean::filter;
    int certain = 0;
    for (int round = 0; round < 2000; ++round) {
        const Site i = some_site<Site, Ordinary>();
        const Site j = some_site<Site, Ordinary>();
        const Site k = some_site<Site, Ordinary>();
        const Site q = some_site<Site, Ordinary>();
        Trapping::enter();
        certain += static_cast<int>(filter::in_circle(i, j, k, q).is_certain());
        certain += static_cast<int>(filter::in_circle_infinite(i, j, q).is_certain());
        Trapping::leave();
    }
    // Linked with -funsafe-math-optimizations a program may begin with denormals flushed, where
    // filters decline.
    if (signum::filters::environment_is_default())
        expect("the Euclidean filters are certain of something", static_cast<int>(certain > 0), 1);
}

/// What was seen to go wrong before operands were pinned.
template <class Environment>
void ccw_around() {
    const Point a = {0x1.8p1023, 0x1.4p-76};
    const Point b = {-0x1.8p1023 + 0x1p1000, 0x1p-100};
    const Point c = {-0x1.8p1023, 0.0};
    const auto ask = [](const Point& i, const Point& j, const Point& k) {
        return signum::ccw(i, j, k);
    };
    ask_around<Environment>("ccw around a change, without a product", 1, nothing, ask, a, b, c);
    ask_around<Environment>("ccw around a change, after the product", 1, product, ask, a, b, c);
}

template <class Environment, class Numbers>
void around() {
    for (int round = 0; round < 150; ++round) {
        power_around<Environment, Numbers, Point>();
        power_around<Environment, Numbers, signum::power::Site>();
        power_around<Environment, Numbers, Site>();
        space_around<Environment, Numbers, Point3>();
        space_around<Environment, Numbers, signum::power::Site3>();
        space_around<Environment, Numbers, Site3>();
        additive_around<Environment, Numbers, signum::euclidean::Perturbed<>>();
        additive_around<Environment, Numbers, signum::supremum::Perturbed<>>();
        additive_around<Environment, Numbers, signum::manhattan::Perturbed<>>();
    }
}

}  // namespace

int main() {
    for (int round = 0; round < 2000; ++round) ccw_of_aligned<Between>();
    of_computed<Product>();
    of_computed<Sum>();
    of_computed<Between>();
    cgal_signs_beside_lines();
    integers_beside();
    ccw_around<TowardZero>();
    around<TowardZero, Extreme>();
    around<Upward, Extreme>();
    around<Trapping, Ordinary>();
    euclidean_filters_under_traps();
#if defined(__SSE2__)
    ccw_around<Flushing>();
    around<Flushing, Extreme>();
#endif
    std::printf("%d of %d answers are wrong\n", wrong, asked);
    return wrong == 0 && asked > 0 ? 0 : 1;
}
