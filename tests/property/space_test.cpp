// The space of tessellations: swaps keep it a space, and lead from each to each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "../../triangulation/flip_graph.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

class Space : public testing::Test {
 protected:
    std::mt19937_64 random_{5};
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    std::size_t below(std::size_t count) { return random_() % count; }

    std::vector<Site> sites(std::size_t count, double radius = 0) {
        std::vector<Site> result(count);
        for (Site& s : result) s = {real(), real(), radius * real()};
        return result;
    }
    /// A tessellation far from any metric's.
    TessellationArrays stirred(const TessellationArrays& from, int swaps) {
        ExtendedTessellation t(from);
        for (int i = 0; i < swaps; ++i) {
            const auto e = static_cast<Index>(below(static_cast<std::size_t>(t.edges())));
            if (t.can_swap(e)) t.swap(e);
        }
        return t.arrays();
    }
};

/// A triangulated sphere with these vertices: nothing of space.cpp is used.
void expect_sphere(const TessellationArrays& t, std::size_t vertices) {
    ASSERT_EQ(t.faces.size(), 2 * vertices - 2);
    ASSERT_EQ(t.neighbours.size(), t.faces.size());
    // Around a vertex, across one edge after the other, all its corners come.
    std::map<Index, std::size_t> corners;
    for (std::size_t f = 0; f < t.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            ++corners[t.faces[f][k]];
            ASSERT_NE(t.faces[f][k], t.faces[f][(k + 1) % 3]);
            const auto g = static_cast<std::size_t>(t.neighbours[f][k]);
            ASSERT_LT(g, t.faces.size());
            int found = 0;
            for (std::size_t l = 0; l < 3; ++l)
                found += static_cast<int>(t.neighbours[g][l] == static_cast<Index>(f) &&
                                          t.faces[g][(l + 1) % 3] == t.faces[f][(k + 2) % 3] &&
                                          t.faces[g][(l + 2) % 3] == t.faces[f][(k + 1) % 3]);
            ASSERT_GE(found, 1);
        }
    ASSERT_EQ(corners.size(), vertices + 1);
    std::set<Index> done;
    for (std::size_t f = 0; f < t.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = t.faces[f][k];
            if (!done.insert(v).second) continue;
            std::size_t count = 0;
            std::size_t at = f;
            do {
                std::size_t l = 0;
                while (t.faces[at][l] != v) ++l;
                at = static_cast<std::size_t>(t.neighbours[at][(l + 1) % 3]);
                ++count;
                ASSERT_LE(count, corners[v]);
            } while (at != f);
            ASSERT_EQ(count, corners[v]) << "vertex " << v;
        }
}

/// The vertices joined to v, as often as they are, sorted.
std::vector<Index> joined(const TessellationArrays& t, Index v) {
    std::vector<Index> result;
    for (const Face& face : t.faces)
        for (std::size_t k = 0; k < 3; ++k)
            if (face[k] == v) result.push_back(face[(k + 1) % 3]);
    std::ranges::sort(result);
    return result;
}

TEST_F(Space, ASwapTwiceIsNone) {
    for (const Metric metric : all_metrics) {
        const Tessellation t = triangulate(sites(30, 0.2), metric);
        ExtendedTessellation e(t.arrays());
        const std::size_t visible = 30 - t.hidden().size();
        EXPECT_EQ(static_cast<std::size_t>(e.edges()), 3 * visible - 3);
        EXPECT_EQ(e.arrays(), t.arrays());
        int refused = 0;
        for (Index edge = 0; edge < e.edges(); ++edge) {
            if (!e.can_swap(edge)) {
                ++refused;
                EXPECT_THROW(e.swap(edge), std::invalid_argument);
                continue;
            }
            const Edge ends = e.ends(edge);
            const Edge corners = e.corners(edge);
            e.swap(edge);
            const Edge now = e.ends(edge);
            EXPECT_EQ(std::minmax(now[0], now[1]), std::minmax(corners[0], corners[1]));
            ASSERT_NO_FATAL_FAILURE(expect_sphere(e.arrays(), visible));
            e.swap(edge);
            const Edge again = e.ends(edge);
            EXPECT_EQ(std::minmax(again[0], again[1]), std::minmax(ends[0], ends[1]));
            EXPECT_EQ(e.arrays(), t.arrays());
        }
        if (metric == Metric::power) {
            EXPECT_EQ(refused, 0);
        }
    }
}

TEST_F(Space, EverySwapLeavesASphere) {
    for (std::size_t n = 2; n < 9; ++n) {
        ExtendedTessellation t(triangulate(sites(n), Power{}).arrays());
        for (int i = 0; i < 300; ++i) {
            const auto e = static_cast<Index>(below(static_cast<std::size_t>(t.edges())));
            if (!t.can_swap(e)) continue;
            t.swap(e);
            ASSERT_NO_FATAL_FAILURE(expect_sphere(t.arrays(), n));
        }
    }
}

