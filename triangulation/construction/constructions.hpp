#pragma once
/// Incremental insertion and the sweep, from checked sites to a tessellation: the text of
/// what each source beside it compiles for arithmetics of its own. For sources only.

#include <algorithm>
#include <chrono>
#include <numeric>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "../../filters/tally.hpp"
#include "../insertion/collinear.hpp"
#include "../insertion/hiders.hpp"
#include "../insertion/insert.hpp"
#include "../kernels/additive_kernel.hpp"
#include "../kernels/power_kernel.hpp"
#include "../kernels/predicates_of.hpp"
#include "../structure/assemble.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/tie_order.hpp"
#include "../structure/watch.hpp"
#include "../sweep/sweep.hpp"
#include "construct.hpp"

namespace signum::triangulation {

/// In that order, and as the arithmetic takes them.
template <power::PowerSite S>
LargeArray<S> in_order(const StridedSites& input, const LargeArray<Index>& original,
                       Arithmetic arithmetic) {
    LargeArray<S> sites(original.size());
    for (std::size_t i = 0; i < original.size(); ++i)
        sites[i] = made_of<S>(
            predicates::rounded(arithmetic, input[static_cast<std::size_t>(original[i])]));
    return sites;
}

/// Moves three sites that are not collinear to the front, counterclockwise; false where there are
/// none.
template <class Kernel>
bool lead_with_triangle(Kernel& kernel, std::span<typename Kernel::SiteType> sites,
                        std::span<Index> original) {
    const auto n = static_cast<Index>(sites.size());
    const auto bring = [&](Index to, Index from) {
        std::swap(sites[static_cast<std::size_t>(to)], sites[static_cast<std::size_t>(from)]);
        std::swap(original[static_cast<std::size_t>(to)], original[static_cast<std::size_t>(from)]);
    };
    Index second = 1;
    while (second < n && kernel.centre(second) == kernel.centre(0)) ++second;
    if (second >= n) return false;
    bring(1, second);
    for (Index third = 2; third < n; ++third) {
        const Sign side = kernel.ccw(0, 1, third);
        if (side == 0) continue;
        bring(2, third);
        if (side < 0) bring(0, 1);
        return true;
    }
    return false;
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

/// The arrays of the result, from a construction that is done.
template <class Kernel>
Tessellation finish(Metric metric, const StridedSites& input, const Options& options,
                    std::chrono::steady_clock::time_point start, Kernel& kernel,
                    LargeArray<typename Kernel::SiteType> sites, Topology topology,
                    LargeArray<Index> original, LargeArray<Index> hidden_by,
                    Statistics statistics = {}) {
    const std::size_t n = input.size();
    settle_hiders(topology, kernel, hidden_by);

    TessellationArrays arrays;
    arrays.metric = metric;
    arrays.weight_is = input.third_is_weight() ? WeightIs::weight : WeightIs::radius;
    arrays.sites = static_cast<std::int64_t>(n);
    for (std::size_t i = 0; i < n; ++i)
        if (hidden_by[i] >= 0)
            arrays.hidden.push_back(
                {original[i], original[static_cast<std::size_t>(hidden_by[i])]});
    std::sort(arrays.hidden.begin(), arrays.hidden.end(),
              [](const Hidden& a, const Hidden& b) { return a.site < b.site; });
    sites = {};
    hidden_by = {};
    assemble(std::move(topology), original, arrays);
    original = {};

    if (options.count) fill(statistics, kernel.tally());
    std::vector<Site> copy(n);
    for (std::size_t i = 0; i < n; ++i) copy[i] = input[i];
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return constructed(std::move(arrays), std::move(copy), statistics);
}

template <class Kernel, class Signs>
Tessellation construct_with_kernel(Metric metric, const StridedSites& input, const Options& options,
                                   Signs signs) {
    using S = typename Kernel::SiteType;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<S> sites = in_order<S>(input, original, options.arithmetic);

    Kernel kernel(sites.data(), original.data(), signs);
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    if (lead_with_triangle(kernel, sites, original)) {
        Insertion<Kernel> insertion(topology, kernel, hidden_by, 0, 1, 2);
        const Watch watch(options.stop, options.progress, n);
        for (std::size_t i = 3; i < n; ++i) {
            insertion.insert(static_cast<Index>(i));
            watch.at(i);
        }
    } else {
        connect_line(topology, visible_on_line(kernel, n, hidden_by));
    }
    return finish(metric, input, options, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by));
}

template <class Kernel, class Predicates>
Tessellation construct_additive_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options, Predicates predicates) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<RankedSite> sites(n);
    for (std::size_t i = 0; i < n; ++i)
        sites[i] = {
            predicates::rounded(options.arithmetic, input[static_cast<std::size_t>(original[i])]),
            0};
    rank(sites, original);
    if (n > 0) {
        // The first site of the tie rule's order leads: no other ever hides it.
        const auto first = std::find_if(sites.begin(), sites.end(),
                                        [](const RankedSite& site) { return site.rank == 0; });
        std::swap(original[0], original[static_cast<std::size_t>(first - sites.begin())]);
        std::swap(sites[0], *first);
    }

    Kernel kernel(sites.data(), predicates);
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    std::size_t second = 1;
    for (; second < n && kernel.hides(0, static_cast<Index>(second)); ++second)
        hidden_by[second] = 0;
    if (second < n) {
        Insertion<Kernel> insertion(topology, kernel, hidden_by, 0, static_cast<Index>(second));
        const Watch watch(options.stop, options.progress, n);
        for (std::size_t i = second + 1; i < n; ++i) {
            insertion.insert(static_cast<Index>(i));
            watch.at(i);
        }
    }
    return finish(metric, input, options, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by));
}

/// The same, for squares, by a sweep.
template <class Directions, Arithmetic arithmetic, class Kernel, class Predicates>
Tessellation construct_by_sweep_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options, Predicates predicates) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    const bool exact_sums = arithmetic == Arithmetic::exact && rectangular::sums_are_exact(input);
    LargeArray<Index> original(n);
    std::iota(original.begin(), original.end(), 0);
    LargeArray<RankedSite> sites(n);
    {
        LargeArray<RankedSite> given(n);
        for (std::size_t i = 0; i < n; ++i)
            given[i] = {predicates::rounded(arithmetic, input[i]), 0};
        rank(given, original);
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
    return finish(metric, input, options, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by), statistics);
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
Tessellation construct_directly(Metric metric, const StridedSites& input, const Options& options) {
    return construct_by_metric(
        metric, input,
        [&]<class S>() {
            using Signs = PowerSigns<S, arithmetic>;
            return construct_with_kernel<PowerKernel<Signs, filters::NoTally>>(metric, input,
                                                                               options, Signs{});
        },
        [&]<class M>() {
            using Predicates = typename PredicatesOf<M>::template Perturbed<arithmetic>;
            using Kernel = AdditiveKernel<Predicates, filters::NoTally>;
            if constexpr (M::traits.has_sweep)
                if (options.method == Method::sweep)
                    return construct_by_sweep_with_kernel<typename PredicatesOf<M>::Directions,
                                                          arithmetic, Kernel>(
                        metric, input, options, Predicates{});
            return construct_additive_with_kernel<Kernel>(metric, input, options, Predicates{});
        });
}

}  // namespace signum::triangulation
