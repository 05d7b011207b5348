#include "plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "../../triangulation/options.hpp"
#include "../generate/generate.hpp"

namespace signum::study {
namespace {

using Names = std::vector<std::string>;
using Sizes = std::vector<std::int64_t>;

constexpr std::array four_distributions = {Distribution::random, Distribution::circle,
                                           Distribution::square, Distribution::grid};
constexpr std::array hard_distributions = {Distribution::random, Distribution::circle,
                                           Distribution::rings,  Distribution::lattice,
                                           Distribution::offset, Distribution::tangent};

constexpr std::array perturbations = {1e-1, 1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                                      1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15};

struct Radii {
    double from;
    double to;
};

/// Sets enough for a percentage, and for a run that the clock can resolve.
std::size_t sets_of(std::int64_t sites) {
    return static_cast<std::size_t>(std::clamp<std::int64_t>(10000 / sites, 1, 20));
}

class Cells {
 public:
    explicit Cells(const Scope& scope) : scope_(scope) {}

    /// A cell of the plane, or of space.
    template <class AnyDistribution>
    void add(const std::string& experiment, Work work, Metric metric, AnyDistribution distribution,
             std::int64_t sites, double perturbation, Radii radii, Names contestants) {
        if (sites < scope_.least_sites || sites > scope_.most_sites) return;
        Cell cell;
        cell.setting = {experiment,
                        std::string(name_of(metric)),
                        std::string(name_of(distribution)),
                        sites,
                        perturbation,
                        radii.from,
                        radii.to};
        cell.work = work;
        cell.dimension = std::is_same_v<AnyDistribution, SpaceDistribution> ? 3 : 2;
        cell.contestants = std::move(contestants);
        // Rationals take a thousand times as long as the rest.
        const bool is_slow =
            std::count(cell.contestants.begin(), cell.contestants.end(), "multiprecision") > 0;
        cell.sets = is_slow ? 1 : sets_of(sites);
        // Six are the fewest whose extremes are an interval of 95 %.
        const bool is_timed = work == Work::deletion || work == Work::stage_cost ||
                              (work == Work::construction && cell.contestants.size() > 1);
        cell.passes = is_timed ? 6 : 1;
        cell.budget = {1, 5, scope_.quick ? 0.04 : 0.25};
        cells_.push_back(std::move(cell));
    }

    std::vector<Cell> take() { return std::move(cells_); }

 private:
    const Scope& scope_;
    std::vector<Cell> cells_;
};

}  // namespace

std::vector<Cell> plan(const Scope& scope) {
    Cells cells(scope);
    const auto pick = [&](const Sizes& quick, const Sizes& full) {
        return scope.quick ? quick : full;
    };
    const auto built_by = [&](Method method) {
        std::vector<Metric> metrics = scope.metrics;
        std::erase_if(metrics, [&](Metric metric) { return !builds(method, metric); });
        return metrics;
    };
    // The thesis's radii: 1 to 10 for random sites, the same for all where all is degenerate.
    const auto radii_of = [](Distribution distribution) {
        return distribution == Distribution::random ? Radii{1.0, 10.0} : Radii{1.0, 1.0};
    };
    const Radii small = {0.01, 10.0};

    // How near to zero, and when that is too near.
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : all_distributions)
            cells.add("margin", Work::margin, metric, distribution, scope.quick ? 2000 : 10000, 0.0,
                      radii_of(distribution), {});
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : four_distributions)
            for (const std::int64_t sites : pick({100, 1000, 10000}, {100, 1000, 10000, 100000}))
                cells.add("first_error", Work::first_error, metric, distribution, sites, 0.0,
                          radii_of(distribution), {"naive", "single"});

    // Figures 4.7.4 and 4.7.5: against the perturbation.
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : four_distributions)
            for (std::size_t i = 0; i < perturbations.size(); i += scope.quick ? 2 : 1)
                cells.add("perturbation", Work::construction, metric, distribution, 100,
                          perturbations[i], radii_of(distribution),
                          {"naive", "exact", "interval", "single"});

    // Against the radii, in mean distances of neighbours.
    for (const Metric metric : scope.metrics)
        for (const double factor : {0.0, 0.01, 0.1, 0.3, 1.0, 3.0})
            cells.add("radii", Work::construction, metric, Distribution::random, 1000, 0.0,
                      {0.0, std::round(1e4 * factor * 700.0 / std::sqrt(1000.0)) / 1e4},
                      {"naive", "exact"});

    // All arithmetics side by side.
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : four_distributions)
            cells.add("kernels", Work::construction, metric, distribution, scope.quick ? 200 : 1000,
                      0.0, radii_of(distribution),
                      {"naive", "exact", "single", "interval", "sum", "multiprecision"});

    // Who decides, and what that costs.
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : all_distributions)
            for (const std::int64_t sites : pick({2000}, {10000, 100000}))
                cells.add("stages", Work::construction, metric, distribution, sites, 0.0,
                          radii_of(distribution), {"exact"});
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : all_distributions)
            cells.add("stage_cost", Work::stage_cost, metric, distribution, 2000, 0.0,
                      radii_of(distribution), {});

    // Figures 6.7.1 and 6.7.2: from Delaunay to power by flips.
    for (const Metric metric : built_by(Method::flips))
        for (const Distribution distribution : four_distributions)
            for (const std::int64_t sites :
                 pick({100, 300, 1000, 3000}, {100, 200, 500, 1000, 2000, 3000, 10000, 100000}))
                cells.add("flips", Work::construction, metric, distribution, sites, 0.0, small,
                          {"incremental", "flips"});

    // The same where radii shrink with the distances, so that the discs intersect no more often.
    for (const Metric metric : built_by(Method::flips))
        for (const std::int64_t sites : pick({100, 300, 1000, 3000}, {100, 300, 1000, 3000, 10000}))
            cells.add("flips_scaled", Work::construction, metric, Distribution::random, sites, 0.0,
                      {0.01, 100.0 / std::sqrt(static_cast<double>(sites))},
                      {"incremental", "flips"});

    // Figure 5.7.2: the sweep.
    for (const Metric metric : built_by(Method::sweep))
        for (const Distribution distribution : four_distributions)
            for (const std::int64_t sites :
                 pick({1000, 3000, 10000}, {1000, 2000, 4000, 6000, 8000, 10000, 100000, 1000000}))
                cells.add("sweep", Work::construction, metric, distribution, sites, 0.0, small,
                          {"incremental", "sweep"});

    for (const Metric metric : scope.metrics)
        for (const std::int64_t sites : pick({1000, 10000}, {1000, 10000, 100000}))
            cells.add("deletion", Work::deletion, metric, Distribution::random, sites, 0.0, small,
                      {"build", "insert", "erase"});

    // What stays hard at any size, beside what does not.
    for (const Metric metric : scope.metrics)
        for (const Distribution distribution : hard_distributions)
            for (const std::int64_t sites : pick({1000, 10000}, {1000, 10000, 100000}))
                cells.add("hard", Work::construction, metric, distribution, sites, 0.0,
                          radii_of(distribution), {"naive", "exact"});

    // Figures 4.7.2 and 4.7.3: against the number of sites. The large ones come last.
    for (const std::int64_t sites :
         pick({100, 200, 500, 1000, 10000, 100000},
              {100, 200, 300, 500, 700, 1000, 3000, 10000, 30000, 100000, 300000, 1000000}))
        for (const Metric metric : scope.metrics)
            for (const Distribution distribution : four_distributions) {
                if (scope.quick && sites > 10000 && !traits_of(metric).edges_are_straight) continue;
                cells.add("sites", Work::construction, metric, distribution, sites, 0.0,
                          radii_of(distribution), {"naive", "exact", "interval", "single"});
            }
    return cells.take();
}

