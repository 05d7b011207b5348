#include "checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "arrangement.hpp"
#include "beside_wall.hpp"

namespace signum {
namespace {

constexpr double ulp = 0x1p-53;

Judgement judged(bool is_good) {
    return is_good ? Judgement::good : Judgement::not_good;
}

template <int D>
bool has_moving_walls(const motion::Effects<D>& effects) {
    const auto moves = [](const auto& obstacle) {
        using Kind = std::decay_t<decltype(obstacle)>;
        if constexpr (std::is_same_v<Kind, motion::HalfSpace<D>>) return obstacle.speed != 0.0;
        if constexpr (std::is_same_v<Kind, motion::Sphere<D>>)
            return obstacle.velocity != motion::Vector<D>{};
        return false;
    };
    return effects.shake || std::ranges::any_of(effects.obstacles, [&](const auto& obstacle) {
               return std::visit(moves, obstacle);
           });
}

template <int D>
bool has_walls(const motion::Effects<D>& effects) {
    return first_wall(effects) < end_of_walls(effects);
}

/// Nothing but elastic strikes and gravity acts.
template <int D>
bool is_elastic(const motion::Effects<D>& effects) {
    return effects.restitution == 1.0 && (!has_walls(effects) || effects.wall_restitution == 1.0) &&
           !effects.friction && !effects.growth && !effects.fluid && !effects.contacts &&
           effects.time_step == 0.0;
}

template <int D>
bool has_gravity(const motion::Effects<D>& effects) {
    return effects.gravity != motion::Vector<D>{};
}

/// In a periodic box with nothing else in it.
template <int D>
bool is_endless(const motion::Effects<D>& effects) {
    return effects.periodic && effects.obstacles.empty() && !has_gravity(effects);
}

template <int D>
double mass_of(const motion::State<D>& state) {
    return std::accumulate(state.masses.begin(), state.masses.end(), 0.0);
}

/// What rounding may add to a sum over n balls, as a part of the sum of its terms: a few last
/// places at each strike of each ball, and those of the sum.
template <int D>
double rounding_of_sum(const RunRecord<D>& record) {
    const auto n = static_cast<double>(record.end().balls.size());
    const auto strikes = static_cast<double>(record.moments().back().strikes);
    return ulp * (100.0 + n + 16.0 * strikes / std::max(n, 1.0));
}

/// Twice the energy of motion relative to the mean, a degree of freedom.
template <int D>
double temperature(const Moment& moment, double mass, std::size_t balls) {
    double square = 0.0;
    for (const double p : moment.momentum) square += p * p;
    const double relative = moment.kinetic - 0.5 * square / mass;
    return 2.0 * relative / (D * (static_cast<double>(balls) - 1.0));
}

std::span<const Moment> second_half(const std::vector<Moment>& moments) {
    const double middle = 0.5 * (moments.front().time + moments.back().time);
    const auto begin =
        std::ranges::find_if(moments, [&](const Moment& each) { return each.time >= middle; });
    return {begin, moments.end()};
}

/// From the last one back to the middle of the run, those between which there are that many
/// strikes.
template <int D>
std::vector<const typename RunRecord<D>::Look*> looks_apart(const RunRecord<D>& record,
                                                            double strikes) {
    std::vector<const typename RunRecord<D>::Look*> result;
    const double middle = 0.5 * (record.moments().front().time + record.moments().back().time);
    for (auto look = record.looks().rbegin(); look != record.looks().rend(); ++look) {
        if (look->time < middle) break;
        if (result.empty() ||
            static_cast<double>(result.back()->strikes - look->strikes) >= strikes)
            result.push_back(&*look);
    }
    return result;
}

/// Samples that should be uniform between 0 and 1, counted in cells.
class ChiSquared {
 public:
    void add(double share) {
        ++counts_[static_cast<std::size_t>(
            std::clamp(share * cells, 0.0, static_cast<double>(cells - 1)))];
        ++samples_;
    }
    [[nodiscard]] double value() const {
        const double expected = static_cast<double>(samples_) / cells;
        double sum = 0.0;
        for (const std::size_t count : counts_) {
            const double off = static_cast<double>(count) - expected;
            sum += off * off / expected;
        }
        return sum;
    }
    /// In standard deviations above what is expected (Wilson, Hilferty, Proc. Natl. Acad. Sci.
    /// 17:684, 1931).
    [[nodiscard]] double deviation() const {
        constexpr double spread = 2.0 / (9.0 * freedoms);
        return (std::cbrt(value() / freedoms) - (1.0 - spread)) / std::sqrt(spread);
    }
    /// One in ten thousand is beyond 3.7.
    void put(Check& check, std::size_t looks) const {
        constexpr double most = 3.7;
        constexpr std::size_t least_samples = 20 * cells;
        check.found = fmt::format("χ² = {:.1f} over {} cells, {} samples at {} times", value(),
                                  cells, samples_, looks);
        check.deviation = fmt::format("{:+.1f} standard deviations", deviation());
        check.judgement =
            samples_ < least_samples ? Judgement::not_told : judged(deviation() < most);
    }

