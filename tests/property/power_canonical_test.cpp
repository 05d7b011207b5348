// The power tessellation equals the oracle's, faces and hidden sites, whatever the insertion order.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>
#include "../oracle/power.hpp"

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

const int share = is_fast ? 1 : 5;  // of the trials one in so many

oracle::Tessellation plain(const Tessellation& t) {
    oracle::Tessellation result;
    result.faces.assign(t.faces().begin(), t.faces().end());
    for (const Hidden& h : t.hidden()) result.hidden.push_back({h.site, h.by});
    return result;
}

std::string describe(const std::vector<Site>& sites) {
    std::string text;
    for (const Site& s : sites)
        text += "{" + std::to_string(s.x) + "," + std::to_string(s.y) + "," + std::to_string(s.r) +
                "}, ";
    return text;
}

/// Families of small sets that are meant to break a triangulation.
struct Family {
    const char* name;
    Site (*draw)(std::mt19937_64&);
};

int roll(std::mt19937_64& random, int below) {
    return static_cast<int>(random() % static_cast<std::uint64_t>(below));
}
double real(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

const Family families[] = {
    {"random",
     [](auto& g) {
         return Site{real(g), real(g), 0.3 * real(g)};
     }},
    {"tiny grid",
     [](auto& g) {
         return Site{1.0 * roll(g, 3), 1.0 * roll(g, 3), 0.0};
     }},
    {"tiny grid, radii",
     [](auto& g) {
         return Site{1.0 * roll(g, 4), 1.0 * roll(g, 4), 1.0 * roll(g, 3)};
     }},
    {"cocircular",
     [](auto& g) {
         static constexpr int points[12][2] = {{5, 0},   {4, 3},  {3, 4},  {0, 5},
                                               {-3, 4},  {-4, 3}, {-5, 0}, {-4, -3},
                                               {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
         const auto& p = points[roll(g, 12)];
         return Site{1.0 * p[0], 1.0 * p[1], 1.0};
     }},
    {"collinear",
     [](auto& g) {
         const double t = roll(g, 6);
         return Site{2 * t, t, 0.5 * roll(g, 6)};
     }},
    {"nearly collinear",
     [](auto& g) {
         const double t = roll(g, 6);
         return Site{0.1 * t, 0.3 * t, 0.1 * roll(g, 3)};
     }},
    {"nested",
     [](auto& g) {
         return Site{0.25 * roll(g, 3), 0.25 * roll(g, 3), std::ldexp(1.0, -roll(g, 4))};
     }},
    {"duplicates",
     [](auto& g) {
         return Site{1.0 * roll(g, 2), 1.0 * roll(g, 2), 1.0 * roll(g, 2)};
     }},
    {"negative radii",
     [](auto& g) {
         return Site{1.0 * roll(g, 3), 1.0 * roll(g, 3), 1.0 * roll(g, 5) - 2.0};
     }},
    {"mixed scales",
     [](auto& g) {
         return Site{std::ldexp(1.0 * roll(g, 3), roll(g, 3) * 40 - 40),
                     std::ldexp(1.0 * roll(g, 3), roll(g, 3) * 40 - 40), 0.5 * roll(g, 3)};
     }},
    {"huge",
     [](auto& g) {
         return Site{(roll(g, 5) - 2) * 0x1.ffffffffffffp1021, (roll(g, 5) - 2) * 0x1p1021,
                     roll(g, 2) * 0x1p1000};
     }},
    {"denormal",
     [](auto& g) {
         return Site{roll(g, 4) * 0x1p-1074, roll(g, 4) * 0x1p-1074, roll(g, 3) * 0x1p-1074};
     }},
    {"huge beside denormal",
     [](auto& g) {
         const auto pick = [&] {
             static constexpr double values[] = {0.0, 0x1p-1074, 1.0, 0x1p1023, -0x1p1023};
             return values[roll(g, 5)];
         };
         return Site{pick(), pick(), pick()};
     }},
};

class PowerCanonical : public testing::TestWithParam<Family> {};

TEST_P(PowerCanonical, EqualsTheOracleInEveryOrderTried) {
    std::mt19937_64 random(7);
    for (int round = 0; round < 250 / share; ++round) {
        std::vector<Site> sites(1 + static_cast<std::size_t>(roll(random, 12)));
        for (Site& site : sites) site = GetParam().draw(random);
        const oracle::Tessellation expected = oracle::power(sites);
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            Options options;
            options.seed = seed;
            const Tessellation t = triangulate(sites, Power{}, options);
            ASSERT_EQ(plain(t), expected) << GetParam().name << ": " << describe(sites);
            if (seed == 0) {
                const Validation v = validate(t.arrays(), sites);
                ASSERT_TRUE(v.valid && v.canonical) << v.message << ": " << describe(sites);
            }
        }
    }
}

TEST_P(PowerCanonical, WeightsGiveTheSameAsRadii) {
    std::mt19937_64 random(8);
    for (int round = 0; round < 100 / share; ++round) {
        std::vector<power::Site> sites(1 + static_cast<std::size_t>(roll(random, 10)));
        for (power::Site& site : sites) {
            const Site s = GetParam().draw(random);
            site = {s.x, s.y, s.r - 0.5};
        }
        ASSERT_EQ(plain(triangulate(sites, Power{})), oracle::power_weights(sites))
            << GetParam().name;
    }
}

TEST_P(PowerCanonical, MultiprecisionKernelAgrees) {
    std::mt19937_64 random(9);
    for (int round = 0; round < 50 / share; ++round) {
        std::vector<Site> sites(1 + static_cast<std::size_t>(roll(random, 30)));
        for (Site& site : sites) site = GetParam().draw(random);
        Options options;
        options.arithmetic = Arithmetic::multiprecision;
        ASSERT_EQ(triangulate(sites, Power{}).arrays(),
                  triangulate(sites, Power{}, options).arrays())
            << GetParam().name << ": " << describe(sites);
    }
}

/// Of a result of rounded signs: that it is one. Faces have three sites and are glued in pairs
/// along their edges, each site is in a face or hidden, and the sphere has two faces for each of
/// its vertices but two.
void expect_structure(const Tessellation& t, std::size_t sites) {
    const std::span<const Face> faces = t.faces();
    const auto n = static_cast<Index>(sites);
    std::vector<int> times(sites, 0);
    bool has_infinity = false;
    std::multiset<std::pair<Index, Index>> edges;
    for (const Face& face : faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_GE(face[k], infinite);
            ASSERT_LT(face[k], n);
            ASSERT_NE(face[k], face[(k + 1) % 3]);
            if (face[k] == infinite)
                has_infinity = true;
            else
                times[static_cast<std::size_t>(face[k])] = 1;
            edges.insert({face[k], face[(k + 1) % 3]});
        }
    }
    for (const auto& [from, to] : edges)
        EXPECT_EQ(edges.count({from, to}), edges.count({to, from}));
    const auto visible = std::ranges::count(times, 1);
    for (const auto& [site, by] : t.hidden()) {
        ASSERT_TRUE(site >= 0 && site < n && by >= 0 && by < n);
        ++times[static_cast<std::size_t>(site)];
    }
    if (!faces.empty() && has_infinity && visible >= 3) {
        EXPECT_EQ(std::ssize(faces), 2 * (visible + 1) - 4);
        for (const int each : times) EXPECT_EQ(each, 1);
    }
}

/// Less than 30 are made. A walk in circles is given up after as many steps as there are faces, 2 n
/// of two calls each, and n is 60 at most here.
constexpr std::uint64_t most_calls_a_site = 300;

TEST_P(PowerCanonical, NaiveKernelEndsWithAResultOrAClearWord) {
    std::mt19937_64 random(10);
    int results = 0;
    const int rounds = 300 / share;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Site> sites(1 + static_cast<std::size_t>(roll(random, 60)));
        for (Site& site : sites) site = GetParam().draw(random);
        Options options;
        options.arithmetic = Arithmetic::naive;
        options.count = true;
        try {
            const Tessellation t = triangulate(sites, Power{}, options);
            ++results;
            SCOPED_TRACE(describe(sites));
            expect_structure(t, sites.size());
            // A walk astray is given up: it ends by what it has asked, not by the patience of
            // whoever runs the test.
            const Statistics& s = t.statistics();
            EXPECT_LE(s.ccw + s.in_circle + s.nearer, most_calls_a_site * sites.size());
        } catch (const BrokenStructure& broken) {
            EXPECT_STRNE(broken.what(), "");
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(results, rounds / 2);
}

INSTANTIATE_TEST_SUITE_P(Families, PowerCanonical, testing::ValuesIn(families),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::erase_if(name, [](char c) { return c == ',' || c == ' '; });
                             return name;
                         });

TEST(PowerPermutations, EveryOrderOfAFewSitesGivesTheSame) {
    std::mt19937_64 random(11);
    const std::size_t count = is_fast ? 6 : 5;
    for (const Family& family : families) {
        std::vector<Site> sites(count);
        for (Site& site : sites) site = family.draw(random);
        std::vector<std::size_t> order(sites.size());
        std::iota(order.begin(), order.end(), 0U);
        do {
            std::vector<Site> permuted;
            for (const std::size_t i : order) permuted.push_back(sites[i]);
            ASSERT_EQ(plain(triangulate(permuted, Power{})), oracle::power(permuted))
                << family.name << ": " << describe(permuted);
        } while (std::next_permutation(order.begin(), order.end()));
    }
}

/// The faces under a renaming of the sites, in canonical form again.
TessellationArrays renamed(const Tessellation& t, const std::vector<Index>& names) {
    TessellationArrays result = t.arrays();
    result.neighbours.clear();
    for (Face& face : result.faces) {
        for (Index& v : face)
            if (v != infinite) v = names[static_cast<std::size_t>(v)];
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    }
    std::sort(result.faces.begin(), result.faces.end());
    for (Hidden& h : result.hidden)
        h = {names[static_cast<std::size_t>(h.site)], names[static_cast<std::size_t>(h.by)]};
    std::sort(result.hidden.begin(), result.hidden.end(),
              [](const Hidden& a, const Hidden& b) { return a.site < b.site; });
    return result;
}

TEST(PowerPermutations, LargerSetsGiveTheSameInEveryPermutationTried) {
    std::mt19937_64 random(12);
    const auto distinct = [&](Site (*draw)(std::mt19937_64&), std::size_t n) {
        std::vector<Site> sites;
        for (std::size_t i = 0; i < n; ++i) sites.push_back(draw(random));
        std::sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) {
            return std::tie(a.x, a.y, a.r) < std::tie(b.x, b.y, b.r);
        });
        sites.erase(std::unique(sites.begin(), sites.end()), sites.end());
        return sites;
    };
    Site (*const draws[])(std::mt19937_64&) = {
        [](auto& g) {
            return Site{real(g), real(g), 0.05 * real(g)};
        },
        [](auto& g) {
            return Site{1.0 * roll(g, 40), 1.0 * roll(g, 40), 0.0};
        },
        [](auto& g) {
            return Site{1.0 * roll(g, 40), 1.0 * roll(g, 40), 1.0 * roll(g, 3)};
        },
        [](auto& g) {
            const double a = 6.283185307179586 * roll(g, 1000) / 1000;
            return Site{std::cos(a), std::sin(a), 1.0};
        },
        [](auto& g) {
            return Site{1.0 * roll(g, 4000), 0.0, 1.0 * roll(g, 50)};
        },
    };
    for (const auto draw : draws) {
        const std::vector<Site> sites = distinct(draw, 2000);
        std::vector<Index> same(sites.size());
        std::iota(same.begin(), same.end(), 0);
        const TessellationArrays expected = renamed(triangulate(sites, Power{}), same);
        for (int trial = 0; trial < 10; ++trial) {
            std::vector<Index> order = same;
            std::shuffle(order.begin(), order.end(), random);
            std::vector<Site> permuted;
            for (const Index i : order) permuted.push_back(sites[static_cast<std::size_t>(i)]);
            Options options;
            options.seed = random();
            ASSERT_EQ(renamed(triangulate(permuted, Power{}, options), order), expected);
        }
    }
}

}  // namespace
}  // namespace signum
