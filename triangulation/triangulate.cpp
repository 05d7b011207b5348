#include <signum/triangulation/triangulate.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <signum/exact/floating_environment.hpp>
#include <signum/predicates/euclidean.hpp>
#include <signum/predicates/manhattan.hpp>
#include <signum/predicates/supremum.hpp>
#include <signum/triangulation/additive_kernel.hpp>
#include <signum/triangulation/assemble.hpp>
#include <signum/triangulation/cold_inflation.hpp>
#include <signum/triangulation/collinear.hpp>
#include <signum/triangulation/hiders.hpp>
#include <signum/triangulation/insert.hpp>
#include <signum/triangulation/kernel.hpp>
#include <signum/triangulation/spatial_order.hpp>
#include <signum/triangulation/cold_sweep.hpp>
#include <signum/triangulation/tie_order.hpp>

namespace signum {
namespace triangulation {
namespace {

void check_input(const StridedSites& sites) {
    if (sites.size() > static_cast<std::size_t>(max_sites))
        throw std::invalid_argument("too many sites: " + std::to_string(sites.size()) +
                                    ", the limit is " + std::to_string(max_sites));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        const Site site = sites[i];
        if (!std::isfinite(site.x) || !std::isfinite(site.y) || !std::isfinite(site.r))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
    }
}

/// The same weight everywhere: ordinary Delaunay, which needs no weights at all.
bool equal_weights(const StridedSites& sites) noexcept {
    for (std::size_t i = 1; i < sites.size(); ++i) {
        const double first = sites[0].r;
        const double other = sites[i].r;
        if (sites.third_is_weight() ? first != other : std::fabs(first) != std::fabs(other))
            return false;
    }
    return true;
}

bool equal_radii(const StridedSites& sites) noexcept {
    for (std::size_t i = 1; i < sites.size(); ++i)
        if (sites[i].r != sites[0].r) return false;
    return true;
}

template <power::PowerSite S>
S site_of(const Site& site) noexcept {
    if constexpr (std::is_same_v<S, Point>) {
        return {site.x, site.y};
    } else {
        return {site.x, site.y, site.r};
    }
}

/// Calls the user back every few thousand sites.
class Watch {
 public:
    Watch(const Options& options, std::size_t sites) noexcept : options_(options), sites_(sites) {}

    void at(std::size_t done) const {
        if (done % period != 0) return;
        if (options_.stop.stop_requested()) throw Stopped();
        if (options_.progress)
            options_.progress(static_cast<double>(done) / static_cast<double>(sites_));
    }

