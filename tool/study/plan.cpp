#include "plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "../../motion/simulation.hpp"
#include "../../triangulation/options.hpp"
#include "../generate/generate.hpp"
#include "../io/names.hpp"

namespace signum::study {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;
using Sizes = std::vector<std::int64_t>;
using Metrics = std::vector<Metric>;

const Names four = {"random", "circle", "square", "grid"};
const Names hard = {"random", "circle", "rings", "lattice", "offset", "tangent"};

struct Radii {
    double from;
    double to;
};
constexpr Radii small = {0.01, 10.0};

class Plan {
 public:
    Plan(const Scope& scope, int dimension) : scope_(scope), dimension_(dimension) {}

    /// A cell for each metric, distribution, number of sites and perturbation. Without radii they
    /// are the thesis's: 1 to 10 for random sites, the same for all where all is degenerate.
    void add(const char* experiment, Work work, const Metrics& metrics, const Names& distributions,
             const Sizes& numbers, const Names& contestants = {},
             const std::optional<Radii>& radii = {}, const Numbers& perturbations = {0.0}) {
        // Six are the fewest whose extremes are an interval of 95 %.
        const bool is_timed = work == Work::deletion || work == Work::stage_cost ||
                              (work == Work::construction && contestants.size() > 1);
        // Rationals take a thousand times as long as the rest.
        const bool is_slow = std::ranges::count(contestants, "multiprecision") > 0;
        for (const Metric metric : metrics)
            for (const std::string& distribution : distributions)
                for (const std::int64_t sites : numbers)
                    for (const double perturbation : perturbations) {
                        const Radii thesis = {1.0, distribution == "random" ? 10.0 : 1.0};
                        const auto& [from, to] = radii.value_or(thesis);
                        // Enough for a percentage, and for a run that the clock can resolve.
                        const auto sets = std::clamp<std::int64_t>(10000 / sites, 1, 20);
                        add({.setting = {experiment, std::string(name_of(metric)), distribution,
                                         sites, perturbation, from, to},
                             .work = work,
                             .dimension = dimension_,
                             .contestants = contestants,
                             .sets = is_slow ? 1 : static_cast<std::size_t>(sets),
                             .passes = is_timed ? 6U : 1U,
                             .budget = {1, 5, scope_.quick ? 0.04 : 0.25}});
                    }
    }
    void add(Cell cell) {
        const std::int64_t count = cell.setting.count;
        if (count >= scope_.least_sites && count <= scope_.most_sites)
            cells_.push_back(std::move(cell));
    }

    /// What the quick form has, or the full one.
    [[nodiscard]] Sizes sizes(const Sizes& quick, const Sizes& full) const {
        return scope_.quick ? quick : full;
    }
    [[nodiscard]] Numbers numbers(const Numbers& quick, const Numbers& full) const {
        return scope_.quick ? quick : full;
    }
    [[nodiscard]] Numbers perturbations() const {
        return numbers({1e-1, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15},
                       {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12,
                        1e-13, 1e-14, 1e-15});
    }
    [[nodiscard]] Metrics built_by(Method method) const {
        Metrics metrics = scope_.metrics;
        std::erase_if(metrics, [&](Metric metric) { return !builds(method, metric); });
        return metrics;
    }

    std::vector<Cell> take() { return std::move(cells_); }

 private:
    const Scope& scope_;
    int dimension_;
    std::vector<Cell> cells_;
};

/// In mean distances of neighbours: of random sites in a square 700 wide, or a cube.
void add_radii(Plan& plan, Metric metric, double mean_distance) {
    for (const double factor : {0.0, 0.01, 0.1, 0.3, 1.0, 3.0})
        plan.add("radii", Work::construction, {metric}, {"random"}, {1000}, {"naive", "exact"},
                 Radii{0.0, std::round(1e4 * factor * mean_distance) / 1e4});
}

}  // namespace

