#pragma once
/// Incremental insertion and the sweep, from checked sites to a tessellation: the text of
/// what each source beside it compiles for arithmetics of its own. For sources only.

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "../../core/insertion_rounds.hpp"
#include "../../core/parallel.hpp"
#include "../../filters/tally.hpp"
#include "../insertion/collinear.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/insert_all.hpp"
#include "../kernels/additive_kernel.hpp"
#include "../kernels/power_kernel.hpp"
#include "../kernels/predicates_of.hpp"
#include "../parts/construct_parts.hpp"
#include "../structure/assemble.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/tie_order.hpp"
#include "../structure/watch.hpp"
#include "../sweep/sweep.hpp"
#include "construct.hpp"
#include "grid_unit.hpp"

namespace signum::triangulation {

/// In that order, and as the arithmetic takes them.
template <class S>
LargeArray<S> in_order(const StridedSites& input, std::span<const Index> original,
                       Arithmetic arithmetic, const Workers& workers) {
    LargeArray<S> sites(original.size());
    workers.each_range(original.size(), [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t ahead = 24;
        for (std::size_t i = begin; i < end; ++i) {
            if (i + ahead < end) input.prefetch(static_cast<std::size_t>(original[i + ahead]));
            const Site site =
                predicates::rounded(arithmetic, input[static_cast<std::size_t>(original[i])]);
            if constexpr (std::is_same_v<S, RankedSite>)
                sites[i] = {site, 0};
            else
                sites[i] = power::made_of<S>(site);
        }
    });
    return sites;
}

inline void fill(Statistics& statistics, const filters::Tally& tally) noexcept {
    statistics.counted = true;
    statistics.ccw = tally.ccw;
    statistics.in_circle = tally.in_circle;
    statistics.nearer = tally.nearer;
    const auto decided = [&](Stage stage) { return tally.stages[static_cast<int>(stage)]; };
    statistics.filtered = decided(Stage::filter);
    statistics.refined = decided(Stage::refine);
    statistics.exact = decided(Stage::exact);
    statistics.essa = decided(Stage::essa);
    statistics.multiprecision = decided(Stage::multiprecision);
    statistics.ties = tally.ties;
    const std::uint64_t decisions =
        std::accumulate(std::begin(tally.stages), std::end(tally.stages), std::uint64_t{0});
    statistics.others = decisions - (tally.ccw + tally.in_circle + tally.nearer);
}
inline void fill(Statistics&, const filters::NoTally&) noexcept {}

/// The hidden sites and who hides them, by their numbers in the input, sorted.
inline void list_hidden(std::span<const Index> hidden_by, std::span<const Index> original,
                        std::vector<Hidden>& result, const Workers& workers) {
    if (std::ranges::all_of(hidden_by, [](Index by) { return by < 0; })) return;
    LargeArray<Index> by(hidden_by.size());  // of each number
    workers.each_range(by.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            by[static_cast<std::size_t>(original[i])] =
                hidden_by[i] < 0 ? -1 : original[static_cast<std::size_t>(hidden_by[i])];
    });
    for (std::size_t i = 0; i < by.size(); ++i)
        if (by[i] >= 0) result.push_back({static_cast<Index>(i), by[i]});
}

/// The arrays of the result, from a construction that is done.
template <class Kernel>
Tessellation finish(Metric metric, const StridedSites& input, const Options& options,
                    std::chrono::steady_clock::time_point start, const Workers& workers,
                    Kernel& kernel, LargeArray<typename Kernel::SiteType> sites, Topology topology,
                    LargeArray<Index> original, LargeArray<Index> hidden_by,
                    LargeArray<Index> ranks = {}, Statistics statistics = {}) {
    const std::size_t n = input.size();
    settle_hiders(topology, kernel, hidden_by, workers);

    TessellationArrays arrays;
    arrays.metric = metric;
    arrays.weight_is = input.third_is_weight() ? WeightIs::weight : WeightIs::radius;
    arrays.sites = static_cast<std::int64_t>(n);
    list_hidden(hidden_by, original, arrays.hidden, workers);
    give_back(workers, sites, hidden_by);
    arrays.order = options.order;
    const bool along_curve = options.order == Order::curve;
    if (along_curve && ranks.empty()) {
        const LargeArray<Index> by_number = ranks_along_curve(input, workers);
        for (const Index i : original) ranks.push_back(by_number[static_cast<std::size_t>(i)]);
    }
    assemble(std::move(topology), original, along_curve ? ranks : original, arrays, workers);
    give_back(workers, original, ranks);

    if (options.count) fill(statistics, kernel.tally());
    std::vector<Site> copy;
    make_room(workers, n, copy);
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) copy[i] = input[i];
    });
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return constructed(std::move(arrays), std::move(copy), statistics);
}

