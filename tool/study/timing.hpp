#pragma once
/// Timing that repeats: contestants take turns, and what is told is the median with the interval in
/// which it lies.

#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace signum::study {

/// On the wall's clock.
[[nodiscard]] inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Those that a piece of work takes.
template <class Work>
[[nodiscard]] double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return seconds_since(start);
}

/// A median and an interval that contains the true one with a confidence of at least 95 %, where
/// there are six runs or more; the extremes otherwise. From order statistics: no distribution is
/// supposed.
struct Interval {
    double median = 0.0;
    double low = 0.0;
    double high = 0.0;
    std::size_t runs = 0;
};

/// Precondition: there are values.
[[nodiscard]] Interval median_of(std::vector<double> values);

/// When to stop.
struct Budget {
    std::size_t least_rounds = 3;
    std::size_t most_rounds = 21;
    double seconds = 1.0;  ///< no further round once so much has passed
};

/// Each contestant does its work once and says how many seconds it took.
using Contestant = std::function<double()>;

/// What took how long: of the times of each contestant, and of their ratios to the first one's time
/// in the same round, in which noise that lasts longer than a round cancels out.
struct Race {
    std::vector<Interval> seconds;
    std::vector<Interval> ratios;  ///< of the first: 1
};

/// Rounds in which all contestants run once, in an order that alternates; from the last to the
/// first in the first round where `reversed`.
[[nodiscard]] Race race(std::span<const Contestant> contestants, const Budget& budget,
                        bool reversed = false);

}  // namespace signum::study
