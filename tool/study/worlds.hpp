#pragma once
/// The plane and space, as far as experiments do the same in both. For the sources of study/.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "../../triangulation/space/compare.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../voronoi/compare.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {

/// What compare_edges() and compare_cells() say, counted.
struct Difference {
    double all = 0.0;
    double wrong = 0.0;
    double different = 0.0;
};

/// Of an EdgeComparison `all` edges, of a CellComparison `all` cells.
template <class Comparison>
[[nodiscard]] Difference difference_of(const Comparison& comparison, std::int64_t all) {
    return {static_cast<double>(all), static_cast<double>(comparison.wrong.size()),
            static_cast<double>(comparison.different.size())};
}

struct Plane {
    using Sites = std::vector<Site>;
    using Result = Tessellation;
    static constexpr std::string_view parts = "edges";

    static Sites sites(const Setting& setting, std::size_t seed) { return sites_of(setting, seed); }
    static Result build(const Sites& sites, Metric metric, const Options& options = {}) {
        return triangulate(sites, metric, options);
    }
    static double seconds(const Sites& sites, Metric metric, const Options& options) {
        return triangulate(sites, metric, options).statistics().seconds;
    }
    static Difference difference(const Result& result, const Result& canonical, const Sites&) {
        const EdgeComparison comparison = compare_edges(result, canonical);
        return difference_of(comparison, comparison.edges);
    }
    static std::size_t hidden(const Result& result) { return result.hidden().size(); }
    static const Statistics* calls(const Result& result) { return &result.statistics(); }
};

/// There is one metric yet, and calls are not counted.
struct Space {
    using Sites = std::vector<Site3>;
    using Result = SpaceTessellation;
    static constexpr std::string_view parts = "cells";

    static Sites sites(const Setting& setting, std::size_t seed) {
        return sites_in_space_of(setting, seed);
    }
    static Result build(const Sites& sites, Metric, const Options& options = {}) {
        return triangulate(std::span<const Site3>(sites), Power{}, options);
    }
    static double seconds(const Sites& sites, Metric metric, const Options& options) {
        return seconds_of([&] { static_cast<void>(build(sites, metric, options)); });
    }
    static Difference difference(const Result& result, const Result& canonical,
                                 const Sites& sites) {
        const CellComparison comparison =
            compare_cells(result, canonical, std::span<const Site3>(sites));
        return difference_of(comparison, comparison.cells);
    }
    static std::size_t hidden(const Result& result) { return result.hidden.size(); }
    static const Statistics* calls(const Result&) { return nullptr; }
};

}  // namespace signum::study