 private:
    static constexpr int cells = 20;
    static constexpr int freedoms = cells - 1;
    std::array<std::size_t, cells> counts_{};
    std::size_t samples_ = 0;
};

/// The share of balls of a gas whose energy is below u times T.
template <int D>
double maxwell_share(double u) {
    if constexpr (D == 2) return -std::expm1(-u);
    return std::erf(std::sqrt(u)) - 2.0 * std::sqrt(u / std::numbers::pi) * std::exp(-u);
}

/// ln T as a line over ln(1 + t/τ).
struct HaffFit {
    double tau = 0.0;
    double exponent = 0.0;
    double rest = 0.0;  ///< the sum of squares
};
HaffFit fit_haff(std::span<const double> times, std::span<const double> logs, double tau) {
    const auto n = static_cast<double>(times.size());
    double sx = 0.0;
    double sy = 0.0;
    double sxx = 0.0;
    double sxy = 0.0;
    double syy = 0.0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double x = std::log1p(times[i] / tau);
        sx += x;
        sy += logs[i];
        sxx += x * x;
        sxy += x * logs[i];
        syy += logs[i] * logs[i];
    }
    const double xx = sxx - sx * sx / n;
    const double xy = sxy - sx * sy / n;
    return {tau, -xy / xx, std::max(0.0, syy - sy * sy / n - xy * xy / xx)};
}

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
        if (contact.b >= 0) continue;
        const motion::Ball<D>& ball = record.end().balls[static_cast<std::size_t>(contact.a)];
        const BesideWall<D> beside =
            beside_wall(effects, -1 - contact.b, centre(ball, time, effects), time);
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

/// Where nearly all of the weight is borne at about one height, what is above is a heap on a floor.
template <int D>
std::optional<Check> slope_of_heap(const RunRecord<D>& record,
                                   std::span<const WallContact<D>> floor) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    const double time = record.moments().back().time;
    constexpr std::size_t fewest_on_floor = 3;
    if (!effects.friction || floor.size() < fewest_on_floor) return std::nullopt;
    const double g = std::sqrt(dot(effects.gravity, effects.gravity));
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
        if (std::fabs(dot(up, contact.point) - level) > diameter)
            elsewhere += std::fabs(dot(up, contact.force));
    if (!(elsewhere <= most_elsewhere * borne)) return std::nullopt;

    const double mass = mass_of(state);
    motion::Vector<D> middle{};
    for (std::size_t i = 0; i < state.balls.size(); ++i)
        for (int k = 0; k < D; ++k)
            middle[k] += state.masses[i] / mass * coordinate(state.balls[i], k, time, effects);
    double height = 0.0;
    double width = 0.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        motion::Vector<D> off = centre(state.balls[i], time, effects);
        const double above = dot(up, off);
        height += state.masses[i] / mass * (above - level);
        for (int k = 0; k < D; ++k) off[k] -= middle[k];
        const double along = dot(up, off);
        for (int k = 0; k < D; ++k) off[k] -= along * up[k];
        width += state.masses[i] / mass * std::sqrt(dot(off, off));
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

}  // namespace

