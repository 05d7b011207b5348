#include "walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact_meeting.hpp"

namespace signum::motion {
namespace {

using filters::magnitude;

/// F and F' at a time, rounded.
struct Course {
    double gap = 0.0;
    double slope = 0.0;
    double error = 0.0;        ///< of F: not less at later times
    double slope_error = 0.0;  ///< of F'
};

Meeting later_than(double time) noexcept {
    return {std::max(std::nextafter(time, infinity), std::numeric_limits<double>::lowest()),
            infinity};
}

/// How F bends: bounds of -F'' and of |F''|.
struct Bend {
    double down = 0.0;
    double either = 0.0;
};

/// course(t), bend(t, h) from t to t + h; skip(t) > t is a time before which F is surely above 0, t
/// where nothing is known and infinity where it stays above 0. No step is longer than `longest`.
template <class CourseAt, class BendIn, class Skip>
Meeting first_fall(double now, double latest, const CourseAt& course, const BendIn& bend,
                   const Skip& skip, double longest) {
    constexpr int most_steps = 100;
    double t = now;
    Course at = course(t);
    if (at.gap < -2.0 * at.error) return unknown;
    if (at.gap <= 4.0 * at.error) {
        // It has just been struck: F rises by 8 errors at least, at half its slope.
        if (!(at.slope > 4.0 * at.slope_error)) return unknown;
        const double h = 16.0 * at.error / at.slope;
        if (!(4.0 * bend(t, h).down * h < at.slope) || !(t + h > t)) return unknown;
        t += h;
        at = course(t);
        if (!(at.gap > 4.0 * at.error)) return unknown;
    }
    for (int step = 0; step < most_steps; ++step) {
        const double onward = skip(t);
        if (onward == infinity) return never;
        // Times are rounded: by as much as that a step is shorter.
        constexpr double rounded_down = 1.0 - 0x1p-51;
        if (onward * rounded_down > t) {
            t = onward * rounded_down;
            at = course(t);
            if (!(at.gap > 2.0 * at.error)) return unknown;
        }
        if (t > latest) return later_than(latest);
        if (at.slope < -4.0 * at.slope_error) {
            // F falls all the way to twice Newton's step, at 15/16 of its slope at least. A step
            // may have led to where F is 0, or beyond it, by as much as F errs.
            const double steep = -at.slope;
            const double root = at.gap / steep;
            const double length = magnitude(root);
            const double either = bend(t, 2.0 * length).either;
            if (at.slope_error + 2.0 * length * either < 0.0625 * steep) {
                const double error = course(t + 2.0 * length).error;
                const double bent = length * length * either;
                const double way =
                    2.0 * (error + bent + 2.0 * length * at.slope_error) / (0.9375 * steep) +
                    0x1p-49 * (t + length);
                if (bent <= error || way <= 0x1p-46 * (t + length)) {
                    if (!(at.slope_error + 2.0 * (length + way) * either < 0.0625 * steep))
                        return unknown;
                    return {std::max(t + root - way, now), t + root + way};
                }
            }
        }
        const double down = bend(t, longest).down;
        const double slope = at.slope - at.slope_error;
        if (!(down > 0.0) && slope >= 0.0 && longest == infinity) return never;
        const double above = at.gap - 2.0 * at.error;
        const double root = std::sqrt(slope * slope + 2.0 * std::max(down, 0.0) * above);
        const double safe = slope < 0.0  ? 2.0 * above / (root - slope)
                            : down > 0.0 ? (slope + root) / down
                                         : infinity;
        const double next = (t + std::min(safe * (1.0 - 0x1p-30), longest)) * rounded_down;
        if (!(next > t)) return unknown;
        t = next;
        at = course(t);
        if (!(at.gap > -2.0 * at.error)) return unknown;
    }
    return unknown;
}

template <class Asker>
Meeting filtered(const ShakingWall& wall, const Asker& ball, double latest) {
    const auto& bounds = ball.bounds();
    const double rate = ball.growth();
    const double inwards = wall.wall % 2 != 0 ? -1.0 : 1.0;
    const int axis = wall.wall / 2;
    const double now = ball.now();
    const double g = inwards * bounds.gravity[axis];
    const double v = inwards * ball.place().v[axis] - rate;
    const double gap = inwards * (ball.place().x[axis] - wall.level) - ball.radius();
    const double a = inwards * wall.amplitude;
    const double size = magnitude(wall.amplitude);
    const double omega = wall.frequency;
    const double extent = bounds.extent + magnitude(wall.level) + size;
    const double speed = bounds.speed + magnitude(v) + 2.0 * rate;
    if (latest < infinity) {
        // Whether it stays beyond all that the wave reaches until then.
        const double s = std::max(latest - now, 0.0);
        const double flown = (magnitude(v) + magnitude(g) * s) * s;
        if (gap - size - flown > 0x1p-40 * (extent + flown)) return later_than(latest);
    }
    const auto course = [&](double t) {
        const double s = t - now;
        const double argument = omega * t + wall.phase;
        const double turned = magnitude(omega * t) + magnitude(wall.phase);
        const double flown = speed * s + magnitude(g) * s * s;
        return Course{gap + (v + 0.5 * g * s) * s - a * std::sin(argument),
                      v + g * s - a * omega * std::cos(argument),
                      0x1p-46 * (extent + flown) + 0x1p-50 * size * (1.0 + turned),
                      0x1p-46 * (speed + magnitude(g) * s) +
                          0x1p-50 * size * magnitude(omega) * (1.0 + turned)};
    };
    // F'' = g + a ω² sin.
    const double of_wave = size * omega * omega * (1.0 + 0x1p-40);
    const auto bend = [&](double, double) { return Bend{of_wave - g, of_wave + magnitude(g)}; };
    // Beyond all the wave reaches it is a parabola.
    const auto skip = [&](double t) {
        const double s = t - now;
        const double height = gap + (v + 0.5 * g * s) * s - size;
        const double falling = v + g * s;
        const double margin = 0x1p-20 * size + 0x1p-40 * (extent + magnitude(speed * s)) +
                              0x1p-40 * magnitude(g) * s * s;
        const double way = height - 2.0 * margin;
        if (!(way > 0.0)) return t;
        if (g >= 0.0 && falling >= 0.0) return infinity;
        if (g == 0.0) return t + way / -falling;
        const double square = falling * falling - 2.0 * g * way;
        if (square <= 0.0) return infinity;
        return t + (falling < 0.0 ? 2.0 * way / (std::sqrt(square) - falling)
                                  : (falling + std::sqrt(square)) / -g);
    };
    return first_fall(now, latest, course, bend, skip, infinity);
}

template <int D>
Meeting filtered(const HalfSpace<D>& wall, const typename MeetingFilter<D>::Asker& ball, double) {
    const Bounds<D>& bounds = ball.bounds();
    Approach approach;
    approach.distance = dot(wall.normal, ball.place().x) - (wall.offset + wall.speed * ball.now());
    approach.scale = norm(wall.normal);
    approach.v = dot(wall.normal, ball.place().v) - wall.speed;
    approach.g = dot(wall.normal, bounds.gravity);
    double sizes = 0.0;
    for (int k = 0; k < D; ++k)
        sizes += magnitude(wall.normal[k]) * (magnitude(ball.place().v[k]) + bounds.speed);
    approach.extent = 2.0 * (2.0 * approach.scale * bounds.extent + magnitude(wall.offset) +
                             magnitude(wall.speed * ball.now()));
    approach.sizes = 4.0 * (sizes + magnitude(wall.speed));
    // An acceleration along the wall that is not 0 for rounding alone.
    if (magnitude(approach.g) <= 0x1p-40 * approach.scale * norm(bounds.gravity) &&
        approach.g != 0.0)
        return unknown;
    return ball.descent(approach);
}

/// How far a ball flies until then, no less.
template <int D>
double farthest_flight(const typename MeetingFilter<D>::Asker& ball, double latest) {
    const double wait = std::max(latest - ball.now(), 0.0);
    return (norm(ball.place().v) + 0.5 * norm(ball.bounds().gravity) * wait + ball.growth()) *
           wait * (1.0 + 0x1p-30);
}

/// |D|² against the square of a distance, D straight or a parabola.
template <int D>
Meeting filtered(const Sphere<D>& wall, const typename MeetingFilter<D>::Asker& ball,
                 double latest) {
    const Bounds<D>& bounds = ball.bounds();
    const double rate = ball.growth();
    const bool is_outside = wall.side == Sphere<D>::Side::outside;
    const double now = ball.now();
    const Vector<D>& g = bounds.gravity;
    const double pull = norm(g);
    const Vector<D> d = ball.place().x - (wall.centre + now * wall.velocity);
    const Vector<D> v = ball.place().v - wall.velocity;
    double extent = bounds.extent + wall.radius + ball.radius();
    double speed = 2.0 * (bounds.speed + rate);
    for (int k = 0; k < D; ++k) {
        extent += magnitude(wall.centre[k]) + magnitude(wall.velocity[k] * now) + magnitude(d[k]);
        speed += magnitude(v[k]);
    }
    const double reach = is_outside ? wall.radius + ball.radius() : wall.radius - ball.radius();
    if (latest < infinity) {
        const double apart = norm(d) - reach;
        const double flown =
            farthest_flight<D>(ball, latest) + norm(wall.velocity) * (latest - now);
        if ((is_outside ? apart : -apart) > flown + 0x1p-40 * (extent + flown))
            return later_than(latest);
    }
    const double reach_rate = is_outside ? rate : -rate;
    const auto seen_at = [&](double s) { return Place<D>{d + s * (v + 0.5 * s * g), v + s * g}; };
    const double sign = is_outside ? 1.0 : -1.0;
    const auto course = [&](double t) {
        const double s = t - now;
        const auto [x, w] = seen_at(s);
        const double r = reach + reach_rate * s;
        const double far = extent + speed * s + pull * s * s;
        const double fast = speed + 2.0 * pull * s;
        return Course{sign * (dot(x, x) - r * r), sign * 2.0 * (dot(x, w) - r * reach_rate),
                      0x1p-44 * far * far, 0x1p-43 * far * fast};
    };
    // F'' = ± 2 (|D'|² + D·g - q²).
    const auto bend = [&](double t, double h) {
        const auto [x, w] = seen_at(t - now);
        const double fast = norm(w) + (pull > 0.0 ? pull * h : 0.0);
        const double far = norm(x) + fast * h;
        const double pulled = pull > 0.0 ? far * pull : 0.0;
        const double turned = 2.0 * (1.0 + 0x1p-30) * (pulled + rate * rate);
        const double flown = 2.0 * (1.0 + 0x1p-30) * fast * fast;
        // Where nothing falls F'' is constant.
        if (is_outside && pull == 0.0 && fast > (1.0 + 0x1p-20) * rate)
            return Bend{0.0, turned + flown};
        return Bend{is_outside ? turned : turned + flown, turned + flown};
    };
    const auto skip = [&](double t) {
        const auto [x, w] = seen_at(t - now);
        const Course at = course(t);
        const bool leaves = at.gap > 2.0 * at.error && at.slope > at.slope_error;
        // From here on F'' >= 0.
        const double square = dot(w, w);
        const bool outgrows = rate > 0.0 && !(square > (1.0 + 0x1p-20) * rate * rate);
        if (is_outside && leaves && !outgrows && dot(x, g) >= 0.0 && dot(w, g) >= 0.0)
            return infinity;
        if (rate == 0.0 && pull == 0.0 && square == 0.0 && at.gap > at.error) return infinity;
        return t;
    };
    // So long that it neither flies nor falls much farther than the sphere is large.
    const double length = std::max(norm(d), magnitude(reach));
    double longest = infinity;
    if (pull > 0.0) longest = std::min(longest, std::sqrt(0.5 * length / pull));
    if (!is_outside) longest = std::min(longest, 0.5 * length / norm(v));
    return first_fall(now, latest, course, bend, skip, longest);
}

Meeting earlier(const Meeting& a, const Meeting& b) noexcept {
    return {std::min(a.early, b.early), std::min(a.late, b.late)};
}

Meeting filtered(const Segment& wall, const MeetingFilter<2>::Asker& ball, double latest) {
    Meeting first = never;
    const Vector<2> along = wall.to - wall.from;
    const Vector<2>& x = ball.place().x;
    const Vector<2>& v = ball.place().v;
    const Vector<2>& g = ball.bounds().gravity;
    const double length = norm(along);
    const double extent =
        4.0 * (ball.bounds().extent + magnitude(wall.from[0]) + magnitude(wall.from[1]) +
               magnitude(wall.to[0]) + magnitude(wall.to[1]));
    // Too far away to be reached by then.
    const double flown = farthest_flight<2>(ball, latest);
    const double reach = ball.radius() + flown + 0x1p-40 * (extent + flown);
    bool is_far = false;
    for (int k = 0; k < 2; ++k) {
        const auto [low, high] = std::minmax(wall.from[k], wall.to[k]);
        is_far = is_far || x[k] - reach > high || x[k] + reach < low;
    }
    if (is_far) return later_than(latest);
    for (const Vector<2>& end : {wall.from, wall.to}) {
        const Meeting meeting = filtered(Sphere<2>{.centre = end}, ball, latest);
        if (meeting.early == -infinity) return unknown;
        first = earlier(first, meeting);
    }
    for (const double side : {1.0, -1.0}) {
        const Vector<2> n{{-side * along[1], side * along[0]}};
        Approach approach;
        approach.distance = dot(n, x - wall.from);
        approach.scale = length;
        approach.v = dot(n, v);
        approach.g = dot(n, g);
        approach.extent = extent * length;
        approach.sizes = 8.0 * length * (ball.bounds().speed + magnitude(v[0]) + magnitude(v[1]));
        const double clear = 0x1p-40 * approach.extent;
        const double gap = approach.distance - length * ball.radius();
        if (approach.g != 0.0 && magnitude(approach.g) <= 0x1p-40 * length * norm(g))
            return unknown;
        if (gap < -clear) {
            // Behind it, or beside its ends: does it come out on this side, and back?
            const double rise =
                approach.v > 0.0 ? approach.v * approach.v / (-2.0 * approach.g) : 0.0;
            if (approach.g < 0.0 && !(gap + rise * (1.0 + 0x1p-20) < -clear)) return unknown;
            const double foot = dot(along, x) - dot(along, wall.from);
            const bool is_off = foot < -clear || foot > length * length + clear;
            // In front of it, and overlapping.
            if (approach.distance >= -clear && !is_off) return unknown;
            continue;
        }
        const Meeting meeting = ball.descent(approach);
        if (meeting.early == infinity) continue;
        if (meeting.early == -infinity) return unknown;
        // Where its foot is then.
        const double error =
            clear + (meeting.late - meeting.early) *
                        (length * (norm(v) + norm(g) * (meeting.late - ball.now())));
        const double s = meeting.early - ball.now();
        const double foot = dot(along, x - wall.from + s * (v + 0.5 * s * g));
        double size = 0.0;
        for (int k = 0; k < 2; ++k)
            size += magnitude(along[k]) * (magnitude(v[k]) * s + magnitude(g[k]) * s * s);
        const double bound = 2.0 * error + 0x1p-40 * size;
        if (foot < -bound || foot > length * length + bound) continue;
        if (!(foot > bound && foot < length * length - bound)) return unknown;
        first = earlier(first, meeting);
    }
    return first;
}

template <int D>
ShakingWall shaking_side(const Effects<D>& effects, Wall wall) {
    const auto& [low, high] = *effects.box;
    const auto& [amplitude, frequency, phase] = *effects.shake;
    const int axis = wall / 2;
    return {wall, wall % 2 != 0 ? high[axis] : low[axis], amplitude[axis], frequency, phase};
}

template <int D>
double gap_of(const Ball<D>& ball, const ShakingWall& wall) {
    const double d = ball.x[wall.wall / 2] - (wall.level + shift_at(wall, ball.time));
    return (wall.wall % 2 != 0 ? -d : d) - ball.radius;
}
template <int D>
double gap_of(const Ball<D>& ball, const HalfSpace<D>& wall) {
    const double height = dot(wall.normal, ball.x) - (wall.offset + wall.speed * ball.time);
    return height / norm(wall.normal) - ball.radius;
}
template <int D>
double gap_of(const Ball<D>& ball, const Sphere<D>& wall) {
    const double distance = norm(ball.x - (wall.centre + ball.time * wall.velocity));
    return wall.side == Sphere<D>::Side::outside ? distance - (wall.radius + ball.radius)
                                                 : wall.radius - ball.radius - distance;
}
double gap_of(const Ball<2>& ball, const Segment& wall) {
    const Vector<2> along = wall.to - wall.from;
    const Vector<2> d = ball.x - wall.from;
    const double foot = std::clamp(dot(along, d) / dot(along, along), 0.0, 1.0);
    return norm(d - foot * along) - ball.radius;
}

}  // namespace

template <int D>
Walls<D>::Walls(const Effects<D>& effects, Kernel kernel) : effects_(effects), kernel_(kernel) {
    for (Wall wall = 0; effects.shake && wall < 2 * D; ++wall) {
        if (effects.shake->amplitude[wall / 2] == 0.0) continue;
        numbers_.push_back(wall);
        surfaces_.push_back(shaking_side(effects, wall));
    }
    Wall number = 2 * D;
    for (const Obstacle<D>& obstacle : effects.obstacles) {
        numbers_.push_back(number++);
        std::visit([&](const auto& each) { surfaces_.push_back(each); }, obstacle);
    }
}

template <int D>
auto Walls<D>::wall_of(Wall wall) const noexcept -> const Surface* {
    const auto found = std::ranges::lower_bound(numbers_, wall);
    if (found == numbers_.end() || *found != wall) return nullptr;
    return &surfaces_[static_cast<std::size_t>(found - numbers_.begin())];
}

template <int D>
Meeting Walls<D>::meeting(Wall wall, const Asker& asker, double latest) const {
    const Meeting meeting =
        std::visit([&](const auto& each) { return filtered(each, asker, latest); }, *wall_of(wall));
    if (kernel_ == Kernel::exact || meeting.early == -infinity || meeting.late == infinity)
        return meeting;
    const double t = 0.5 * (meeting.early + meeting.late);
    return {t, t};
}

template <int D>
double Walls<D>::exact_meeting(const Ball<D>& ball, Wall wall) const {
    if (!has(wall)) return motion::exact_meeting(ball, wall, effects_);
    const GrowingBall<D> growing{ball, growth_of(ball, effects_)};
    return std::visit([&](const auto& each) { return meeting_time(growing, each, effects_); },
                      *wall_of(wall));
}

template <int D>
double Walls<D>::next_meeting(const Ball<D>& ball, Wall wall, double passed) const {
    const GrowingBall<D> growing{ball, growth_of(ball, effects_)};
    const auto next = [&](const auto& each) {
        if constexpr (requires { meeting_time(growing, each, effects_, passed); }) {
            double step = std::nextafter(passed, infinity) - passed;
            for (double since = passed + step; since < infinity; since = passed + (step *= 2.0)) {
                const double time = meeting_time(growing, each, effects_, since);
                if (time > since) return time;
            }
        }
        return infinity;
    };
    return std::visit(next, *wall_of(wall));
}

template <int D>
double Walls<D>::refined_meeting(const Ball<D>& ball, Wall wall, double about) const {
    if (!has(wall)) return motion::refined_meeting(ball, wall, effects_, about);
    const GrowingBall<D> growing{ball, growth_of(ball, effects_)};
    return std::visit(
        [&](const auto& each) { return motion::refined_meeting(growing, each, effects_, about); },
        *wall_of(wall));
}

template <int D>
Facing<D> Walls<D>::facing(const Ball<D>& ball, Wall wall) const {
    if (!has(wall)) return facing_side<D>(wall);
    return std::visit([&](const auto& each) { return motion::facing(ball, each); }, *wall_of(wall));
}

template <int D>
bool Walls<D>::bends_down(const Ball<D>& ball, Wall wall) const {
    if (!has(wall)) return (wall % 2 != 0 ? -1.0 : 1.0) * effects_.gravity[wall / 2] < 0.0;
    return std::visit(
        [&](const auto& each) {
            return motion::bends_down(ball, each, effects_.gravity, growth_of(ball, effects_));
        },
        *wall_of(wall));
}

template <int D>
double Walls<D>::depth(const Ball<D>& ball, Wall wall) const {
    const double radius = ball.radius + growth_of(ball, effects_) * ball.time;
    if (const auto* sphere = std::get_if<Sphere<D>>(wall_of(wall)))
        return sphere->side == Sphere<D>::Side::outside ? sphere->radius + radius : infinity;
    if constexpr (D == 2)
        if (std::holds_alternative<Segment>(*wall_of(wall))) return radius;
    return infinity;
}

template <int D>
Vector<D> Walls<D>::velocity(Wall wall, double t) const {
    Vector<D> v{};
    if (wall < 2 * D) {
        for (int k = 0; k < D && effects_.shake; ++k)
            v[k] = speed_at(shaking_side(effects_, 2 * k), t);
    } else if (const auto* plane = std::get_if<HalfSpace<D>>(wall_of(wall))) {
        v = plane->speed / dot(plane->normal, plane->normal) * plane->normal;
    } else if (const auto* sphere = std::get_if<Sphere<D>>(wall_of(wall))) {
        v = sphere->velocity;
    }
    return v;
}

template <int D>
std::array<Vector<D>, 2 * D> Walls<D>::side_velocities(double t, double step) const {
    std::array<Vector<D>, 2 * D> velocities{};
    for (int k = 0; k < D && effects_.shake; ++k) {
        const ShakingWall shaking = shaking_side(effects_, 2 * k);
        const double start = shift_at(shaking, t);
        double mean = speed_at(shaking, t);
        double slowest = mean;
        double fastest = mean;
        for (const double share : {0.25, 0.5, 0.75, 1.0}) {
            mean = (shift_at(shaking, t + share * step) - start) / (share * step);
            slowest = std::min(slowest, mean);
            fastest = std::max(fastest, mean);
        }
        for (Vector<D>& each : velocities) each[k] = mean;
        velocities[static_cast<std::size_t>(2 * k)][k] = fastest;
        velocities[static_cast<std::size_t>(2 * k + 1)][k] = slowest;
    }
    return velocities;
}

template <int D>
double Walls<D>::curvature(const Ball<D>& ball, Wall wall) const {
    const Surface* const surface = wall_of(wall);
    const auto* const sphere = surface ? std::get_if<Sphere<D>>(surface) : nullptr;
    if (sphere == nullptr || sphere->side == Sphere<D>::Side::outside) return 0.0;
    const double radius = sphere->radius - ball.radius;
    return radius > 0.0 ? 1.0 / radius : 0.0;
}

template <int D>
double Walls<D>::gap(const Ball<D>& ball, Wall wall) const {
    if (const Surface* surface = wall_of(wall))
        return std::visit([&](const auto& each) { return gap_of(ball, each); }, *surface);
    const double d = wall % 2 != 0 ? effects_.box->high[wall / 2] - ball.x[wall / 2]
                                   : ball.x[wall / 2] - effects_.box->low[wall / 2];
    return d - ball.radius;
}

template class Walls<2>;
template class Walls<3>;

}  // namespace signum::motion
