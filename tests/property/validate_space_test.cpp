/// validate() accepts the tessellations of space, and of any dimension, that triangulate() makes,
/// says of every mutation what is wrong with it, and survives anything.

#include <algorithm>
#include <array>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/space.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../../predicates/space/ties.hpp"
#include "../../triangulation/any_dimension/triangulate.hpp"
#include "../../triangulation/any_dimension/validate.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"
#include "any_dimension_sites.hpp"
#include "judged_by_definition.hpp"

namespace signum {
namespace {

using any_dimension_test::lattice;
using any_dimension_test::random_sites;
using any_dimension_test::small_set;
using oracle_test::Random;
using Sites = std::vector<power::Site3>;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}
Sites in_space(const any_dimension_test::Sites<3>& sites) {
    Sites result;
    for (const auto& s : sites) result.push_back({s.centre[0], s.centre[1], s.centre[2], s.w});
    return result;
}
SpaceTessellation tessellation_of(const Sites& sites) {
    return triangulate(std::span<const power::Site3>(sites));
}
Validation judged(const SpaceTessellation& tessellation, const Sites& sites) {
    return validate(tessellation, std::span<const power::Site3>(sites));
}

template <class T, class S>
void expect_canonical(const T& tessellation, const std::vector<S>& sites) {
    const Validation result = validate(tessellation, std::span<const S>(sites));
    ASSERT_TRUE(result.valid) << result.message;
    ASSERT_TRUE(result.canonical) << result.message;
    ASSERT_EQ(result.message, "");
}
void expect_canonical(const Sites& sites) {
    ASSERT_NO_FATAL_FAILURE(expect_canonical(tessellation_of(sites), sites));
    // The same sites as balls and as points.
    std::vector<Site3> balls;
    std::vector<Point3> points;
    for (const power::Site3& s : sites) {
        balls.push_back({s.x, s.y, s.z, s.w});
        points.push_back({s.x, s.y, s.z});
    }
    ASSERT_NO_FATAL_FAILURE(expect_canonical(triangulate(balls), balls));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(triangulate(points), points));
}
template <class Draw>
Sites drawn(int n, Draw draw) {
    Sites sites;
    for (int i = 0; i < n; ++i) sites.push_back(draw());
    return sites;
}

TEST(ValidateSpace, AcceptsWhatTriangulateGives) {
    Random random(61);
    const auto unit = [&] { return random.unit(); };
    ASSERT_NO_FATAL_FAILURE(expect_canonical(in_space(random_sites<3>(random, 1500, 0.0))));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(in_space(random_sites<3>(random, 1500, 0.05))));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(in_space(lattice<3>(8))));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(800, [&] {
        return power::Site3{1.0 * random.below(6), 1.0 * random.below(6), 1.0 * random.below(6),
                            1.0 * random.below(4)};
    })));
    // On a sphere, rounded; on one with integer points.
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(800, [&] {
        const double z = 2.0 * unit() - 1.0;
        const double turn = 7.0 * unit();
        const double r = std::sqrt(1.0 - z * z);
        return power::Site3{r * std::cos(turn), r * std::sin(turn), z, 0.0};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(200, [&] {
        std::array<double, 3> p = {1.0, 2.0, 2.0};
        std::swap(p[0], p[at(random.below(3))]);
        for (double& x : p) x *= 1.0 - 2.0 * random.below(2);
        return power::Site3{p[0], p[1], p[2], 0.0};
    })));
    // Nested balls, and sites far apart in size.
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(500, [&] {
        const double size = std::ldexp(1.0, -random.below(30));
        return power::Site3{size * unit(), size * unit(), size * unit(), size * size * unit()};
    })));
    // In a plane along the axes, in another one, on a line, in one place.
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(500, [&] {
        return power::Site3{unit(), 0.25, unit(), 0.01 * unit()};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(500, [&] {
        const double x = unit();
        const double y = unit();
        return power::Site3{x, y, x + y, 0.01 * unit()};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(200, [&] {
        const double x = random.below(50);
        return power::Site3{x, -x, 2.0 * x, 3.0 * unit()};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(drawn(20, [&] {
        return power::Site3{1.0, 2.0, 3.0, 1.0 * random.below(3)};
    })));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(Sites{}));
    ASSERT_NO_FATAL_FAILURE(expect_canonical(Sites{{1.0, 2.0, 3.0, 4.0}}));
    for (int trial = 0; trial < 400 * thoroughness; ++trial)
        ASSERT_NO_FATAL_FAILURE(expect_canonical(in_space(small_set<3>(random, 20))));
}

template <int D>
void expect_canonical_in(Random& random, int trials, int most) {
    for (int trial = 0; trial < trials; ++trial) {
        const auto sites = small_set<D>(random, most);
        ASSERT_NO_FATAL_FAILURE(expect_canonical(triangulate<D>(sites), sites)) << D;
    }
    const auto cube = lattice<D>(2);
    ASSERT_NO_FATAL_FAILURE(expect_canonical(triangulate<D>(cube), cube));
}

TEST(ValidateSpace, AcceptsAnyDimension) {
    Random random(62);
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<1>(random, 100 * thoroughness, 20));
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<2>(random, 100 * thoroughness, 20));
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<3>(random, 100 * thoroughness, 20));
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<4>(random, 50 * thoroughness, 20));
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<5>(random, 20 * thoroughness, 14));
    ASSERT_NO_FATAL_FAILURE(expect_canonical_in<6>(random, 5 * thoroughness, 12));
}