template <int D>
std::optional<Check> energy_is_conserved(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    if (!is_elastic(effects) || has_moving_walls(effects) ||
        (effects.periodic && has_gravity(effects)))
        return std::nullopt;
    const std::vector<Moment>& moments = record.moments();
    double scale = 0.0;
    double most = 0.0;
    for (const Moment& moment : moments) {
        scale = std::max(scale, moment.terms_of_total);
        most = std::max(most, std::fabs(moment.total - moments.front().total));
    }
    if (!(scale > 0.0)) return std::nullopt;
    const double allowed = rounding_of_sum(record);
    return Check{"energy is conserved", "E(t) = E(0), for all strikes are elastic",
                 fmt::format("{:.9g} at the start, {:.9g} at the end", moments.front().total,
                             moments.back().total),
                 fmt::format("{:.1e} of it at most; rounding allows {:.1e}", most / scale, allowed),
                 judged(most <= allowed * scale)};
}

template <int D>
std::optional<Check> momentum_is_conserved(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    if (!is_endless(effects) || effects.fluid) return std::nullopt;
    const std::vector<Moment>& moments = record.moments();
    double scale = 0.0;
    double most = 0.0;
    for (const Moment& moment : moments) {
        scale = std::max(scale, moment.terms_of_momentum);
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, std::fabs(moment.momentum[k] - moments.front().momentum[k]));
    }
    if (!(scale > 0.0)) return std::nullopt;
    const double allowed = rounding_of_sum(record);
    return Check{"momentum is conserved", "Σ m v stays, for strikes are all that acts",
                 fmt::format("changes by at most {:.1e}; Σ m |v| is {:.6g}", most, scale),
                 fmt::format("{:.1e} of it at most; rounding allows {:.1e}", most / scale, allowed),
                 judged(most <= allowed * scale)};
}

template <int D>
std::optional<Check> gas_has_known_pressure(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    const std::size_t n = state.balls.size();
    if (!is_elastic(effects) || !is_endless(effects) || n < 2) return std::nullopt;
    const double radius = state.balls.front().radius;
    if (std::ranges::any_of(state.balls, [&](const auto& b) { return b.radius != radius; }))
        return std::nullopt;
    const double eta = record.moments().back().packing;
    const double most_packing = D == 2 ? 0.6 : 0.49;
    if (eta > most_packing || !(eta > 0.0)) return std::nullopt;
    const double expected =
        D == 2 ? (1.0 + eta * eta / 8.0) / std::pow(1.0 - eta, 2)
               : (1.0 + eta + eta * eta - eta * eta * eta) / std::pow(1.0 - eta, 3);
    Check check;
    check.what = "the pressure is that of hard balls";
    check.expected = fmt::format("Z = pV/NkT = {:.4f}: {}, packing {:.4g}", expected,
                                 D == 2 ? "(1 + η²/8)/(1 − η)², Henderson 1975"
                                        : "(1 + η + η² − η³)/(1 − η)³, Carnahan and Starling 1969",
                                 eta);
    constexpr std::size_t blocks = 10;
    const std::span<const Moment> half = second_half(record.moments());
    check.found = "fewer than ten frames in the second half";
    if (half.size() <= blocks) return check;
    const double mass = mass_of(state);
    double mean = 0.0;
    double square = 0.0;
    for (std::size_t block = 0; block < blocks; ++block) {
        const Moment& from = half[block * (half.size() - 1) / blocks];
        const Moment& to = half[(block + 1) * (half.size() - 1) / blocks];
        const double t = temperature<D>(to, mass, n);
        const double z = 1.0 + (to.virial - from.virial) /
                                   (D * static_cast<double>(n) * t * (to.time - from.time));
        mean += z / blocks;
        square += z * z / blocks;
    }
    // Student's t of nine degrees of freedom, 95 %.
    constexpr double quantile = 2.26;
    const double error = quantile * std::sqrt(std::max(0.0, square - mean * mean) / (blocks - 1.0));
    constexpr double allowed = 0.005;
    const double off = std::fabs(mean - expected);
    check.found = fmt::format("{:.4f} ± {:.4f} (95 %, ten blocks of the second half)", mean, error);
    check.deviation = fmt::format("{:+.2f} %; 0.5 % and the error are allowed",
                                  100.0 * (mean - expected) / expected);
    check.judgement = error > 2.0 * allowed * expected ? Judgement::not_told
                                                       : judged(off <= allowed * expected + error);
    return check;
}

