#pragma once
/// What the tests of the oracles share: little random inputs, canonical identities of sites, and
/// diagrams looked at with nothing but distances.

#include "oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace signum::oracle_test {

using oracle::Tessellation;
using Face = std::array<std::int32_t, 3>;
using Faces = std::vector<Face>;

/// The same numbers with every standard library.
class Random {
 public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    int below(int bound) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(bound)); }
    /// A multiple of 2^-30 in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 34) * 0x1p-30; }

 private:
    std::mt19937_64 engine_;
};

inline Face rotated(Face face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

/// n sites with coordinates 0, 1, …, range-1 and radii 0, 1, …, radii-1: ties everywhere.
template <class Site>
std::vector<Site> integer_sites(Random& random, int n, int range, int radii) {
    std::vector<Site> sites;
    for (int i = 0; i < n; ++i) {
        const double x = random.below(range), y = random.below(range);
        sites.push_back({x, y, static_cast<double>(random.below(radii))});
    }
    return sites;
}

/// n sites with coordinates in [0, 1) and radii in [0, radius): no ties.
template <class Site>
std::vector<Site> generic_sites(Random& random, int n, double radius) {
    std::vector<Site> sites;
    for (int i = 0; i < n; ++i) {
        const double x = random.unit(), y = random.unit();
        sites.push_back({x, y, random.unit() * radius});
    }
    return sites;
}

/// The ranks of the sites by falling size, rising x, y, index. `size` must be exact here.
template <class Site, class Size>
std::vector<std::int32_t> ranks(const std::vector<Site>& sites, Size size) {
    std::vector<std::size_t> order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (size(sites[a]) != size(sites[b])) return size(sites[a]) > size(sites[b]);
        if (sites[a].x != sites[b].x) return sites[a].x < sites[b].x;
        return sites[a].y < sites[b].y;
    });
    std::vector<std::int32_t> rank(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<std::int32_t>(i);
    return rank;
}

/// Site i gets the number names[i].
inline Tessellation renamed(Tessellation t, const std::vector<std::int32_t>& names) {
    for (Face& face : t.faces) {
        for (std::int32_t& vertex : face)
            if (vertex >= 0) vertex = names[static_cast<std::size_t>(vertex)];
        face = rotated(face);
    }
    for (auto& pair : t.hidden)
        for (std::int32_t& site : pair) site = names[static_cast<std::size_t>(site)];
    std::sort(t.faces.begin(), t.faces.end());
    std::sort(t.hidden.begin(), t.hidden.end());
    return t;
}

inline Tessellation mirrored(Tessellation t) {
    for (Face& face : t.faces) face = rotated({face[0], face[2], face[1]});
    std::sort(t.faces.begin(), t.faces.end());
    return t;
}

