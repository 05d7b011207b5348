// Sites come, go and change, in any order: at every moment the tessellation is the one that the
// sites make when they are built anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/triangulate.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

class Dynamic : public testing::TestWithParam<Metric> {
 protected:
    std::mt19937_64 random_{41};
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }

    void expect_canonical(const DynamicTessellation& dynamic,
                          const std::map<Index, Site>& expected) {
        std::vector<Site> sites;
        for (const auto& [handle, site] : expected) {
            ASSERT_TRUE(dynamic.contains(handle));
            ASSERT_EQ(dynamic.site(handle), site);
            sites.push_back(site);
        }
        ASSERT_EQ(dynamic.size(), sites.size());
        const Tessellation now = dynamic.tessellation();
        ASSERT_TRUE(now.arrays() == triangulate(sites, GetParam()).arrays()) << text(sites);
        ASSERT_TRUE(std::ranges::equal(now.sites(), sites));
    }
    static std::string text(const std::vector<Site>& sites) {
        std::string result;
        for (const Site& s : sites)
            result += "{" + std::to_string(s.x) + ", " + std::to_string(s.y) + ", " +
                      std::to_string(s.r) + "}, ";
        return result;
    }

    /// Random insertions, deletions and changes with about `size` sites alive, and a comparison
    /// every so often.
    template <class MakeSite>
    void run(int size, int steps, int every, const MakeSite& make_site) {
        DynamicTessellation dynamic(GetParam());
        std::map<Index, Site> sites;
        for (int step = 0; step < steps; ++step) {
            const int kind = below(3);
            if (sites.empty() || (static_cast<int>(sites.size()) < size && kind != 2) ||
                kind == 0) {
                const Site site = make_site();
                const Index handle = dynamic.insert(site);
                ASSERT_TRUE(sites.emplace(handle, site).second);
            } else {
                const auto any = std::next(sites.begin(), below(static_cast<int>(sites.size())));
                if (kind == 1 || static_cast<int>(sites.size()) > size) {
                    dynamic.erase(any->first);
                    ASSERT_FALSE(dynamic.contains(any->first));
                    sites.erase(any);
                } else {
                    any->second.r = make_site().r;
                    dynamic.change(any->first, any->second.r);
                }
            }
            if (step % every == 0) {
                ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << "step " << step;
            }
        }
    }
};

TEST_P(Dynamic, OfFewSitesAtEveryStep) {
    for (const double radius : {0.0, 0.2, 1.0})
        ASSERT_NO_FATAL_FAILURE(run(9, 250 * thoroughness, 1, [&] {
            return Site{real(), real(), radius * real()};
        }));
}

/// Ties of all kinds, equal sites, all on one line.
TEST_P(Dynamic, OfIntegersAtEveryStep) {
    for (const int extent : {2, 4, 8})
        for (const int radii : {1, 4})
            ASSERT_NO_FATAL_FAILURE(run(14, 150 * thoroughness, 1, [&] {
                return Site{1.0 * below(extent), 1.0 * below(extent), 1.0 * below(radii)};
            }));
    ASSERT_NO_FATAL_FAILURE(run(10, 150 * thoroughness, 1, [&] {
        const double t = below(12);
        return Site{t, 2 * t, below(3) / 2.0};
    }));
}

TEST_P(Dynamic, OfDegenerateFamilies) {
    for (int family = 0; family < brute_force::Degenerate::families; ++family) {
        std::vector<Site> sites(40);
        brute_force::Degenerate(random_()).fill(family, sites.data(), sites.size());
        ASSERT_NO_FATAL_FAILURE(
            run(12, 60 * thoroughness, 1, [&] { return sites[random_() % sites.size()]; }));
    }
}

TEST_P(Dynamic, OfManySites) {
    const int count = 250 * thoroughness;
    for (const double radius : {0.5, 30.0})
        ASSERT_NO_FATAL_FAILURE(run(count, 5 * count, count, [&] {
            return Site{real(), real(), radius / std::sqrt(1.0 * count) * real()};
        }));
}

