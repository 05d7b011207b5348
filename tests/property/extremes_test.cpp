// Sites whose numbers have magnitudes far apart, from the least denormal to the largest double
// (tool/generate/hard.hpp): what overflows, underflows and is nothing beside others is no reason to
// be wrong.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/hard.hpp"
#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/clip.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using hard::Kind;

template <std::size_t d>
std::vector<hard::Ball<d>> balls_of(Kind kind, int round, std::int64_t most = 24) {
    hard::Moves<d> moves(static_cast<std::uint64_t>(round) * 16 + static_cast<std::uint64_t>(kind));
    std::vector<hard::Ball<d>> balls(
        static_cast<std::size_t>(moves.integer(2, moves.once_in(4) ? most : 9)));
    moves.extremes(kind, balls);
    return balls;
}

Metric metric_of(Kind kind) {
    switch (kind) {
        case Kind::euclidean:
            return Metric::euclidean;
        case Kind::supremum:
            return Metric::supremum;
        case Kind::manhattan:
            return Metric::manhattan;
        default:
            return Metric::power;
    }
}

/// In the hexadecimal of C, so that a failure can be asked again.
template <std::size_t d>
std::string text_of(const std::vector<hard::Ball<d>>& balls) {
    std::string text;
    for (const hard::Ball<d>& ball : balls) {
        char digits[40];
        for (const double x : ball.centre) {
            std::snprintf(digits, sizeof digits, "%a ", x);
            text += digits;
        }
        std::snprintf(digits, sizeof digits, "%a\n", ball.size);
        text += digits;
    }
    return text;
}

/// The cells tile the box, as far as doubles can tell of it. Whether it could be asked.
bool expect_tiling(const Tessellation& tessellation, const std::string& text) {
    const Voronoi diagram(tessellation);
    const Box box = default_box(tessellation.sites(), diagram.exponent());
    const double area = (box.x1 - box.x0) * (box.y1 - box.y0);
    if (!(area > 0x1p-900 && std::isfinite(area)) || !fits(box, diagram)) return false;
    const ClippedVoronoi clipped(diagram, box);
    double sum = 0.0;
    for (Index site = 0; site < static_cast<Index>(tessellation.sites().size()); ++site)
        sum += measure(clipped.cell(site)).area;
    // Vertices are rounded, which shows where the box is small beside its place.
    const double farthest =
        std::max({std::abs(box.x0), std::abs(box.x1), std::abs(box.y0), std::abs(box.y1)});
    const double rounding = 0x1p-50 * farthest / std::min(box.x1 - box.x0, box.y1 - box.y0);
    const auto sites = static_cast<double>(tessellation.sites().size());
    EXPECT_NEAR(sum / area, 1.0, 1e-6 + sites * rounding) << text;
    return true;
}

class Extremes : public testing::TestWithParam<Kind> {};

TEST_P(Extremes, OfThePlaneAreOrdinary) {
    const Metric metric = metric_of(GetParam());
    int tiled = 0;
    for (int round = 0; round < 25 * thoroughness; ++round) {
        const auto balls = balls_of<2>(GetParam(), round);
        const std::string text = text_of(balls);
        std::vector<Site> sites;
        std::vector<power::Site> weights;
        for (const auto& [centre, size] : balls) {
            sites.push_back({centre[0], centre[1], size});
            weights.push_back({centre[0], centre[1], size});
        }
        const bool are_weights = GetParam() == Kind::weights;
        const StridedSites given = are_weights ? StridedSites(weights) : StridedSites(sites);
        const Tessellation result = triangulate(given, metric);
        const Validation verdict = validate(result);
        ASSERT_TRUE(verdict.valid && verdict.canonical) << verdict.message << "\n" << text;
        ASSERT_EQ(triangulate(given, metric, {.seed = 7}).arrays(), result.arrays()) << text;
        for (const Method method : all_methods) {
            if (!builds(method, metric)) continue;
            ASSERT_EQ(triangulate(given, metric, {.method = method}).arrays(), result.arrays())
                << text;
        }
        tiled += expect_tiling(result, text) ? 1 : 0;
        if (are_weights) continue;
        DynamicTessellation dynamic(metric);
        std::vector<Index> handles;
        for (const Site& site : sites) handles.push_back(dynamic.insert(site));
        ASSERT_EQ(dynamic.tessellation().arrays(), result.arrays()) << text;
        std::vector<Site> rest;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (i % 2 == 0) {
                rest.push_back(sites[i]);
            } else {
                dynamic.erase(handles[i]);
            }
        }
        ASSERT_EQ(dynamic.tessellation().arrays(), triangulate(rest, metric).arrays()) << text;
    }
    EXPECT_GT(tiled, 5 * thoroughness);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Extremes, testing::ValuesIn(hard::all_kinds),
                         [](const auto& info) { return std::string(name_of(info.param)); });

