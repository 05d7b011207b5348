/// validate_finite() against the definition: no flat face, interiors apart, all of the hull
/// covered, every place a vertex, every circle empty. All in integers.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/ccw.hpp"
#include "../../predicates/space.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate_finite.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using Triangle = std::array<Index, 3>;
using Tetrahedron = std::array<Index, 4>;
using Integer = std::int64_t;

struct Place {
    Integer x;
    Integer y;
    Integer w = 0;
};

Integer turn(const Place& a, const Place& b, const Place& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
/// Above 0 inside, for a triangle that turns left.
Integer in_circle(const Place& a, const Place& b, const Place& c, const Place& q) {
    const auto row = [&](const Place& m) {
        const Integer x = m.x - q.x, y = m.y - q.y;
        return std::array<Integer, 3>{x, y, x * x + y * y - (m.w - q.w)};
    };
    const auto [ax, ay, az] = row(a);
    const auto [bx, by, bz] = row(b);
    const auto [cx, cy, cz] = row(c);
    return az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx);
}

/// Twice the area of the convex hull.
Integer area_of_hull(std::vector<Place> places) {
    std::ranges::sort(places, {}, [](const Place& p) { return std::pair(p.x, p.y); });
    std::vector<Place> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = hull.size();
        for (const Place& p : places) {
            while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(places);
    }
    Integer area = 0;
    for (std::size_t k = 0; k + 1 < hull.size(); ++k) area += turn(hull[0], hull[k], hull[k + 1]);
    return area;
}

/// Whether a line through a side of either has the two on different sides, or touches them.
bool are_apart(const std::array<Place, 3>& a, const std::array<Place, 3>& b) {
    const auto separates = [](const std::array<Place, 3>& one, const std::array<Place, 3>& other) {
        for (std::size_t k = 0; k < 3; ++k)
            if (std::ranges::all_of(
                    other, [&](const Place& p) { return turn(one[k], one[(k + 1) % 3], p) <= 0; }))
                return true;
        return false;
    };
    return separates(a, b) || separates(b, a);
}