std::vector<Cell> plan_in_space(const Scope& scope) {
    Cells cells(scope);
    const auto pick = [&](const Sizes& quick, const Sizes& full) {
        return scope.quick ? quick : full;
    };
    const auto radii_of = [](SpaceDistribution distribution) {
        return distribution == SpaceDistribution::random ? Radii{1.0, 10.0} : Radii{1.0, 1.0};
    };
    constexpr Metric metric = Metric::power;
    const Names both = {"naive", "exact"};

    for (const SpaceDistribution distribution : all_space_distributions)
        for (const std::int64_t sites : pick({100, 1000}, {100, 1000, 10000}))
            cells.add("first_error", Work::first_error, metric, distribution, sites, 0.0,
                      radii_of(distribution), {"naive"});
    for (const SpaceDistribution distribution : all_space_distributions)
        for (std::size_t i = 0; i < perturbations.size(); i += scope.quick ? 2 : 1)
            cells.add("perturbation", Work::construction, metric, distribution, 300,
                      perturbations[i], radii_of(distribution), both);
    // In mean distances of neighbours, as in the plane.
    for (const double factor : {0.0, 0.01, 0.1, 0.3, 1.0, 3.0})
        cells.add("radii", Work::construction, metric, SpaceDistribution::random, 1000, 0.0,
                  {0.0, std::round(1e4 * factor * 70.0) / 1e4}, both);
    for (const SpaceDistribution distribution : all_space_distributions)
        cells.add("stage_cost", Work::stage_cost, metric, distribution, scope.quick ? 2000 : 10000,
                  0.0, radii_of(distribution), {});
    for (const std::int64_t sites :
         pick({100, 300, 1000, 10000}, {100, 200, 300, 500, 1000, 3000, 10000, 30000, 100000}))
        for (const SpaceDistribution distribution : all_space_distributions)
            cells.add("sites", Work::construction, metric, distribution, sites, 0.0,
                      radii_of(distribution), both);
    return cells.take();
}

double expected_seconds(const Cell& cell, std::size_t pass) {
    const bool is_slow = cell.setting.experiment == "kernels";
    const double per_site = is_slow ? 1e-4 : cell.dimension == 3 ? 8e-6 : 1.5e-6;
    const double once = per_site * static_cast<double>(cell.setting.sites) *
                        static_cast<double>(cell.sets * (cell.contestants.size() + 1));
    if (cell.work == Work::first_error) return 8.0 * once;
    return (pass == 1 ? 2.0 * once : 0.0) +
           std::max(cell.budget.seconds, static_cast<double>(cell.budget.least_rounds) * once);
}

}  // namespace signum::study
