#pragma once
/// A Euclidean tessellation from the oracle's faces, which know no neighbours: the faces on both
/// sides of the edges between two sites follow one another along the sites' bisector.

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <signum/triangulation/tessellation.hpp>
#include <signum/triangulation/vertices.hpp>

#include "oracle/euclidean.hpp"

namespace signum {

/// Three discs touch a line: whether from below (+1), upwards being to the left of a -> b, or not.
inline int tangent_side(const Site& a, const Site& b, const Site& c) {
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    const double square = x * x + y * y;
    const double slant = a.r - b.r;
    const double excess = slant * (x * (c.x - a.x) + y * (c.y - a.y)) - (a.r - c.r) * square;
    const double height = std::sqrt(square - slant * slant) * (x * (c.y - a.y) - y * (c.x - a.x));
    return std::abs(excess + height) < std::abs(excess - height) ? 1 : -1;
}

/// Neighbours across edges to infinity are not filled in. Heights along a bisector are rounded:
/// several edges of nearly no length may be mistaken for one another.
inline Tessellation glued_euclidean(const std::vector<Site>& sites) {
    const oracle::Tessellation solved = oracle::euclidean(sites);
    TessellationArrays arrays;
    arrays.metric = Metric::euclidean;
    arrays.sites = static_cast<std::int64_t>(sites.size());
    arrays.faces = solved.faces;
    arrays.neighbours.assign(solved.faces.size(), {0, 0, 0});
    for (const auto& [site, by] : solved.hidden) arrays.hidden.push_back({site, by});
    const auto corners = vertices(Tessellation(arrays, sites, {}));

    struct Side {
        double height;
        std::size_t face;
        std::size_t k;
    };
    std::map<std::pair<Index, Index>, std::vector<Side>> sides;
    for (std::size_t f = 0; f < arrays.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index from = arrays.faces[f][(k + 1) % 3];
            const Index to = arrays.faces[f][(k + 2) % 3];
            if (from == infinite || to == infinite) continue;
            // Upwards along the bisector of the smaller number, on the left, and the larger.
            const Site& a = sites[static_cast<std::size_t>(std::min(from, to))];
            const Site& b = sites[static_cast<std::size_t>(std::max(from, to))];
            double height = (corners[f].y - a.y) * (b.x - a.x) - (corners[f].x - a.x) * (b.y - a.y);
            const Index third = arrays.faces[f][k];
            if (third == infinite) {
                height = std::numeric_limits<double>::infinity() * (from < to ? 1 : -1);
            } else if (std::isnan(height)) {
                height = std::numeric_limits<double>::max() *
                         tangent_side(a, b, sites[static_cast<std::size_t>(third)]);
            }
            sides[{from, to}].push_back({height, f, k});
        }
    const auto sorted = [&](Index from, Index to) {
        auto& all = sides[{from, to}];
        std::sort(all.begin(), all.end(),
                  [](const Side& x, const Side& y) { return x.height < y.height; });
        return all;
    };
    for (const auto& [edge, unsorted] : std::map(sides)) {
        if (edge.first > edge.second) continue;
        const auto above = sorted(edge.first, edge.second);
        const auto below = sorted(edge.second, edge.first);
        for (std::size_t i = 0; i < above.size(); ++i) {
            arrays.neighbours[above[i].face][above[i].k] = static_cast<Index>(below[i].face);
            arrays.neighbours[below[i].face][below[i].k] = static_cast<Index>(above[i].face);
        }
    }
    return {arrays, sites, {}};
}

}  // namespace signum