/// Of all exponents, the largest and the least among them.
double any_double(Random& random) {
    switch (random.below(6)) {
        case 0:
            return 0.0;
        case 1:
            return std::numeric_limits<double>::max() * (1 - 2 * random.below(2));
        case 2:
            return std::numeric_limits<double>::denorm_min() * random.below(4);
        default:
            return std::ldexp(random.unit() - 0.5, random.below(2000) - 1000);
    }
}

TEST(ValidateSpace, AcceptsSitesOfAllSizes) {
    Random random(68);
    for (int trial = 0; trial < 15 * thoroughness; ++trial) {
        const Sites sites = drawn(4 + random.below(8), [&] {
            const double x = any_double(random);
            const double y = random.below(4) == 0 ? x : any_double(random);
            return power::Site3{x, y, random.below(4) == 0 ? y : any_double(random),
                                random.below(2) == 0 ? any_double(random) : 0.0};
        });
        ASSERT_NO_FATAL_FAILURE(expect_canonical(sites)) << trial;
        any_dimension_test::Sites<4> in_four;
        any_dimension_test::Sites<3> in_three;
        for (const power::Site3& s : sites) {
            in_four.push_back({{s.x, s.y, any_double(random), s.z}, s.w});
            in_three.push_back({{s.x, s.y, s.z}, s.w});
        }
        ASSERT_NO_FATAL_FAILURE(expect_canonical(triangulate<4>(in_four), in_four)) << trial;
        ASSERT_EQ(triangulate<3>(in_three).cells, tessellation_of(sites).cells);
    }
}

TEST(ValidateSpace, AsksForNoFloatingPointEnvironment) {
    Random random(69);
    for (int trial = 0; trial < 50 * thoroughness; ++trial) {
        const auto sites = small_set<4>(random, 12);
        const auto expected = triangulate<4>(sites);
        for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            const auto result = triangulate<4>(sites);
            const Validation judgement = validate(result, std::span<const power::SiteOf<4>>(sites));
            const bool is_kept = std::fegetround() == mode;
            std::fesetround(FE_TONEAREST);
            ASSERT_TRUE(is_kept);
            ASSERT_EQ(result, expected);
            ASSERT_TRUE(judgement.canonical) << judgement.message;
        }
    }
}

/// The neighbours of cells, by their facets; where there is none, the cell itself.
void connect(SpaceTessellation& t) {
    std::map<std::vector<Index>, std::vector<std::pair<std::size_t, std::size_t>>> sides;
    t.neighbours.assign(t.cells.size(), {});
    for (std::size_t c = 0; c < t.cells.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
            t.neighbours[c][i] = t.cells[c][i] == no_vertex ? no_vertex : static_cast<Index>(c);
            if (t.cells[c][i] == no_vertex) continue;
            std::vector<Index> facet;
            for (std::size_t m = 0; m < 4; ++m)
                if (m != i) facet.push_back(t.cells[c][m]);
            std::ranges::sort(facet);
            sides[facet].emplace_back(c, i);
        }
    for (const auto& [facet, of] : sides) {
        if (of.size() != 2) continue;
        t.neighbours[of[0].first][of[0].second] = static_cast<Index>(of[1].first);
        t.neighbours[of[1].first][of[1].second] = static_cast<Index>(of[0].first);
    }
}
bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
/// What is wrong, as validate() says.
std::string complaint(const SpaceTessellation& tessellation, const Sites& sites) {
    const Validation result = judged(tessellation, sites);
    EXPECT_FALSE(result.valid && result.canonical);
    return (result.valid ? "valid: " : "") + result.message;
}
#define EXPECT_COMPLAINT(tessellation, sites, part)             \
    EXPECT_TRUE(contains(complaint(tessellation, sites), part)) \
        << "instead: " << complaint(tessellation, sites)

