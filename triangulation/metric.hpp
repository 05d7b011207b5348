#pragma once
/// The metrics: one table of what they are called, what their sites look like and what can be asked
/// of them. Whatever differs from metric to metric stands here or, where it is code, hangs on the
/// types by which with_metric() names them: kernels/predicates_of.hpp says which predicates a
/// metric has, and templates without a text of their own are specialized in a metric's own sources.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace signum {

/// The distances from a site; shared by types and files.
enum class Metric : std::uint8_t { power, euclidean, manhattan, supremum };

/// What the third number of a site means; anything but radius exists in the power metric alone.
enum class WeightIs : std::uint8_t { radius, weight };

/// What is known of a metric without computing anything.
struct MetricTraits {
    Metric metric;                            ///< whose row this is
    std::string_view name;                    ///< in files and on the command line
    std::string_view title;                   ///< in sentences: the … metric
    std::array<std::string_view, 4> aliases;  ///< what else it is called; unused ones are empty
    std::string_view distance;                ///< of a point p from a site with centre c, radius r
    std::string_view site;                    ///< what a site looks like
    std::string_view circle;                  ///< what touches three of them
    std::string_view sphere;                  ///< in space: what touches four
    std::string_view spheres;                 ///< several of those
    /// Whether the edges of a tessellation are straight, and its faces triangles that cover the
    /// convex hull.
    bool edges_are_straight = false;
    bool has_weights = false;  ///< whether the third number of a site may be a weight
    /// Whether sites of equal radii have Delaunay's triangulation.
    bool is_delaunay_for_equal_radii = false;
    bool has_flips = false;  ///< whether Method::flips builds it
    bool has_sweep = false;  ///< whether Method::sweep builds it
};

/// A row for every metric, in the order of the enumerators.
inline constexpr std::array<MetricTraits, 4> metric_table = {{
    {.metric = Metric::power,
     .name = "power",
     .title = "power",
     .aliases = {"laguerre", "regular"},
     .distance = "|p - c|^2 - r^2",
     .site = "disc",
     .circle = "circle",
     .sphere = "sphere",
     .spheres = "spheres",
     .edges_are_straight = true,
     .has_weights = true,
     .is_delaunay_for_equal_radii = true,
     .has_flips = true},
    {.metric = Metric::euclidean,
     .name = "euclidean",
     .title = "Euclidean",
     .aliases = {"apollonius", "l2"},
     .distance = "|p - c| - r",
     .site = "disc",
     .circle = "circle",
     .sphere = "sphere",
     .spheres = "spheres",
     .is_delaunay_for_equal_radii = true},
    {.metric = Metric::manhattan,
     .name = "manhattan",
     .title = "Manhattan",
     .aliases = {"l1", "taxicab", "cityblock"},
     .distance = "|p - c| - r in the norm |x| + |y|",
     .site = "diamond",
     .circle = "diamond",
     .sphere = "octahedron",
     .spheres = "octahedra",
     .has_sweep = true},
    {.metric = Metric::supremum,
     .name = "supremum",
     .title = "supremum",
     .aliases = {"linf", "linfinity", "chebyshev", "maximum"},
     .distance = "|p - c| - r in the norm max(|x|, |y|)",
     .site = "square",
     .circle = "square",
     .sphere = "cube",
     .spheres = "cubes",
     .has_sweep = true},
}};

/// The row of a metric. Precondition: one of the enumerators.
[[nodiscard]] constexpr const MetricTraits& traits_of(Metric metric) noexcept {
    return metric_table[static_cast<std::size_t>(metric)];
}

/// In the order of the table.
inline constexpr auto all_metrics = [] {
    std::array<Metric, metric_table.size()> metrics{};
    for (std::size_t i = 0; i < metrics.size(); ++i) metrics[i] = metric_table[i].metric;
    return metrics;
}();

/// A metric as a type, for code that is another one in each. It converts to its enumerator, so that
/// triangulate(sites, Euclidean{}) says what it means.
template <Metric which>
struct MetricType {
    static constexpr Metric metric = which;  ///< its enumerator
    /// Its row of the table.
    static constexpr const MetricTraits& traits = traits_of(which);
    static_assert(traits.metric == which, "the rows follow the enumerators");
    /// Its enumerator, for the sake of calls.
    // NOLINTNEXTLINE(google-explicit-constructor)
    constexpr operator Metric() const noexcept { return which; }
};
struct Power : MetricType<Metric::power> {};
struct Euclidean : MetricType<Metric::euclidean> {};
struct Manhattan : MetricType<Metric::manhattan> {};
struct Supremum : MetricType<Metric::supremum> {};

/// Several metrics, as types.
template <class... M>
struct MetricTypes {};

/// All of them, in the order of the table.
using AllMetrics = MetricTypes<Power, Euclidean, Manhattan, Supremum>;
static_assert([]<class... M>(MetricTypes<M...>) {
    return std::array{M::metric...} == all_metrics;
}(AllMetrics{}));

/// Calls visit with the metric as a type, one of those listed: where a metric lacks the code that
/// visit wants of it, nothing compiles. Throws std::invalid_argument for what is none of them.
template <class Visit, class M, class... Others>
decltype(auto) with_metric(Metric metric, Visit&& visit, MetricTypes<M, Others...> /*listed*/) {
    if (metric == M::metric) return std::forward<Visit>(visit)(M{});
    if constexpr (sizeof...(Others) > 0)
        return with_metric(metric, std::forward<Visit>(visit), MetricTypes<Others...>{});
    throw std::invalid_argument("no such metric");
}
/// The same with any metric. Nothing else tells metrics apart.
template <class Visit>
decltype(auto) with_metric(Metric metric, Visit&& visit) {
    return with_metric(metric, std::forward<Visit>(visit), AllMetrics{});
}

/// The name by which files and the tool know it.
[[nodiscard]] constexpr std::string_view name_of(Metric metric) noexcept {
    return traits_of(metric).name;
}
/// The same of what a third number is.
[[nodiscard]] constexpr std::string_view name_of(WeightIs weight_is) noexcept {
    return weight_is == WeightIs::radius ? "radius" : "weight";
}

/// The metric of that name or alias, in capitals or not, with hyphens and underscores or not.
[[nodiscard]] std::optional<Metric> metric_named(std::string_view name);

/// What to say where sites of a metric come with weights, and it has none.
[[nodiscard]] std::string no_weights(Metric metric);

}  // namespace signum
