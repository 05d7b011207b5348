/// What balls must be to begin.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "../exact/floating_environment.hpp"
#include "apart.hpp"
#include "check_parts.hpp"
#include "pair_tree.hpp"
#include "partner.hpp"
#include "simulation.hpp"
#include "time_steps.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;

/// Numbers whose squares, and squares of squares, are doubles with the errors of their products.
constexpr double largest = 0x1p150;

bool is_in_window(double number) noexcept {
    const double magnitude = std::fabs(number);
    return magnitude == 0.0 || (magnitude >= 1.0 / largest && magnitude <= largest);
}
/// Of states: balls that were within the window at the start may have flown beyond it, and strikes
/// may have made their numbers small. The squares of squares are doubles here, too.
constexpr double farthest = 0x1p200;

bool is_in_reach(double number) noexcept {
    return std::fabs(number) <= farthest;
}
bool is_finite(double number) noexcept {
    return std::isfinite(number);
}

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument(what);
}
/// Whether each number is one that its field may be; `path` is in front of the field's name.
template <class Value>
void check_numbers(const Value& value, const Field& field, const std::string& path) {
    if constexpr (std::is_arithmetic_v<Value>) {
        const auto number = static_cast<double>(value);
        std::string_view wanted;
        if (!field.range.has(number))
            wanted = field.range.words;
        else if (!field.range.is_fine && !is_in_window(number))
            wanted = "0 or a number of 2^-150 to 2^150";
        if (!wanted.empty())
            refuse(path + std::string(field.name) + ": give " + std::string(wanted));
    } else if constexpr (Described<Value>) {
        const std::string inner = path + std::string(field.name) + ".";
        Value::each_field(
            [&](auto member, const Field& each) { check_numbers(value.*member, each, inner); });
    } else if constexpr (DescribedIfOn<Value>) {
        if (value) check_numbers(*value, field, path);
    } else if constexpr (requires { value.begin(); }) {
        for (const auto& each : value) check_numbers(each, field, path);
    }
}

template <int D>
void check_obstacle(const HalfSpace<D>& wall) {
    if (wall.normal == Vector<D>{}) refuse("half-space: give a normal other than 0");
}
template <int D>
void check_obstacle(const Sphere<D>&) {}
void check_obstacle(const Segment& wall) {
    if (wall.from == wall.to) refuse("segment: its two ends are the same; give two places");
}