 private:
    static constexpr std::size_t period = 4096;
    const Options& options_;
    std::size_t sites_;
};

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

void fill(Statistics& statistics, const filters::Tally& tally) noexcept {
    statistics.counted = true;
    statistics.ccw = tally.ccw;
    statistics.in_circle = tally.in_circle;
    const auto decided = [&](Stage stage) { return tally.stages[static_cast<int>(stage)]; };
    statistics.filtered = decided(Stage::filter);
    statistics.refined = decided(Stage::refine);
    statistics.essa = decided(Stage::exact);
    statistics.multiprecision = decided(Stage::multiprecision);
    statistics.ties = tally.ties;
}
void fill(Statistics&, const filters::NoTally&) noexcept {}

/// The arrays of the result, from a construction that is done.
template <class Kernel>
Tessellation finish(Metric metric, WeightIs weight_is, const StridedSites& input,
                    std::chrono::steady_clock::time_point start, const Kernel& kernel,
                    LargeArray<typename Kernel::SiteType> sites, Topology topology,
                    LargeArray<Index> original, LargeArray<Index> hidden_by,
                    Statistics statistics = {}) {
    const std::size_t n = input.size();
    settle_hiders(topology, kernel, hidden_by);

    TessellationArrays arrays;
    arrays.metric = metric;
    arrays.weight_is = weight_is;
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

    fill(statistics, kernel.tally());
    std::vector<Site> copy = large_vector<Site>(n);
    for (std::size_t i = 0; i < n; ++i) copy[i] = input[i];
    statistics.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {std::move(arrays), std::move(copy), statistics};
}

/// construct<arithmetic, Tally>() for what the options ask.
template <Arithmetic arithmetic, class Construct>
Tessellation with_tally(const Options& options, Construct construct) {
    return options.count ? construct.template operator()<arithmetic, filters::Tally>()
                         : construct.template operator()<arithmetic, filters::NoTally>();
}
template <class Construct>
Tessellation with_arithmetic(const Options& options, Construct construct) {
    switch (options.arithmetic) {
        case Arithmetic::naive:
            return with_tally<Arithmetic::naive>(options, construct);
        case Arithmetic::multiprecision:
            return with_tally<Arithmetic::multiprecision>(options, construct);
        case Arithmetic::exact:
            break;
    }
    return with_tally<Arithmetic::exact>(options, construct);
}

template <power::PowerSite S>
LargeArray<S> in_order(const StridedSites& input, const LargeArray<Index>& original) {
    LargeArray<S> sites(original.size());
    for (std::size_t i = 0; i < original.size(); ++i)
        sites[i] = site_of<S>(input[static_cast<std::size_t>(original[i])]);
    return sites;
}

template <class Kernel>
Tessellation construct_with_kernel(Metric metric, const StridedSites& input,
                                   const Options& options) {
    using S = typename Kernel::SiteType;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<S> sites = in_order<S>(input, original);

    Kernel kernel(sites.data(), original.data());
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    if (lead_with_triangle(kernel, sites, original)) {
        Insertion<Kernel> insertion(topology, kernel, hidden_by, 0, 1, 2);
        const Watch watch(options, n);
        for (std::size_t i = 3; i < n; ++i) {
            insertion.insert(static_cast<Index>(i));
            watch.at(i);
        }
    } else {
        connect_line(topology, visible_on_line(kernel, n, hidden_by));
    }
    const WeightIs weight_is = input.third_is_weight() ? WeightIs::weight : WeightIs::radius;
    return finish(metric, weight_is, input, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by));
}

/// Of equal centres the first in the tie rule's order comes to the front of the arrays, the others
/// behind; the number of those in front, and for each one behind the number of its first.
template <class Kernel>
std::size_t front_of_equal_centres(const Kernel& kernel,
                                   LargeArray<typename Kernel::SiteType>& sites,
                                   LargeArray<Index>& original, std::vector<Index>& first_of) {
    const std::size_t n = original.size();
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        const Point p = kernel.centre(a);
        const Point q = kernel.centre(b);
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        return a != b && kernel.precedes(a, b);
    });
    std::vector<Index> first(n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(order[i]);
        const bool same = i > 0 && kernel.centre(order[i]) == kernel.centre(order[i - 1]);
        first[at] = same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
    LargeArray<typename Kernel::SiteType> new_sites(n);
    LargeArray<Index> new_original(n);
    std::size_t front = 0;
    std::size_t behind = n;
    for (std::size_t i = 0; i < n; ++i) {
        const bool stands = first[i] == static_cast<Index>(i);
        const std::size_t to = stands ? front++ : --behind;
        new_sites[to] = sites[i];
        new_original[to] = original[i];
    }
    first_of.resize(n - front);
    for (std::size_t i = 0, at = n; i < n; ++i)
        if (first[i] != static_cast<Index>(i))
            first_of[--at - front] = original[static_cast<std::size_t>(first[i])];
    std::copy(new_sites.begin(), new_sites.end(), sites.begin());
    std::copy(new_original.begin(), new_original.end(), original.begin());
    return front;
}

