/// How many questions deletions ask: of a giant amid a rim about as many as it has neighbours, in
/// whatever order these came; and which centres lie in its star.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/supremum.hpp"
#include "../../triangulation/dynamic/star.hpp"
#include "../../triangulation/insertion/delete.hpp"
#include "../../triangulation/insertion/insert.hpp"
#include "../../triangulation/kernels/additive_kernel.hpp"
#include "../../triangulation/kernels/power_kernel.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "../../triangulation/structure/topology.hpp"

namespace signum::triangulation {
namespace {

using Power = PowerKernel<PowerSigns<Site>, filters::Tally>;
template <template <Arithmetic> class Predicates>
using Additive = AdditiveKernel<Predicates<Arithmetic::exact>, filters::Tally>;

/// The giant last, the others around it in no order.
std::vector<Site> giant_in_rim(int rim) {
    std::mt19937_64 random(5);
    std::vector<Site> sites;
    for (int i = 0; i < rim; ++i) {
        const double angle = 2.0 * std::acos(-1.0) * (i + 0.3) / rim;
        sites.push_back({1000.0 * std::cos(angle), 1000.0 * std::sin(angle), 0.0});
    }
    std::shuffle(sites.begin(), sites.end(), random);
    sites.push_back({0.25, 0.125, 400.0});
    return sites;
}

std::uint64_t questions(const filters::Tally& tally) {
    return tally.ccw + tally.in_circle + tally.nearer;
}

struct Asked {
    std::size_t degree;
    std::uint64_t questions;
};

/// What it takes to delete the giant.
template <class Kernel>
Asked to_delete(int rim) {
    const std::vector<Site> given = giant_in_rim(rim);
    const auto giant = static_cast<Index>(rim);
    std::vector<Index> numbers(given.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<Index>(i);
    std::vector<Index> hidden_by(given.size(), -1);
    std::vector<Index> none_hidden(given.size(), -1);
    Topology topology(given.size());
    const auto ask = [&](Kernel& kernel, Insertion<Kernel>& insertion, Index first) {
        for (Index i = first; i <= giant; ++i) insertion.insert(i);
        HalfEdge spoke = topology.spoke(insertion.recent(), giant);
        Asked asked{0, questions(kernel.tally())};
        for ([[maybe_unused]] const HalfEdge of : topology.fan(spoke)) ++asked.degree;
        EXPECT_EQ(Deletion<Kernel>(insertion, none_hidden).erase(spoke), Gap::closed);
        asked.questions = questions(kernel.tally()) - asked.questions;
        return asked;
    };
    if constexpr (Kernel::is_straight) {
        Kernel kernel(given.data(), numbers.data());
        const bool left = kernel.ccw(0, 1, 2) > 0;
        Insertion<Kernel> insertion(topology, kernel, hidden_by, left ? 0 : 1, left ? 1 : 0, 2);
        return ask(kernel, insertion, 3);
    } else {
        std::vector<RankedSite> sites;
        for (const Site& site : given) sites.push_back({site, 0});
        rank(sites, numbers, Workers(1));
        Kernel kernel(sites.data());
        Insertion<Kernel> insertion(topology, kernel, hidden_by, 0, 1);
        return ask(kernel, insertion, 2);
    }
}

template <class Kernel>
void expect_about_degree(double most_each) {
    const Asked few = to_delete<Kernel>(500);
    const Asked many = to_delete<Kernel>(8000);
    EXPECT_GT(many.degree, 4000U);
    const auto each = [](const Asked& asked) {
        return static_cast<double>(asked.questions) / static_cast<double>(asked.degree);
    };
    EXPECT_LT(each(many), most_each);
    EXPECT_LT(each(many), 2.0 * each(few));
}

TEST(Deletion, OfAGiantAsksAboutAsOftenAsItHasNeighbours) {
    expect_about_degree<Power>(60.0);
    expect_about_degree<Additive<euclidean::Perturbed>>(60.0);
    expect_about_degree<Additive<manhattan::Perturbed>>(60.0);
    expect_about_degree<Additive<supremum::Perturbed>>(60.0);
}

/// Stars of every width, whole and at the hull, and centres on their spokes and rims.
TEST(Star, HoldsWhatAFaceHolds) {
    std::mt19937_64 random(7);
    const auto below = [&](int end) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(end));
    };
    int stars = 0;
    for (int trial = 0; trial < 100; ++trial) {
        // Around the origin: integer directions within an angle or all around, each once.
        std::vector<Site> sites;
        const int extent = 3 + below(12);
        const bool at_hull = trial % 2 == 0;
        const auto before = [](const Site& a, const Site& b) {
            return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
        };
        for (int k = 0; k < 8 + below(60); ++k) {
            const Site site = {1.0 * (below(2 * extent + 1) - extent),
                               1.0 * (at_hull ? below(extent + 1) : below(2 * extent + 1) - extent),
                               0.0};
            const bool is_new = std::none_of(sites.begin(), sites.end(), [&](const Site& s) {
                return s.x * site.y == s.y * site.x && s.x * site.x + s.y * site.y > 0.0;
            });
            if (is_new && (site.x != 0.0 || site.y != 0.0)) sites.push_back(site);
        }
        std::sort(sites.begin(), sites.end(), before);
        const auto spokes = static_cast<Index>(sites.size());
        const Index centre = spokes;
        sites.push_back({0.0, 0.0, 0.0});
        const Index query = spokes + 1;
        sites.push_back({0.0, 0.0, 0.0});
        std::vector<Index> numbers(sites.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<Index>(i);
        Power kernel(sites.data(), numbers.data());
        // A wheel: infinity stands where the gap is not less than half a turn.
        std::vector<Index> rim;
        int gaps = 0;
        for (Index k = 0; k < spokes; ++k) {
            rim.push_back(k);
            if (kernel.ccw(centre, k, (k + 1) % spokes) <= 0) {
                rim.push_back(infinite);
                ++gaps;
            }
        }
        if (spokes < 3 || gaps > 1) continue;
        ++stars;
        Topology topology(rim.size() + 2);
        for (std::size_t k = 0; k < rim.size(); ++k)
            static_cast<void>(topology.add_face(centre, rim[k], rim[(k + 1) % rim.size()]));
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const auto next = static_cast<Index>((k + 1) % rim.size());
            topology.glue(Topology::first_edge(static_cast<Index>(k)) + 2,
                          Topology::first_edge(next));
        }
        Star<Power> star(
            topology, kernel,
            Topology::first_edge(static_cast<Index>(below(static_cast<int>(rim.size())))));
        for (int x = -2 * extent; x <= 2 * extent; ++x)
            for (int y = -2 * extent; y <= 2 * extent; ++y) {
                sites[static_cast<std::size_t>(query)] = {x / 2.0, y / 2.0, 0.0};
                bool expected = false;
                for (std::size_t k = 0; k < rim.size(); ++k) {
                    const Index a = rim[k];
                    const Index b = rim[(k + 1) % rim.size()];
                    expected |= a != infinite && b != infinite &&
                                kernel.ccw(centre, a, query) >= 0 && kernel.ccw(a, b, query) >= 0 &&
                                kernel.ccw(b, centre, query) >= 0;
                }
                ASSERT_EQ(star.contains(query), expected) << trial << ": " << x << " " << y;
            }
    }
    EXPECT_GT(stars, 60);
}

TEST(Star, AsksAboutTheLogarithmOfItsSpokes) {
    std::vector<Site> sites = giant_in_rim(4096);
    const auto centre = static_cast<Index>(sites.size() - 1);
    std::sort(sites.begin(), sites.end() - 1, [](const Site& a, const Site& b) {
        return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
    });
    const auto query = static_cast<Index>(sites.size());
    sites.push_back({300.0, -200.0, 0.0});
    std::vector<Index> numbers(sites.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<Index>(i);
    Power kernel(sites.data(), numbers.data());
    Topology topology(sites.size());
    for (Index k = 0; k < centre; ++k)
        static_cast<void>(topology.add_face(centre, k, (k + 1) % centre));
    for (Index k = 0; k < centre; ++k)
        topology.glue(Topology::first_edge(k) + 2, Topology::first_edge((k + 1) % centre));
    Star<Power> star(topology, kernel, 0);
    const std::uint64_t before = kernel.tally().ccw;
    EXPECT_TRUE(star.contains(query));
    EXPECT_LT(kernel.tally().ccw - before, 60U);
}

}  // namespace
}  // namespace signum::triangulation
