#include "../construction/constructions.hpp"
#include "inflation.hpp"

namespace signum::triangulation {
namespace {

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

template <class Kernel>
Tessellation construct_by_flips_with_kernel(const StridedSites& input, const Options& options,
                                            std::optional<Edge>* obstruction) {
    using S = typename Kernel::SiteType;
    const auto start = std::chrono::steady_clock::now();
    const std::size_t n = input.size();

    LargeArray<Index> original = spatial_order(input, options.seed);
    const Workers workers(options.threads, n);
    LargeArray<S> sites = in_order<S>(input, original, Arithmetic::exact, workers);
    Kernel kernel(sites.data(), original.data());
    std::vector<Index> first_of;
    const std::size_t front = front_of_equal_centres(kernel, sites, original, first_of);

    Topology topology(n);
    LargeArray<Index> hidden_by(n, -1);
    Statistics statistics;
    const Watch watch(options.stop, options.progress, 2 * n);
    LargeArray<Point> points(n);
    for (std::size_t i = 0; i < n; ++i) points[i] = {sites[i].x, sites[i].y};
    using PointKernel = PowerKernel<PowerSigns<Point>, filters::NoTally>;
    PointKernel point_kernel(points.data(), original.data());
    std::vector<Index> in_front(front);
    std::iota(in_front.begin(), in_front.end(), 0);
    if (insert_all(topology, point_kernel, hidden_by, in_front, watch)) {
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
    return finish(Metric::power, input, options, start, workers, kernel, std::move(sites),
                  std::move(topology), std::move(original), std::move(hidden_by), {}, statistics);
}

template <class S>
Tessellation construct_by_flips_of(const StridedSites& input, const Options& options,
                                   std::optional<Edge>* obstruction) {
    using Counting = PowerKernel<PowerSigns<S>, filters::Tally>;
    using Plain = PowerKernel<PowerSigns<S>, filters::NoTally>;
    return options.count ? construct_by_flips_with_kernel<Counting>(input, options, obstruction)
                         : construct_by_flips_with_kernel<Plain>(input, options, obstruction);
}

}  // namespace

Tessellation construct_by_flips(const StridedSites& input, const Options& options,
                                std::optional<Edge>* obstruction) {
    return input.third_is_weight() ? construct_by_flips_of<power::Site>(input, options, obstruction)
                                   : construct_by_flips_of<Site>(input, options, obstruction);
}

}  // namespace signum::triangulation
