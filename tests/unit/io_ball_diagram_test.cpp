/// The files of a diagram of balls, read back.

#include <limits>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../../tool/io/write_space_cells.hpp"

namespace signum {
namespace {

nlohmann::json json_of(const BallDiagram& diagram) {
    std::ostringstream out;
    write_json(out, diagram);
    return nlohmann::json::parse(out.str());
}
std::string csv_of(const BallDiagram& diagram) {
    std::ostringstream out;
    write_csv(out, diagram);
    return out.str();
}

/// The corners of a cube, all on one sphere, and a ball that one of them hides.
std::vector<Site3> corners() {
    std::vector<Site3> balls;
    for (const double x : {0.1, 1.1})
        for (const double y : {0.0, 1.0})
            for (const double z : {0.0, 1.0}) balls.push_back({x, y, z, 0.25});
    balls.push_back({0.1, 0.0, 0.0, 0.125});
    return balls;
}

TEST(BallDiagramFiles, JsonHasEverything) {
    const BallDiagram diagram = ball_diagram(corners());
    const nlohmann::json json = json_of(diagram);
    EXPECT_EQ(json["format"], "signum.voronoi");
    EXPECT_EQ(json["dimension"], 3);
    EXPECT_EQ(json["metric"], "euclidean");
    EXPECT_EQ(json["sites"], 9);
    ASSERT_EQ(json["vertices"].size(), diagram.spheres.size());
    ASSERT_EQ(json["touching"].size(), diagram.vertices.size());
    for (std::size_t v = 0; v < diagram.spheres.size(); ++v) {
        const auto& [x, y, z, r] = diagram.spheres[v];
        EXPECT_EQ(json["vertices"][v], nlohmann::json({x, y, z, r}));
        const auto touching = diagram.vertices[v];
        EXPECT_EQ(json["touching"][v].get<std::vector<Index>>(),
                  std::vector<Index>(touching.begin(), touching.end()));
        EXPECT_EQ(json["turns"][v], diagram.turns[v]);
    }
    EXPECT_EQ(json["touching"][0].size(), 8U);
    ASSERT_EQ(json["edges"].size(), diagram.edges.size());
    for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
        const auto balls = diagram.edges[e];
        EXPECT_EQ(json["edges"][e]["sites"].get<std::vector<Index>>(),
                  std::vector<Index>(balls.begin(), balls.end()));
        EXPECT_EQ(json["edges"][e]["vertices"], nlohmann::json(diagram.ends[e]));
    }
    EXPECT_EQ(json["hidden"], nlohmann::json({{8, 0}}));
}

TEST(BallDiagramFiles, ClosedEdgesHaveNoEnds) {
    const nlohmann::json json =
        json_of(ball_diagram(std::vector<Site3>{{-5, 0, 0, 4}, {5, 0, 0, 4}, {0, 0, 0, 0.5}}));
    EXPECT_TRUE(json["vertices"].empty());
    ASSERT_EQ(json["edges"].size(), 1U);
    EXPECT_EQ(json["edges"][0]["sites"], nlohmann::json({0, 1, 2}));
    EXPECT_TRUE(json["edges"][0]["vertices"].empty());
}

TEST(BallDiagramFiles, TheTableHasAVertexALine) {
    EXPECT_EQ(csv_of(ball_diagram(corners())),
              "a,b,c,d,x,y,z,r,turn,others\n"
              "0,1,2,3,0.6000000000000001,0.5,0.5,0.6160254037844387,-1,4 5 6 7\n");
    EXPECT_EQ(csv_of(BallDiagram()), "a,b,c,d,x,y,z,r,turn,others\n");
}

TEST(BallDiagramFiles, WhatIsBeyondDoublesIsNoNumber) {
    BallDiagram diagram;
    diagram.balls = 4;
    diagram.vertices.add(std::vector<Index>{0, 1, 2, 3});
    constexpr double infinity = std::numeric_limits<double>::infinity();
    diagram.spheres = {{1, -infinity, 2, infinity}};
    diagram.turns = {-1};
    EXPECT_EQ(json_of(diagram)["vertices"][0].dump(), "[1,null,2,null]");
    EXPECT_EQ(csv_of(diagram), "a,b,c,d,x,y,z,r,turn,others\n0,1,2,3,1,,2,,-1,\n");
}

}  // namespace
}  // namespace signum