/// Every site of a set is deleted in turn, hull and hiders included, and comes back.
TEST_P(Dynamic, EverySiteInTurn) {
    for (int round = 0; round < 6 * thoroughness; ++round) {
        DynamicTessellation dynamic(GetParam());
        std::map<Index, Site> sites;
        const double largest = std::pow(10.0, -2 * real());
        for (int i = 0; i < 12; ++i) {
            const Site site = {real(), real(), largest * real()};
            sites.emplace(dynamic.insert(site), site);
        }
        for (Index handle = 0; handle < 12; ++handle) {
            const Site site = sites.at(handle);
            dynamic.erase(handle);
            sites.erase(handle);
            ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
            ASSERT_EQ(dynamic.insert(site), handle);
            sites.emplace(handle, site);
            ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
        }
    }
}

/// One site that hides all others, and goes again.
TEST_P(Dynamic, TheGiant) {
    DynamicTessellation dynamic(GetParam());
    std::map<Index, Site> sites;
    for (int i = 0; i < 20; ++i) {
        const Site site = {real(), real(), 0.1 * real()};
        sites.emplace(dynamic.insert(site), site);
    }
    for (const double radius : {100.0, 0.01, 100.0}) {
        const Site giant = {0.5, 0.5, radius};
        const Index handle = dynamic.insert(giant);
        sites.emplace(handle, giant);
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
        dynamic.change(handle, 0.2);
        sites.at(handle).r = 0.2;
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
        dynamic.erase(handle);
        sites.erase(handle);
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
    }
}

/// A hub amid a rim of many neighbours, with many sites hidden between: it goes, comes, moves and
/// shrinks, and so many gaps are closed and so many sites put in again that their order matters.
TEST_P(Dynamic, AHubInARim) {
    for (int kind = 0; kind < 3; ++kind) {
        SCOPED_TRACE(kind);
        DynamicTessellation dynamic(GetParam());
        std::map<Index, Site> sites;
        const auto add = [&](const Site& site) { sites.emplace(dynamic.insert(site), site); };
        const int rim = 120;
        for (int i = 0; i < rim; ++i) {
            const double angle = 2.0 * std::acos(-1.0) * i / rim;
            const double along = i % (rim / 4) / (rim / 8.0) - 1.0;
            const Site sides[] = {
                {along, -1.0, 0.0}, {1.0, along, 0.0}, {-along, 1.0, 0.0}, {-1.0, -along, 0.0}};
            if (kind == 0)
                add({std::cos(angle), std::sin(angle), 0.0});
            else if (kind == 1)
                add({std::cos(angle), std::sin(angle), 0.02 * real()});
            else
                add(sides[i / (rim / 4)]);
        }
        const Site hub = {0.03125, 0.0625, 0.6};
        const Index handle = dynamic.insert(hub);
        sites.emplace(handle, hub);
        for (int i = 0; i < 100; ++i)
            add({0.7 * real() - 0.35, 0.7 * real() - 0.35, 0.001 * below(3)});
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
        Site& it = sites.at(handle);
        for (int step = 0; step < 3; ++step) {
            it.x = 0.1 * real();
            it.y = 0.1 * real();
            dynamic.move(handle, {it.x, it.y});
            ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << "step " << step;
            it.r = step == 1 ? 0.001 : 0.6 + 0.05 * step;
            dynamic.change(handle, it.r);
            ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << "step " << step;
        }
        dynamic.erase(handle);
        sites.erase(handle);
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
    }
}

