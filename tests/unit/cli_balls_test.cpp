/// The tool from outside: the Voronoi diagram of balls.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::Outcome;
using test::run;
using test::Scratch;
using Words = test::Words;

/// A file of six balls: a tetrahedron with one in it, and one hidden.
class ToolOfBalls : public testing::Test {
 protected:
    Scratch scratch;
    std::string balls = scratch.file(
        "balls.csv", "x,y,z,r\n0,0,0,1\n4,0,0,1\n0,4,0,1\n0,0,4,1\n1,1,1,0.5\n1,1,1,0.25\n");
    std::string table =
        "a,b,c,d,x,y,z,r,turn,others\n"
        "0,1,2,4,2,2,-1.1064322306091547,2.0371355387816905,1,\n"
        "0,1,3,4,2,-1.1064322306091547,2,2.0371355387816905,-1,\n"
        "0,2,3,4,-1.1064322306091547,2,2,2.0371355387816905,1,\n"
        "1,2,3,4,3.880453818634569,3.880453818634569,3.880453818634569,4.489092362730862,-1,\n";

    [[nodiscard]] Words voronoi(const Words& more) const {
        Words words = {"voronoi", balls};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    void refused(const Words& more, const std::string& err) const {
        const std::size_t before = scratch.size();
        const Outcome outcome = run(voronoi(more));
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err, err);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(scratch.size(), before);
    }
};

TEST_F(ToolOfBalls, WritesTheDiagram) {
    const Outcome outcome = run(voronoi({}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.out.starts_with(
        "{\"format\": \"signum.voronoi\", \"version\": 1, \"dimension\": 3, \"metric\": "
        "\"euclidean\", \"weight_is\": \"radius\", \"sites\": 6, \"clip\": null,\n\"vertices\": "
        "[\n[2, 2, -1.1064322306091547, 2.0371355387816905],\n"))
        << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with("\"hidden\": [\n[5, 4]]}\n")) << outcome.out;
    EXPECT_EQ(outcome.err,
              "sites    6, in space\n"
              "diagram  of balls, euclidean: vertices and edges; --metric power measures cells\n"
              "cells    5\nhidden   1\nvertices 4\n"
              "edges    10, 4 of them infinite, 0 closed\n");
    EXPECT_EQ(run(voronoi({"--quiet"})).err, "");
    EXPECT_EQ(run(voronoi({"--metric", "euclidean", "--seed", "7"})).out, outcome.out);
    EXPECT_EQ(run({"voronoi", "-"}, {.in = balls}).out, outcome.out);

    const std::string json = scratch.path("a.json");
    const std::string csv = scratch.path("a.csv");
    const Outcome files = run(voronoi({"-o", json, "-o", csv}));
    EXPECT_EQ(files.out, "");
    EXPECT_TRUE(files.err.ends_with("written  " + json + ", " + csv + "\n")) << files.err;
    EXPECT_EQ(contents(json), outcome.out);
    EXPECT_EQ(contents(csv), table);
    EXPECT_EQ(run(voronoi({"--format", "csv", "--quiet"})).out, table);
}

TEST_F(ToolOfBalls, ReadsWhateverSaysTheSame) {
    const auto same = [&](const std::string& name, const std::string& text, const Words& more) {
        Words words = {"voronoi", scratch.file(name, text), "--format", "csv", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.err, "") << name;
        EXPECT_EQ(outcome.out, table) << name;
    };
    same("a.txt", "0 0 0 1\n4 0 0 1\n0 4 0 1\n0 0 4 1\n1 1 1 0.5\n", {"--dimension", "3"});
    same("b.csv", "r;n;z;y;x\n1;a;0;0;0\n1;b;0;0;4\n1;c;0;4;0\n1;d;4;0;0\n0.5;e;1;1;1\n", {});
    same("c.json", "[[0,0,0,1],[4,0,0,1],[0,4,0,1],[0,0,4,1],[1,1,1,0.5]]", {});
    const std::string atoms =
        "5\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\nA 4 0 0 1\nA 0 4 0 1\nA 0 0 4 "
        "1\nA 1 1 1 0.5\n";
    same("d.xyz", atoms, {});
    same("d.data", atoms, {"--read-as", "xyz"});
    // Only differences of radii matter, but to the spheres.
    const Words words = {"voronoi",
                         scratch.file("n.csv", "x,y,z,r\n0,0,0,-1\n4,0,0,-1\n0,4,0,-1\n0,0,4,-1\n"),
                         "--format", "csv", "--quiet"};
    EXPECT_EQ(run(words).err, "");
    EXPECT_EQ(run(words).out, "a,b,c,d,x,y,z,r,turn,others\n0,1,2,3,2,2,2,4.464101615137754,1,\n");
}

TEST_F(ToolOfBalls, SaysWhatIsOfOtherDiagrams) {
    const std::string of_file = ": the diagram of balls, as those of " + balls + " are, ";
    refused({"--clip", "0", "0", "1", "1"},
            "signum: --clip" + of_file +
                "has vertices and edges alone, which are written whole; leave --clip out\n");
    refused({"--tolerance", "1"},
            "signum: --tolerance" + of_file + "has no polygons; leave --tolerance out\n");
    refused({"--merge"},
            "signum: --merge" + of_file + "has one vertex a sphere anyway; leave --merge out\n");
    refused({"--format", "svg"},
            "signum: svg" + of_file + "is written as json or csv; name one of them\n");
    refused({"-o", scratch.path("a.geojson")},
            "signum: geojson" + of_file + "is written as json or csv; name one of them\n");
    refused({"-o", balls},
            "signum: -o " + balls + " would overwrite the input; give another name\n");
    refused({"--weight-is", "weight"},
            "signum: --weight-is weight: only the power metric has weights, and this is --metric "
            "euclidean; leave --weight-is out, or add --metric power\n");
    const Outcome squares = run(voronoi({"--metric", "supremum"}));
    EXPECT_EQ(squares.code, 2);
    EXPECT_TRUE(squares.err.starts_with("signum: --metric supremum: sites in space, as those of " +
                                        balls + " are, have "))
        << squares.err;
}

TEST_F(ToolOfBalls, SaysNothingMoreOfManyEqualRadii) {
    const std::string many = scratch.path("many.csv");
    ASSERT_EQ(run({"generate", "random", "--dimension", "3", "-n", "500", "-o", many}).code, 0);
    const Words words = {"voronoi", many, "-o", scratch.path("many.json")};
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err.find("equal"), std::string::npos);
    Words quiet = words;
    quiet.emplace_back("--quiet");
    EXPECT_EQ(run(quiet).err, "");
}

}  // namespace
}  // namespace signum
