// validate() in the metrics with additive weights: accepts what triangulate() makes, rejects
// mutations of it, tells valid from canonical.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"

namespace {

using namespace signum;
using Sites = std::vector<Site>;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

class Random {
 public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    double real() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
    std::mt19937_64 bits_;
};

constexpr int families = 7;

Sites draw(int family, int n, Random& random) {
    Sites sites(at(n));
    for (Site& s : sites) {
        const double angle = 6.283185307179586 * random.real();
        switch (family) {
            case 0:
                s = {random.real(), random.real(), 0.1 * random.real()};
                break;
            case 1:
                s = {random.real(), random.real(), 0.6 * random.real() - 0.1};
                break;
            case 2:
                s = {1.0 * random.below(9), 1.0 * random.below(9), 1.0 * random.below(3)};
                break;
            case 3:
                s = {std::cos(angle), std::sin(angle), 0.01 * random.real()};
                break;
            case 4:
                s = {3.0 * random.below(40), -1.0 * random.below(2), 0};
                break;
            case 5:
                s = {5, 1.0 * random.below(40), 1.0 * random.below(4)};
                break;
            default:
                s = {std::ldexp(random.real(), random.below(200) - 100),
                     std::ldexp(random.real(), random.below(200) - 100), 0};
        }
    }
    return sites;
}

enum class Expected { canonical, valid_alone, invalid };

void expect(Expected expected, const TessellationArrays& t, const Sites& sites) {
    const Validation v = validate(t, sites);
    ASSERT_EQ(v.valid, expected != Expected::invalid) << v.message;
    ASSERT_EQ(v.canonical, expected == Expected::canonical) << v.message;
    ASSERT_EQ(v.message.empty(), expected == Expected::canonical);
}

template <class Metric>
class ValidateAdditive : public testing::Test {
 public:
    Random random{5};
    static TessellationArrays build(const Sites& sites) {
        return triangulate(sites, Metric{}).arrays();
    }
};
using Metrics = testing::Types<Euclidean, Manhattan, Supremum>;
TYPED_TEST_SUITE(ValidateAdditive, Metrics);

TYPED_TEST(ValidateAdditive, AcceptsEveryResult) {
    for (int family = 0; family < families; ++family)
        for (const int n : {0, 1, 2, 3, 4, 5, 6, 8, 12, 20, 40, 300}) {
            const Sites sites = draw(family, n, this->random);
            ASSERT_NO_FATAL_FAILURE(expect(Expected::canonical, this->build(sites), sites))
                << "family " << family << ", " << n << " sites";
        }
}

/// Large sites between which many edges join the same two.
TYPED_TEST(ValidateAdditive, AcceptsHeavilyOverlappingSites) {
    for (int round = 0; round < 150; ++round) {
        const Sites sites = draw(round % 3, 30, this->random);
        ASSERT_NO_FATAL_FAILURE(expect(Expected::canonical, this->build(sites), sites)) << round;
    }
}

TYPED_TEST(ValidateAdditive, AnotherNumberingIsValidAlone) {
    for (int round = 0; round < 60; ++round) {
        const Sites sites = draw(round % families, 3 + this->random.below(20), this->random);
        const TessellationArrays t = this->build(sites);
        if (t.faces.size() < 3) continue;
        TessellationArrays m = t;
        const std::size_t f = at(this->random.below(static_cast<int>(t.faces.size())));
        std::rotate(m.faces[f].begin(), m.faces[f].begin() + 1, m.faces[f].end());
        std::rotate(m.neighbours[f].begin(), m.neighbours[f].begin() + 1, m.neighbours[f].end());
        ASSERT_NO_FATAL_FAILURE(expect(Expected::valid_alone, m, sites));
        m = t;
        std::reverse(m.faces.begin(), m.faces.end());
        std::reverse(m.neighbours.begin(), m.neighbours.end());
        for (Face& neighbours : m.neighbours)
            for (Index& g : neighbours) g = static_cast<Index>(t.faces.size()) - 1 - g;
        ASSERT_NO_FATAL_FAILURE(expect(Expected::valid_alone, m, sites));
    }
}

/// Where no two sites share several edges the neighbours may be missing; otherwise that is said.
TYPED_TEST(ValidateAdditive, MissingNeighboursAreFoundWhereTheyAreUnique) {
    int unique = 0;
    int several = 0;
    for (int round = 0; round < 60; ++round) {
        const Sites sites = draw(round % 2, 4 + this->random.below(20), this->random);
        const Tessellation tessellation = triangulate(sites, TypeParam{});
        const std::vector<Edge> edges = tessellation.edges();
        const bool is_unique = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
        TessellationArrays m = tessellation.arrays();
        if (m.faces.empty()) continue;
        m.neighbours.clear();
        ++(is_unique ? unique : several);
        ASSERT_NO_FATAL_FAILURE(
            expect(is_unique ? Expected::valid_alone : Expected::invalid, m, sites));
    }
    EXPECT_GT(unique, 5);
    EXPECT_GT(several, 5);
}

TYPED_TEST(ValidateAdditive, RejectsMutations) {
    for (int round = 0; round < 150; ++round) {
        const Sites sites = draw(round % families, 3 + this->random.below(25), this->random);
        const TessellationArrays t = this->build(sites);
        if (t.faces.size() < 4) continue;
        const auto count = static_cast<int>(t.faces.size());
        const std::size_t f = at(this->random.below(count));
        const std::size_t g = at(this->random.below(count));
        const std::size_t k = at(this->random.below(3));
        const auto n = static_cast<Index>(sites.size());
        std::vector<TessellationArrays> wrong;
        const auto mutate = [&](auto change) {
            wrong.push_back(t);
            change(wrong.back());
        };
        mutate([&](auto& m) { m.faces.pop_back(); });
        mutate([&](auto& m) { m.faces.push_back(m.faces[f]); });
        mutate([&](auto& m) { std::swap(m.faces[f][k], m.faces[f][(k + 1) % 3]); });
        // Where every triple occurs in both orientations the mirror image is the same.
        std::vector<Face> mirrored = t.faces;
        for (Face& face : mirrored) std::swap(face[1], face[2]);
        std::sort(mirrored.begin(), mirrored.end());
        if (mirrored != t.faces)
            mutate([&](auto& m) {
                for (Face& face : m.faces) std::swap(face[1], face[2]);
                for (Face& face : m.neighbours) std::swap(face[1], face[2]);
            });
        if (f != g) mutate([&](auto& m) { m.faces[f] = m.faces[g]; });
        for (const Index number : {-2, n, std::numeric_limits<Index>::max()}) {
            mutate([&](auto& m) { m.faces[f][k] = number; });
            mutate([&](auto& m) { m.neighbours[f][k] = number < n ? number : count; });
            mutate([&](auto& m) { m.hidden.push_back({number, 0}); });
        }
        mutate([&](auto& m) { m.neighbours[f][k] = m.neighbours[f][k] == 0 ? 1 : 0; });
        mutate([&](auto& m) { m.neighbours.pop_back(); });
        mutate([&](auto& m) { m.hidden.push_back({t.faces[f][2], t.faces[f][1]}); });
        mutate([&](auto& m) { m.sites += 1; });
        mutate([&](auto& m) { m.weight_is = WeightIs::weight; });
        if (!t.hidden.empty()) {
            mutate([&](auto& m) { m.hidden.pop_back(); });
            mutate([&](auto& m) { m.hidden.push_back(m.hidden.front()); });
            mutate([&](auto& m) { m.hidden.front().by = m.hidden.front().site; });
        }
        for (std::size_t m = 0; m < wrong.size(); ++m)
            ASSERT_NO_FATAL_FAILURE(expect(Expected::invalid, wrong[m], sites))
                << "mutation " << m << " in round " << round;
    }
}

/// The edge of face f opposite its vertex k turned to join the two vertices across, neighbours
/// following; nothing where the two faces share another edge or those vertices are one.
bool flip(TessellationArrays& t, std::size_t f, std::size_t k) {
    const std::size_t g = at(t.neighbours[f][k]);
    std::size_t m = 0;
    while (at(t.neighbours[g][m]) != f || t.faces[g][(m + 1) % 3] != t.faces[f][(k + 2) % 3]) ++m;
    const Index p = t.faces[f][k];
    const Index q = t.faces[g][m];
    if (p == q || f == g) return false;
    // f = (p, a, b) and g = (q, b, a) become (p, a, q) and (q, b, p).
    const Index a = t.faces[f][(k + 1) % 3];
    const Index b = t.faces[f][(k + 2) % 3];
    const Index across_bp = t.neighbours[f][(k + 1) % 3];
    const Index across_pa = t.neighbours[f][(k + 2) % 3];
    const Index across_aq = t.neighbours[g][(m + 1) % 3];
    const Index across_qb = t.neighbours[g][(m + 2) % 3];
    const auto fi = static_cast<Index>(f);
    const auto gi = static_cast<Index>(g);
    for (const Index other : {across_bp, across_pa, across_aq, across_qb})
        if (other == fi || other == gi) return false;
    if (across_bp == across_aq || across_bp == across_qb || across_pa == across_aq ||
        across_bp == across_pa || across_aq == across_qb || across_pa == across_qb)
        return false;
    t.faces[f] = {p, a, q};
    t.neighbours[f] = {across_aq, gi, across_pa};
    t.faces[g] = {q, b, p};
    t.neighbours[g] = {across_bp, fi, across_qb};
    std::replace(t.neighbours[at(across_bp)].begin(), t.neighbours[at(across_bp)].end(), fi, gi);
    std::replace(t.neighbours[at(across_aq)].begin(), t.neighbours[at(across_aq)].end(), gi, fi);
    return true;
}

TYPED_TEST(ValidateAdditive, EveryFlipInGeneralPositionIsInvalid) {
    int flips = 0;
    for (int round = 0; round < 8; ++round) {
        const Sites sites = draw(round % 2, 12, this->random);
        const TessellationArrays t = this->build(sites);
        for (std::size_t f = 0; f < t.faces.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                TessellationArrays m = t;
                if (!flip(m, f, k)) continue;
                ++flips;
                ASSERT_NO_FATAL_FAILURE(expect(Expected::invalid, m, sites)) << f << " " << k;
            }
    }
    EXPECT_GT(flips, 100);
}

/// Edges between the same two sites glued crosswise.
TYPED_TEST(ValidateAdditive, CrossedEdgesBetweenTheSameSitesAreInvalid) {
    int crossed = 0;
    for (int round = 0; round < 300 && crossed < 60; ++round) {
        const Sites sites = draw(1, 8, this->random);
        const TessellationArrays t = this->build(sites);
        for (std::size_t f = 0; f < t.faces.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t f2 = 0; f2 < f; ++f2)
                    for (std::size_t k2 = 0; k2 < 3; ++k2) {
                        if (t.faces[f][(k + 1) % 3] != t.faces[f2][(k2 + 1) % 3] ||
                            t.faces[f][(k + 2) % 3] != t.faces[f2][(k2 + 2) % 3])
                            continue;
                        TessellationArrays m = t;
                        const Index g = t.neighbours[f][k];
                        const Index g2 = t.neighbours[f2][k2];
                        const auto toward = [&](Index from, std::size_t to) -> Index& {
                            auto& list = m.neighbours[at(from)];
                            return *std::find(list.begin(), list.end(), static_cast<Index>(to));
                        };
                        toward(g, f) = static_cast<Index>(f2);
                        toward(g2, f2) = static_cast<Index>(f);
                        std::swap(m.neighbours[f][k], m.neighbours[f2][k2]);
                        ++crossed;
                        ASSERT_NO_FATAL_FAILURE(expect(Expected::invalid, m, sites));
                    }
    }
    EXPECT_GE(crossed, 60);
}

/// Four equal sites at the corners of a tilted square, which one circle touches in every metric.
TYPED_TEST(ValidateAdditive, TheOtherDiagonalIsValidAlone) {
    const double c = std::is_same_v<TypeParam, Manhattan> ? 1 : 2;
    const Sites sites = std::is_same_v<TypeParam, Manhattan>
                            ? Sites{{0, 0, 0.25}, {4, 0, 0.25}, {4, 4, 0.25}, {0, 4, 0.25}}
                            : Sites{{c, 0, 0.25}, {4, c, 0.25}, {c, 4, 0.25}, {0, c, 0.25}};
    const TessellationArrays t = this->build(sites);
    int diagonals = 0;
    for (std::size_t f = 0; f < t.faces.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = t.faces[f][(k + 1) % 3];
            const Index b = t.faces[f][(k + 2) % 3];
            if (a == infinite || b == infinite || (a + b) % 2 != 0) continue;
            TessellationArrays m = t;
            ASSERT_TRUE(flip(m, f, k));
            ++diagonals;
            ASSERT_NO_FATAL_FAILURE(expect(Expected::valid_alone, m, sites));
        }
    EXPECT_EQ(diagonals, 2);
}

TYPED_TEST(ValidateAdditive, SaysWhichMetricHasNoWeights) {
    const std::vector<power::Site> sites = {{0, 0, 1}, {1, 0, 1}};
    TessellationArrays t = triangulate(Sites{{0, 0, 1}, {1, 0, 1}}, TypeParam{}).arrays();
    t.weight_is = WeightIs::weight;
    const Validation v = validate(t, sites);
    EXPECT_FALSE(v.valid);
    EXPECT_NE(v.message.find("radii"), std::string::npos) << v.message;
}

}  // namespace
