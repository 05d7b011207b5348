#include "../../triangulation/edge_list.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace {

using namespace signum;

std::vector<Index> cells_across(const EdgeList& list, Index site) {
    std::vector<Index> cells;
    for (const Index h : list.around_cell(site)) cells.push_back(list[list[h].twin].cell);
    return cells;
}

void expect_laws(const Tessellation& t) {
    const EdgeList list(t.arrays());
    ASSERT_EQ(list.arrays(), t.arrays());
    const auto count = static_cast<Index>(list.half_edges().size());
    ASSERT_EQ(list.vertices(), static_cast<Index>(t.faces().size()));
    for (Index h = 0; h < count; ++h) {
        const EdgeList::HalfEdge& e = list[h];
        ASSERT_NE(e.twin, h);
        ASSERT_EQ(list[e.twin].twin, h);
        ASSERT_EQ(list[e.next].previous, h);
        ASSERT_EQ(list[e.previous].next, h);
        ASSERT_EQ(list[e.next].cell, e.cell);
        ASSERT_EQ(list[e.next].origin, list.target(h));
        ASSERT_EQ(e.origin, h / 3);
    }
    Index around = 0;
    for (Index site = infinite; site < static_cast<Index>(t.sites().size()); ++site) {
        for (const Index h : list.around_cell(site)) {
            ASSERT_EQ(list[h].cell, site);
            ++around;
        }
        if (site == infinite) continue;
        // Around a cell its neighbours follow one another as around the site.
        std::vector<Index> cells = cells_across(list, site);
        const std::vector<Index> expected = t.neighbours(site);
        ASSERT_EQ(cells.size(), expected.size());
        bool same = expected.empty();
        for (std::size_t turn = 0; turn < cells.size() && !same; ++turn) {
            same = cells == expected;
            std::rotate(cells.begin(), cells.begin() + 1, cells.end());
        }
        ASSERT_TRUE(same) << site;
    }
    ASSERT_EQ(around, count);
    for (Index v = 0; v < list.vertices(); ++v) {
        std::vector<Index> cells;
        for (const Index h : list.around_vertex(v)) {
            ASSERT_EQ(list[h].origin, v);
            cells.push_back(list[h].cell);
        }
        std::rotate(cells.begin(), std::min_element(cells.begin(), cells.end()), cells.end());
        const Face& face = t.faces()[static_cast<std::size_t>(v)];
        ASSERT_EQ(cells, std::vector<Index>(face.begin(), face.end()));
    }
}

TEST(EdgeList, IsTheDualOfEveryTessellation) {
    GenerateOptions options;
    options.count = 300;
    options.radius_to = 40;
    for (const Distribution distribution : {Distribution::random, Distribution::grid})
        for (const Metric metric : all_metrics)
            ASSERT_NO_FATAL_FAILURE(
                expect_laws(triangulate(generate(distribution, options), metric)));
}

TEST(EdgeList, TwoSitesAndFewer) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}};
    const Tessellation two = triangulate(sites, Supremum{});
    expect_laws(two);
    const EdgeList list(two.arrays());
    EXPECT_EQ(list.vertices(), 2);
    EXPECT_EQ(cells_across(list, 0).size(), 2U);
    const std::vector<Site> alone = {{0, 0, 0}};
    const EdgeList none(triangulate(alone, Supremum{}).arrays());
    EXPECT_EQ(none.vertices(), 0);
    EXPECT_EQ(none.edge_of_cell(0), -1);
    for (const Index h : none.around_cell(0)) ADD_FAILURE() << h;
    EXPECT_TRUE(EdgeList().half_edges().empty());
}

TEST(EdgeList, SweptSquares) {
    GenerateOptions generated;
    generated.count = 500;
    generated.radius_to = 20;
    Options options;
    options.method = Method::sweep;
    expect_laws(triangulate(generate(Distribution::random, generated), Supremum{}, options));
}

TEST(EdgeList, RefusesNeighboursThatDoNotFit) {
    const std::vector<Site> sites = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 4, 0}};
    const TessellationArrays good = triangulate(sites, Power{}).arrays();
    TessellationArrays bad = good;
    std::swap(bad.neighbours[0][0], bad.neighbours[0][1]);
    EXPECT_THROW((void)EdgeList(bad), std::invalid_argument);
    bad = good;
    bad.neighbours[1][2] = 99;
    EXPECT_THROW((void)EdgeList(bad), std::invalid_argument);
    bad = good;
    bad.neighbours.pop_back();
    EXPECT_THROW((void)EdgeList(bad), std::invalid_argument);
    bad = good;
    bad.faces[0][0] = 17;
    EXPECT_THROW((void)EdgeList(bad), std::invalid_argument);
}

}  // namespace
