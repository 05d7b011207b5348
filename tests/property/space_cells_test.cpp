/// Cells of space in a box: lattices whose cells are known, few sites beside rationals, the laws of
/// many, whatever their places and weights; their polyhedra.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../oracle/power_cells.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using oracle_test::Random;
using Sites = std::vector<Site3>;

constexpr Box3 unit_box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};

template <class S>
SpaceCells cells_of(const std::vector<S>& sites, const Box3& box) {
    const std::span<const S> all(sites);
    return space_cells(triangulate(all), all, box);
}

std::vector<SpacePolyhedron> polyhedra_of(const Sites& sites, const Box3& box) {
    std::vector<Index> which(sites.size());
    std::iota(which.begin(), which.end(), 0);
    const std::span<const Site3> all(sites);
    return space_polyhedra(triangulate(all), all, box, which);
}

double volume_of(const Box3& box) {
    return (box.high.x - box.low.x) * (box.high.y - box.low.y) * (box.high.z - box.low.z);
}

/// Of the box's sides: the areas, and the whole surface.
std::array<double, 6> areas_of(const Box3& box) {
    const double x = box.high.x - box.low.x;
    const double y = box.high.y - box.low.y;
    const double z = box.high.z - box.low.z;
    return {y * z, y * z, x * z, x * z, x * y, x * y};
}

/// Laws 1, 2 and 4, the sums among them.
void expect_laws(const SpaceCells& cells, std::size_t sites, double tolerance = 1e-12) {
    ASSERT_EQ(cells.measures.size(), sites);
    ASSERT_EQ(cells.first_face.size(), sites + 1);
    ASSERT_EQ(cells.faces.size(), static_cast<std::size_t>(cells.first_face.back()));
    const std::array<double, 6> sides = areas_of(cells.box);
    const double surface = std::accumulate(sides.begin(), sides.end(), 0.0);
    double volume = 0.0;
    std::array<double, 6> on_sides{};
    std::map<std::pair<Index, Index>, double> areas;
    for (std::size_t s = 0; s < sites; ++s) {
        const auto i = static_cast<Index>(s);
        const SpaceMeasure& measure = cells.measures[s];
        ASSERT_GE(measure.volume, 0.0);
        ASSERT_TRUE(std::isfinite(measure.volume + measure.area));
        const auto& [x, y, z] = measure.centroid;
        ASSERT_TRUE(cells.box.low.x <= x && x <= cells.box.high.x);
        ASSERT_TRUE(cells.box.low.y <= y && y <= cells.box.high.y);
        ASSERT_TRUE(cells.box.low.z <= z && z <= cells.box.high.z);
        volume += measure.volume;
        double area = 0.0;
        const auto faces = cells.faces_of(i);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const auto& [beyond, each] = faces[f];
            ASSERT_GE(each, 0.0);
            area += each;
            if (f > 0) {
                const Index before = faces[f - 1].beyond;
                ASSERT_TRUE(beyond >= 0 ? before < beyond && before >= 0
                                        : before >= 0 || before > beyond);
            }
            if (beyond >= 0) {
                ASSERT_NE(beyond, i);
                areas[{i, beyond}] = each;
            } else {
                ASSERT_GE(beyond, -6);
                on_sides[static_cast<std::size_t>(-1 - beyond)] += each;
            }
        }
        ASSERT_NEAR(area, measure.area, 1e-14 * surface);
    }
    for (const auto& [pair, area] : areas) {
        const auto other = areas.find({pair.second, pair.first});
        ASSERT_NE(other, areas.end());
        ASSERT_EQ(other->second, area);
    }
    if (sites == 0) return;
    ASSERT_NEAR(volume, volume_of(cells.box), tolerance * volume_of(cells.box));
    for (std::size_t k = 0; k < 6; ++k) ASSERT_NEAR(on_sides[k], sides[k], tolerance * sides[k]);
}

