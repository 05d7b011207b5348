#pragma once
/// Sets of sites that are hard to cut into parts: tied everywhere, with cells that reach far.

#include <cmath>
#include <cstdint>
#include <vector>

#include "../../core/site.hpp"
#include "degenerate_sites.hpp"

namespace signum::brute_force {

/// Small integers with giants among them: so many sites that parts have an inside of their own.
inline std::vector<Site> integers_and_giants(int trial) {
    Random random(static_cast<std::uint64_t>(trial));
    const int count = random.between(300, 1500);
    const int span = random.between(20, 60);
    const int most = trial % 3 == 0 ? 0 : random.between(1, 4);
    std::vector<Site> sites;
    for (int i = 0; i < count; ++i)
        sites.push_back({static_cast<double>(random.between(0, span)),
                         static_cast<double>(random.between(0, span)),
                         static_cast<double>(random.between(0, most))});
    for (int i = trial % 4; i > 0; --i)
        sites.push_back({static_cast<double>(random.between(-span, 2 * span)),
                         static_cast<double>(random.between(-span, 2 * span)),
                         static_cast<double>(random.between(0, span / 2))});
    return sites;
}

/// One half of the sites weighs so much more than the other that it takes from it what lies far
/// beyond the cut, and hides what is there.
inline std::vector<Site> one_side_hides_the_other(int trial) {
    Random random(static_cast<std::uint64_t>(trial));
    const double more = std::ldexp(1.0, random.between(-2, 5));
    std::vector<Site> sites;
    for (int i = 0; i < 1200; ++i) {
        const Site site = {random.between(0, 1000) * 0.03125, random.between(0, 1000) * 0.03125,
                           random.between(0, 100) * 0.0078125};
        sites.push_back({site.x, site.y, site.r + (site.x > 15 ? more : 0.0)});
    }
    return sites;
}

/// Large discs in front of a cut, and small ones close together in the gap between these and beyond
/// it: all that is beyond, but for some at the border of all. Vertices of large discs beyond the
/// cut lead to them, though no site is there. Turned by a quarter so many times.
inline std::vector<Site> cluster_behind_large_discs(int trial) {
    Random random(static_cast<std::uint64_t>(trial));
    std::vector<Site> sites = {{-1, 0, 30},     {-1, 70, 30},   {-1, 35, 2.125}, {-80, 35, 15},
                               {-100, -100, 0}, {-100, 170, 0}, {100, -100, 0},  {100, 170, 0},
                               {100, 35, 0},    {12, 35, 0}};
    const double narrow = std::ldexp(1.0, -random.between(4, 12));
    for (int i = 0; i < 700; ++i)
        sites.push_back(
            {-80 + random.between(-80, 80) * 0.125, 35 + random.between(-40, 40) * 0.125, 0.0});
    for (int i = 0; i < 700; ++i)
        sites.push_back(
            {12 + random.between(1, 200) * narrow, 35 + random.between(-100, 100) * narrow, 0.0});
    for (Site& site : sites)
        for (int quarter = trial % 4; quarter > 0; --quarter) site = {-site.y, site.x, site.r};
    return sites;
}

/// Huge or tiny: beyond the filters' windows, or beyond a double's range in between.
inline std::vector<Site> sites_of_magnitude(int exponent, int count) {
    Random random(5);
    std::vector<Site> sites;
    for (int i = 0; i < count; ++i)
        sites.push_back({std::ldexp(random.between(-1000, 1000), exponent),
                         std::ldexp(random.between(-1000, 1000), exponent),
                         std::ldexp(random.between(0, 60), exponent)});
    return sites;
}

}  // namespace signum::brute_force