std::vector<Cell> plan(const Scope& scope) {
    Plan plan(scope, 2);
    const Metrics& all = scope.metrics;
    const Names every = names_of(all_distributions);
    const Names arithmetics = {"naive", "exact", "interval", "single"};

    // How near to zero, and when that is too near.
    plan.add("margin", Work::margin, all, every, plan.sizes({2000}, {10000}));
    plan.add("first_error", Work::first_error, all, four,
             plan.sizes({100, 1000, 10000}, {100, 1000, 10000, 100000}), {"naive", "single"});
    // Figures 4.7.4 and 4.7.5: against the perturbation.
    plan.add("perturbation", Work::construction, all, four, {100}, arithmetics, {},
             plan.perturbations());
    for (const Metric metric : all) add_radii(plan, metric, 700.0 / std::sqrt(1000.0));
    // All arithmetics side by side.
    plan.add("kernels", Work::construction, all, four, plan.sizes({200}, {1000}),
             {"naive", "exact", "single", "interval", "sum", "multiprecision"});
    // Who decides, and what that costs.
    plan.add("stages", Work::construction, all, every, plan.sizes({2000}, {10000, 100000}),
             {"exact"});
    plan.add("stage_cost", Work::stage_cost, all, every, {2000});
    // Figures 6.7.1 and 6.7.2: from Delaunay to power by flips.
    plan.add("flips", Work::construction, plan.built_by(Method::flips), four,
             plan.sizes({100, 300, 1000, 3000}, {100, 200, 500, 1000, 2000, 3000, 10000, 100000}),
             {"incremental", "flips"}, small);
    // The same where radii shrink with the distances, so that the discs intersect no more often.
    for (const std::int64_t sites :
         plan.sizes({100, 300, 1000, 3000}, {100, 300, 1000, 3000, 10000}))
        plan.add("flips_scaled", Work::construction, plan.built_by(Method::flips), {"random"},
                 {sites}, {"incremental", "flips"},
                 Radii{0.01, 100.0 / std::sqrt(static_cast<double>(sites))});
    // Figure 5.7.2: the sweep.
    plan.add(
        "sweep", Work::construction, plan.built_by(Method::sweep), four,
        plan.sizes({1000, 3000, 10000}, {1000, 2000, 4000, 6000, 8000, 10000, 100000, 1000000}),
        {"incremental", "sweep"}, small);
    plan.add("deletion", Work::deletion, all, {"random"},
             plan.sizes({1000, 10000}, {1000, 10000, 100000}), {"build", "insert", "erase"}, small);
    // What stays hard at any size, beside what does not.
    plan.add("hard", Work::construction, all, hard,
             plan.sizes({1000, 10000}, {1000, 10000, 100000}), {"naive", "exact"});
    // Figures 4.7.2 and 4.7.3: against the number of sites. The large ones come last.
    for (const std::int64_t sites :
         plan.sizes({100, 200, 500, 1000, 10000, 100000},
                    {100, 200, 300, 500, 700, 1000, 3000, 10000, 30000, 100000, 300000, 1000000})) {
        Metrics metrics = all;
        if (scope.quick && sites > 10000)
            std::erase_if(metrics,
                          [](Metric metric) { return !traits_of(metric).edges_are_straight; });
        plan.add("sites", Work::construction, metrics, four, {sites}, arithmetics);
    }
    return plan.take();
}

std::vector<Cell> plan_in_space(const Scope& scope) {
    Plan plan(scope, 3);
    const Metrics power = {Metric::power};
    const Names every = names_of(all_space_distributions);
    const Names both = {"naive", "exact"};
    plan.add("first_error", Work::first_error, power, every,
             plan.sizes({100, 1000}, {100, 1000, 10000}), {"naive"});
    plan.add("perturbation", Work::construction, power, every, {300}, both, {},
             plan.perturbations());
    add_radii(plan, Metric::power, 70.0);
    plan.add("stage_cost", Work::stage_cost, power, every, plan.sizes({2000}, {10000}));
    for (const std::int64_t sites : plan.sizes(
             {100, 300, 1000, 10000}, {100, 200, 300, 500, 1000, 3000, 10000, 30000, 100000}))
        plan.add("sites", Work::construction, power, every, {sites}, both);
    return plan.take();
}

