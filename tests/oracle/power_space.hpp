#pragma once
/// Brute force for the power metric in one to six dimensions: the lower hull of the lifted sites,
/// every simplex against every other site, in rationals with the infinitesimals of the tie rule.
/// Sites need not span the space.

#include "oracle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace signum::oracle {

/// Centre c and weight w: the distance of a point p is |p-c|² - w.
template <int D>
struct SpaceSite {
    std::array<double, static_cast<std::size_t>(D)> c{};
    double w = 0.0;
    friend bool operator==(const SpaceSite&, const SpaceSite&) = default;
};

/// What stands behind the last site of a tuple that has room for more.
inline constexpr std::int32_t no_site = -2;

/// N places: numbers of sites, rising, then no_site.
template <int N>
using SpaceTuple = std::array<std::int32_t, static_cast<std::size_t>(N)>;

template <int D>
struct SpaceTessellation {
    /// k, that of the smallest flat through all centres: -1 without sites, 0 in one point, ..., D.
    int dimension = -1;
    /// The simplices of k + 1 sites each, sorted; where k = 0, the one visible site.
    std::vector<SpaceTuple<D + 1>> cells;
    /// The hull: k sites that are in one cell only, sorted. A point (k = 0) has none.
    std::vector<SpaceTuple<D>> facets;
    /// {site, by}, sorted by site: the sites in no cell; `by` is the visible site nearest to the
    /// hidden site's centre, its weight reduced as the tie rule says.
    std::vector<std::array<std::int32_t, 2>> hidden;
    friend bool operator==(const SpaceTessellation&, const SpaceTessellation&) = default;
};

/// The tie rule: sites are ordered by falling weight, then rising coordinates from the first to the
/// last, then index; every weight is reduced by its own infinitesimal, infinitely larger for the
/// later site. `ranks` are places in the order of ties, where that is to be another than the
/// rule's.
template <int D>
SpaceTessellation<D> power_space(std::span<const SpaceSite<D>> sites, const Ranks& ranks = {});

/// The sign of det[c_i - c_0], i = 1, ..., D, for the sites c_0, ..., c_D that `tuple` names, in
/// the order in which it names them; 0 where one is no_site.
template <int D>
int orientation(std::span<const SpaceSite<D>> sites, const SpaceTuple<D + 1>& tuple);

}  // namespace signum::oracle