/// The laws of polyhedra, and their measures beside those of the cells.
void expect_polyhedra(const std::vector<SpacePolyhedron>& polyhedra, const SpaceCells& cells,
                      double tolerance = 1e-9) {
    const double extent = std::cbrt(volume_of(cells.box));
    for (const SpacePolyhedron& each : polyhedra) {
        std::map<std::pair<Index, Index>, int> edges;
        double volume = 0.0;
        for (std::size_t f = 0; f < each.beyond.size(); ++f) {
            const auto loop = each.corners_of(f);
            ASSERT_GE(loop.size(), 3U);
            for (std::size_t k = 0; k < loop.size(); ++k)
                ++edges[{loop[k], loop[(k + 1) % loop.size()]}];
            const auto at = [&](std::size_t k) {
                return each.corners[static_cast<std::size_t>(loop[k])];
            };
            const Point3 o = each.corners[0];
            for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
                const Point3 a = {at(0).x - o.x, at(0).y - o.y, at(0).z - o.z};
                const Point3 b = {at(k).x - o.x, at(k).y - o.y, at(k).z - o.z};
                const Point3 c = {at(k + 1).x - o.x, at(k + 1).y - o.y, at(k + 1).z - o.z};
                volume += (a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
                           a.z * (b.x * c.y - b.y * c.x)) /
                          6;
            }
        }
        for (const auto& [edge, count] : edges) {
            ASSERT_EQ(count, 1) << each.site;
            ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << each.site;
        }
        // Euler: corners - edges + faces = 2.
        if (!each.corners.empty()) {
            ASSERT_EQ(each.corners.size() + each.beyond.size(), edges.size() / 2 + 2) << each.site;
        }
        const SpaceMeasure& measure = cells.measures[static_cast<std::size_t>(each.site)];
        ASSERT_NEAR(volume, measure.volume, tolerance * extent * extent * extent);
    }
}

// ---- lattices ----------------------------------------------------------------------------------

/// Cubes of a side with the given places in each, moved, in the box of that many cubes.
Sites lattice(int side, const std::vector<Point3>& places, double shift) {
    Sites sites;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            for (int z = 0; z < side; ++z)
                for (const Point3& p : places)
                    sites.push_back({x + p.x + shift, y + p.y + shift, z + p.z + shift, 0.0});
    return sites;
}

struct Lattice {
    const char* name;
    std::vector<Point3> places;
    double volume;
    std::vector<double> areas;  ///< rising
};

TEST(SpaceCells, Lattices) {
    const double hexagon = 3.0 * std::sqrt(3.0) / 16.0;
    const double rhombus = std::sqrt(2.0) / 8.0;
    std::vector<double> truncated_octahedron(6, 0.125);
    truncated_octahedron.insert(truncated_octahedron.end(), 8, hexagon);
    const std::vector<Lattice> lattices = {
        {"cubic", {{0, 0, 0}}, 1.0, std::vector<double>(6, 1.0)},
        {"body-centred", {{0, 0, 0}, {0.5, 0.5, 0.5}}, 0.5, truncated_octahedron},
        {"face-centred",
         {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}},
         0.25,
         std::vector<double>(12, rhombus)}};
    constexpr int side = 5;
    for (const Lattice& each : lattices)
        // Where cells lie in the box's sides, where they are halved by them, and neither.
        for (const double shift : {0.5, 0.0, 0.125, 0.1}) {
            const Sites sites = lattice(side, each.places, shift);
            const Box3 box = {{0, 0, 0}, {side, side, side}};
            const SpaceCells cells = cells_of(sites, box);
            ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size()));
            ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, box), cells));
            int inside = 0;
            for (std::size_t s = 0; s < sites.size(); ++s) {
                const auto is_within = [&](double x) { return x > 1.4 && x < side - 1.4; };
                if (!is_within(sites[s].x) || !is_within(sites[s].y) || !is_within(sites[s].z))
                    continue;
                ++inside;
                std::vector<double> areas;
                for (const SpaceFace& face : cells.faces_of(static_cast<Index>(s)))
                    areas.push_back(face.area);
                std::ranges::sort(areas);
                ASSERT_EQ(areas.size(), each.areas.size()) << each.name << " " << shift;
                for (std::size_t f = 0; f < areas.size(); ++f)
                    ASSERT_NEAR(areas[f], each.areas[f], 1e-13) << each.name;
                const SpaceMeasure& measure = cells.measures[s];
                ASSERT_NEAR(measure.volume, each.volume, 1e-13) << each.name;
                ASSERT_NEAR(measure.centroid.x, sites[s].x, 1e-13);
                ASSERT_NEAR(measure.centroid.y, sites[s].y, 1e-13);
                ASSERT_NEAR(measure.centroid.z, sites[s].z, 1e-13);
            }
            EXPECT_GE(inside, 8) << each.name;
        }
}

TEST(SpaceCells, ACubicLatticeInABoxOfItsCells) {
    const Sites sites = lattice(4, {{0, 0, 0}}, 0.5);
    const SpaceCells cells = cells_of(sites, {{0, 0, 0}, {4, 4, 4}});
    for (std::size_t s = 0; s < sites.size(); ++s) {
        ASSERT_NEAR(cells.measures[s].volume, 1.0, 1e-15);
        ASSERT_EQ(cells.faces_of(static_cast<Index>(s)).size(), 6U);
    }
    // One layer of cells lies outside, and touches the box.
    const SpaceCells part = cells_of(sites, {{1, 0, 0}, {4, 4, 4}});
    ASSERT_NO_FATAL_FAILURE(expect_laws(part, sites.size()));
    for (std::size_t s = 0; s < sites.size(); ++s) {
        const bool is_outside = sites[s].x < 1.0;
        ASSERT_NEAR(part.measures[s].volume, is_outside ? 0.0 : 1.0, 1e-15);
        ASSERT_EQ(part.faces_of(static_cast<Index>(s)).size(), is_outside ? 0U : 6U);
    }
}

