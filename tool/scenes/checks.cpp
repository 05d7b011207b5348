#include "checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "check_parts.hpp"

namespace signum {
namespace {

constexpr double ulp = 0x1p-53;

/// What rounding may add to a sum over n balls, as a part of the sum of its terms: a few last
/// places at each strike of each ball, and those of the sum.
template <int D>
double rounding_of_sum(const RunRecord<D>& record) {
    const auto n = static_cast<double>(record.end().balls.size());
    const auto strikes = static_cast<double>(record.moments().back().strikes);
    return ulp * (100.0 + n + 16.0 * strikes / std::max(n, 1.0));
}

/// That a sum has changed by that much at most, and its terms are of that scale.
template <int D>
std::optional<Check> conserved(const RunRecord<D>& record, std::string what, std::string expected,
                               std::string found, double most, double scale) {
    if (scale <= 0.0) return std::nullopt;
    const double allowed = rounding_of_sum(record);
    return Check{std::move(what), std::move(expected), std::move(found),
                 fmt::format("{:.1e} of it at most; rounding allows {:.1e}", most / scale, allowed),
                 judged(most <= allowed * scale)};
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
        scale = larger(scale, moment.terms_of_total);
        most = larger(most, std::fabs(moment.total - moments.front().total));
    }
    return conserved(record, "energy is conserved", "E(t) = E(0), for all strikes are elastic",
                     fmt::format("{:.9g} at the start, {:.9g} at the end", moments.front().total,
                                 moments.back().total),
                     most, scale);
}

template <int D>
std::optional<Check> momentum_is_conserved(const RunRecord<D>& record) {
    const motion::Effects<D>& effects = record.effects();
    if (!is_endless(effects) || effects.fluid) return std::nullopt;
    const std::vector<Moment>& moments = record.moments();
    double scale = 0.0;
    double most = 0.0;
    for (const Moment& moment : moments) {
        scale = larger(scale, moment.terms_of_momentum);
        for (std::size_t k = 0; k < 3; ++k)
            most = larger(most, std::fabs(moment.momentum[k] - moments.front().momentum[k]));
    }
    return conserved(record, "momentum is conserved", "Σ m v stays, for strikes are all that acts",
                     fmt::format("changes by at most {:.1e}; Σ m |v| is {:.6g}", most, scale), most,
                     scale);
}

template <int D>
std::vector<Check> nothing_overlaps(const RunRecord<D>& record) {
    const bool has_contacts = record.effects().contacts.has_value();
    // Contacts that stand wait for the next step up to an overlap of a 256th, and a little longer.
    const double allowed = has_contacts ? 0x1.4p-8 : 0x1p-30;
    double of_balls = 0.0;
    double of_walls = 0.0;
    for (const Moment& moment : record.moments()) {
        of_balls = larger(of_balls, moment.overlaps.of_balls);
        of_walls = larger(of_walls, moment.overlaps.of_walls);
    }
    const auto check = [&](std::string what, double deepest) {
        return Check{std::move(what),
                     fmt::format("at most {:.0e} of a radius, {}", allowed,
                                 has_contacts ? "by contacts that stand" : "by rounding"),
                     deepest <= 0.0 ? std::string("none")
                                    : fmt::format("{:.1e} of a radius at most", deepest),
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

#define SIGNUM_CHECKS(D)                                                      \
    template std::optional<Check> energy_is_conserved(const RunRecord<D>&);   \
    template std::optional<Check> momentum_is_conserved(const RunRecord<D>&); \
    template std::vector<Check> nothing_overlaps(const RunRecord<D>&);        \
    template std::vector<Check> check_run(const RunRecord<D>&);
SIGNUM_CHECKS(2)
SIGNUM_CHECKS(3)
#undef SIGNUM_CHECKS

}  // namespace signum
