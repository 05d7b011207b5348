#include "motion.hpp"

#include "linear_form.hpp"
#include "polynomial.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace signum::oracle::motion {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// p / sqrt(q), where p >= 0 and q > 0.
double nearest_by_root(const Rational& p, const Rational& q) {
    return nearest(
        [&](const Rational& x) { return x < 0 ? 1 : Rational(p * p).compare(x * x * q); });
}

/// Between two neighbouring roots of F·F' both signs stay. So the meeting is where the first gap
/// begins that has F < 0 and F' < 0: there F was at most 0 and decreases from there on.
std::optional<double> first_meeting(const Polynomial& gap, double since) {
    const Polynomial slope = gap.derivative();
    if (slope.is_zero()) return std::nullopt;
    const Roots roots(gap * slope);
    const std::vector<Rational> points = roots.between(exactly(since));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (gap.sign(points[i]) >= 0 || slope.sign(points[i]) >= 0) continue;
        const double time = i == 0 ? since : roots.nearest_root(points[i - 1], points[i]);
        return std::isfinite(time) ? std::optional(time) : std::nullopt;
    }
    return std::nullopt;
}

using Vector = std::array<Rational, 3>;
using Path = std::array<Polynomial, 3>;

Vector exactly(const std::array<double, 3>& v) {
    return {oracle::exactly(v[0]), oracle::exactly(v[1]), oracle::exactly(v[2])};
}
using oracle::exactly;