TEST(SpaceCells, PerturbedLattices) {
    std::mt19937_64 random(7);
    for (const double most : {1e-16, 1e-15, 1e-13, 1e-10, 1e-8, 1e-6, 1e-3}) {
        Sites sites = lattice(6, {{0, 0, 0}, {0.5, 0.5, 0.5}}, 0.25);
        for (Site3& s : sites)
            for (double Site3::*const axis : {&Site3::x, &Site3::y, &Site3::z})
                s.*axis += most * (std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0);
        const Box3 box = {{0, 0, 0}, {6, 6, 6}};
        const SpaceCells cells = cells_of(sites, box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << most;
        ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, box), cells)) << most;
        for (std::size_t s = 0; s < sites.size(); ++s) {
            const auto is_within = [](double x) { return x > 1 && x < 5; };
            if (is_within(sites[s].x) && is_within(sites[s].y) && is_within(sites[s].z)) {
                ASSERT_NEAR(cells.measures[s].volume, 0.5, 1e-12 + 10 * most);
            }
        }
    }
}

// ---- few sites beside rationals ----------------------------------------------------------------

struct Trial {
    Sites sites;
    Box3 box;
};

Trial small_trial(Random& random) {
    const int kind = random.below(5);
    const auto one = [&] {
        switch (kind) {
            case 0:
                return 1.0 * random.below(3);
            case 1:
                return 0.5 * random.below(4);
            case 2:
                return 0.1 * random.below(6);
            default:
                return random.unit();
        }
    };
    Trial trial;
    const int flat = random.below(8);
    const int weights = random.below(3);
    for (int n = random.below(7); n >= 0; --n) {
        Site3 s{one(), one(), one(), 0.0};
        if (flat <= 2) s.z = flat == 0 ? 0.5 : flat == 1 ? s.x : s.x + s.y;
        if (flat == 1 || flat == 3) s.y = 2.0 * s.x;
        if (flat == 3) s.z = s.x;
        if (flat == 4 && random.below(2) == 0 && !trial.sites.empty()) s = trial.sites.front();
        if (weights == 1) s.r = 0.5 * random.below(3);
        if (weights == 2) s.r = 0.5 * random.unit();
        trial.sites.push_back(s);
    }
    const double from = random.below(2) == 0 ? -0.5 : 0.0;
    const double to = random.below(2) == 0 ? 1.0 : 2.0;
    trial.box = {{from, from, from}, {to, to, random.below(2) == 0 ? 0.75 : to}};
    return trial;
}

