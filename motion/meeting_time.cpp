#include "meeting_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "../core/contract.hpp"
#include "../exact/nearest_double.hpp"
#include "../exact/polynomial.hpp"
#include "apart.hpp"
#include "descent.hpp"
#include "nearby_time.hpp"
#include "vector.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;
using exact::Integer;
using exact::Polynomial;

/// Of a centre, in the powers of t.
template <int D>
using Path = PerAxis<Polynomial, D>;

template <int D>
Path<D> path_of(const Ball<D>& ball, const Vector<D>& gravity) {
    static const Dyadic half(0.5);
    const Dyadic since(ball.time);
    Path<D> path;
    for (int i = 0; i < D; ++i) {
        const Dyadic v(ball.v[i]);
        const Dyadic g(gravity[i]);
        path[i] = {Dyadic(ball.x[i]) + (half * g * since - v) * since, v - g * since, half * g};
    }
    return path;
}

template <int D>
Polynomial radius_of(const GrowingBall<D>& ball) {
    return {Dyadic(ball.radius), Dyadic(ball.growth)};
}

// Two balls

/// One ball seen from another one flies straight: gravity cancels.
template <int D>
struct RelativeFlight {
    double start;
    Path<D> distance;
    Polynomial reach;

    RelativeFlight(const GrowingBall<D>& a, const GrowingBall<D>& b, const Effects<D>& effects)
        : start(std::max(a.time, b.time)),
          distance(path_of<D>(a, effects.gravity) - path_of<D>(b, effects.gravity)),
          reach(radius_of(a) + radius_of(b)) {}

    /// The meeting time of the image that is seen shifted.
    [[nodiscard]] double meeting(const PerAxis<Dyadic, D>& shift) const {
        Path<D> seen = distance;
        for (int i = 0; i < D; ++i) seen[i] = seen[i] - Polynomial{shift[i]};
        return first_descent(dot(seen, seen) - reach * reach, start);
    }
};

/// The coefficient of t, rounded.
double rate_of(const Polynomial& p) {
    const Dyadic rate = p.derivative().value_at(Dyadic());
    return exact::nearest_double([&](const Dyadic& x) { return (rate - x).sign(); });
}

/// The greatest integer not above a / b, b > 0.
Integer floor_of(const Dyadic& a, const Dyadic& b) {
    const int exponent = std::min(a.exponent(), b.exponent());
    const Integer numerator = a.significand() << (a.exponent() - exponent);
    const Integer denominator = b.significand() << (b.exponent() - exponent);
    return exact::floor_of(numerator, denominator);
}

/// In a window of time the images that may touch in it are those that are near enough along each
/// axis by itself. The first of them that meets within the window is the first of all.
template <int D>
class ImageSearch {
 public:
    ImageSearch(const RelativeFlight<D>& pair, const Effects<D>& effects) : pair_(pair) {
        for (int i = 0; i < D; ++i) length_[i] = length<Dyadic>(effects, i);
    }

    /// The least meeting time of the images that may touch in [begin, end].
    [[nodiscard]] double first_between(double begin, double end) {
        const Dyadic from(begin);
        const Dyadic to(end);
        const auto magnitude = [](const Dyadic& x) { return x.sign() < 0 ? -x : x; };
        const Dyadic reach =
            std::max(magnitude(pair_.reach.value_at(from)), magnitude(pair_.reach.value_at(to)));
        for (int i = 0; i < D; ++i) {
            const auto [least, most] =
                std::minmax({pair_.distance[i].value_at(from), pair_.distance[i].value_at(to)});
            first_[i] = -floor_of(reach - least, length_[i]);
            last_[i] = floor_of(most + reach, length_[i]);
        }
        best_ = infinity;
        try_all(0);
        return best_;
    }

 private:
    void try_all(int axis) {
        if (axis == D) {
            best_ = std::min(best_, pair_.meeting(shift_));
            return;
        }
        for (Integer k = first_[axis]; k <= last_[axis]; ++k) {
            shift_[axis] = Dyadic(k, 0) * length_[axis];
            try_all(axis + 1);
        }
    }

