/// The tool from outside, on sites in space.

#include <string>
#include <vector>

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
class ToolInSpace : public testing::Test {
 protected:
    Scratch scratch;
    std::string balls = scratch.file(
        "balls.csv", "x,y,z,r\n0,0,0,1\n4,0,0,1\n0,4,0,1\n0,0,4,1\n1,1,1,0.5\n1,1,1,0.25\n");

    [[nodiscard]] Words triangulate(const Words& more) const {
        Words words = {"triangulate", balls, "--metric", "power"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static void expect(const Words& words, int code, const std::string& err) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, code);
        EXPECT_EQ(outcome.err, err);
        EXPECT_EQ(outcome.out, "");
    }
};

TEST_F(ToolInSpace, WritesJsonToStandardOutput) {
    const Outcome outcome = run(triangulate({}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out,
              "{\"format\": \"signum.tessellation\", \"version\": 1, \"dimension\": 3, \"metric\": "
              "\"power\", \"weight_is\": \"radius\", \"sites\": 6,\n"
              "\"cells\": [\n[-1, 0, 1, 2],\n[-1, 0, 2, 3],\n[-1, 0, 3, 1],\n[-1, 1, 3, 2],\n"
              "[0, 1, 2, 4],\n[0, 1, 4, 3],\n[0, 2, 3, 4],\n[1, 2, 4, 3]],\n"
              "\"neighbours\": [\n[4, 3, 1, 2],\n[6, 3, 2, 0],\n[5, 3, 0, 1],\n[7, 1, 0, 2],\n"
              "[7, 6, 5, 0],\n[7, 6, 2, 4],\n[7, 5, 4, 1],\n[6, 5, 3, 4]],\n"
              "\"hidden\": [\n[5, 4]]}\n");
    EXPECT_TRUE(
        outcome.err.starts_with("sites    6, in space\nvisible  5\nhidden   1\n"
                                "cells    8, 4 of them infinite\nseconds  "))
        << outcome.err;
    EXPECT_EQ(run(triangulate({"--quiet"})).err, "");
    EXPECT_EQ(run({"triangulate", "-", "--metric", "power"}, {.in = balls}).out, outcome.out);
    EXPECT_EQ(run(triangulate({"--seed", "7"})).out, outcome.out);
}

TEST_F(ToolInSpace, ReadsWhateverSaysTheSame) {
    const std::string expected = run(triangulate({"--quiet"})).out;
    const auto same = [&](const std::string& name, const std::string& text, const Words& more) {
        Words words = {"triangulate", scratch.file(name, text), "--metric", "power", "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.err, "") << name;
        EXPECT_EQ(outcome.out, expected) << name;
    };
    same("a.txt", "0 0 0 1\n4 0 0 1\n0 4 0 1\n0 0 4 1\n1 1 1 0.5\n1 1 1 0.25\n",
         {"--dimension", "3"});
    const std::string permuted =
        "r;n;z;y;x\n1;a;0;0;0\n1;b;0;0;4\n1;c;0;4;0\n1;d;4;0;0\n0.5;e;1;1;1\n0.25;f;1;1;1\n";
    same("b.csv", permuted, {});
    same("b.csv", permuted, {"--columns", "x,y,z,r"});
    same("b.csv", permuted, {"--columns", "5,4,3,1"});
    same("c.json", "[[0,0,0,1],[4,0,0,1],[0,4,0,1],[0,0,4,1],\n[1,1,1,0.5],[1,1,1,0.25]]", {});
    const std::string atoms =
        "6\nsix\nA 0 0 0 1\nA 4 0 0 1\nA 0 4 0 1\nA 0 0 4 1\nA 1 1 1 0.5\nA 1 1 1 0.25\n";
    same("d.xyz", atoms, {});
    same("d.data", atoms, {"--read-as", "xyz"});
    same("e.ply",
         "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty "
         "float z\nproperty float radius\nend_header\n0 0 0 1\n4 0 0 1\n0 4 0 1\n0 0 4 1\n1 1 1 "
         "0.5\n1 1 1 0.25\n",
         {});
    same("f.pqr",
         "ATOM 1 N N 1 0 0 0 0 1\nATOM 2 N N 1 4 0 0 0 1\nATOM 3 N N 1 0 4 0 0 1\nATOM 4 N N 1 0 0 "
         "4 0 1\nATOM 5 N N 1 1 1 1 0 0.5\nATOM 6 N N 1 1 1 1 0 0.25\n",
         {});
    // Weights, whose squares the radii were.
    Words words = {"triangulate",
                   scratch.file("g.csv",
                                "x,y,z,weight\n0,0,0,1\n4,0,0,1\n0,4,0,1\n0,0,4,1\n"
                                "1,1,1,0.25\n1,1,1,0.0625\n"),
                   "--metric", "power", "--quiet"};
    std::string weighted = run(words).out;
    const auto weight = weighted.find("\"weight\"");
    ASSERT_NE(weight, std::string::npos);
    EXPECT_EQ(weighted.replace(weight, 8, "\"radius\""), expected);
}

TEST_F(ToolInSpace, SaysWhatIsOfThePlaneAlone) {
    const std::string of_file = ": sites in space, as those of " + balls + " are, have ";
    expect({"triangulate", balls}, 2,
           "signum: --metric euclidean" + of_file +
               "tessellations of the power metric alone; add --metric power, or say --dimension 2 "
               "to leave z out\n");
    expect({"triangulate", balls, "--metric", "supremum", "--dimension", "3"}, 2,
           "signum: --metric supremum" + of_file +
               "tessellations of the power metric alone; add --metric power\n");
    expect(triangulate({"--check"}), 2,
           "signum: --check" + of_file + "no check yet; leave --check out\n");
    expect(triangulate({"--vertices"}), 2,
           "signum: --vertices" + of_file + "no vertices in JSON yet; leave --vertices out\n");
    expect(
        triangulate({"--method", "flips"}), 2,
        "signum: --method flips" + of_file + "the method incremental alone; leave --method out\n");
    expect(triangulate({"--arithmetic", "naive"}), 2,
           "signum: --arithmetic naive" + of_file +
               "exact arithmetic alone; leave --arithmetic out\n");
    const std::string svg = scratch.path("a.svg");
    expect(triangulate({"--clip", "0", "0", "1", "1", "-o", svg}), 2,
           "signum: --clip" + of_file + "pictures of all of them alone; leave --clip out\n");
    EXPECT_FALSE(std::filesystem::exists(svg));
    const std::string vtk = scratch.path("a.vtk");
    expect(triangulate({"--columns", "x,y", "-o", vtk}), 2,
           "signum: vtk is written of sites in space, and those of " + balls +
               " lie in the plane; write obj\n");
    EXPECT_FALSE(std::filesystem::exists(vtk));
    expect(triangulate({"--dimension", "4"}), 2,
           "signum: --dimension: '4' is unknown; it is one of 2, 3; see signum triangulate "
           "--help\n");
    expect(triangulate({"--dimension", "3", "--columns", "x,y"}), 2,
           "signum: --columns x,y: give three or four with commas between, by name or number, as "
           "in --columns x,y,z or --columns 2,3,4,6\n");
    expect(triangulate({"--read-as", "ply", "--dimension", "2"}), 2,
           "signum: --dimension 2: the sites of " + balls +
               " lie in space; leave it out, or add --read-as text\n");
    expect(triangulate({"--read-as", "ply", "--columns", "1,2,3"}), 2,
           "signum: --columns 1,2,3: " + balls +
               " has columns of its own; leave --columns out, or add --read-as text\n");
}

TEST_F(ToolInSpace, RefusesWrongInputAndWritesNothing) {
    const std::string bad = scratch.file("bad.csv", "x,y,z\n0,0,1\n4,zero,1\n");
    const std::size_t before = scratch.size();
    expect({"triangulate", bad, "--metric", "power", "-o", scratch.path("a.vtk")}, 2,
           bad +
               ":3:3: 'zero' is not a number; write a decimal or hexadecimal float, such as 1.5, "
               "-2e-3 or 0x1.8p-3\n");
    EXPECT_EQ(scratch.size(), before);
    const std::string negative = scratch.file("n.csv", "x,y,z,r\n0,0,1,-2\n");
    const Outcome outcome = run({"triangulate", negative, "--metric", "power", "--quiet"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "signum: " + negative +
                               ":2:7: the radius -2 is negative, the only one of the file, and the "
                               "power metric squares radii; say --weight-is weight if weights are "
                               "meant, --weight-is radius if not\n");
}

TEST_F(ToolInSpace, WritesEveryFormat) {
    Words words = triangulate({"--stats"});
    for (const char* name : {"a.json", "a.svg", "a.csv", "a.obj", "a.vtk"})
        words.insert(words.end(), {"-o", scratch.path(name)});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(contents(scratch.path("a.json")).find("\"ccw\": null"), std::string::npos);
    EXPECT_TRUE(contents(scratch.path("a.svg")).ends_with("</svg>\n"));
    EXPECT_TRUE(contents(scratch.path("a.csv")).starts_with("a,b,c,d\n-1,0,1,2\n"));
    EXPECT_NE(contents(scratch.path("a.obj")).find("g hull\nf 1 3 2\n"), std::string::npos);
    EXPECT_NE(contents(scratch.path("a.vtk")).find("CELLS 4 20\n4 0 1 2 4\n"), std::string::npos);
    EXPECT_EQ(run(triangulate({"--format", "vtk", "--quiet"})).out,
              contents(scratch.path("a.vtk")));
    const std::string flat = scratch.file("f.csv", "x,y,z\n0,0,0\n1,1,1\n2,2,2\n");
    EXPECT_TRUE(run({"triangulate", flat, "--metric", "power", "--format", "svg"})
                    .err.starts_with("sites    3, in space\nflat     all lie on a line\n"));
}

TEST_F(ToolInSpace, Generates) {
    EXPECT_EQ(run({"generate", "grid", "--dimension", "3", "-n", "8"}).out,
              "0 0 0 0\n700 0 0 0\n0 700 0 0\n700 700 0 0\n0 0 700 0\n700 0 700 0\n0 700 700 0\n"
              "700 700 700 0\n");
    const std::string csv = scratch.path("s.csv");
    EXPECT_EQ(run({"generate", "sphere", "--dimension", "3", "-n", "50", "--radius", "1:20",
                   "--perturb", "3", "--seed", "2", "-o", csv})
                  .code,
              0);
    EXPECT_TRUE(contents(csv).starts_with("x,y,z,r\n"));
    const Outcome outcome = run({"triangulate", csv, "--metric", "power", "--quiet"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    expect({"generate", "circle", "--dimension", "3", "-n", "3"}, 2,
           "signum: circle lies in the plane; leave --dimension 3 out, or take one of random, "
           "sphere, cube, grid\n");
    expect({"generate", "cube", "-n", "3"}, 2,
           "signum: cube lies in space; add --dimension 3, or take one of random, circle, square, "
           "grid, lattice, rings, offset, tangent\n");
}

TEST_F(ToolInSpace, PrintsSigns) {
    const Words corners = {"0", "0", "0", "1", "0", "0", "0", "1", "0", "0", "0", "1"};
    const auto ccw = [&](const Words& more) {
        Words words = {"sign", "ccw"};
        words.insert(words.end(), more.begin(), more.end());
        words.emplace_back("--");
        words.insert(words.end(), corners.begin(), corners.end());
        return run(words);
    };
    EXPECT_EQ(ccw({}).out, "1 filter\n");
    EXPECT_EQ(ccw({"--dimension", "3", "--json"}).out, "{\"sign\": 1, \"stage\": \"filter\"}\n");
    EXPECT_EQ(ccw({"--dimension", "2"}).err,
              "signum: sign ccw needs 6 numbers after --, x y of each of three points; 12 are "
              "given\n");
    const auto in_sphere = [](const Words& more, const Words& last) {
        Words words = {"sign", "in_sphere"};
        words.insert(words.end(), more.begin(), more.end());
        words.insert(words.end(), {"--", "0", "0", "0", "1", "1", "0", "0", "1", "0", "1", "0", "1",
                                   "0", "0", "1", "1"});
        words.insert(words.end(), last.begin(), last.end());
        return run(words);
    };
    const Words power = {"--metric", "power"};
    EXPECT_EQ(in_sphere(power, {"1", "1", "1", "2"}).out, "1 filter\n");
    EXPECT_EQ(in_sphere(power, {"1", "1", "1", "0.5"}).out, "-1 filter\n");
    const Outcome tie = in_sphere(power, {"1", "1", "1", "-1"});
    EXPECT_EQ(tie.out, "0 exact\n");
    EXPECT_EQ(tie.err,
              "tie      q touches the sphere of i, j, k and l\n"
              "rule     by falling weight, rising x, y, z and place q is the last of them: q does "
              "not conflict\n"
              "decided  not by the filter, but by integers, expansions or sums that commit no "
              "rounding\n");
    EXPECT_EQ(
        in_sphere({"--metric", "power", "--json"}, {"-0", "1", "1", "1"}).out,
        "{\"sign\": 0, \"stage\": \"exact\", \"tie\": {\"last\": \"j\", \"conflict\": false}}\n");
    EXPECT_EQ(in_sphere({"--metric", "power", "--weight-is", "weight"}, {"1", "1", "1", "-1"}).out,
              "-1 filter\n");
    EXPECT_EQ(in_sphere({}, {"1", "1", "1", "1"}).err,
              "signum: sign in_sphere: there is --metric power alone, and this is --metric "
              "euclidean; add --metric power\n");
    EXPECT_EQ(in_sphere(power, {"1", "1", "1"}).err,
              "signum: sign in_sphere needs 20 numbers after --, x y z r of each of the sites i, "
              "j, k, l and of the query; 19 are given\n");
    const auto on_four = [](const Words& third) {
        Words words = {"sign", "in_sphere", "--metric", "power", "--", "0", "0",
                       "0",    "1",         "0",        "1",     "0",  "1"};
        words.insert(words.end(), third.begin(), third.end());
        words.insert(words.end(), {"0", "0", "1", "1", "1", "1", "1", "1"});
        return run(words).err;
    };
    EXPECT_EQ(on_four({"1", "0", "0", "1"}),
              "signum: sign in_sphere: i, j, k, l must turn positively, as sign ccw --dimension 3 "
              "says, and turn negatively; exchange two of them\n");
    EXPECT_EQ(on_four({"0", "2", "0", "1"}),
              "signum: sign in_sphere: i, j, k, l must turn positively and lie in a plane: no "
              "sphere touches them; give four centres that do not\n");
    expect({"sign", "in_circle", "--dimension", "3", "--", "0"}, 2,
           "signum: sign in_circle: it is asked in the plane; leave --dimension 3 out, or ask "
           "in_sphere\n");
    expect({"sign", "in_sphere", "--dimension", "2", "--", "0"}, 2,
           "signum: sign in_sphere: it is asked in space; leave --dimension 2 out, or ask "
           "in_circle\n");
}

}  // namespace
}  // namespace signum
