// validate() accepts what triangulate() makes, rejects every mutation of it with a word about what
// is wrong, judges anything else as the definition does, and survives anything.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"
#include "judged_by_definition.hpp"

namespace signum {
namespace {

const int effort = is_fast ? 4 : 1;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

class Random {
 public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    int between(int low, int high) { return low + below(high - low + 1); }
    double real() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    std::mt19937_64& engine() { return bits_; }

 private:
    std::mt19937_64 bits_;
};

struct Family {
    const char* name;
    Site (*draw)(Random&);
};
void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

const Family families[] = {
    {"random",
     [](Random& g) {
         return Site{g.real(), g.real(), 0.0};
     }},
    {"radii",
     [](Random& g) {
         return Site{g.real(), g.real(), 0.2 * g.real()};
     }},
    {"grid",
     [](Random& g) {
         return Site{1.0 * g.below(60), 1.0 * g.below(60), 0.0};
     }},
    {"grid_with_radii",
     [](Random& g) {
         return Site{1.0 * g.below(30), 1.0 * g.below(30), 1.0 * g.below(3)};
     }},
    {"circle",
     [](Random& g) {
         const double a = 6.283185307179586 * g.real();
         return Site{std::cos(a), std::sin(a), 1.0};
     }},
    {"cocircular",
     [](Random& g) {
         static constexpr int points[5][2] = {{63, 16}, {56, 33}, {60, 25}, {52, 39}, {65, 0}};
         const auto& p = points[g.below(5)];
         const int swap = g.below(2);
         return Site{1.0 * p[swap] * (1 - 2 * g.below(2)), 1.0 * p[1 - swap] * (1 - 2 * g.below(2)),
                     2.0};
     }},
    {"collinear",
     [](Random& g) {
         const double t = g.below(4000);
         return Site{3 * t, -t, 1.0 * g.below(4)};
     }},
    {"vertical",
     [](Random& g) {
         return Site{5.0, 1.0 * g.below(500), 0.0};
     }},
    {"nearly_collinear",
     [](Random& g) {
         const double t = g.below(900);
         return Site{0.1 * t, 0.3 * t, 0.0};
     }},
    {"duplicates",
     [](Random& g) {
         return Site{1.0 * g.below(3), 1.0 * g.below(3), g.real()};
     }},
    {"square",
     [](Random& g) {
         const double t = g.below(700);
         const int side = g.below(4);
         return Site{side == 0 ? 0 : side == 1 ? 700 : t, side == 2 ? 0 : side == 3 ? 700 : t, 1.0};
     }},
    {"extremes",
     [](Random& g) {
         static constexpr double values[] = {0, 0x1p-1074, 1, -1, 1.7e308, -1.7e308, 0x1p-300};
         return Site{values[g.below(7)], values[g.below(7)], 0.0};
     }},
};

std::vector<Site> draw(const Family& family, Random& random, int n) {
    std::vector<Site> sites(static_cast<std::size_t>(n));
    for (Site& s : sites) s = family.draw(random);
    return sites;
}

[[nodiscard]] testing::AssertionResult canonical(const TessellationArrays& t,
                                                 const std::vector<Site>& sites) {
    const Validation v = validate(t, sites);
    if (v.valid && v.canonical && v.message.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "valid " << v.valid << ", canonical " << v.canonical << ": " << v.message;
}

[[nodiscard]] testing::AssertionResult valid_alone(const TessellationArrays& t,
                                                   const std::vector<Site>& sites) {
    const Validation v = validate(t, sites);
    if (v.valid && !v.canonical && !v.message.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "valid " << v.valid << ", canonical " << v.canonical << ": " << v.message;
}

[[nodiscard]] testing::AssertionResult invalid(const TessellationArrays& t,
                                               const std::vector<Site>& sites) {
    const Validation v = validate(t, sites);
    if (!v.valid && !v.canonical && !v.message.empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "valid " << v.valid << ", canonical " << v.canonical << ": " << v.message;
}

class Validate : public testing::TestWithParam<Family> {
 protected:
    Random random_{99};
};

TEST_P(Validate, AcceptsEveryResult) {
    for (int n = 0; n <= 40; ++n) {
        const auto sites = draw(GetParam(), random_, n);
        ASSERT_TRUE(canonical(triangulate(sites, Power{}).arrays(), sites)) << n;
    }
    for (const int n : {100, 500 * effort, 750 * effort}) {
        const auto sites = draw(GetParam(), random_, n);
        ASSERT_TRUE(canonical(triangulate(sites, Power{}).arrays(), sites)) << n;
    }
}

TEST_P(Validate, AcceptsWeights) {
    for (const int n : {1, 2, 3, 4, 7, 20, 300}) {
        std::vector<power::Site> sites;
        for (const Site& s : draw(GetParam(), random_, n)) sites.push_back({s.x, s.y, s.r - 0.5});
        const Tessellation t = triangulate(sites, Power{});
        const Validation v = validate(t.arrays(), sites);
        ASSERT_TRUE(v.valid && v.canonical) << v.message;
    }
}

TEST_P(Validate, ShuffledFacesAreValidButNotCanonical) {
    for (int n = 3; n < 40; ++n) {
        const auto sites = draw(GetParam(), random_, n);
        TessellationArrays t = triangulate(sites, Power{}).arrays();
        if (t.faces.size() < 2) continue;
        t.neighbours.clear();
        ASSERT_TRUE(valid_alone(t, sites));
        const auto sorted = t.faces;
        while (t.faces == sorted) std::shuffle(t.faces.begin(), t.faces.end(), random_.engine());
        ASSERT_TRUE(valid_alone(t, sites));
    }
}

/// Reorders faces consistently, neighbours and all: still valid.
TEST_P(Validate, RotatedAndRenumberedIsValidButNotCanonical) {
    for (int n = 3; n < 40; ++n) {
        const auto sites = draw(GetParam(), random_, n);
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        if (t.faces.empty()) continue;
        TessellationArrays rotated = t;
        const std::size_t f = at(random_.below(static_cast<int>(t.faces.size())));
        const int by = random_.between(1, 2);
        std::rotate(rotated.faces[f].begin(), rotated.faces[f].begin() + by,
                    rotated.faces[f].end());
        std::rotate(rotated.neighbours[f].begin(), rotated.neighbours[f].begin() + by,
                    rotated.neighbours[f].end());
        ASSERT_TRUE(valid_alone(rotated, sites));

        std::vector<Index> place(t.faces.size());
        std::iota(place.begin(), place.end(), 0);
        std::reverse(place.begin(), place.end());
        TessellationArrays reversed = t;
        for (std::size_t i = 0; i < place.size(); ++i) {
            reversed.faces[at(place[i])] = t.faces[i];
            Face neighbours = t.neighbours[i];
            for (Index& g : neighbours) g = place[at(g)];
            reversed.neighbours[at(place[i])] = neighbours;
        }
        ASSERT_TRUE(valid_alone(reversed, sites));
    }
}

/// Mutations after which nothing can be right.
TEST_P(Validate, RejectsMutations) {
    for (int round = 0; round < 60 * effort; ++round) {
        const auto sites = draw(GetParam(), random_, random_.between(3, 30));
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        if (t.faces.empty()) continue;
        const std::size_t f = at(random_.below(static_cast<int>(t.faces.size())));
        const std::size_t g = at(random_.below(static_cast<int>(t.faces.size())));
        const auto k = at(random_.below(3));
        const auto n = static_cast<Index>(sites.size());
        {
            TessellationArrays m = t;
            m.faces.erase(m.faces.begin() + static_cast<std::ptrdiff_t>(f));
            m.neighbours.clear();
            ASSERT_TRUE(invalid(m, sites)) << "removed face";
        }
        {
            TessellationArrays m = t;
            m.faces.push_back(m.faces[f]);
            m.neighbours.clear();
            ASSERT_TRUE(invalid(m, sites)) << "duplicated face";
        }
        if (f != g) {
            TessellationArrays m = t;
            m.faces[g] = m.faces[f];
            m.neighbours.clear();
            ASSERT_TRUE(invalid(m, sites)) << "face in place of another";
        }
        {
            TessellationArrays m = t;
            std::swap(m.faces[f][k], m.faces[f][(k + 1) % 3]);
            m.neighbours.clear();
            // Two sites have (-1, 0, 1) and (-1, 1, 0), of which one twice is nothing.
            ASSERT_TRUE(invalid(m, sites)) << "face turned over";
        }
        {
            TessellationArrays m = t;
            for (Face& face : m.faces) std::swap(face[1], face[2]);
            m.neighbours.clear();
            // On a line the mirror image is the same.
            if (m.faces.back()[0] != infinite) {
                ASSERT_TRUE(invalid(m, sites)) << "all turned over";
            }
        }
        for (const Index wrong : {Index{-2}, n, Index{1 << 30}, std::numeric_limits<Index>::min(),
                                  std::numeric_limits<Index>::max()}) {
            TessellationArrays m = t;
            m.faces[f][k] = wrong;
            ASSERT_TRUE(invalid(m, sites)) << "site " << wrong;
            m = t;
            m.neighbours[f][k] = wrong;
            if (wrong >= n || wrong < 0) {
                if (at(wrong) >= t.faces.size()) {
                    ASSERT_TRUE(invalid(m, sites)) << "neighbour " << wrong;
                }
            }
            m = t;
            m.hidden.push_back({wrong, 0});
            ASSERT_TRUE(invalid(m, sites)) << "hidden " << wrong;
        }
        {
            TessellationArrays m = t;
            const Index other = static_cast<Index>(g);
            if (m.neighbours[f][k] != other) {
                m.neighbours[f][k] = other;
                ASSERT_TRUE(invalid(m, sites)) << "wrong neighbour";
            }
            m = t;
            m.neighbours.pop_back();
            ASSERT_TRUE(invalid(m, sites)) << "neighbours cut short";
            m = t;
            m.neighbours.push_back(m.neighbours.back());
            ASSERT_TRUE(invalid(m, sites)) << "neighbours to spare";
        }
        {
            TessellationArrays m = t;
            const Index v = m.faces[f][k] == infinite ? m.faces[f][(k + 1) % 3] : m.faces[f][k];
            const Index u = v == 0 ? 1 : 0;
            m.hidden.push_back({v, u});
            ASSERT_TRUE(invalid(m, sites)) << "visible and hidden";
        }
        {
            TessellationArrays m = t;
            m.faces.clear();
            m.neighbours.clear();
            ASSERT_TRUE(invalid(m, sites)) << "no faces";
            m.hidden.clear();
            ASSERT_TRUE(invalid(m, sites)) << "nothing";
        }
        {
            TessellationArrays m = t;
            m.sites += random_.below(2) == 0 ? 1 : -1;
            ASSERT_TRUE(invalid(m, sites)) << "wrong number of sites";
            m = t;
            m.metric = Metric::euclidean;  // of equal radii the same, ties included
            ASSERT_EQ(validate(m, sites).canonical, triangulate(sites, Euclidean{}).arrays() == m)
                << "wrong metric";
            m = t;
            m.weight_is = WeightIs::weight;
            ASSERT_TRUE(invalid(m, sites)) << "wrong kind of weight";
        }
        if (t.hidden.empty()) continue;
        const std::size_t h = at(random_.below(static_cast<int>(t.hidden.size())));
        {
            TessellationArrays m = t;
            m.hidden.erase(m.hidden.begin() + static_cast<std::ptrdiff_t>(h));
            ASSERT_TRUE(invalid(m, sites)) << "hidden site missing";
            m = t;
            m.hidden.push_back(m.hidden[h]);
            ASSERT_TRUE(invalid(m, sites)) << "hidden twice";
            m = t;
            m.hidden[h].by = m.hidden[h].site;
            ASSERT_TRUE(invalid(m, sites)) << "hidden by itself";
            // In the place of the visible site that hides it.
            m = t;
            const auto [site, by] = m.hidden[h];
            for (Face& face : m.faces)
                for (Index& v : face)
                    if (v == by) v = site;
            m.hidden[h] = {by, site};
            m.neighbours.clear();
            bool others = false;  // that the former hider hid
            for (const Hidden& other : m.hidden) others = others || other.by == by;
            const Validation v = validate(m, sites);
            ASSERT_FALSE(v.canonical) << "hidden and hider exchanged";
            if (others) {
                ASSERT_FALSE(v.valid) << "hidden by a hidden one";
            }
        }
        if (t.hidden.size() >= 2) {
            TessellationArrays m = t;
            std::swap(m.hidden.front(), m.hidden.back());
            ASSERT_TRUE(valid_alone(m, sites)) << "hidden not sorted";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Validate, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

/// The number of the vertex opposite to the edge shared with g.
std::size_t opposite(const TessellationArrays& t, Index f, Index g) {
    for (std::size_t k = 0; k < 3; ++k)
        if (t.neighbours[at(f)][k] == g) return k;
    throw std::logic_error("no neighbours");
}

/// Flips the edge of face f opposite its vertex k; neighbours are dropped.
TessellationArrays flipped(const TessellationArrays& t, Index f, std::size_t k) {
    TessellationArrays m = t;
    const Index g = t.neighbours[at(f)][k];
    const Face& face = t.faces[at(f)];
    const Index p = face[k];
    const Index a = face[(k + 1) % 3];
    const Index b = face[(k + 2) % 3];
    const Index q = t.faces[at(g)][opposite(t, g, f)];
    const auto turned = [](Face v) {
        std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
        return v;
    };
    m.faces[at(f)] = turned({p, a, q});
    m.faces[at(g)] = turned({q, b, p});
    std::sort(m.faces.begin(), m.faces.end());
    m.neighbours.clear();
    return m;
}

TEST(ValidateFlips, EveryFlipInGeneralPositionIsInvalid) {
    Random random(4);
    for (int round = 0; round < 3 * effort; ++round) {
        const auto sites = draw(families[round % 2], random, 25);
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        for (Index f = 0; f < static_cast<Index>(t.faces.size()); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_TRUE(invalid(flipped(t, f, k), sites)) << f << " " << k;
    }
}

TEST(ValidateFlips, TheOtherDiagonalOfASquareIsValidAlone) {
    const std::vector<Site> sites = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const TessellationArrays t = triangulate(sites, Power{}).arrays();
    int diagonals = 0;
    for (Index f = 0; f < static_cast<Index>(t.faces.size()); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = t.faces[at(f)][(k + 1) % 3];
            const Index b = t.faces[at(f)][(k + 2) % 3];
            const TessellationArrays m = flipped(t, f, k);
            if (a != infinite && b != infinite && (a + b) % 2 == 0) {
                ++diagonals;
                ASSERT_TRUE(valid_alone(m, sites));
            } else {
                ASSERT_TRUE(invalid(m, sites));
            }
        }
    ASSERT_EQ(diagonals, 2);
}

TEST(ValidateFlips, AnyTriangulationOfACircleIsValid) {
    // Twelve lattice points of one circle: flip at random, always valid, canonical only at home.
    std::vector<Site> sites;
    for (const auto& [x, y] : {std::pair{5, 0},
                               {4, 3},
                               {3, 4},
                               {0, 5},
                               {-3, 4},
                               {-4, 3},
                               {-5, 0},
                               {-4, -3},
                               {-3, -4},
                               {0, -5},
                               {3, -4},
                               {4, -3}})
        sites.push_back({1.0 * x, 1.0 * y, 0.0});
    const TessellationArrays home = triangulate(sites, Power{}).arrays();
    for (Index f = 0; f < static_cast<Index>(home.faces.size()); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Face& v = home.faces[at(f)];
            const Face& w = home.faces[at(home.neighbours[at(f)][k])];
            if (v[0] == infinite || w[0] == infinite) continue;
            ASSERT_TRUE(valid_alone(flipped(home, f, k), sites));
        }
    // A fan from every site.
    for (Index apex = 0; apex < 12; ++apex) {
        TessellationArrays fan = home;
        fan.faces.clear();
        fan.neighbours.clear();
        for (Index i = 0; i < 12; ++i) fan.faces.push_back({infinite, (i + 1) % 12, i});
        for (Index i = 1; i < 11; ++i) {
            Face v = {apex, (apex + i) % 12, (apex + i + 1) % 12};
            std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
            fan.faces.push_back(v);
        }
        std::sort(fan.faces.begin(), fan.faces.end());
        const Validation v = validate(fan, sites);
        ASSERT_TRUE(v.valid) << apex << ": " << v.message;
    }
}

/// All heights 0, so that every triangulation of the sites is regular across each of its edges; one
/// of them twists about its middle, so that a walk towards a hidden site there can go around for
/// ever.
TEST(ValidateWalks, TwistedTieEnds) {
    std::vector<power::Site> sites;
    for (const auto& [x, y] :
         {std::pair{100, 0}, {-50, 87}, {-50, -87}, {10, -2}, {-3, 10}, {-7, -8}})
        sites.push_back({1.0 * x, 1.0 * y, 1.0 * (x * x + y * y)});
    sites.push_back({0, 0, -1});
    for (const bool mirrored : {false, true}) {
        if (mirrored)
            for (auto& s : sites) s.y = -s.y;
        TessellationArrays t;
        t.weight_is = WeightIs::weight;
        t.sites = 7;
        for (Index i = 0; i < 3; ++i) {
            const Index n = (i + 1) % 3;
            t.faces.push_back({infinite, n, i});
            t.faces.push_back({i, n, 3 + i});
            t.faces.push_back({n, 3 + n, 3 + i});
        }
        t.faces.push_back({3, 4, 5});
        if (mirrored)
            for (Face& f : t.faces) std::swap(f[1], f[2]);
        for (std::size_t shift = 0; shift < t.faces.size(); ++shift) {
            std::rotate(t.faces.begin(), t.faces.begin() + 1, t.faces.end());
            for (Index by = 0; by < 6; ++by) {
                t.hidden = {{6, by}};
                const Validation v = validate(t, sites);
                ASSERT_TRUE(v.valid && !v.canonical) << v.message;
            }
        }
        // A site that is not hidden is found out all the same.
        auto lighter = sites;
        lighter[6].w = 1;
        ASSERT_FALSE(validate(t, lighter).valid);
    }
}

TEST(ValidateShapes, WoundTwice) {
    // A pentagon around a centre, wound twice over doubled sites: a double cover.
    std::vector<Site> sites;
    for (int turn = 0; turn < 2; ++turn)
        for (int i = 0; i < 5; ++i)
            sites.push_back(
                {std::cos(1.2566370614359172 * i), std::sin(1.2566370614359172 * i), 0});
    sites.push_back({0, 0, 0});
    TessellationArrays t;
    t.sites = 11;
    for (Index i = 0; i < 10; ++i) {
        t.faces.push_back({10, i, (i + 1) % 10});
        t.faces.push_back({infinite, (i + 1) % 10, i});
    }
    ASSERT_TRUE(invalid(t, sites));
    // A pentagram has convex turns and winds twice.
    std::vector<Site> star(sites.begin(), sites.begin() + 5);
    star.push_back({0, 0, 0});
    TessellationArrays s;
    s.sites = 6;
    for (Index i = 0; i < 5; ++i) {
        s.faces.push_back({5, 2 * i % 5, (2 * i + 2) % 5});
        s.faces.push_back({infinite, (2 * i + 2) % 5, 2 * i % 5});
    }
    ASSERT_TRUE(invalid(s, star));
}

TEST(ValidateShapes, Folded) {
    // The square 0 1 2 3 folded along its diagonal: counterclockwise faces need a fold at a site.
    const std::vector<Site> sites = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1.5, 1, 0}};
    TessellationArrays t;
    t.sites = 5;
    // Vertex 4 outside its own quadrilateral's kernel: faces (0,1,4), (1,2,4), (2,3,4), (3,0,4) are
    // right; joined wrongly they overlap.
    t.faces = {{infinite, 1, 0}, {infinite, 2, 1}, {infinite, 3, 2}, {infinite, 0, 3},
               {0, 1, 4},        {1, 2, 4},        {2, 3, 4},        {3, 0, 4}};
    const Validation v = validate(t, sites);
    ASSERT_TRUE(v.valid) << v.message;
    auto outside = sites;
    outside[4] = {3, 1, 0};
    ASSERT_TRUE(invalid(t, outside));
    auto on_edge = sites;
    on_edge[4] = {2, 1, 0};
    ASSERT_TRUE(invalid(t, on_edge));
}

TEST(ValidateShapes, TwoSpheres) {
    // Two tetrahedra's worth of faces, each closed; Euler's count is off by design or by hiding.
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                     {9, 9, 0}, {8, 9, 0}, {9, 8, 0}};
    TessellationArrays t;
    t.sites = 6;
    for (const Index base : {0, 3}) {
        t.faces.push_back({base, base + 1, base + 2});
        for (Index i = 0; i < 3; ++i) t.faces.push_back({infinite, base + (i + 1) % 3, base + i});
    }
    ASSERT_TRUE(invalid(t, sites));  // 8 faces, 10 are due
    t.faces.push_back({0, 1, 3});
    t.faces.push_back({0, 3, 1});
    ASSERT_TRUE(invalid(t, sites));
}

TEST(ValidateShapes, LinesThatAreNone) {
    std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    const auto path = [](const std::vector<Index>& order, bool closed = false) {
        TessellationArrays t;
        t.sites = 5;
        for (std::size_t i = 0; i + 1 < order.size() + static_cast<std::size_t>(closed); ++i) {
            const Index a = order[i];
            const Index b = order[(i + 1) % order.size()];
            t.faces.push_back({infinite, a, b});
            t.faces.push_back({infinite, b, a});
        }
        return t;
    };
    EXPECT_TRUE(valid_alone(path({0, 1, 2, 3, 4}), sites));
    EXPECT_TRUE(valid_alone(path({4, 3, 2, 1, 0}), sites));
    EXPECT_TRUE(invalid(path({0, 2, 1, 3, 4}), sites));
    EXPECT_TRUE(invalid(path({1, 0, 2, 3, 4}), sites));
    EXPECT_TRUE(invalid(path({0, 1, 2, 3}), sites));
    // A chain and a ring.
    TessellationArrays ring = path({0, 1, 2}, true);
    const TessellationArrays chain = path({3, 4});
    ring.faces.insert(ring.faces.end(), chain.faces.begin(), chain.faces.end());
    EXPECT_TRUE(invalid(ring, sites));
    // A fork.
    TessellationArrays fork = path({0, 1, 2, 3});
    fork.faces.push_back({infinite, 1, 4});
    fork.faces.push_back({infinite, 4, 1});
    EXPECT_TRUE(invalid(fork, sites));
    // A bend.
    sites[2].y = 0.5;
    EXPECT_TRUE(invalid(path({0, 1, 2, 3, 4}), sites));
    // Hidden off the line, beyond it, on it.
    std::vector<Site> some = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 0, 0}, {0.5, 0, 0}};
    TessellationArrays t = path({0, 1, 2});
    t.hidden = {{3, 1}, {4, 0}};
    EXPECT_TRUE(invalid(t, some));
    std::vector<power::Site> weights = {
        {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1.5, 0, -9}, {0.5, 0, -9}};
    t.weight_is = WeightIs::weight;
    EXPECT_TRUE(validate(t, weights).valid) << validate(t, weights).message;
    weights[4].y = 0.1;
    EXPECT_FALSE(validate(t, weights).valid);
    weights[4] = {-1, 0, -9};
    EXPECT_FALSE(validate(t, weights).valid);
    weights[4] = {0, 0, -9};
    EXPECT_TRUE(validate(t, weights).valid) << validate(t, weights).message;
    // Two sites at one place, both visible.
    std::vector<Site> twins = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    EXPECT_TRUE(invalid(path({0, 1, 2, 3, 4}), twins));
}

/// Around the site in the middle the faces on either side of each segment go around alone.
TEST(ValidateShapes, LineWithExchangedNeighbours) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    TessellationArrays t = triangulate(sites, Power{}).arrays();
    ASSERT_EQ(t.faces, (std::vector<Face>{{-1, 0, 1}, {-1, 1, 0}, {-1, 1, 2}, {-1, 2, 1}}));
    ASSERT_EQ(t.neighbours, (std::vector<Face>{{1, 2, 1}, {0, 0, 3}, {3, 3, 0}, {2, 1, 2}}));
    t.neighbours = {{1, 1, 1}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}};
    EXPECT_TRUE(invalid(t, sites));
}

TEST(ValidateShapes, FewSites) {
    const std::vector<Site> none;
    const std::vector<Site> one = {{1, 2, 3}};
    const std::vector<Site> same = {{1, 2, 3}, {1, 2, 3}};
    TessellationArrays t;
    EXPECT_TRUE(canonical(t, none));
    t.sites = 1;
    EXPECT_TRUE(canonical(t, one));
    EXPECT_TRUE(invalid(t, none));
    // One visible site has no face and so no neighbours.
    t.neighbours = {{0, 0, 0}};
    EXPECT_TRUE(invalid(t, one));
    t.neighbours.clear();
    t.hidden = {{0, 0}};
    EXPECT_TRUE(invalid(t, one));
    t.hidden = {};
    t.faces = {{infinite, 0, 0}};
    EXPECT_TRUE(invalid(t, one));
    t = {};
    t.sites = 2;
    EXPECT_TRUE(invalid(t, same));
    t.hidden = {{1, 0}};
    EXPECT_TRUE(canonical(t, same));
    t.hidden = {{0, 1}};
    EXPECT_TRUE(valid_alone(t, same));
    const std::vector<Site> larger_first = {{1, 2, 4}, {1, 2, 3}};
    EXPECT_TRUE(invalid(t, larger_first));
    t.hidden = {{1, 0}};
    EXPECT_TRUE(canonical(t, larger_first));
    t.hidden = {{0, 1}, {1, 0}};
    EXPECT_TRUE(invalid(t, same));
    t.hidden = {};
    t.faces = {{infinite, 0, 1}, {infinite, 1, 0}};
    EXPECT_TRUE(invalid(t, same));
    const std::vector<Site> apart = {{1, 2, 3}, {1, 2.5, 3}};
    t.neighbours = {{1, 1, 1}, {0, 0, 0}};
    EXPECT_TRUE(canonical(t, apart));
    t.faces.clear();
    t.neighbours.clear();
    t.hidden = {{1, 0}};
    EXPECT_TRUE(invalid(t, apart));
}

TEST(ValidateShapes, SitesThatAreNotFinite) {
    TessellationArrays t;
    t.sites = 1;
    EXPECT_THROW((void)validate(t, std::vector<Site>{{NAN, 0, 0}}), std::invalid_argument);
    EXPECT_THROW((void)validate(t, std::vector<Site>{{0, HUGE_VAL, 0}}), std::invalid_argument);
}

// ---- watching ----------------------------------------------------------------------------------

class ValidateWatched : public testing::TestWithParam<Metric> {
 protected:
    std::vector<Site> sites = [] {
        Random random(3);
        std::vector<Site> drawn(20000);
        for (Site& site : drawn) site = {random.real(), random.real(), 0.02 * random.real()};
        return drawn;
    }();
    TessellationArrays arrays = triangulate(sites, GetParam()).arrays();
};

TEST_P(ValidateWatched, SaysHowFarItHasCome) {
    std::vector<double> shares;
    const Validation v =
        validate(arrays, sites, {.progress = [&](double share) { shares.push_back(share); }});
    EXPECT_TRUE(v.canonical) << v.message;
    ASSERT_GT(shares.size(), 5U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.front(), 0.0);
    EXPECT_LT(shares.front(), 0.2);
    EXPECT_GT(shares.back(), 0.8);
    EXPECT_LE(shares.back(), 1.0);
}

TEST_P(ValidateWatched, StopsWhereItIsAskedTo) {
    std::stop_source source;
    int calls = 0;
    const ValidationOptions options = {.stop = source.get_token(), .progress = [&](double) {
                                           if (++calls == 3) source.request_stop();
                                       }};
    EXPECT_THROW((void)validate(arrays, sites, options), Stopped);
    EXPECT_EQ(calls, 3);
}

INSTANTIATE_TEST_SUITE_P(, ValidateWatched, testing::ValuesIn(all_metrics),
                         [](const testing::TestParamInfo<Metric>& info) {
                             return std::string(name_of(info.param));
                         });

// ---- garbage -----------------------------------------------------------------------------------

TEST(ValidateGarbage, RandomArrays) {
    Random random(8);
    for (int trial = 0; trial < 10000; ++trial) {
        const int n = random.below(8);
        std::vector<Site> sites;
        for (int i = 0; i < n; ++i)
            sites.push_back({1.0 * random.below(3), 1.0 * random.below(3), 1.0 * random.below(2)});
        const bool wild = random.below(4) == 0;
        const auto number = [&]() -> Index {
            if (wild && random.below(10) == 0) return static_cast<Index>(random.engine()());
            return random.between(-1, std::max(0, n - 1));
        };
        TessellationArrays t;
        t.sites = random.below(8) == 0 ? number() : n;
        const auto visible = n - random.below(2) * random.below(n + 1);
        const int count = random.below(3) == 0 ? random.below(15) : std::max(0, 2 * visible - 2);
        for (int i = 0; i < count; ++i) {
            Face face = {number(), number(), number()};
            if (random.below(2) == 0) {
                face[0] = infinite;
            }
            t.faces.push_back(face);
            if (random.below(2) == 0) t.faces.push_back({face[1], face[0], face[2]});
            t.neighbours.push_back({number(), number(), number()});
        }
        if (random.below(2) == 0) t.neighbours.clear();
        for (int i = visible; i < n; ++i) t.hidden.push_back({number(), number()});
        const Validation v = validate(t, sites);
        ASSERT_TRUE(v.valid || !v.canonical);
        ASSERT_EQ(v.message.empty(), v.canonical);
    }
}

/// Where nearly everything is tied.
const Family few_places = {
    "few_places", [](Random& g) {
        return Site{1.0 * g.below(4), 1.0 * g.below(3), g.below(8) == 0 ? 1.0 : 0.0};
    }};

/// Hidden sites name another visible one, as near or farther.
TEST(ValidateGarbage, ChangedHiders) {
    Random random(15);
    Verdicts verdicts;
    for (int trial = 0; trial < 300 * effort; ++trial) {
        std::vector<power::Site> sites;
        for (const Site& s : draw(few_places, random, random.between(4, 10)))
            sites.push_back({s.x, s.y, random.below(2) == 0 ? s.r : -9.0});
        const TessellationArrays home = triangulate(sites, Power{}).arrays();
        TessellationArrays t = home;
        if (t.hidden.empty() || t.faces.empty()) continue;
        Hidden& hidden = t.hidden[at(random.below(static_cast<int>(t.hidden.size())))];
        hidden.by = t.faces[at(random.below(static_cast<int>(t.faces.size())))][2];
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(t, sites, home, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 50 * effort);
    EXPECT_GT(verdicts.valid_alone, 5 * effort);
    EXPECT_GT(verdicts.canonical, 20 * effort);
}

/// A few numbers of a valid tessellation changed.
TEST(ValidateGarbage, ChangedNumbers) {
    Random random(9);
    Verdicts verdicts;
    for (int trial = 0; trial < 2500 * effort; ++trial) {
        const Family& family = families[random.below(12)];
        const auto sites = draw(family, random, random.between(2, 12));
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        TessellationArrays m = t;
        if (random.below(2) == 0) m.neighbours.clear();
        for (int changes = random.between(1, 3); changes > 0; --changes) {
            const auto number =
                static_cast<Index>(random.between(-1, static_cast<int>(sites.size()) - 1));
            const int what = random.below(4);
            if (what < 2 && !m.faces.empty())
                m.faces[at(random.below(static_cast<int>(m.faces.size())))][at(random.below(3))] =
                    number;
            if (what == 2 && !m.neighbours.empty())
                m.neighbours[at(random.below(static_cast<int>(m.neighbours.size())))]
                            [at(random.below(3))] = number;
            if (what == 3 && !m.hidden.empty()) {
                Hidden& h = m.hidden[at(random.below(static_cast<int>(m.hidden.size())))];
                (random.below(2) == 0 ? h.site : h.by) = number;
            }
        }
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(m, sites, t, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 1000 * effort);
    EXPECT_GT(verdicts.valid_alone, 100 * effort);
    EXPECT_GT(verdicts.canonical, 100 * effort);
}

/// The faces across the edges, found by their vertices; -1 where there is none.
void connect(TessellationArrays& t) {
    t.neighbours.assign(t.faces.size(), {-1, -1, -1});
    for (std::size_t f = 0; f < t.faces.size(); ++f)
        for (std::size_t g = 0; g < t.faces.size(); ++g)
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t l = 0; l < 3; ++l)
                    if (t.faces[f][(k + 1) % 3] == t.faces[g][(l + 2) % 3] &&
                        t.faces[f][(k + 2) % 3] == t.faces[g][(l + 1) % 3])
                        t.neighbours[f][k] = static_cast<Index>(g);
}

/// Random triangulations of the sphere, every edge glued, over random sites; half of them by flips
/// that go from one valid one to another, as far as ties allow it. The walk ends.
TEST(ValidateGarbage, RandomFlips) {
    Random random(10);
    Verdicts verdicts;
    for (int trial = 0; trial < 1000 * effort; ++trial) {
        const Family& family = random.below(2) == 0 ? few_places : families[random.below(12)];
        const auto sites = draw(family, random, random.between(4, 10));
        TessellationArrays t = triangulate(sites, Power{}).arrays();
        const TessellationArrays home = t;
        if (t.faces.size() < 4) continue;
        const bool keeps_valid = random.below(2) == 0;
        for (int flips = random.between(1, 6) * (keeps_valid ? 4 : 1); flips > 0; --flips) {
            connect(t);
            const auto f = static_cast<Index>(random.below(static_cast<int>(t.faces.size())));
            const auto k = at(random.below(3));
            const Index g = t.neighbours[at(f)][k];
            if (g < 0 || std::find(t.neighbours[at(g)].begin(), t.neighbours[at(g)].end(), f) ==
                             t.neighbours[at(g)].end())
                break;
            TessellationArrays other = flipped(t, f, k);
            if (!keeps_valid || wrong_by_definition(other, sites).empty()) t = std::move(other);
        }
        if (random.below(2) == 0) connect(t);
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(t, sites, home, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 300 * effort);
    EXPECT_GT(verdicts.valid_alone, 20 * effort);
    EXPECT_GT(verdicts.canonical, 10 * effort);
}

/// Sites that are moved, or have another radius, after they were tessellated: faces turn over and
/// overlap, hulls have dents, and hidden ones come to light.
TEST(ValidateGarbage, ChangedSites) {
    Random random(11);
    Verdicts verdicts;
    for (int trial = 0; trial < 1500 * effort; ++trial) {
        const Family& family = random.below(2) == 0 ? few_places : families[random.below(12)];
        auto sites = draw(family, random, random.between(2, 12));
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        for (int changes = random.between(1, 2); changes > 0; --changes) {
            Site& site = sites[at(random.below(static_cast<int>(sites.size())))];
            const Site other = family.draw(random);
            const int what = random.below(4);
            if (what != 1) site.x = other.x;
            if (what != 0) site.y = other.y;
            if (what == 2) site.r = other.r;
        }
        const TessellationArrays home = triangulate(sites, Power{}).arrays();
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(t, sites, home, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 700 * effort);
    EXPECT_GT(verdicts.valid_alone, 2 * effort);
    EXPECT_GT(verdicts.canonical, 50 * effort);
}

TEST(ValidateGarbage, NoMetric) {
    const std::vector<Site> sites = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
    TessellationArrays t = triangulate(StridedSites(sites, true), Power{}).arrays();
    t.metric = static_cast<Metric>(9);
    EXPECT_THROW((void)validate(t, StridedSites(sites, true)), std::invalid_argument);
}

/// On a line two faces have an edge from the same site to infinity. Where they exchange their
/// neighbours there, who agree about it, the faces at infinity are several cycles.
TEST(ValidateGarbage, ExchangedNeighbours) {
    Random random(12);
    Verdicts verdicts;
    for (int trial = 0; trial < 300 * effort; ++trial) {
        const auto sites = draw(families[6 + random.below(2)], random, random.between(3, 8));
        const TessellationArrays home = triangulate(sites, Power{}).arrays();
        TessellationArrays t = home;
        if (t.faces.empty()) continue;
        for (int changes = random.below(3); changes > 0; --changes) {
            const std::size_t f = at(random.below(static_cast<int>(t.faces.size())));
            const std::size_t g = at(random.below(static_cast<int>(t.faces.size())));
            // The edge of a face {-1, u, v} from v to infinity is across from u.
            if (t.faces[f][2] != t.faces[g][2]) continue;
            const std::size_t across_f = at(t.neighbours[f][1]);
            const std::size_t across_g = at(t.neighbours[g][1]);
            std::swap(t.neighbours[f][1], t.neighbours[g][1]);
            if (f != g) std::swap(t.neighbours[across_f][2], t.neighbours[across_g][2]);
        }
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(t, sites, home, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 20 * effort);
    EXPECT_GT(verdicts.canonical, 50 * effort);
}

/// One site more, whose only faces are two at infinity, on the sides of an edge to another site:
/// the numbers agree, and there is a sphere beside the sphere. In half of them the two sites are in
/// one place.
TEST(ValidateGarbage, TwoFacesAlone) {
    Random random(14);
    Verdicts verdicts;
    for (int trial = 0; trial < 500 * effort; ++trial) {
        const Family& family = random.below(2) == 0 ? few_places : families[random.below(12)];
        auto sites = draw(family, random, random.between(3, 8));
        TessellationArrays t = triangulate(sites, Power{}).arrays();
        if (t.faces.empty()) continue;
        const Index end = t.faces[at(random.below(static_cast<int>(t.faces.size())))][2];
        const auto more = static_cast<Index>(sites.size());
        sites.push_back(random.below(2) == 0 ? sites[at(end)] : family.draw(random));
        ++t.sites;
        const auto face = static_cast<Index>(t.faces.size());
        t.faces.push_back({infinite, end, more});
        t.faces.push_back({infinite, more, end});
        t.neighbours.push_back({face + 1, face + 1, face + 1});
        t.neighbours.push_back({face, face, face});
        if (random.below(2) == 0) t.neighbours.clear();
        const TessellationArrays home = triangulate(sites, Power{}).arrays();
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(t, sites, home, verdicts)) << trial;
    }
    EXPECT_GT(verdicts.wrong, 300 * effort);
}

/// All faces twice, over as many sites once more: a cover of the plane that is cut open along a way
/// from a site to infinity, and glued crosswise there. Sites are in the place of their twins, or
/// nearly so.
TEST(ValidateGarbage, TwoLayers) {
    Random random(13);
    Verdicts verdicts;
    for (int trial = 0; trial < 500 * effort; ++trial) {
        const Family& family = random.below(2) == 0 ? few_places : families[random.below(12)];
        auto sites = draw(family, random, random.between(3, 7));
        const TessellationArrays t = triangulate(sites, Power{}).arrays();
        const std::size_t faces = t.faces.size();
        if (faces == 0) continue;
        const auto place_in = [](const Face& v, Index i) {
            return static_cast<std::size_t>(std::find(v.begin(), v.end(), i) - v.begin());
        };
        // A random walk; what it has crossed twice is not cut.
        std::vector<std::array<bool, 3>> is_cut(faces, {false, false, false});
        std::size_t f = at(random.below(static_cast<int>(faces)));
        Index v = t.faces[f][at(random.below(3))];
        if (v == infinite) continue;
        while (v != infinite) {
            for (int turns = random.below(6); turns > 0; --turns)
                f = at(t.neighbours[f][(place_in(t.faces[f], v) + 1) % 3]);
            // Along the edge that begins at v.
            const std::size_t k = (place_in(t.faces[f], v) + 2) % 3;
            const auto g = at(t.neighbours[f][k]);
            const Index next = t.faces[f][(k + 2) % 3];
            const std::size_t back = (place_in(t.faces[g], next) + 2) % 3;
            is_cut[f][k] = !is_cut[f][k];
            is_cut[g][back] = !is_cut[g][back];
            v = next;
        }
        TessellationArrays twice = t;
        twice.faces.insert(twice.faces.end(), t.faces.begin(), t.faces.end());
        twice.neighbours.insert(twice.neighbours.end(), t.neighbours.begin(), t.neighbours.end());
        for (std::size_t c = 0; c < 2 * faces; ++c)
            for (std::size_t k = 0; k < 3; ++k)
                if ((c < faces) == is_cut[c % faces][k])
                    twice.neighbours[c][k] += static_cast<Index>(faces);
        // Faces that hang together around a vertex name one site; those that do not, its twin.
        std::vector<std::array<bool, 3>> is_named(2 * faces, {false, false, false});
        std::vector<bool> is_taken(sites.size(), false);
        const bool is_rounded = random.below(2) == 0;
        for (std::size_t c = 0; c < 2 * faces; ++c)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index was = t.faces[c % faces][k];
                if (was == infinite || is_named[c][k]) continue;
                Index twin = was;
                if (is_taken[at(was)]) {
                    twin = static_cast<Index>(sites.size());
                    Site site = sites[at(was)];
                    if (is_rounded) site.x *= 1.0 + 0x1p-40 * random.real();
                    sites.push_back(site);
                }
                is_taken[at(was)] = true;
                std::size_t d = c;
                std::size_t m = k;
                while (!is_named[d][m]) {
                    is_named[d][m] = true;
                    twice.faces[d][m] = twin;
                    d = at(twice.neighbours[d][(m + 1) % 3]);
                    m = place_in(t.faces[d % faces], was);
                }
            }
        twice.sites = static_cast<std::int64_t>(sites.size());
        const TessellationArrays home = triangulate(sites, Power{}).arrays();
        ASSERT_NO_FATAL_FAILURE(expect_judged_by_definition(twice, sites, home, verdicts)) << trial;
    }
    EXPECT_EQ(verdicts.valid_alone + verdicts.canonical, 0);
    EXPECT_GT(verdicts.wrong, 200 * effort);
}

}  // namespace
}  // namespace signum
