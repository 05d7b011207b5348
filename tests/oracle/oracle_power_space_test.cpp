/// The oracle of the power metric in space against that of the plane, the volume of the hull, the
/// determinant of the in-sphere test with the derivative that breaks its ties, and weights that are
/// really reduced.

#include <gtest/gtest.h>
#include "linear_form.hpp"
#include "oracle_test_support.hpp"
#include "power.hpp"
#include "power_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace signum::oracle_test;
using signum::oracle::exactly;
using signum::oracle::no_site;
using signum::oracle::power_space;
using signum::oracle::Ranks;
using signum::oracle::Rational;
using signum::oracle::SpaceSite;
using signum::oracle::SpaceTessellation;
using signum::oracle::SpaceTuple;

template <int D>
using Sites = std::vector<SpaceSite<D>>;
using Row = std::vector<Rational>;
using Numbers = std::vector<std::size_t>;

template <int D>
Sites<D> lattice_sites(Random& random, int n, int range, int weights) {
    Sites<D> sites(static_cast<std::size_t>(n));
    for (auto& site : sites) {
        for (double& x : site.c) x = random.below(range);
        site.w = random.below(weights) - weights / 2;
    }
    return sites;
}

template <int D>
Sites<D> scattered_sites(Random& random, int n, double weight) {
    Sites<D> sites(static_cast<std::size_t>(n));
    for (auto& site : sites) {
        for (double& x : site.c) x = random.unit();
        site.w = random.unit() * weight;
    }
    return sites;
}

/// How many sites are looked at: fewer where there are more simplices.
template <int D>
int some_number(Random& random) {
    return 1 + random.below(D == 4 ? 8 : 9);
}

template <int D>
Ranks tie_order(const Sites<D>& sites) {
    Numbers order(sites.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return sites[a].w != sites[b].w ? sites[a].w > sites[b].w : sites[a].c < sites[b].c;
    });
    Ranks ranks(sites.size());
    for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = i;
    return ranks;
}

template <std::size_t N>
Numbers members(const std::array<std::int32_t, N>& tuple) {
    Numbers sites;
    for (const std::int32_t site : tuple)
        if (site != no_site) sites.push_back(static_cast<std::size_t>(site));
    return sites;
}

/// By elimination.
Rational determinant(std::vector<Row> rows) {
    Rational product = 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::size_t pivot = i;
        while (pivot < rows.size() && rows[pivot][i].is_zero()) ++pivot;
        if (pivot == rows.size()) return 0;
        if (pivot != i) std::swap(rows[pivot], rows[i]), product = -product;
        product *= rows[i][i];
        for (std::size_t j = i + 1; j < rows.size(); ++j) {
            const Rational factor = rows[j][i] / rows[i][i];
            for (std::size_t k = i; k < rows.size(); ++k) rows[j][k] -= factor * rows[i][k];
        }
    }
    return product;
}

template <int D>
Row centre(const SpaceSite<D>& site) {
    Row row;
    for (const double x : site.c) row.push_back(exactly(x));
    return row;
}

/// D! times the volume, with its sign.
Rational volume(const std::vector<Row>& corners) {
    std::vector<Row> rows;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        rows.push_back(corners[i]);
        for (std::size_t x = 0; x < rows.back().size(); ++x) rows.back()[x] -= corners[0][x];
    }
    return determinant(rows);
}

/// Every rising tuple of `size` numbers below `count`.
std::vector<Numbers> all_subsets(std::size_t count, std::size_t size) {
    std::vector<Numbers> found;
    for (unsigned mask = 0; mask < (1U << count); ++mask) {
        Numbers subset;
        for (std::size_t i = 0; i < count; ++i)
            if (mask >> i & 1U) subset.push_back(i);
        if (subset.size() == size) found.push_back(subset);
    }
    return found;
}