    const RelativeFlight<D>& pair_;
    PerAxis<Dyadic, D> length_;
    PerAxis<Integer, D> first_;
    PerAxis<Integer, D> last_;
    PerAxis<Dyadic, D> shift_;
    double best_ = infinity;
};

// Half spaces

/// u + v √n.
struct WithRoot {
    Dyadic u;
    Dyadic v;

    /// Where u and v √n are of different signs, their squares tell which is greater.
    [[nodiscard]] Sign sign(const Dyadic& n) const {
        const Sign of_u = u.sign();
        const Sign of_v = v.sign();
        if (of_u == 0 || of_u == of_v) return of_v;
        if (of_v == 0) return of_u;
        return of_u * (u * u - n * v * v).sign();
    }
};

/// A half space, in exact numbers.
template <int D>
struct ExactHalfSpace {
    PerAxis<Dyadic, D> normal;
    Dyadic offset;
    Dyadic speed;
};
template <int D>
ExactHalfSpace<D> dyadic(const HalfSpace<D>& wall) {
    return {dyadic(wall.normal), Dyadic(wall.offset), Dyadic(wall.speed)};
}

/// F = s - |n| r, s the height of the centre over the wall, times |n|. Its coefficients are of the
/// form u + v √(n·n), so that each of its signs is one of s² - n·n r², taken with the signs of s
/// and r, and rational. The polynomial s² - n·n r² by itself would not do: it is above 0 for a ball
/// behind the wall, too, and for a point it only touches 0 where s changes its sign.
///
/// F is a parabola, and where it goes down through 0 or turns to fall is known by the signs of F
/// and F' at dyadic points alone.
template <int D>
double meeting_of(const GrowingBall<D>& ball, const ExactHalfSpace<D>& wall,
                  const Effects<D>& effects, double since) {
    static const Dyadic half(0.5);
    const double first = std::max(ball.time, since);
    const Dyadic start(first);
    const Dyadic growth(ball.growth);
    const Dyadic square = dot(wall.normal, wall.normal);
    SIGNUM_EXPECTS(square.sign() > 0);
    // F(start + y) = c + b y + a y²
    const ExactPlace<D> then(ball, effects, first);
    const Dyadic a = half * dot(wall.normal, dyadic(effects.gravity));
    const WithRoot b{dot(wall.normal, then.v) - wall.speed, -growth};
    const WithRoot c{dot(wall.normal, then.x) - (wall.offset + wall.speed * start),
                     -(Dyadic(ball.radius) + growth * start)};
    const auto gap = [&](const Dyadic& y) {
        return WithRoot{c.u + (b.u + a * y) * y, c.v + b.v * y}.sign(square);
    };
    const auto slope = [&](const Dyadic& y) { return WithRoot{b.u + 2 * a * y, b.v}.sign(square); };

    const Sign bends = a.sign();
    const Sign slopes = b.sign(square);
    const bool falls = slopes < 0 || (slopes == 0 && bends < 0);
    if (!falls && bends >= 0) return infinity;
    if (falls && c.sign(square) <= 0) return first;
    if (bends > 0) {
        const WithRoot discriminant{b.u * b.u + square * b.v * b.v - 4 * a * c.u,
                                    2 * (b.u * b.v) - 4 * a * c.v};
        if (discriminant.sign(square) <= 0) return infinity;
    }
    // Where F is convex the meeting is where it falls through 0, before its least value. Otherwise
    // from the meeting on F is not above 0 and does not rise, and before it one of these fails.
    return exact::nearest_double([&](const Dyadic& x) {
        const Dyadic y = x - start;
        if (y.sign() <= 0) return 1;
        const Sign rises = slope(y);
        if (bends > 0) return rises >= 0 ? -1 : gap(y);
        const Sign apart = gap(y);
        return rises > 0 || apart > 0 ? 1 : std::max(rises, apart);
    });
}

Dyadic cross(const PerAxis<Dyadic, 2>& a, const PerAxis<Dyadic, 2>& b) {
    return a[0] * b[1] - a[1] * b[0];
}
/// One side of a segment.
ExactHalfSpace<2> side_of(const PerAxis<Dyadic, 2>& from, const PerAxis<Dyadic, 2>& along,
                          int side) {
    const PerAxis<Dyadic, 2> normal{{side * -along[1], side * along[0]}};
    return {normal, dot(normal, from), Dyadic()};
}

