#include "timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "../../core/contract.hpp"

namespace signum::study {
namespace {

/// The least rank k for which k values below the median and k above it leave 95 % between them: the
/// binomial distribution of fair coins.
std::size_t outer_rank(std::size_t runs) {
    const auto n = static_cast<double>(runs);
    double tail = 0.0;
    std::size_t rank = 0;
    for (std::size_t k = 0; 2 * k < runs; ++k) {
        const auto x = static_cast<double>(k);
        tail += std::exp(std::lgamma(n + 1) - std::lgamma(x + 1) - std::lgamma(n - x + 1) -
                         n * std::log(2.0));
        if (tail > 0.025) break;
        rank = k;
    }
    return rank;
}

}  // namespace

Interval median_of(std::vector<double> values) {
    SIGNUM_EXPECTS(!values.empty());
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const std::size_t rank = outer_rank(n);
    return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values[rank], values[n - 1 - rank], n};
}

Race race(std::span<const Contestant> contestants, const Budget& budget, bool reversed) {
    const std::size_t count = contestants.size();
    std::vector<std::vector<double>> seconds(count);
    std::vector<std::vector<double>> ratios(count);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t round = 0; round < budget.most_rounds; ++round) {
        if (round >= budget.least_rounds && seconds_since(start) > budget.seconds) break;
        for (std::size_t turn = 0; turn < count; ++turn) {
            const std::size_t i = (round % 2 == 0) == reversed ? count - 1 - turn : turn;
            seconds[i].push_back(contestants[i]());
        }
        for (std::size_t i = 0; i < count; ++i)
            ratios[i].push_back(seconds[i].back() / seconds[0].back());
    }
    Race result;
    for (std::size_t i = 0; i < count; ++i) {
        result.seconds.push_back(median_of(seconds[i]));
        result.ratios.push_back(median_of(ratios[i]));
    }
    return result;
}

}  // namespace signum::study
