// The brute-force Apollonius graph: small cases by hand, counts, symmetries, and what a grid of
// points sees of the cells.
#include <gtest/gtest.h>
#include "euclidean.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using signum::Site;
using signum::oracle::Enclosure;
using signum::oracle::euclidean;
using signum::oracle::Integer;
using signum::oracle::Tessellation;
using signum::oracle::Undecided;
using Sites = std::vector<Site>;
using Faces = std::vector<std::array<std::int32_t, 3>>;
using Hidden = std::vector<std::array<std::int32_t, 2>>;

std::string text(const Sites& sites) {
    std::string result;
    for (const Site& s : sites) {
        result += " {" + std::to_string(s.x) + "," + std::to_string(s.y) + "," +
                  std::to_string(s.r) + "}";
    }
    return result;
}

void expect(const Sites& sites, const Faces& faces, const Hidden& hidden = {}) {
    const Tessellation result = euclidean(sites);
    EXPECT_EQ(result.faces, faces) << text(sites);
    EXPECT_EQ(result.hidden, hidden) << text(sites);
}

class Random {
 public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(n)); }
    double unit() { return static_cast<double>(engine_()) / 4294967296.0; }
    Sites small(int n, int range, int radii) {
        Sites sites;
        for (int i = 0; i < n; ++i) {
            sites.push_back({static_cast<double>(below(range)), static_cast<double>(below(range)),
                             static_cast<double>(below(radii))});
        }
        return sites;
    }
    Sites generic(int n) {
        Sites sites;
        for (int i = 0; i < n; ++i) {
            sites.push_back({100.0 * unit(), 100.0 * unit(), 25.0 * unit()});
        }
        return sites;
    }
    void shuffle(std::vector<std::int32_t>& order) {
        std::shuffle(order.begin(), order.end(), engine_);
    }

 private:
    std::mt19937 engine_;
};

Tessellation renamed(Tessellation t, const std::vector<std::int32_t>& name) {
    const auto of = [&](std::int32_t a) { return a < 0 ? a : name[static_cast<std::size_t>(a)]; };
    for (auto& face : t.faces) {
        for (std::int32_t& a : face) a = of(a);
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    }
    for (auto& [site, by] : t.hidden) {
        site = of(site);
        by = of(by);
    }
    std::sort(t.faces.begin(), t.faces.end());
    std::sort(t.hidden.begin(), t.hidden.end());
    return t;
}

TEST(OracleEnclosure, GrowsUntilASignIsCertain) {
    const auto certain = [](std::int64_t precision, auto&& number) {
        Enclosure::precision = precision;
        try {
            return number().sign();
        } catch (const Undecided&) {
            return 0;
        }
    };
    const auto speck = [] { return (Enclosure{1} + Enclosure{Integer{1}, -5000}) - Enclosure{1}; };
    EXPECT_EQ(certain(64, speck), 0);
    EXPECT_EQ(certain(4096, speck), 0);
    EXPECT_EQ(certain(8192, speck), 1);
    // 3/7 - 3/7 is never certain, however precise; 1/3 - 333/1000 soon is.
    const auto nothing = [] { return Enclosure{3} / 7 - Enclosure{-3} / -7; };
    const auto third = [] { return Enclosure{1} / 3 - Enclosure{333} / 1000; };
    // sqrt(2) + sqrt(3) - sqrt(5 + 2 sqrt(6)) = 0, and with 2^-200 under the root it is less.
    const auto roots = [] { return sqrt(Enclosure{2}) + sqrt(Enclosure{3}); };
    const auto equal = [&] { return roots() - sqrt(Enclosure{5} + 2 * sqrt(Enclosure{6})); };
    const auto less = [&] {
        return roots() - sqrt(Enclosure{5} + 2 * sqrt(Enclosure{6}) + Enclosure{Integer{1}, -200});
    };
    for (const std::int64_t precision : {32, 64, 128, 256, 512}) {
        EXPECT_EQ(certain(precision, nothing), 0);
        EXPECT_EQ(certain(precision, third), 1);
        EXPECT_EQ(certain(precision, [&] { return -third(); }), -1);
        EXPECT_EQ(certain(precision, [&] { return (-third()) * third(); }), -1);
        EXPECT_EQ(certain(precision, [&] { return third() / (-third()); }), -1);
        EXPECT_EQ(certain(precision, equal), 0);
    }
    EXPECT_EQ(certain(128, less), 0);
    EXPECT_EQ(certain(256, less), -1);
    EXPECT_THROW(Enclosure{}.sign(), std::logic_error);
    EXPECT_THROW(sqrt(Enclosure{-1}), std::logic_error);
}

