/// Whatever works on several threads gives the same bytes for any number of them: vertices,
/// diagrams, cells, judgements with their counts and words, comparisons. Of so many sites that
/// several threads do work.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../core/parallel.hpp"
#include "../../tool/study/margin.hpp"
#include "../../triangulation/space/compare.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/compare.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/voronoi.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

using brute_force::Random;

constexpr std::array<int, 3> several = {2, 3, 7};

/// As bytes: two that are not a number may be the same.
[[nodiscard]] std::vector<std::uint64_t> bits(std::initializer_list<double> numbers) {
    std::vector<std::uint64_t> result;
    for (const double number : numbers) result.push_back(std::bit_cast<std::uint64_t>(number));
    return result;
}

/// More than twice as many as let a second thread begin, on a grid with every tie there is: small
/// integers, some sites hidden by their neighbours.
[[nodiscard]] std::vector<Site> grid(std::uint64_t seed) {
    Random random(seed);
    std::vector<Site> sites;
    for (int x = 0; x < 190; ++x)
        for (int y = 0; y < 190; ++y)
            sites.push_back({static_cast<double>(x), static_cast<double>(y),
                             static_cast<double>(random.between(0, 60) == 0 ? 2 : 0)});
    return sites;
}
/// In no position that is special.
[[nodiscard]] std::vector<Site> scattered(std::uint64_t seed) {
    Random random(seed);
    std::vector<Site> sites;
    for (int i = 0; i < 40'000; ++i)
        sites.push_back({random.between(0, 1 << 24) / 1024.0, random.between(0, 1 << 24) / 1024.0,
                         random.between(0, 1 << 16) / 1024.0});
    return sites;
}
[[nodiscard]] std::vector<Site3> in_space(bool is_lattice) {
    Random random(7);
    std::vector<Site3> sites;
    if (is_lattice) {
        for (int x = 0; x < 22; ++x)
            for (int y = 0; y < 22; ++y)
                for (int z = 0; z < 22; ++z)
                    sites.push_back({static_cast<double>(x), static_cast<double>(y),
                                     static_cast<double>(z), random.between(0, 60) == 0 ? 2.0 : 0});
        return sites;
    }
    for (int i = 0; i < 18'000; ++i)
        sites.push_back({random.between(0, 1 << 20) / 1024.0, random.between(0, 1 << 20) / 1024.0,
                         random.between(0, 1 << 20) / 1024.0, random.between(0, 1 << 15) / 1024.0});
    return sites;
}

class Loops : public testing::TestWithParam<Metric> {
 protected:
    static std::vector<Tessellation> tessellations() {
        return {triangulate(grid(1), GetParam()), triangulate(scattered(2), GetParam())};
    }
};

// ---- diagrams ----------------------------------------------------------------------------------

TEST_P(Loops, OfVertices) {
    for (const Tessellation& t : tessellations()) {
        ASSERT_GT(t.faces().size(), 2 * few_items);
        const auto of = [&](int threads) {
            std::vector<std::vector<std::uint64_t>> result;
            for (const auto& [x, y, rho] : vertices(t, threads))
                result.push_back(bits({x, y, rho}));
            return result;
        };
        const auto one = of(1);
        for (const int threads : several) ASSERT_EQ(of(threads), one) << threads << " threads";
    }
}

struct Drawn {
    std::vector<std::vector<std::uint64_t>> numbers;
    std::vector<Index> names;
    friend bool operator==(const Drawn&, const Drawn&) = default;
};

/// A diagram, whole and in a box that cuts it, with all that is told of it.
Drawn drawn(const Tessellation& t, bool merge, int threads) {
    Drawn result;
    const Voronoi diagram(t, {.merge = merge, .threads = threads});
    for (const auto& [x, y, rho] : diagram.vertices()) result.numbers.push_back(bits({x, y, rho}));
    const auto name = [&](const auto... names) { (result.names.push_back(names), ...); };
    for (const Index vertex : diagram.vertex_of_face()) name(vertex);
    for (const auto& [left, right, from, to, from_face, to_face] : diagram.edges())
        name(left, right, from, to, from_face, to_face);
    const auto sites = static_cast<Index>(t.sites().size());
    for (Index site = 0; site < sites; ++site)
        for (const auto& [edge, forward] : diagram.cell(site))
            name(edge, static_cast<Index>(forward));
    const Box box = {20, 30, 9000, 8000};
    for (const Box& each : {no_box, box}) {
        const ClippedVoronoi clipped(diagram, each, Lengths::of_the_plane, threads);
        for (std::size_t e = 0; e < diagram.edges().size(); ++e)
            for (const Conic& part : clipped.edge(static_cast<Index>(e)))
                result.numbers.push_back(bits({part.from.x, part.from.y, part.control.x,
                                               part.control.y, part.to.x, part.to.y, part.weight}));
        for (const auto& [area, perimeter, centroid] : measures(clipped, threads))
            result.numbers.push_back(bits({area, perimeter, centroid.x, centroid.y}));
    }
    return result;
}

TEST_P(Loops, OfDiagramsAndCells) {
    for (const Tessellation& t : tessellations())
        for (const bool merge : {false, true}) {
            const Drawn one = drawn(t, merge, 1);
            for (const int threads : several)
                ASSERT_TRUE(drawn(t, merge, threads) == one) << threads << " threads";
        }
}

// ---- judgements --------------------------------------------------------------------------------

std::string told(const Validation& v) {
    return v.message + (v.valid ? ", valid" : ", not valid") +
           (v.canonical ? ", canonical" : ", not canonical") + ", " + std::to_string(v.filtered) +
           " filtered, " + std::to_string(v.multiprecision) + " exactly";
}

/// What several threads say is what one says, to the last count.
template <class T, class Sites>
void expect_one_judgement(const T& arrays, const Sites& sites, const std::string& what) {
    const std::string one = told(validate(arrays, sites, {.threads = 1}));
    for (const int threads : several)
        ASSERT_EQ(told(validate(arrays, sites, {.threads = threads})), one)
            << what << ", " << threads << " threads";
}

TEST_P(Loops, OfJudgements) {
    Random random(3);
    for (const Tessellation& t : tessellations()) {
        const std::vector<Site> sites(t.sites().begin(), t.sites().end());
        expect_one_judgement(t.arrays(), StridedSites(sites), "whole");
        const auto faces = static_cast<int>(t.faces().size());
        for (int trial = 0; trial < 24; ++trial) {
            TessellationArrays arrays = t.arrays();
            // Of several faults the first is told, wherever others are.
            for (int fault = 0; fault < 4; ++fault) {
                const auto f = static_cast<std::size_t>(random.between(0, faces - 1));
                const auto g = static_cast<std::size_t>(random.between(0, faces - 1));
                switch (trial % 6) {
                    case 0:
                        std::swap(arrays.faces[f][0], arrays.faces[f][1]);
                        break;
                    case 1:
                        std::swap(arrays.neighbours[f][0], arrays.neighbours[f][2]);
                        break;
                    case 2:
                        arrays.faces[f][2] = static_cast<Index>(sites.size()) + fault;
                        break;
                    case 3:
                        std::swap(arrays.faces[f], arrays.faces[g]);
                        break;
                    case 4:
                        arrays.faces[f][1] = arrays.faces[g][1];
                        break;
                    default:
                        if (!arrays.hidden.empty())
                            arrays.hidden[f % arrays.hidden.size()].by = t.faces()[g][2];
                }
            }
            expect_one_judgement(arrays, StridedSites(sites), "trial " + std::to_string(trial));
            if (HasFatalFailure()) return;
        }
        // Sites that are elsewhere: conflicts, and hidden sites that are not.
        for (int trial = 0; trial < 4; ++trial) {
            std::vector<Site> moved = sites;
            for (int fault = 0; fault < 4; ++fault) {
                Site& site = moved[static_cast<std::size_t>(
                    random.between(0, static_cast<int>(sites.size()) - 1))];
                (trial % 2 == 0 ? site.x : site.r) += 0.5;
            }
            expect_one_judgement(t.arrays(), StridedSites(moved), "moved");
            if (HasFatalFailure()) return;
        }
    }
}

/// Valid, not canonical: who is later in the tie rule's order is turned around, so that it would
/// decide ties otherwise.
TEST_P(Loops, OfJudgementsThatNoteTies) {
    std::vector<Site> sites = grid(1);
    const Tessellation t = triangulate(sites, GetParam());
    std::vector<Site> turned(sites.rbegin(), sites.rend());
    TessellationArrays arrays = t.arrays();
    const auto other = [&](Index& i) {
        if (i != infinite) i = static_cast<Index>(sites.size()) - 1 - i;
    };
    for (Face& face : arrays.faces)
        for (Index& i : face) other(i);
    for (Hidden& hidden : arrays.hidden) {
        other(hidden.site);
        other(hidden.by);
    }
    expect_one_judgement(arrays, StridedSites(turned), "turned");
    for (Site& site : turned) site = {-site.x, -site.y, site.r};
    expect_one_judgement(arrays, StridedSites(turned), "turned around");
}

// ---- comparisons -------------------------------------------------------------------------------

TEST_P(Loops, OfComparisons) {
    for (const bool is_grid : {true, false}) {
        const std::vector<Site> sites = is_grid ? grid(1) : scattered(2);
        const Tessellation canonical = triangulate(sites, GetParam());
        // Another tessellation, said to be that of the same sites: edges that are and are not.
        std::vector<Site> moved = sites;
        for (std::size_t i = 0; i < moved.size(); i += 5) moved[i].x += 0.25;
        const Tessellation other(triangulate(moved, GetParam()).arrays(), sites, {});
        const EdgeComparison one = compare_edges(other, canonical, 1);
        ASSERT_GT(one.wrong.size() + one.different.size(), 0U);
        for (const int threads : several) {
            const EdgeComparison found = compare_edges(other, canonical, threads);
            ASSERT_EQ(found.edges, one.edges);
            ASSERT_EQ(found.wrong, one.wrong) << threads << " threads";
            ASSERT_EQ(found.different, one.different) << threads << " threads";
        }
        const study::Margins margins = study::margins_of(canonical, 1);
        for (const int threads : several) {
            const study::Margins found = study::margins_of(canonical, threads);
            ASSERT_EQ(found.edges, margins.edges);
            ASSERT_EQ(found.ties, margins.ties);
            ASSERT_EQ(found.powers, margins.powers);
            ASSERT_EQ(found.least, margins.least);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Metrics, Loops, testing::ValuesIn(all_metrics),
                         [](const auto& of) { return std::string(name_of(of.param)); });

// ---- space -------------------------------------------------------------------------------------

TEST(LoopsInSpace, OfVerticesAndCells) {
    for (const bool is_lattice : {false, true}) {
        const std::vector<Site3> sites = in_space(is_lattice);
        const std::span<const Site3> all(sites);
        const SpaceTessellation t = triangulate(all);
        ASSERT_GT(t.cells.size(), 2 * few_items);
        const Box3 cut = {{3, 3.5, 2}, {700, 800, 600}};
        const auto of = [&](int threads) {
            std::vector<std::vector<std::uint64_t>> result;
            for (const auto& [x, y, z, rho] : vertices(t, all, threads))
                result.push_back(bits({x, y, z, rho}));
            return result;
        };
        const auto one = of(1);
        for (const int threads : several) ASSERT_EQ(of(threads), one) << threads << " threads";
        for (const Box3& box : {default_box(all), cut}) {
            const SpaceCells cells = space_cells(t, all, box, 1);
            for (const int threads : several)
                ASSERT_TRUE(space_cells(t, all, box, threads) == cells) << threads << " threads";
        }
    }
}

TEST(LoopsInSpace, OfJudgementsAndComparisons) {
    Random random(5);
    for (const bool is_lattice : {false, true}) {
        const std::vector<Site3> sites = in_space(is_lattice);
        const std::span<const Site3> all(sites);
        const SpaceTessellation t = triangulate(all);
        expect_one_judgement(t, all, "whole");
        const auto cells = static_cast<int>(t.cells.size());
        for (int trial = 0; trial < 12; ++trial) {
            SpaceTessellation wrong = t;
            for (int fault = 0; fault < 4; ++fault) {
                const auto c = static_cast<std::size_t>(random.between(0, cells - 1));
                const auto d = static_cast<std::size_t>(random.between(0, cells - 1));
                if (trial % 3 == 0) std::swap(wrong.cells[c][1], wrong.cells[c][2]);
                if (trial % 3 == 1) std::swap(wrong.neighbours[c], wrong.neighbours[d]);
                if (trial % 3 == 2) wrong.cells[c][3] = wrong.cells[d][3];
            }
            expect_one_judgement(wrong, all, "trial " + std::to_string(trial));
            if (testing::Test::HasFatalFailure()) return;
        }
        std::vector<Site3> moved = sites;
        for (std::size_t i = 0; i < moved.size(); i += 7) moved[i].x += 0.25;
        const std::span<const Site3> elsewhere(moved);
        expect_one_judgement(t, elsewhere, "moved");
        const SpaceTessellation other = triangulate(elsewhere);
        const CellComparison one = compare_cells(other, t, all, 1);
        const FacetTies ties = ties_of(t, all, 1);
        ASSERT_GT(one.wrong.size() + one.different.size(), 0U);
        for (const int threads : several) {
            const CellComparison found = compare_cells(other, t, all, threads);
            ASSERT_EQ(found.cells, one.cells);
            ASSERT_EQ(found.wrong, one.wrong) << threads << " threads";
            ASSERT_EQ(found.different, one.different) << threads << " threads";
            const FacetTies counted = ties_of(t, all, threads);
            ASSERT_EQ(counted.facets, ties.facets);
            ASSERT_EQ(counted.ties, ties.ties);
        }
    }
}

TEST(LoopsInSpace, OfDiagramsOfBalls) {
    Random random(9);
    for (const bool is_lattice : {false, true}) {
        std::vector<Site3> balls;
        const int most = is_lattice ? 6 : 1 << 20;
        for (int i = 0; i < (is_lattice ? 216 : 500); ++i)
            balls.push_back({static_cast<double>(is_lattice ? i % 6 : random.between(0, most)),
                             static_cast<double>(is_lattice ? i / 6 % 6 : random.between(0, most)),
                             static_cast<double>(is_lattice ? i / 36 : random.between(0, most)),
                             is_lattice ? 0.25 * (i % 2) : random.between(0, most / 32)});
        const BallDiagram one = ball_diagram(balls, {.threads = 1});
        ASSERT_GT(one.vertices.size(), 0U);
        for (const int threads : several)
            ASSERT_TRUE(ball_diagram(balls, {.threads = threads}) == one) << threads << " threads";
    }
}

}  // namespace
}  // namespace signum
