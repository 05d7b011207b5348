#pragma once
/// How a construction is asked for, and how it may end without a tessellation.

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <stop_token>
#include <string_view>

#include "../predicates/arithmetic.hpp"
#include "arrays.hpp"
#include "metric.hpp"

namespace signum {

/// Those of constructions, in the order of their enumerators.
inline constexpr std::array all_arithmetics = {Arithmetic::exact,  Arithmetic::naive,
                                               Arithmetic::single, Arithmetic::interval,
                                               Arithmetic::sum,    Arithmetic::multiprecision};

/// The name by which files and the tool know it.
[[nodiscard]] constexpr std::string_view name_of(Arithmetic arithmetic) noexcept {
    constexpr std::string_view names[] = {"exact", "naive",          "single", "interval",
                                          "sum",   "multiprecision", "judging"};
    return names[static_cast<int>(arithmetic)];
}

/// How a tessellation is built; the result is the same.
enum class Method : std::uint8_t {
    incremental,  ///< site by site
    flips,        ///< power metric: from the Delaunay triangulation of the centres, by flips
    sweep         ///< Manhattan and supremum: a line sweeps the plane
};

/// In the order of their enumerators.
inline constexpr std::array all_methods = {Method::incremental, Method::flips, Method::sweep};

/// The name by which files and the tool know it.
[[nodiscard]] constexpr std::string_view name_of(Method method) noexcept {
    constexpr std::string_view names[] = {"incremental", "flips", "sweep"};
    return names[static_cast<int>(method)];
}

/// Whether the method builds tessellations of the metric.
[[nodiscard]] constexpr bool builds(Method method, Metric metric) noexcept {
    switch (method) {
        case Method::incremental:
            return true;
        case Method::flips:
            return traits_of(metric).has_flips;
        case Method::sweep:
            return traits_of(metric).has_sweep;
    }
    return false;
}

/// How to build; the result depends on none of this but `order`, and `arithmetic` where it rounds.
struct Options {
    /// The single kernel takes the sites rounded to floats: std::invalid_argument, naming the site,
    /// for a number beyond 3.4e38.
    Arithmetic arithmetic = Arithmetic::exact;
    /// std::invalid_argument with a metric that the method does not build, and for flips with any
    /// arithmetic but the exact one.
    Method method = Method::incremental;
    /// Seeds the random insertion order. The result does not depend on it.
    std::uint64_t seed = 1;
    /// In which order the faces stand: along the curve those that are near stand together.
    Order order = Order::index;
    /// How many threads work, the calling one among them: 0 for as many cores as the process may
    /// use; below some thousand sites one, and fewer where so many cannot be started. 1024 at most:
    /// std::invalid_argument with others, or with fewer than 0. An arithmetic that rounds, `count`,
    /// and the loops of flips and sweep stay on one.
    int threads = 0;
    /// Fill the counters of Statistics; costs up to a fifth of the time.
    bool count = false;
    /// Checked every few thousand sites; a stopped construction throws Stopped.
    std::stop_token stop = {};
    /// Called now and then with the share of the work done, from 0 to 1, by the calling thread.
    std::function<void(double)> progress = {};
};

/// Thrown when Options::stop, or that of a validation, asked for it.
class Stopped : public std::runtime_error {
 public:
    Stopped() : std::runtime_error("the work was stopped before its end") {}
};

/// Thrown when inexact arithmetic led the construction astray: a walk without end, a conflict
/// region that is no disc. Exact kernels never throw it.
class BrokenStructure : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

}  // namespace signum