Sites some_sites() {
    Random random(63);
    Sites sites = in_space(random_sites<3>(random, 60, 0.0));
    // A ball that hides others.
    sites.push_back({0.5, 0.5, 0.5, 0.02});
    sites.push_back({0.51, 0.5, 0.5, -0.1});
    sites.push_back({0.5, 0.51, 0.5, -0.1});
    return sites;
}

TEST(ValidateSpace, AnyOrderThatKeepsOrientationsIsValid) {
    const Sites sites = some_sites();
    const SpaceTessellation right = tessellation_of(sites);
    ASSERT_GE(right.hidden.size(), 2U);
    SpaceTessellation turned = right;
    for (std::size_t c = 0; c < turned.cells.size(); c += 3)
        for (auto* each : {&turned.cells[c], &turned.neighbours[c]})
            *each = {(*each)[1], (*each)[0], (*each)[3], (*each)[2]};
    EXPECT_COMPLAINT(turned, sites, "valid: cell 0: its numbers are not in canonical order");
    SpaceTessellation shuffled = right;
    std::swap(shuffled.cells[5], shuffled.cells[40]);
    connect(shuffled);
    EXPECT_COMPLAINT(shuffled, sites, "valid: cell 6 is not in canonical order");
    SpaceTessellation hidden = right;
    std::swap(hidden.hidden[0], hidden.hidden[1]);
    EXPECT_COMPLAINT(hidden, sites, "valid: the hidden sites are not in canonical order");
    // Cells of flat sites have no orientation.
    Sites flat = sites;
    for (power::Site3& s : flat) s.z = s.x;
    SpaceTessellation plane = tessellation_of(flat);
    EXPECT_EQ(plane.dimension, 2);
    for (auto* each : {&plane.cells[30], &plane.neighbours[30]}) std::swap((*each)[0], (*each)[1]);
    EXPECT_COMPLAINT(plane, flat, "valid: cell 30: its numbers are not in canonical order");
}

TEST(ValidateSpace, SaysWhatIsWrongWithNumbers) {
    const Sites sites = some_sites();
    const SpaceTessellation right = tessellation_of(sites);
    const auto changed = [&](auto change) {
        SpaceTessellation result = right;
        change(result);
        return result;
    };
    const Index first_hidden = right.hidden[0].site;
    EXPECT_COMPLAINT(changed([](auto& t) { --t.sites; }), sites,
                     "speaks of 62 sites, the input has 63");
    EXPECT_COMPLAINT(changed([](auto& t) { t.dimension = 4; }), sites, "do not span 4 dimensions");
    EXPECT_COMPLAINT(changed([](auto& t) { t.dimension = -1; }), sites,
                     "do not span -1 dimensions");
    EXPECT_COMPLAINT(changed([](auto& t) { t.dimension = 2; }), sites,
                     "cell 0 has more than 3 vertices");
    EXPECT_COMPLAINT(changed([](auto& t) { t.cells.clear(); }), sites, "there is no cell");
    EXPECT_COMPLAINT(changed([](auto& t) { t.neighbours.pop_back(); }), sites,
                     "tuples of neighbours");
    EXPECT_COMPLAINT(changed([](auto& t) { t.cells[7][2] = 63; }), sites,
                     "cell 7: there is no site 63");
    EXPECT_COMPLAINT(changed([](auto& t) { t.cells[7][2] = no_vertex; }), sites,
                     "cell 7: there is no site -2");
    EXPECT_COMPLAINT(changed([](auto& t) { t.cells[7][2] = t.cells[7][1]; }), sites, "twice");
    EXPECT_COMPLAINT(changed([](auto& t) { t.neighbours[7][2] = 1 << 30; }), sites,
                     "cell 1073741824 is no neighbour");
    EXPECT_COMPLAINT(changed([](auto& t) { t.neighbours[7][2] = -5; }), sites,
                     "cell -5 is no neighbour");
    EXPECT_COMPLAINT(changed([](auto& t) { t.neighbours[7][2] = 7; }), sites,
                     "cell 7 is no neighbour");
    EXPECT_COMPLAINT(changed([](auto& t) { t.neighbours[7][2] = t.neighbours[7][1]; }), sites,
                     "does not share the facet");
    EXPECT_COMPLAINT(changed([](auto& t) { t.cells.pop_back(), t.neighbours.pop_back(); }), sites,
                     "is no neighbour");
    // Another vertex.
    EXPECT_COMPLAINT(changed([&](auto& t) {
                         Index other = 0;
                         while (std::ranges::find(t.cells[99], other) != t.cells[99].end()) ++other;
                         t.cells[99][3] = other;
                     }),
                     sites, "does not share the facet");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden[0].site = -1; }), sites,
                     "hidden: there is no site -1");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden[0].by = 63; }), sites,
                     "hidden: there is no site 63");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden[0].site = 3; }), sites,
                     "site 3 is both visible and hidden");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden.push_back(t.hidden[0]); }), sites,
                     "is hidden twice");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden.erase(t.hidden.begin()); }), sites,
                     "site " + std::to_string(first_hidden) + " is neither visible nor hidden");
    EXPECT_COMPLAINT(changed([](auto& t) { t.hidden[0].by = t.hidden[1].site; }), sites,
                     "which is hidden itself");
    Sites infinite_sites = sites;
    infinite_sites[4].w = HUGE_VAL;
    EXPECT_THROW(static_cast<void>(judged(right, infinite_sites)), std::invalid_argument);
}