TEST(OracleEuclidean, FewSites) {
    expect({}, {});
    expect({{3, 4, -5}}, {});
    expect({{0, 0, 1}, {5, 5, 0}}, {{-1, 0, 1}, {-1, 1, 0}});
    expect({{0, 0, 4}, {3, 0, 3}}, {{-1, 0, 1}, {-1, 1, 0}});
    expect({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}});
    expect({{0, 0, 0}, {0, 2, 0}, {2, 0, 0}}, {{-1, 0, 1}, {-1, 1, 2}, {-1, 2, 0}, {0, 2, 1}});
}

TEST(OracleEuclidean, HiddenSites) {
    // Equal sites: the least index is visible.
    expect({{1, 1, 2}, {1, 1, 2}, {1, 1, 2}}, {}, {{1, 0}, {2, 0}});
    // Inside, and touching from inside.
    expect({{1, 0, 0}, {0, 0, 5}, {3, 0, 2}}, {}, {{0, 1}, {2, 1}});
    // `by` is the nearer of two that hide it; at the same distance the earlier in the order, which
    // is the larger, then the one to the left.
    expect({{0, 0, 5}, {6, 0, 5}, {4, 0, 0}}, {{-1, 0, 1}, {-1, 1, 0}}, {{2, 1}});
    expect({{6, 0, 5}, {0, 0, 5}, {3, 0, 0}}, {{-1, 0, 1}, {-1, 1, 0}}, {{2, 1}});
    expect({{0, 0, 3}, {5, 0, 4}, {2, 0, 0}}, {{-1, 0, 1}, {-1, 1, 0}}, {{2, 1}});
    // Nested three deep: the nearest visible one is the outermost.
    expect({{0, 0, 9}, {1, 0, 5}, {1, 0, 2}}, {}, {{1, 0}, {2, 0}});
}

TEST(OracleEuclidean, CollinearSites) {
    expect({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}});
    expect({{5, 5, 1}, {0, 0, 1}, {3, 3, 1}}, {{-1, 0, 2}, {-1, 1, 2}, {-1, 2, 0}, {-1, 2, 1}});
    // Radii in proportion: still a common tangent on each side.
    expect({{0, 0, 0}, {4, 0, 2}, {2, 0, 1}}, {{-1, 0, 2}, {-1, 1, 2}, {-1, 2, 0}, {-1, 2, 1}});
    // The middle one is smaller: it has a cell between two edges of its neighbours.
    expect({{-10, 0, 9}, {10, 0, 9}, {0, 0, 0}}, {{-1, 0, 1}, {-1, 1, 0}, {0, 1, 2}, {0, 2, 1}});
    // Site 2 holds both ends of the bisector of 0 and 1.
    expect({{-1, 0, 0}, {1, 0, 0}, {10, 0, 5}}, {{-1, 0, 2}, {-1, 2, 0}, {0, 1, 2}, {0, 2, 1}});
}

TEST(OracleEuclidean, Ties) {
    // A square: the last site gives way, so the diagonal joins the other two.
    expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 2}, {1, 3, 2}});
    expect({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1.25}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 3}, {0, 3, 2}});
    // Three discs on a line, the smallest in the middle: it leaves the line, and a circle of nearly
    // infinite radius touches all three from below.
    expect({{0, 2, 2}, {10, 2, 2}, {5, 1, 1}}, {{-1, 0, 1}, {-1, 1, 0}, {0, 1, 2}, {0, 2, 1}});
    // The largest in the middle stays on the line.
    expect({{0, 1, 1}, {10, 1, 1}, {5, 2, 2}}, {{-1, 0, 2}, {-1, 1, 2}, {-1, 2, 0}, {-1, 2, 1}});
    // The smallest at the end of the line.
    expect({{0, 2, 2}, {10, 2, 2}, {12, 1, 1}}, {{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}});
}

