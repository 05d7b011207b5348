// A million sites of every distribution; a hundred thousand validated from scratch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"

namespace signum {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr std::int64_t million = 50'000;
constexpr std::int64_t hundred_thousand = 5'000;
#else
constexpr std::int64_t million = 1'000'000;
constexpr std::int64_t hundred_thousand = 100'000;
#endif

struct Kind {
    const char* name;
    Distribution distribution;
    double radius;
};
void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

const Kind kinds[] = {
    {"random", Distribution::random, 0},          {"circle", Distribution::circle, 0},
    {"square", Distribution::square, 0},          {"grid", Distribution::grid, 0},
    {"random_radii", Distribution::random, 0.5},  {"circle_radii", Distribution::circle, 0.02},
    {"square_radii", Distribution::square, 0.02}, {"grid_radii", Distribution::grid, 0.5},
};

std::vector<Site> sites_of(const Kind& kind, std::int64_t count) {
    GenerateOptions options;
    options.count = count;
    options.radius_to = kind.radius;
    options.seed = 17;
    return generate(kind.distribution, options);
}

class Large : public testing::TestWithParam<Kind> {};

TEST_P(Large, AMillionSites) {
    const auto sites = sites_of(GetParam(), million);
    const Tessellation t = triangulate(sites, Power{});
    const std::size_t visible = sites.size() - t.hidden().size();
    ASSERT_EQ(t.faces().size(), 2 * visible - 2);
    ASSERT_EQ(t.edges().size(), 3 * visible - 3);
    if (GetParam().radius == 0) {
        // Only sites at one place hide one another.
        std::set<std::pair<double, double>> places;
        for (const Site& s : sites) places.insert({s.x, s.y});
        EXPECT_EQ(visible, places.size());
    }
    std::mt19937_64 random(1);
    for (int question = 0; question < 1000; ++question) {
        const auto i = static_cast<Index>(random() % sites.size());
        const Site& s = sites[static_cast<std::size_t>(i)];
        const Index nearest = t.nearest({s.x, s.y});
        if (GetParam().radius == 0) {
            const Site& n = sites[static_cast<std::size_t>(nearest)];
            ASSERT_TRUE(n.x == s.x && n.y == s.y);
        }
    }
}

TEST_P(Large, AHundredThousandValidated) {
    const auto sites = sites_of(GetParam(), hundred_thousand);
    Options options;
    options.seed = 3;
    const Validation v = validate(triangulate(sites, Power{}, options).arrays(), sites);
    EXPECT_TRUE(v.valid && v.canonical) << v.message;
}

TEST_P(Large, PermutationsGiveTheSame) {
    const auto sites = sites_of(GetParam(), hundred_thousand);
    const Tessellation expected = triangulate(sites, Power{});
    std::vector<Index> order(sites.size());
    std::iota(order.begin(), order.end(), 0);
    std::mt19937_64 random(2);
    std::shuffle(order.begin(), order.end(), random);
    // Of equal sites the first counts: keep their order.
    std::vector<std::size_t> by_place(sites.size());
    std::iota(by_place.begin(), by_place.end(), std::size_t{0});
    const auto key = [&](std::size_t place) {
        const Site& s = sites[static_cast<std::size_t>(order[place])];
        return std::tuple(s.x, s.y, s.r, place);
    };
    std::sort(by_place.begin(), by_place.end(),
              [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    for (std::size_t first = 0; first < by_place.size();) {
        std::size_t last = first + 1;
        const auto same = [&](std::size_t a, std::size_t b) {
            return sites[static_cast<std::size_t>(order[by_place[a]])] ==
                   sites[static_cast<std::size_t>(order[by_place[b]])];
        };
        while (last < by_place.size() && same(first, last)) ++last;
        std::vector<Index> group;
        for (std::size_t i = first; i < last; ++i) group.push_back(order[by_place[i]]);
        std::sort(group.begin(), group.end());
        for (std::size_t i = first; i < last; ++i) order[by_place[i]] = group[i - first];
        first = last;
    }
    std::vector<Site> permuted;
    for (const Index i : order) permuted.push_back(sites[static_cast<std::size_t>(i)]);
    Options options;
    options.seed = 12345;
    const Tessellation t = triangulate(permuted, Power{}, options);
    std::vector<Face> faces;
    for (Face face : t.faces()) {
        for (Index& v : face)
            if (v != infinite) v = order[static_cast<std::size_t>(v)];
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(faces, expected.arrays().faces);
    std::vector<std::pair<Index, Index>> hidden;
    std::vector<std::pair<Index, Index>> expected_hidden;
    for (const Hidden& h : t.hidden())
        hidden.emplace_back(order[static_cast<std::size_t>(h.site)],
                            order[static_cast<std::size_t>(h.by)]);
    for (const Hidden& h : expected.hidden()) expected_hidden.emplace_back(h.site, h.by);
    std::sort(hidden.begin(), hidden.end());
    EXPECT_EQ(hidden, expected_hidden);
}

TEST_P(Large, NaiveArithmeticEnds) {
    for (const double perturb : {0.0, 1e-9}) {
        auto sites = sites_of(GetParam(), hundred_thousand);
        std::mt19937_64 random(4);
        for (Site& s : sites) s.x += perturb * static_cast<double>(random() >> 11) * 0x1p-53;
        Options options;
        options.arithmetic = Arithmetic::naive;
        try {
            const Tessellation t = triangulate(sites, Power{}, options);
            EXPECT_EQ(t.sites().size(), sites.size());
        } catch (const BrokenStructure& e) {
            EXPECT_FALSE(std::string(e.what()).empty());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Distributions, Large, testing::ValuesIn(kinds),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace signum