bool is_triangulation(const std::vector<Triangle>& faces, const std::vector<Place>& places) {
    std::vector<std::array<Place, 3>> triangles;
    std::set<std::array<Integer, 3>> covered;
    std::map<std::pair<Integer, Integer>, std::set<Index>> used;
    Integer area = 0;
    for (const Triangle& face : faces) {
        std::array<Place, 3> t;
        for (std::size_t k = 0; k < 3; ++k) {
            if (face[k] < 0 || static_cast<std::size_t>(face[k]) >= places.size()) return false;
            t[k] = places[static_cast<std::size_t>(face[k])];
            covered.insert({t[k].x, t[k].y, t[k].w});
            used[{t[k].x, t[k].y}].insert(face[k]);
        }
        if (turn(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
        if (turn(t[0], t[1], t[2]) == 0) return false;
        area += turn(t[0], t[1], t[2]);
        triangles.push_back(t);
    }
    // Of equal sites one is the vertex.
    for (const auto& [place, sites] : used)
        if (sites.size() > 1) return false;
    for (std::size_t a = 0; a < triangles.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if (!are_apart(triangles[a], triangles[b])) return false;
    if (area != area_of_hull(places)) return false;
    for (const auto& t : triangles)
        for (const Place& q : places)
            if (in_circle(t[0], t[1], t[2], q) > 0) return false;
    // Of points all places are vertices; weights may hide some, also by a tie, which a site that is
    // none may be left to: it touches then a circle from above.
    const bool are_points = std::ranges::all_of(places, [](const Place& p) { return p.w == 0; });
    for (const Place& p : places)
        if (are_points && !covered.contains({p.x, p.y, p.w})) return false;
    return true;
}

/// One change that may or may not leave a triangulation.
void change(std::vector<Triangle>& faces, std::size_t sites, std::mt19937_64& random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    if (faces.empty()) return;
    const std::size_t f = below(faces.size());
    switch (below(6)) {
        case 0:
            faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(f));
            return;
        case 1:
            faces.push_back(faces[f]);
            return;
        case 2:
            faces[f][below(3)] = static_cast<Index>(below(sites));
            return;
        case 3:
            std::ranges::reverse(faces[f]);
            return;
        default:
            break;
    }
    // The diagonal of two faces that share an edge is exchanged.
    for (std::size_t g = 0; g < faces.size(); ++g) {
        std::vector<Index> shared;
        for (const Index i : faces[f])
            if (std::ranges::find(faces[g], i) != faces[g].end()) shared.push_back(i);
        if (g == f || shared.size() != 2) continue;
        const auto apex = [&](const Triangle& face) {
            return *std::ranges::find_if(face,
                                         [&](Index i) { return i != shared[0] && i != shared[1]; });
        };
        const Index a = apex(faces[f]);
        const Index b = apex(faces[g]);
        faces[f] = {a, b, shared[0]};
        faces[g] = {b, a, shared[1]};
        if (below(2) == 0) return;
    }
}

TEST(ValidateFinite, IsTheDefinition) {
    std::mt19937_64 random(1);
    int valid = 0;
    int not_valid = 0;
    for (int trial = 0; trial < (is_fast ? 6000 : 1500); ++trial) {
        const auto size = static_cast<Integer>(2 + random() % 4);
        const std::size_t count = 3 + random() % 9;
        const bool has_weights = trial % 4 == 3;
        std::vector<Place> places;
        std::vector<power::Site> weighted;
        std::vector<Point> points;
        for (std::size_t i = 0; i < count; ++i) {
            const auto coordinate = [&] { return static_cast<Integer>(random() % 5) % size; };
            const Place p{coordinate(), coordinate(),
                          has_weights ? static_cast<Integer>(random() % 5) - 2 : 0};
            places.push_back(p);
            points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
            weighted.push_back({points.back().x, points.back().y, static_cast<double>(p.w)});
        }
        const StridedSites sites = has_weights ? StridedSites(weighted) : StridedSites(points);
        std::vector<Triangle> faces;
        // Weights that differ by next to nothing decide ties in any way that there is.
        std::vector<power::Site> untied = weighted;
        for (power::Site& site : untied) site.w += 0x1p-60 * static_cast<double>(random() >> 44);
        const Tessellation whole = triangulate(StridedSites(untied), Power{});
        for (const Face& face : whole.faces())
            if (face[0] != infinite) faces.push_back(face);
        std::ranges::shuffle(faces, random);
        for (std::uint64_t changes = random() % 4; changes > 0; --changes)
            change(faces, count, random);
        const FiniteValidation judged = validate_finite(faces, sites);
        if (faces.empty()) {
            EXPECT_EQ(judged.valid, std::ranges::all_of(points, [&](const Point& p) {
                          return std::ranges::all_of(points, [&](const Point& q) {
                              return signum::ccw(points[0], p, q) == 0;
                          });
                      }));
            continue;
        }
        EXPECT_EQ(judged.valid, is_triangulation(faces, places))
            << "trial " << trial << ": " << judged.message;
        EXPECT_EQ(judged.valid, judged.message.empty()) << judged.message;
        (judged.valid ? valid : not_valid) += 1;
        if (HasFailure()) return;
    }
    EXPECT_GT(valid, 100);
    EXPECT_GT(not_valid, 100);
}

TEST(ValidateFinite, OfSpace) {
    std::mt19937_64 random(2);
    for (int trial = 0; trial < (is_fast ? 300 : 60); ++trial) {
        std::vector<Site3> sites;
        for (int i = 0; i < 30; ++i) {
            const auto coordinate = [&] { return static_cast<double>(random() % 4); };
            sites.push_back({coordinate(), coordinate(), coordinate(),
                             trial % 2 == 0 ? 0.0 : static_cast<double>(random() % 2)});
        }
        const SpaceTessellation whole = triangulate(std::span<const Site3>(sites));
        if (whole.dimension < 3) continue;
        std::vector<Tetrahedron> cells;
        for (const SpaceCell& cell : whole.cells)
            if (std::ranges::find(cell, infinite) == cell.end())
                cells.push_back({cell[0], cell[1], cell[2], cell[3]});
        std::ranges::shuffle(cells, random);
        for (Tetrahedron& cell : cells) std::ranges::shuffle(cell, random);
        const auto judge = [&] { return validate_finite(cells, std::span<const Site3>(sites)); };
        const FiniteValidation right = judge();
        ASSERT_TRUE(right.valid) << right.message;
        EXPECT_TRUE(right.faults.empty() && right.missing.empty());
        const std::vector<Tetrahedron> kept = cells;
        const std::size_t k = random() % cells.size();
        // One is missing, one is there twice, one has another vertex.
        cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(k));
        EXPECT_FALSE(judge().valid);
        cells = kept;
        cells.push_back(cells[k]);
        const FiniteValidation twice = judge();
        EXPECT_FALSE(twice.valid);
        EXPECT_TRUE(std::ranges::any_of(twice.faults, [&](const auto& fault) {
            return fault.face == static_cast<std::int64_t>(k) &&
                   fault.fault == FiniteFault::overlap;
        }));
        cells = kept;
        cells[k][random() % 4] = static_cast<Index>(random() % sites.size());
        if (cells[k] != kept[k]) {
            EXPECT_FALSE(judge().valid);
        }
    }
}

/// Five points of which two lie beyond a triangle of the others, which the line between them
/// crosses: two cells and three are both triangulations, and one of them is Delaunay's.
TEST(ValidateFinite, OfSpaceFindsConflicts) {
    std::mt19937_64 random(3);
    int asked = 0;
    while (asked < (is_fast ? 300 : 60)) {
        std::vector<Point3> p;
        for (int i = 0; i < 5; ++i) {
            const auto coordinate = [&] { return static_cast<double>(random() % 19) - 9.0; };
            p.push_back({coordinate(), coordinate(), coordinate()});
        }
        const auto turn = [&](int i, int j, int k, int l) {
            return ccw(p[static_cast<std::size_t>(i)], p[static_cast<std::size_t>(j)],
                       p[static_cast<std::size_t>(k)], p[static_cast<std::size_t>(l)]);
        };
        const int way = turn(0, 1, 3, 4);
        if (way == 0 || turn(1, 2, 3, 4) != way || turn(2, 0, 3, 4) != way ||
            turn(0, 1, 2, 3) * turn(0, 1, 2, 4) >= 0)
            continue;
        const Sign inside = turn(0, 1, 2, 3) * power::in_sphere(p[0], p[1], p[2], p[3], p[4]);
        if (inside == 0) continue;
        ++asked;
        const std::vector<Tetrahedron> two = {{0, 1, 2, 3}, {0, 1, 2, 4}};
        const std::vector<Tetrahedron> three = {{0, 1, 3, 4}, {1, 2, 3, 4}, {2, 0, 3, 4}};
        const FiniteValidation of_two = validate_finite(two, std::span<const Point3>(p));
        const FiniteValidation of_three = validate_finite(three, std::span<const Point3>(p));
        EXPECT_NE(of_two.valid, of_three.valid);
        for (const FiniteValidation& each : {of_two, of_three})
            for (const auto& fault : each.faults) EXPECT_EQ(fault.fault, FiniteFault::conflict);
    }
}

/// The middle of a square, on the lifted plane of its corners, may be a vertex or hidden.
TEST(ValidateFinite, LeavesTiesOfWeightsOpen) {
    std::vector<power::Site> sites = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {1, 1, -2}};
    const std::vector<Triangle> without = {{0, 1, 2}, {1, 3, 2}};
    const std::vector<Triangle> with = {{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}};
    EXPECT_TRUE(validate_finite(without, StridedSites(sites)).valid);
    EXPECT_TRUE(validate_finite(with, StridedSites(sites)).valid);
    for (const double weight : {-2.0 - 0x1p-51, -2.0 + 0x1p-51}) {
        sites[4].w = weight;
        EXPECT_EQ(validate_finite(without, StridedSites(sites)).valid, weight < -2.0);
        EXPECT_EQ(validate_finite(with, StridedSites(sites)).valid, weight > -2.0);
    }
}