TEST(SpaceCells, AsInRationals) {
    Random random(41);
    int compared = 0;
    int hidden = 0;
    std::array<int, 5> dimensions{};
    for (int trial = 0; trial < 60 * thoroughness; ++trial) {
        const auto [sites, box] = small_trial(random);
        const SpaceTessellation tessellation = triangulate(std::span<const Site3>(sites));
        const SpaceCells cells = space_cells(tessellation, std::span<const Site3>(sites), box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << trial;
        ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, box), cells)) << trial;
        ++dimensions[static_cast<std::size_t>(tessellation.dimension + 1)];
        // Who is hidden is not at issue here.
        std::vector<bool> is_hidden(sites.size(), false);
        for (const Hidden& each : tessellation.hidden) {
            is_hidden[static_cast<std::size_t>(each.site)] = true;
            ASSERT_TRUE(cells.faces_of(each.site).empty());
            ++hidden;
        }
        std::vector<oracle::WeighedPoint> plain;
        std::vector<Index> names;
        for (std::size_t s = 0; s < sites.size(); ++s) {
            if (is_hidden[s]) continue;
            const mpq_class r = sites[s].r;
            plain.push_back({{sites[s].x, sites[s].y, sites[s].z}, r * r});
            names.push_back(static_cast<Index>(s));
        }
        const auto expected = oracle::power_cells(plain, {box.low.x, box.low.y, box.low.z},
                                                  {box.high.x, box.high.y, box.high.z});
        for (std::size_t k = 0; k < plain.size(); ++k) {
            const SpaceMeasure& measure = cells.measures[static_cast<std::size_t>(names[k])];
            ASSERT_NEAR(measure.volume, expected[k].volume.get_d(), 1e-13 * volume_of(box));
        }
        // A flat cell, visible by the tie rule alone, lies between two that the planes say touch.
        const bool has_flat = std::ranges::any_of(expected, [](const oracle::PowerCell& cell) {
            return std::ranges::any_of(cell.faces, [](const oracle::CellFace& face) {
                return std::ranges::count_if(face.beyond, [](auto b) { return b >= 0; }) > 1;
            });
        });
        if (has_flat) continue;
        for (std::size_t k = 0; k < plain.size(); ++k) {
            std::vector<SpaceFace> faces;
            if (expected[k].volume != 0)
                for (const oracle::CellFace& face : expected[k].faces) {
                    // In a side of the box a face is the side's.
                    const auto beyond = *std::ranges::min_element(face.beyond);
                    faces.push_back(
                        {beyond < 0 ? beyond : names[static_cast<std::size_t>(beyond)], face.area});
                }
            std::ranges::sort(faces, {}, &SpaceFace::beyond);
            const auto listed = cells.faces_of(names[k]);
            std::vector<SpaceFace> found(listed.begin(), listed.end());
            std::ranges::sort(found, {}, &SpaceFace::beyond);
            // What rounding of coordinates makes is none.
            std::erase_if(faces, [](const SpaceFace& face) { return face.area < 1e-13; });
            ASSERT_EQ(found.size(), faces.size()) << trial << " site " << names[k];
            for (std::size_t f = 0; f < faces.size(); ++f) {
                ASSERT_EQ(found[f].beyond, faces[f].beyond) << trial << " site " << names[k];
                ASSERT_NEAR(found[f].area, faces[f].area, 1e-13 * volume_of(box)) << trial;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 800 * thoroughness);
    EXPECT_GT(hidden, 20 * thoroughness);
    for (std::size_t d = 1; d < 5; ++d) EXPECT_GT(dimensions[d], thoroughness) << d;
}

// ---- planes that nearly coincide ---------------------------------------------------------------

double moved_by_ulps(double x, int count) {
    for (; count > 0; --count) x = std::nextafter(x, HUGE_VAL);
    for (; count < 0; ++count) x = std::nextafter(x, -HUGE_VAL);
    return x;
}

constexpr int hostile_kinds = 12;

Sites hostile_sites(Random& random, int kind, int count) {
    const double near = std::ldexp(1.0, -random.below(55));
    const double greatest = 0.2 * random.below(3);
    const double slope = random.below(3) == 0 ? 0.5 * random.below(3) : random.unit() - 0.5;
    const auto ulps = [&](double x, int most) {
        return moved_by_ulps(x, random.below(2 * most + 1) - most);
    };
    Sites sites;
    for (int i = 0; i < count; ++i) {
        Site3 s{random.unit(), random.unit(), random.unit(), greatest * random.unit()};
        const double angle = 6.3 * s.x;
        switch (kind) {
            case 0:  // nearly in a plane
                s.z = 0.5 + slope * (s.x + s.y - 1) + near * (s.z - 0.5);
                break;
            case 1:  // a few roundings apart
                if (i > 0 && random.below(5) > 0) {
                    s = sites[static_cast<std::size_t>(random.below(i))];
                    s = {ulps(s.x, 2), ulps(s.y, 2), ulps(s.z, 2), s.r};
                }
                break;
            case 2:  // in sheets
                s.z = 0.25 * random.below(3) + near * s.z;
                break;
            case 3:  // mirrored at sides of the box
                if (i % 2 != 0) {
                    s = sites.back();
                    if (i % 4 == 1) s.x = ulps((i % 8 == 1 ? 0.0 : 2.0) - s.x, 3);
                    if (i % 4 == 3) s.z = ulps((i % 8 == 3 ? 0.0 : 2.0) - s.z, 3);
                }
                break;
            case 4:  // of a lattice, moved by roundings
                s = {ulps(0.1 * random.below(8), 2), ulps(0.1 * random.below(8), 1),
                     ulps(0.1 * random.below(8), 1), 0.0};
                break;
            case 5:  // of weights far larger than the box
                s.r = 1e6 * random.unit();
                break;
            case 6:
                s.r = 1e3 * (1 + near * random.unit());
                break;
            case 7:  // a cluster
                s = {0.5 + 1e-9 * s.x, 0.5 + 1e-9 * s.y, 0.5 + 1e-9 * s.z, 0.0};
                break;
            case 8:  // a cluster in a corner, and one that is nearly a point
                if (i % 2 == 0) s = {0.5 + 1e-9 * s.x, 1e-9 * s.y, 1e-9 * s.z, 1e-9 * s.r};
                if (i % 4 == 1) s = {0.25, 0.25, 0.25 + 1e-12 * s.z, 0.0};
                break;
            case 9:  // nearly on a line
                s = {near * (s.x - 0.5), slope * near * (s.x - 0.5), 0.5 + 1e-8 * near * s.z, s.r};
                break;
            case 10:  // nearly on a circle
                s = {0.5 + 0.4 * std::cos(angle), 0.5 + 0.4 * std::sin(angle), 0.5 + near * s.z,
                     0.0};
                break;
            default:  // of a lattice, nearly
                s = {0.5 * random.below(3) + near * s.x, 0.5 * random.below(3) + near * s.y,
                     0.5 * random.below(3) + near * s.z, greatest * (1 + near * random.unit())};
        }
        sites.push_back(s);
    }
    return sites;
}