TEST(ValidateSpace, SaysWhatIsWrongWithPlaces) {
    const Sites sites = some_sites();
    const SpaceTessellation right = tessellation_of(sites);
    const auto first_finite = static_cast<std::size_t>(
        std::ranges::find_if(right.cells, [](const SpaceCell& c) { return c[0] >= 0; }) -
        right.cells.begin());
    SpaceTessellation turned = right;
    for (auto* each : {&turned.cells[first_finite], &turned.neighbours[first_finite]})
        std::swap((*each)[0], (*each)[1]);
    EXPECT_COMPLAINT(turned, sites,
                     "cell " + std::to_string(first_finite) + " turns the wrong way");
    SpaceTessellation hull = right;
    for (auto* each : {&hull.cells[2], &hull.neighbours[2]}) std::swap((*each)[0], (*each)[1]);
    EXPECT_COMPLAINT(hull, sites, "lie on the same side of their facet");
    // Mirrored as a whole.
    SpaceTessellation mirrored = right;
    for (std::size_t c = 0; c < mirrored.cells.size(); ++c)
        for (auto* each : {&mirrored.cells[c], &mirrored.neighbours[c]})
            std::swap((*each)[0], (*each)[1]);
    EXPECT_COMPLAINT(mirrored, sites, "turns the wrong way");
    // A site that has gone elsewhere.
    Sites moved = sites;
    moved[7].x += 0.3;
    EXPECT_FALSE(judged(right, moved).valid);
    // Two copies, each closed.
    SpaceTessellation twice = right;
    const auto number = static_cast<Index>(right.cells.size());
    for (std::size_t c = 0; c < right.cells.size(); ++c) {
        twice.cells.push_back(right.cells[c]);
        SpaceCell shifted = right.neighbours[c];
        for (Index& n : shifted) n += number;
        twice.neighbours.push_back(shifted);
    }
    EXPECT_COMPLAINT(twice, sites, "overlap");
    // One cell twice, which its neighbours do not know of. The last one is not the base.
    SpaceTessellation repeated = right;
    repeated.cells.push_back(right.cells.back());
    repeated.neighbours.push_back(right.neighbours.back());
    EXPECT_COMPLAINT(repeated, sites, "has another neighbour there");
    // The two copies connected crosswise along some facets: a branched cover.
    SpaceTessellation branched = twice;
    for (std::size_t c = first_finite; c < first_finite + 20; ++c) {
        const Index n = branched.neighbours[c][0];
        if (n >= number) continue;
        const auto back = static_cast<std::size_t>(
            std::ranges::find(branched.neighbours[at(n)], static_cast<Index>(c)) -
            branched.neighbours[at(n)].begin());
        const auto other_c = c + at(number);
        const auto other_n = at(n) + at(number);
        std::swap(branched.neighbours[c][0], branched.neighbours[other_c][0]);
        std::swap(branched.neighbours[at(n)][back], branched.neighbours[other_n][back]);
    }
    EXPECT_COMPLAINT(branched, sites, "overlap");
    // The hull of fewer sites is not convex around one that is joined from outside: that of a
    // tetrahedron with a dent.
    const Sites dent = {{0, 0, 0, 0}, {4, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 4, 0}, {1, 1, 0.5, 0}};
    SpaceTessellation hollow = tessellation_of(dent);
    ASSERT_EQ(hollow.cells.size(), 8U);
    const auto bottom = std::ranges::find_if(hollow.cells, [](SpaceCell c) {
        std::ranges::sort(c);
        return c == SpaceCell{0, 1, 2, 4};
    });
    ASSERT_NE(bottom, hollow.cells.end());
    const SpaceCell removed = *bottom;
    hollow.cells.erase(bottom);
    std::erase_if(hollow.cells, [](SpaceCell c) {
        std::ranges::sort(c);
        return c == SpaceCell{-1, 0, 1, 2};
    });
    // In its place three cells at infinity, with 4 for one of 0, 1, 2 and infinity for 4.
    for (std::size_t i = 0; i < 4; ++i) {
        if (removed[i] == 4) continue;
        SpaceCell cell = removed;
        cell[i] = -1;
        hollow.cells.push_back(cell);
    }
    connect(hollow);
    EXPECT_COMPLAINT(hollow, dent, "beyond the hull's facet");
}