/// As many cuts into parts as there are threads for, where they help.
inline constexpr int any_levels = -1;

/// Sites in an order of insertion, leaf by leaf of a plan, and what they are inserted into.
template <class Kernel>
struct Ordered {
    using S = typename Kernel::SiteType;

    template <class MakeKernel>
    Ordered(const StridedSites& input, int levels, const Options& options, const Workers& workers,
            const MakeKernel& make_kernel)
        : plan(make_plan(input, levels, options.seed, workers, options.order == Order::curve)),
          sites(in_order<S>(input, plan.numbers, options.arithmetic, workers)),
          kernel(make_kernel(sites, plan.numbers, workers)),
          hidden_by(made<Index>(workers, input.size(), [](std::size_t) { return -1; })),
          topology(input.size()) {}

    Plan plan;
    LargeArray<S> sites;
    Kernel kernel;
    LargeArray<Index> hidden_by;
    Topology topology;
};

/// Whether parts are joined, and not handed on to one thread, tried with a sample of the sites:
/// some at random, and the greatest of each range, for one giant may reach all others. A quarter of
/// the sample at the cut is too much: what one thread does alone would take as long as what others
/// save.
template <class Kernel, class MakeKernel, class MakeReach>
bool parts_help(const StridedSites& input, const Options& options, const Workers& workers,
                const MakeKernel& make_kernel, const MakeReach& make_reach) {
    const std::size_t n = input.size();
    std::vector<Site> sample(std::min<std::size_t>(n, 4096));
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = input[mix(options.seed + i) % n];
    const std::size_t ranges = workers.range_count(n);
    std::vector<Site> greatest(ranges);
    workers.each(ranges, [&](std::size_t range) {
        const std::size_t end = n * (range + 1) / ranges;
        std::size_t best = n * range / ranges;
        for (std::size_t i = best; i < end; ++i)
            if (std::fabs(input[i].r) > std::fabs(input[best].r)) best = i;
        greatest[range] = input[best];
    });
    sample.insert(sample.end(), greatest.begin(), greatest.end());

    const Workers one(1);
    Ordered<Kernel> few({sample, input.third_is_weight()}, 1, options, one, make_kernel);
    const std::function<void(double)> nobody;
    const Watch watch(options.stop, nobody, n);
    const auto reach = make_reach(few.kernel, few.plan.numbers);
    return PartsConstruction(few.plan, one, few.kernel, reach, few.hidden_by, options.seed, watch)
        .run(few.topology, 4);
}

/// By insertion, in parts where `levels` says so. make_kernel(sites, original, workers) makes the
/// kernel once the sites are there, and make_reach(kernel, original) what parts ask of faces.
template <class Kernel, class MakeKernel, class MakeReach>
Tessellation construct_by_insertion(Metric metric, const StridedSites& input,
                                    const Options& options, int levels,
                                    const MakeKernel& make_kernel, const MakeReach& make_reach) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();
    const Workers workers(options.threads, n);
    // What rounds, or counts, depends on the order of the sites, and is left in that of one thread.
    constexpr bool may_be_cut = Kernel::is_exact && !Kernel::counts;
    if constexpr (!may_be_cut)
        levels = 0;
    else if (levels == any_levels)
        levels = workers.count() > 1 &&
                         parts_help<Kernel>(input, options, workers, make_kernel, make_reach)
                     ? levels_for(n, workers)
                     : 0;

    Ordered<Kernel> all(input, levels, options, workers, make_kernel);
    LargeArray<Index>& original = all.plan.numbers;
    const Watch watch(options.stop, options.progress, n);
    bool is_done = false;
    if constexpr (may_be_cut)
        if (levels > 0) {
            const auto reach = make_reach(all.kernel, original);
            is_done = PartsConstruction(all.plan, workers, all.kernel, reach, all.hidden_by,
                                        options.seed, watch)
                          .run(all.topology);
            if (!is_done) all.topology = Topology(n);
        }
    if (!is_done) {
        LargeArray<Index> visible;
        visible.reserve(n);
        for (std::size_t i = 0; i < n; ++i)
            if (all.hidden_by[i] < 0) visible.push_back(static_cast<Index>(i));
        if (levels > 0) order_spatially(view_of(std::span(all.sites)), visible, options.seed);
        is_done = insert_all(all.topology, all.kernel, all.hidden_by, visible, watch);
    }
    if constexpr (Kernel::is_straight)
        if (!is_done) connect_line(all.topology, visible_on_line(all.kernel, n, all.hidden_by));
    watch.end();
    return finish(metric, input, options, start, workers, all.kernel, std::move(all.sites),
                  std::move(all.topology), std::move(original), std::move(all.hidden_by),
                  std::move(all.plan.ranks));
}