std::vector<Cell> plan_motion(const Scope& scope) {
    Plan plan(scope, 2);
    constexpr double thesis_step = 0.005;
    const bool quick = scope.quick;
    const std::size_t passes = quick ? 2 : 6;
    const Numbers packings = plan.numbers({0.05, 0.33, 0.7}, {0.05, 0.2, 0.33, 0.5, 0.7});
    const auto add = [&](const char* experiment, std::int64_t balls, double size_ratio,
                         double packing, double time_step, Cell cell) {
        cell.setting = {.experiment = experiment,
                        .count = balls,
                        .size_ratio = size_ratio,
                        .packing = packing,
                        .time_step = time_step};
        // The first one is whom the others are compared with.
        if (cell.work == Work::structures) cell.contestants = names_of(motion::all_structures);
        if (balls > 1000) std::erase(cell.contestants, "pairs");
        plan.add(std::move(cell));
    };

    // Tables 10.4.1 to 10.4.4: from event to event, and by the thesis's time step.
    const Cell shaken = {
        .work = Work::structures, .passes = passes, .simulated = quick ? 2.0 : 10.0};
    for (const double size_ratio : {1.0, 10.0})
        for (const double packing : packings)
            for (const double step : {0.0, thesis_step})
                add("packing", 100, size_ratio, packing, step, shaken);
    // Table 10.4.5: 100 balls of radii 5 to 10 fill 0.363 of the box. There are as many predictions
    // in it as in two seconds.
    for (std::int64_t balls = 10; balls <= 100; balls += quick ? 30 : 10)
        for (const double step : {0.0, thesis_step})
            add("number", balls, 2.0, 0.00363 * static_cast<double>(balls), step,
                {.work = Work::structures, .passes = passes, .simulated = 2.0});

    // What accuracy costs, and what goes wrong without it.
    Cell judged = {.work = Work::rounding, .contestants = {"naive", "exact"}, .passes = passes};
    for (const double size_ratio : {1.0, 10.0})
        for (const double packing : packings)
            add("accuracy", 100, size_ratio, packing, 0.0, judged);
    judged.speed = 30.0;
    judged.warming_up = 5.0;
    judged.simulated = 1.0;
    for (const std::int64_t balls : plan.sizes({1000}, {1000, 10000}))
        for (const double size_ratio : {1.0, 10.0})
            for (const double packing : plan.numbers({0.33}, {0.05, 0.33, 0.5, 0.7}))
                add("accuracy", balls, size_ratio, packing, 0.0, judged);

    // Time steps against events.
    for (const double packing : plan.numbers({0.33}, {0.05, 0.33, 0.5}))
        for (const double step : {0.0, 0.00125, 0.0025, thesis_step})
            add("time_steps", 100, 1.0, packing, step,
                {.work = Work::time_steps, .sets = quick ? 3U : 8U, .simulated = shaken.simulated});

    // More balls than the thesis had: flying, or the floor alone would strike at first.
    Cell large = {.work = Work::structures,
                  .passes = passes,
                  .most_strikes = quick ? 20'000U : 200'000U,
                  .speed = 30.0,
                  .warming_up = 5.0};
    for (const std::int64_t balls : plan.sizes({1000, 10000}, {1000, 10000, 100000}))
        for (const double size_ratio : {1.0, 10.0})
            for (const double packing : plan.numbers({0.05, 0.33, 0.7}, {0.05, 0.33, 0.5, 0.7})) {
                large.simulated = 10.0;
                add("large", balls, size_ratio, packing, 0.0, large);
                // A step moves all balls, whoever strikes.
                large.simulated = quick ? 0.05 : 0.5;
                if (balls == 1000) add("large", balls, size_ratio, packing, thesis_step, large);
            }
    return plan.take();
}

double expected_seconds(const Cell& cell, std::size_t pass) {
    const auto count = static_cast<double>(cell.setting.count);
    if (cell.setting.packing > 0.0) {
        const double steps =
            cell.setting.time_step > 0.0 ? cell.simulated / cell.setting.time_step : 0.0;
        const double strikes =
            std::min(20.0 * count * cell.simulated, static_cast<double>(cell.most_strikes));
        const double runs = static_cast<double>(std::max(cell.contestants.size(), cell.sets));
        const double place = pass == 1 && cell.setting.packing >= 0.4 ? 2e-4 * count : 0.0;
        return place + runs * (4e-6 * strikes + 2e-6 * steps * count);
    }
    const bool is_slow = cell.setting.experiment == "kernels";
    const double per_site = is_slow ? 1e-4 : cell.dimension == 3 ? 8e-6 : 1.5e-6;
    const double once =
        per_site * count * static_cast<double>(cell.sets * (cell.contestants.size() + 1));
    if (cell.work == Work::first_error) return 8.0 * once;
    return (pass == 1 ? 2.0 * once : 0.0) +
           std::max(cell.budget.seconds, static_cast<double>(cell.budget.least_rounds) * once);
}

}  // namespace signum::study