TEST(ValidateSpace, SaysWhatIsInConflict) {
    // Five sites: of the two triangulations that differ by one flip each is wrong for the weights
    // of the other.
    const Sites low = {{0, 0, 0, 0}, {4, 0, 0, 0}, {0, 4, 0, 0}, {1, 1, 3, 0}, {1, 1, -3, 0}};
    Sites high = low;
    high[3].w = high[4].w = 20.0;
    const SpaceTessellation two = tessellation_of(low);
    const SpaceTessellation three = tessellation_of(high);
    const auto finite = [](const SpaceTessellation& t) {
        return std::ranges::count_if(t.cells, [](const SpaceCell& c) { return c[0] >= 0; });
    };
    ASSERT_EQ(finite(two) + finite(three), 5);
    EXPECT_COMPLAINT(two, high, "in conflict with cell");
    EXPECT_COMPLAINT(three, low, "in conflict with cell");

    const Sites sites = some_sites();
    const SpaceTessellation right = tessellation_of(sites);
    // The same sites as points, of which none is hidden.
    Sites plain = sites;
    for (power::Site3& s : plain) s.w = 0.0;
    EXPECT_COMPLAINT(tessellation_of(plain), sites, "in conflict with cell");
    EXPECT_FALSE(judged(right, plain).valid);
    // By another site.
    SpaceTessellation by = right;
    by.hidden[0].by = 3;
    EXPECT_COMPLAINT(by, sites, "is nearer");
    // Not hidden at all: within, and outside.
    Sites fewer(sites.begin(), sites.end() - 3);
    SpaceTessellation claimed = tessellation_of(fewer);
    ++claimed.sites;
    fewer.push_back({0.5, 0.5, 0.5, 0.0});
    Index nearest = 0;
    for (Index i = 1; i + 1 < static_cast<Index>(fewer.size()); ++i)
        if (power::nearer_decision(centre3(fewer.back()), fewer[at(i)], fewer[at(nearest)]).sign >
            0)
            nearest = i;
    claimed.hidden = {{static_cast<Index>(fewer.size() - 1), nearest}};
    EXPECT_COMPLAINT(claimed, fewer, "site 60 is in conflict with cell");
    fewer.back() = {2.0, 2.0, 2.0, 0.0};
    nearest = 0;
    for (Index i = 1; i + 1 < static_cast<Index>(fewer.size()); ++i)
        if (power::nearer_decision(centre3(fewer.back()), fewer[at(i)], fewer[at(nearest)]).sign >
            0)
            nearest = i;
    claimed.hidden[0].by = nearest;
    EXPECT_COMPLAINT(claimed, fewer, "lies outside the hull");
}

TEST(ValidateSpace, ProvesTheDimension) {
    const Sites cube = in_space(lattice<3>(2));
    Sites square = cube;
    for (power::Site3& s : square) s.z = 0.0;
    const SpaceTessellation of_square = tessellation_of(square);
    ASSERT_EQ(of_square.dimension, 2);
    EXPECT_COMPLAINT(of_square, cube, "does not lie in the flat of dimension 2 of cell");
    const SpaceTessellation of_cube = tessellation_of(cube);
    EXPECT_COMPLAINT(of_cube, square, "is flat");
    Sites thin = cube;
    for (power::Site3& s : thin) s.z = s.x;
    EXPECT_COMPLAINT(of_cube, thin, "is flat");
    Sites edge = square;
    for (power::Site3& s : edge) s.y = 0.0;
    const SpaceTessellation of_edge = tessellation_of(edge);
    ASSERT_EQ(of_edge.dimension, 1);
    EXPECT_COMPLAINT(of_edge, square, "does not lie in the flat of dimension 1 of cell");
    Sites point = edge;
    for (power::Site3& s : point) s.x = 0.0;
    const SpaceTessellation of_point = tessellation_of(point);
    ASSERT_EQ(of_point.dimension, 0);
    EXPECT_COMPLAINT(of_point, edge, "are not in one place");
    SpaceTessellation other = of_point;
    other.cells[1][0] = 1;
    for (Hidden& h : other.hidden) h = {h.site == 1 ? 0 : h.site, 1};
    EXPECT_COMPLAINT(other, point, "valid: by the tie rule site 0 hides site 1");
    point[0].w = -1.0;
    EXPECT_COMPLAINT(of_point, point, "site 0 does not hide site 1");
}