/// The same as construct_with_kernel, by flips. `obstruction` is where to report the edge that
/// could not be flipped in the order of discovery; without it the order is that of time.
template <class Kernel>
Tessellation construct_by_flips_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options,
                                            std::optional<Edge>* obstruction) {
    using S = typename Kernel::SiteType;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<S> sites = in_order<S>(input, original);
    Kernel kernel(sites.data(), original.data());
    std::vector<Index> first_of;
    const std::size_t front = front_of_equal_centres(kernel, sites, original, first_of);

    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    Statistics statistics;
    if (lead_with_triangle(kernel, std::span(sites).first(front),
                           std::span(original).first(front))) {
        LargeArray<Point> points(n);
        for (std::size_t i = 0; i < n; ++i) points[i] = {sites[i].x, sites[i].y};
        using PointKernel = PowerKernel<Point, Arithmetic::exact, filters::NoTally>;
        PointKernel point_kernel(points.data(), original.data());
        Insertion<PointKernel> insertion(topology, point_kernel, hidden_by, 0, 1, 2);
        const Watch watch(options, 2 * n);
        for (std::size_t i = 3; i < front; ++i) {
            insertion.insert(static_cast<Index>(i));
            watch.at(i);
        }
        std::vector<Index> place(n);
        for (std::size_t i = 0; i < n; ++i)
            place[static_cast<std::size_t>(original[i])] = static_cast<Index>(i);
        for (std::size_t i = front; i < n; ++i)
            hidden_by[i] = place[static_cast<std::size_t>(first_of[i - front])];

        using Flips = Inflation<Kernel>;
        Flips inflation(
            topology, kernel, hidden_by,
            obstruction == nullptr ? Flips::Order::of_time : Flips::Order::of_discovery);
        if (!inflation.run(
                [&](std::uint64_t done) { watch.at(n + std::min<std::size_t>(done, n - 1)); })) {
            const auto [a, b] = inflation.obstruction();
            const Edge edge = {a == infinite ? a : original[static_cast<std::size_t>(a)],
                               b == infinite ? b : original[static_cast<std::size_t>(b)]};
            if (obstruction == nullptr)
                throw BrokenStructure("an edge that has to be flipped cannot be");
            *obstruction = edge;
            return {};
        }
        statistics.flips = inflation.flips();
    } else {
        connect_line(topology, visible_on_line(kernel, n, hidden_by));
    }
    const WeightIs weight_is = input.third_is_weight() ? WeightIs::weight : WeightIs::radius;
    return finish(metric, weight_is, input, start, kernel, std::move(sites), std::move(topology),
                  std::move(original), std::move(hidden_by), statistics);
}

template <class S>
Tessellation construct_by_flips(Metric metric, const StridedSites& input, const Options& options,
                                std::optional<Edge>* obstruction = nullptr) {
    return with_tally<Arithmetic::exact>(options, [&]<Arithmetic arithmetic, class Tally>() {
        return construct_by_flips_with_kernel<PowerKernel<S, arithmetic, Tally>>(
            metric, input, options, obstruction);
    });
}

template <power::PowerSite S>
Tessellation construct(Metric metric, const StridedSites& input, const Options& options) {
    return with_arithmetic(options, [&]<Arithmetic arithmetic, class Tally>() {
        return construct_with_kernel<PowerKernel<S, arithmetic, Tally>>(metric, input, options);
    });
}

template <class Kernel>
Tessellation construct_additive_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    LargeArray<RankedSite> sites(n);
    for (std::size_t i = 0; i < n; ++i)
        sites[i] = {input[static_cast<std::size_t>(original[i])], 0};
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
        const Watch watch(options, n);
        for (std::size_t i = second + 1; i < n; ++i) {
            insertion.insert(static_cast<Index>(i));
            watch.at(i);
        }
    }
    return finish(metric, WeightIs::radius, input, start, kernel, std::move(sites),
                  std::move(topology), std::move(original), std::move(hidden_by));
}

/// The same, for squares, by a sweep.
template <class Kernel>
Tessellation construct_by_sweep_with_kernel(Metric metric, const StridedSites& input,
                                            const Options& options) {
    using SweepOfKernel = Sweep<Kernel>;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    const bool exact_sums = rectangular::sums_are_exact(input);
    LargeArray<Index> original(n);
    std::iota(original.begin(), original.end(), 0);
    LargeArray<RankedSite> sites(n);
    {
        LargeArray<RankedSite> given(n);
        for (std::size_t i = 0; i < n; ++i) given[i] = {input[i], 0};
        rank(given, original);
        original = order_of_starts<typename SweepOfKernel::Directions, SweepOfKernel::sums>(given);
        for (std::size_t i = 0; i < n; ++i) sites[i] = given[static_cast<std::size_t>(original[i])];
    }

    Kernel kernel(sites.data());
    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    const Watch watch(options, n);
    SweepOfKernel sweep(topology, kernel, hidden_by, exact_sums);
    sweep.run(n, [&](std::size_t reached) { watch.at(reached); });
    Statistics statistics;
    statistics.events = sweep.events();
    return finish(metric, WeightIs::radius, input, start, kernel, std::move(sites),
                  std::move(topology), std::move(original), std::move(hidden_by), statistics);
}

constexpr additive::Stages stages_of(Arithmetic arithmetic) noexcept {
    using additive::Stages;
    return arithmetic == Arithmetic::exact   ? Stages::exact
           : arithmetic == Arithmetic::naive ? Stages::naive
                                             : Stages::multiprecision;
}