template <class Site>
std::vector<Site> shuffled(std::vector<Site> sites, Random& random) {
    for (std::size_t i = sites.size(); i > 1; --i)
        std::swap(sites[i - 1], sites[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    return sites;
}

/// The diagram of at most nine sites as a person with a calculator would see it.
template <class Distance>  // distance(site number, x, y)
class Diagram {
 public:
    Diagram(std::size_t sites, Distance distance) : sites_(sites), distance_(distance) {}

    std::int32_t nearest(double x, double y) const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < sites_; ++i)
            if (distance_(i, x, y) < distance_(best, x, y)) best = i;
        return static_cast<std::int32_t>(best);
    }

    /// Looks at the square [-1, 2]²: which sites are seen at the points of a fine grid, which pairs
    /// of cells meet on the lines of a coarse one, which triples at a point.
    void look() {
        constexpr int fine = 128, coarse = 32;
        for (int i = 0; i <= fine; ++i)
            for (int j = 0; j <= fine; ++j) seen_.insert(nearest(at(i, fine), at(j, fine)));
        for (int i = 0; i < coarse; ++i) {
            for (int j = 0; j < coarse; ++j) {
                const Spot a = spot(at(i, coarse), at(j, coarse));
                const Spot b = spot(at(i + 1, coarse), at(j, coarse));
                const Spot c = spot(at(i, coarse), at(j + 1, coarse));
                follow(a, b), follow(a, c);
                narrow((a.x + b.x) / 2, (a.y + c.y) / 2, (b.x - a.x) / 2);
            }
        }
    }

    const std::set<std::int32_t>& seen() const { return seen_; }
    const std::set<std::pair<std::int32_t, std::int32_t>>& edges() const { return edges_; }
    const std::set<Face>& faces() const { return faces_; }

 private:
    struct Spot {
        double x, y;
        std::int32_t site;
    };
    static double at(int i, int parts) { return -1 + 3.0 * i / parts + 1e-4; }
    static bool are_close(const Spot& a, const Spot& b) {
        return std::abs(a.x - b.x) + std::abs(a.y - b.y) < 1e-10;
    }
    Spot spot(double x, double y) const { return {x, y, nearest(x, y)}; }
    Spot middle(const Spot& a, const Spot& b) const {
        return spot((a.x + b.x) / 2, (a.y + b.y) / 2);
    }

    /// The cells that meet on the way from a to b.
    void follow(const Spot& a, const Spot& b) {
        if (a.site == b.site) return;
        if (are_close(a, b)) {
            edges_.insert(std::minmax(a.site, b.site));
            return;
        }
        const Spot m = middle(a, b);
        follow(a, m), follow(m, b);
    }

    /// Where a square (x ± half, y ± half) or its surroundings see three sites, halve it. In the
    /// end, a walk around the point tells who meets there.
    void narrow(double x, double y, double half) {
        std::set<std::int32_t> sites;
        for (int i = -2; i <= 2; ++i)
            for (int j = -2; j <= 2; ++j)
                sites.insert(nearest(x + 0.7 * half * i, y + 0.7 * half * j));
        if (sites.size() < 3) return;
        if (half > 1e-10) {
            half /= 2;
            narrow(x - half, y - half, half), narrow(x + half, y - half, half);
            narrow(x - half, y + half, half), narrow(x + half, y + half, half);
            return;
        }
        std::vector<std::int32_t> around;
        for (int i = 0; i < 256; ++i) {
            const double angle = i * (2 * 3.14159265358979 / 256);
            const auto site = nearest(x + 1e-8 * std::cos(angle), y + 1e-8 * std::sin(angle));
            if (around.empty() || around.back() != site) around.push_back(site);
        }
        if (around.front() == around.back()) around.pop_back();
        if (around.size() == 3) faces_.insert(rotated({around[0], around[1], around[2]}));
    }

    std::size_t sites_;
    Distance distance_;
    std::set<std::int32_t> seen_;
    std::set<std::pair<std::int32_t, std::int32_t>> edges_;
    std::set<Face> faces_;
};

/// The sites that are not hidden.
inline std::set<std::int32_t> visible_sites(const Tessellation& t, std::size_t sites) {
    std::set<std::int32_t> visible;
    for (std::size_t i = 0; i < sites; ++i) visible.insert(static_cast<std::int32_t>(i));
    for (const auto& pair : t.hidden) visible.erase(pair[0]);
    return visible;
}

/// The edges, each once and smaller number first.
inline std::set<std::pair<std::int32_t, std::int32_t>> edges_of(const Tessellation& t) {
    std::set<std::pair<std::int32_t, std::int32_t>> edges;
    for (const Face& face : t.faces)
        for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(face[i], face[(i + 1) % 3]));
    return edges;
}

/// Everything a look at the diagram shows must be in the tessellation. Says how many of its finite
/// faces were seen.
template <class Distance>
std::size_t faces_seen(const Tessellation& t, std::size_t sites, Distance distance, bool& agrees) {
    Diagram diagram(sites, distance);
    diagram.look();
    const auto visible = visible_sites(t, sites);
    const auto edges = edges_of(t);
    const auto within = [](const auto& part, const auto& whole) {
        return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
    };
    agrees = within(diagram.seen(), visible) && within(diagram.edges(), edges) &&
             within(diagram.faces(), t.faces);
    return diagram.faces().size();
}

/// How many faces have no infinite vertex.
inline std::size_t finite_faces(const Tessellation& t) {
    return static_cast<std::size_t>(
        std::count_if(t.faces.begin(), t.faces.end(), [](const Face& f) { return f[0] >= 0; }));
}

}  // namespace signum::oracle_test
