#include "gaps.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "polynomial.hpp"
#include "real_roots.hpp"

namespace signum::oracle::motion {
namespace {

/// A pair in one image: the square of the distance of the centres in powers of the time, and the
/// sum of the radii.
struct Couple {
    int a, b;
    Polynomial square;
    Rational radii;
};

Polynomial path(const Ball& ball, const World& world, std::size_t axis) {
    const Rational x = exactly(ball.x[axis]), v = exactly(ball.v[axis]), since = exactly(ball.t0);
    const Rational half = exactly(world.g[axis]) / 2;
    return Polynomial{x - v * since + half * since * since, v - 2 * half * since, half};
}

/// All images that are among the nearest at some time from one to another, of a ball's pairs or of
/// all. An image is the nearest one along an axis where it is no farther than half a length.
std::vector<Couple> couples_of(const std::vector<Ball>& balls, const World& world,
                               const Rational& from, const Rational& to,
                               std::optional<int> of = {}) {
    std::vector<Couple> couples;
    const auto dimension = static_cast<std::size_t>(world.dimension);
    for (int a = 0; a < static_cast<int>(balls.size()); ++a) {
        for (int b = a + 1; b < static_cast<int>(balls.size()); ++b) {
            if (of && a != *of && b != *of) continue;
            const Ball& first = balls[static_cast<std::size_t>(a)];
            const Ball& second = balls[static_cast<std::size_t>(b)];
            // Sums of squares over the axes done so far, one an image.
            std::vector<Polynomial> squares = {Polynomial{}};
            for (std::size_t k = 0; k < dimension; ++k) {
                const Polynomial d = path(first, world, k) - path(second, world, k);
                std::vector<Polynomial> shifted = {d};
                if (world.periodic) {
                    shifted.clear();
                    const Rational length = exactly(world.high[k]) - exactly(world.low[k]);
                    const auto [low, high] = std::minmax({d(from), d(to)});
                    for (Rational turns = floor(low / length - Rational(1) / 2);
                         turns * length <= high + length / 2; turns += 1)
                        shifted.push_back(d - Polynomial{turns * length});
                }
                std::vector<Polynomial> sums;
                for (const Polynomial& square : squares)
                    for (const Polynomial& each : shifted) sums.push_back(square + each * each);
                squares = sums;
            }
            for (const Polynomial& square : squares)
                couples.push_back({a, b, square, exactly(first.r) + exactly(second.r)});
        }
    }
    return couples;
}

/// The sign of u + v √n.
int sign_with_root(const Rational& u, const Rational& v, const Rational& n) {
    const int of_u = u.sign(), of_v = n.is_zero() ? 0 : v.sign();
    if (of_u * of_v >= 0) return of_u != 0 ? of_u : of_v;
    return of_u * Rational(u * u - v * v * n).sign();
}

/// The sign of the gap of p less that of q: √s less t = √n + c, either t < 0, or by their squares.
int compare_gaps(const Couple& p, const Couple& q, const Rational& time) {
    const Rational s = p.square(time), n = q.square(time), c = p.radii - q.radii;
    if (sign_with_root(c, 1, n) < 0) return 1;
    return sign_with_root(s - n - c * c, -2 * c, n);
}

const Couple& least(const std::vector<Couple>& couples, const Rational& time) {
    const Couple* best = &couples.front();
    for (const Couple& each : couples) {
        const int order = compare_gaps(each, *best, time);
        if (order < 0 || (order == 0 && std::tie(each.a, each.b) < std::tie(best->a, best->b)))
            best = &each;
    }
    return *best;
}

double rounded_gap(const Couple& couple, const Rational& time) {
    const Rational square = couple.square(time);
    return nearest([&](const Rational& x) {
        const Rational distance = x + couple.radii;
        return distance.sign() < 0 ? 1 : Rational(square - distance * distance).sign();
    });
}

IntegerPolynomial in_integers(const Polynomial& p) {
    boost::multiprecision::mpz_int common = 1;
    for (std::size_t i = 0; i < p.size(); ++i)
        common = lcm(common, boost::multiprecision::mpz_int(denominator(p.coefficient(i))));
    IntegerPolynomial result;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Rational whole = p.coefficient(i) * Rational(common);
        mpz_class number;
        mpz_set(number.get_mpz_t(), mpq_numref(whole.backend().data()));
        result.push_back(number);
    }
    return result;
}

mpq_class to_mpq(const Rational& x) {
    return mpq_class(x.backend().data());
}

/// A root of one of the polynomials, in (low, high].
struct Event {
    const IntegerPolynomial* polynomial;
    const RealRoots* roots;
    int index;
    Rational low, high;