/// Whether cells that are a triangulation are one of the weights, from the definition: no site in
/// conflict with any cell.
bool is_regular(const SpaceTessellation& t, const Sites& sites, bool by_rule) {
    for (const SpaceCell& c : t.cells) {
        if (c[0] < 0) continue;
        const std::array<power::Site3, 4> s = {sites[at(c[0])], sites[at(c[1])], sites[at(c[2])],
                                               sites[at(c[3])]};
        for (Index q = 0; at(q) < sites.size(); ++q) {
            if (std::ranges::find(c, q) != c.end()) continue;
            const Sign sign = power::in_sphere(s[0], s[1], s[2], s[3], sites[at(q)]);
            if (sign > 0) return false;
            if (sign == 0 && by_rule &&
                power::in_sphere_tie<power::Site3>({s[0], s[1], s[2], s[3], sites[at(q)]},
                                                   {c[0], c[1], c[2], c[3], q}) > 0)
                return false;
        }
    }
    return true;
}

TEST(ValidateSpace, JudgesAsEveryCellWithEverySite) {
    Random random(64);
    int valid = 0;
    int canonical = 0;
    int wrong = 0;
    for (int trial = 0; trial < 1000 * thoroughness; ++trial) {
        Sites sites;
        const int range = 2 + random.below(3);
        for (int n = 5 + random.below(12); n > 0; --n)
            sites.push_back({1.0 * random.below(range), 1.0 * random.below(range),
                             1.0 * random.below(range), random.below(4) == 0 ? 1.0 : 0.0});
        // Triangulations of the same centres, regular for weights that differ a little.
        Sites others = sites;
        for (power::Site3& s : others)
            if (random.below(3) == 0)
                s.w += 0x1p-10 * random.unit() * (random.below(4) == 0 ? 1024 : 1);
        SpaceTessellation t = tessellation_of(others);
        if (t.dimension < 3) continue;
        for (Hidden& h : t.hidden) {
            // The nearest for the weights at hand.
            std::vector<char> is_hidden(sites.size(), 0);
            for (const Hidden& each : t.hidden) is_hidden[at(each.site)] = 1;
            h.by = infinite;
            for (Index v = 0; at(v) < sites.size(); ++v) {
                if (is_hidden[at(v)] != 0) continue;
                const Sign sign = h.by == infinite
                                      ? 1
                                      : power::nearer_decision(centre3(sites[at(h.site)]),
                                                               sites[at(v)], sites[at(h.by)])
                                            .sign;
                if (sign > 0 ||
                    (sign == 0 && power::precedes(sites[at(v)], v, sites[at(h.by)], h.by)))
                    h.by = v;
            }
        }
        const Validation result = judged(t, sites);
        const bool is_valid = is_regular(t, sites, false);
        ASSERT_EQ(result.valid, is_valid) << result.message;
        ASSERT_EQ(result.canonical, is_valid && is_regular(t, sites, true)) << result.message;
        ASSERT_EQ(result.canonical, result.message.empty());
        valid += static_cast<int>(result.valid);
        canonical += static_cast<int>(result.canonical);
        wrong += static_cast<int>(!result.valid);
    }
    EXPECT_GT(wrong, 20 * thoroughness);
    EXPECT_GT(canonical, 20 * thoroughness);
    EXPECT_GT(valid - canonical, 20 * thoroughness);
}

/// Gives each hidden site the nearest that is not, by numbers that are small integers.
void name_hiders(TessellationOf<2>& t, const any_dimension_test::Sites<2>& sites) {
    std::vector<char> is_hidden(sites.size(), 0);
    for (const Hidden& each : t.hidden) is_hidden[at(each.site)] = 1;
    for (Hidden& h : t.hidden) {
        const auto key = [&](Index v) {
            const auto& s = sites[at(v)];
            const double x = s.centre[0] - sites[at(h.site)].centre[0];
            const double y = s.centre[1] - sites[at(h.site)].centre[1];
            return std::tuple(x * x + y * y - s.w, -s.w, s.centre, v);
        };
        h.by = infinite;
        for (Index v = 0; at(v) < sites.size(); ++v)
            if (is_hidden[at(v)] == 0 && (h.by == infinite || key(v) < key(h.by))) h.by = v;
    }
}