/// Every edge lies across from a corner in two faces, and joins the other two corners.
TEST_F(Space, FacesKnowTheirEdges) {
    for (std::size_t n = 2; n < 9; ++n) {
        ExtendedTessellation t(triangulate(sites(n), Power{}).arrays());
        for (int i = 0; i < 50; ++i) {
            std::map<Index, std::vector<Index>> across;
            for (Index f = 0; f < t.faces(); ++f)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Face corners = t.corners_of(f);
                    const Index edge = t.edges_of(f)[k];
                    across[edge].push_back(corners[k]);
                    const Edge ends = t.ends(edge);
                    EXPECT_EQ(std::minmax(ends[0], ends[1]),
                              std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]));
                }
            ASSERT_EQ(across.size(), 3 * n - 3);
            for (const auto& [edge, corners] : across) {
                ASSERT_EQ(corners.size(), 2U);
                const Edge expected = t.corners(edge);
                EXPECT_EQ(std::minmax(corners[0], corners[1]),
                          std::minmax(expected[0], expected[1]));
            }
            const auto e = static_cast<Index>(below(static_cast<std::size_t>(t.edges())));
            if (t.can_swap(e)) t.swap(e);
        }
    }
}

TEST_F(Space, ReducedFormHasTheLastSiteBetweenTheFirstTwoAndInfinity) {
    for (std::size_t n = 3; n < 200; n += 1 + n / 4)
        for (int round = 0; round < 8; ++round) {
            const TessellationArrays start =
                stirred(triangulate(sites(n), Power{}).arrays(), round * 100);
            ExtendedTessellation t(start);
            const std::vector<Index> swaps = reduced_form(t);
            EXPECT_LE(swaps.size(), 8 * n);
            const TessellationArrays reduced = t.arrays();
            ASSERT_NO_FATAL_FAILURE(expect_sphere(reduced, n));
            EXPECT_EQ(joined(reduced, static_cast<Index>(n - 1)), (std::vector<Index>{-1, 0, 1}));
            EXPECT_EQ(replay(start, swaps), reduced);
        }
    ExtendedTessellation two(triangulate(sites(2), Power{}).arrays());
    EXPECT_TRUE(reduced_form(two).empty());
    ExtendedTessellation one(triangulate(sites(1), Power{}).arrays());
    EXPECT_TRUE(reduced_form(one).empty());
}

TEST_F(Space, EveryMetricIsReachedFromEveryOther) {
    for (std::size_t n = 1; n < 60; n += 1 + n / 5) {
        const auto points = sites(n);  // without radii none is hidden in any metric
        for (const Metric from : all_metrics)
            for (const Metric to : all_metrics) {
                const TessellationArrays a = triangulate(points, from).arrays();
                const TessellationArrays b = triangulate(points, to).arrays();
                const std::vector<Index> swaps = path(a, b);
                EXPECT_LE(swaps.size(), 2 * n * n + 8 * n);
                TessellationArrays arrived = replay(a, swaps);
                EXPECT_EQ(arrived.faces, b.faces);
                EXPECT_EQ(arrived.neighbours, b.neighbours);
            }
    }
}

TEST_F(Space, EveryStepOfAPathIsATessellation) {
    const auto discs = sites(14, 0.05);
    const Tessellation a = triangulate(discs, Euclidean{});
    ASSERT_TRUE(a.hidden().empty());
    const TessellationArrays b = triangulate(discs, Supremum{}).arrays();
    ExtendedTessellation t(a.arrays());
    for (const Index edge : path(a.arrays(), b)) {
        t.swap(edge);
        ASSERT_NO_FATAL_FAILURE(expect_sphere(t.arrays(), 14));
    }
    EXPECT_EQ(t.arrays().faces, b.faces);
}

/// Far from any metric's, with several edges between the same vertices.
TEST_F(Space, StirredTessellationsAreReached) {
    for (std::size_t n = 2; n < 80; n += 1 + n / 3)
        for (int round = 0; round < 10; ++round) {
            const TessellationArrays delaunay = triangulate(sites(n), Power{}).arrays();
            const TessellationArrays a = stirred(delaunay, 20 * round);
            const TessellationArrays b = stirred(delaunay, 7 * round);
            // Back to Delaunay's, which has no two faces with the same corners.
            std::vector<Index> swaps = path(a, delaunay);
            EXPECT_EQ(replay(a, swaps).faces, delaunay.faces);
            EXPECT_EQ(replay(a, swaps).neighbours, delaunay.neighbours);
            // And by way of b.
            const TessellationArrays arrived = replay(a, path(a, b));
            EXPECT_EQ(replay(arrived, path(arrived, delaunay)).faces, delaunay.faces);
            EXPECT_EQ(arrived.faces, b.faces);
        }
}

TEST_F(Space, RefusesWhatIsNoTessellation) {
    const TessellationArrays good = triangulate(sites(8), Power{}).arrays();
    const TessellationArrays other = triangulate(sites(9), Power{}).arrays();
    EXPECT_THROW(static_cast<void>(path(good, other)), std::invalid_argument);
    TessellationArrays bad = good;
    bad.neighbours[0][0] = 99;
    EXPECT_THROW(ExtendedTessellation{bad}, std::invalid_argument);
    bad = good;
    std::swap(bad.neighbours[0], bad.neighbours[1]);
    EXPECT_THROW(ExtendedTessellation{bad}, std::invalid_argument);
    bad = good;
    bad.faces[0][1] = bad.faces[0][2];
    EXPECT_THROW(ExtendedTessellation{bad}, std::invalid_argument);
    bad = good;
    bad.neighbours.pop_back();
    EXPECT_THROW(ExtendedTessellation{bad}, std::invalid_argument);
}

}  // namespace
}  // namespace signum
