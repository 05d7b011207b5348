#pragma once
/// Little sets of sites in any dimension, in which everything is tied, nested, flat or double.

#include <cmath>
#include <cstddef>
#include <vector>

#include "../../triangulation/any_dimension/triangulate.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum::any_dimension_test {

template <int D>
using Sites = std::vector<power::SiteOf<D>>;

/// Up to `most` sites. Coordinates of a few values, or none; weights of none, a few, or a range;
/// flat in some of them.
template <int D>
Sites<D> small_set(oracle_test::Random& random, int most) {
    const int kind = random.below(7);
    const auto one = [&] {
        switch (kind) {
            case 0:
                return 1.0 * random.below(2);
            case 1:
                return 1.0 * random.below(3);
            case 2:
                return 0.1 * random.below(4);
            case 3:
                return std::ldexp(1.0 * random.below(3), 300);
            case 4:
                return std::ldexp(1.0 * random.below(3), -300);
            default:
                return random.unit();
        }
    };
    const int weights = random.below(3);
    // From this axis on coordinates are sums of those before, or one number.
    const int flat_from = random.below(3) == 0 ? random.below(D + 1) : D;
    const bool is_level = random.below(2) == 0;
    Sites<D> sites;
    for (int n = 1 + random.below(most); n > 0; --n) {
        power::SiteOf<D> site;
        for (std::size_t axis = 0; axis < D; ++axis) {
            site.centre[axis] = one();
            if (static_cast<int>(axis) < flat_from) continue;
            site.centre[axis] = is_level || axis == 0 ? 0.5 : site.centre[axis - 1];
            if (!is_level && axis > 1) site.centre[axis] += site.centre[axis - 2];
        }
        if (weights == 1) site.w = 1.0 * random.below(3);
        if (weights == 2) site.w = 0.25 * one() * one();
        if (random.below(8) == 0 && !sites.empty()) site.centre = sites.front().centre;
        sites.push_back(site);
    }
    return sites;
}

/// All points with coordinates 0, ..., side-1.
template <int D>
Sites<D> lattice(int side) {
    Sites<D> sites(1);
    for (std::size_t axis = 0; axis < D; ++axis) {
        const Sites<D> before = sites;
        for (int x = 1; x < side; ++x)
            for (power::SiteOf<D> site : before) {
                site.centre[axis] = x;
                sites.push_back(site);
            }
    }
    return sites;
}

template <int D>
Sites<D> random_sites(oracle_test::Random& random, int n, double weight) {
    Sites<D> sites;
    for (int i = 0; i < n; ++i) {
        power::SiteOf<D> site;
        for (double& x : site.centre) x = random.unit();
        site.w = weight * random.unit();
        sites.push_back(site);
    }
    return sites;
}

}  // namespace signum::any_dimension_test
