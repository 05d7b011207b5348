/// Balances of forces: what lies, and what a current carries.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../motion/partner.hpp"
#include "check_parts.hpp"

namespace signum {
namespace {

/// What standing contacts with walls press at the end.
template <int D>
struct WallContact {
    motion::Vector<D> force{};  ///< on the ball
    motion::Vector<D> point{};
};
template <int D>
std::vector<WallContact<D>> wall_contacts(const RunRecord<D>& record) {
    std::vector<WallContact<D>> result;
    const motion::Effects<D>& effects = record.effects();
    const double time = record.moments().back().time;
    for (const motion::StandingContact<D>& contact : record.end().contacts) {
        const auto partner = motion::Partner::coded(contact.b);
        if (!partner.is_wall()) continue;
        const motion::Ball<D>& ball = record.end().balls[static_cast<std::size_t>(contact.a)];
        const BesideWall<D> beside =
            beside_wall(effects, partner.wall(), centre(ball, time, effects), time);
        WallContact<D> found;
        found.point = beside.nearest;
        for (int k = 0; k < D; ++k)
            found.force[k] = (contact.push * beside.normal[k] + contact.rub[k]) / effects.time_step;
        result.push_back(found);
    }
    return result;
}

double mean_radius(const auto& balls, double time, const auto& effects) {
    double sum = 0.0;
    for (const auto& ball : balls) sum += radius_at(ball, time, effects);
    return sum / static_cast<double>(balls.size());
}

/// Where hardly any force acts but at about one height, what is above is a heap on a floor.
template <int D>
std::optional<Check> slope_of_heap(const RunRecord<D>& record,
                                   std::span<const WallContact<D>> floor) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    const double time = record.moments().back().time;
    constexpr std::size_t fewest_on_floor = 3;
    if (!effects.friction || floor.size() < fewest_on_floor) return std::nullopt;
    const double g = norm(effects.gravity);
    motion::Vector<D> up{};
    for (int k = 0; k < D; ++k) up[k] = -effects.gravity[k] / g;
    double level = 0.0;
    double borne = 0.0;
    for (const WallContact<D>& contact : floor) {
        level += dot(up, contact.point) * dot(up, contact.force);
        borne += dot(up, contact.force);
    }
    level /= borne;
    // A grain that has rolled to a wall may lean on it.
    constexpr double most_elsewhere = 0.01;
    const double diameter = 2.0 * mean_radius(state.balls, time, effects);
    double elsewhere = 0.0;
    for (const WallContact<D>& contact : floor)
        if (std::fabs(dot(up, contact.point) - level) > diameter) elsewhere += norm(contact.force);
    if (!(elsewhere <= most_elsewhere * borne)) return std::nullopt;

    const double mass = mass_of(state);
    motion::Vector<D> middle{};
    for (std::size_t i = 0; i < state.balls.size(); ++i)
        middle = middle + state.masses[i] / mass * centre(state.balls[i], time, effects);
    double height = 0.0;
    double width = 0.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        motion::Vector<D> off = centre(state.balls[i], time, effects);
        const double above = dot(up, off);
        height += state.masses[i] / mass * (above - level);
        off = off - middle;
        width += state.masses[i] / mass * norm(off - dot(up, off) * up);
    }
    // Of a triangle both means are a third, of a cone they are a quarter of the height and half the
    // radius.
    const double slope = (D == 2 ? 1.0 : 2.0) * height / width;
    const double friction =
        std::max(effects.friction->coefficient, effects.friction->wall_coefficient);
    Check check;
    check.what = "the heap is not steeper than friction holds";
    check.expected = fmt::format("slope at most μ = {} (Coulomb)", friction);
    check.found =
        fmt::format("{:.3f} = tan {:.1f}°", slope, std::atan(slope) * 180.0 / std::numbers::pi);
    check.deviation = fmt::format("{:.0f} % of it", 100.0 * slope / friction);
    constexpr std::size_t fewest = 30;
    check.judgement = state.balls.size() < fewest ? Judgement::not_told : judged(slope <= friction);
    return check;
}

template <int D>
motion::Vector<D> current_at(const motion::Effects<D>& effects, const motion::Vector<D>& x) {
    motion::Vector<D> u = effects.fluid->velocity;
    for (int k = 0; k < D; ++k) u[k] += dot(effects.fluid->gradient[k], x);
    return u;
}

/// After which a ball that was as fast as the current differs from it by a fortieth, by linear or
/// by quadratic drag alone; infinite in a current that changes by more than a tenth on the way.
template <int D>
double time_of_drag(const motion::Fluid<D>& fluid, double radius, double mass, double fast) {
    const double area = D == 2 ? radius : radius * radius;
    const double time = std::min(std::log(40.0) * mass / (fluid.linear * radius),
                                 39.0 * mass / (fluid.quadratic * area * fast));
    double gradient = 0.0;
    for (const motion::Vector<D>& row : fluid.gradient) gradient += norm(row);
    return gradient * time <= 0.1 ? time : std::numeric_limits<double>::infinity();
}