/// Whether a ball is surely too far from a point to touch it from one time to another: sums and
/// products of doubles, each of which errs by 2^-53 of what is added up.
bool stays_away(const GrowingBall<2>& ball, const Vector<2>& point, const Effects<2>& effects,
                double from, double until) {
    if (!(until < infinity)) return false;
    const double flight = until - ball.time;
    double size = 0.0;
    for (int k = 0; k < 2; ++k) size += std::fabs(ball.x[k]) + std::fabs(point[k]);
    const double way = (norm(ball.v) + 0.5 * norm(effects.gravity) * flight) * flight;
    const double radius = ball.radius + ball.growth * std::max(until, from);
    return norm(ball.x - point) > way + radius + 0x1p-40 * (size + way + radius);
}

constexpr double untold = std::numeric_limits<double>::quiet_NaN();

/// F and F' at a time, each rounded; what F' is a difference of, and a bound of |F''| there.
struct Fall {
    double f = 0.0;
    double slope = 0.0;
    double size = 0.0;
    double bend = 0.0;
};

/// Where F falls through 0 next to `about`: from t at t - F/F' (1 + θ), |θ| <= 2 |F'' F| / F'², as
/// long as that is small; where it is below 1/4 there is one such root near (Kantorovich), and
/// another step leads nearer to it. fall_at(t) -> Fall.
template <class FallAt>
double falls_near(double about, double start, const FallAt& fall_at) {
    constexpr int most_steps = 4;
    for (int step = 0; step < most_steps; ++step) {
        const Fall at = fall_at(about);
        if (!(at.slope < -0x1p-10 * at.size)) return untold;
        const double delta = -at.f / at.slope;
        const double theta = 2.0 * std::fabs(at.bend * delta / at.slope);
        if (theta < 0x1p-20) {
            const double error = std::fabs(delta) * (0x1p-28 + 2.0 * theta);
            const double time = nearby_time(about, delta, error, start);
            if (!std::isnan(time)) return time;
        }
        const double nearer = about + delta;
        if (!(theta < 0.25) || nearer == about || !(nearer >= start)) return untold;
        about = nearer;
    }
    return untold;
}

bool is_told(double about, double start) {
    return about >= start && about < 0x1p300;
}

template <int D>
double refined_meeting_of(const GrowingBall<D>& ball, const ExactHalfSpace<D>& wall,
                          const Effects<D>& effects, double about) {
    if (!is_told(about, ball.time)) return untold;
    double bend = 0.0;
    for (int i = 0; i < D; ++i)
        bend += std::fabs(round_to_double(wall.normal[i]) * effects.gravity[i]);
    const Dyadic square = dot(wall.normal, wall.normal);
    const double scale = std::sqrt(round_to_double(square));
    return falls_near(about, ball.time, [&](double time) -> Fall {
        const ExactPlace<D> then(ball, effects, time);
        const Dyadic t(time);
        const Dyadic height = dot(wall.normal, then.x) - (wall.offset + wall.speed * t);
        const Dyadic rise = dot(wall.normal, then.v) - wall.speed;
        const Dyadic radius = Dyadic(ball.radius) + Dyadic(ball.growth) * t;
        // h - |n| r = (h² - n² r²) / (h + |n| r)
        const double sum = round_to_double(height) + scale * round_to_double(radius);
        if (!(sum > 0.0) || height.sign() < 0) return {};
        const double slope = round_to_double(rise);
        const double growth = scale * ball.growth;
        return {round_to_double(height * height - square * radius * radius) / sum, slope - growth,
                std::fabs(slope) + growth, bend};
    });
}

}  // namespace

template <int D>
double meeting_time(const GrowingBall<D>& a, const GrowingBall<D>& b, const Image<D>& image,
                    const Effects<D>& effects) {
    PerAxis<Dyadic, D> shift;
    for (int i = 0; i < D; ++i)
        if (image[i] != 0) shift[i] = image[i] * length<Dyadic>(effects, i);
    return RelativeFlight<D>(a, b, effects).meeting(shift);
}