/// d! times the volume of the convex hull of points that span the space, without tessellating it:
/// pyramids over the facets, whose volumes are found in the same way one dimension below.
Rational hull_volume(const std::vector<Row>& points) {
    const std::size_t d = points[0].size();
    if (d == 1) {
        const auto [least, largest] = std::minmax_element(points.begin(), points.end());
        return (*largest)[0] - (*least)[0];
    }
    Rational sum = 0;
    std::set<Numbers> done;
    for (const Numbers& subset : all_subsets(points.size(), d)) {
        Row normal;  // the cofactors
        for (std::size_t x = 0; x < d; ++x) {
            std::vector<Row> corners;
            for (const std::size_t i : subset) {
                corners.push_back(points[i]);
                corners.back().erase(corners.back().begin() + static_cast<std::ptrdiff_t>(x));
            }
            normal.push_back(x % 2 == 0 ? volume(corners) : -volume(corners));
        }
        std::size_t seen_along = 0;
        while (seen_along < d && normal[seen_along].is_zero()) ++seen_along;
        if (seen_along == d) continue;
        const auto height = [&](const Row& p) {
            Rational dot = 0;
            for (std::size_t x = 0; x < d; ++x) dot += normal[x] * (p[x] - points[subset[0]][x]);
            return dot;
        };
        Numbers on;
        std::vector<Row> base;
        bool below = false, above = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const int side = height(points[i]).sign();
            below = below || side < 0, above = above || side > 0;
            if (side != 0) continue;
            on.push_back(i);
            base.push_back(points[i]);
            base.back().erase(base.back().begin() + static_cast<std::ptrdiff_t>(seen_along));
        }
        if ((below && above) || !done.insert(on).second) continue;
        sum += abs(Rational(height(points[0]) / normal[seen_along])) * hull_volume(base);
    }
    return sum;
}

/// What every tessellation is, whichever the weights.
template <int D>
void check_triangulation(const Sites<D>& sites, const SpaceTessellation<D>& t) {
    const auto k = static_cast<std::size_t>(t.dimension);
    std::set<std::size_t> visible, hidden;
    ASSERT_TRUE(std::is_sorted(t.cells.begin(), t.cells.end()));
    ASSERT_TRUE(std::is_sorted(t.facets.begin(), t.facets.end()));
    ASSERT_TRUE(std::is_sorted(t.hidden.begin(), t.hidden.end()));
    for (const auto& cell : t.cells) {
        const Numbers corners = members(cell);
        ASSERT_EQ(corners.size(), k + 1);
        ASSERT_TRUE(std::is_sorted(corners.begin(), corners.end()));
        visible.insert(corners.begin(), corners.end());
    }
    for (const auto& [site, by] : t.hidden) {
        ASSERT_TRUE(hidden.insert(static_cast<std::size_t>(site)).second);
        ASSERT_TRUE(visible.contains(static_cast<std::size_t>(by)));
        ASSERT_FALSE(visible.contains(static_cast<std::size_t>(site)));
    }
    ASSERT_EQ(visible.size() + hidden.size(), sites.size());
    if (t.dimension < D) return;

    std::vector<Row> points;
    for (const auto& site : sites) points.push_back(centre(site));
    Rational sum = 0;
    std::map<Numbers, std::vector<int>> sides;  // of the cells at a facet
    for (const auto& cell : t.cells) {
        const Numbers corners = members(cell);
        std::vector<Row> simplex;
        for (const std::size_t i : corners) simplex.push_back(points[i]);
        const Rational size = volume(simplex);
        ASSERT_EQ(size.sign(), signum::oracle::orientation<D>(sites, cell));
        ASSERT_NE(size.sign(), 0);
        sum += abs(size);
        for (std::size_t i = 0; i <= k; ++i) {
            Numbers facet = corners;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            sides[facet].push_back(i % 2 == 0 ? size.sign() : -size.sign());
        }
    }
    ASSERT_EQ(sum, hull_volume(points));
    std::set<Numbers> facets;
    for (const auto& [facet, signs] : sides) {
        ASSERT_LE(signs.size(), 2U);
        if (signs.size() == 2) {
            ASSERT_EQ(signs[0], -signs[1]) << "cells on the same side";
        } else {
            facets.insert(facet);
            for (const Row& point : points) {
                std::vector<Row> simplex{point};
                for (const std::size_t i : facet) simplex.push_back(points[i]);
                ASSERT_NE(volume(simplex).sign(), -signs[0]) << "a site beyond the hull";
            }
        }
    }
    std::set<Numbers> listed;
    for (const auto& facet : t.facets) listed.insert(members(facet));
    ASSERT_EQ(listed, facets);
    ASSERT_EQ(t.facets.size(), facets.size());
}

