#pragma once
/// What benchmarks measure, time, memory, and what is in the middle of several tries; and balls to
/// measure on.

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <malloc.h>
#include <unistd.h>

#include "../core/site.hpp"

namespace signum::benchmarks {

/// That this process has computed up to now.
inline double seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// How many of them the work takes.
template <class Work>
double seconds_of(const Work& work) {
    const double begin = seconds();
    work();
    return seconds() - begin;
}

/// What this process takes of the machine's memory; of arrays that lie on pages of their own the
/// heap's own count would include what is left out to reach the next page, and never touched.
inline double bytes_taken() {
    ::malloc_trim(0);
    long all = 0;
    long resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Balls with radii from `least` to `greatest`, their centres in a cube.
inline std::vector<Site3> random_balls(std::int64_t count, std::uint64_t seed, double side,
                                       double least, double greatest) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return 0x1p-53 * static_cast<double>(random() >> 11); };
    std::vector<Site3> balls;
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = uniform(), y = uniform(), z = uniform();
        balls.push_back({side * x, side * y, side * z, least + (greatest - least) * uniform()});
    }
    return balls;
}

/// Precondition: there are values. Of an even number the greater one of the two in the middle.
inline double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// In two decimals, with the least and the greatest.
inline std::string median_and_range(const std::vector<double>& values) {
    const auto [least, greatest] = std::ranges::minmax(values);
    return fmt::format("{:.2f} ({:.2f}–{:.2f})", median(values), least, greatest);
}

/// How long two take in turn, and the second's time over the first's.
struct Turns {
    std::vector<double> first;
    std::vector<double> second;
    std::vector<double> ratios;

    void add(double one, double other) {
        first.push_back(one);
        second.push_back(other);
        ratios.push_back(other / one);
    }
};

}  // namespace signum::benchmarks