template <int D>
std::optional<Check> speeds_are_maxwellian(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const std::size_t n = record.end().balls.size();
    if (!is_elastic(effects) || !is_endless(effects) || n < 2) return std::nullopt;
    Check check;
    check.what = "speeds are those of Maxwell";
    check.expected = D == 2 ? "energy above E: the share exp(−E/T) of all"
                            : "energy above E: the share Γ(3/2, E/T)/Γ(3/2) of all";
    const auto looks = looks_apart(record, 2.0 * static_cast<double>(n));
    const double mass = mass_of(record.end());
    const Moment& last = record.moments().back();
    const double t = temperature<D>(last, mass, n);
    check.found = "less than twenty strikes a ball before the second half, or nothing moves";
    // Before that many speeds are those of the start.
    if (looks.empty() ||
        static_cast<double>(looks.back()->strikes) < 10.0 * static_cast<double>(n) || !(t > 0.0))
        return check;
    ChiSquared cells;
    for (const auto* look : looks) {
        for (std::size_t i = 0; i < n; ++i) {
            double square = 0.0;
            for (int k = 0; k < D; ++k) {
                const double v = speed(look->state.balls[i], k, look->time, effects) -
                                 last.momentum[static_cast<std::size_t>(k)] / mass;
                square += v * v;
            }
            cells.add(maxwell_share<D>(0.5 * look->state.masses[i] * square / t));
        }
    }
    cells.put(check, looks.size());
    return check;
}

template <int D>
std::optional<Check> gas_cools_as_haff_says(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const std::size_t n = record.end().balls.size();
    if (!is_endless(effects) || !(effects.restitution < 1.0) || effects.speed_law ||
        effects.friction || effects.growth || effects.fluid || effects.contacts ||
        effects.time_step > 0.0 || n < 2)
        return std::nullopt;
    const std::vector<Moment>& moments = record.moments();
    const double mass = mass_of(record.end());
    const double first = temperature<D>(moments.front(), mass, n);
    if (!(first > 0.0)) return std::nullopt;
    Check check;
    check.what = "the gas cools as Haff says";
    check.expected = "T = T₀/(1 + t/τ)^2 until clusters form (Haff 1983); fitted down to T₀/10";
    std::vector<double> times;
    std::vector<double> logs;
    for (const Moment& moment : moments) {
        const double t = temperature<D>(moment, mass, n);
        if (t < 0.1 * first) break;
        times.push_back(moment.time - moments.front().time);
        logs.push_back(std::log(t));
    }
    constexpr std::size_t fewest = 8;
    const double cooled = std::exp(logs.back() - logs.front());
    check.found =
        fmt::format("{} frames before T is a tenth, down to {:.2f} T₀", times.size(), cooled);
    if (times.size() < fewest || cooled > 0.5) return check;
    // A range of τ wide enough for any exponent near 2, in steps that do not show.
    std::vector<HaffFit> fits;
    for (double tau = times.back() / 100.0; tau < 100.0 * times.back(); tau *= 1.005)
        fits.push_back(fit_haff(times, logs, tau));
    const HaffFit best = *std::ranges::min_element(fits, {}, &HaffFit::rest);
    const double accepted = best.rest * (1.0 + 4.0 / (static_cast<double>(times.size()) - 3.0));
    double low = best.exponent;
    double high = best.exponent;
    for (const HaffFit& fit : fits) {
        if (fit.rest > accepted) continue;
        low = std::min(low, fit.exponent);
        high = std::max(high, fit.exponent);
    }
    const double error = std::max(high - best.exponent, best.exponent - low);
    // Vortices form early, and slow the cooling by some per cent a decade.
    constexpr double allowed = 0.2;
    check.found =
        fmt::format("exponent {:.3f}, {:.3f} to {:.3f} (95 %, from {} frames); τ = {:.4g}",
                    best.exponent, low, high, times.size(), best.tau);
    check.deviation = fmt::format("{:+.3f}; 0.2 and the error are allowed", best.exponent - 2.0);
    check.judgement = error > 2.5 * allowed ? Judgement::not_told
                                            : judged(low - allowed <= 2.0 && 2.0 <= high + allowed);
    return check;
}