/// The tessellation in rationals alone: the k-th of n weights loses 2^-128(n-k). A simplex carries
/// an affine function that has the heights of its corners, found by elimination in all
/// coordinates; it is a cell where all other sites are above.
template <int D>
SpaceTessellation<D> really_reduced(const Sites<D>& sites, int dimension) {
    const Ranks ranks = tie_order(sites);
    std::vector<Rational> loss, height;
    for (std::size_t i = 0; i < sites.size(); ++i) {
        loss.push_back(1);
        for (std::size_t k = ranks[i]; k < sites.size(); ++k) loss[i] *= exactly(0x1p-128);
        height.push_back(loss[i] - exactly(sites[i].w));
        for (const Rational& x : centre(sites[i])) height[i] += x * x;
    }
    constexpr auto d = static_cast<std::size_t>(D);
    SpaceTessellation<D> result;
    result.dimension = dimension;
    std::set<std::int32_t> visible;
    for (const Numbers& simplex :
         all_subsets(sites.size(), static_cast<std::size_t>(dimension + 1))) {
        std::vector<Row> rows;
        for (const std::size_t i : simplex) {
            rows.push_back(centre(sites[i]));
            rows.back().push_back(1), rows.back().push_back(height[i]);
        }
        std::vector<std::size_t> pivots;
        for (std::size_t x = 0; x <= d && pivots.size() < rows.size(); ++x) {
            const std::size_t top = pivots.size();
            std::size_t found = top;
            while (found < rows.size() && rows[found][x].is_zero()) ++found;
            if (found == rows.size()) continue;
            std::swap(rows[top], rows[found]);
            const Rational pivot = rows[top][x];
            for (Rational& y : rows[top]) y /= pivot;
            for (std::size_t j = 0; j < rows.size(); ++j) {
                const Rational factor = rows[j][x];
                if (j == top || factor.is_zero()) continue;
                for (std::size_t y = 0; y < d + 2; ++y) rows[j][y] -= factor * rows[top][y];
            }
            pivots.push_back(x);
        }
        if (pivots.size() < rows.size()) continue;
        bool is_cell = true;
        for (std::size_t q = 0; q < sites.size() && is_cell; ++q) {
            if (std::find(simplex.begin(), simplex.end(), q) != simplex.end()) continue;
            Row at = centre(sites[q]);
            at.push_back(1);
            Rational plane = 0;
            for (std::size_t i = 0; i < pivots.size(); ++i) plane += rows[i][d + 1] * at[pivots[i]];
            EXPECT_NE(plane, height[q]);
            is_cell = plane < height[q];
        }
        if (!is_cell) continue;
        auto& cell = result.cells.emplace_back();
        cell.fill(no_site);
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            cell[i] = static_cast<std::int32_t>(simplex[i]);
            visible.insert(cell[i]);
        }
    }
    std::sort(result.cells.begin(), result.cells.end());
    for (std::size_t q = 0; q < sites.size(); ++q) {
        const auto number = static_cast<std::int32_t>(q);
        if (visible.contains(number)) continue;
        std::map<Rational, std::int32_t> nearest;
        for (const std::int32_t i : visible) {
            const auto& other = sites[static_cast<std::size_t>(i)];
            Rational distance = loss[static_cast<std::size_t>(i)] - exactly(other.w);
            for (std::size_t x = 0; x < d; ++x) {
                const Rational difference = exactly(sites[q].c[x]) - exactly(other.c[x]);
                distance += difference * difference;
            }
            nearest.emplace(distance, i);
        }
        result.hidden.push_back({number, nearest.begin()->second});
    }
    return result;
}