/// Some have sides that nearly lie in bisecting planes, some are small beside the sites' distances.
Box3 hostile_box(Random& random, const Sites& sites) {
    const auto ulps = [&](double x) { return moved_by_ulps(x, random.below(5) - 2); };
    const double half = std::ldexp(1.0, -random.below(30));
    const Site3& a = sites.front();
    const Site3& b = sites.back();
    const Point3 low = {ulps((a.x + b.x) / 2), ulps((a.y + b.y) / 2), ulps((a.z + b.z) / 2)};
    switch (random.below(5)) {
        case 0:
            return {{-0.3, 0.1, 0.2}, {1.1, 0.77, 0.9}};
        case 1:
            return {low, {low.x + 1, low.y + 1, low.z + 1}};
        case 2:
            return {{0.5 - half, 0.5 - half, 0.5 - half}, {0.5 + half, 0.5 + half, 0.5 + half}};
        case 3:
            return {{ulps(0.05), ulps(0.15), 0.0}, {ulps(0.55), 0.75, ulps(0.65)}};
        default:
            return unit_box;
    }
}

TEST(SpaceCells, PlanesThatNearlyCoincide) {
    Random random(13);
    for (int trial = 0; trial < 12 * hostile_kinds * thoroughness; ++trial) {
        const Sites sites = hostile_sites(random, trial % hostile_kinds, 2 + random.below(40));
        const Box3 box = hostile_box(random, sites);
        const SpaceCells cells = cells_of(sites, box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << trial;
        // A small box's corners have the digits that its coordinates have.
        const double width = box.high.x - box.low.x;
        ASSERT_NO_FATAL_FAILURE(
            expect_polyhedra(polyhedra_of(sites, box), cells, 1e-11 + 1e-14 / width))
            << trial;
    }
}

TEST(SpaceCells, PlanesThatNearlyCoincideAsInRationals) {
    Random random(14);
    for (int trial = 0; trial < 5 * hostile_kinds * thoroughness; ++trial) {
        const Sites sites = hostile_sites(random, trial % hostile_kinds, 2 + random.below(5));
        const Box3 box = hostile_box(random, sites);
        const SpaceTessellation tessellation = triangulate(std::span<const Site3>(sites));
        const SpaceCells cells = space_cells(tessellation, std::span<const Site3>(sites), box);
        std::vector<bool> is_hidden(sites.size(), false);
        for (const Hidden& each : tessellation.hidden)
            is_hidden[static_cast<std::size_t>(each.site)] = true;
        std::vector<oracle::WeighedPoint> plain;
        std::vector<std::size_t> names;
        for (std::size_t s = 0; s < sites.size(); ++s) {
            if (is_hidden[s]) continue;
            const mpq_class r = sites[s].r;
            plain.push_back({{sites[s].x, sites[s].y, sites[s].z}, r * r});
            names.push_back(s);
        }
        const auto expected = oracle::power_cells(plain, {box.low.x, box.low.y, box.low.z},
                                                  {box.high.x, box.high.y, box.high.z});
        for (std::size_t k = 0; k < plain.size(); ++k)
            ASSERT_NEAR(cells.measures[names[k]].volume, expected[k].volume.get_d(),
                        1e-13 * volume_of(box))
                << trial;
    }
}

// ---- many sites --------------------------------------------------------------------------------

Sites balls(int count, double greatest, std::uint64_t seed) {
    Random random(seed);
    Sites sites;
    for (int i = 0; i < count; ++i)
        sites.push_back({random.unit(), random.unit(), random.unit(), greatest * random.unit()});
    return sites;
}

const int many = is_fast ? 3000 : 500;

TEST(SpaceCells, ManyTileTheBox) {
    for (const double greatest : {0.0, 0.05, 0.3})
        // The box of the sites, one that most lie outside of, and one around all.
        for (const Box3& box : {unit_box, Box3{{0.31, 0.28, 0.4}, {0.52, 0.83, 0.43}},
                                Box3{{-3, -2, -1}, {2, 3, 70}}}) {
            const Sites sites = balls(many, greatest, 3);
            const SpaceCells cells = cells_of(sites, box);
            ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size()));
            ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, box), cells));
        }
}