TEST(ValidateFinite, SaysWhatIsWrong) {
    const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 0.5}};
    const auto message_of = [&](const std::vector<Triangle>& faces) {
        return validate_finite(faces, square).message;
    };
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {2, 1, 4}}), "");
    EXPECT_EQ(message_of({{1, 3, 2}, {3, 0, 1}, {2, 1, 4}}), "");
    EXPECT_EQ(message_of({{0, 1, 7}}),
              "face 0: there is no site 7 of 5, which are numbered from 0");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 3, 3}}), "face 1: site 3 is there twice");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {2, 1, 4}, {0, 1, 1}}),
              "face 3: site 1 is there twice");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}}),
              "site 4 is no vertex of any face, and should be one");
    EXPECT_EQ(message_of({{0, 1, 2}, {2, 1, 4}}),
              "site 3 is no vertex of any face, and should be one");
    EXPECT_EQ(message_of({}), "site 0 is no vertex of any face, and should be one");
    // The long diagonal.
    const FiniteValidation conflict =
        validate_finite(std::vector<Triangle>{{0, 1, 4}, {0, 4, 2}, {0, 2, 3}}, square);
    EXPECT_FALSE(conflict.valid);
    EXPECT_EQ(conflict.faults.size(), 2U);
    EXPECT_EQ(conflict.faults[0].fault, FiniteFault::conflict);
    EXPECT_EQ(conflict.message,
              "face 0: site 2 of face 1 lies in its circle, across their edge 0 4");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {2, 1, 4}, {0, 2, 4}}),
              "face 0: 3 faces share its edge 0 2");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 1, 3}, {2, 1, 4}}),
              "face 0: face 1 lies on the same side of their edge 0 1");
    const std::vector<Point> centred = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
    const FiniteValidation open =
        validate_finite(std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}, centred);
    EXPECT_EQ(open.message, "face 0: its edge 0 4 is on no other face, and not on the hull");
    ASSERT_EQ(open.open.size(), 2U);
    EXPECT_EQ(open.open[1].face, 2);
    EXPECT_EQ(open.open[1].between, (std::array<Index, 2>{3, 4}));
    EXPECT_EQ(validate_finite(std::vector<Triangle>{{0, 1, 7}}, square, {}, 1).message,
              "face 1: there is no site 8 of 5, which are numbered from 1");
    const std::vector<Point> line = {{0, 0}, {1, 0}, {2, 0}, {0, 1}};
    const FiniteValidation flat =
        validate_finite(std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}, {0, 1, 2}}, line);
    EXPECT_EQ(flat.message, "face 2: its sites lie on a line");
    EXPECT_EQ(flat.faults.size(), 1U) << "its neighbours are sound, however it is written";
    const std::vector<Point> in_a_row = {{0, 0}, {1, 1}, {2, 2}};
    EXPECT_TRUE(validate_finite(std::vector<Triangle>{}, in_a_row).valid);
    std::vector<Point> beyond = square;
    beyond[2].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(static_cast<void>(validate_finite(std::vector<Triangle>{{0, 1, 3}}, beyond)),
                 std::invalid_argument);
}

}  // namespace
}  // namespace signum
