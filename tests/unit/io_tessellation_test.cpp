/// Tessellations to JSON, CSV and OBJ, and back from JSON.

#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "../../tool/io/read_sites.hpp"
#include "../../tool/io/read_tessellation.hpp"
#include "../../tool/io/write_sites.hpp"
#include "../../tool/io/write_tessellation.hpp"

#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

/// A triangle with a hidden site in it.
TessellationArrays triangle() {
    TessellationArrays arrays;
    arrays.sites = 4;
    arrays.faces = {{-1, 0, 2}, {-1, 1, 0}, {-1, 2, 1}, {0, 1, 2}};
    arrays.neighbours = {{3, 2, 1}, {3, 0, 2}, {3, 1, 0}, {2, 0, 1}};
    arrays.hidden = {{3, 0}};
    return arrays;
}

Tessellation tessellation() {
    Statistics statistics;
    statistics.seconds = 0.5;
    return {triangle(), {{0, 0, 1}, {2, 0, 1}, {0, 2, 1}, {0.1, 0.5, -3}}, statistics};
}

template <typename... Options>
std::string json(const Tessellation& tessellation, const Options&... options) {
    std::ostringstream out;
    write_json(out, tessellation, options...);
    return out.str();
}

TessellationArrays read(std::string_view text) {
    const test::Scratch scratch;
    return read_tessellation(scratch.file("t.json", text)).arrays;
}

std::string error(std::string_view text) {
    return test::refusal(text, [](const std::string& path) { return read_tessellation(path); });
}

const std::string expected = "; a tessellation is what signum triangulate writes as JSON";

TEST(WriteJson, WritesTheSchema) {
    EXPECT_EQ(json(tessellation()),
              "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", "
              "\"weight_is\": \"radius\", \"sites\": 4,\n"
              "\"faces\": [\n[-1, 0, 2],\n[-1, 1, 0],\n[-1, 2, 1],\n[0, 1, 2]],\n"
              "\"neighbours\": [\n[3, 2, 1],\n[3, 0, 2],\n[3, 1, 0],\n[2, 0, 1]],\n"
              "\"hidden\": [\n[3, 0]]}\n");
    TessellationArrays one;
    one.sites = 1;
    one.weight_is = WeightIs::weight;
    EXPECT_EQ(json(Tessellation(one, {{1, 2, 3}}, {})),
              "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", "
              "\"weight_is\": \"weight\", \"sites\": 1,\n"
              "\"faces\": [],\n\"neighbours\": [],\n\"hidden\": []}\n");
}

TEST(WriteJson, WritesStatisticsOnRequest) {
    const JsonOptions options = {.vertices = false, .statistics = true};
    EXPECT_NE(
        json(tessellation(), options)
            .find(",\n\"statistics\": {\"ccw\": null, \"in_circle\": null, \"nearer\": null, "
                  "\"others\": null, \"filtered\": null, "
                  "\"refined\": null, \"exact\": null, \"essa\": null, \"multiprecision\": null, "
                  "\"ties\": null, "
                  "\"flips\": null, \"events\": null, \"seconds\": 0.5}}\n"),
        std::string::npos);
    Statistics counted;
    counted.counted = true;
    counted.ccw = 1;
    counted.multiprecision = std::numeric_limits<std::uint64_t>::max();
    counted.seconds = 1e-7;
    EXPECT_NE(json(Tessellation(triangle(), std::vector<Site>(4), counted), options)
                  .find("{\"ccw\": 1, \"in_circle\": 0, \"nearer\": 0, \"others\": 0, "
                        "\"filtered\": 0, \"refined\": 0, \"exact\": 0, \"essa\": 0, "
                        "\"multiprecision\": 18446744073709551615, \"ties\": 0, \"flips\": 0, "
                        "\"events\": 0, "
                        "\"seconds\": 1e-07}}\n"),
              std::string::npos);
}

TEST(WriteJson, WritesVerticesOnRequest) {
    // The circles about the right triangle: (1, 1), and |(1, 1)|² - 1.
    EXPECT_NE(json(tessellation(), JsonOptions{.vertices = true, .statistics = false})
                  .find(",\n\"vertices\": [\nnull,\nnull,\nnull,\n[1, 1, 1]]}\n"),
              std::string::npos);
}