TEST(SpaceCells, SpheresPlanesAndLines) {
    Random random(8);
    for (int kind = 0; kind < 6; ++kind) {
        Sites sites;
        for (int i = 0; i < many / 4; ++i) {
            const double u = random.unit();
            const double v = random.unit();
            const double z = 2 * u - 1;
            const double r = std::sqrt(1 - z * z);
            const Site3 of_kind[6] = {
                // Nearly cospherical, in a plane, there with weights, on a line, two clusters, and
                // all in one place.
                {0.5 + 0.3 * r * std::cos(7 * v), 0.5 + 0.3 * r * std::sin(7 * v), 0.5 + 0.3 * z,
                 0},
                {u, v, u + v, 0},
                {u, 0.25, v, 0.1 * random.unit()},
                {u, 2 * u, 0.5 * u, 0.01 * random.unit()},
                {i % 2 == 0 ? 1e-7 * u : 1 - 1e-7 * u, 1e-7 * v, 1e-7 * random.unit(), 0},
                {0.25, 0.5, 0.75, 0.01 * (i % 3)}};
            sites.push_back(of_kind[kind]);
        }
        const SpaceCells cells = cells_of(sites, unit_box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << kind;
        ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, unit_box), cells)) << kind;
    }
}

/// The first site has a face with nearly all others, which lie around it on a sphere or a circle.
enum class Hub { amid_balls, in_a_plane, above_a_circle, in_a_crowd };
Sites hub(Hub kind, int count) {
    Random random(15);
    Sites sites = {{0.5, 0.5, 0.5, kind == Hub::amid_balls ? 0.2 : 0.0}};
    if (kind == Hub::above_a_circle) sites[0].z = 0.75;
    const bool is_crowd = kind == Hub::in_a_crowd;
    const bool is_sphere = is_crowd || kind == Hub::amid_balls;
    for (int i = 0; i < count; ++i) {
        const double z = is_sphere ? 2 * random.unit() - 1 : 0.0;
        const double angle = 6.2831853 * random.unit();
        const double radius = is_crowd ? 0x1p-38 : 0.4;
        const double r = radius * std::sqrt(1 - z * z);
        sites.push_back({0.5 + r * std::cos(angle), 0.5 + r * std::sin(angle), 0.5 + radius * z,
                         kind == Hub::amid_balls ? 0.001 * random.unit() : 0.0});
    }
    return sites;
}

TEST(SpaceCells, AHub) {
    for (const Hub kind :
         {Hub::amid_balls, Hub::in_a_plane, Hub::above_a_circle, Hub::in_a_crowd}) {
        const Sites sites = hub(kind, many);
        const auto number = static_cast<int>(kind);
        const SpaceCells cells = cells_of(sites, unit_box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << number;
        // Of those of a circle some lie within it by rounding, and of the crowd within the sphere.
        EXPECT_GT(cells.faces_of(0).size(), sites.size() / 4) << number;
        ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, unit_box), cells)) << number;
    }
}

TEST(SpaceCells, CornersOfACrowdThatAreNearAreOne) {
    const Sites sites = hub(Hub::in_a_crowd, many);
    const SpacePolyhedron cell = polyhedra_of(sites, unit_box).front();
    // Where three planes meet a corner would have three edges.
    EXPECT_LT(cell.corners.size(), 2 * cell.beyond.size() - 4);
    constexpr double near = 0.9 * 0x1p-47;
    for (std::size_t k = 0; k < cell.corners.size(); ++k)
        for (std::size_t m = 0; m < k; ++m) {
            const Point3& p = cell.corners[k];
            const Point3& q = cell.corners[m];
            ASSERT_GT(std::max({std::fabs(p.x - q.x), std::fabs(p.y - q.y), std::fabs(p.z - q.z)}),
                      near);
        }
}

TEST(SpaceCells, NearlyCoplanarAndCocircular) {
    // Rounded to doubles four of these are neither, and a face is narrower than rounding.
    const Sites sites = {{0.1, 0.5, 0.4, 0}, {0.1 + 0.2, 0.1 + 0.2, 0.4, 0}, {0.5, 0.5, 0.5, 0},
                         {0.4, 0.1, 0.5, 0}, {0.1 + 0.2, 0.1, 0.2, 0},       {0.5, 0.0, 0.0, 0}};
    const Box3 box = {{-0.5, -0.5, -0.5}, {2, 2, 2}};
    const SpaceCells cells = cells_of(sites, box);
    ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size()));
    ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, box), cells));
}