/// What takes two effects to make sense, or two numbers of one.
template <int D>
void check(const Effects<D>& effects) {
    Effects<D>::each_field([&]<class Value>(Value Effects<D>::*member, const Field& field) {
        check_numbers(effects.*member, field, "");
        if constexpr (DescribedIfOn<Value>)
            if (effects.*member && !field.stepped.empty() && effects.time_step == 0.0)
                refuse(std::string(field.name) + ": " + std::string(field.stepped) +
                       " is computed in steps of time; give a time step");
    });
    const auto& [box, shake, contacts] = std::tie(effects.box, effects.shake, effects.contacts);
    if (effects.periodic && !box) refuse("a periodic world needs a box");
    if (shake && (!box || effects.periodic))
        refuse("a box that shakes needs walls; give a box, and not a periodic one");
    for (const Obstacle<D>& obstacle : effects.obstacles)
        std::visit(
            [](const auto& wall) {
                check_numbers(wall, {wall.kind}, "");
                check_obstacle(wall);
            },
            obstacle);
    if (effects.obstacles.size() > 100'000) refuse("more than 100000 obstacles; give fewer");
    if (!effects.obstacles.empty() && effects.periodic)
        refuse("obstacles are for a world that is not periodic; leave one of the two out");
    if (contacts && effects.growth)
        refuse("growth and contacts that stand do not go together; leave one out");
    if (contacts && shake && std::fabs(shake->frequency) * effects.time_step > 1.0)
        refuse(
            "contacts that stand in a box that shakes: give a time step of a radian of it at most, "
            "a sixth of its period");
    for (int k = 0; box && k < D; ++k)
        if (!(box->low[k] < box->high[k])) refuse("box: give the lower corner, then the upper one");
}

void check_radius_and_mass(double radius, double mass, std::int64_t number) {
    if (!(radius >= 0.0) || !is_in_window(radius))
        throw BallError(number,
                        "a radius that is negative, not finite, or beyond 2^150 or below "
                        "2^-150 and not 0");
    if (!(mass > 0.0)) throw BallError(number, "a mass that is not positive; a ball needs one");
    if (!is_in_window(mass)) throw BallError(number, "a mass beyond 2^150, or below 2^-150");
}

template <int D>
void check(const Body<D>& body, std::int64_t number) {
    if (!std::ranges::all_of(body.x, is_in_window) || !std::ranges::all_of(body.v, is_in_window))
        throw BallError(number,
                        "a coordinate or speed that is not finite, or beyond 2^150 or "
                        "below 2^-150 and not 0");
    if (!std::ranges::all_of(body.spin, is_in_window))
        throw BallError(number,
                        "a spin that is not finite, or beyond 2^150 or below 2^-150 and not 0");
    check_radius_and_mass(body.radius, body.mass, number);
}

/// Whether a ball lies in what an obstacle takes, exactly.
template <int D>
bool is_within(const Body<D>& body, const HalfSpace<D>& wall) {
    const PerAxis<Dyadic, D> normal = dyadic(wall.normal);
    const Dyadic height = dot(normal, dyadic(body.x)) - Dyadic(wall.offset);
    const Dyadic radius(body.radius);
    return height.sign() < 0 ||
           (height * height - dot(normal, normal) * radius * radius).sign() < 0;
}
template <int D>
bool is_within(const Body<D>& body, const Sphere<D>& wall) {
    const PerAxis<Dyadic, D> d = dyadic(body.x) - dyadic(wall.centre);
    const Dyadic square = dot(d, d);
    if (wall.side == Sphere<D>::Side::outside) {
        const Dyadic reach = Dyadic(wall.radius) + Dyadic(body.radius);
        return (square - reach * reach).sign() < 0;
    }
    const Dyadic room = Dyadic(wall.radius) - Dyadic(body.radius);
    return room.sign() < 0 || (room * room - square).sign() < 0;
}
bool is_within(const Body<2>& body, const Segment& wall) {
    for (const Vector<2>& end : {wall.from, wall.to})
        if (is_within(body, Sphere<2>{.centre = end})) return true;
    const PerAxis<Dyadic, 2> along = dyadic(wall.to) - dyadic(wall.from);
    const PerAxis<Dyadic, 2> seen = dyadic(body.x) - dyadic(wall.from);
    const Dyadic foot = dot(along, seen);
    const Dyadic height = along[1] * seen[0] - along[0] * seen[1];
    const Dyadic length = dot(along, along);
    const Dyadic radius(body.radius);
    return foot.sign() > 0 && (length - foot).sign() > 0 &&
           (height * height - length * radius * radius).sign() < 0;
}
template <int D>
void check_obstacles(const Body<D>& body, const Effects<D>& effects, std::int64_t number) {
    std::size_t wall = 2 * D;
    for (const Obstacle<D>& obstacle : effects.obstacles) {
        if (std::visit([&](const auto& each) { return is_within(body, each); }, obstacle))
            throw BallError(
                number, "a ball that overlaps wall " + std::to_string(wall) + "; it may touch it");
        ++wall;
    }
}
template <int D>
void check_sides_of_segments(double radius, const Effects<D>& effects, std::int64_t number) {
    if constexpr (D == 2) {
        const auto is_segment = [](const Obstacle<D>& each) {
            return std::holds_alternative<Segment>(each);
        };
        if (radius == 0.0 && std::ranges::any_of(effects.obstacles, is_segment))
            throw BallError(number,
                            "a ball of radius 0 where there are segments, of which it knows no "
                            "side; give a radius above 0");
    }
}

/// Exactly, but for where a box that shakes is at the start.
template <int D>
void check_walls(const Body<D>& body, const Effects<D>& effects, std::int64_t number) {
    for (int k = 0; k < D; ++k) {
        const Dyadic x(body.x[k]);
        const Dyadic shift(
            effects.shake ? effects.shake->amplitude[k] * std::sin(effects.shake->phase) : 0.0);
        const Dyadic low = Dyadic(effects.box->low[k]) + shift;
        const Dyadic high = Dyadic(effects.box->high[k]) + shift;
        const Dyadic radius(body.radius);
        if (effects.periodic) {
            if ((x - low).sign() < 0 || (high - x).sign() < 0)
                throw BallError(number, "a centre outside the periodic box; give one inside");
            continue;
        }
        if ((x - low - radius).sign() < 0 || (high - x - radius).sign() < 0)
            throw BallError(number, "a ball outside its walls; it may touch them from within");
    }
}

/// That a ball of some radius, and as it becomes when it grows from then on, finds room; `slack` is
/// a part of the box that it may be too wide by.
template <int D>
void check_width(double radius, const std::optional<Growth>& growth, const Effects<D>& effects,
                 double slack, std::int64_t number) {
    const Dyadic grown =
        Dyadic(radius) +
        (growth ? Dyadic(growth->rate * radius) * Dyadic(growth->until) : Dyadic());
    for (int k = 0; k < D; ++k) {
        const Dyadic width = (Dyadic(effects.box->high[k]) - Dyadic(effects.box->low[k])) *
                             (Dyadic(1.0) + Dyadic(slack));
        // In the end, for partners are seen in their nearest images.
        if (effects.periodic && (width - 8 * grown).sign() < 0)
            throw BallError(number,
                            "a ball whose diameter is more than a quarter of the periodic box, or "
                            "grows to be; give a larger box");
        if ((width - 2 * grown).sign() < 0)
            throw BallError(number,
                            "a ball that is wider than its walls are apart, or grows to be; give a "
                            "larger box, or let it grow for a shorter time");
    }
}

/// Balls that grow until they jam strike ever faster, for ever: where it is sure that they would
/// that is said before.
template <int D>
void check_room_to_grow(std::span<const Body<D>> bodies, const Effects<D>& effects) {
    double filled = 0.0;
    for (const Body<D>& body : bodies) filled += ball_volume<D>(body.radius);
    filled *= std::pow(largest_growth(*effects.growth), D);
    if (filled > effects.box->volume())
        refuse(
            "growth: in the end balls would fill more than the box; give a smaller rate, or let "
            "them grow for a shorter time");
}

/// Whether two balls overlap, exactly; each at its own time, which is the same.
template <int D>
bool overlap(const Ball<D>& a, const Ball<D>& b, const Effects<D>& effects) {
    const Image<D> image = nearest_image(a.x, b.x, effects);
    const Vector<D> d = apart<double>(a.x, b.x, image, effects);
    double size = 0.0;
    for (int k = 0; k < D; ++k) {
        size = std::max({size, std::fabs(a.x[k]), std::fabs(b.x[k])});
        if (image[k] != 0) size = std::max(size, length<double>(effects, k));
    }
    const double radii = a.radius + b.radius;
    // What rounding does to a difference is far less than a part in 2^40 of the numbers.
    if (dot(d, d) > std::max(radii * radii * (1.0 + 0x1p-20), 0x1p-40 * size * size)) return false;
    const PerAxis<Dyadic, D> exact = apart<Dyadic>(a.x, b.x, image, effects);
    const Dyadic sum = Dyadic(a.radius) + Dyadic(b.radius);
    return (dot(exact, exact) - sum * sum).sign() < 0;
}

/// The numbers of the balls, but of points in one place the first one's alone: whatever overlaps
/// the others overlaps that one, and they do not overlap one another.
template <int D>
std::vector<std::uint32_t> without_doubled_points(const State<D>& state) {
    const auto is_before = [](const Vector<D>& a, const Vector<D>& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::set<Vector<D>, decltype(is_before)> points(is_before);
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const Ball<D>& ball = state.balls[i];
        if (ball.radius > 0.0 || points.insert(ball.x).second)
            numbers.push_back(static_cast<std::uint32_t>(i));
    }
    return numbers;
}

/// Two of the balls of these numbers that overlap, the larger number first; any two, so that as
/// many as lie in one place need not all be asked.
template <int D>
std::optional<std::pair<std::uint32_t, std::uint32_t>> any_overlap(
    const State<D>& state, const Effects<D>& effects, std::span<const std::uint32_t> numbers) {
    if (numbers.empty()) return std::nullopt;
    std::vector<typename PairTree<D>::Place> places;
    places.reserve(numbers.size());
    for (const std::uint32_t number : numbers) {
        const Ball<D>& ball = state.balls[number];
        places.push_back({.box = {ball.x, ball.x}, .radius = ball.radius});
    }
    std::optional<std::pair<std::uint32_t, std::uint32_t>> found;
    PairTree<D>(places, effects)
        .visit_pairs([] { return 0.0; },
                     [&](std::uint32_t i, std::uint32_t j) {
                         const std::pair pair(numbers[std::max(i, j)], numbers[std::min(i, j)]);
                         if (overlap(state.balls[pair.first], state.balls[pair.second], effects))
                             found = pair;
                         return !found;
                     });
    return found;
}

/// Names the first ball that overlaps one before it, and the first of these.
template <int D>
void refuse_overlap(const State<D>& state, const Effects<D>& effects) {
    const std::vector<std::uint32_t> numbers = without_doubled_points(state);
    const auto first_before = [&](std::uint32_t ball) {
        return std::ranges::lower_bound(numbers, ball) - numbers.begin();
    };
    auto found = any_overlap<D>(state, effects, numbers);
    if (!found) return;
    // Among the first `free` of them there is none, and some ball before the end of the found one.
    std::ptrdiff_t free = 0;
    while (free < first_before(found->first)) {
        const std::ptrdiff_t middle = free + (first_before(found->first) - free + 1) / 2;
        const auto one = any_overlap<D>(state, effects,
                                        std::span(numbers).first(static_cast<std::size_t>(middle)));
        if (one)
            found = one;
        else
            free = middle;
    }
    const std::uint32_t ball = found->first;
    std::uint32_t other = 0;
    while (!overlap(state.balls[ball], state.balls[other], effects)) ++other;
    throw BallError(ball,
                    "a ball that overlaps ball " + std::to_string(other) + "; balls may touch");
}

}  // namespace