template <int D>
std::optional<Check> heights_are_barometric(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    const std::size_t n = state.balls.size();
    if (!is_elastic(effects) || !effects.box || effects.periodic || effects.shake ||
        !effects.obstacles.empty() || !has_gravity(effects) || n < 2)
        return std::nullopt;
    int axis = 0;
    while (effects.gravity[axis] == 0.0) ++axis;
    for (int k = axis + 1; k < D; ++k)
        if (effects.gravity[k] != 0.0) return std::nullopt;
    const double g = std::fabs(effects.gravity[axis]);
    const std::span<const Moment> half = second_half(record.moments());
    double kinetic = 0.0;
    for (const Moment& moment : half) kinetic += moment.kinetic / static_cast<double>(half.size());
    const double t = 2.0 * kinetic / (D * static_cast<double>(n));
    if (!(t > 0.0)) return std::nullopt;
    // How dense it is at the floor: all balls within the mean height.
    const double tall = effects.box->high[axis] - effects.box->low[axis];
    const double mean_height = std::min(tall, t * static_cast<double>(n) / (mass_of(state) * g));
    constexpr double most_packing = 0.02;
    if (record.moments().back().packing * tall / mean_height > most_packing) return std::nullopt;

    Check check;
    check.what = "heights are barometric";
    check.expected = "density ∝ exp(−m g h / T)";
    const auto looks = looks_apart(record, 20.0 * static_cast<double>(n));
    ChiSquared cells;
    for (const auto* look : looks)
        for (std::size_t i = 0; i < n; ++i) {
            const motion::Ball<D>& ball = look->state.balls[i];
            const double x = coordinate(ball, axis, look->time, effects);
            const double height = (effects.gravity[axis] < 0.0 ? x - effects.box->low[axis]
                                                               : effects.box->high[axis] - x) -
                                  ball.radius;
            const double rate = look->state.masses[i] * g / t;
            cells.add(std::expm1(-rate * height) / std::expm1(-rate * (tall - 2.0 * ball.radius)));
        }
    cells.put(check, looks.size());
    return check;
}

template <int D>
std::vector<Check> heap_is_at_rest(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    const motion::State<D>& state = record.end();
    if (!effects.contacts || !has_gravity(effects) || effects.fluid || effects.periodic ||
        has_moving_walls(effects) || state.balls.empty())
        return {};
    const std::vector<Moment>& moments = record.moments();
    const double g = std::sqrt(dot(effects.gravity, effects.gravity));
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
        "the speed of the current where they are: without other forces drag ends there";
    double of_balls = 0.0;
    double of_current = 0.0;
    std::size_t alone = 0;
    constexpr double clear = 3.0;
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const motion::Vector<D> x = centre(state.balls[i], time, effects);
        const double radius = radius_at(state.balls[i], time, effects);
        bool is_alone = true;
        for (int wall = first_wall(effects); is_alone && wall < end_of_walls(effects); ++wall)
            is_alone = beside_wall(effects, wall, x, time).distance > (1.0 + clear) * radius;
        for (std::size_t j = 0; is_alone && j < state.balls.size(); ++j) {
            if (j == i) continue;
            double square = 0.0;
            for (int k = 0; k < D; ++k) {
                double d = coordinate(state.balls[j], k, time, effects) - x[k];
                if (effects.periodic) {
                    const double side = effects.box->high[k] - effects.box->low[k];
                    d -= side * std::nearbyint(d / side);
                }
                square += d * d;
            }
            const double reach = (1.0 + clear) * radius + radius_at(state.balls[j], time, effects);
            is_alone = square > reach * reach;
        }
        if (!is_alone) continue;
        motion::Vector<D> current = effects.fluid->velocity;
        motion::Vector<D> v;
        for (int k = 0; k < D; ++k) {
            current[k] += dot(effects.fluid->gradient[k], x);
            v[k] = speed(state.balls[i], k, time, effects);
        }
        of_balls += std::sqrt(dot(v, v));
        of_current += std::sqrt(dot(current, current));
        ++alone;
    }
    constexpr std::size_t fewest = 5;
    check.found = fmt::format("{} of {} balls are farther than three radii from all else", alone,
                              state.balls.size());
    if (alone < fewest || !(of_current > 0.0)) return check;
    constexpr double allowed = 0.05;
    const double ratio = of_balls / of_current;
    check.found = fmt::format("{:.4f} of it, the mean of {} balls", ratio, alone);
    check.deviation = fmt::format("{:+.1f} %; 5 % are allowed", 100.0 * (ratio - 1.0));
    check.judgement = judged(std::fabs(ratio - 1.0) <= allowed);
    return check;
}

