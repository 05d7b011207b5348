/// The tool from outside, on sites in space.

#include <string>
#include <utility>
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
        "6\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\nA 4 0 0 1\nA 0 4 0 1\nA 0 0 4 "
        "1\nA 1 1 1 0.5\nA 1 1 1 0.25\n";
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
    expect(
        triangulate({"--method", "flips"}), 2,
        "signum: --method flips" + of_file + "the method incremental alone; leave --method out\n");
    expect(triangulate({"--arithmetic", "single"}), 2,
           "signum: --arithmetic single" + of_file +
               "the arithmetics exact and naive alone; leave --arithmetic out, or name one of "
               "them\n");
    const std::string svg = scratch.path("a.svg");
    expect(triangulate({"--clip", "0", "0", "1", "1", "-o", svg}), 2,
           "signum: --clip" + of_file + "pictures of all of them alone; leave --clip out\n");
    EXPECT_FALSE(std::filesystem::exists(svg));
    expect(triangulate({"--clip", "0", "0", "0", "1", "1", "1", "-o", svg}), 2,
           "signum: --clip takes 4 words after it, X0 Y0 X1 Y1, a box of the plane; 6 are given; "
           "see signum triangulate --help\n");
    const std::string vtu = scratch.path("a.vtu");
    expect(triangulate({"--columns", "x,y", "-o", vtu}), 2,
           "signum: vtu is written of sites in space, and those of " + balls +
               " lie in the plane; write vtp\n");
    EXPECT_FALSE(std::filesystem::exists(vtu));
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

