#include "arrangement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <variant>

#include <fmt/format.h>

#include "../generate/uniform.hpp"
#include "beside_wall.hpp"
#include "normal.hpp"

namespace signum {
namespace {

using motion::Body;
using motion::Vector;

/// Between surfaces, as a part of the radii: far more than doubles round by.
constexpr double margin = 1e-9;

/// Balls in cells as wide as two of the largest, so that those that could overlap lie in cells side
/// by side.
template <int D>
class Occupied {
 public:
    Occupied(const Region<D>& region, double largest, std::size_t expected,
             const Surroundings<D>& surroundings)
        : region_(region), obstacles_(surroundings.obstacles) {
        for (const Body<D>& ball : surroundings.balls) largest = std::max(largest, ball.radius);
        // No more cells than about twice the balls.
        const double most = std::pow(2.0 * static_cast<double>(expected) + 64.0, 1.0 / D);
        std::size_t all = 1;
        for (int k = 0; k < D; ++k) {
            const double length = region.box.lengths()[k];
            counts_[k] = static_cast<int>(
                std::clamp(std::floor(length / (2.0 * largest * (1.0 + margin))), 1.0, most));
            all *= static_cast<std::size_t>(counts_[k]);
        }
        first_.assign(all, none);
        for (const Body<D>& ball : surroundings.balls) add(ball.x, ball.radius);
    }

    void add(const Vector<D>& x, double radius) {
        std::size_t cell = 0;
        for (int k = 0; k < D; ++k)
            cell = cell * static_cast<std::size_t>(counts_[k]) +
                   static_cast<std::size_t>(cell_along(x[k], k));
        balls_.push_back({x, radius, first_[cell]});
        first_[cell] = balls_.size() - 1;
    }

    [[nodiscard]] bool is_free(const Vector<D>& x, double radius) const {
        for (const auto& obstacle : obstacles_) {
            const double room = std::visit(
                [&](const auto& wall) { return beside::of(wall, x, 0.0).distance; }, obstacle);
            if (room < radius * (1.0 + margin)) return false;
        }
        return is_free_of_balls(x, radius, 0, 0);
    }

 private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    struct Ball {
        Vector<D> x;
        double radius;
        std::size_t next;  ///< in its cell
    };

    [[nodiscard]] int cell_along(double x, int k) const {
        const double share = (x - region_.box.low[k]) / region_.box.lengths()[k];
        return static_cast<int>(
            std::clamp(std::floor(share * counts_[k]), 0.0, static_cast<double>(counts_[k] - 1)));
    }
    /// Of all cells beside that of x, those whose numbers along the first k axes lead to `cell`.
    bool is_free_of_balls(const Vector<D>& x, double radius, int k, std::size_t cell) const {
        if (k == D) {
            for (std::size_t i = first_[cell]; i != none; i = balls_[i].next)
                if (std::sqrt(square_between(x, balls_[i].x, region_.periodic_box())) <
                    (radius + balls_[i].radius) * (1.0 + margin))
                    return false;
            return true;
        }
        const int own = cell_along(x[k], k);
        for (int step = -1; step <= 1; ++step) {
            int there = own + step;
            if (region_.periodic) {
                there = (there + counts_[k]) % counts_[k];
            } else if (there < 0 || there >= counts_[k]) {
                continue;
            }
            if (!is_free_of_balls(
                    x, radius, k + 1,
                    cell * static_cast<std::size_t>(counts_[k]) + static_cast<std::size_t>(there)))
                return false;
        }
        return true;
    }