TEST(SpaceCells, NoSiteAndOne) {
    const SpaceCells none = cells_of(Sites{}, unit_box);
    ASSERT_NO_FATAL_FAILURE(expect_laws(none, 0));
    for (const Point3& place : {Point3{0.5, 0.25, 0.125}, Point3{7.0, -3.0, 1e6}}) {
        const SpaceCells one = cells_of(std::vector<Point3>{place}, unit_box);
        ASSERT_NO_FATAL_FAILURE(expect_laws(one, 1));
        ASSERT_EQ(one.measures[0].volume, 1.0);
        ASSERT_EQ(one.measures[0].centroid, (Point3{0.5, 0.5, 0.5}));
        std::vector<SpaceFace> sides;
        for (Index side = -1; side >= -6; --side) sides.push_back({side, 1.0});
        ASSERT_EQ(one.faces, sides);
    }
}

TEST(SpaceCells, TheOrderOfTheInputDoesNotMatter) {
    for (const double greatest : {0.0, 0.1}) {
        const Sites sites = balls(many / 4, greatest, 5);
        const SpaceCells cells = cells_of(sites, unit_box);
        std::vector<std::size_t> order(sites.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::shuffle(order.begin(), order.end(), std::mt19937_64(6));
        Sites shuffled;
        for (const std::size_t s : order) shuffled.push_back(sites[s]);
        const SpaceCells others = cells_of(shuffled, unit_box);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const SpaceMeasure& one = cells.measures[order[k]];
            const SpaceMeasure& other = others.measures[k];
            ASSERT_NEAR(one.volume, other.volume, 1e-16);
            ASSERT_NEAR(one.area, other.area, 1e-15);
            std::vector<Index> neighbours;
            for (const SpaceFace& face : others.faces_of(static_cast<Index>(k)))
                neighbours.push_back(
                    face.beyond < 0
                        ? face.beyond
                        : static_cast<Index>(order[static_cast<std::size_t>(face.beyond)]));
            std::vector<Index> expected;
            for (const SpaceFace& face : cells.faces_of(static_cast<Index>(order[k])))
                expected.push_back(face.beyond);
            std::ranges::sort(neighbours);
            std::ranges::sort(expected);
            ASSERT_EQ(neighbours, expected);
        }
    }
}

TEST(SpaceCells, ScalingByPowersOfTwoIsExact) {
    const Sites sites = balls(many / 4, 0.1, 9);
    const SpaceCells cells = cells_of(sites, unit_box);
    for (const int exponent : {-320, -100, 1, 100, 320}) {
        const auto times = [&](double x, int lengths) { return std::ldexp(x, lengths * exponent); };
        Sites scaled;
        for (const Site3& s : sites)
            scaled.push_back({times(s.x, 1), times(s.y, 1), times(s.z, 1), times(s.r, 1)});
        const Box3 box = {{0, 0, 0}, {times(1, 1), times(1, 1), times(1, 1)}};
        const SpaceCells others = cells_of(scaled, box);
        ASSERT_EQ(others.faces.size(), cells.faces.size());
        for (std::size_t s = 0; s < sites.size(); ++s) {
            ASSERT_EQ(others.measures[s].volume, times(cells.measures[s].volume, 3));
            ASSERT_EQ(others.measures[s].area, times(cells.measures[s].area, 2));
            ASSERT_EQ(others.measures[s].centroid.x, times(cells.measures[s].centroid.x, 1));
        }
        for (std::size_t f = 0; f < cells.faces.size(); ++f) {
            ASSERT_EQ(others.faces[f].beyond, cells.faces[f].beyond);
            ASSERT_EQ(others.faces[f].area, times(cells.faces[f].area, 2));
        }
    }
}

TEST(SpaceCells, FarFromTheOriginNothingIsLost) {
    // Multiples of 2^-30, so that they can be moved exactly.
    const Sites sites = balls(many / 4, 0.0, 10);
    const SpaceCells cells = cells_of(sites, unit_box);
    constexpr double far = 0x1p22;
    Sites moved = sites;
    for (Site3& s : moved) s = {s.x + far, s.y - far, s.z + far / 2, s.r};
    const SpaceCells others =
        cells_of(moved, {{far, -far, far / 2}, {far + 1, 1 - far, far / 2 + 1}});
    ASSERT_NO_FATAL_FAILURE(expect_laws(others, sites.size()));
    for (std::size_t s = 0; s < sites.size(); ++s)
        ASSERT_NEAR(others.measures[s].volume, cells.measures[s].volume, 1e-16);
}