/// A hub with so many neighbours that hiders are looked for in boxes of sites: those that have gone
/// are in none, however near they would be.
TEST_P(Dynamic, TheGoneHideNothing) {
    DynamicTessellation dynamic(GetParam());
    std::map<Index, Site> sites;
    const auto in_square = [&](double half) { return half * (2.0 * real() - 1.0); };
    const auto add = [&](const Site& site) {
        const Index handle = dynamic.insert(site);
        sites.emplace(handle, site);
        return handle;
    };
    std::vector<Index> going;
    for (int i = 0; i < 20; ++i) going.push_back(add({in_square(0.3), in_square(0.3), 9.05}));
    for (int i = 0; i < 1000; ++i) {
        const double angle = 6.28 * real();
        add({10.0 * std::cos(angle), 10.0 * std::sin(angle), 1e-4 * real()});
    }
    add({0.0, 0.0, 9.0});
    for (int i = 0; i < 100; ++i) add({in_square(8.0), in_square(8.0), 0.001});
    for (const Index handle : going) {
        dynamic.erase(handle);
        sites.erase(handle);
    }
    expect_canonical(dynamic, sites);
}

TEST_P(Dynamic, StructureIsChangedAndNotBuiltAnew) {
    DynamicTessellation dynamic(GetParam());
    std::vector<Index> handles;
    for (int i = 0; i < 1000; ++i)
        handles.push_back(dynamic.insert({real(), real(), 0.02 * real()}));
    const std::size_t before = dynamic.rebuilds();
    for (int i = 0; i < 500; ++i) {
        dynamic.erase(handles[static_cast<std::size_t>(i)]);
        dynamic.change(handles[static_cast<std::size_t>(500 + i)], 0.02 * real());
    }
    EXPECT_EQ(dynamic.rebuilds(), before);
}

/// Sets in which hardly a site is visible, or all are on one line: there is no structure to change,
/// and yet nothing is built anew. What is counted is insertions, of hidden sites looked at again
/// too.
TEST_P(Dynamic, NorWhereThereIsNoStructure) {
    const int count = 1250 * thoroughness;
    using Make = std::function<Site(int)>;
    struct Family {
        std::string name;
        Make make;
    };
    const std::vector<Family> families = {
        {"identical",
         [](int) {
             return Site{1, 2, 3};
         }},
        {"concentric, growing",
         [](int i) {
             return Site{1, 2, 1.0 + i};
         }},
        {"concentric, shrinking",
         [&](int i) {
             return Site{1, 2, 1.0 * count - i};
         }},
        {"collinear",
         [](int i) {
             return Site{1.0 * i, 2.0 * i, 0};
         }},
        {"collinear in no order, with weights",
         [&](int) {
             const double t = below(1 << 20);
             return Site{t, 2 * t, 1000 * real()};
         }},
        {"collinear, most of them hidden",
         [&](int) {
             const double t = below(1 << 20);
             return Site{t, 2 * t, 0x1p20 * real()};
         }},
        {"within one", [&](int i) {
             return i == 0 ? Site{0.5, 0.5, 10} : Site{real(), real(), 0.01 * real()};
         }}};
    for (const auto& family : families) {
        const auto& name = family.name;
        DynamicTessellation dynamic(GetParam());
        std::map<Index, Site> sites;
        const auto insert = [&](int i) {
            const Site site = family.make(i);
            sites.emplace(dynamic.insert(site), site);
        };
        const auto erase = [&](Index handle) {
            dynamic.erase(handle);
            sites.erase(handle);
        };
        for (int i = 0; i < count; ++i) insert(i);
        EXPECT_LE(dynamic.insertions(), 1U * count) << name;
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << name;
        // The one that came last goes and comes; then any; in the end those that came first go.
        std::uint64_t before = dynamic.insertions();
        for (int i = 0; i < count; ++i) {
            erase(count - 1);
            insert(count - 1);
        }
        for (int i = 0; i < count; ++i) {
            const Index any = 1 + below(count - 1);
            erase(any);
            insert(any);
        }
        EXPECT_LE(dynamic.insertions() - before, 12U * count) << name;
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << name;
        before = dynamic.insertions();
        for (Index handle = 0; handle + 20 < count; ++handle) erase(handle);
        EXPECT_LE(dynamic.insertions() - before, 12U * count) << name;
        ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites)) << name;
        EXPECT_EQ(dynamic.rebuilds(), 0U) << name;
    }
}