template <int D>
std::vector<Check> nothing_overlaps(const RunRecord<D>& record) {
    const bool has_contacts = record.effects().contacts.has_value();
    // Contacts that stand wait for the next step up to an overlap of a 256th, and a little longer.
    const double allowed = has_contacts ? 0x1.4p-8 : 0x1p-30;
    double of_balls = 0.0;
    double of_walls = 0.0;
    for (const Moment& moment : record.moments()) {
        of_balls = std::max(of_balls, moment.overlap_of_balls);
        of_walls = std::max(of_walls, moment.overlap_of_walls);
    }
    const auto check = [&](std::string what, double deepest) {
        return Check{std::move(what),
                     fmt::format("at most {:.0e} of a radius, {}", allowed,
                                 has_contacts ? "by contacts that stand" : "by rounding"),
                     deepest > 0.0 ? fmt::format("{:.1e} of a radius at most", deepest)
                                   : std::string("none"),
                     fmt::format("over {} frames", record.moments().size()),
                     judged(deepest <= allowed)};
    };
    std::vector<Check> result = {check("no two balls overlap", of_balls)};
    if (has_walls(record.effects()))
        result.push_back(check("no ball is in a wall, or outside", of_walls));
    return result;
}

template <int D>
std::vector<Check> check_run(const RunRecord<D>& record) {
    std::vector<Check> result;
    const auto add = [&](std::optional<Check> check) {
        if (check) result.push_back(std::move(*check));
    };
    add(energy_is_conserved(record));
    add(momentum_is_conserved(record));
    add(gas_has_known_pressure(record));
    add(speeds_are_maxwellian(record));
    add(gas_cools_as_haff_says(record));
    add(heights_are_barometric(record));
    for (Check& check : heap_is_at_rest(record)) add(std::move(check));
    add(fluid_carries_balls(record));
    for (Check& check : nothing_overlaps(record)) add(std::move(check));
    return result;
}

// clang-format off
#define SIGNUM_CHECKS(D)                                                                  \
    template std::optional<Check> energy_is_conserved(const RunRecord<D>&);               \
    template std::optional<Check> momentum_is_conserved(const RunRecord<D>&);             \
    template std::optional<Check> gas_has_known_pressure(const RunRecord<D>&);            \
    template std::optional<Check> speeds_are_maxwellian(const RunRecord<D>&);             \
    template std::optional<Check> gas_cools_as_haff_says(const RunRecord<D>&);            \
    template std::optional<Check> heights_are_barometric(const RunRecord<D>&);            \
    template std::vector<Check> heap_is_at_rest(const RunRecord<D>&);                     \
    template std::optional<Check> fluid_carries_balls(const RunRecord<D>&);               \
    template std::vector<Check> nothing_overlaps(const RunRecord<D>&);                    \
    template std::vector<Check> check_run(const RunRecord<D>&);
// clang-format on
SIGNUM_CHECKS(2)
SIGNUM_CHECKS(3)
#undef SIGNUM_CHECKS

}  // namespace signum
