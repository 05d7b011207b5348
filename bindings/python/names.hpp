#pragma once
/// Metrics, methods and so on by their names, as files and the command line have them.

#include <array>
#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

#include "../../core/parallel.hpp"
#include "../../triangulation/options.hpp"

namespace signum::python {

namespace py = pybind11;

/// Which of `all` has that name. Throws ValueError that lists them.
template <class Enumerators>
[[nodiscard]] auto named(const std::string& name, const char* kind, const Enumerators& all) {
    std::string known;
    for (const auto each : all) {
        if (name_of(each) == name) return each;
        known += (known.empty() ? "" : ", ") + std::string(name_of(each));
    }
    throw py::value_error(std::string(kind) + " '" + name + "' is none of " + known);
}
[[nodiscard]] inline Metric metric_of(const std::string& name) {
    if (const auto metric = metric_named(name)) return *metric;
    return named(name, "metric", all_metrics);
}
[[nodiscard]] inline WeightIs weight_of(const std::string& name) {
    return named(name, "weight_is", std::array{WeightIs::radius, WeightIs::weight});
}
[[nodiscard]] inline Arithmetic arithmetic_of(const std::string& name) {
    return named(name, "arithmetic", all_arithmetics);
}
/// How many threads work. Throws ValueError for what is no such number.
[[nodiscard]] inline int threads_of(int threads) {
    if (threads >= 0 && threads <= most_threads) return threads;
    throw py::value_error("threads: " + std::to_string(threads) + " is not from 0 to " +
                          std::to_string(most_threads));
}
[[nodiscard]] inline py::str text(std::string_view name) {
    return py::str(name.data(), name.size());
}

}  // namespace signum::python