template <class Kernel, class Signs>
Tessellation construct_with_kernel(Metric metric, const StridedSites& input, const Options& options,
                                   Signs signs, int levels = any_levels) {
    return construct_by_insertion<Kernel>(
        metric, input, options, levels,
        [&](auto& sites, const auto& original, const Workers&) {
            return Kernel(sites.data(), original.data(), signs);
        },
        [](const Kernel& kernel, const auto&) { return PowerReach(kernel); });
}

template <class M, class Kernel, class Predicates>
Tessellation construct_additive_with_kernel(const StridedSites& input, const Options& options,
                                            Predicates predicates, int levels = any_levels) {
    return construct_by_insertion<Kernel>(
        M{}, input, options, levels,
        [&](auto& sites, const auto& original, const Workers& workers) {
            rank(sites, original, workers);
            return Kernel(sites.data(), predicates);
        },
        [](const Kernel& kernel, const auto& original) {
            return AdditiveReach<M, Kernel>(kernel, original);
        });
}

/// The same, for squares, by a sweep.
template <class Directions, Arithmetic arithmetic, class Kernel, class Predicates>
Tessellation construct_by_sweep_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options, Predicates predicates) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    const Workers workers(options.threads, n);
    const bool exact_sums = arithmetic == Arithmetic::exact && rectangular::sums_are_exact(input);
    LargeArray<Index> original = counted<Index>(workers, n);
    LargeArray<RankedSite> sites(n);
    {
        LargeArray<RankedSite> given(n);
        for (std::size_t i = 0; i < n; ++i)
            given[i] = {predicates::rounded(arithmetic, input[i]), 0};
        rank(given, original, workers);
        original = order_of_starts<Directions, arithmetic>(given);
        for (std::size_t i = 0; i < n; ++i) sites[i] = given[static_cast<std::size_t>(original[i])];
    }

    Kernel kernel(sites.data(), predicates);
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    const Watch watch(options.stop, options.progress, n);
    Sweep<Directions, arithmetic, Kernel> sweep(topology, kernel, hidden_by, exact_sums);
    sweep.run(n, [&](std::size_t reached) { watch.at(reached); });
    Statistics statistics;
    statistics.events = sweep.events();
    return finish(metric, input, options, start, workers, kernel, std::move(sites),
                  std::move(topology), std::move(original), std::move(hidden_by), {}, statistics);
}

/// Calls by_power<S>() with the simplest kind of site that will do, or by_distance<M>().
template <class Power, class Additive>
Tessellation construct_by_metric(Metric metric, const StridedSites& input, Power by_power,
                                 Additive by_distance) {
    return with_metric(metric, [&]<class M>(M) {
        if constexpr (M::traits.edges_are_straight) {
            if (equal_weights(input)) return by_power.template operator()<Point>();
            if (input.third_is_weight()) return by_power.template operator()<power::Site>();
            return by_power.template operator()<Site>();
        } else {
            // Ties included.
            if constexpr (M::traits.is_delaunay_for_equal_radii)
                if (equal_radii(input)) return by_power.template operator()<Point>();
            return by_distance.template operator()<M>();
        }
    });
}

/// By kernels that ask without a detour, and count nothing.
template <Arithmetic arithmetic>
Tessellation construct_directly(Metric metric, const StridedSites& input, const Options& options,
                                int levels = any_levels) {
    return construct_by_metric(
        metric, input,
        [&]<class S>() {
            constexpr bool is_exact = arithmetic == Arithmetic::exact;
            using Signs = std::conditional_t<is_exact, SignsOfKnown<S>, PowerSigns<S, arithmetic>>;
            Signs signs;
            if constexpr (is_exact)
                signs.exact_below =
                    4.0 * fourth_power_of_grid_unit(input, !std::is_same_v<S, Point>);
            return construct_with_kernel<PowerKernel<Signs, filters::NoTally>>(
                metric, input, options, signs, levels);
        },
        [&]<class M>() {
            using Predicates = typename PredicatesOf<M>::template Perturbed<arithmetic>;
            using Kernel = AdditiveKernel<Predicates, filters::NoTally>;
            if constexpr (M::traits.has_sweep)
                if (options.method == Method::sweep)
                    return construct_by_sweep_with_kernel<typename PredicatesOf<M>::Directions,
                                                          arithmetic, Kernel>(
                        metric, input, options, Predicates{});
            return construct_additive_with_kernel<M, Kernel>(input, options, Predicates{}, levels);
        });
}

}  // namespace signum::triangulation