TEST(WriteJson, WritesTheSameBytesTwice) {
    EXPECT_EQ(json(tessellation()), json(tessellation()));
}

TEST(ReadTessellation, ReadsWhatIsWritten) {
    EXPECT_EQ(read(json(tessellation())), triangle());
    EXPECT_EQ(read(json(tessellation(), JsonOptions{.vertices = true, .statistics = true})),
              triangle());
    TessellationArrays large = triangle();
    large.weight_is = WeightIs::weight;
    large.sites = 300'000;
    for (Index i = 4; i < 300'000; ++i) large.hidden.push_back({i, i % 3});
    EXPECT_EQ(read(json(Tessellation(large, std::vector<Site>(300'000), {}))), large);
}

TEST(ReadTessellation, ReadsEveryMetric) {
    TessellationArrays arrays = triangle();
    // Two edges between 0 and 1, as the additive metrics have them: 2 is small and lies between.
    arrays.faces = {{-1, 0, 1}, {-1, 1, 0}, {0, 1, 2}, {0, 2, 1}};
    arrays.neighbours = {{3, 1, 1}, {2, 0, 0}, {3, 3, 1}, {2, 0, 2}};
    for (const Metric metric : all_metrics) {
        arrays.metric = metric;
        const std::string text = json(Tessellation(arrays, std::vector<Site>(4), {}));
        EXPECT_NE(text.find("\"metric\": \"" + std::string(name_of(metric)) + "\""),
                  std::string::npos);
        EXPECT_EQ(read(text), arrays) << text;
    }
}

TEST(ReadTessellation, ReadsWhatOthersWrite) {
    const TessellationArrays arrays = read(
        "{\"x\": {\"faces\": [[0]], \"y\": [1, {}, \"a\", null, 1e5]}, \"sites\":3,\n"
        "\"faces\":[[7,8,-2147483648]], \"metric\": \"supremum\", \"z\": true,"
        "\"version\": 1, \"format\": \"signum.tessellation\"}");
    EXPECT_EQ(arrays.sites, 3);
    EXPECT_EQ(arrays.metric, Metric::supremum);
    EXPECT_EQ(arrays.weight_is, WeightIs::radius);
    EXPECT_EQ(arrays.faces, (std::vector<Face>{{7, 8, -2147483647 - 1}}));
    EXPECT_TRUE(arrays.neighbours.empty());
    EXPECT_TRUE(arrays.hidden.empty());
}

TEST(ReadTessellation, RefusesWrongValues) {
    EXPECT_EQ(error("{\"format\": \"geo\"}"),
              "1:12: the format is 'geo', not 'signum.tessellation'" + expected);
    EXPECT_EQ(error("{\"version\": 2}"),
              "1:13: version 2 is unknown, version 1 is read" + expected);
    EXPECT_EQ(
        error("{\"metric\": \"taxi\"}"),
        "1:12: \"metric\" cannot be 'taxi'; it is one of power, euclidean, manhattan, supremum");
    EXPECT_EQ(error("{\"weight_is\": \"mass\"}"),
              "1:15: \"weight_is\" cannot be 'mass'; it is one of radius, weight");
    EXPECT_EQ(error("{\"sites\": -1}"),
              "1:11: \"sites\" cannot hold -1; it holds the number of sites");
    EXPECT_EQ(error("{\"sites\": 1.5}"),
              "1:11: \"sites\" cannot hold 1.5; it holds the number of sites");
    EXPECT_EQ(error("{\"sites\": [3]}"),
              "1:11: \"sites\" cannot hold an array; it holds the number of sites");
    EXPECT_EQ(error("{\"metric\": 1}"), "1:12: \"metric\" cannot hold 1; it holds a string");
    EXPECT_EQ(error("{\"faces\": 1}"), "1:11: \"faces\" cannot hold 1; it holds [[i, j, k], ...]");
    EXPECT_EQ(error("{\"faces\": [1]}"),
              "1:12: \"faces\" cannot hold 1; it holds [[i, j, k], ...]");
    EXPECT_EQ(error("{\"faces\": [[1,2,\"a\"]]}"),
              "1:17: \"faces\" cannot hold 'a'; it holds [[i, j, k], ...]");
    EXPECT_EQ(error("{\"faces\": [[1,2,[3]]]}"),
              "1:17: \"faces\" cannot hold an array; it holds [[i, j, k], ...]");
    EXPECT_EQ(error("{\"hidden\": {}}"),
              "1:12: \"hidden\" cannot hold an object; it holds [[site, by], ...]");
    EXPECT_EQ(error("{\"faces\": [[0,1,2],\n[1,2]]}"),
              "2:1: 2 numbers in an entry of \"faces\", not 3" + expected);
    EXPECT_EQ(error("{\"hidden\": [[0,1,2]]}"),
              "1:13: more than 2 numbers in one entry of \"hidden\"" + expected);
    EXPECT_EQ(error("{\"faces\": [[0,1,2147483648]]}"),
              "1:17: 2147483648 does not fit into 32 bits" + expected);
    EXPECT_EQ(error("{\"sites\": 1, \"sites\": 2}"), "1:14: a second \"sites\"" + expected);
}

TEST(ReadTessellation, RefusesWhatIsNoTessellation) {
    EXPECT_EQ(error("[[0,0,1]]"), "1:1: an array cannot stand here" + expected);
    EXPECT_EQ(error("{}"), "1:2: \"format\" is missing" + expected);
    EXPECT_EQ(error("{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\",\n"
                    "\"sites\": 0}"),
              "2:11: \"faces\" is missing" + expected);
    const std::string of_plane =
        "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", \"sites\": "
        "3, "
        "\"faces\": [[0,1,2]], \"dimension\": ";
    EXPECT_EQ(error(of_plane + "2}"), "no error");
    EXPECT_EQ(
        error(of_plane + "3}"),
        "1:114: \"dimension\" is 3, and \"faces\" are of the plane; leave one of them out, or "
        "give \"cells\"" +
            expected);
    EXPECT_EQ(error("0 0 1\n"), "1:1: 0 cannot stand here" + expected);
    EXPECT_EQ(error("x y r\n"), "1:1: 'x' cannot stand here" + expected);
    EXPECT_EQ(error(""), "1:1: the file ends too early" + expected);
    EXPECT_EQ(error("{\"faces\": ["), "1:12: the file ends too early" + expected);
}

TEST(ReadTessellation, RefusesAMisspeltKeyOfWhatMayBeMissing) {
    const std::string begin =
        "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", \"sites\": "
        "3, \"faces\": [[0,1,2]], ";
    const auto is_no_key = [&begin](const std::string& key, const std::string& meant) {
        return "1:" + std::to_string(begin.size() + 1) + ": '" + key +
               "' is no key of a tessellation; did you mean \"" + meant + "\"?";
    };
    EXPECT_EQ(error(begin + "\"weight_si\": \"weight\"}"), is_no_key("weight_si", "weight_is"));
    EXPECT_EQ(error(begin + "\"neighbors\": [[-1,-1,-1]]}"), is_no_key("neighbors", "neighbours"));
    EXPECT_EQ(error(begin + "\"Hidden\": [[3, 0]]}"), is_no_key("Hidden", "hidden"));
    // Where what is meant is there, it is a key of somebody's own.
    EXPECT_EQ(error(begin + "\"hiden\": 1, \"hidden\": []}"), "no error");
    EXPECT_EQ(error(begin + "\"title\": \"Cells\"}"), "no error");
}

/// A tetrahedron with a hidden site in it.
SpaceTessellation tetrahedron() {
    SpaceTessellation t;
    t.dimension = 3;
    t.sites = 5;
    t.cells = {{-1, 0, 1, 2}, {-1, 0, 2, 3}, {-1, 0, 3, 1}, {-1, 1, 3, 2}, {0, 1, 2, 3}};
    t.neighbours = {{4, 3, 1, 2}, {4, 3, 2, 0}, {4, 3, 0, 1}, {4, 1, 0, 2}, {3, 1, 2, 0}};
    t.hidden = {{4, 0}};
    return t;
}

std::string json(const SpaceTessellation& tessellation, WeightIs weight_is) {
    std::ostringstream out;
    write_json(out, tessellation, Metric::power, weight_is);
    return out.str();
}

ReadTessellation read_any(std::string_view text) {
    const test::Scratch scratch;
    return read_tessellation(scratch.file("t.json", text));
}

const std::string head =
    "{\"format\": \"signum.tessellation\", \"version\": 1, \"metric\": \"power\", \"sites\": 1";

TEST(ReadAnyTessellation, NotesWhatItIgnores) {
    const std::string note =
        read_any(head + ", \"faces\": [],\n\"title\": {\"faces\": 1}, \"x\": 2}").note;
    EXPECT_NE(note.find("t.json:2:1: 'title' is no key of a tessellation, and is ignored"),
              std::string::npos)
        << note;
    EXPECT_EQ(
        read_any(json(tessellation(), JsonOptions{.vertices = true, .statistics = true})).note, "");
    EXPECT_EQ(read_any(json(tetrahedron(), WeightIs::weight)).note, "");
    EXPECT_EQ(error(head + ", \"dimension\": 0, \"cells\": [[0]], \"neighbor\": [[1]]}"),
              "1:112: 'neighbor' is no key of a tessellation; did you mean \"neighbours\"?");
}

TEST(ReadAnyTessellation, ReadsWhatIsWritten) {
    const ReadTessellation in_space = read_any(json(tetrahedron(), WeightIs::weight));
    ASSERT_TRUE(in_space.in_space.has_value());
    EXPECT_EQ(*in_space.in_space, tetrahedron());
    EXPECT_EQ(in_space.arrays.metric, Metric::power);
    EXPECT_EQ(in_space.arrays.weight_is, WeightIs::weight);

    // Of flat sites cells have fewer vertices.
    SpaceTessellation line;
    line.dimension = 1;
    line.sites = 2;
    constexpr Index none = no_vertex;
    line.cells = {{-1, 0, none, none}, {-1, 1, none, none}, {0, 1, none, none}};
    line.neighbours = {{2, 1, none, none}, {2, 0, none, none}, {1, 0, none, none}};
    EXPECT_EQ(read_any(json(line, WeightIs::radius)).in_space, line);
    EXPECT_EQ(read_any(json(SpaceTessellation{}, WeightIs::radius)).in_space, SpaceTessellation{});

    const ReadTessellation in_plane = read_any(json(tessellation()));
    EXPECT_FALSE(in_plane.in_space.has_value());
    EXPECT_EQ(in_plane.arrays, triangle());
}

TEST(ReadAnyTessellation, ReadsKeysInAnyOrder) {
    const std::string rest = head.substr(1) + "}";
    EXPECT_EQ(
        read_any("{\"neighbours\": [[0, 1, 2]], \"faces\": [[3, 4, 5]], " + rest).arrays.neighbours,
        (std::vector<Face>{{0, 1, 2}}));
    const ReadTessellation sorted =
        read_any("{\"neighbours\": [[0, 1, 2]], \"cells\": [[3, 4, 5]], \"dimension\": 2, " + rest);
    ASSERT_TRUE(sorted.in_space.has_value());
    EXPECT_EQ(sorted.in_space->cells, (std::vector<SpaceCell>{{3, 4, 5, no_vertex}}));
    EXPECT_EQ(sorted.in_space->neighbours, (std::vector<SpaceCell>{{0, 1, 2, no_vertex}}));
    EXPECT_TRUE(sorted.in_space->hidden.empty());
}

TEST(ReadAnyTessellation, RefusesWrongValues) {
    EXPECT_EQ(error(head + "}"), "1:78: \"faces\" is missing" + expected);
    EXPECT_EQ(error(head + ",\n\"cells\": []}"), "2:12: \"dimension\" is missing" + expected);
    EXPECT_EQ(error("{\"dimension\": 4}"),
              "1:15: \"dimension\" cannot hold 4; it holds a number from -1 to 3");
    EXPECT_EQ(error("{\"dimension\": -2}"),
              "1:15: \"dimension\" cannot hold -2; it holds a number from -1 to 3");
    EXPECT_EQ(error("{\"dimension\": \"3\"}"),
              "1:15: \"dimension\" cannot hold '3'; it holds a number from -1 to 3");
    EXPECT_EQ(error("{\"cells\": 1}"),
              "1:11: \"cells\" cannot hold 1; it holds [[i, j, k, l], ...]");
    EXPECT_EQ(error("{\"cells\": [[0,1,2,3],\n[0,1,2]]}"),
              "2:1: 3 numbers in an entry of \"cells\", not 4" + expected);
    EXPECT_EQ(error("{\"cells\": [[]]}"),
              "1:12: 0 numbers in an entry of \"cells\", not 1" + expected);
    EXPECT_EQ(error("{\"cells\": [[0,1,2,3,4]]}"),
              "1:12: more than 4 numbers in one entry of \"cells\"" + expected);
    EXPECT_EQ(error("{\"cells\": [[0,1,2,2147483648]]}"),
              "1:19: 2147483648 does not fit into 32 bits" + expected);
    EXPECT_EQ(error(head + ", \"dimension\": 3,\n\"cells\": [[0,1,2]]}"),
              "2:11: 3 numbers in an entry of \"cells\", not 4" + expected);
    EXPECT_EQ(error(head + ", \"dimension\": 2,\n\"cells\": [[0,1,2]],\n\"neighbours\": "
                           "[[0,1,2,3]]}"),
              "3:16: 4 numbers in an entry of \"neighbours\", not 3" + expected);
    EXPECT_EQ(error("{\"neighbours\": [[0,1,2,3]],\n\"faces\": [], " + head.substr(1) + "}"),
              "1:17: 4 numbers in an entry of \"neighbours\", not 3" + expected);
    for (const char* text : {"{\"faces\": [],\n\"cells\": []}", "{\"cells\": [],\n\"faces\": []}"})
        EXPECT_EQ(error(text),
                  "2:1: \"faces\" are of the plane and \"cells\" of space; there is one of them" +
                      expected);
}

TEST(WriteCsv, WritesTheFaces) {
    std::ostringstream out;
    write_csv(out, tessellation());
    EXPECT_EQ(out.str(), "a,b,c\n-1,0,2\n-1,1,0\n-1,2,1\n0,1,2\n");
}

TEST(WriteObj, WritesSitesAndFiniteFaces) {
    std::ostringstream out;
    write_obj(out, tessellation());
    EXPECT_EQ(out.str(),
              "# signum: power tessellation, a vertex a site\n"
              "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0.1 0.5 0\nf 1 2 3\n");
}

TEST(WriteObj, SaysThatCurvedEdgesAreDrawnStraight) {
    for (const Metric metric : {Metric::euclidean, Metric::manhattan, Metric::supremum}) {
        TessellationArrays arrays = triangle();
        arrays.metric = metric;
        std::ostringstream out;
        write_obj(out, Tessellation(arrays, std::vector<Site>(4), {}));
        EXPECT_TRUE(out.str().starts_with(
            "# signum: " + std::string(name_of(metric)) +
            " tessellation, a vertex a site\n# edges are curved in this metric; drawn straight, "
            "faces may overlap or turn\nv 0 0 0\n"))
            << out.str();
    }
}

TEST(WriteSites, ReadsBackToTheSameDoubles) {
    const std::vector<Site> sites = {{0.1, -1e300, 5e-324},
                                     {1.0 / 3.0, 1e16, 0x1.fffffffffffffp1023},
                                     {-0.0, 123456789.125, 1e-5}};
    for (const SitesFormat format : {SitesFormat::text, SitesFormat::csv, SitesFormat::json}) {
        std::ostringstream out;
        write_sites(out, sites, format);
        const test::Scratch scratch;
        EXPECT_EQ(read_sites(scratch.file("s", out.str()), {.dimension = 2}).sites, sites)
            << out.str();
    }
}

}  // namespace
}  // namespace signum