TEST_F(ToolInSpace, IsHintedAtWhereThirdNumbersHideMostSites) {
    const std::string numbers = "0 0 9\n1 0 1\n0 1 2\n1 1 3\n";
    const std::string bare = scratch.file("bare.txt", numbers);
    const std::string hint = "signum: " + bare +
                             ": most sites are hidden, for the third number of a line is a radius; "
                             "if it is z, say --dimension 3 --metric power\n";
    for (const char* command : {"triangulate", "voronoi"}) {
        EXPECT_TRUE(run({command, bare}).err.ends_with(hint)) << command;
        EXPECT_EQ(run({command, bare, "--quiet"}).err.find("most sites"), std::string::npos);
        const std::string named = scratch.file("named.txt", "x y r\n" + numbers);
        const std::string few = scratch.file("few.txt", "0 0 9\n1 0 1\n20 1 2\n1 30 3\n");
        for (const Words& said :
             {Words{command, bare, "--dimension", "2"}, Words{command, bare, "--columns", "1,2,3"},
              Words{command, named}, Words{command, few}})
            EXPECT_EQ(run(said).err.find("most sites"), std::string::npos) << said[1];
    }
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

TEST_F(ToolInSpace, WritesVertices) {
    const std::string json = run(triangulate({"--vertices", "--quiet"})).out;
    const std::string alone = run(triangulate({"--quiet"})).out;
    // The same, and behind the hidden sites the vertices: null for infinite cells. The first one is
    // at (2, 2, z) by the corners 0, 1, 2, and its distance from (1, 1, 1) says -2.125 of z.
    const std::string same = alone.substr(0, alone.size() - 2);
    ASSERT_EQ(json.substr(0, same.size()), same);
    EXPECT_EQ(json.substr(same.size()),
              ",\n\"vertices\": [\nnull,\nnull,\nnull,\nnull,\n[2, 2, -2.125, 11.515625],\n"
              "[2, -2.125, 2, 11.515625],\n[-2.125, 2, 2, 11.515625],\n"
              "[6.125, 6.125, 6.125, 78.546875]]}\n");
    const std::string flat = scratch.file("flat.csv", "x,y,z\n0,0,5\n1,1,6\n");
    const Outcome outcome =
        run({"triangulate", flat, "--metric", "power", "--vertices", "--quiet"});
    EXPECT_TRUE(outcome.out.ends_with("\"vertices\": [\nnull,\nnull,\nnull]}\n")) << outcome.out;
    expect(triangulate({"--vertices", "-o", scratch.path("a.csv")}), 2,
           "signum: --vertices goes into JSON alone; add -o FILE.json\n");
}

TEST_F(ToolInSpace, TakesNaiveArithmetic) {
    EXPECT_EQ(run(triangulate({"--arithmetic", "naive", "--quiet"})).out,
              run(triangulate({"--quiet"})).out);
}

TEST_F(ToolInSpace, ComparesCells) {
    const Words words = {"compare", balls, "--metric", "power", "--seconds", "0"};
    const auto compare = [&](const Words& more) {
        Words all = words;
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    const Outcome table = compare({"--quiet"});
    EXPECT_EQ(table.code, 0);
    EXPECT_EQ(table.err, "");
    EXPECT_TRUE(
        table.out.starts_with("                                           naive             "
                              "      exact\nseconds, median "))
        << table.out;
    EXPECT_NE(
        table.out.find("\ncells                                          4                  "
                       "     4\nwrong                                    0 (0 %)            "
                       "     0 (0 %)\ndifferent                                0 (0 %)        "
                       "         0 (0 %)\n\nexact / naive time: "),
        std::string::npos)
        << table.out;
    EXPECT_TRUE(table.out.ends_with(
        "These sites do not need exactness: naive arithmetic got no cell of 4 wrong.\n"))
        << table.out;
    const Outcome json = compare({"--json", "--arithmetic", "exact", "--against", "naive"});
    EXPECT_TRUE(json.out.starts_with(
        "{\"cells\": 4, \"wrong\": 0, \"different\": 0, \"broken\": null, \"ratio\": "))
        << json.out;
    EXPECT_NE(json.out.find(",\n\"margins\": {\"facets\": 6, \"ties\": 0},\n\"answer\": \"These "),
              std::string::npos)
        << json.out;
    EXPECT_NE(json.out.find(",\n\"exact\": {\"cells\": 4, "), std::string::npos) << json.out;
    EXPECT_NE(json.out.find(",\n\"naive\": {\"cells\": 4, "), std::string::npos) << json.out;

    const std::string of_file = " of " + balls + " ";
    EXPECT_EQ(compare({"-o", scratch.path("a.svg")}).err,
              "signum: -o: pictures are of sites in the plane, and those" + of_file +
                  "lie in space; leave -o out\n");
    EXPECT_EQ(compare({"--format", "svg"}).err,
              "signum: --format: pictures are of sites in the plane, and those" + of_file +
                  "lie in space; leave --format out\n");
    EXPECT_EQ(compare({"--against", "sum"}).err,
              "signum: --against sum: sites in space, as those" + of_file +
                  "are, have the arithmetics exact and naive alone; leave --against out, or name "
                  "one of them\n");
    EXPECT_EQ(run({"compare", balls}).err,
              "signum: --metric euclidean: sites in space, as those" + of_file +
                  "are, have tessellations of the power metric alone; add --metric power, or say "
                  "--dimension 2 to leave z out\n");
    const std::string flat = scratch.file("flat.csv", "x,y,z\n0,0,5\n1,1,5\n0,1,5\n");
    const Outcome of_flat =
        run({"compare", flat, "--metric", "power", "--quiet", "--seconds", "0", "--json"});
    EXPECT_EQ(of_flat.code, 0);
    EXPECT_TRUE(of_flat.out.starts_with("{\"cells\": 1, \"wrong\": 0, ")) << of_flat.out;
}

TEST_F(ToolInSpace, ComparesWhatNaiveArithmeticGetsWrong) {
    const std::string sphere = scratch.path("sphere.csv");
    ASSERT_EQ(run({"generate", "sphere", "--dimension", "3", "-n", "100", "--perturb", "1e-11",
                   "-o", sphere})
                  .code,
              0);
    const Words words = {"compare", sphere, "--metric", "power", "--seconds", "0", "--quiet"};
    const Outcome wrong = run(words);
    EXPECT_EQ(wrong.code, 0);
    EXPECT_NE(wrong.out.find("\ncells "), std::string::npos) << wrong.out;
    EXPECT_NE(
        wrong.out.find("These sites need exactness: naive arithmetic got 2 of 284 cells wrong "
                       "(0.7 %).\n"),
        std::string::npos)
        << wrong.out;
}

TEST_F(ToolInSpace, SaysWhereNaiveArithmeticBreaks) {
    const std::string sphere = scratch.path("sphere.csv");
    ASSERT_EQ(run({"generate", "sphere", "--dimension", "3", "-n", "300", "-o", sphere}).code, 0);
    const Words words = {"compare", sphere, "--metric", "power", "--seconds", "0", "--quiet"};
    const Outcome table = run(words);
    EXPECT_EQ(table.code, 0);
    EXPECT_NE(table.out.find("\nnaive broke: "), std::string::npos) << table.out;
    EXPECT_EQ(table.out.find("exact / naive time"), std::string::npos) << table.out;
    EXPECT_TRUE(table.out.ends_with(
        "These sites need exactness: in naive arithmetic the structure broke.\n"))
        << table.out;
    Words with_json = words;
    with_json.emplace_back("--json");
    const Outcome json = run(with_json);
    EXPECT_EQ(json.code, 0);
    EXPECT_TRUE(json.out.starts_with(
        "{\"cells\": null, \"wrong\": null, \"different\": null, \"broken\": \""))
        << json.out;
    EXPECT_NE(json.out.find("\"ratio\": null"), std::string::npos) << json.out;

    const std::string file = scratch.path("a.json");
    const Outcome built = run({"triangulate", sphere, "--metric", "power", "--arithmetic", "naive",
                               "--quiet", "-o", file});
    EXPECT_EQ(built.code, 1);
    EXPECT_TRUE(built.err.starts_with(
        "signum: the structure broke, because naive arithmetic rounds its signs: "))
        << built.err;
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(ToolInSpace, SaysWhoTakesSitesInSpace) {
    const std::string atoms = scratch.file("a.xyz", "1\none\nH 0 0 0\n");
    const std::string wanted =
        "signum: " + atoms +
        ": by its ending it holds sites in space, and sites of the plane are wanted here; signum "
        "triangulate, voronoi and compare take it with --metric power (as lines x y [r] it is "
        "wrong: " +
        atoms + ":1:";
    const std::string plane = scratch.file("plane.txt", "0 0 0\n1 0 0\n0 1 0\n");
    const std::string json = scratch.path("plane.json");
    ASSERT_EQ(run({"triangulate", plane, "-o", json}).code, 0);
    for (const Words& words : {Words{"voronoi", atoms, "--dimension", "2", "--read-as", "text"},
                               Words{"validate", json, atoms}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_TRUE(outcome.err.starts_with(wanted)) << outcome.err;
    }
    // What are sites of the plane is read, whatever the name.
    const std::string lines = scratch.file("lines.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    EXPECT_EQ(run({"voronoi", lines, "--quiet", "--dimension", "2"}).code, 0);
    expect({"study", atoms}, 2,
           "signum: '" + atoms +
               "' is a word too many; a study makes its own sites, signum compare FILE judges "
               "yours; see signum study --help\n");
}

TEST_F(ToolInSpace, WritesCells) {
    const Words words = {"voronoi", balls,  "--metric", "power", "--clip", "-1",
                         "-1",      "-1.5", "5",        "5",     "5"};
    const Outcome json = run(words);
    EXPECT_EQ(json.code, 0);
    EXPECT_EQ(json.err,
              "sites    6, in space\ncells    5, 4 of them unbounded\nhidden   1\nvertices 4\n"
              "faces    10 between two cells\nbox      -1 -1 -1.5 5 5 5\n"
              "volume   234, of the box 234\n");
    EXPECT_TRUE(json.out.starts_with(
        "{\"format\": \"signum.voronoi\", \"version\": 1, \"dimension\": 3, \"metric\": "
        "\"power\", \"weight_is\": \"radius\", \"sites\": 6, \"clip\": [-1, -1, -1.5, 5, 5, 5],\n"
        "\"vertices\": [\n"))
        << json.out;
    const std::string csv = scratch.path("a.csv");
    const std::string vtk = scratch.path("a.vtk");
    const std::string svg = scratch.path("a.svg");
    const Outcome files =
        run({"voronoi", balls, "--metric", "power", "-o", csv, "-o", vtk, "-o", svg});
    EXPECT_EQ(files.code, 0);
    EXPECT_EQ(files.out, "");
    // A tenth of 4 beyond the centres.
    EXPECT_TRUE(
        files.err.ends_with("box      -0.4 -0.4 -0.4 4.4 4.4 4.4\nvolume   110.592, of the "
                            "box 110.592\nwritten  " +
                            csv + ", " + vtk + ", " + svg + "\n"))
        << files.err;
    EXPECT_TRUE(contents(csv).starts_with("site,volume,area,centroid_x,"));
    EXPECT_NE(contents(vtk).find("CELL_TYPES 5\n42\n42\n42\n42\n42\n"), std::string::npos);
    EXPECT_NE(contents(svg).find("cells: 5, all cut by the box"), std::string::npos);
    EXPECT_NE(run({"voronoi", balls, "--metric", "power", "--format", "svg", "--clip", "-9", "-9",
                   "-9", "9", "9", "9"})
                  .out.find("1 that the box does not cut are drawn, 4 that it cuts are not"),
              std::string::npos);
    EXPECT_EQ(run({"voronoi", balls, "--metric", "power", "--quiet"}).err, "");
    // FILE may follow the numbers; one site has the whole box.
    const std::string one = scratch.file("one.xyz", "1\none\nH 1 2 3\n");
    EXPECT_EQ(run({"voronoi", "--clip", "0", "0", "0", "4", "4", "4", one, "--metric", "power",
                   "--format", "csv", "--quiet"})
                  .out,
              "site,volume,area,centroid_x,centroid_y,centroid_z,faces,neighbours,face_areas\n"
              "0,64,96,2,2,2,6,-1 -2 -3 -4 -5 -6,16 16 16 16 16 16\n");
    EXPECT_TRUE(run({"voronoi", one, "--metric", "power"})
                    .err.ends_with("vertices 0\nfaces    0 between two cells\nbox      0 1 2 2 3 "
                                   "4\nvolume   8, of the box 8\n"));
}

TEST_F(ToolInSpace, RefusesWrongCallsOfVoronoi) {
    const auto refused = [&](const Words& more, const std::string& message) {
        Words words = {"voronoi", balls};
        words.insert(words.end(), more.begin(), more.end());
        expect(words, 2, "signum: " + message + "\n");
    };
    const std::string of_file = "as those of " + balls + " are, have ";
    refused({"--metric", "supremum"},
            "--metric supremum: sites in space, " + of_file +
                "tessellations of the power and euclidean metric alone; add --metric power, or say "
                "--dimension 2 to leave z out");
    refused(
        {"--metric", "power", "--clip", "0", "0", "1", "1"},
        "--clip: 4 numbers, but the sites of " + balls + " lie in space; give X0 Y0 Z0 X1 Y1 Z1");
    refused(
        {"--metric", "power", "--clip", "0", "0", "0", "1", "1"},
        "--clip: 5 numbers, but the sites of " + balls + " lie in space; give X0 Y0 Z0 X1 Y1 Z1");
    refused({"--metric", "power", "--clip", "0", "0", "2", "1", "1", "2"},
            "--clip 0 0 2 1 1 2: the corner with the least coordinates comes first, x0 < x1, "
            "y0 < y1 and z0 < z1");
    for (const char* last : {"nan", "inf"}) {
        const std::string message = std::string("--clip: '") + last +
                                    "' is not a finite number; write a finite one; see signum "
                                    "voronoi --help";
        refused({"--clip", "0", "0", "0", "1", "1", last}, message);
        refused({"--clip", "0", "0", "0", last, "1", "1"}, message);
        refused({"--clip", "0", "0", "1", last}, message);
        expect({"voronoi", "--clip", "0", "0", "0", "1", "1", last, balls}, 2,
               "signum: " + message + "\n");
    }
    refused({"--clip", "0", "0", "0", "1", "1", "-inf"},
            "'-inf' is not a finite number; write a finite one; see signum voronoi --help");
    refused({"--clip", "0", "0", "0", "1", "1", "x"},
            "--clip: 'x' is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 "
            "or 0x1.8p-3; see signum voronoi --help");
    const std::string csv = scratch.path("a.csv");
    refused({"--metric", "power", "--clip", "0", "0", "0", "1e-100", "1e-100", "1e-100", "-o", csv},
            "the box 0 0 0 1e-100 1e-100 1e-100: site 0 is not finite, or too large beside the "
            "box; cut the cells to another one with --clip");
    EXPECT_FALSE(std::filesystem::exists(csv));
    refused({"--metric", "power", "--tolerance", "1"},
            "--tolerance: cells in space, " + of_file + "no arcs; leave --tolerance out");
    refused({"--metric", "power", "--merge"},
            "--merge: cells in space, " + of_file + "vertices one by one alone; leave --merge out");
    refused({"--metric", "power", "--format", "geojson"},
            "geojson is written of sites in the plane, and those of " + balls +
                " lie in space; write vtk");
}

TEST_F(ToolInSpace, Validates) {
    const std::string json = scratch.path("a.json");
    const Outcome made = run(triangulate({"--check", "-o", json}));
    EXPECT_EQ(made.code, 0);
    EXPECT_TRUE(made.err.ends_with("\ncheck    valid, canonical\n")) << made.err;
    const Outcome good = run({"validate", json, balls});
    EXPECT_EQ(good.code, 0);
    EXPECT_EQ(good.out, "valid, canonical\n");
    EXPECT_EQ(good.err, "");
    EXPECT_EQ(run({"validate", "-", balls}, {.in = json}).out, "valid, canonical\n");
    EXPECT_EQ(run({"validate", json, "-"}, {.in = balls}).out, "valid, canonical\n");
    const std::string atoms =
        scratch.file("a.data",
                     "6\nProperties=species:S:1:pos:R:3:radius:R:1\nA 0 0 0 1\nA 4 0 0 1\nA 0 4 0 "
                     "1\nA 0 0 4 1\nA 1 1 1 .5\nA 1 1 1 .25\n");
    EXPECT_EQ(run({"validate", json, atoms, "--read-as", "xyz"}).out, "valid, canonical\n");

    using Change = std::pair<std::string, std::string>;
    const auto judged = [&](const std::vector<Change>& changes) {
        std::string text = contents(json);
        for (const auto& [from, to] : changes) {
            const auto place = text.find(from);
            EXPECT_NE(place, std::string::npos) << from;
            text.replace(place, from.size(), to);
        }
        return run({"validate", scratch.file("b.json", text), balls});
    };
    const Outcome turned =
        judged({{"[0, 1, 2, 4]", "[1, 2, 0, 4]"}, {"[7, 6, 5, 0]", "[6, 5, 7, 0]"}});
    EXPECT_EQ(turned.code, 0);
    EXPECT_TRUE(turned.out.starts_with("valid, not canonical: ")) << turned.out;
    for (const Change& change :
         {Change{"[0, 1, 2, 4]", "[0, 2, 1, 4]"}, Change{"[0, 1, 2, 4]", "[0, 1, 2, 3]"},
          Change{"[0, 1, 2, 4]", "[0, 1, 2, 77]"}, Change{"[7, 6, 5, 0]", "[7, 6, 0, 5]"},
          Change{"[5, 4]", "[5, 0]"}, Change{"\"sites\": 6", "\"sites\": 7"}}) {
        const Outcome wrong = judged({change});
        EXPECT_EQ(wrong.code, 1) << change.second;
        EXPECT_TRUE(wrong.out.starts_with("not valid: ")) << wrong.out;
        EXPECT_EQ(wrong.err, "signum: " + scratch.path("b.json") +
                                 " is not a valid tessellation of " + balls + "\n");
    }
    EXPECT_EQ(judged({{"\"power\"", "\"euclidean\""}}).err,
              "signum: " + scratch.path("b.json") +
                  ": its metric is euclidean, and in space there are tessellations of the power "
                  "metric alone\n");
    EXPECT_EQ(judged({{"\"dimension\": 3", "\"dimension\": 2"}}).err,
              scratch.path("b.json") +
                  ":3:1: 4 numbers in an entry of \"cells\", not 3; a tessellation is what signum "
                  "triangulate writes as JSON\n");

    // A tessellation of flat sites, and sites in the plane, which have no z.
    const std::string flat = scratch.file("flat.csv", "x,y,z\n0,0,5\n1,1,5\n0,1,5\n");
    ASSERT_EQ(run({"triangulate", flat, "--metric", "power", "-o", json, "--quiet"}).code, 0);
    EXPECT_EQ(run({"validate", json, flat}).out, "valid, canonical\n");
    EXPECT_EQ(run({"validate", json, balls}).code, 1);
    const std::string plane = scratch.file("plane.csv", "x,y\n0,0\n1,1\n0,1\n");
    EXPECT_EQ(run({"validate", json, plane}).code, 2);
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
    expect({"generate", "grid", "--dimension", "3", "-n", "268435457"}, 2,
           "signum: -n 268435457: give a number of sites from 1 to 268435456\n");
    expect({"generate", "circle", "--dimension", "3", "-n", "3"}, 2,
           "signum: circle lies in the plane; leave --dimension 3 out, or take one of random, "
           "sphere, cube, grid, hard\n");
    expect({"generate", "cube", "-n", "3"}, 2,
           "signum: cube lies in space; add --dimension 3, or take one of random, circle, square, "
           "grid, lattice, rings, offset, tangent, hard\n");
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
    EXPECT_EQ(in_sphere({"--metric", "supremum"}, {"1", "1", "1", "1"}).err,
              "signum: sign in_sphere: infinitely many cubes touch i, j, k and l; give four other "
              "sites\n");
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

TEST_F(ToolInSpace, PrintsSignsOfEuclideanSpheres) {
    const Words balls_of_corners = {"0", "0", "0", "1", "4", "0", "0", "1",
                                    "0", "4", "0", "1", "0", "0", "4", "1"};
    const auto in_sphere = [](const Words& four, const Words& last, const Words& more = {}) {
        Words words = {"sign", "in_sphere", "--metric", "euclidean"};
        words.insert(words.end(), more.begin(), more.end());
        words.emplace_back("--");
        words.insert(words.end(), four.begin(), four.end());
        words.insert(words.end(), last.begin(), last.end());
        return run(words);
    };
    const Outcome inside = in_sphere(balls_of_corners, {"2", "2", "2", "0"});
    EXPECT_EQ(inside.out, "1 filter\n");
    EXPECT_EQ(inside.err, "");
    EXPECT_EQ(in_sphere(balls_of_corners, {"9", "9", "9", "1"}).out, "-1 filter\n");
    const Outcome hidden = in_sphere(balls_of_corners, {"0", "0", "0", "0.5"});
    EXPECT_EQ(hidden.out, "-1 filter\n");
    EXPECT_EQ(hidden.err, "hidden   i hides q\n");
    // Of equal radii it is the sphere of the centres, which goes through (4, 4, 4).
    const Outcome tie = in_sphere(balls_of_corners, {"4", "4", "4", "1"});
    EXPECT_TRUE(tie.out.starts_with("0 ")) << tie.out;
    EXPECT_TRUE(
        tie.err.starts_with("tie      q touches the sphere of i, j, k and l; the metric has "
                            "no tie rule in space\ndecided  "))
        << tie.err;
    const std::string json = in_sphere(balls_of_corners, {"4", "4", "4", "1"}, {"--json"}).out;
    EXPECT_TRUE(json.starts_with("{\"sign\": 0, \"stage\": \"")) << json;
    EXPECT_EQ(json.find("tie"), std::string::npos) << json;

    const auto refused = [&](const Words& four, const std::string& why) {
        const Outcome outcome = in_sphere(four, {"2", "2", "2", "0"});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "signum: sign in_sphere: " + why + "\n");
    };
    const std::string no_sphere =
        "no sphere touches i, j, k and l in points that turn positively; ";
    refused({"4", "0", "0", "1", "0", "0", "0", "1", "0", "4", "0", "1", "0", "0", "4", "1"},
            no_sphere + "one touches them in points that turn negatively: exchange two of them");
    refused({"0", "0", "0", "1", "4", "0", "0", "1", "8", "0", "0", "1", "12", "0", "0", "1"},
            no_sphere +
                "none touches them in points that turn negatively either: give four other sites");
    refused({"0", "0", "0", "1", "0.5", "0", "0", "0", "0", "4", "0", "1", "0", "0", "4", "1"},
            "i hides j, so that no sphere touches i, j, k and l; leave j out");
    EXPECT_EQ(in_sphere(balls_of_corners, {"1"}, {"--weight-is", "radius"}).code, 2);
    EXPECT_EQ(in_sphere(balls_of_corners, {"1"}).err,
              "signum: sign in_sphere needs 20 numbers after --, x y z r of each of the sites i, "
              "j, k, l and of the query; 17 are given\n");
}

/// sign in_sphere of a metric, five sites behind it.
Outcome in_sphere_of(const char* metric, const Words& sites, const Words& more = {}) {
    Words words = {"sign", "in_sphere", "--metric", metric};
    words.insert(words.end(), more.begin(), more.end());
    words.emplace_back("--");
    words.insert(words.end(), sites.begin(), sites.end());
    return run(words);
}

/// Four sites, and one that is asked about.
Words five(const Words& four, const Words& last) {
    Words words = four;
    words.insert(words.end(), last.begin(), last.end());
    return words;
}

TEST_F(ToolInSpace, PrintsSignsOfCubes) {
    const Words four = {"0", "0", "0", "1", "6", "1", "2", "1",
                        "1", "7", "3", "1", "2", "3", "8", "1"};
    const Outcome inside = in_sphere_of("supremum", five(four, {"4", "4", "4", "0"}));
    EXPECT_EQ(inside.code, 0);
    EXPECT_EQ(inside.out, "1 filter\n");
    EXPECT_EQ(inside.err, "");
    EXPECT_EQ(in_sphere_of("Chebyshev", five(four, {"40", "4", "4", "0"})).out, "-1 filter\n");
    const Outcome hidden = in_sphere_of("supremum", five(four, {"0", "0", "0", "0.5"}));
    EXPECT_EQ(hidden.out, "-1 filter\n");
    EXPECT_EQ(hidden.err, "hidden   i hides q\n");
    // One of the sites itself touches.
    const Outcome tie = in_sphere_of("supremum", five(four, {"0", "0", "0", "1"}));
    EXPECT_TRUE(tie.out.starts_with("0 ")) << tie.out;
    EXPECT_TRUE(
        tie.err.starts_with("hidden   i hides q\nhidden   q hides i\ntie      q touches the cube "
                            "of i, j, k and l; the metric has no tie rule in space\n"))
        << tie.err;
    EXPECT_EQ(in_sphere_of("supremum", five(four, {"0", "0", "0", "1"}), {"--json"}).out.find("ti"),
              std::string::npos);
    EXPECT_EQ(in_sphere_of("supremum", five(four, {"4", "4", "4", "0"}), {"--sphere", "0"}).out,
              "1 filter\n");
    EXPECT_EQ(in_sphere_of("supremum", five(four, {"4", "4", "4", "0"}), {"--sphere", "1"}).err,
              "signum: --sphere 1: one cube alone touches i, j, k and l; leave --sphere out\n");
}

TEST_F(ToolInSpace, AsksWhichOfSeveralSpheresIsMeant) {
    const Words cubes = {"2", "2", "9", "1", "4", "9", "6", "2",
                         "7", "5", "4", "1", "5", "0", "4", "2"};
    const std::string both =
        "2 cubes touch i, j, k and l; say which is meant: --sphere 0 is that around 3.5 4.5 5.5 "
        "with radius 2.5, --sphere 1 is that around 5.5 4.5 7.5 with radius 2.5\n";
    const Words near_the_first = five(cubes, {"2", "4", "5", "0"});
    const Outcome unsaid = in_sphere_of("supremum", near_the_first);
    EXPECT_EQ(unsaid.code, 2);
    EXPECT_EQ(unsaid.out, "");
    EXPECT_EQ(unsaid.err, "signum: sign in_sphere: " + both);
    EXPECT_EQ(in_sphere_of("supremum", near_the_first, {"--sphere", "0"}).out, "1 filter\n");
    EXPECT_EQ(in_sphere_of("supremum", near_the_first, {"--sphere", "1"}).out, "-1 filter\n");
    EXPECT_EQ(in_sphere_of("supremum", near_the_first, {"--sphere", "2"}).err,
              "signum: --sphere 2: " + both);

    // Six octahedra; the site lies on all of them.
    const Words octahedra = {"0",  "0",  "0", "0",  "7",   "15", "-10", "-6",  "1", "3",
                             "-2", "-5", "8", "16", "-11", "-4", "0.5", "8.5", "9", "0"};
    EXPECT_TRUE(in_sphere_of("manhattan", octahedra)
                    .err.starts_with("signum: sign in_sphere: 6 octahedra touch i, j, k and l; say "
                                     "which is meant: --sphere 0 is that around 0.5 8.5 -10.5 with "
                                     "radius 19.5, --sphere 1 is "));
    const Outcome tie = in_sphere_of("manhattan", octahedra, {"--sphere", "0"});
    EXPECT_TRUE(tie.out.starts_with("0 ")) << tie.out;
    EXPECT_TRUE(tie.err.starts_with("tie      q touches the octahedron of ")) << tie.err;
}

TEST_F(ToolInSpace, SaysWhyThereIsNoCube) {
    const auto refused = [](const Words& four, const std::string& why) {
        const Outcome outcome = in_sphere_of("supremum", five(four, {"4", "4", "4", "0"}));
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "signum: sign in_sphere: " + why + "\n");
    };
    refused({"9", "4", "5", "2", "8", "0", "7", "0", "0", "2", "1", "1", "7", "3", "6", "2"},
            "no cube touches i, j, k and l; give four other sites");
    refused({"2", "0", "0", "0", "3", "2", "2", "1", "5", "3", "8", "2", "3", "2", "3", "1"},
            "infinitely many cubes touch i, j, k and l; give four other sites");
    refused({"6", "5", "6", "2", "0", "7", "0", "2", "2", "9", "3", "0", "3", "7", "5", "2"},
            "l hides k, so that no cube touches i, j, k and l; leave k out");
    EXPECT_EQ(run({"sign", "ccw", "--sphere", "0", "--", "0"}).err,
              "signum: --sphere is of in_sphere alone, and this is ccw; leave it out\n");
    EXPECT_EQ(in_sphere_of("power", {"0"}, {"--sphere", "0"}).err,
              "signum: --sphere: in the power metric four sites have one sphere; leave it out\n");
    EXPECT_EQ(
        in_sphere_of("euclidean", {"0"}, {"--sphere", "0"}).err,
        "signum: --sphere: in the euclidean metric four sites have two spheres at most, which "
        "their order tells apart; leave it out\n");
    EXPECT_EQ(in_sphere_of("supremum", {"0"}, {"--sphere", "6"}).err,
              "signum: --sphere: '6' is unknown; it is one of 0, 1, 2, 3, 4, 5; see signum sign "
              "--help (numbers stand after --)\n");
}

}  // namespace
}  // namespace signum
