/// Gases beside their equations of state and their distributions.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "check_parts.hpp"

namespace signum {
namespace {

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
/// strikes. Not more than a quarter of the balls: of few balls energies are not distributed as of
/// infinitely many, by a part of 1/n, which more samples would show.
template <int D>
std::vector<const typename RunRecord<D>::Look*> looks_apart(const RunRecord<D>& record,
                                                            double strikes) {
    const std::size_t most = record.end().balls.size() / 4;
    std::vector<const typename RunRecord<D>::Look*> result;
    const double middle = 0.5 * (record.moments().front().time + record.moments().back().time);
    for (auto look = record.looks().rbegin(); look != record.looks().rend(); ++look) {
        if (look->time < middle || result.size() == most) break;
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

}  // namespace

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
    // Of few balls Z is another one, by a part of 1/n.
    constexpr std::size_t fewest = 200;
    check.judgement = n < fewest || error > 2.0 * allowed * expected
                          ? Judgement::not_told
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
            motion::Vector<D> v = velocity(look->state.balls[i], look->time, effects);
            for (int k = 0; k < D; ++k) v[k] -= last.momentum[static_cast<std::size_t>(k)] / mass;
            cells.add(maxwell_share<D>(0.5 * look->state.masses[i] * dot(v, v) / t));
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
        const double since = moment.time - moments.front().time;
        // Strikes that a contact's duration makes elastic must be rare.
        const double strikes_of_a_ball =
            2.0 * static_cast<double>(moment.strikes) / static_cast<double>(n);
        if (strikes_of_a_ball * effects.contact_duration > 0.01 * since) return std::nullopt;
        times.push_back(since);
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
    const double tall = effects.box->lengths()[axis];
    const double mean_height = std::min(tall, t * static_cast<double>(n) / (mass_of(state) * g));
    constexpr double most_packing = 0.02;
    if (record.moments().back().packing * tall / mean_height > most_packing) return std::nullopt;

    Check check;
    check.what = "heights are barometric";
    check.expected = "density ∝ exp(−m g h / T)";
    const auto looks = looks_apart(record, 20.0 * static_cast<double>(n));
    check.found = "less than forty strikes a ball before the second half";
    // Before that many heights are those of the start.
    if (looks.empty() || static_cast<double>(looks.back()->strikes) < 20.0 * static_cast<double>(n))
        return check;
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

#define SIGNUM_GAS_CHECKS(D)                                                   \
    template std::optional<Check> gas_has_known_pressure(const RunRecord<D>&); \
    template std::optional<Check> speeds_are_maxwellian(const RunRecord<D>&);  \
    template std::optional<Check> gas_cools_as_haff_says(const RunRecord<D>&); \
    template std::optional<Check> heights_are_barometric(const RunRecord<D>&);
SIGNUM_GAS_CHECKS(2)
SIGNUM_GAS_CHECKS(3)
#undef SIGNUM_GAS_CHECKS

}  // namespace signum