/// Planes as arrays of the plane, of two dimensions and of space; half of them with a site that has
/// moved since.
TEST(ValidateSpace, JudgesPlanesByDefinition) {
    Random random(67);
    int valid = 0;
    int canonical = 0;
    int wrong = 0;
    for (int trial = 0; trial < 1000 * thoroughness; ++trial) {
        any_dimension_test::Sites<2> sites;
        const int range = 2 + random.below(4);
        for (int n = 4 + random.below(12); n > 0; --n)
            sites.push_back({{1.0 * random.below(range), 1.0 * random.below(range)},
                             random.below(4) == 0 ? 1.0 : 0.0});
        any_dimension_test::Sites<2> others = sites;
        for (auto& s : others)
            if (random.below(3) == 0)
                s.w += 0x1p-10 * random.unit() * (random.below(4) == 0 ? 1024 : 1);
        TessellationOf<2> t = triangulate<2>(others);
        if (t.dimension < 2) continue;
        const bool is_moved = random.below(2) == 0;
        if (is_moved)
            sites[at(random.below(static_cast<int>(sites.size())))].centre = {
                1.0 * random.below(range), 1.0 * random.below(range)};
        name_hiders(t, sites);
        TessellationArrays arrays;
        arrays.weight_is = WeightIs::weight;
        arrays.sites = t.sites;
        arrays.faces = t.cells;
        arrays.neighbours = t.neighbours;
        arrays.hidden = t.hidden;
        // In space they are as well, whatever the plane.
        SpaceTessellation flat;
        flat.dimension = 2;
        flat.sites = t.sites;
        flat.hidden = t.hidden;
        for (std::size_t c = 0; c < t.cells.size(); ++c) {
            const auto in_four = [](const CellOf<2>& cell) {
                return SpaceCell{cell[0], cell[1], cell[2], no_vertex};
            };
            flat.cells.push_back(in_four(t.cells[c]));
            flat.neighbours.push_back(in_four(t.neighbours[c]));
        }
        std::vector<power::Site> plane;
        Sites tilted;
        const int axis = random.below(3);
        for (const auto& s : sites) {
            const auto [x, y] = s.centre;
            plane.push_back({x, y, s.w});
            // Isometric but for the factor 5, which weights take twice.
            tilted.push_back(axis == 0   ? power::Site3{x, y, 3.0, s.w}
                             : axis == 1 ? power::Site3{7.0, y, x, s.w}
                                         : power::Site3{3.0 * x, 5.0 * y, 4.0 * x, 25.0 * s.w});
        }
        const std::string expected = wrong_by_definition(arrays, plane);
        const bool is_canonical = t == triangulate<2>(sites);
        const Validation of_plane =
            validate(arrays, StridedSites(std::span<const power::Site>(plane)));
        ASSERT_EQ(of_plane.valid, expected.empty()) << of_plane.message << "; " << expected;
        ASSERT_EQ(of_plane.canonical, is_canonical) << of_plane.message;
        const Validation result = validate<2>(t, std::span<const power::SiteOf<2>>(sites));
        ASSERT_EQ(result.valid, expected.empty()) << result.message << "; " << expected;
        ASSERT_EQ(result.canonical, is_canonical) << result.message;
        // There flat cells have no orientation, so that one which a site has turned over is right.
        if (!is_moved) {
            const Validation in_space = judged(flat, tilted);
            ASSERT_EQ(in_space.valid, expected.empty()) << in_space.message << "; " << expected;
            // Along other axes the order of equal weights is another one.
            if (axis != 1 && expected.empty()) {
                ASSERT_EQ(contains(in_space.message, "by the tie rule"), !is_canonical)
                    << in_space.message;
            }
        }
        valid += static_cast<int>(result.valid);
        canonical += static_cast<int>(result.canonical);
        wrong += static_cast<int>(!result.valid);
    }
    EXPECT_GT(wrong, 20 * thoroughness);
    EXPECT_GT(canonical, 20 * thoroughness);
    EXPECT_GT(valid - canonical, 20 * thoroughness);
}

/// What the arrays say, whatever their order.
template <class T>
auto meaning(T t) {
    for (auto& cell : t.cells) std::ranges::sort(cell);
    std::ranges::sort(t.cells);
    std::ranges::sort(t.hidden, {}, &Hidden::site);
    return std::pair(t.cells, t.hidden);
}
template <class T>
void change_somewhere(Random& random, T& t) {
    const auto n = static_cast<int>(t.sites);
    const auto cells = static_cast<int>(t.cells.size());
    const auto size = static_cast<int>(t.cells[0].size());
    const std::size_t c = at(random.below(cells));
    const std::size_t d = at(random.below(cells));
    const std::size_t i = at(random.below(size));
    const std::size_t k = at(random.below(size));
    switch (random.below(9)) {
        case 0:
            t.cells[c][i] = random.below(n + 6) - 3;
            break;
        case 1:
            t.neighbours[c][i] = random.below(cells + 6) - 3;
            break;
        case 2:
            std::swap(t.cells[c][i], t.cells[c][k]);
            std::swap(t.neighbours[c][i], t.neighbours[c][k]);
            break;
        case 3:
            std::swap(t.cells[c][i], t.cells[d][k]);
            break;
        case 4:
            std::swap(t.neighbours[c][i], t.neighbours[d][k]);
            break;
        case 5:
            if (!t.hidden.empty()) {
                Hidden& h = t.hidden[at(random.below(static_cast<int>(t.hidden.size())))];
                (random.below(2) == 0 ? h.site : h.by) = random.below(n + 4) - 2;
            }
            break;
        case 6:
            t.cells[c][i] = std::numeric_limits<Index>::min() + random.below(3);
            break;
        case 7:
            t.dimension = random.below(6) - 2;
            break;
        default: {
            // Two sites exchanged throughout.
            const Index a = random.below(n);
            const Index b = random.below(n);
            for (auto& cell : t.cells)
                for (Index& v : cell) v = v == a ? b : v == b ? a : v;
        }
    }
}
/// Whether the changed arrays are still valid, which they are only if they say the same.
template <class T, class S>
void expect_judged(Random& random, const T& right, const std::vector<S>& sites, int& still_valid) {
    T t = right;
    for (int changes = 1 + random.below(3); changes > 0; --changes) change_somewhere(random, t);
    const Validation result = validate(t, std::span<const S>(sites));
    if (!result.valid) {
        ASSERT_NE(result.message, "");
        return;
    }
    ASSERT_EQ(meaning(t), meaning(right));
    ASSERT_EQ(result.canonical, t == right) << result.message;
    ++still_valid;
}

