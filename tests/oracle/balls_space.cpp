#include "balls_space.hpp"

#include "linear_system.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace signum::oracle {
namespace {

/// A ball or a sphere as a point of one dimension more, relative to the first ball: (c_i - c_0,
/// r_0 - r_i) or (c - c_0, rho + r_0). It touches where the difference of the two, sphere less
/// ball, is (x, h) with |x| = h.
using Cycle = RationalVector;

/// x·x' - h h'
Rational cone_product(const Cycle& a, const Cycle& b) {
    Rational sum = -a.back() * b.back();
    for (std::size_t k = 0; k + 1 < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

Cycle along(const Cycle& start, const Rational& t, const Cycle& direction) {
    Cycle end = start;
    for (std::size_t k = 0; k < end.size(); ++k) end[k] += t * direction[k];
    return end;
}

/// |x|² - h² of the difference of two balls: negative where one contains the other, 0 where they
/// touch from inside or are equal.
Rational separation(const Cycle& a, const Cycle& b) {
    const Cycle difference = along(a, -1, b);
    return cone_product(difference, difference);
}

/// What touches D + 1 balls.
template <int D>
class Tangency {
 public:
    explicit Tangency(const BallTuple<D>& balls) : first_(balls[0]) {
        for (const SpaceBall<D>& ball : balls) {
            Cycle& cycle = balls_.emplace_back();
            for (std::size_t x = 0; x < size(); ++x) cycle.push_back(ball.c[x] - first_.c[x]);
            cycle.push_back(first_.r - ball.r);
        }
    }

    TouchingSpheres<D> spheres() const {
        // |s - b|² of the sphere s and the ball b is 0, as is |s|²: 2 s·b = |b|², products as
        // above.
        std::vector<RationalVector> rows;
        for (const Cycle& ball : balls_) {
            RationalVector& row = rows.emplace_back(ball);
            for (Rational& number : row) number *= 2;
            row.back() = -row.back();
            row.push_back(cone_product(ball, ball));
        }
        const std::optional<Flat> flat = solutions(rows, size() + 1);
        if (!flat) return none();
        if (flat->directions.size() == 1) return on_line(flat->point, flat->directions[0]);
        return on_flat(std::move(rows));
    }

 private:
    static constexpr std::size_t size() { return static_cast<std::size_t>(D); }
    static TouchingSpheres<D> none() { return {}; }
    static TouchingSpheres<D> infinitely_many() { return {SphereCount::infinitely_many, {}}; }

    /// Of points s = p + t d that solve the linear equations those with |s|² = 0.
    TouchingSpheres<D> on_line(const Cycle& p, const Cycle& d) const {
        const Rational a = cone_product(d, d), b = cone_product(p, d), c = cone_product(p, p);
        if (a.is_zero() && b.is_zero()) return c.is_zero() ? on_line_of_cone(p, d) : none();
        if (a.is_zero()) return those_of({sphere(p, d, Surd(-c / (2 * b)))});  // one at infinity
        const Rational g = b * b - a * c;
        if (g.sign() < 0) return none();
        if (g.is_zero()) return those_of({sphere(p, d, Surd(-b / a))});
        return those_of({sphere(p, d, {-b / a, 1 / a, g}), sphere(p, d, {-b / a, -1 / a, g})});
    }

    /// Of points s = p + t d, |d|² = 0, those that touch: each ball gives a linear equation for t.
    TouchingSpheres<D> on_line_of_cone(const Cycle& p, const Cycle& d) const {
        std::optional<Rational> t;
        for (const Cycle& ball : balls_) {
            const Cycle difference = along(p, -1, ball);
            const Rational slope = 2 * cone_product(d, difference);
            const Rational start = cone_product(difference, difference);
            if (slope.is_zero() && start.is_zero()) continue;
            if (slope.is_zero() || (t && *t != -start / slope)) return none();
            t = -start / slope;
        }
        // h + r_i - r_0 >= 0 for all i holds on a half of the line.
        if (!t) return infinitely_many();
        return those_of({sphere(p, d, Surd(*t))});
    }

    /// Where the linear equations leave two dimensions or more.
    TouchingSpheres<D> on_flat(std::vector<RationalVector> equations) const {
        for (const Cycle& a : balls_) {
            for (const Cycle& b : balls_) {
                // ||c - c_a| - |c - c_b|| = |r_a - r_b| is at most |c_a - c_b|, and only as large
                // on the line through the centres.
                const int sign = separation(a, b).sign();
                if (sign < 0) return none();
                if (sign == 0 && a != b) return on_line_of_cone(a, along(a, -1, b));
            }
        }
        // Now balls are equal or neither contains the other, and h >= 0 is enough. For else |c-c_a|
        // = rho + r_a and |c-c_b| = -(rho + r_b), whose sum r_a - r_b were at least |c_a - c_b|.
        // So it is asked whether the flat meets the surface |x| = h >= 0. If it meets the convex
        // set |x| <= h in more than one point, then the surface in infinitely many, for it has two
        // dimensions or more and the set contains no whole line.
        return meets_cone(std::move(equations)) ? infinitely_many() : none();
    }

    /// Whether a flat of two dimensions or more meets the set |x| <= h. At every height it is asked
    /// of the point with the least |x|: that where x is orthogonal to all level directions of the
    /// flat.
    bool meets_cone(std::vector<RationalVector> equations) const {
        std::vector<RationalVector> level_equations = equations;
        for (RationalVector& row : level_equations) row.back() = 0;
        level_equations.emplace_back(size() + 2, 0)[size()] = 1;
        const Flat level = *solutions(level_equations, size() + 1);
        for (const RationalVector& direction : level.directions) {
            equations.push_back(direction);
            equations.back().push_back(0);
        }
        const Flat nearest = *solutions(equations, size() + 1);
        Cycle p = nearest.point;
        const auto decided = [](int sign) {
            // In two and three dimensions the above leaves no such case.
            if (sign == 0) throw std::logic_error("oracle: a flat that touches a cone");
            return sign < 0;
        };
        if (nearest.directions.empty())  // all at one height
            return p.back().sign() >= 0 && decided(cone_product(p, p).sign());

        // |s|² = a h² + 2 b h + c at the height h, with c >= 0: is it negative for some h >= 0?
        const Cycle rise =
            along(Cycle(size() + 1, 0), 1 / nearest.directions[0].back(), nearest.directions[0]);
        p = along(p, -p.back(), rise);
        const Rational a = cone_product(rise, rise), b = cone_product(p, rise),
                       c = cone_product(p, p);
        if (a.sign() < 0) return true;
        if (a.is_zero()) return c.is_zero() && b.sign() >= 0 ? decided(0) : b.sign() < 0;
        if (b.sign() > 0) return c.is_zero() ? decided(0) : false;
        return decided(Rational(a * c - b * b).sign());
    }

    /// p + t d
    static std::vector<Surd> sphere(const Cycle& p, const Cycle& d, const Surd& t) {
        std::vector<Surd> s;
        for (std::size_t k = 0; k < p.size(); ++k) s.push_back(Surd(p[k]) + t * Surd(d[k]));
        return s;
    }

    /// Of one or two points with |s|² = 0 those that touch: where no distance is negative.
    TouchingSpheres<D> those_of(const std::vector<std::vector<Surd>>& points) const {
        TouchingSpheres<D> result;
        for (const std::vector<Surd>& s : points) {
            if (std::any_of(balls_.begin(), balls_.end(), [&](const Cycle& ball) {
                    return (s.back() - Surd(ball.back())).sign() < 0;
                }))
                continue;
            TouchingSphere<D>& touching = result.spheres.emplace_back();
            for (std::size_t x = 0; x < size(); ++x) touching.c[x] = s[x] + Surd(first_.c[x]);
            touching.rho = s.back() - Surd(first_.r);
            touching.orientation = orientation(s);
        }
        std::stable_sort(
            result.spheres.begin(), result.spheres.end(),
            [](const auto& a, const auto& b) { return a.orientation > b.orientation; });
        constexpr std::array counts{SphereCount::none, SphereCount::one, SphereCount::two};
        result.count = counts.at(result.spheres.size());
        return result;
    }

    /// det[c_i - c, rho + r_i], which is det[direction_i, 1] times distances; all rows less the
    /// first, but for the first itself.
    int orientation(const std::vector<Surd>& s) const {
        Surd sum;
        for (std::size_t column = 0; column <= size(); ++column) {
            std::vector<RationalVector> minor;
            for (std::size_t i = 1; i <= size(); ++i) {
                RationalVector& row = minor.emplace_back(balls_[i]);
                row.back() = -row.back();
                row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
            }
            const Surd entry = column == size() ? s[column] : -s[column];
            const Rational cofactor = determinant(std::move(minor));
            sum = sum + entry * Surd(column % 2 == 0 ? cofactor : -cofactor);
        }
        return sum.sign();
    }

    SpaceBall<D> first_;
    std::vector<Cycle> balls_;
};

/// Of all rising tuples of numbers below `count`, the one that follows in the order of words; false
/// after the last.
template <std::size_t N>
bool next_tuple(std::array<std::size_t, N>& tuple, std::size_t count) {
    for (std::size_t i = N; i-- > 0;) {
        if (tuple[i] == count - N + i) continue;
        ++tuple[i];
        for (std::size_t j = i + 1; j < N; ++j) tuple[j] = tuple[j - 1] + 1;
        return true;
    }
    return false;
}

}  // namespace

template <int D>
TouchingSpheres<D> touching_spheres(const BallTuple<D>& balls) {
    return Tangency<D>(balls).spheres();
}

template <int D>
int side(const TouchingSphere<D>& sphere, const SpaceBall<D>& q) {
    const Surd reach = sphere.rho + Surd(q.r);
    if (reach.sign() < 0) return 1;
    Surd sum = -(reach * reach);
    for (std::size_t x = 0; x < q.c.size(); ++x) {
        const Surd difference = sphere.c[x] - Surd(q.c[x]);
        sum = sum + difference * difference;
    }
    return sum.sign();
}

template <int D>
bool contains(const SpaceBall<D>& j, const SpaceBall<D>& i) {
    const Rational more = j.r - i.r;
    Rational square = 0;
    for (std::size_t x = 0; x < i.c.size(); ++x) {
        const Rational difference = j.c[x] - i.c[x];
        square += difference * difference;
    }
    return more.sign() >= 0 && square <= more * more;
}

template <int D>
std::vector<bool> hidden_balls(std::span<const SpaceBall<D>> balls) {
    std::vector<bool> hidden(balls.size(), false);
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = 0; j < balls.size(); ++j)
            if (j != i && contains(balls[j], balls[i]) && (j < i || balls[j] != balls[i]))
                hidden[i] = true;
    return hidden;
}

template <int D>
std::vector<BallVertex<D>> ball_vertices(std::span<const SpaceBall<D>> balls) {
    constexpr std::size_t corners = D + 1;
    const std::vector<bool> hidden = hidden_balls(balls);
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!hidden[i]) visible.push_back(i);