template <int D>
double meeting_time(const GrowingBall<D>& a, const GrowingBall<D>& b, const Effects<D>& effects,
                    double until) {
    const RelativeFlight<D> pair(a, b, effects);
    const auto no_later = [until](double time) { return time <= until ? time : infinity; };
    if (!effects.periodic) return no_later(pair.meeting({}));

    // Windows so short that few images are in reach of each: half a box length of flight, rounded.
    // Their lengths have no part in the result.
    double turns_per_time = 0.0;
    for (int i = 0; i < D; ++i) {
        const double speed = std::fabs(rate_of(pair.distance[i])) + std::fabs(rate_of(pair.reach));
        turns_per_time = std::max(turns_per_time, speed / length<double>(effects, i));
    }
    const bool grow = pair.reach.degree() == 1 && pair.reach.sign_at_infinity() > 0;
    if (until == infinity && !grow)
        throw std::invalid_argument("meeting_time: in a periodic box the search needs an end");
    ImageSearch<D> images(pair, effects);
    for (double begin = pair.start; begin <= until && begin < infinity;) {
        const double after =
            std::max(begin + 0.5 / turns_per_time, std::nextafter(begin, infinity));
        const double end = std::min({after, until, std::numeric_limits<double>::max()});
        const double time = images.first_between(begin, end);
        if (time <= end) return time;
        if (end == until || end < after) break;
        begin = end;
    }
    return infinity;
}

template <int D>
double meeting_time(const GrowingBall<D>& ball, const HalfSpace<D>& wall,
                    const Effects<D>& effects) {
    return meeting_of(ball, dyadic(wall), effects, -infinity);
}

/// The ends are circles of radius 0. Each side is met as a half space is, if the centre is on that
/// side then (or, of a point, was so one double before), and its foot on the segment at the rounded
/// time. A foot off by that rounding loses nothing: next to an end the circle is met as soon.
///
/// Of each side one time is enough: a ball that already falls below it, beside the segment or
/// behind it, does not come back to fall through it again, for the gap is a parabola.
double meeting_time(const GrowingBall<2>& ball, const Segment& wall, const Effects<2>& effects,
                    double since) {
    double first = infinity;
    const double start = std::max(ball.time, since);
    const PerAxis<Dyadic, 2> from = dyadic(wall.from);
    const PerAxis<Dyadic, 2> along = dyadic(wall.to) - from;
    const auto seen_at = [&](double t) { return ExactPlace<2>(ball, effects, t).x - from; };
    for (const int side : {1, -1}) {
        const double t = meeting_of<2>(ball, side_of(from, along, side), effects, since);
        if (!(t < first)) continue;
        const PerAxis<Dyadic, 2> seen = seen_at(t);
        const auto is_behind = [&](const PerAxis<Dyadic, 2>& place) {
            return side * cross(along, place).sign() < 0;
        };
        if (is_behind(seen) && (t == start || is_behind(seen_at(std::nextafter(t, -infinity)))))
            continue;
        const Dyadic foot = dot(seen, along);
        if (foot.sign() >= 0 && (dot(along, along) - foot).sign() >= 0) first = t;
    }
    for (const Vector<2>& end : {wall.from, wall.to})
        if (!stays_away(ball, end, effects, start, first))
            first = std::min(first, meeting_time(ball, Sphere<2>{.centre = end}, effects, since));
    return first;
}

template <int D>
double meeting_time(const GrowingBall<D>& ball, const Sphere<D>& wall, const Effects<D>& effects,
                    double since) {
    const double start = std::max(ball.time, since);
    Path<D> centre;
    for (int i = 0; i < D; ++i) centre[i] = {Dyadic(wall.centre[i]), Dyadic(wall.velocity[i])};
    const Path<D> seen = path_of<D>(ball, effects.gravity) - centre;
    const Polynomial square = dot(seen, seen);
    const Polynomial radius{Dyadic(wall.radius)};
    if (wall.side == Sphere<D>::Side::outside) {
        const Polynomial reach = radius + radius_of(ball);
        return first_descent(square - reach * reach, start);
    }
    const Polynomial room = radius - radius_of(ball);
    return first_descent(room * room - square, start);
}

