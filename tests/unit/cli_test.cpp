/// The tool from outside: what it prints, what it writes, how it ends.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/tessellation.hpp"

#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::Circumstances;
using test::contents;
using test::Outcome;
using test::run;
using test::Scratch;
using Words = test::Words;

/// A file of four sites: a triangle with one hidden in it.
class Tool : public testing::Test {
 protected:
    Scratch scratch;
    std::string sites =
        scratch.file("sites.txt", "x y r\n0 0 1\n4 0 1\n0 4 1\n1 1 0.5\n1 1 0.25\n");

    [[nodiscard]] Words triangulate(const Words& more) const {
        Words words = {"triangulate", sites, "--metric", "power"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    void expect(const Words& words, int code, const std::string& err) const {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, code);
        EXPECT_EQ(outcome.err, err);
        EXPECT_EQ(outcome.out, "");
    }
};

TEST_F(Tool, SaysItsVersionAndHelps) {
    EXPECT_EQ(run({"--version"}).out, "signum 0.1.0\n");
    for (const Words& words : {Words{"--help"}, Words{"triangulate", "--help"}, Words{"sign", "-h"},
                               Words{"voronoi", "--help"}, Words{"generate", "--help"},
                               Words{"validate", "--help"}, Words{"compare", "--help"}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("Example"), std::string::npos);
        EXPECT_TRUE(outcome.out.ends_with('\n'));
    }
    EXPECT_EQ(run({"--help"}, {.out = "/dev/full"}).code, 3);
}

TEST_F(Tool, RefusesWrongCalls) {
    const Outcome outcome = run({});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(outcome.err.starts_with("Signs that are right")) << outcome.err;
    expect({"simplify"}, 2, "signum: 'simplify' is no subcommand; see signum --help\n");
    expect({"triangulate"}, 2,
           "signum: FILE is missing; the least is signum triangulate FILE; see signum triangulate "
           "--help\n");
    const std::string help = "; see signum triangulate --help\n";
    expect(triangulate({"--foo"}), 2, "signum: triangulate has no option '--foo'" + help);
    expect({"triangulate", sites, "--meric", "power"}, 2,
           "signum: triangulate has no option '--meric'; did you mean --metric? See signum "
           "triangulate --help\n");
    expect({"triangulat", sites}, 2,
           "signum: 'triangulat' is no subcommand; did you mean triangulate? See signum --help\n");
    expect({"--metric", "power", "triangulate", sites}, 2,
           "signum: '--metric' stands before the subcommand; write signum SUBCOMMAND first, then "
           "its options; see signum --help\n");
    expect({"voronoi", sites, "--vertices"}, 2,
           "signum: voronoi has no option '--vertices'; triangulate has it; see signum voronoi "
           "--help\n");
    expect({"validate", "--json", sites, sites}, 2,
           "signum: validate has no option '--json'; compare, sign and torture have it; see signum "
           "validate "
           "--help\n");
    expect(triangulate({"--metric"}), 2,
           "signum: --metric needs a word after it: --metric NAME" + help);
    expect(triangulate({"--metric", "power"}), 2,
           "signum: --metric is given 2 times; give it once" + help);
    expect(triangulate({"more.txt"}), 2,
           "signum: 'more.txt' is a word too many; the least is signum triangulate FILE" + help);
    expect(triangulate({"--quiet=no"}), 2, "signum: --quiet takes no value" + help);
    expect({"compare", sites, "--seconds", "-1"}, 2,
           "signum: --seconds: '-1' is not from 0 to 86400; see signum compare --help\n");
    expect({"voronoi", sites, "--clip", "1", "2", "3"}, 2,
           "signum: --clip takes 4 or 6 words after it, X0 Y0 [Z0] X1 Y1 [Z1]; 3 are given; see "
           "signum voronoi "
           "--help\n");
    expect({"triangulate", sites, "--metric", "euclidian"}, 2,
           "signum: --metric: 'euclidian' is unknown; did you mean euclidean? it is one of power, "
           "euclidean, manhattan, supremum" +
               help);
    expect(triangulate({"--seed", "-1"}), 2,
           "signum: --seed: '-1' is no whole number from 0 to 2^64 - 1; see signum triangulate "
           "--help\n");
    for (const char* word : {"-1", "two", "1025"})
        expect(triangulate({"--threads", word}), 2,
               "signum: --threads: '" + std::string(word) +
                   "' is no whole number from 0 to 1024; see signum triangulate --help\n");
}

TEST_F(Tool, TakesNoOptionAfterTheEndOfOptions) {
    const std::string help = "; see signum triangulate --help\n";
    const std::string least = "; the least is signum triangulate FILE" + help;
    const Outcome plain = run({"triangulate", sites, "--quiet"});
    EXPECT_EQ(run({"triangulate", "--quiet", "--", sites}).out, plain.out);
    EXPECT_EQ(run({"triangulate", "--quiet", sites, "--"}).out, plain.out);
    expect({"triangulate", "--", "-foo"}, 2,
           "-foo: cannot open it (No such file or directory); give a file of sites, or - for "
           "standard input\n");
    expect({"triangulate", "--", sites, "--quiet"}, 2,
           "signum: '--quiet' is a word too many, no option after --" + least);
    for (const Words& before :
         {Words{"triangulate", "--", sites}, Words{"triangulate", sites, "--"}}) {
        Words words = before;
        words.emplace_back("more.txt");
        expect(words, 2, "signum: 'more.txt' is a word too many" + least);
    }
    expect({"triangulate", "--", sites, "--meric", "power"}, 2,
           "signum: '--meric' is a word too many, no option after --" + least);
    expect({"triangulate", "--meric", "--", sites}, 2,
           "signum: triangulate has no option '--meric'; did you mean --metric? See signum "
           "triangulate --help\n");
    expect({"generate", "--", "random"}, 2,
           "signum: -n is missing; the least is signum generate DISTRIBUTION -n N; see signum "
           "generate --help\n");
    for (const Words& words :
         {Words{"sign", "in_cirle", "0", "0"}, Words{"sign", "in_cirle", "--", "0", "-1"}}) {
        expect(
            words, 2,
            "signum: PREDICATE: 'in_cirle' is unknown; did you mean in_circle? it is one of ccw, "
            "in_circle, in_sphere, orient2d, incircle, orient3d, insphere, -; see signum sign "
            "--help (numbers stand after --)\n");
    }
}

TEST_F(Tool, SaysWhichNumberNoFloatReaches) {
    const std::string text = scratch.file("t.txt", "0 0\n1 0\n0 -1e39\n1e300 1\n");
    const std::string json = scratch.file("s.json", "[[0,0],\n[1,0],[0,4e38]]");
    const std::string what =
        ": a number beyond single precision, 3.4e38; take another arithmetic than single, or write "
        "smaller numbers\n";
    expect({"triangulate", text, "--arithmetic", "single"}, 2, text + ":3:3" + what);
    expect({"triangulate", json, "--arithmetic", "single"}, 2, json + ":2:10" + what);
    expect({"compare", text, "--arithmetic", "single"}, 2, text + ":3:3" + what);
    expect({"compare", text, "--against", "single"}, 2, text + ":3:3" + what);
    EXPECT_EQ(run({"triangulate", json}).code, 0);
}

TEST_F(Tool, SaysWhatThisVersionDoesNotHave) {
    expect(
        {"triangulate", sites, "--metric", "taxi"}, 2,
        "signum: --metric: 'taxi' is unknown; it is one of power, euclidean, manhattan, supremum; "
        "see signum triangulate --help\n");
    EXPECT_EQ(run({"sign", "in_circle", "--metric", "taxi", "--", "1"}).code, 2);
    expect(triangulate({"--method", "sweep"}), 2,
           "signum: --method sweep builds only manhattan and supremum, and this is --metric power; "
           "leave --method out, or add --metric supremum\n");
    expect({"triangulate", sites, "--method", "flips"}, 2,
           "signum: --method flips builds only power, and this is --metric euclidean; leave "
           "--method out, or add --metric power\n");
    for (const std::string arithmetic : {"naive", "single", "interval", "sum", "multiprecision"}) {
        expect(triangulate({"--method", "flips", "--arithmetic", arithmetic.c_str()}), 2,
               "signum: --method flips has exact arithmetic alone; leave --arithmetic " +
                   arithmetic + " out\n");
    }
    expect(triangulate({"--arithmetic", "double"}), 2,
           "signum: --arithmetic: 'double' is unknown; it is one of exact, naive, single, "
           "interval, sum, multiprecision; see signum triangulate --help\n");
}

TEST_F(Tool, WritesJsonToStandardOutput) {
    const Outcome outcome = run(triangulate({}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out,
              "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", "
              "\"weight_is\": \"radius\", \"sites\": 5,\n"
              "\"faces\": [\n[-1, 0, 2],\n[-1, 1, 0],\n[-1, 2, 1],\n[0, 1, 3],\n[0, 3, 2],\n"
              "[1, 2, 3]],\n"
              "\"neighbours\": [\n[4, 2, 1],\n[3, 0, 2],\n[5, 1, 0],\n[5, 4, 1],\n[5, 0, 3],\n"
              "[4, 3, 2]],\n"
              "\"hidden\": [\n[4, 3]]}\n");
    EXPECT_TRUE(
        outcome.err.starts_with("sites    5\nvisible  4\nhidden   1\nfaces    6, 3 of them "
                                "infinite\nseconds  "))
        << outcome.err;
    EXPECT_EQ(run(triangulate({"--quiet"})).err, "");
    EXPECT_EQ(run({"triangulate", "-", "--metric", "power"}, {.in = sites}).out, outcome.out);
}

TEST_F(Tool, WritesTheSameBytesWhateverTheSeed) {
    const std::string input = scratch.path("random.csv");
    ASSERT_EQ(run({"generate", "random", "-n", "2000", "--radius", "0:30", "-o", input}).code, 0);
    const Words words = {"triangulate", input, "--metric", "power", "--quiet"};
    const auto with = [&](const Words& more) {
        Words all = words;
        all.insert(all.end(), more.begin(), more.end());
        return run(all).out;
    };
    const std::string once = with({});
    EXPECT_GT(once.size(), 10'000U);
    EXPECT_EQ(with({}), once);
    EXPECT_EQ(with({"--seed", "99"}), once);
    EXPECT_EQ(with({"--threads", "3"}), once);
    EXPECT_EQ(with({"--arithmetic", "multiprecision"}), once);
}

TEST_F(Tool, FlipsToTheSameTessellation) {
    const std::string input = scratch.path("random.csv");
    ASSERT_EQ(run({"generate", "random", "-n", "500", "--radius", "0:40", "-o", input}).code, 0);
    const Words words = {"triangulate", input, "--metric", "power"};
    Words flips = words;
    const std::string svg = scratch.path("a.svg");
    flips.insert(flips.end(), {"--method", "flips"});
    const Outcome outcome = run(flips);
    EXPECT_EQ(outcome.out, run(words).out);
    EXPECT_NE(outcome.err.find("\nflips    "), std::string::npos) << outcome.err;
    flips.insert(flips.end(), {"-o", svg, "--check"});
    EXPECT_EQ(run(flips).code, 0);
    EXPECT_NE(contents(svg).find("flipped edges"), std::string::npos);
}

TEST_F(Tool, SweepsToTheSameTessellation) {
    const std::string input = scratch.path("random.csv");
    ASSERT_EQ(run({"generate", "random", "-n", "500", "--radius", "0:40", "-o", input}).code, 0);
    for (const char* metric : {"manhattan", "supremum"}) {
        const Words words = {"triangulate", input, "--metric", metric, "--check"};
        Words sweep = words;
        sweep.insert(sweep.end(), {"--method", "sweep"});
        const Outcome outcome = run(sweep);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.out, run(words).out);
        EXPECT_NE(outcome.err.find("\nevents   "), std::string::npos) << outcome.err;
    }
}

TEST_F(Tool, ComparesAndSaysWhetherExactnessIsNeeded) {
    const std::string circle = scratch.path("circle.txt");
    ASSERT_EQ(run({"generate", "circle", "-n", "300", "-o", circle}).code, 0);
    const std::string picture = scratch.path("wrong.svg");
    const Outcome table = run({"compare", circle, "--dimension", "2", "--metric", "power",
                               "--seconds", "0", "--quiet", "-o", picture});
    EXPECT_EQ(table.code, 0);
    EXPECT_EQ(table.err, "");
    EXPECT_NE(table.out.find("\nwrong "), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("exact / naive time: "), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("These sites need exactness: naive arithmetic got "),
              std::string::npos)
        << table.out;
    EXPECT_NE(contents(picture).find(">wrong edges<"), std::string::npos);

    const Outcome json = run({"compare", sites, "--metric", "power", "--seconds", "0", "--json"});
    EXPECT_EQ(json.code, 0);
    EXPECT_TRUE(json.out.starts_with(
        "{\"edges\": 6, \"wrong\": 0, \"different\": 0, \"broken\": null, \"ratio\": "))
        << json.out;
    EXPECT_NE(json.out.find("\n\"naive\": {\"edges\": 6, "), std::string::npos) << json.out;
    EXPECT_NE(json.out.find("\n\"exact\": {\"edges\": 6, "), std::string::npos) << json.out;
    EXPECT_NE(json.out.find("These sites do not need exactness"), std::string::npos) << json.out;
    EXPECT_NE(json.out.find("\"rounds\": 3,"), std::string::npos) << json.out;  // at least
}

/// Doubles get no edge wrong here, but hide a site that is visible.
TEST_F(Tool, ComparesWithARunThatLosesSites) {
    const std::string lost =
        scratch.file("lost.txt",
                     "0.0004 0.00013333333333333334\n0.001 0.0003333333333333333\n"
                     "0.0008 0.0002666666666666667\n0.001 0.00033333333333343334\n"
                     "0.0009000000000000001 0.00030000000000000003\n0.5 3\n"
                     "5 0.051737513312367936\n");
    const auto answer = [&](const std::string& judged, const std::string& against) {
        const Outcome table = run({"compare", lost, "--metric", "power", "--seconds", "0",
                                   "--arithmetic", judged, "--against", against});
        EXPECT_EQ(table.code, 0);
        return table.out.substr(table.out.rfind("\n", table.out.size() - 2) + 1);
    };
    for (const std::string& found : {answer("naive", "exact"), answer("exact", "naive")})
        EXPECT_TRUE(
            found.starts_with("These sites need exactness: naive arithmetic got no edge of "
                              "12 wrong, but others are missing, or sites (site 1 "))
            << found;
    EXPECT_TRUE(answer("interval", "exact").starts_with("Both arithmetics are exact: "));
}

TEST_F(Tool, ComparesWithARunThatBreaks) {
    const std::string offset = scratch.path("offset.txt");
    ASSERT_EQ(run({"generate", "offset", "-n", "1000", "--radius", "1", "-o", offset}).code, 0);
    const Outcome table = run({"compare", offset, "--metric", "manhattan", "--seconds", "0"});
    EXPECT_EQ(table.code, 0);
    EXPECT_NE(table.out.find("naive broke: "), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("in naive arithmetic the structure broke"), std::string::npos);
    EXPECT_EQ(table.out.find("exact / naive time"), std::string::npos) << table.out;

    const Outcome json =
        run({"compare", offset, "--metric", "manhattan", "--seconds", "0", "--json"});
    EXPECT_EQ(json.code, 0);
    EXPECT_TRUE(
        json.out.starts_with("{\"edges\": null, \"wrong\": null, \"different\": null, "
                             "\"broken\": \""))
        << json.out;
    EXPECT_NE(json.out.find("\"ratio\": null"), std::string::npos) << json.out;

    const std::string picture = scratch.path("none.svg");
    const Outcome drawn =
        run({"compare", offset, "--metric", "manhattan", "--seconds", "0", "-o", picture});
    EXPECT_EQ(drawn.code, 1);
    EXPECT_NE(drawn.err.find("there is nothing to draw"), std::string::npos) << drawn.err;
    EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST_F(Tool, ComparesOfATieTheChoiceAlone) {
    const std::string grid = scratch.path("grid.txt");
    ASSERT_EQ(run({"generate", "grid", "-n", "100", "-o", grid}).code, 0);
    const Outcome outcome = run({"compare", grid, "--metric", "power", "--seconds", "0"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("exactness only for a result that does not depend on their order"),
              std::string::npos)
        << outcome.out;
}

TEST_F(Tool, RefusesComparisonsThatSayNothing) {
    expect({"compare", sites, "--arithmetic", "exact"}, 2,
           "signum: --arithmetic and --against are both exact; name two\n");
    EXPECT_EQ(run({"compare", sites, "-o", scratch.path("out.json")}).code, 2);
    EXPECT_EQ(run({"compare", sites, "--against", "guess"}).code, 2);
}

TEST_F(Tool, WritesSeveralFiles) {
    const std::string json = scratch.path("a.json");
    const std::string csv = scratch.path("a.csv");
    const std::string obj = scratch.path("a.obj");
    const std::string svg = scratch.path("a.SVG");
    // An output takes one word: the input may stand after it.
    const Outcome outcome =
        run({"triangulate", "--metric", "power", "-o", json, "-o", csv, "--output", obj, "-o", svg,
             sites, "--vertices", "--stats", "--check"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("written  " + json + ", " + csv + ", " + obj + ", " + svg),
              std::string::npos);
    EXPECT_NE(outcome.err.find("check    valid, canonical\n"), std::string::npos);
    EXPECT_NE(contents(json).find("\"vertices\""), std::string::npos);
    EXPECT_NE(contents(json).find("\"refined\": "), std::string::npos);
    EXPECT_EQ(contents(json).find("\"ccw\": null"), std::string::npos);
    EXPECT_TRUE(contents(csv).starts_with("a,b,c\n-1,0,2\n"));
    EXPECT_NE(contents(obj).find("f 1 2 4\n"), std::string::npos);
    EXPECT_NE(contents(svg).find("<svg"), std::string::npos);
    EXPECT_EQ(scratch.size(), 5U);
}

TEST_F(Tool, WeighsAsAskedForAndAsTheHeaderSays) {
    const std::string weighted =
        scratch.file("w.csv", "x,y,weight\n0,0,0\n9,0,0\n0,9,0\n1,1,-17\n");
    const Words words = {"triangulate", weighted, "--metric", "power"};
    // The circle about the triangle has rho = 40.5 and (1, 1) lies at 24.5 + 17; a radius of -17
    // weighs 289.
    EXPECT_NE(run(words).out.find("\"weight_is\": \"weight\""), std::string::npos);
    EXPECT_NE(run(words).out.find("\"hidden\": [\n[3, 0]]"), std::string::npos);
    Words radius = words;
    radius.insert(radius.end(), {"--weight-is", "radius"});
    EXPECT_NE(run(radius).out.find("\"weight_is\": \"radius\""), std::string::npos);
    EXPECT_EQ(run(radius).out.find("[3, 0]]"), std::string::npos);
}

TEST_F(Tool, WarnsOfNegativeRadiiThatWillBeSquared) {
    const std::string negative = scratch.file("n.txt", "x y r\n0 0 1\n9 0 -2\n0 9 -3\n");
    const auto with = [&](const Words& more) {
        Words words = {"triangulate", negative, "--quiet"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words).err;
    };
    EXPECT_EQ(
        with({"--metric", "power"}),
        "signum: " + negative +
            ":3:5: the radius -2 is negative, the first of 2, and the power metric squares "
            "radii; say --weight-is weight if weights are meant, --weight-is radius if not\n");
    EXPECT_EQ(with({"--metric", "power", "--weight-is", "radius"}), "");
    EXPECT_EQ(with({"--metric", "power", "--weight-is", "weight"}), "");
    EXPECT_EQ(with({"--metric", "supremum"}), "");
}

TEST_F(Tool, TakesTheColumnsThatAreNamed) {
    const std::string cities =
        scratch.file("c.csv", "name,lon,lat,height\na,0,0,1\nb,4,0,1\nc,0,4,1\nd,1,1,9\n");
    const std::string plain = scratch.file("p.txt", "0 0\n4 0\n0 4\n1 1\n");
    const std::string json = scratch.path("a.json");
    const Outcome expected = run({"triangulate", plain, "--quiet"});
    for (const char* columns : {"lon,lat", "2,3", "LON, Lat"}) {
        const Outcome outcome = run({"triangulate", cities, "--columns", columns, "--quiet"});
        EXPECT_EQ(outcome.code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(outcome.out, expected.out);
    }
    EXPECT_EQ(run({"voronoi", cities, "--columns", "lon,lat", "--quiet"}).out,
              run({"voronoi", plain, "--quiet"}).out);
    EXPECT_EQ(run({"compare", cities, "--columns", "lon,lat", "--seconds", "0"}).code, 0);
    ASSERT_EQ(run({"triangulate", plain, "--quiet", "-o", json}).code, 0);
    EXPECT_EQ(run({"validate", json, cities, "--columns", "lon,lat"}).out, "valid, canonical\n");
    expect({"triangulate", cities, "--columns", "lon,lat,hight"}, 2,
           cities +
               ":1:1: no column is called 'hight'; did you mean 'height'? there are 'name', "
               "'lon', 'lat', 'height'\n");
    for (const char* columns : {"lon", "1,2,3,4,5", "lon,,lat", ","}) {
        expect({"triangulate", cities, "--columns", columns}, 2,
               std::string("signum: --columns ") + columns +
                   ": give two or three, in space three or four, with commas between, by name or "
                   "number, as in --columns lon,lat or --columns 2,3,5\n");
    }
    for (const char* columns : {"lon", "1,2,3,4", "lon,,lat", ","}) {
        expect({"voronoi", cities, "--columns", columns, "--dimension", "2"}, 2,
               std::string("signum: --columns ") + columns +
                   ": give two or three with commas between, by name or number, as in --columns "
                   "lon,lat or --columns 2,3,5\n");
    }
    // A third column that no header calls a radius is left out, with a word.
    const std::string third = scratch.file("t.csv", "x,y,h\n0,0,5\n4,0,5\n0,4,5\n1,1,5\n");
    const Outcome left_out = run({"triangulate", third, "--quiet"});
    EXPECT_EQ(left_out.code, 0);
    EXPECT_EQ(left_out.out, expected.out);
    EXPECT_TRUE(left_out.err.starts_with("signum: " + third + ":1: 'h' is left out: "))
        << left_out.err;
    // One called z says that sites lie in space, unless the call says that they do not.
    const std::string heights = scratch.file("z.csv", "x,y,z\n0,0,5\n4,0,5\n0,4,5\n1,1,5\n");
    for (const Words& words : {Words{"triangulate", heights, "--quiet", "--dimension", "2"},
                               Words{"voronoi", heights, "--quiet", "--dimension", "2"}}) {
        const Outcome flat = run(words);
        EXPECT_EQ(flat.code, 0);
        EXPECT_EQ(flat.out, run({words[0], plain, "--quiet"}).out);
        EXPECT_TRUE(flat.err.starts_with("signum: " + heights +
                                         ":1: 'z' is left out: sites lie in the plane here. "))
            << flat.err;
    }
}

TEST_F(Tool, RefusesWrongInputAndWritesNothing) {
    const std::string bad = scratch.file("bad.txt", "0 0 1\n4 zero 1\n");
    const std::size_t before = scratch.size();
    expect({"triangulate", bad, "--metric", "power", "-o", scratch.path("a.json")}, 2,
           bad +
               ":2:3: 'zero' is not a number; write a decimal or hexadecimal float, such as 1.5, "
               "-2e-3 or 0x1.8p-3\n");
    const Outcome piped = run({"triangulate", "-", "--metric", "power"}, {.in = bad});
    EXPECT_EQ(piped.code, 2);
    EXPECT_TRUE(piped.err.starts_with("-:2:3: ")) << piped.err;
    EXPECT_EQ(piped.out, "");
    const std::string missing = scratch.path("missing");
    expect({"triangulate", missing, "--metric", "power"}, 2,
           missing +
               ": cannot open it (No such file or directory); give a file of sites, or - "
               "for standard input\n");
    EXPECT_EQ(scratch.size(), before);
}

TEST_F(Tool, KnowsMetricsByOtherNames) {
    const auto with = [&](const char* name) {
        return run({"triangulate", sites, "--metric", name, "--quiet"}).out;
    };
    const std::string supremum = with("supremum");
    EXPECT_NE(supremum.find("\"supremum\""), std::string::npos);
    for (const char* name : {"Supremum", "LINF", "l-inf"}) EXPECT_EQ(with(name), supremum);
    EXPECT_EQ(with("L1"), with("manhattan"));
    EXPECT_EQ(with("Laguerre"), with("power"));
}

TEST_F(Tool, WritesEveryFormatToStandardOutput) {
    const std::string file = scratch.path("a.data");
    for (const Words& formats : {Words{"triangulate", "json", "svg", "csv", "obj"},
                                 Words{"voronoi", "json", "svg", "geojson", "csv"}}) {
        for (std::size_t i = 1; i < formats.size(); ++i) {
            const auto with = [&](const Words& more) {
                Words words = {formats[0], sites, "--quiet"};
                words.insert(words.end(), more.begin(), more.end());
                const Outcome outcome = run(words);
                EXPECT_EQ(outcome.code, 0) << outcome.err;
                return outcome.out;
            };
            const std::string path = scratch.path("b." + formats[i]);
            EXPECT_EQ(with({"-o", path}), "");
            const std::string expected = contents(path);
            EXPECT_FALSE(expected.empty());
            EXPECT_EQ(with({"--format", formats[i]}), expected);
            EXPECT_EQ(with({"-o", "-", "--format", formats[i]}), expected);
            EXPECT_EQ(with({"-o", file, "--format", formats[i]}), "");
            EXPECT_EQ(contents(file), expected);
        }
    }
    const Outcome both =
        run(triangulate({"-o", scratch.path("c.csv"), "-o", "-", "--format", "obj"}));
    EXPECT_TRUE(both.out.starts_with("# signum: "));
    EXPECT_TRUE(contents(scratch.path("c.csv")).starts_with("a,b,c\n"));
    EXPECT_NE(both.err.find("written  " + scratch.path("c.csv") + "\n"), std::string::npos);
    expect(
        triangulate({"-o", "a.json", "-o", "b.svg", "--format", "svg"}), 2,
        "signum: --format svg and -o a.json: with several files either their endings say what to "
        "write, or --format does; leave --format out, or name the file otherwise\n");
    EXPECT_EQ(run({"generate", "grid", "-n", "4", "-o", "-", "--format", "json"}).out,
              "[[0, 0, 0],\n[700, 0, 0],\n[0, 700, 0],\n[700, 700, 0]]\n");
    const Outcome picture = run({"compare", sites, "--seconds", "0", "-o", "-"});
    EXPECT_NE(picture.out.find("<svg"), std::string::npos);
    EXPECT_NE(picture.err.find("exact / naive time: "), std::string::npos) << picture.err;
    EXPECT_EQ(run({"compare", sites, "--json", "-o", "-"}).code, 2);
}

TEST_F(Tool, RefusesOutputsThatCannotBeMeant) {
    expect(triangulate({"-o", "a.txt"}), 2,
           "signum: -o a.txt: the ending says what to write; give it .json, .svg, .png, .pdf, "
           ".csv, .npy, .i32, .obj, .ply, .vtk, .vtp, .vtu, .node, .ele or .neigh, or say it with "
           "--format\n");
    expect(triangulate({"-o", "a.json", "-o", "a.json"}), 2,
           "signum: -o a.json is given twice; give it once\n");
    const std::string csv = scratch.file("sites.csv", "0,0\n");
    expect({"triangulate", csv, "--metric", "power", "-o", csv}, 2,
           "signum: -o " + csv + " would overwrite the input; give another name\n");
    expect(triangulate({"--vertices", "-o", "a.csv"}), 2,
           "signum: --vertices goes into JSON alone; add -o FILE.json\n");
    EXPECT_EQ(contents(csv), "0,0\n");
}

TEST_F(Tool, ReportsAMachineThatFails) {
    const std::string nowhere = scratch.path("no/a.json");
    expect(triangulate({"-o", nowhere}), 2,
           "signum: cannot write " + nowhere +
               ": No such file or directory; give a file in a directory that is there\n");
    EXPECT_EQ(run(triangulate({"--quiet"}), {.out = "/dev/full"}).code, 3);
    expect({"generate", "random", "-n", "9", "-o", "/dev/full"}, 3,
           "signum: cannot write /dev/full: No space left on device\n");
    // Of two files neither appears when one cannot be written.
    const std::string full = scratch.path("full.json");
    ASSERT_EQ(::symlink("/dev/full", full.c_str()), 0);
    const std::size_t before = scratch.size();
    expect(triangulate({"-o", scratch.path("a.csv"), "-o", full, "--quiet"}), 3,
           "signum: cannot write " + full + ": No space left on device\n");
    EXPECT_EQ(scratch.size(), before);
}

TEST_F(Tool, LeavesNoHalfFileWhenTheDiskIsFull) {
    const std::string path = scratch.file("out.txt", "old");
    const Outcome outcome =
        run({"generate", "random", "-n", "100000", "-o", path}, {.file_size = 100'000});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "signum: cannot write " + path + ": File too large\n");
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(scratch.size(), 2U);
}

TEST_F(Tool, LeavesNoHalfFileWhenInterrupted) {
    // A pipe without a writer holds the second output open: the first one is unfinished then.
    const std::string pipe = scratch.path("pipe.csv");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const Outcome outcome = run(triangulate({"-o", scratch.path("a.json"), "-o", pipe, "--quiet"}),
                                {.signal_after_ms = 300});
    EXPECT_EQ(outcome.code, -SIGINT);
    EXPECT_EQ(scratch.size(), 2U);
}

TEST_F(Tool, PrintsSigns) {
    EXPECT_EQ(run({"sign", "ccw", "--", "0", "0", "1", "0", "0", "1"}).out, "1 filter\n");
    EXPECT_EQ(run({"sign", "ccw", "--json", "--", "0", "0", "1", "0", "0", "-0x1p0"}).out,
              "{\"sign\": -1, \"stage\": \"filter\"}\n");
    EXPECT_TRUE(run({"sign", "ccw", "--", "0", "0", "1", "1", "2", "2"}).out.starts_with("0 "));
    const auto in_circle = [](const Words& more, const char* last) {
        Words words = {"sign", "in_circle", "--metric", "power"};
        words.insert(words.end(), more.begin(), more.end());
        words.insert(words.end(),
                     {"--", "0", "0", "1", "1", "0", "1", "0", "1", "1", "1", "1", last});
        return run(words).out;
    };
    EXPECT_EQ(in_circle({}, "1.5"), "1 filter\n");
    EXPECT_EQ(in_circle({}, "0.5"), "-1 filter\n");
    EXPECT_TRUE(in_circle({}, "-1").starts_with("0 "));
    EXPECT_EQ(in_circle({"--weight-is", "weight"}, "-1"), "-1 filter\n");
}

TEST_F(Tool, RefusesSignsThatDoNotExist) {
    expect({"sign", "ccw", "--", "0", "0", "1"}, 2,
           "signum: sign ccw needs 6 numbers after --, x y of each of three points; 3 are given\n");
    expect(
        {"sign", "in_circle", "--metric", "power", "--", "0"}, 2,
        "signum: sign in_circle needs 12 numbers after --, x y r of each of the sites i, j, k and "
        "of the query; 1 is given\n");
    expect({"sign", "ccw", "--", "0", "0", "1", "0", "0", "nan"}, 2,
           "signum: number 6 of 6: 'nan' is not a finite number; write a finite one\n");
    const auto in_circle = [](const char* x, const char* y) {
        return Words{"sign", "in_circle", "--metric", "power", "--", "0", "0", "0", "1",
                     "0",    "0",         x,          y,       "0",  "1", "1", "0"};
    };
    expect(
        in_circle("0", "-1"), 2,
        "signum: sign in_circle: i, j, k must be counterclockwise and are clockwise; exchange two "
        "of them\n");
    expect(in_circle("2", "0"), 2,
           "signum: sign in_circle: i, j, k must be counterclockwise and are collinear: no circle "
           "touches them; give three centres that are not on one line\n");
}

TEST_F(Tool, Generates) {
    const Outcome outcome = run({"generate", "grid", "-n", "4"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, "0 0 0\n700 0 0\n0 700 0\n700 700 0\n");
    const std::string json = scratch.path("s.json");
    EXPECT_EQ(run({"generate", "circle", "-n", "3", "--radius", "-1:2", "-o", json}).code, 0);
    EXPECT_TRUE(contents(json).starts_with("[["));
    for (const char* name : {"sites", "s.txt", "s.xyr", "s.DAT"}) {
        const std::string text = scratch.path(name);
        EXPECT_EQ(run({"generate", "grid", "-n", "4", "-o", text}).code, 0);
        EXPECT_EQ(contents(text), outcome.out) << name;
    }
    const std::string svg = scratch.path("s.svg");
    expect(
        {"generate", "circle", "-n", "3", "-o", svg}, 2,
        "signum: -o " + svg +
            ": the ending says what to write; give it .txt, .csv, .json, .npy or .f64, or say it "
            "with --format\n");
    EXPECT_FALSE(std::filesystem::exists(svg));
    EXPECT_EQ(run({"generate", "circle", "-n", "3", "-o", svg, "--format", "text"}).code, 0);
    EXPECT_NE(run({"generate", "random", "-n", "3"}).out,
              run({"generate", "random", "-n", "3", "--seed", "2"}).out);
    expect({"generate", "random", "-n", "0"}, 2,
           "signum: -n 0: give a number of sites from 1 to 357913941\n");
    expect({"generate", "random", "-n", "3", "--radius", "2:1"}, 2,
           "signum: --radius 2:1: give the smaller number first\n");
    expect({"generate", "random", "-n", "3", "--perturb", "-1"}, 2,
           "signum: --perturb -1: give a number that is not negative\n");
    expect(
        {"generate", "random", "-n", "3", "--perturb", "much"}, 2,
        "signum: --perturb: 'much' is not a number; write a decimal or hexadecimal float, such as "
        "1.5, -2e-3 or 0x1.8p-3\n");
}

/// What fails its check is nowhere: the file asked for keeps its old contents.
TEST_F(Tool, WritesNothingThatFailsItsCheck) {
    const std::string input = scratch.path("circle.txt");
    ASSERT_EQ(run({"generate", "circle", "-n", "300", "-o", input}).code, 0);
    const std::string json = scratch.file("a.json", "old");
    const std::size_t before = scratch.size();
    for (const char* metric : {"power", "euclidean"}) {
        Words words = {"triangulate", input,          "--dimension", "2",      "--metric",
                       metric,        "--arithmetic", "single",      "--check"};
        const Outcome printed = run(words);
        EXPECT_EQ(printed.code, 1) << printed.err;
        EXPECT_EQ(printed.out, "");
        words.insert(words.end(), {"-o", json, "-o", scratch.path("a.csv")});
        const Outcome written = run(words);
        EXPECT_EQ(written.code, 1);
        EXPECT_TRUE(written.err.starts_with("signum: --check: not valid: ")) << written.err;
        EXPECT_TRUE(written.err.ends_with("; nothing is written, without --check it would be\n"))
            << written.err;
        EXPECT_EQ(contents(json), "old");
        EXPECT_EQ(scratch.size(), before);
    }
}

TEST_F(Tool, Validates) {
    const std::string json = scratch.path("a.json");
    ASSERT_EQ(run(triangulate({"-o", json, "--quiet"})).code, 0);
    const Outcome good = run({"validate", json, sites});
    EXPECT_EQ(good.code, 0);
    EXPECT_EQ(good.out, "valid, canonical\n");
    EXPECT_EQ(good.err, "");
    EXPECT_EQ(run({"validate", "-", sites}, {.in = json}).out, "valid, canonical\n");

    const std::string other = scratch.file("other.txt", "0 0\n1 0\n");
    const Outcome wrong = run({"validate", json, other});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(wrong.out.starts_with("not valid: ")) << wrong.out;
    EXPECT_EQ(wrong.err, "signum: " + json + " is not a valid tessellation of " + other + "\n");

    expect({"validate", sites, sites}, 2,
           sites +
               ":1:1: 'x' cannot stand here; a tessellation is what signum triangulate writes as "
               "JSON\n");
    expect({"validate", "-", "-"}, 2, "signum: only one of the two files can be standard input\n");
    const std::string foreign =
        scratch.file("e.json",
                     "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"taxi\", "
                     "\"sites\": 0, \"faces\": []}");
    expect({"validate", json, sites, "--read-as", "pdb"}, 2,
           "signum: --read-as pdb: it holds sites in space, and the tessellation of " + json +
               " is one of the plane\n");
    const Outcome unknown = run({"validate", foreign, sites});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("\"metric\" cannot be 'taxi'; it is one of power, euclidean, "
                               "manhattan, supremum"),
              std::string::npos)
        << unknown.err;
}

// ---- all metrics -------------------------------------------------------------------------------

class ToolInMetric : public Tool, public testing::WithParamInterface<Metric> {
 protected:
    const std::string metric{name_of(GetParam())};

    /// Runs `signum sign in_circle` in the metric.
    [[nodiscard]] Outcome in_circle(const Words& numbers, const Words& options = {}) const {
        Words words = {"sign", "in_circle", "--metric", metric};
        words.insert(words.end(), options.begin(), options.end());
        words.emplace_back("--");
        words.insert(words.end(), numbers.begin(), numbers.end());
        return run(words);
    }
};

TEST_P(ToolInMetric, WritesEveryFormat) {
    const std::string input = scratch.path("random.txt");
    ASSERT_EQ(run({"generate", "random", "-n", "300", "--radius", "0:40", "-o", input}).code, 0);
    const std::string json = scratch.path("a.json");
    const std::string svg = scratch.path("a.svg");
    const std::string csv = scratch.path("a.csv");
    const std::string obj = scratch.path("a.obj");
    const Outcome outcome = run({"triangulate", input, "--dimension", "2", "--metric", metric, "-o",
                                 json, "-o", svg, "-o", csv, "-o", obj, "--stats"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("sites    300\nvisible  ")) << outcome.err;
    EXPECT_NE(outcome.err.find("decided  "), std::string::npos);
    EXPECT_NE(contents(json).find("\"metric\": \"" + metric + "\", \"weight_is\": \"radius\""),
              std::string::npos);
    EXPECT_EQ(contents(json).find("\"filtered\": null"), std::string::npos);
    EXPECT_NE(contents(svg).find("<svg"), std::string::npos);
    EXPECT_TRUE(contents(csv).starts_with("a,b,c\n-1,"));
    EXPECT_TRUE(contents(obj).starts_with("# signum: " + metric + " tessellation"));
    EXPECT_EQ(scratch.size(), 6U);
}

TEST_P(ToolInMetric, WritesTheSameBytesWhateverTheSeed) {
    const std::string input = scratch.path("grid.csv");
    ASSERT_EQ(run({"generate", "grid", "-n", "400", "--radius", "0:40", "-o", input}).code, 0);
    const auto with = [&](const Words& more) {
        Words all = {"triangulate", input, "--metric", metric, "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return run(all).out;
    };
    const std::string once = with({});
    EXPECT_GT(once.size(), 2000U);
    EXPECT_EQ(with({"--seed", "99"}), once);
    EXPECT_EQ(with({"--threads", "3"}), once);
    EXPECT_EQ(with({"--arithmetic", "multiprecision"}), once);
}

TEST_P(ToolInMetric, JudgesWhatItWrites) {
    const std::string input = scratch.path("random.txt");
    ASSERT_EQ(run({"generate", "random", "-n", "100", "--radius", "0:60", "-o", input}).code, 0);
    const std::string json = scratch.path("a.json");
    ASSERT_EQ(run({"triangulate", input, "--metric", metric, "-o", json, "--quiet"}).code, 0);
    const Outcome good = run({"validate", json, input});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_EQ(good.out, "valid, canonical\n");
    const Outcome checked = run({"triangulate", input, "--metric", metric, "-o", json, "--check"});
    EXPECT_EQ(checked.code, 0);
    EXPECT_NE(checked.err.find("check    valid, canonical\n"), std::string::npos) << checked.err;
    const Outcome wrong = run({"validate", json, sites});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(wrong.out.starts_with("not valid: ")) << wrong.out;
}

TEST_P(ToolInMetric, TakesFewSites) {
    const auto with = [&](std::string_view text) {
        const std::string input = scratch.file("few.txt", text);
        const Outcome outcome = run({"triangulate", input, "--metric", metric, "--quiet"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out.substr(outcome.out.find('\n') + 1);
    };
    EXPECT_EQ(with("1 2 3\n"), "\"faces\": [],\n\"neighbours\": [],\n\"hidden\": []}\n");
    EXPECT_EQ(with("1 2\n1 2\n"), "\"faces\": [],\n\"neighbours\": [],\n\"hidden\": [\n[1, 0]]}\n");
    EXPECT_EQ(with("0 0\n5 1\n"),
              "\"faces\": [\n[-1, 0, 1],\n[-1, 1, 0]],\n"
              "\"neighbours\": [\n[1, 1, 1],\n[0, 0, 0]],\n\"hidden\": []}\n");
}

TEST_P(ToolInMetric, HasWeightsInPowerAlone) {
    const bool is_power = GetParam() == Metric::power;
    for (const std::string third : {"radius", "weight"}) {
        const std::string error =
            is_power ? ""
                     : "signum: --weight-is " + third +
                           ": only the power metric has weights, and this is --metric " + metric +
                           "; leave --weight-is out, or add --metric power\n";
        const Outcome tessellation =
            run({"triangulate", sites, "--metric", metric, "--weight-is", third, "--quiet"});
        EXPECT_EQ(tessellation.code, is_power ? 0 : 2);
        EXPECT_EQ(tessellation.err, error);
        const Outcome sign = in_circle(
            {"0", "0", "1", "9", "2", "1", "2", "9", "1", "30", "4", "1"}, {"--weight-is", third});
        EXPECT_EQ(sign.code, is_power ? 0 : 2);
        EXPECT_EQ(sign.err, error);
    }
    const std::string weighted = scratch.file("w.csv", "x,y,weight\n0,0,0\n9,0,0\n0,9,0\n");
    const Outcome header = run({"triangulate", weighted, "--metric", metric, "--quiet"});
    EXPECT_EQ(header.code, is_power ? 0 : 2);
    EXPECT_EQ(header.err, is_power ? ""
                                   : "signum: " + weighted + ": its header says weight, and the " +
                                         metric +
                                         " metric has radii alone; name the column radius, or add "
                                         "--metric power\n");
}

TEST_P(ToolInMetric, PrintsSigns) {
    for (const Words& options : {Words{}, Words{"--json"}}) {
        const auto with = [&](const char* x, const char* y, const char* r) {
            const Outcome outcome =
                in_circle({"0", "0", "1", "9", "2", "1", "3", "8.5", "1", x, y, r}, options);
            EXPECT_EQ(outcome.code, 0);
            EXPECT_TRUE(options.empty() || outcome.err.empty()) << outcome.err;
            return outcome.out;
        };
        const std::string before = options.empty() ? "" : "{\"sign\": ";
        const std::string after = options.empty() ? " filter\n" : ", \"stage\": \"filter\"}\n";
        EXPECT_EQ(with("4", "5", "1"), before + "1" + after);
        EXPECT_EQ(with("40", "5", "1"), before + "-1" + after);
    }
}

TEST_P(ToolInMetric, ExplainsTies) {
    // On one circle, square or diamond, counterclockwise; the first is the last in the order.
    const std::vector<Words> corners =
        GetParam() == Metric::manhattan
            ? std::vector<Words>{{"1", "1", "0"},
                                 {"-1", "1", "0"},
                                 {"-1", "-1", "0"},
                                 {"1", "-1", "0"}}
            : std::vector<Words>{
                  {"2", "0", "0"}, {"0", "2", "0"}, {"-2", "0", "0"}, {"0", "-2", "0"}};
    struct Case {
        std::array<std::size_t, 4> order;
        char last;
        bool conflict;
    };
    for (const auto& [order, last, conflict] :
         {Case{{1, 2, 3, 0}, 'q', false}, Case{{0, 1, 2, 3}, 'i', true},
          Case{{0, 1, 3, 2}, 'i', false}, Case{{3, 0, 1, 2}, 'j', false}}) {
        Words numbers;
        for (const std::size_t c : order)
            numbers.insert(numbers.end(), corners[c].begin(), corners[c].end());
        const Outcome outcome = in_circle(numbers);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_TRUE(outcome.out.starts_with("0 ")) << outcome.out;
        EXPECT_TRUE(outcome.err.starts_with("tie      q touches the ")) << outcome.err;
        EXPECT_NE(outcome.err.find(std::string(1, last) + " is the last of them: q " +
                                   (conflict ? "conflicts\n" : "does not conflict\n")),
                  std::string::npos)
            << outcome.err;
        EXPECT_NE(outcome.err.find("\ndecided  not by the filter, but by "), std::string::npos);
        const Outcome json = in_circle(numbers, {"--json"});
        EXPECT_TRUE(json.out.starts_with("{\"sign\": 0, \"stage\": \""));
        EXPECT_TRUE(json.out.ends_with(std::string(", \"tie\": {\"last\": \"") + last +
                                       "\", \"conflict\": " + (conflict ? "true" : "false") +
                                       "}}\n"))
            << json.out;
        EXPECT_EQ(json.err, "");
    }
}

TEST_P(ToolInMetric, RefusesWhatHasNoCircle) {
    if (GetParam() == Metric::power) return;  // see RefusesSignsThatDoNotExist
    const std::string circle(traits_of(GetParam()).circle);
    const auto refused = [&](const Words& numbers, const std::string& why) {
        const Outcome outcome = in_circle(numbers);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err, "signum: sign in_circle: " + why + "\n");
    };
    refused({"0", "0", "0", "3", "8.5", "0", "9", "2", "0", "5", "5", "0"},
            "no " + circle +
                " touches i, j and k counterclockwise; one touches them clockwise: exchange two of "
                "them");
    refused({"0", "0", "0", "4", "8", "1", "8", "16", "0", "5", "5", "0"},
            "no " + circle +
                " touches i, j and k counterclockwise; none touches them clockwise either: give "
                "three other sites");
    refused({"0", "0", "5", "2", "9", "0", "1", "2", "1", "5", "5", "0"},
            "i hides k, so that no " + circle + " touches i, j and k; leave k out");
    // A hidden query is an answer.
    const Outcome hidden =
        in_circle({"0", "0", "2", "9", "2", "1", "3", "8.5", "1", "0.5", "0.25", "1"});
    EXPECT_EQ(hidden.code, 0);
    EXPECT_TRUE(hidden.out.starts_with("-1 ")) << hidden.out;
    EXPECT_TRUE(hidden.err.starts_with("hidden   i hides q\n")) << hidden.err;
    const Outcome hiding =
        in_circle({"0", "0", "1", "9", "2", "1", "3", "8.5", "1", "3", "3", "50"});
    EXPECT_TRUE(hiding.out.starts_with("1 ")) << hiding.out;
    EXPECT_TRUE(
        hiding.err.starts_with("hidden   q hides i\nhidden   q hides j\nhidden   q hides "
                               "k\n"))
        << hiding.err;
}

INSTANTIATE_TEST_SUITE_P(Metrics, ToolInMetric, testing::ValuesIn(all_metrics),
                         [](const auto& info) { return std::string(name_of(info.param)); });

TEST_F(Tool, WritesDiagrams) {
    const Outcome outcome = run({"voronoi", sites, "--metric", "power"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(
        outcome.out.starts_with("{\"format\": \"signum.voronoi\", \"version\": 1, "
                                "\"metric\": \"power\", \"weight_is\": \"radius\", "
                                "\"sites\": 5, \"clip\": null,\n\"vertices\": [\n"))
        << outcome.out;
    EXPECT_EQ(outcome.err,
              "sites    5\ncells    4, 3 of them unbounded\nhidden   1\nvertices 3\nedges    6\n");
    EXPECT_EQ(run({"voronoi", "-", "--metric", "power", "--quiet"}, {.in = sites}).out,
              outcome.out);

    const std::string geojson = scratch.path("a.geojson");
    const std::string csv = scratch.path("a.csv");
    const std::string svg = scratch.path("a.svg");
    const Outcome files = run({"voronoi", "-o", geojson, "-o", csv, "-o", svg, "--clip", "-1", "-1",
                               "5", "6", "--tolerance", "0.01", "--merge", sites});
    EXPECT_EQ(files.code, 0) << files.err;
    EXPECT_EQ(files.out, "");
    EXPECT_NE(files.err.find("written  " + geojson + ", " + csv + ", " + svg), std::string::npos);
    EXPECT_NE(contents(geojson).find("\"bbox\": [-1, -1, 5, 6]"), std::string::npos);
    EXPECT_TRUE(contents(csv).starts_with("site,x,y,radius,"));
    EXPECT_NE(contents(svg).find("Voronoi diagram"), std::string::npos);
    // One number may be negative, and so may all.
    EXPECT_EQ(run({"voronoi", sites, "--quiet", "--clip", "-4", "-3", "-2.5", "-1"}).code, 0);
    // FILE may follow the numbers.
    EXPECT_EQ(run({"voronoi", "--clip", "-4", "-3", "-2.5", "-1", sites, "--quiet"}).code, 0);
}

TEST_F(Tool, WritesPolygonsOfDenormalSites) {
    const std::string tiny = scratch.file("tiny.txt", "5e-324 0\n0 5e-324\n0 0\n");
    for (const char* format : {"csv", "geojson"}) {
        const Outcome outcome = run({"voronoi", tiny, "--format", format});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
}

TEST_F(Tool, RefusesWrongCallsOfVoronoi) {
    const auto refused = [&](Words more, const std::string& message) {
        Words words = {"voronoi", sites};
        words.insert(words.end(), more.begin(), more.end());
        expect(words, 2, message);
    };
    refused({"--clip", "5", "0", "1", "1"},
            "signum: --clip 5 0 1 1: the lower left corner comes first, x0 < x1 and y0 < y1\n");
    refused({"--clip", "nan", "0", "1", "1"},
            "signum: --clip: 'nan' is not a finite number; write a finite one; see signum voronoi "
            "--help\n");
    refused({"--tolerance", "0"}, "signum: --tolerance: give a number above 0\n");
    for (const char* name : {"a.json", "a.svg", "a.csv"})
        refused(
            {"--clip", "-1e308", "-1e308", "1e308", "1e308", "-o", scratch.path(name)},
            "signum: the box -1e+308 -1e+308 1e+308 1e+308 is too large or too small beside the "
            "coordinates and radii of the sites; cut the cells to another one with --clip\n");
    refused({"--tolerance", "1e-300"},
            "signum: --tolerance 1e-300: below a billionth of the box's longer side polygons would "
            "have more points than anybody wants; give at least 4.8e-09\n");
    refused({"--clip", "0", "0", "1e-6", "1", "-o", "a.svg"},
            "signum: --clip: a picture of a box more than a thousand times as long as wide shows "
            "nothing; give another box, or leave the picture out\n");
    refused({"-o", "a.obj"},
            "signum: -o a.obj: the ending says what to write; give it .json, .svg, .png, .pdf, "
            ".geojson, .csv, .wkt, .vtk, .vtp or .vtu, or say it with --format\n");
    refused({"-o", "a.vtu"}, "signum: vtu is written of sites in space, and those of " + sites +
                                 " lie in the plane; write vtp\n");
    refused({"--carry", "-o", "a.geojson"},
            "signum: --carry is for tables, and GeoJSON has the columns anyway; add -o FILE.csv\n");
    refused({"--clip", "0", "0", "0", "1", "1", "1"},
            "signum: --clip: 6 numbers, but the sites of " + sites +
                " lie in the plane; give X0 Y0 X1 Y1\n");
    EXPECT_EQ(run({"voronoi", sites, "--clip", "1", "2", "3"}).code, 2);
    EXPECT_EQ(run({"voronoi", sites, "--clip", "1", "2", "3", "x"}).code, 2);
    EXPECT_EQ(run({"voronoi", scratch.path("none.txt")}).code, 2);
}

TEST_F(Tool, DrawsAPartOfATessellation) {
    const std::string svg = scratch.path("part.svg");
    const std::string json = scratch.path("whole.json");
    const Outcome whole = run({"triangulate", sites, "--quiet"});
    const Outcome part = run(
        {"triangulate", sites, "--clip", "-1", "-1", "5", "6", "-o", svg, "-o", json, "--quiet"});
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_EQ(contents(json), whole.out);
    const std::string drawn = contents(svg);
    EXPECT_EQ(run({"triangulate", sites, "-o", svg, "--quiet"}).code, 0);
    EXPECT_NE(contents(svg), drawn);

    const auto refused = [&](Words more, const std::string& message) {
        Words words = {"triangulate", sites, "--clip"};
        words.insert(words.end(), more.begin(), more.end());
        expect(words, 2, message);
    };
    refused({"0", "0", "1", "1"}, "signum: --clip is what a picture shows; add -o FILE.svg\n");
    refused({"5", "0", "1", "1", "-o", svg},
            "signum: --clip 5 0 1 1: the lower left corner comes first, x0 < x1 and y0 < y1\n");
    refused({"-1e308", "-1e308", "1e308", "1e308", "-o", svg},
            "signum: the box -1e+308 -1e+308 1e+308 1e+308 is too large or too small beside the "
            "coordinates and radii of the sites; cut the cells to another one with --clip\n");
    refused({"0", "0", "1e-6", "1", "-o", svg},
            "signum: --clip: a picture of a box more than a thousand times as long as wide shows "
            "nothing; give another box, or leave the picture out\n");
}

TEST_F(Tool, TakesEuclideanWhereNoMetricIsGiven) {
    for (const Words& words : {Words{"triangulate", sites, "--quiet"},
                               Words{"sign", "in_circle", "--", "0", "0", "1", "9", "2", "1", "2",
                                     "9", "1", "4", "5", "1"}}) {
        Words named = words;
        named.insert(named.begin() + 1, {"--metric", "euclidean"});
        const Outcome expected = run(named);
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, expected.code);
        EXPECT_EQ(outcome.out, expected.out);
        EXPECT_EQ(outcome.err, expected.err);
    }
}

TEST_F(Tool, AnswersAQuestionALine) {
    const std::string questions = scratch.file("questions.txt",
                                               "# of points\n"
                                               "orient2d 0 0 1 0 0 1\n"
                                               "\n"
                                               "incircle 0 0 0 1 1 0 0.5 0.5\n"
                                               "orient3d 0 0 0 1 0 0 0 1 0 0 0 1\n"
                                               "insphere 1 0 0 0 0 0 0 1 0 0 0 1 1 1 1\n"
                                               "in_circle 0 0 1 1 0 1 0 1 1 1 1 1\n"
                                               "ccw 0 0 1\n");
    Circumstances from_questions;
    from_questions.in = questions;
    const Outcome mixed = run({"sign", "-"}, from_questions);
    EXPECT_EQ(mixed.out, "1 filter\n-1 filter\n-1 filter\n0 exact\n0 exact\n");
    EXPECT_EQ(mixed.err,
              "standard input:8:1: sign ccw needs 6 numbers, x y of each of three points; 3 are "
              "given\n");
    EXPECT_EQ(mixed.code, 2);
    EXPECT_EQ(
        run({"sign", "-", "--metric", "power"}, from_questions).err,
        "standard input:2:1: sign orient2d: it asks of points; leave --metric, --weight-is and "
        "--dimension out\n");

    from_questions.in = scratch.file("lines.txt", "0 0 1 1 2 2\n0 0 1 1 3 2\n");
    const Outcome alike = run({"sign", "ccw", "-", "--json", "--explain"}, from_questions);
    EXPECT_EQ(alike.out,
              "{\"sign\": 0, \"stage\": \"exact\"}\n{\"sign\": -1, \"stage\": \"filter\"}\n");
    EXPECT_EQ(alike.err.substr(0, alike.err.find('\n')),
              "line 1: tie      the points lie on a line; ccw has no tie rule");

    from_questions.in = scratch.file("wrong.txt", "turn 0 0 1 1 2 2\n");
    EXPECT_EQ(run({"sign", "-"}, from_questions).err,
              "standard input:1:1: 'turn' is no predicate; they are ccw, in_circle, in_sphere, "
              "orient2d, incircle, orient3d, insphere\n");
    expect({"sign", "insphere", "--", "0"}, 2,
           "signum: sign insphere needs 15 numbers after --, x y z of each of 5 points; 1 is "
           "given\n");
}

}  // namespace
}  // namespace signum