TEST(ValidateSpace, SurvivesAnything) {
    Random random(65);
    int still_valid = 0;
    for (int trial = 0; trial < 4000 * thoroughness; ++trial) {
        const int kind = random.below(3);
        Sites sites = in_space(random_sites<3>(random, 6 + random.below(10), 0.2));
        if (kind == 0)
            for (power::Site3& s : sites) s.z = s.y;
        if (kind == 1 && random.below(4) == 0)
            for (power::Site3& s : sites) s.y = s.z = 2.0 * s.x;
        ASSERT_NO_FATAL_FAILURE(expect_judged(random, tessellation_of(sites), sites, still_valid));
        if (trial % 4 != 0) continue;
        auto in_four = random_sites<4>(random, 6 + random.below(6), 0.2);
        if (kind == 0)
            for (auto& s : in_four) s.centre[2] = s.centre[0] + s.centre[1];
        ASSERT_NO_FATAL_FAILURE(
            expect_judged(random, triangulate<4>(in_four), in_four, still_valid));
    }
    EXPECT_GT(still_valid, 0);
}

TEST(ValidateSpace, StopsAndTellsHowFarItIs) {
    Random random(66);
    const Sites sites = in_space(random_sites<3>(random, 1000, 0.0));
    const SpaceTessellation t = tessellation_of(sites);
    std::stop_source source;
    source.request_stop();
    ValidationOptions options;
    options.stop = source.get_token();
    EXPECT_THROW(static_cast<void>(validate(t, std::span<const power::Site3>(sites), options)),
                 Stopped);
    options = {};
    double last = 0.0;
    options.progress = [&](double share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0);
        last = share;
    };
    EXPECT_TRUE(validate(t, std::span<const power::Site3>(sites), options).canonical);
    EXPECT_GT(last, 0.8);
    // Random sites are judged by the filters.
    const Validation result = judged(t, sites);
    EXPECT_GT(result.filtered, 10000U);
    EXPECT_LT(result.multiprecision, result.filtered / 100);
}

/// Nearly all signs of in_sphere are left open by the filter. Judging took five times the
/// construction when they were all of them dyadic numbers'.
TEST(ValidateSpace, TakesNoMuchLongerThanTheConstructionOfARoundedSphere) {
    if (!is_fast) GTEST_SKIP() << "a time of optimized code";
    Random g(9);
    std::vector<Point3> sites;
    for (int i = 0; i < 10000; ++i) {
        const double z = 2 * g.unit() - 1, angle = 7 * g.unit(), r = std::sqrt(1 - z * z);
        sites.push_back(
            {350 + 350 * r * std::cos(angle), 350 + 350 * r * std::sin(angle), 350 + 350 * z});
    }
    const auto seconds = [](const auto& work) {
        double least = HUGE_VAL;
        for (int run = 0; run < 5; ++run) {
            const auto begin = std::chrono::steady_clock::now();
            work();
            const std::chrono::duration<double> its = std::chrono::steady_clock::now() - begin;
            least = std::min(least, its.count());
        }
        return least;
    };
    const std::span<const Point3> all(sites);
    const SpaceTessellation tessellation = triangulate(all);
    Validation result;
    const double to_judge = seconds([&] { result = validate(tessellation, all); });
    EXPECT_TRUE(result.canonical) << result.message;
    EXPECT_GT(result.multiprecision, sites.size());
    EXPECT_LT(to_judge, 3 * seconds([&] { static_cast<void>(triangulate(all)); }));
}

}  // namespace
}  // namespace signum
