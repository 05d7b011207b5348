#pragma once
/// What tests know of each metric, and share with nothing but the types of the library: its
/// distance and its oracle. Other tests ask these; a metric that has none does not compile.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../triangulation/metric.hpp"
#include "oracle/euclidean.hpp"
#include "oracle/power.hpp"
#include "oracle/rectangular.hpp"

namespace signum::by_metric {

/// The length of a vector, from its coordinates' absolute values; its square where sites are discs.
template <class Number>
Number length_or_square(Metric metric, const Number& x, const Number& y) {
    switch (metric) {
        case Metric::power:
        case Metric::euclidean:
            return Number(x * x + y * y);
        case Metric::manhattan:
            return Number(x + y);
        case Metric::supremum:
            break;
    }
    return std::max(x, y);
}

/// By brute force, with ties in the order of `ranks`, for discs by powers of the infinitesimals.
template <class Sites>
oracle::Tessellation tessellation(Metric metric, const Sites& sites, const oracle::Ranks& ranks,
                                  const std::vector<std::int64_t>& powers) {
    switch (metric) {
        case Metric::power:
            return oracle::power(sites, ranks);
        case Metric::euclidean:
            return oracle::euclidean(sites, powers);
        case Metric::manhattan:
            return oracle::manhattan(sites, ranks);
        case Metric::supremum:
            break;
    }
    return oracle::supremum(sites, ranks);
}

}  // namespace signum::by_metric
