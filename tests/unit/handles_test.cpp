// Handles and numbers that come from outside: what names nothing is std::out_of_range, what is no
// number std::invalid_argument, in release builds too, in every class of the public headers. What
// was moved from can be asked.

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/edge_list.hpp"
#include "../../triangulation/flip_graph.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/contacts.hpp"
#include "../../voronoi/polygon.hpp"
#include "../../voronoi/voronoi.hpp"

namespace signum {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_finite[] = {nan, infinity, -infinity};

/// Calls ask with numbers that name none of `count` things. `also_infinity`: -1 names something.
template <class Ask>
void expect_out_of_range(std::size_t count, const Ask& ask, bool also_infinity = false) {
    const auto n = static_cast<Index>(count);
    for (const Index wrong : {n, n + 1, n + 1000, Index{99'999}, std::numeric_limits<Index>::max(),
                              std::numeric_limits<Index>::min(), Index{-2}, Index{-1}}) {
        if (also_infinity && wrong == infinite) continue;
        try {
            ask(wrong);
            ADD_FAILURE() << wrong << " of " << count << " was taken";
        } catch (const std::out_of_range& error) {
            EXPECT_NE(std::string(error.what()).find(std::to_string(wrong)), std::string::npos)
                << error.what();
        }
    }
}

class Handles : public testing::TestWithParam<Metric> {
 protected:
    const std::vector<Site> sites_ = {{0, 0, 1}, {10, 0, 2}, {0, 10, 1}, {9, 9, 1}, {0.1, 0, 0.2}};
    const Tessellation tessellation_ = triangulate(sites_, GetParam());
};

TEST_P(Handles, OfATessellation) {
    expect_out_of_range(sites_.size(), [&](Index i) { (void)tessellation_.neighbours(i); });
    for (const double x : not_finite) {
        EXPECT_THROW((void)tessellation_.nearest({x, 0}), std::invalid_argument);
        EXPECT_THROW((void)tessellation_.locate({0, x}), std::invalid_argument);
    }
    Tessellation moved_from = tessellation_;
    const Tessellation moved = std::move(moved_from);
    EXPECT_EQ(moved.faces().size(), tessellation_.faces().size());
    EXPECT_EQ(moved_from.faces().size() + moved_from.sites().size(), 0U);
    EXPECT_EQ(moved_from.nearest({0, 0}), -1);
    expect_out_of_range(0, [&](Index i) { (void)moved_from.neighbours(i); });
}

TEST_P(Handles, InTheArraysOfATessellation) {
    const auto expect_refused = [&](const auto& change) {
        TessellationArrays arrays = tessellation_.arrays();
        change(arrays);
        EXPECT_THROW(Tessellation(arrays, sites_, {}), std::invalid_argument);
    };
    for (const Index wrong : {-2, 5, 1000}) {
        expect_refused([&](TessellationArrays& arrays) { arrays.faces[1][0] = wrong; });
        expect_refused([&](TessellationArrays& arrays) { arrays.faces[1][1] = wrong; });
        expect_refused([&](TessellationArrays& arrays) { arrays.hidden = {{wrong, 0}}; });
        expect_refused([&](TessellationArrays& arrays) { arrays.hidden = {{0, wrong}}; });
    }
    for (const Index wrong : {-1, static_cast<Index>(tessellation_.faces().size()), 1000})
        expect_refused([&](TessellationArrays& arrays) { arrays.neighbours[1][1] = wrong; });
    expect_refused([&](TessellationArrays& arrays) { arrays.neighbours.pop_back(); });
    // Infinity stands first in a face.
    expect_refused([&](TessellationArrays& arrays) { arrays.faces.back()[1] = infinite; });
    expect_refused([&](TessellationArrays& arrays) { arrays.faces.back()[2] = infinite; });
}

TEST_P(Handles, OfADynamicTessellation) {
    DynamicTessellation dynamic(GetParam());
    for (const Site& site : sites_) dynamic.insert(site);
    const auto expect_refused = [&](DynamicTessellation& of, std::size_t count) {
        expect_out_of_range(count, [&](Index i) { of.erase(i); });
        expect_out_of_range(count, [&](Index i) { of.change(i, 1); });
        expect_out_of_range(count, [&](Index i) { (void)of.site(i); });
        EXPECT_EQ(of.size(), count);
        EXPECT_FALSE(of.contains(77));
        EXPECT_FALSE(of.contains(-1));
    };
    expect_refused(dynamic, sites_.size());
    dynamic.erase(2);
    EXPECT_THROW(dynamic.erase(2), std::out_of_range);
    EXPECT_THROW(dynamic.change(2, 1), std::out_of_range);
    EXPECT_THROW((void)dynamic.site(2), std::out_of_range);
    EXPECT_EQ(dynamic.size(), sites_.size() - 1);
    for (const double x : not_finite) {
        EXPECT_THROW(dynamic.insert({x, 0, 0}), std::invalid_argument);
        EXPECT_THROW(dynamic.insert({0, x, 0}), std::invalid_argument);
        EXPECT_THROW(dynamic.insert({0, 0, x}), std::invalid_argument);
        EXPECT_THROW(dynamic.change(0, x), std::invalid_argument);
    }
    EXPECT_EQ(dynamic.size(), sites_.size() - 1);

    const DynamicTessellation moved = std::move(dynamic);
    EXPECT_EQ(moved.size(), sites_.size() - 1);
    expect_refused(dynamic, 0);
    EXPECT_TRUE(dynamic.tessellation().sites().empty());
    EXPECT_EQ(dynamic.insert(sites_[0]), 0);
    EXPECT_EQ(dynamic.size(), 1U);
}

TEST_P(Handles, OfAnEdgeList) {
    EdgeList list(tessellation_.arrays());
    const auto expect_refused = [](const EdgeList& of, std::size_t half_edges, std::size_t sites) {
        expect_out_of_range(half_edges, [&](Index h) { (void)of[h]; });
        expect_out_of_range(half_edges, [&](Index h) { (void)of.target(h); });
        expect_out_of_range(
            sites, [&](Index i) { (void)of.edge_of_cell(i); }, true);
        expect_out_of_range(
            sites, [&](Index i) { (void)of.around_cell(i); }, true);
        expect_out_of_range(half_edges / 3, [&](Index v) { (void)of.around_vertex(v); });
    };
    expect_refused(list, list.half_edges().size(), sites_.size());
    const EdgeList moved = std::move(list);
    EXPECT_EQ(list.vertices(), 0);
    EXPECT_EQ(list.edge_of_cell(infinite), -1);
    expect_refused(list, 0, 0);
    expect_refused(EdgeList(), 0, 0);
}

TEST_P(Handles, InTheSpaceOfTessellations) {
    ExtendedTessellation extended(tessellation_.arrays());
    const auto edges = static_cast<std::size_t>(extended.edges());
    expect_out_of_range(edges, [&](Index e) { (void)extended.ends(e); });
    expect_out_of_range(edges, [&](Index e) { (void)extended.corners(e); });
    expect_out_of_range(edges, [&](Index e) { (void)extended.can_swap(e); });
    expect_out_of_range(edges, [&](Index e) { extended.swap(e); });
    expect_out_of_range(
        edges, [&](Index e) { (void)replay(tessellation_.arrays(), std::vector<Index>{e}); });
    const auto faces = static_cast<std::size_t>(extended.faces());
    expect_out_of_range(faces, [&](Index f) { (void)extended.corners_of(f); });
    expect_out_of_range(faces, [&](Index f) { (void)extended.edges_of(f); });
    const ExtendedTessellation moved = std::move(extended);
    EXPECT_EQ(extended.edges(), 0);
    EXPECT_EQ(extended.faces(), 0);
    expect_out_of_range(0, [&](Index e) { (void)extended.ends(e); });
}

TEST_P(Handles, OfADiagramAndItsPartInABox) {
    Voronoi diagram(tessellation_);
    const std::size_t edges = diagram.edges().size();
    expect_out_of_range(sites_.size(), [&](Index i) { (void)diagram.cell(i); });
    expect_out_of_range(sites_.size(), [&](Index i) { (void)diagram.is_hidden(i); });
    expect_out_of_range(sites_.size(), [&](Index i) { (void)diagram.is_unbounded(i); });
    expect_out_of_range(edges, [&](Index e) { (void)diagram.geometry(e); });
    for (const double x : not_finite) {
        EXPECT_THROW((void)diagram.geometry(0, Point{x, 0}), std::invalid_argument);
    }

    const ClippedVoronoi clipped(diagram, {-1, -1, 11, 11});
    expect_out_of_range(sites_.size(), [&](Index i) { (void)clipped.cell(i); });
    expect_out_of_range(edges, [&](Index e) { (void)clipped.edge(e); });
    for (const double x : not_finite) {
        EXPECT_THROW(ClippedVoronoi(diagram, {x, -1, 11, 11}), std::invalid_argument);
        EXPECT_THROW(ClippedVoronoi(diagram, {-1, -1, 11, x}), std::invalid_argument);
        EXPECT_THROW((void)default_box(std::vector<Site>{{0, 0, 0}, {x, 0, 0}}),
                     std::invalid_argument);
    }
    EXPECT_THROW((void)default_box({}), std::invalid_argument);
    EXPECT_FALSE(fits({nan, 0, 1, 1}, diagram));
    for (const double tolerance : {nan, 0.0, -1.0}) {
        std::vector<Point> points;
        const Conic line = Conic::straight({0, 0}, {1, 0});
        EXPECT_THROW((void)polygons(clipped.cell(0), tolerance), std::invalid_argument);
        EXPECT_THROW(sample(line, tolerance, points), std::invalid_argument);
        EXPECT_THROW((void)parabolas(line, tolerance), std::invalid_argument);
    }

    const Voronoi moved = std::move(diagram);
    EXPECT_EQ(moved.edges().size(), edges);
    EXPECT_EQ(diagram.edges().size(), 0U);
    expect_out_of_range(0, [&](Index i) { (void)diagram.cell(i); });
    expect_out_of_range(0, [&](Index i) { (void)diagram.is_unbounded(i); });
    expect_out_of_range(0, [&](Index e) { (void)diagram.geometry(e); });
}

TEST_P(Handles, OfContacts) {
    const Canonical canonical(tessellation_);
    const Contacts may_share_edge = contacts_of(canonical);
    const Edge last = tessellation_.edges().back();
    EXPECT_TRUE(may_share_edge(last[0], last[1]));
    const std::size_t sites = sites_.size();
    expect_out_of_range(sites, [&](Index i) { (void)canonical.site(i); });
    expect_out_of_range(sites, [&](Index i) { (void)canonical.hidden_by(i); });
    expect_out_of_range(sites, [&](Index i) { (void)canonical.shown_for(i); });
    expect_out_of_range(sites, [&](Index i) { (void)canonical.lesser(i, 0); });
    expect_out_of_range(
        sites, [&](Index i) { (void)canonical.any_face_at(i, [](const Face&) { return false; }); });
    expect_out_of_range(sites, [&](Index i) { (void)may_share_edge(i, 0); });
    expect_out_of_range(sites, [&](Index i) { (void)may_share_edge(0, i); });
    expect_out_of_range(tessellation_.faces().size(), [&](Index f) { (void)canonical.face(f); });
}

TEST_P(Handles, NumbersOfSites) {
    for (const double x : not_finite)
        for (const Site& site : {Site{x, 0, 0}, Site{0, x, 0}, Site{0, 0, x}}) {
            EXPECT_THROW((void)triangulate(std::vector<Site>{{1, 1, 1}, site}, GetParam()),
                         std::invalid_argument);
            EXPECT_THROW((void)flip_from_delaunay(std::vector<Site>{{1, 1, 1}, site}),
                         std::invalid_argument);
        }
}

INSTANTIATE_TEST_SUITE_P(Metrics, Handles, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

}  // namespace
}  // namespace signum