template <template <additive::Stages> class Predicates>
Tessellation construct_additive(Metric metric, const StridedSites& input, const Options& options) {
    const exact::IeeeEnvironment environment;
    check_input(input);
    if (options.method == Method::flips)
        throw std::invalid_argument("flips build tessellations of the power metric alone");
    if (options.method == Method::sweep && metric == Metric::euclidean)
        throw std::invalid_argument(
            "the sweep builds tessellations of the Manhattan and supremum metrics alone");
    if (input.third_is_weight())
        throw std::invalid_argument("sites of the " + std::string(name_of(metric)) +
                                    " metric have radii, not weights");
    // Of equal radii the Euclidean tessellation is Delaunay's, ties included.
    if (metric == Metric::euclidean && equal_radii(input))
        return construct<Point>(metric, input, options);
    return with_arithmetic(options, [&]<Arithmetic arithmetic, class Tally>() {
        using Kernel = AdditiveKernel<Predicates<stages_of(arithmetic)>, arithmetic, Tally>;
        if constexpr (!std::is_same_v<Predicates<additive::Stages::exact>, euclidean::Perturbed<>>)
            if (options.method == Method::sweep)
                return construct_by_sweep_with_kernel<Kernel>(metric, input, options);
        return construct_additive_with_kernel<Kernel>(metric, input, options);
    });
}

}  // namespace
}  // namespace triangulation

std::string_view name_of(Arithmetic arithmetic) noexcept {
    constexpr std::string_view names[] = {"exact", "naive", "multiprecision"};
    return names[static_cast<int>(arithmetic)];
}

std::string_view name_of(Method method) noexcept {
    constexpr std::string_view names[] = {"incremental", "flips", "sweep"};
    return names[static_cast<int>(method)];
}

FlipOutcome flip_from_delaunay(StridedSites sites, const Options& options) {
    const exact::IeeeEnvironment environment;
    triangulation::check_input(sites);
    FlipOutcome outcome;
    outcome.tessellation = sites.third_is_weight()
                               ? triangulation::construct_by_flips<power::Site>(
                                     Metric::power, sites, options, &outcome.obstruction)
                               : triangulation::construct_by_flips<Site>(
                                     Metric::power, sites, options, &outcome.obstruction);
    return outcome;
}

Tessellation triangulate(StridedSites sites, Euclidean /*metric*/, const Options& options) {
    return triangulation::construct_additive<euclidean::Perturbed>(Metric::euclidean, sites,
                                                                   options);
}

Tessellation triangulate(StridedSites sites, Manhattan /*metric*/, const Options& options) {
    return triangulation::construct_additive<manhattan::Perturbed>(Metric::manhattan, sites,
                                                                   options);
}

Tessellation triangulate(StridedSites sites, Supremum /*metric*/, const Options& options) {
    return triangulation::construct_additive<supremum::Perturbed>(Metric::supremum, sites, options);
}

Tessellation triangulate(StridedSites sites, Power /*metric*/, const Options& options) {
    using namespace triangulation;
    // Comparisons, and the speed of the filters, want denormals kept; the predicates would be right
    // without.
    const exact::IeeeEnvironment environment;
    check_input(sites);
    if (options.method == Method::sweep)
        throw std::invalid_argument(
            "the sweep builds tessellations of the Manhattan and supremum metrics alone");
    if (options.method == Method::flips && options.arithmetic == Arithmetic::naive)
        throw std::invalid_argument("flips need exact arithmetic");
    if (equal_weights(sites)) return construct<Point>(Metric::power, sites, options);
    if (options.method == Method::flips) {
        if (sites.third_is_weight())
            return construct_by_flips<power::Site>(Metric::power, sites, options);
        return construct_by_flips<Site>(Metric::power, sites, options);
    }
    if (sites.third_is_weight()) return construct<power::Site>(Metric::power, sites, options);
    return construct<Site>(Metric::power, sites, options);
}

Tessellation triangulate(StridedSites sites, Metric metric, const Options& options) {
    switch (metric) {
        case Metric::power:
            return triangulate(sites, Power{}, options);
        case Metric::manhattan:
            return triangulate(sites, Manhattan{}, options);
        case Metric::supremum:
            return triangulate(sites, Supremum{}, options);
        case Metric::euclidean:
            return triangulate(sites, Euclidean{}, options);
    }
    throw std::invalid_argument("no such metric");
}

}  // namespace signum
