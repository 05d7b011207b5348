/// From which perturbation on inexact arithmetic errs: by bisection over the powers of ten.

#include <cmath>

#include "worlds.hpp"

namespace signum::study {
namespace {

/// Whether the arithmetic gives a wrong edge (cell), or breaks, on any of the sets.
template <class World>
bool errs(const Cell& cell, const Options& options, int exponent) {
    Setting setting = cell.setting;
    setting.perturbation = std::pow(10.0, exponent);
    const Metric metric = metric_named(setting.metric).value();
    for (std::size_t seed = 1; seed <= cell.sets; ++seed) {
        const auto sites = World::sites(setting, seed);
        try {
            const auto tessellation = World::build(sites, metric, options);
            const auto canonical = World::build(sites, metric);
            if (World::difference(tessellation, canonical, sites).wrong > 0.0) return true;
        } catch (const BrokenStructure&) {
            return true;
        }
    }
    return false;
}

constexpr int greatest = 2;
constexpr int least = -17;  // moves no site that is not near an axis

template <class World>
std::vector<Row> first_errors(const Cell& cell) {
    std::vector<Row> rows;
    for (const std::string& name : cell.contestants) {
        const auto options = options_named(name);
        if (!options) continue;
        int bad = least;
        int good = greatest + 1;
        if (!errs<World>(cell, *options, bad)) good = bad;
        while (good - bad > 1) {
            const int middle = bad + (good - bad) / 2;
            (errs<World>(cell, *options, middle) ? bad : good) = middle;
        }
        Interval value = exactly(0.0);
        if (good > bad) value = {std::pow(10.0, bad), std::pow(10.0, bad), std::pow(10.0, good), 1};
        rows.push_back({cell.setting, name, "first_error", value});
    }
    return rows;
}

}  // namespace

std::vector<Row> measure_first_error(const Cell& cell, const Pass& /*pass*/) {
    return cell.dimension == 3 ? first_errors<Space>(cell) : first_errors<Plane>(cell);
}

}  // namespace signum::study