TEST(OracleEuclidean, RejectsWhatIsNoNumber) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(euclidean(Sites{{nan, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(euclidean(Sites{{0, infinity, 0}}), std::invalid_argument);
    EXPECT_THROW(euclidean(Sites{{0, 0, 0}, {0, 0, -infinity}}), std::invalid_argument);
}

// The oracle checks 2n-2 faces and the gluing itself, and that other infinitesimals give the same.
TEST(OracleEuclidean, EveryTinyInputIsASphere) {
    Random random(1);
    for (int n = 0; n < 3000; ++n) {
        const int size = 1 + n % 7;
        const int range = 2 + random.below(5);
        const Sites sites = random.small(size, range, 1 + random.below(4));
        ASSERT_NO_THROW({
            const Tessellation t = euclidean(sites);
            const auto visible = static_cast<std::size_t>(size) - t.hidden.size();
            ASSERT_GE(visible, 1U);
            ASSERT_EQ(t.faces.size(), visible == 1 ? 0 : 2 * visible - 2) << text(sites);
            ASSERT_TRUE(std::is_sorted(t.faces.begin(), t.faces.end()));
            for (const auto& [a, b, c] : t.faces) ASSERT_TRUE(a < b && a < c && b != c);
        }) << text(sites);
    }
}

TEST(OracleEuclidean, Symmetries) {
    Random random(2);
    for (int n = 0; n < 250; ++n) {
        Sites sites = n % 5 == 0 ? random.generic(5) : random.small(3 + n % 4, 4, 1 + n % 3);
        std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) {
            return std::array{a.x, a.y, a.r} < std::array{b.x, b.y, b.r};
        });
        sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
        const Tessellation expected = euclidean(sites);
        // Site m of the original is site name[m] of the permuted input.
        std::vector<std::int32_t> name(sites.size());
        std::iota(name.begin(), name.end(), 0);
        random.shuffle(name);
        Sites permuted(sites.size());
        for (std::size_t m = 0; m < sites.size(); ++m) {
            permuted[static_cast<std::size_t>(name[m])] = sites[m];
        }
        ASSERT_EQ(euclidean(permuted), renamed(expected, name)) << text(sites);

        const double scale = std::ldexp(1.0, random.below(600) - 300);
        Sites scaled = sites;
        for (Site& s : scaled) s = {scale * s.x, scale * s.y, scale * s.r};
        ASSERT_EQ(euclidean(scaled), expected) << text(sites);

        if (n % 5 != 0) {
            Sites moved = sites;
            const double more = random.below(40) - 20;
            for (Site& s : moved) s = {s.x + 3 * more, s.y - more, s.r + more};
            ASSERT_EQ(euclidean(moved), expected) << text(sites);
            // Half a turn keeps circles, but not the order of the sites: only without ties.
        } else {
            Sites turned = sites;
            for (Site& s : turned) s = {-s.x, -s.y, s.r};
            ASSERT_EQ(euclidean(turned), expected) << text(sites);
            Sites mirrored = sites;
            for (Site& s : mirrored) s = {s.y, s.x, s.r};
            Tessellation other = euclidean(mirrored);
            for (auto& [a, b, c] : other.faces) std::swap(b, c);
            std::sort(other.faces.begin(), other.faces.end());
            ASSERT_EQ(other, expected) << text(sites);
        }
    }
}

class Nearest {
 public:
    explicit Nearest(const Sites& sites) : sites_(sites) {}
    std::int32_t operator()(double x, double y) const {
        std::int32_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t m = 0; m < sites_.size(); ++m) {
            const double d = std::hypot(x - sites_[m].x, y - sites_[m].y) - sites_[m].r;
            if (d < least) {
                least = d;
                best = static_cast<std::int32_t>(m);
            }
        }
        return best;
    }
    /// The pairs of cells that share a boundary on the way from p to q, as far as halving sees it.
    void neighbours(std::array<double, 2> p, std::array<double, 2> q,
                    std::set<std::pair<std::int32_t, std::int32_t>>& found) const {
        const std::int32_t a = (*this)(p[0], p[1]);
        const std::int32_t b = (*this)(q[0], q[1]);
        if (a == b) return;
        if (std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-9) {
            found.insert(std::minmax(a, b));
            return;
        }
        const std::array<double, 2> middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
        neighbours(p, middle, found);
        neighbours(middle, q, found);
    }

 private:
    const Sites& sites_;
};