template <class T>
T dot(const std::array<T, 3>& a, const std::array<T, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
std::array<T, 3> operator-(const std::array<T, 3>& a, const std::array<T, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(const Rational& factor, const Vector& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}
Path constant(const Vector& v) {
    return {Polynomial{v[0]}, Polynomial{v[1]}, Polynomial{v[2]}};
}

/// x + v·(t - since) + g/2·(t - since)²
Path path(const Vector& x, const Vector& v, const Vector& g, const Rational& since) {
    const Polynomial passed{-since, 1};
    const auto along = [&](std::size_t i) {
        return Polynomial{x[i]} + Polynomial{v[i]} * passed +
               Polynomial{g[i] / 2} * passed * passed;
    };
    return {along(0), along(1), along(2)};
}
Path path(const Ball& ball, const World& world) {
    return path(exactly(ball.x), exactly(ball.v), exactly(world.g), exactly(ball.t0));
}
Path centre(const Wall& wall) {
    return path(exactly(wall.centre), exactly(wall.u), {}, 0);
}
Polynomial radius(const Ball& ball) {
    return {exactly(ball.r), exactly(ball.growth)};
}
Vector at(const Path& path, const Rational& t) {
    return {path[0](t), path[1](t), path[2](t)};
}

Polynomial gap(const Ball& a, const Ball& b, const World& world, const Vector& shift = {}) {
    const Path distance = path(a, world) - path(b, world) - constant(Rational(-1) * shift);
    const Polynomial reach = radius(a) + radius(b);
    return dot(distance, distance) - reach * reach;
}

bool is_side(const Wall& wall) {
    return dot(exactly(wall.n), exactly(wall.n)) == 1 &&
           std::count(wall.n.begin(), wall.n.end(), 0) == 2;
}

Polynomial gap(const Ball& ball, const Wall& wall, const World& world) {
    const Path way = path(ball, world);
    const Polynomial r = radius(ball);
    if (wall.kind == Wall::Kind::outside || wall.kind == Wall::Kind::inside) {
        const Path distance = way - centre(wall);
        const Polynomial square = dot(distance, distance), rho{exactly(wall.radius)};
        return wall.kind == Wall::Kind::outside ? square - (rho + r) * (rho + r)
                                                : (rho - r) * (rho - r) - square;
    }
    const Path n = constant(exactly(wall.n));
    const Polynomial height = dot(n, way) - Polynomial{exactly(wall.c), exactly(wall.w)};
    if (is_side(wall) || r.is_zero()) return height - r;
    if (wall.kind == Wall::Kind::side || dot(n, n).is_zero())
        throw std::invalid_argument("oracle: n is no normal of this kind of wall");
    return height * height - dot(n, n) * r * r;
}

std::optional<double> no_later(const std::optional<double>& time, double until) {
    return time && *time <= until ? time : std::nullopt;
}

Vector lengths(const World& world) {
    return exactly(world.high) - exactly(world.low);
}

/// A shift with which two balls are so near in every single coordinate that they can touch, and
/// since when.
struct Shift {
    Rational since;
    Vector by;
};

/// From [from, to], in which the coordinates before `axis` are near enough with the shift `by`.
/// Without gravity every coordinate of their distance is linear.
void add_shifts(const Path& distance, const Rational& reach, const World& world, std::size_t axis,
                const Rational& from, const Rational& to, Vector by, std::vector<Shift>& shifts) {
    if (axis == static_cast<std::size_t>(world.dimension)) {
        shifts.push_back({from, by});
        return;
    }
    const Rational length = lengths(world)[axis];
    const Rational first = distance[axis](from), last = distance[axis](to);
    const Rational speed = distance[axis].coefficient(1);
    for (Rational k = -floor((reach + std::max(first, last)) / length);
         std::min(first, last) + k * length <= reach; k += 1) {
        by[axis] = k * length;
        Rational begin = from, end = to;
        if (!speed.is_zero()) {
            const Rational enters =
                from + ((speed < 0 ? reach : -reach) - first - by[axis]) / speed;
            begin = std::max(from, enters);
            end = std::min(to, Rational(enters + 2 * reach / abs(speed)));
        }
        if (begin <= end) add_shifts(distance, reach, world, axis + 1, begin, end, by, shifts);
    }
}

std::vector<Shift> shifts_until(const Ball& a, const Ball& b, const World& world, double until) {
    if (!std::isfinite(until)) throw std::invalid_argument("oracle: a periodic box without end");
    const Rational from = exactly(std::max(a.t0, b.t0));
    const Rational to = exactly(std::nextafter(until, infinity));  // what is later rounds so, too
    const Polynomial radii = radius(a) + radius(b);
    std::vector<Shift> shifts;
    add_shifts(path(a, world) - path(b, world), std::max(abs(radii(from)), abs(radii(to))), world,
               0, from, to, {}, shifts);
    std::sort(shifts.begin(), shifts.end(),
              [](const Shift& p, const Shift& q) { return p.since < q.since; });
    return shifts;
}

std::optional<double> periodic_meeting_time(const Ball& a, const Ball& b, const World& world,
                                            double until, std::optional<double> passed = {}) {
    const double since = std::max(a.t0, b.t0);
    if (since > until) return std::nullopt;
    std::optional<double> first;
    for (const Shift& shift : shifts_until(a, b, world, until)) {
        if (first && shift.since > exactly(*first)) break;
        const auto time = first_meeting(gap(a, b, world, shift.by), since);
        if (time && (!passed || *time > *passed) && (!first || *time < *first)) first = time;
    }
    return no_later(first, until);
}

double finite(double value) {
    if (!std::isfinite(value)) throw std::overflow_error("oracle: beyond the doubles");
    return value;
}
std::array<double, 3> rounded(const Vector& v) {
    return {finite(nearest(v[0])), finite(nearest(v[1])), finite(nearest(v[2]))};
}

/// The ball with its state at time t, rounded.
Ball moved(const Ball& ball, double time, const World& world) {
    const Rational t = exactly(time);
    Vector x = at(path(ball, world), t);
    if (world.periodic) {
        const Vector low = exactly(world.low), length = lengths(world);
        for (std::size_t i = 0; i < static_cast<std::size_t>(world.dimension); ++i)
            x[i] -= floor((x[i] - low[i]) / length[i]) * length[i];
    }
    Ball result = ball;
    result.x = rounded(x);
    result.v = rounded(exactly(ball.v) + (t - exactly(ball.t0)) * exactly(world.g));
    result.t0 = time;
    return result;
}

/// What a strike leaves, and the speed of approach along the normal, squared; nothing where it is
/// none.
struct BallStrike {
    Ball a, b;
    double impulse;
    Rational approach_squared;
};
std::optional<BallStrike> strike(Ball a, Ball b, const World& world) {
    Vector distance = exactly(a.x) - exactly(b.x);
    if (world.periodic) {
        const Vector length = lengths(world);
        for (std::size_t i = 0; i < static_cast<std::size_t>(world.dimension); ++i)
            distance[i] -= floor(distance[i] / length[i] + Rational(1, 2)) * length[i];
    }
    const Rational approach = dot(exactly(a.v) - exactly(b.v), distance);
    if (approach >= 0) return std::nullopt;
    const Rational square = dot(distance, distance);
    const Rational ma = exactly(a.m), mb = exactly(b.m);
    const Rational gained = -(1 + exactly(world.restitution)) * ma * mb / (ma + mb) * approach;
    const auto before = std::pair(a.v, b.v);
    a.v = rounded(exactly(a.v) + gained / square / ma * distance);
    b.v = rounded(exactly(b.v) - gained / square / mb * distance);
    if (before == std::pair(a.v, b.v)) return std::nullopt;
    return BallStrike{a, b, finite(nearest_by_root(gained, square)), approach * approach / square};
}

struct WallStrike {
    Ball ball;
    double impulse;
    Rational approach_squared;
};
std::optional<WallStrike> strike(Ball ball, const Wall& wall, const World& world) {
    Vector n = exactly(wall.n);
    Rational approach = dot(exactly(ball.v), n) - exactly(wall.w);
    if (wall.kind == Wall::Kind::outside || wall.kind == Wall::Kind::inside) {
        n = exactly(ball.x) - at(centre(wall), exactly(ball.t0));
        if (wall.kind == Wall::Kind::inside) n = Rational(-1) * n;
        approach = dot(exactly(ball.v) - exactly(wall.u), n);
    }
    if (approach >= 0) return std::nullopt;
    const Rational gained = -(1 + exactly(world.wall_restitution)) * approach;
    const auto before = ball.v;
    ball.v = rounded(exactly(ball.v) + gained / dot(n, n) * n);
    if (before == ball.v) return std::nullopt;
    return WallStrike{ball, finite(nearest_by_root(gained * exactly(ball.m), dot(n, n))),
                      approach * approach / dot(n, n)};
}

class Simulation {
 public:
    Simulation(std::vector<Ball> balls, const World& world, double until)
        : world_(world), until_(until), in_place_(balls.size()) {
        for (const Ball& ball : balls)
            if (ball.growth != 0) throw std::invalid_argument("oracle: a strike of growing balls");
        if (world.periodic && !world.walls.empty())
            throw std::invalid_argument("oracle: walls in a periodic box");
        run_.balls = std::move(balls);
    }

    Run run(std::size_t most) {
        while (run_.log.size() < most && !run_.collapsed) {
            const std::optional<Event> next = earliest();
            if (!next) break;
            happen(*next);
        }
        return run_;
    }

 private:
    using Pair = std::tuple<bool, int, int>;  // whether with a wall, and who
    using Event = std::pair<double, Pair>;    // in the order in which they happen

    Ball& ball(int i) { return run_.balls[static_cast<std::size_t>(i)]; }
    const Wall& wall(int i) const { return world_.walls[static_cast<std::size_t>(i)]; }

    std::optional<double> time_of(const Pair& pair) {
        const auto [with_wall, a, b] = pair;
        const auto [entry, is_new] = times_.try_emplace(pair);
        if (is_new)
            entry->second = with_wall ? meeting_time(ball(a), wall(b), world_, until_)
                                      : meeting_time(ball(a), ball(b), world_, until_);
        return entry->second;
    }

    /// The next meeting of the two after one that is passed over: that of another image.
    std::optional<double> time_after(double passed, const Pair& pair) {
        const auto [with_wall, a, b] = pair;
        if (with_wall || !world_.periodic) return std::nullopt;
        return periodic_meeting_time(ball(a), ball(b), world_, until_, passed);
    }

    std::optional<Event> earliest() {
        std::optional<Event> first;
        const auto look_at = [&](const Pair& pair) {
            const std::optional<double> time = time_of(pair);
            if (time && (!first || Event(*time, pair) < *first)) first = Event(*time, pair);
        };
        const int balls = static_cast<int>(run_.balls.size());
        const int walls = static_cast<int>(world_.walls.size());
        for (int a = 0; a < balls; ++a) {
            for (int b = a + 1; b < balls; ++b) look_at({false, a, b});
            for (int b = 0; b < walls; ++b) look_at({true, a, b});
        }
        return first;
    }

    void happen(const Event& event) {
        const auto& [time, pair] = event;
        const auto [with_wall, a, b] = pair;
        times_[pair] = time_after(time, pair);  // unless it is a strike
        if (with_wall) {
            if (const auto struck = strike(moved(ball(a), time, world_), wall(b), world_)) {
                const double before = ball(a).t0;
                ball(a) = struck->ball;
                run_.log.push_back({time, true, a, b, struck->impulse});
                count(a, before, struck->approach_squared);
            } else {
                const Polynomial slope = gap(ball(a), wall(b), world_).derivative();
                run_.collapsed = slope.derivative().sign(exactly(time)) < 0;
            }
        } else if (const auto struck =
                       strike(moved(ball(a), time, world_), moved(ball(b), time, world_), world_)) {
            const double before_a = ball(a).t0, before_b = ball(b).t0;
            ball(a) = struck->a;
            ball(b) = struck->b;
            run_.log.push_back({time, false, a, b, struck->impulse});
            count(a, before_a, struck->approach_squared);
            count(b, before_b, struck->approach_squared);
        }
    }

    /// The ball has just been struck, for the first time since `before`.
    void count(int i, double before, const Rational& approach_squared) {
        std::erase_if(times_, [&](const auto& entry) {
            const auto [with_wall, a, b] = entry.first;
            return a == i || (!with_wall && b == i);
        });
        Rational size = exactly(ball(i).r);
        for (const double x : ball(i).x) size = std::max(size, abs(exactly(x)));
        size /= Rational(boost::multiprecision::mpz_int(1) << 40);
        const Rational since = exactly(ball(i).t0) - exactly(before);
        int& strikes = in_place_[static_cast<std::size_t>(i)];
        const Rational no_time =
            exactly(ball(i).t0) / Rational(boost::multiprecision::mpz_int(1) << 45);
        const bool is_in_place =
            approach_squared * since * since <= size * size || since <= no_time;
        strikes = is_in_place ? strikes + 1 : 0;
        const bool loses = world_.restitution < 1 || world_.wall_restitution < 1 ||
                           world_.g != std::array<double, 3>{};
        if (strikes >= (loses ? 1000 : 100'000)) run_.collapsed = true;
    }

    const World& world_;
    double until_;
    std::vector<int> in_place_;  // strikes of a ball in a row that found it in place
    std::map<Pair, std::optional<double>> times_;  // meetings, as long as their balls go on
    Run run_;
};

}  // namespace

std::vector<Wall> box_walls(const std::array<double, 3>& low, const std::array<double, 3>& high,
                            int dimension) {
    std::vector<Wall> walls;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
        Wall wall;
        wall.n[i] = 1, wall.c = low[i];
        walls.push_back(wall);
        wall.n[i] = -1, wall.c = -high[i];
        walls.push_back(wall);
    }
    return walls;
}

std::optional<double> meeting_time(const Ball& a, const Ball& b, const World& world, double until) {
    if (world.periodic) return periodic_meeting_time(a, b, world, until);
    return no_later(first_meeting(gap(a, b, world), std::max(a.t0, b.t0)), until);
}

std::optional<double> meeting_time(const Ball& ball, const Wall& wall, const World& world,
                                   double until) {
    return no_later(first_meeting(gap(ball, wall, world), ball.t0), until);
}

Run simulate(std::vector<Ball> balls, const World& world, double until, std::size_t most) {
    return Simulation(std::move(balls), world, until).run(most);
}

double nearest_quotient(double p, double q) {
    return nearest(exactly(p) / exactly(q));
}
double nearest_quotient_by_root(double p, double q) {
    return nearest_by_root(exactly(p), exactly(q));
}

}  // namespace signum::oracle::motion