    std::vector<BallVertex<D>> vertices;
    if (visible.size() < corners) return vertices;
    std::array<std::size_t, corners> tuple;
    for (std::size_t i = 0; i < corners; ++i) tuple[i] = i;
    do {
        BallTuple<D> corner;
        for (std::size_t i = 0; i < corners; ++i) corner[i] = balls[visible[tuple[i]]];
        for (const TouchingSphere<D>& sphere : touching_spheres<D>(corner).spheres) {
            BallVertex<D> vertex{{}, sphere};
            bool is_empty = true;
            for (const std::size_t q : visible) {
                const int sign = side(sphere, balls[q]);
                is_empty = is_empty && sign >= 0;
                if (sign == 0) vertex.balls.push_back(static_cast<std::int32_t>(q));
            }
            const bool is_known =
                std::any_of(vertices.begin(), vertices.end(), [&](const BallVertex<D>& other) {
                    return other.balls == vertex.balls && other.sphere.c == sphere.c &&
                           other.sphere.rho == sphere.rho;
                });
            if (is_empty && !is_known) vertices.push_back(std::move(vertex));
        }
    } while (next_tuple(tuple, visible.size()));
    // Stable: of two spheres of one tuple the first stays first.
    std::stable_sort(vertices.begin(), vertices.end(),
                     [](const auto& a, const auto& b) { return a.balls < b.balls; });
    return vertices;
}

template TouchingSpheres<2> touching_spheres<2>(const BallTuple<2>&);
template TouchingSpheres<3> touching_spheres<3>(const BallTuple<3>&);
template int side<2>(const TouchingSphere<2>&, const SpaceBall<2>&);
template int side<3>(const TouchingSphere<3>&, const SpaceBall<3>&);
template bool contains<2>(const SpaceBall<2>&, const SpaceBall<2>&);
template bool contains<3>(const SpaceBall<3>&, const SpaceBall<3>&);
template std::vector<bool> hidden_balls<2>(std::span<const SpaceBall<2>>);
template std::vector<bool> hidden_balls<3>(std::span<const SpaceBall<3>>);
template std::vector<BallVertex<2>> ball_vertices<2>(std::span<const SpaceBall<2>>);
template std::vector<BallVertex<3>> ball_vertices<3>(std::span<const SpaceBall<3>>);

}  // namespace signum::oracle