template <int D>
double refined_meeting(const GrowingBall<D>& ball, const HalfSpace<D>& wall,
                       const Effects<D>& effects, double about) {
    return refined_meeting_of(ball, dyadic(wall), effects, about);
}

template <int D>
double refined_meeting(const GrowingBall<D>& ball, const Sphere<D>& wall, const Effects<D>& effects,
                       double about) {
    if (!is_told(about, ball.time)) return untold;
    const double sign = wall.side == Sphere<D>::Side::outside ? 1.0 : -1.0;
    return falls_near(about, ball.time, [&](double time) -> Fall {
        const ExactPlace<D> then(ball, effects, time);
        const Dyadic t(time);
        const Dyadic radius = Dyadic(ball.radius) + Dyadic(ball.growth) * t;
        const Dyadic reach = Dyadic(wall.radius) + Dyadic(sign) * radius;
        const PerAxis<Dyadic, D> u = dyadic(wall.velocity);
        const PerAxis<Dyadic, D> d = then.x - (dyadic(wall.centre) + t * u);
        const PerAxis<Dyadic, D> v = then.v - u;
        double fast = 0.0;
        double fall = 0.0;
        for (int i = 0; i < D; ++i) {
            fast += std::pow(round_to_double(v[i]), 2);
            fall += std::fabs(round_to_double(d[i]) * effects.gravity[i]);
        }
        const double slope = 2.0 * sign * round_to_double(dot(d, v));
        const double grown = 2.0 * round_to_double(reach) * ball.growth;
        // Twice that of F'' now, for F'' changes, too.
        return {sign * round_to_double(dot(d, d) - reach * reach), slope - grown,
                std::fabs(slope) + std::fabs(grown),
                4.0 * (fast + fall + ball.growth * ball.growth)};
    });
}

double refined_meeting(const GrowingBall<2>& ball, const Segment& wall, const Effects<2>& effects,
                       double about) {
    if (!is_told(about, ball.time)) return untold;
    const PerAxis<Dyadic, 2> from = dyadic(wall.from);
    const PerAxis<Dyadic, 2> along = dyadic(wall.to) - from;
    const PerAxis<Dyadic, 2> seen = ExactPlace<2>(ball, effects, about).x - from;
    const double foot = round_to_double(dot(seen, along)) / round_to_double(dot(along, along));
    // Next to where a side ends and an end begins all is looked at exactly.
    constexpr double margin = 0x1p-20;
    if (foot < -margin)
        return refined_meeting(ball, Sphere<2>{.centre = wall.from}, effects, about);
    if (foot > 1.0 + margin)
        return refined_meeting(ball, Sphere<2>{.centre = wall.to}, effects, about);
    if (!(foot > margin && foot < 1.0 - margin)) return untold;
    const int side = cross(along, seen).sign();
    return refined_meeting_of<2>(ball, side_of(from, along, side), effects, about);
}

#define SIGNUM_MEETING_TIMES(D)                                                                    \
    template double meeting_time(const GrowingBall<D>&, const GrowingBall<D>&, const Image<D>&,    \
                                 const Effects<D>&);                                               \
    template double meeting_time(const GrowingBall<D>&, const GrowingBall<D>&, const Effects<D>&,  \
                                 double);                                                          \
    template double meeting_time(const GrowingBall<D>&, const HalfSpace<D>&, const Effects<D>&);   \
    template double meeting_time(const GrowingBall<D>&, const Sphere<D>&, const Effects<D>&,       \
                                 double);                                                          \
    template double refined_meeting(const GrowingBall<D>&, const HalfSpace<D>&, const Effects<D>&, \
                                    double);                                                       \
    template double refined_meeting(const GrowingBall<D>&, const Sphere<D>&, const Effects<D>&,    \
                                    double);
SIGNUM_MEETING_TIMES(2)
SIGNUM_MEETING_TIMES(3)
#undef SIGNUM_MEETING_TIMES

}  // namespace signum::motion