    Region<D> region_;
    std::span<const motion::Obstacle<D>> obstacles_;
    motion::PerAxis<int, D> counts_;
    std::vector<std::size_t> first_;
    std::vector<Ball> balls_;
};

double largest_of(std::span<const double> radii) {
    return *std::ranges::max_element(radii);
}

/// Where a centre may lie along an axis.
template <int D>
std::array<double, 2> reach(const Region<D>& region, int k, double radius) {
    const double inset = region.periodic ? 0.0 : radius * (1.0 + margin);
    return {region.box.low[k] + inset, region.box.high[k] - inset};
}

template <int D>
void refuse_too_large(const Region<D>& region, double radius) {
    for (int k = 0; k < D; ++k) {
        const auto [low, high] = reach(region, k, radius);
        if (low > high)
            throw NoPlaceError(fmt::format(
                "a ball of radius {} is wider than its region along {}; give a larger region, or "
                "smaller radii",
                radius, "xyz"[k]));
    }
}

/// How many points a lattice has along each axis, whole steps apart.
template <int D>
using Steps = motion::PerAxis<std::int64_t, D>;

/// Between points of the lattice that are nearest to one another.
template <int D>
double spacing(const Steps<D>& steps, const Region<D>& region, double radius) {
    Vector<D> step;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < D; ++k) {
        const auto [low, high] = reach(region, k, radius);
        const double parts = static_cast<double>(region.periodic ? steps[k] : steps[k] - 1);
        step[k] = parts > 0.0 ? (high - low) / parts : std::numeric_limits<double>::infinity();
        least = std::min(least, 2.0 * step[k]);
        for (int j = 0; j < k; ++j)
            least = std::min(least, std::sqrt(step[j] * step[j] + step[k] * step[k]));
    }
    return least;
}

/// Points with an even sum among so many along each axis.
template <int D>
std::int64_t points_of(const Steps<D>& steps) {
    const std::int64_t all =
        std::accumulate(steps.begin(), steps.end(), std::int64_t{1}, std::multiplies<>());
    return (all + 1) / 2;
}

/// The lattice of at least so many points that are farthest apart.
template <int D>
Steps<D> best_steps(std::int64_t wanted, const Region<D>& region, double radius) {
    Steps<D> best{};
    double widest = -1.0;
    const std::int64_t stride = region.periodic ? 2 : 1;
    const auto last_for = [&](std::int64_t others) {
        std::int64_t last = (2 * wanted - 1 + others - 1) / others;
        last = std::max<std::int64_t>(last, 1);
        return (last + stride - 1) / stride * stride;
    };
    const auto consider = [&](const Steps<D>& steps) {
        if (points_of<D>(steps) < wanted) return;
        const double here = spacing<D>(steps, region, radius);
        if (here <= widest) return;
        widest = here;
        best = steps;
    };
    for (std::int64_t x = stride; x <= 2 * wanted + stride; x += stride) {
        if constexpr (D == 2) {
            consider({x, last_for(x)});
        } else {
            for (std::int64_t y = stride; x * y <= 2 * (2 * wanted + stride); y += stride)
                consider({x, y, last_for(x * y)});
        }
    }
    return best;
}

template <int D>
std::vector<Vector<D>> points_of_lattice(const Steps<D>& steps, const Region<D>& region,
                                         double radius) {
    std::vector<Vector<D>> points;
    Steps<D> at{};
    for (;;) {
        if (std::accumulate(at.begin(), at.end(), std::int64_t{0}) % 2 == 0) {
            Vector<D> x;
            for (int k = 0; k < D; ++k) {
                const auto [low, high] = reach(region, k, radius);
                const std::int64_t parts = region.periodic ? steps[k] : steps[k] - 1;
                const double shift = region.periodic ? 0.5 : 0.0;
                x[k] = parts == 0 ? 0.5 * (low + high)
                                  : low + (high - low) * ((static_cast<double>(at[k]) + shift) /
                                                          static_cast<double>(parts));
            }
            points.push_back(x);
        }
        int axis = D - 1;
        while (++at[axis] == steps[axis]) {
            at[axis] = 0;
            if (axis-- == 0) return points;
        }
    }
}

}  // namespace

template <int D>
std::vector<Vector<D>> place_by_chance(const Region<D>& region, std::span<const double> radii,
                                       const Surroundings<D>& surroundings, std::uint64_t seed) {
    if (radii.empty()) return {};
    constexpr int most_trials = 20'000;
    refuse_too_large(region, largest_of(radii));
    Occupied<D> occupied(region, largest_of(radii), radii.size() + surroundings.balls.size(),
                         surroundings);
    Uniform uniform(seed);
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });
    std::vector<Vector<D>> result(radii.size());
    std::size_t placed = 0;
    for (const std::size_t i : order) {
        int trials = 0;
        do {
            if (++trials > most_trials)
                throw NoPlaceError(fmt::format(
                    "no place by chance for more than {} of {} balls; give arrangement = "
                    "\"lattice\" or \"growth\", fewer balls, or a larger region",
                    placed, radii.size()));
            for (int k = 0; k < D; ++k) {
                const auto [low, high] = reach(region, k, radii[i]);
                result[i][k] = low + uniform() * (high - low);
            }
        } while (!occupied.is_free(result[i], radii[i]));
        occupied.add(result[i], radii[i]);
        ++placed;
    }
    return result;
}

template <int D>
std::vector<Vector<D>> place_on_lattice(const Region<D>& region, std::span<const double> radii,
                                        const Surroundings<D>& surroundings) {
    if (radii.empty()) return {};
    const double largest = largest_of(radii);
    refuse_too_large(region, largest);
    const Occupied<D> occupied(region, largest, surroundings.balls.size(), surroundings);
    const auto number = static_cast<std::int64_t>(radii.size());
    // Points that something else takes are made up for by a finer lattice.
    for (std::int64_t wanted = number;; wanted += wanted / 20 + 1) {
        const Steps<D> steps = best_steps<D>(wanted, region, largest);
        if (spacing<D>(steps, region, largest) < 2.0 * largest * (1.0 + margin)) {
            throw NoPlaceError(fmt::format(
                "no lattice of {} balls as large as the largest fits into the region; give "
                "arrangement = \"growth\", fewer balls, or a larger region",
                radii.size()));
        }
        std::vector<Vector<D>> points;
        for (const Vector<D>& x : points_of_lattice<D>(steps, region, largest))
            if (occupied.is_free(x, largest)) points.push_back(x);
        if (points.size() < radii.size()) continue;
        std::vector<Vector<D>> result;
        for (std::size_t i = 0; i < radii.size(); ++i)
            result.push_back(points[i * points.size() / radii.size()]);
        return result;
    }
}