/// For sites that span the space: det[X_i, |X_i|² - w_i + w_q] over the sites of a positive simplex
/// relative to q, times (-1)^D, is positive where q is in conflict. Where it is 0, the last site in
/// the order whose derivative is not 0 decides; that weight has become less.
template <int D>
std::vector<SpaceTuple<D + 1>> cells_by_determinants(const Sites<D>& sites) {
    constexpr auto d = static_cast<std::size_t>(D);
    const Ranks ranks = tie_order(sites);
    const auto relative = [&](std::size_t i, std::size_t q) {
        Row row = centre(sites[i]);
        const Row origin = centre(sites[q]);
        for (std::size_t x = 0; x < d; ++x) row[x] -= origin[x];
        return row;
    };
    std::vector<SpaceTuple<D + 1>> cells;
    for (const Numbers& simplex : all_subsets(sites.size(), d + 1)) {
        SpaceTuple<D + 1> tuple{};
        for (std::size_t i = 0; i <= d; ++i) tuple[i] = static_cast<std::int32_t>(simplex[i]);
        const int side = signum::oracle::orientation<D>(sites, tuple) * (D % 2 == 0 ? 1 : -1);
        bool is_cell = side != 0;
        for (std::size_t q = 0; q < sites.size() && is_cell; ++q) {
            if (std::find(simplex.begin(), simplex.end(), q) != simplex.end()) continue;
            std::vector<Row> rows;
            for (const std::size_t i : simplex) {
                Row row = relative(i, q);
                Rational lift = exactly(sites[q].w) - exactly(sites[i].w);
                for (const Rational& x : row) lift += x * x;
                row.push_back(lift);
                rows.push_back(row);
            }
            int conflict = determinant(rows).sign() * side;
            if (conflict == 0) {
                std::map<std::size_t, int> lighter;  // by rank: the change as the weight falls
                const auto with_last_column = [&](auto entry) {
                    std::vector<Row> changed = rows;
                    for (std::size_t i = 0; i <= d; ++i) changed[i][d] = entry(i);
                    return determinant(changed).sign() * side;
                };
                lighter[ranks[q]] = with_last_column([](std::size_t) { return Rational(-1); });
                for (std::size_t m = 0; m <= d; ++m)
                    lighter[ranks[simplex[m]]] = with_last_column(
                        [&](std::size_t i) { return i == m ? Rational(1) : Rational(0); });
                for (const auto& [rank, sign] : lighter)
                    if (sign != 0) conflict = sign;
            }
            EXPECT_NE(conflict, 0);
            is_cell = conflict < 0;
        }
        if (is_cell) cells.push_back(tuple);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Site i gets the number names[i].
template <int D>
SpaceTessellation<D> renamed(SpaceTessellation<D> t, const Ranks& names) {
    const auto rename = [&](auto& tuples) {
        for (auto& tuple : tuples)
            for (auto& site : tuple)
                if (site != no_site)
                    site = static_cast<std::int32_t>(names[static_cast<std::size_t>(site)]);
    };
    const auto sort_corners = [](auto& tuples) {
        for (auto& tuple : tuples)
            std::sort(tuple.begin(), std::find(tuple.begin(), tuple.end(), no_site));
    };
    rename(t.cells), rename(t.facets), rename(t.hidden);
    sort_corners(t.cells), sort_corners(t.facets);
    std::sort(t.cells.begin(), t.cells.end());
    std::sort(t.facets.begin(), t.facets.end());
    std::sort(t.hidden.begin(), t.hidden.end());
    return t;
}

/// The same result with more room in its tuples.
template <int D, int E>
SpaceTessellation<D> widened(const SpaceTessellation<E>& t) {
    SpaceTessellation<D> wide;
    wide.dimension = t.dimension;
    wide.hidden = t.hidden;
    const auto copy = [](const auto& from, auto& to) {
        for (const auto& tuple : from) {
            auto& other = to.emplace_back();
            other.fill(no_site);
            std::copy(tuple.begin(), tuple.end(), other.begin());
        }
    };
    copy(t.cells, wide.cells), copy(t.facets, wide.facets);
    return wide;
}

template <class Check>
void in_every_dimension(Check check) {
    check.template operator()<1>();
    check.template operator()<2>();
    check.template operator()<3>();
    check.template operator()<4>();
}

TEST(OraclePowerSpace, ByHand) {
    EXPECT_EQ(power_space<3>({}), SpaceTessellation<3>{});
    const Sites<3> point{{{1, 2, 3}, 0}, {{1, 2, 3}, 0}, {{1, 2, 3}, -1}};
    EXPECT_EQ(power_space<3>(point),
              (SpaceTessellation<3>{0, {{0, no_site, no_site, no_site}}, {}, {{1, 0}, {2, 0}}}));
    const Sites<2> segment{{{0, 0}, 0}, {{2, 2}, 0}, {{1, 1}, -5}};  // the middle one is too light
    EXPECT_EQ(power_space<2>(segment),
              (SpaceTessellation<2>{1, {{0, 1, no_site}}, {{0, no_site}, {1, no_site}}, {{2, 0}}}));
    const Sites<3> simplex{
        {{0, 0, 0}, 0}, {{4, 0, 0}, 0}, {{0, 4, 0}, 0}, {{0, 0, 4}, 0}, {{1, 1, 1}, -9}};
    EXPECT_EQ(power_space<3>(simplex),
              (SpaceTessellation<3>{
                  3, {{0, 1, 2, 3}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}, {{4, 0}}}));
    EXPECT_EQ(signum::oracle::orientation<3>(simplex, {0, 1, 2, 3}), 1);
    EXPECT_EQ(signum::oracle::orientation<3>(simplex, {1, 0, 2, 3}), -1);
    EXPECT_EQ(signum::oracle::orientation<3>(simplex, {0, 1, 2, no_site}), 0);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(power_space<3>(Sites<3>{{{0, 0, infinity}, 0}}), std::invalid_argument);
    EXPECT_THROW(power_space<3>(Sites<3>{{{0, 0, 0}, infinity}}), std::invalid_argument);
}

TEST(OraclePowerSpace, ThePlane) {
    Random random(201);
    std::size_t hidden = 0;
    for (int i = 0; i < 900; ++i) {
        const int n = random.below(9);
        const auto sites =
            i % 3 == 0 ? scattered_sites<2>(random, n, 0.5)
                       : lattice_sites<2>(random, n, 1 + random.below(5), 1 + random.below(4));
        std::vector<signum::power::Site> plane;
        for (const auto& site : sites) plane.push_back({site.c[0], site.c[1], site.w});
        const auto expected = signum::oracle::power_weights(plane);
        const auto found = power_space<2>(sites);

        std::set<Numbers> cells, facets, found_cells, found_facets;
        for (Face face : expected.faces) {
            std::sort(face.begin(), face.end());
            Numbers corners;
            for (const std::int32_t site : face)
                if (site >= 0) corners.push_back(static_cast<std::size_t>(site));
            (corners.size() == 3 ? cells : facets).insert(corners);
        }
        if (found.dimension == 1) {  // the pairs of sites are the cells
            cells = std::move(facets);
            facets.clear();
            std::map<std::size_t, int> ends;
            for (const Numbers& pair : cells)
                for (const std::size_t site : pair) ++ends[site];
            for (const auto& [site, times] : ends)
                if (times == 1) facets.insert({site});
        }
        if (found.dimension == 0)
            for (const std::int32_t site : visible_sites(expected, sites.size()))
                cells.insert({static_cast<std::size_t>(site)});
        for (const auto& cell : found.cells) found_cells.insert(members(cell));
        for (const auto& facet : found.facets) found_facets.insert(members(facet));
        ASSERT_EQ(found_cells, cells) << "input " << i;
        ASSERT_EQ(found_facets, facets) << "input " << i;
        ASSERT_EQ(found.hidden, expected.hidden) << "input " << i;
        hidden += found.hidden.size();
    }
    EXPECT_GT(hidden, 500U);
}

TEST(OraclePowerSpace, Triangulations) {
    Random random(202);
    in_every_dimension([&]<int D>() {
        for (int i = 0; i < (D == 4 ? 120 : 250); ++i) {
            const int n = some_number<D>(random);
            const auto sites = i % 4 == 0 ? scattered_sites<D>(random, n, 0.3)
                                          : lattice_sites<D>(random, n, 2 + random.below(3),
                                                             1 + 2 * random.below(3));
            check_triangulation(sites, power_space<D>(sites));
            ASSERT_FALSE(testing::Test::HasFatalFailure()) << "dimension " << D << ", input " << i;
        }
    });
}

TEST(OraclePowerSpace, WeightsThatAreReallyReduced) {
    Random random(203);
    in_every_dimension([&]<int D>() {
        for (int i = 0; i < (D == 4 ? 120 : 250); ++i) {
            const auto sites = lattice_sites<D>(random, some_number<D>(random), 1 + random.below(3),
                                                1 + random.below(4));
            auto found = power_space<D>(sites);
            const auto expected = really_reduced(sites, found.dimension);
            found.facets.clear();
            ASSERT_EQ(found, expected) << "dimension " << D << ", input " << i;
        }
    });
}

TEST(OraclePowerSpace, FiveAndSixDimensions) {
    Random random(209);
    const auto check = [&]<int D>() {
        for (int i = 0; i < 25; ++i) {
            const auto sites = lattice_sites<D>(random, 3 + random.below(6), 1 + random.below(3),
                                                1 + random.below(4));
            auto found = power_space<D>(sites);
            const auto expected = really_reduced(sites, found.dimension);
            found.facets.clear();
            ASSERT_EQ(found, expected) << "dimension " << D << ", input " << i;
        }
    };
    check.operator()<5>();
    check.operator()<6>();
}

TEST(OraclePowerSpace, TheDerivativeOfTheDeterminantBreaksTies) {
    Random random(204);
    in_every_dimension([&]<int D>() {
        int spanning = 0;
        for (int i = 0; i < (D == 4 ? 120 : 200); ++i) {
            const auto sites = lattice_sites<D>(random, D == 4 ? 8 : some_number<D>(random),
                                                2 + random.below(2), 1 + random.below(4));
            const auto found = power_space<D>(sites);
            if (found.dimension < D) continue;
            ++spanning;
            ASSERT_EQ(found.cells, cells_by_determinants(sites)) << D << ", input " << i;
        }
        EXPECT_GT(spanning, 20) << D;
    });
}

TEST(OraclePowerSpace, PermutationsGiveTheSame) {
    Random random(205);
    in_every_dimension([&]<int D>() {
        for (int i = 0; i < 40; ++i) {
            const auto sites = lattice_sites<D>(random, some_number<D>(random), 3, 3);
            const auto other = shuffled(sites, random);
            ASSERT_EQ(renamed(power_space<D>(sites), tie_order(sites)),
                      renamed(power_space<D>(other), tie_order(other)))
                << "dimension " << D << ", input " << i;
        }
    });
}

TEST(OraclePowerSpace, OfEqualSitesTheFirstIsVisible) {
    Random random(206);
    in_every_dimension([&]<int D>() {
        for (int i = 0; i < 30; ++i) {
            auto sites = lattice_sites<D>(random, 4, 2, 1);
            for (std::size_t k = 0; k < 4; ++k) sites.push_back(sites[k]);
            const auto t = power_space<D>(sites);
            // Of equal weights, all different sites of {0, 1}^D are visible.
            std::set<std::size_t> hidden;
            for (const auto& pair : t.hidden) hidden.insert(static_cast<std::size_t>(pair[0]));
            for (std::size_t k = 0; k < sites.size(); ++k) {
                const auto first = std::find(sites.begin(), sites.end(), sites[k]) - sites.begin();
                ASSERT_EQ(hidden.contains(k), static_cast<std::size_t>(first) != k)
                    << D << ' ' << i;
                if (!hidden.contains(k)) continue;
                ASSERT_TRUE(std::binary_search(
                    t.hidden.begin(), t.hidden.end(),
                    std::array{static_cast<std::int32_t>(k), static_cast<std::int32_t>(first)}));
            }
        }
    });
}

/// Sites of E dimensions in a space of D, one coordinate after the other as `place` says.
template <int D, int E, class Place>
Sites<D> placed(const Sites<E>& sites, Place place) {
    Sites<D> result;
    for (const auto& site : sites) result.push_back({place(site.c), site.w});
    return result;
}

TEST(OraclePowerSpace, FlatSets) {
    Random random(207);
    for (int i = 0; i < 100; ++i) {
        const int n = random.below(8), range = 1 + random.below(4), weights = 1 + random.below(4);
        const auto line = lattice_sites<1>(random, n, range, weights);
        const auto on_line = power_space<1>(line);
        ASSERT_EQ(power_space<2>(placed<2>(line,
                                           [](auto c) {
                                               return std::array{7.0, c[0]};
                                           })),
                  widened<2>(on_line));
        ASSERT_EQ(power_space<4>(placed<4>(line,
                                           [](auto c) {
                                               return std::array{0., 1., c[0], 2.};
                                           })),
                  widened<4>(on_line));
        const auto plane = lattice_sites<2>(random, n, range, weights);
        const auto in_plane = power_space<2>(plane);
        ASSERT_EQ(power_space<3>(placed<3>(plane,
                                           [](auto c) {
                                               return std::array{c[0], c[1], 0.0};
                                           })),
                  widened<3>(in_plane));
        ASSERT_EQ(power_space<3>(placed<3>(plane,
                                           [](auto c) {
                                               return std::array{5.0, c[0], c[1]};
                                           })),
                  widened<3>(in_plane));
        const auto space = lattice_sites<3>(random, n, range, weights);
        ASSERT_EQ(power_space<4>(placed<4>(space,
                                           [](auto c) {
                                               return std::array{c[0], 3., c[1], c[2]};
                                           })),
                  widened<4>(power_space<3>(space)));

        // Aslant, with the height kept by the weight. The order of ties is no more the same, nor is
        // the nearest site.
        auto aslant = placed<3>(plane, [](auto c) {
            return std::array{c[0], c[1], c[0] + 2 * c[1]};
        });
        for (auto& site : aslant) site.w += site.c[2] * site.c[2];
        auto found = power_space<3>(aslant, tie_order(plane));
        auto expected = widened<3>(in_plane);
        for (auto* t : {&found, &expected})
            for (auto& pair : t->hidden) pair[1] = 0;
        ASSERT_EQ(found, expected) << "input " << i;
    }
}

TEST(OraclePowerSpace, Cubes) {
    in_every_dimension([&]<int D>() {
        constexpr auto d = static_cast<std::size_t>(D);
        Sites<D> cube(1U << D);
        for (std::size_t i = 0; i < cube.size(); ++i)
            for (std::size_t x = 0; x < d; ++x) cube[i].c[x] = (i >> (d - 1 - x) & 1U) != 0 ? 1 : 0;
        const auto t = power_space<D>(cube);
        check_triangulation(cube, t);
        EXPECT_TRUE(t.hidden.empty());
        if constexpr (D < 4) {
            EXPECT_EQ(t.cells, cells_by_determinants(cube));
        }
    });
}

TEST(OraclePowerSpace, Invariances) {
    Random random(208);
    in_every_dimension([&]<int D>() {
        for (int i = 0; i < 25; ++i) {
            const auto sites = lattice_sites<D>(random, some_number<D>(random), 4, 4);
            const auto expected = power_space<D>(sites);
            auto moved = sites, scaled = sites;
            for (auto& site : moved) {
                site.w += 17;
                for (double& x : site.c) x -= 1000;
            }
            for (auto& site : scaled) {
                site.w = std::ldexp(site.w, -1000);
                for (double& x : site.c) x = std::ldexp(x, -500);
            }
            ASSERT_EQ(power_space<D>(moved), expected) << "moved " << D << ' ' << i;
            ASSERT_EQ(power_space<D>(scaled), expected) << "scaled " << D << ' ' << i;
        }
    });
}

TEST(OraclePowerSpace, EveryFiniteDouble) {
    const double big = 1.7976931348623157e308, tiny = 4.9406564584124654e-324;
    const Sites<3> sites{{{-big, -big, -big}, big},
                         {{big, -big, -big}, -big},
                         {{0, big, -big}, tiny},
                         {{0, 0, big}, -tiny},
                         {{tiny, 0, -tiny}, 0}};
    const auto t = power_space<3>(sites);
    check_triangulation(sites, t);
    EXPECT_EQ(t.cells.size(), 4U);
    const Sites<3> small{
        {{0, 0, 0}, big}, {{tiny, 0, 0}, big}, {{0, tiny, 0}, big}, {{0, 0, tiny}, big}};
    EXPECT_EQ(power_space<3>(small).cells, (std::vector<SpaceTuple<4>>{{0, 1, 2, 3}}));
}

}  // namespace