/// Whether a ball is farther than three radii from all others and from walls.
template <int D>
bool is_alone(const motion::State<D>& state, const motion::Effects<D>& effects, double time,
              std::size_t i) {
    constexpr double clear = 3.0;
    const motion::Vector<D> x = centre(state.balls[i], time, effects);
    const double radius = radius_at(state.balls[i], time, effects);
    for (int wall = first_wall(effects); wall < end_of_walls(effects); ++wall)
        if (!(beside_wall(effects, wall, x, time).distance > (1.0 + clear) * radius)) return false;
    for (std::size_t j = 0; j < state.balls.size(); ++j) {
        if (j == i) continue;
        const double reach = (1.0 + clear) * radius + radius_at(state.balls[j], time, effects);
        const motion::Vector<D> other = centre(state.balls[j], time, effects);
        if (!(square_between(x, other, periodic_box(effects)) > reach * reach)) return false;
    }
    return true;
}
/// At the end, and at all looks back to one at that time or before.
template <int D>
bool has_been_alone(const RunRecord<D>& record, std::size_t i, double since) {
    const double end = record.moments().back().time;
    if (!(record.moments().front().time <= since) ||
        !is_alone(record.end(), record.effects(), end, i))
        return false;
    for (auto look = record.looks().rbegin(); look != record.looks().rend(); ++look) {
        if (!is_alone(look->state, record.effects(), look->time, i)) return false;
        if (look->time <= since) break;
    }
    return true;
}

}  // namespace

template <int D>
std::vector<Check> heap_is_at_rest(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    if (!effects.contacts || !has_gravity(effects) || effects.fluid || effects.periodic ||
        has_moving_walls(effects) || state.balls.empty())
        return {};
    const std::vector<Moment>& moments = record.moments();
    const double g = norm(effects.gravity);
    const double scale = std::sqrt(g * mean_radius(state.balls, moments.back().time, effects));
    constexpr double rest = 1e-4;
    const double fastest = moments.back().fastest;
    const bool is_at_rest = fastest <= rest * scale;
    // What slows down may still come to rest: the last tenth of the run beside that before.
    const std::size_t tenth = moments.size() / 10;
    double late = 0.0;
    double before = 0.0;
    for (std::size_t i = 0; i < tenth; ++i) {
        late += moments[moments.size() - 1 - i].kinetic;
        before += moments[moments.size() - 1 - tenth - i].kinetic;
    }
    const bool slows_down = tenth == 0 || late < 0.5 * before;
    std::vector<Check> result;
    result.push_back({"all has come to rest", "speed 0 at the end",
                      fmt::format("{:.2e}, the fastest ball", fastest),
                      fmt::format("{:.1e} of √(g r); {:.0e} is allowed", fastest / scale, rest),
                      is_at_rest   ? Judgement::good
                      : slows_down ? Judgement::not_told
                                   : Judgement::not_good});

    const std::vector<WallContact<D>> contacts = wall_contacts(record);
    double weight = mass_of(state) * g;
    double borne = 0.0;
    for (const WallContact<D>& contact : contacts) borne -= dot(contact.force, effects.gravity) / g;
    constexpr double allowed = 1e-3;
    const double off = (borne - weight) / weight;
    result.push_back({"the walls bear the weight",
                      fmt::format("Σ m g = {:.6g} (Newton: at rest all forces are 0)", weight),
                      fmt::format("{:.6g}, from {} contacts with walls", borne, contacts.size()),
                      fmt::format("{:+.1e} of it; 0.1 % is allowed", off),
                      is_at_rest ? judged(std::fabs(off) <= allowed) : Judgement::not_told});
    if (is_at_rest)
        if (auto slope = slope_of_heap<D>(record, contacts)) result.push_back(std::move(*slope));
    return result;
}

template <int D>
std::optional<Check> fluid_carries_balls(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    if (!effects.fluid || has_gravity(effects)) return std::nullopt;
    const double time = record.moments().back().time;
    Check check;
    check.what = "the fluid carries balls that are alone";
    check.expected =
        "the velocity of the current where they are: without other forces drag ends there";
    double off = 0.0;
    double of_current = 0.0;
    std::size_t alone = 0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const motion::Vector<D> u = current_at(effects, centre(state.balls[i], time, effects));
        const double fast = norm(u);
        const double needed =
            time_of_drag(*effects.fluid, state.balls[i].radius, state.masses[i], fast);
        if (!has_been_alone(record, i, time - needed)) continue;
        off += norm(u - velocity(state.balls[i], time, effects));
        of_current += fast;
        ++alone;
    }
    constexpr std::size_t fewest = 5;
    check.found = fmt::format(
        "{} of {} balls have been farther than three radii from all else, for as long "
        "as drag takes",
        alone, state.balls.size());
    if (alone < fewest || of_current <= 0.0) return check;
    constexpr double allowed = 0.05;
    const double share = off / of_current;
    check.found = fmt::format("off by {:.4f} of it, the mean of {} balls", share, alone);
    check.deviation = fmt::format("{:.1f} %; 5 % are allowed", 100.0 * share);
    check.judgement = judged(share <= allowed);
    return check;
}

#define SIGNUM_FORCE_CHECKS(D)                                        \
    template std::vector<Check> heap_is_at_rest(const RunRecord<D>&); \
    template std::optional<Check> fluid_carries_balls(const RunRecord<D>&);
SIGNUM_FORCE_CHECKS(2)
SIGNUM_FORCE_CHECKS(3)
#undef SIGNUM_FORCE_CHECKS

}  // namespace signum