template <class S>
void judge_in_space(const std::vector<S>& sites, const std::string& text) {
    const std::span<const S> all(sites);
    const SpaceTessellation result = triangulate(all);
    const Validation verdict = validate(result, all);
    ASSERT_TRUE(verdict.valid && verdict.canonical) << verdict.message << "\n" << text;
    ASSERT_EQ(triangulate(all, Power{}, {.seed = 7}), result) << text;
}

TEST(ExtremesOfSpace, AreOrdinary) {
    for (int round = 0; round < 25 * thoroughness; ++round) {
        for (const Kind kind : {Kind::points, Kind::weights, Kind::radii}) {
            const auto balls = balls_of<3>(kind, round);
            std::vector<Point3> points;
            std::vector<power::Site3> weights;
            std::vector<Site3> radii;
            for (const auto& [c, size] : balls) {
                points.push_back({c[0], c[1], c[2]});
                weights.push_back({c[0], c[1], c[2], size});
                radii.push_back({c[0], c[1], c[2], size});
            }
            if (kind == Kind::points)
                judge_in_space(points, text_of(balls));
            else if (kind == Kind::weights)
                judge_in_space(weights, text_of(balls));
            else
                judge_in_space(radii, text_of(balls));
        }
    }
}

/// The lists of balls, as they would be had the balls come in the opposite order.
std::vector<std::vector<Index>> turned_around(const BallLists& lists, std::int64_t balls) {
    std::vector<std::vector<Index>> result;
    for (std::size_t k = 0; k < lists.size(); ++k) {
        std::vector<Index>& list = result.emplace_back();
        for (const Index ball : lists[k]) list.push_back(static_cast<Index>(balls - 1 - ball));
        std::ranges::sort(list);
    }
    std::ranges::sort(result);
    return result;
}
std::vector<std::vector<Index>> as_they_are(const BallLists& lists) {
    std::vector<std::vector<Index>> result;
    for (std::size_t k = 0; k < lists.size(); ++k)
        result.emplace_back(lists[k].begin(), lists[k].end());
    std::ranges::sort(result);
    return result;
}

TEST(ExtremesOfSpace, DiagramsOfBallsDependOnNoOrder) {
    for (int round = 0; round < 4 * thoroughness; ++round) {
        const auto balls = balls_of<3>(Kind::euclidean, round, 9);
        std::vector<Site3> sites;
        for (const auto& [c, size] : balls)
            if (const Site3 site = {c[0], c[1], c[2], size};
                std::ranges::find(sites, site) == sites.end())
                sites.push_back(site);  // of equal ones the first is the visible one
        const BallDiagram one = ball_diagram(sites);
        const BallDiagram other = ball_diagram(std::vector<Site3>(sites.rbegin(), sites.rend()));
        EXPECT_EQ(turned_around(one.vertices, one.balls), as_they_are(other.vertices))
            << text_of(balls);
        EXPECT_EQ(turned_around(one.edges, one.balls), as_they_are(other.edges)) << text_of(balls);
        EXPECT_EQ(one.hidden.size(), other.hidden.size()) << text_of(balls);
    }
}

}  // namespace
}  // namespace signum