template <int D>
State<D> start(std::span<const Body<D>> bodies, const Effects<D>& effects) {
    const exact::IeeeEnvironment environment;
    check(effects);
    State<D> state;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto number = static_cast<std::int64_t>(i);
        check(bodies[i], number);
        if (effects.box) {
            check_walls(bodies[i], effects, number);
            check_width(bodies[i].radius, effects.growth, effects, 0.0, number);
        }
        check_obstacles(bodies[i], effects, number);
        check_sides_of_segments(bodies[i].radius, effects, number);
        state.balls.push_back({bodies[i].x, bodies[i].v, bodies[i].radius, 0.0});
        state.masses.push_back(bodies[i].mass);
    }
    if (effects.box && effects.growth) check_room_to_grow<D>(bodies, effects);
    state.in_place.resize(bodies.size());
    if (effects.friction)
        for (const Body<D>& body : bodies) state.spins.push_back(body.spin);
    if (effects.contact_duration > 0.0) state.last_strikes.assign(bodies.size(), -infinity);
    refuse_overlap(state, effects);
    return state;
}

template <int D>
void check_parts(const State<D>& state, const Effects<D>& effects) {
    const exact::IeeeEnvironment environment;
    check(effects);
    const std::size_t balls = state.balls.size();
    if (state.masses.size() != balls || state.in_place.size() != balls)
        refuse("a state whose balls and masses differ in number");
    if (state.spins.size() != (effects.friction ? balls : 0) ||
        state.last_strikes.size() != (effects.contact_duration > 0.0 ? balls : 0))
        refuse("a state that does not have what its effects need of each ball");
    const auto number_of_balls = static_cast<std::int64_t>(balls);
    const auto walls = static_cast<std::int64_t>(2 * D + effects.obstacles.size());
    const auto has_pair = [&](std::int32_t a, std::int32_t b) {
        if (a < 0 || a >= number_of_balls) return false;
        const Partner partner = Partner::coded(b);
        if (!partner.is_wall()) return a < b && b < number_of_balls;
        return partner.wall() < 2 * D ? effects.box && !effects.periodic : partner.wall() < walls;
    };
    for (const Passed& passed : state.passed)
        if (!has_pair(passed.a, passed.b) || std::isnan(passed.time))
            refuse("a state with a meeting of balls or walls that it has not");
    std::int64_t ball_before = -1;
    for (const Pressed& pressed : state.pressed) {
        if (pressed.ball <= std::exchange(ball_before, pressed.ball) ||
            pressed.ball >= number_of_balls)
            refuse("a state with pressed balls that it has not, or twice");
        if (!(0.0 <= pressed.quarter && pressed.quarter <= pressed.half &&
              pressed.half <= pressed.last && pressed.last <= state.time))
            refuse("a state with pressed balls at times that are in no order");
    }
    for (const StandingContact<D>& contact : state.contacts)
        if (!effects.contacts || !has_pair(contact.a, contact.b) || !is_finite(contact.push) ||
            !std::ranges::all_of(contact.rub, is_finite))
            refuse("a state with contacts of balls or walls that it has not");
    for (const Spin<D>& spin : state.spins)
        if (!std::ranges::all_of(spin, is_finite)) refuse("a state with a spin that is not finite");
    if (!(state.time >= 0.0 && is_finite(state.time))) refuse("a state's time: give 0 or more");
    for (const double time : state.last_strikes)
        if (!(time <= state.time)) refuse("a state with a last strike that is after its time");
    // A state is from when the last step began, or ended, to when that comes about next.
    if (const TimeSteps<D> steps(effects, state.half_steps);
        state.half_steps > 0 && !(effects.time_step > 0.0))
        refuse("a state between time steps, of which there are none");
    else if (!(steps.last() <= state.time && state.time <= steps.next()))
        refuse("a state whose time is not within the time step that it names");
    for (std::size_t i = 0; i < balls; ++i) {
        const Ball<D>& ball = state.balls[i];
        const auto number = static_cast<std::int64_t>(i);
        if (!std::ranges::all_of(ball.x, is_finite) || !std::ranges::all_of(ball.v, is_finite))
            throw BallError(number, "a coordinate or speed that is not finite");
        check_radius_and_mass(ball.radius, state.masses[i], number);
        if (!(ball.time >= 0.0 && ball.time <= state.time))
            throw BallError(number, "a ball's own time that is not from 0 to that of the state");
    }
}

