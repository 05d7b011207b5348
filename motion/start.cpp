/// What balls must be to begin.

#include <algorithm>
#include <cmath>
#include <string>

#include "apart.hpp"
#include "simulation.hpp"
#include "structures/grid.hpp"

namespace signum::motion {
namespace {

using exact::Dyadic;

/// Numbers whose squares, and squares of squares, are doubles with the errors of their products.
constexpr double largest = 0x1p150;

bool is_within(double number) noexcept {
    const double magnitude = std::fabs(number);
    return magnitude == 0.0 || (magnitude >= 1.0 / largest && magnitude <= largest);
}
bool is_restitution(double number) noexcept {
    return number >= 0.0 && number <= 1.0;
}

template <int D>
void check(const Effects<D>& effects) {
    for (const double g : effects.gravity)
        if (!is_within(g))
            throw std::invalid_argument("gravity: give 0 or finite numbers of 2^-150 to 2^150");
    if (!is_restitution(effects.restitution) || !is_restitution(effects.wall_restitution))
        throw std::invalid_argument("restitution: give a number from 0 to 1");
    if (effects.periodic && !effects.box)
        throw std::invalid_argument("a periodic world needs a box");
    if (!effects.box) return;
    for (int k = 0; k < D; ++k) {
        const double low = effects.box->low[k];
        const double high = effects.box->high[k];
        if (!is_within(low) || !is_within(high) || !(low < high)) {
            throw std::invalid_argument(
                "box: give the lower corner, then the upper one, each 0 or a finite number of "
                "2^-150 to 2^150");
        }
    }
}

void check_radius_and_mass(double radius, double mass, std::int64_t number) {
    if (!(radius >= 0.0) || !is_within(radius))
        throw BallError(number,
                        "a radius that is negative, not finite, or beyond 2^150 or below "
                        "2^-150 and not 0");
    if (!(mass > 0.0)) throw BallError(number, "a mass that is not positive; a ball needs one");
    if (!is_within(mass)) throw BallError(number, "a mass beyond 2^150, or below 2^-150");
}

template <int D>
void check(const Body<D>& body, std::int64_t number) {
    for (int k = 0; k < D; ++k)
        if (!is_within(body.x[k]) || !is_within(body.v[k]))
            throw BallError(number,
                            "a coordinate or speed that is not finite, or beyond 2^150 or "
                            "below 2^-150 and not 0");
    check_radius_and_mass(body.radius, body.mass, number);
}

/// Exactly.
template <int D>
void check_walls(const Body<D>& body, const Effects<D>& effects, std::int64_t number) {
    for (int k = 0; k < D; ++k) {
        const Dyadic x(body.x[k]);
        const Dyadic low(effects.box->low[k]);
        const Dyadic high(effects.box->high[k]);
        const Dyadic radius(body.radius);
        if (effects.periodic) {
            if ((x - low).sign() < 0 || (high - x).sign() < 0)
                throw BallError(number, "a centre outside the periodic box; give one inside");
            if ((high - low - 8 * radius).sign() < 0)
                throw BallError(number,
                                "a ball whose diameter is more than a quarter of the periodic "
                                "box; give a larger box");
            continue;
        }
        if ((x - low - radius).sign() < 0 || (high - x - radius).sign() < 0)
            throw BallError(number, "a ball outside its walls; it may touch them from within");
    }
}

/// Whether two balls overlap, exactly; each at its own time, which is the same.
template <int D>
bool overlap(const Ball<D>& a, const Ball<D>& b, const World<D>& world) {
    const Image<D> image = nearest_image(a.x, b.x, world.effects);
    Vector<D> d;
    double size = 0.0;
    for (int k = 0; k < D; ++k) {
        d[k] = apart<double>(a.x, b.x, k, image, world.effects);
        size = std::max({size, std::fabs(a.x[k]), std::fabs(b.x[k])});
        if (image[k] != 0) size = std::max(size, length<double>(world.effects, k));
    }
    const double radii = a.radius + b.radius;
    // What rounding does to a difference is far less than a part in 2^40 of the numbers.
    if (dot(d, d) > std::max(radii * radii * (1.0 + 0x1p-20), 0x1p-40 * size * size)) return false;
    Dyadic square;
    for (int k = 0; k < D; ++k) {
        const Dyadic exact = apart<Dyadic>(a.x, b.x, k, image, world.effects);
        square += exact * exact;
    }
    const Dyadic sum = Dyadic(a.radius) + Dyadic(b.radius);
    return (square - sum * sum).sign() < 0;
}

}  // namespace

template <int D>
State<D> start(std::span<const Body<D>> bodies, const Effects<D>& effects) {
    check(effects);
    State<D> state;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto number = static_cast<std::int64_t>(i);
        check(bodies[i], number);
        if (effects.box) check_walls(bodies[i], effects, number);
        state.balls.push_back({bodies[i].x, bodies[i].v, bodies[i].radius, 0.0});
        state.masses.push_back(bodies[i].mass);
    }
    state.in_place.resize(bodies.size());
    const World<D> world({state.balls.begin(), state.balls.end()}, effects, 0.0);
    const Grid<D> levels(world, Structure::levels);
    for (Slot i = 0; i < world.balls.size(); ++i) {
        Slot first = i;
        levels.near(i, [&](Slot j) {
            if (j < first && overlap(world.balls[i], world.balls[j], world)) first = j;
        });
        if (first < i)
            throw BallError(
                i, "a ball that overlaps ball " + std::to_string(first) + "; balls may touch");
    }
    return state;
}

template <int D>
void check(const State<D>& state, const Effects<D>& effects) {
    check(effects);
    const std::size_t balls = state.balls.size();
    if (state.masses.size() != balls || state.in_place.size() != balls)
        throw std::invalid_argument("a state whose balls and masses differ in number");
    if (!(state.time >= 0.0 && std::isfinite(state.time)))
        throw std::invalid_argument("a state's time: give 0 or more");
    for (std::size_t i = 0; i < balls; ++i) {
        const Ball<D>& ball = state.balls[i];
        const auto number = static_cast<std::int64_t>(i);
        for (int k = 0; k < D; ++k)
            if (!std::isfinite(ball.x[k]) || !std::isfinite(ball.v[k]))
                throw BallError(number, "a coordinate or speed that is not finite");
        check_radius_and_mass(ball.radius, state.masses[i], number);
        if (!(ball.time >= 0.0 && ball.time <= state.time))
            throw BallError(number, "a ball's own time that is not from 0 to that of the state");
    }
}

template void check(const State<2>&, const Effects<2>&);
template void check(const State<3>&, const Effects<3>&);
template State<2> start(std::span<const Body<2>>, const Effects<2>&);
template State<3> start(std::span<const Body<3>>, const Effects<3>&);

}  // namespace signum::motion
