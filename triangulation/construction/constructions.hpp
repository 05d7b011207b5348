#pragma once
/// Incremental insertion and the sweep, from checked sites to a tessellation: the text of
/// construct(), which each source beside it compiles for one arithmetic or two. For sources only.

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

template <class Kernel>
LargeArray<typename Kernel::SiteType> in_order(const StridedSites& input,
                                               const LargeArray<Index>& original) {
    LargeArray<typename Kernel::SiteType> sites(original.size());
    for (std::size_t i = 0; i < original.size(); ++i)
        sites[i] = Kernel::rounded(input[static_cast<std::size_t>(original[i])]);
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

template <class Kernel>
Tessellation construct_with_kernel(Metric metric, const StridedSites& input,
                                   const Options& options) {
    using S = typename Kernel::SiteType;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<S> sites = in_order<Kernel>(input, original);

    Kernel kernel(sites.data(), original.data());
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

template <class Kernel>
Tessellation construct_additive_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<RankedSite> sites(n);
    for (std::size_t i = 0; i < n; ++i)
        sites[i] = {Kernel::rounded(input[static_cast<std::size_t>(original[i])]), 0};
    rank(sites, original);
    if (n > 0) {
        // The first site of the tie rule's order leads: no other ever hides it.
        const auto first = std::find_if(sites.begin(), sites.end(),
                                        [](const RankedSite& site) { return site.rank == 0; });
        std::swap(original[0], original[static_cast<std::size_t>(first - sites.begin())]);
        std::swap(sites[0], *first);
    }

    Kernel kernel(sites.data());
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
template <class Kernel>
Tessellation construct_by_sweep_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options) {
    using SweepOfKernel = Sweep<Kernel>;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    const bool exact_sums =
        SweepOfKernel::arithmetic == Arithmetic::exact && rectangular::sums_are_exact(input);
    LargeArray<Index> original(n);
    std::iota(original.begin(), original.end(), 0);
    LargeArray<RankedSite> sites(n);
    {
        LargeArray<RankedSite> given(n);
        for (std::size_t i = 0; i < n; ++i) given[i] = {Kernel::rounded(input[i]), 0};
        rank(given, original);
        original =
            order_of_starts<typename SweepOfKernel::Directions, SweepOfKernel::arithmetic>(given);
        for (std::size_t i = 0; i < n; ++i) sites[i] = given[static_cast<std::size_t>(original[i])];
    }

    Kernel kernel(sites.data());
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    const Watch watch(options.stop, options.progress, n);
    SweepOfKernel sweep(topology, kernel, hidden_by, exact_sums);
    sweep.run(n, [&](std::size_t reached) { watch.at(reached); });
    Statistics statistics;
    statistics.events = sweep.events();
    return finish(metric, input, options, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by), statistics);
}

/// Whether a tally is felt: it costs a few per cent of what exact and rounded numbers cost and
/// nothing beside the others, nor under a sanitizer.
template <Arithmetic arithmetic>
inline constexpr bool is_fast =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    false;
#else
    arithmetic == Arithmetic::exact || !is_exact(arithmetic);
#endif

/// construct<Tally>() for what the options ask. Where it is not felt, the tally is always kept:
/// that code is compiled once.
template <Arithmetic arithmetic, class Construct>
Tessellation with_tally(const Options& options, Construct construct) {
    if constexpr (is_fast<arithmetic>)
        if (!options.count) return construct.template operator()<filters::NoTally>();
    return construct.template operator()<filters::Tally>();
}

template <class S, Arithmetic arithmetic>
Tessellation construct_power(Metric metric, const StridedSites& input, const Options& options) {
    return with_tally<arithmetic>(options, [&]<class Tally>() {
        return construct_with_kernel<PowerKernel<S, arithmetic, Tally>>(metric, input, options);
    });
}

/// M: a metric with additive weights.
template <class M, Arithmetic arithmetic>
Tessellation construct_additive(const StridedSites& input, const Options& options) {
    return with_tally<arithmetic>(options, [&]<class Tally>() {
        using Predicates = typename PredicatesOf<M>::template Perturbed<arithmetic>;
        using Kernel = AdditiveKernel<Predicates, arithmetic, Tally>;
        if constexpr (M::traits.has_sweep)
            if (options.method == Method::sweep)
                return construct_by_sweep_with_kernel<Kernel>(M::metric, input, options);
        return construct_additive_with_kernel<Kernel>(M::metric, input, options);
    });
}

template <Arithmetic arithmetic>
Tessellation construct(Metric metric, const StridedSites& input, const Options& options) {
    return with_metric(metric, [&]<class M>(M) {
        if constexpr (M::traits.edges_are_straight) {
            if (equal_weights(input))
                return construct_power<Point, arithmetic>(metric, input, options);
            if (input.third_is_weight())
                return construct_power<power::Site, arithmetic>(metric, input, options);
            return construct_power<Site, arithmetic>(metric, input, options);
        } else {
            // Ties included.
            if constexpr (M::traits.is_delaunay_for_equal_radii)
                if (equal_radii(input))
                    return construct_power<Point, arithmetic>(metric, input, options);
            return construct_additive<M, arithmetic>(input, options);
        }
    });
}

}  // namespace signum::triangulation