TEST(SpaceCells, KindsOfSitesAndOneWeightForAll) {
    const Sites sites = balls(many / 8, 0.0, 11);
    std::vector<Point3> points;
    std::vector<power::Site3> weights;
    std::vector<power::Site3> heavy;
    for (const Site3& s : sites) {
        points.push_back({s.x, s.y, s.z});
        weights.push_back({s.x, s.y, s.z, 0.0});
        heavy.push_back({s.x, s.y, s.z, 1e12});
    }
    const SpaceCells cells = cells_of(sites, unit_box);
    EXPECT_EQ(cells_of(points, unit_box), cells);
    EXPECT_EQ(cells_of(weights, unit_box), cells);
    EXPECT_EQ(cells_of(heavy, unit_box), cells);
}

bool have_a_face(const SpaceCells& cells, Index site, Index beyond) {
    return std::ranges::any_of(cells.faces_of(site), [&](const SpaceFace& face) {
        return face.beyond == beyond && face.area > 0.0;
    });
}

TEST(SpaceCells, ExtremeSites) {
    Random random(12);
    // Sites that nearly coincide, that lie far from the box, and radii far larger than it.
    for (const double spread : {1e-300, 1e-150, 1e-20, 1e-9, 1e9, 1e20, 1e50})
        for (const double radius : {0.0, 1e-30, 1e-3, 1.0, 1e10, 1e40}) {
            Sites sites;
            for (int i = 0; i < 60; ++i)
                sites.push_back({0.5 + spread * random.unit(), spread * random.unit(),
                                 spread * random.unit(), radius * random.unit()});
            const SpaceCells cells = cells_of(sites, unit_box);
            // Also where the nearest site is many boxes away.
            ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << spread << " " << radius;
            ASSERT_NO_FATAL_FAILURE(expect_polyhedra(polyhedra_of(sites, unit_box), cells))
                << spread << " " << radius;
        }
    // Sites that are one beside the box.
    for (const double near : {5e-324, 1e-310, 1e-230}) {
        const Sites sites = {{0, 0, 0, 0}, {near, 0, 0, 0}, {2, 0, 0, 0}, {0, near, 4 * near, 0}};
        for (const double size : {1.0, 3.0, 1e60, 1e100}) {
            const Box3 box = {{-size, -size, -size}, {size, size, size}};
            const SpaceCells cells = cells_of(sites, box);
            ASSERT_NO_FATAL_FAILURE(expect_laws(cells, sites.size())) << near << " " << size;
            EXPECT_TRUE(have_a_face(cells, 0, 1));
            EXPECT_TRUE(have_a_face(cells, 0, 3));
        }
    }
}

TEST(SpaceCells, WhatCannotBeIsRefused) {
    const auto refused = [](const Sites& sites, const Box3& box) -> std::string {
        const SpaceTessellation tessellation = triangulate(std::span<const Site3>(balls(5, 0, 1)));
        try {
            static_cast<void>(space_cells(tessellation, std::span<const Site3>(sites), box));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    Sites sites = balls(5, 0.0, 1);
    EXPECT_EQ(refused(sites, unit_box), "");
    EXPECT_EQ(refused(sites, {{0, 0, 0}, {1, 0, 1}}), "a box needs low < high along all axes");
    EXPECT_EQ(refused(sites, {{0, 0, 0}, {1, NAN, 1}}), "a box needs low < high along all axes");
    EXPECT_EQ(refused(sites, {{0, 0, 0}, {1, HUGE_VAL, 1}}),
              "the corners of a box are to be finite");
    EXPECT_EQ(refused(sites, {{0, 0, 0}, {1, 1e-320, 1}}), "");
    EXPECT_EQ(refused(sites, {{-1.7e308, 0, 0}, {1.7e308, 1, 1}}), "");
    EXPECT_EQ(refused(sites, {{1, 1, 1}, {1 + 1e-15, 1 + 1e-15, 1 + 1e-15}}), "");
    EXPECT_EQ(refused(sites, {{0, 0, 0}, {1e-300, 1e-300, 1e-300}}),
              "site 0 is not finite, or too large beside the box");
    sites[3].x = NAN;
    EXPECT_EQ(refused(sites, unit_box), "site 3 is not finite, or too large beside the box");
    sites.pop_back();
    sites[3].x = 0.0;
    EXPECT_EQ(refused(sites, unit_box), "a tessellation of another number of sites");
    const SpaceCells cells = cells_of(sites, unit_box);
    EXPECT_THROW(static_cast<void>(cells.faces_of(4)), std::out_of_range);
    EXPECT_THROW(static_cast<void>(cells.faces_of(-1)), std::out_of_range);
    const std::span<const Site3> all(sites);
    EXPECT_THROW(static_cast<void>(
                     space_polyhedra(triangulate(all), all, unit_box, std::vector<Index>{0, 4})),
                 std::out_of_range);
}

}  // namespace
}  // namespace signum