TEST(OracleEuclidean, WhatAGridOfPointsSees) {
    Random random(3);
    int hidden = 0;
    int seen = 0;
    int edges = 0;
    int twice = 0;
    for (int n = 0; n < 100; ++n) {
        const Sites sites = random.generic(3 + n % 6);
        const Tessellation t = euclidean(sites);
        const Nearest nearest(sites);
        std::set<std::int32_t> covered;
        for (const auto& [site, by] : t.hidden) {
            covered.insert(site);
            ++hidden;
            const Site& s = sites[static_cast<std::size_t>(site)];
            ASSERT_EQ(nearest(s.x, s.y), by) << text(sites);
        }
        std::multiset<std::pair<std::int32_t, std::int32_t>> joined;
        for (const auto& [a, b, c] : t.faces) {
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
                if (from < to && from >= 0) joined.insert({from, to});
            }
        }
        for (std::size_t m = 0; m < sites.size(); ++m) {
            const auto site = static_cast<std::int32_t>(m);
            if (!covered.contains(site)) {
                ASSERT_EQ(nearest(sites[m].x, sites[m].y), site) << text(sites);
            }
        }
        std::set<std::pair<std::int32_t, std::int32_t>> found;
        constexpr int kSteps = 40;
        const auto at = [](int step) { return -200.0 + 500.0 * step / kSteps; };
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                ASSERT_FALSE(covered.contains(nearest(at(i), at(j)))) << text(sites);
                nearest.neighbours({at(i), at(j)}, {at(i + 1), at(j)}, found);
                nearest.neighbours({at(i), at(j)}, {at(i), at(j + 1)}, found);
            }
        }
        for (const auto& pair : found) ASSERT_TRUE(joined.contains(pair)) << text(sites);
        // On the other hand nearly all edges are long enough to be seen.
        const std::set<std::pair<std::int32_t, std::int32_t>> once(joined.begin(), joined.end());
        seen += static_cast<int>(found.size());
        edges += static_cast<int>(once.size());
        twice += static_cast<int>(joined.size() - once.size());
    }
    EXPECT_GE(hidden, 10);
    EXPECT_GE(twice, 10);
    EXPECT_GE(seen, edges * 9 / 10) << seen << " of " << edges;
}

TEST(OracleEuclidean, EqualRadiiAreDelaunay) {
    Random random(4);
    const auto integer = [](double value) { return static_cast<std::int64_t>(value); };
    for (int n = 0; n < 300; ++n) {
        Sites sites = random.small(3 + n % 5, 3 + n % 6, 1);
        for (Site& s : sites) s.r = -7;
        const Tessellation t = euclidean(sites);
        std::set<std::pair<double, double>> points;
        for (const Site& s : sites) points.insert({s.x, s.y});
        ASSERT_EQ(sites.size() - t.hidden.size(), points.size()) << text(sites);
        for (const auto& [site, by] : t.hidden) {
            ASSERT_LT(by, site);
            ASSERT_EQ(sites[static_cast<std::size_t>(by)], sites[static_cast<std::size_t>(site)]);
        }
        for (const auto& face : t.faces) {
            if (face[0] < 0) continue;
            for (const Site& s : sites) {
                // Rows of the classical determinant, relative to s; without the last column, and
                // relative to the first corner, the orientation.
                std::array<std::array<std::int64_t, 3>, 3> row{};
                for (std::size_t m = 0; m < 3; ++m) {
                    const Site& corner = sites[static_cast<std::size_t>(face[m])];
                    const std::int64_t x = integer(corner.x - s.x);
                    const std::int64_t y = integer(corner.y - s.y);
                    row[m] = {x, y, x * x + y * y};
                }
                const auto cross = [&](std::size_t a, std::size_t b) {
                    return row[a][0] * row[b][1] - row[a][1] * row[b][0];
                };
                ASSERT_GT(cross(0, 1) + cross(1, 2) + cross(2, 0), 0) << text(sites);
                ASSERT_LE(
                    row[2][2] * cross(0, 1) + row[0][2] * cross(1, 2) + row[1][2] * cross(2, 0), 0)
                    << text(sites);
            }
        }
    }
}

// Numbers of full length and of very different size: nothing is rounded.
TEST(OracleEuclidean, FullDoubles) {
    const double ulp = std::ldexp(1.0, -52);
    // The square, with the last site an ulp inside, then outside the circle of the others.
    expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 - ulp, 1, 0}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 3}, {0, 3, 2}});
    expect({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + ulp, 1, 0}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 3}, {-1, 3, 1}, {0, 1, 2}, {1, 3, 2}});
    // Touching from inside, and not quite.
    expect({{0, 0, 1}, {0.75, 0, 0.25}}, {}, {{1, 0}});
    expect({{0, 0, 1}, {0.75, 0, 0.25 + ulp}}, {{-1, 0, 1}, {-1, 1, 0}});
    const double tiny = std::numeric_limits<double>::denorm_min();
    expect({{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}});
    expect({{0, 0, 0}, {1, 0, 0}, {2, tiny, 0}}, {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}});
    expect({{0, 0, 0}, {1e308, 0, 0}, {0, 1e308, tiny}},
           {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}});
}

}  // namespace