/// From one dimension to two and back.
TEST_P(Dynamic, OnALineAndBesideIt) {
    for (int round = 0; round < 20 * thoroughness; ++round)
        ASSERT_NO_FATAL_FAILURE(run(10, 40, 1, [&] {
            const double t = below(8);
            const bool beside = below(6) == 0;
            return Site{t, 2 * t + (beside ? below(5) - 2 : 0), 1.0 * below(5)};
        }));
}

/// On a convex curve and on a grid there are sites with neighbours on one line, or with one alone.
TEST_P(Dynamic, NorWhereNeighboursHaveNoTessellation) {
    const int count = 40 * thoroughness;
    for (const bool on_curve : {true, false}) {
        DynamicTessellation dynamic(GetParam());
        std::map<Index, Site> sites;
        for (int i = 0; i < count; ++i) {
            const double angle = 6.28 * real();
            const Site site = on_curve
                                  ? Site{std::cos(angle), std::sin(angle), 0.5 / count * real()}
                                  : Site{1.0 * (i % 8), std::floor(i / 8.0), 0.25 * below(3)};
            sites.emplace(dynamic.insert(site), site);
        }
        const std::size_t before = dynamic.rebuilds();
        while (sites.size() > 24) {
            const auto any = std::next(sites.begin(), below(static_cast<int>(sites.size())));
            dynamic.erase(any->first);
            sites.erase(any);
            ASSERT_NO_FATAL_FAILURE(expect_canonical(dynamic, sites));
        }
        EXPECT_EQ(dynamic.rebuilds(), before) << (on_curve ? "on a curve" : "on a grid");
    }
}

TEST_P(Dynamic, RefusesWhatIsNotFinite) {
    DynamicTessellation dynamic(GetParam());
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(dynamic.insert({nan, 0, 0}), std::invalid_argument);
    EXPECT_THROW(dynamic.insert({0, std::numeric_limits<double>::infinity(), 0}),
                 std::invalid_argument);
    const Index handle = dynamic.insert({0, 0, 0});
    EXPECT_THROW(dynamic.change(handle, nan), std::invalid_argument);
    EXPECT_EQ(dynamic.size(), 1U);
    EXPECT_TRUE(dynamic.tessellation().faces().empty());
    dynamic.erase(handle);
    EXPECT_EQ(dynamic.tessellation().sites().size(), 0U);
    if (GetParam() != Metric::power) {
        EXPECT_THROW(DynamicTessellation(GetParam(), WeightIs::weight), std::invalid_argument);
    }
    DynamicTessellation moved = std::move(dynamic);
    EXPECT_EQ(moved.insert({1, 1, 1}), 0);
}

INSTANTIATE_TEST_SUITE_P(Metrics, Dynamic, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

TEST(DynamicPower, TakesWeights) {
    std::mt19937_64 random(3);
    const auto number = [&] { return static_cast<double>(random() % 20) - 6; };
    DynamicTessellation dynamic(Metric::power, WeightIs::weight);
    std::vector<power::Site> sites;
    for (int i = 0; i < 60; ++i) {
        const power::Site site = {number(), number(), number()};
        sites.push_back(site);
        dynamic.insert({site.x, site.y, site.w});
        ASSERT_TRUE(dynamic.tessellation().arrays() == triangulate(sites, Power{}).arrays());
    }
    while (!sites.empty()) {
        dynamic.erase(static_cast<Index>(sites.size()) - 1);
        sites.pop_back();
        if (sites.empty()) break;
        ASSERT_TRUE(dynamic.tessellation().arrays() == triangulate(sites, Power{}).arrays());
    }
}

TEST(DynamicOfWeights, SaysSoWithAndWithoutSites) {
    DynamicTessellation dynamic(Metric::power, WeightIs::weight);
    EXPECT_EQ(dynamic.tessellation().weight_is(), WeightIs::weight);
    const Index handle = dynamic.insert({0, 0, -1});
    EXPECT_EQ(dynamic.tessellation().weight_is(), WeightIs::weight);
    dynamic.erase(handle);
    EXPECT_EQ(dynamic.tessellation().weight_is(), WeightIs::weight);
}

}  // namespace
}  // namespace signum