template <int D>
void check(const State<D>& state, const Effects<D>& effects) {
    const exact::IeeeEnvironment environment;
    check_parts(state, effects);
    for (const Spin<D>& spin : state.spins)
        if (!std::ranges::all_of(spin, is_in_reach)) refuse("a state with a spin beyond 2^200");
    if (!is_in_reach(state.time)) refuse("a state's time: give at most 2^200");
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const Ball<D>& ball = state.balls[i];
        const auto number = static_cast<std::int64_t>(i);
        if (!std::ranges::all_of(ball.x, is_in_reach) || !std::ranges::all_of(ball.v, is_in_reach))
            throw BallError(number, "a coordinate or speed beyond 2^200");
        check_sides_of_segments(ball.radius, effects, number);
        if (effects.box) {
            const bool grows = effects.growth && state.time < effects.growth->until;
            // At the end of growth radii are rounded.
            check_width(ball.radius, grows ? effects.growth : std::nullopt, effects, 0x1p-40,
                        number);
        }
    }
}

template void check_parts(const State<2>&, const Effects<2>&);
template void check_parts(const State<3>&, const Effects<3>&);
template void check(const State<2>&, const Effects<2>&);
template void check(const State<3>&, const Effects<3>&);
template State<2> start(std::span<const Body<2>>, const Effects<2>&);
template State<3> start(std::span<const Body<3>>, const Effects<3>&);

}  // namespace signum::motion