    int compare(const Rational& x) const { return roots->compare(index, to_mpq(x)); }
    void halve() {
        const Rational middle = (low + high) / 2;
        (compare(middle) <= 0 ? high : low) = middle;
    }
};
/// Apart, or by the roots of both polynomials together.
int compare(const Event& a, const Event& b) {
    if (a.high <= b.low) return -1;
    if (b.high <= a.low) return 1;
    const RealRoots both({*a.polynomial, *b.polynomial});
    const auto place = [&](int polynomial, int index) {
        int i = 0;
        while (both.multiplicity(i, polynomial) == 0 || index-- > 0) ++i;
        return i;
    };
    return place(0, a.index) - place(1, b.index);
}

}  // namespace

std::optional<Near> closest(const std::vector<Ball>& balls, const World& world, double time,
                            std::optional<int> of) {
    const Rational t = exactly(time);
    const std::vector<Couple> couples = couples_of(balls, world, t, t, of);
    if (couples.empty()) return std::nullopt;
    const Couple& best = least(couples, t);
    return Near{time, best.a, best.b, rounded_gap(best, t)};
}

/// Where two gaps are equal, (p - q - c²)² = 4 c² q: squared twice. Where that holds for ever the
/// two are linear between the roots of p and q.
std::vector<Near> closest_list(const std::vector<Ball>& balls, const World& world, double from,
                               double to) {
    const Rational begin = exactly(from), end = exactly(to);
    const std::vector<Couple> couples = couples_of(balls, world, begin, end);
    std::vector<Near> list;
    if (couples.empty()) return list;
    std::vector<IntegerPolynomial> polynomials;
    const auto add = [&](const Polynomial& p) {
        if (p.size() < 2) return;
        const IntegerPolynomial in = in_integers(p.scaled());
        if (std::ranges::find(polynomials, in) == polynomials.end()) polynomials.push_back(in);
    };
    for (std::size_t i = 0; i < couples.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Polynomial p = couples[i].square, q = couples[j].square;
            const Rational c = couples[i].radii - couples[j].radii;
            const Polynomial m = p - q - Polynomial{c * c};
            const Polynomial equal = c.is_zero() ? p - q : m * m - Polynomial{4 * c * c} * q;
            add(equal);
            if (!equal.is_zero()) continue;
            add(p);
            add(q);
        }
    }
    // Right after a time, and before the next one.
    const auto put = [&](double time, const Rational& after) {
        const Couple& best = least(couples, after);
        if (!list.empty() && list.back().a == best.a && list.back().b == best.b) return;
        // The gap is that of the nearest image then.
        const Rational then = exactly(time);
        std::vector<Couple> images = couples_of(balls, world, then, then);
        std::erase_if(images,
                      [&](const Couple& each) { return each.a != best.a || each.b != best.b; });
        list.push_back({time, best.a, best.b, rounded_gap(least(images, then), then)});
    };
    std::vector<RealRoots> tables;
    for (const IntegerPolynomial& p : polynomials)
        tables.push_back(RealRoots(std::vector<IntegerPolynomial>{p}));
    std::vector<Event> events;
    for (std::size_t k = 0; k < polynomials.size(); ++k) {
        for (int i = 0; i < tables[k].count(); ++i) {
            Event event{&polynomials[k], &tables[k], i, begin, end};
            if (event.compare(begin) <= 0 || event.compare(end) >= 0) continue;
            for (int halvings = 0; halvings < 100; ++halvings) event.halve();
            events.push_back(event);
        }
    }
    std::ranges::sort(events, [](const Event& a, const Event& b) { return compare(a, b) < 0; });
    const auto same = std::unique(events.begin(), events.end(), [](const Event& a, const Event& b) {
        return compare(a, b) == 0;
    });
    events.erase(same, events.end());
    const auto point_between = [&](const Event* a, const Event* b) {
        Rational low = a ? a->low : begin, high = b ? b->high : end;
        for (;;) {
            const Rational middle = (low + high) / 2;
            if (a && a->compare(middle) >= 0)
                low = middle;
            else if (b && b->compare(middle) <= 0)
                high = middle;
            else
                return middle;
        }
    };
    put(from, point_between(nullptr, events.empty() ? nullptr : &events.front()));
    for (std::size_t i = 0; i < events.size(); ++i)
        put(events[i].roots->nearest_double(events[i].index),
            point_between(&events[i], i + 1 < events.size() ? &events[i + 1] : nullptr));
    return list;
}

}  // namespace signum::oracle::motion