template <int D>
std::vector<Vector<D>> place_by_growth(const Region<D>& region, std::span<const double> radii,
                                       const Surroundings<D>& surroundings, std::uint64_t seed) {
    if (radii.empty()) return {};
    for (const Body<D>& ball : surroundings.balls) {
        bool is_inside = true;
        for (int k = 0; k < D; ++k)
            is_inside = is_inside && ball.x[k] + ball.radius > region.box.low[k] &&
                        ball.x[k] - ball.radius < region.box.high[k];
        if (is_inside)
            throw NoPlaceError(
                "balls that grow need their region alone, and there are balls in it; give "
                "regions apart, or another arrangement");
    }
    double filled = 0.0;
    double mean = 0.0;
    for (const double radius : radii) {
        filled += motion::ball_volume<D>(radius) / region.volume;
        mean += radius / static_cast<double>(radii.size());
    }
    if (filled > 0.999)
        throw NoPlaceError(fmt::format(
            "balls of {:.3g} times the region's size; give fewer or smaller balls, or a "
            "larger region",
            filled));
    // So loose that chance finds a place for all.
    constexpr double loose = D == 2 ? 0.2 : 0.1;
    double share = 0.9;
    const auto filled_then = [&] { return filled * (D == 2 ? 1.0 : share) * share * share; };
    while (filled_then() > loose) share *= 0.95;
    std::vector<double> small(radii.begin(), radii.end());
    for (double& radius : small) radius *= share;
    const std::vector<Vector<D>> centres =
        place_by_chance(region, small, Surroundings<D>{{}, surroundings.obstacles}, seed);
    std::vector<Body<D>> bodies;
    Normal normal(seed + 1);
    for (std::size_t i = 0; i < small.size(); ++i) {
        Body<D> body{centres[i], {}, small[i], 1.0, {}};
        for (int k = 0; k < D; ++k) body.v[k] = mean * normal();
        bodies.push_back(body);
    }
    motion::Effects<D> effects;
    effects.box = region.box;
    effects.periodic = region.periodic;
    effects.obstacles.assign(surroundings.obstacles.begin(), surroundings.obstacles.end());
    // Walls stand still as long as the scene has not begun.
    for (auto& obstacle : effects.obstacles) {
        if (auto* const plane = std::get_if<motion::HalfSpace<D>>(&obstacle)) plane->speed = 0.0;
        if (auto* const sphere = std::get_if<motion::Sphere<D>>(&obstacle)) sphere->velocity = {};
    }
    // Radii grow at a fiftieth of the balls' speed, and a little beyond what is wanted.
    const double rate = 0.02 / share;
    const double end = ((1.0 + margin) / share - 1.0) / rate;
    effects.growth = motion::Growth{rate, end};
    motion::Limits limits;
    limits.until = end;
    limits.strikes = 100'000 + 5000 * static_cast<std::uint64_t>(radii.size());
    motion::Outcome outcome;
    motion::State<D> state;
    try {
        motion::Simulation<D> simulation(motion::start<D>(bodies, effects), effects);
        outcome = simulation.run(limits);
        state = simulation.state();
    } catch (const motion::BallError& error) {
        // Too wide for a periodic box, or beside a wall of which doubles do not tell where it is.
        throw NoPlaceError(
            fmt::format("ball {} of the group, as it grows: {}", error.ball(), error.what()));
    } catch (const std::range_error& error) {
        throw NoPlaceError(fmt::format("balls as they grow: {}", error.what()));
    }
    if (outcome.ending != motion::Ending::until && outcome.ending != motion::Ending::nothing)
        throw NoPlaceError(fmt::format(
            "the balls jam when they have grown to {:.3g} of their radii; give fewer balls, or a "
            "larger region",
            share * (1.0 + rate * state.time)));
    std::vector<Vector<D>> result;
    for (const motion::Ball<D>& ball : state.balls)
        result.push_back(centre_in_box(ball, end, effects));
    return result;
}

#define SIGNUM_ARRANGEMENTS(D)                                                                  \
    template std::vector<Vector<D>> place_by_chance(const Region<D>&, std::span<const double>,  \
                                                    const Surroundings<D>&, std::uint64_t);     \
    template std::vector<Vector<D>> place_on_lattice(const Region<D>&, std::span<const double>, \
                                                     const Surroundings<D>&);                   \
    template std::vector<Vector<D>> place_by_growth(const Region<D>&, std::span<const double>,  \
                                                    const Surroundings<D>&, std::uint64_t);
SIGNUM_ARRANGEMENTS(2)
SIGNUM_ARRANGEMENTS(3)
#undef SIGNUM_ARRANGEMENTS

}  // namespace signum
