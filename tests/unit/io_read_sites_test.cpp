#include <sys/stat.h>

#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "../../tool/io/read_sites.hpp"

#include "../thoroughness.hpp"
#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using namespace std::string_literals;
using Sites = std::vector<Site>;

SitesFile read(std::string_view contents, const Columns& columns = {}) {
    const test::Scratch scratch;
    return read_sites(scratch.file("f", contents), {.columns = columns, .dimension = 2});
}

/// The error message that the contents give, without the path.
std::string error(std::string_view contents, const Columns& columns = {}) {
    return test::refusal(contents, [&](const std::string& path) {
        return read_sites(path, {.columns = columns, .dimension = 2});
    });
}

const std::string word =
    " is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or 0x1.8p-3";
const std::string json = "; sites are [[x, y, r], ...] with finite numbers";

TEST(TextSites, ReadsColumns) {
    EXPECT_EQ(read("1 2 3\n4 5 6\n").sites, (Sites{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read("1 2").sites, (Sites{{1, 2, 0}}));
    EXPECT_EQ(read("1 2\n3 4 5").sites, (Sites{{1, 2, 0}, {3, 4, 5}}));
    EXPECT_EQ(read("1 2 -3").sites, (Sites{{1, 2, -3}}));
    EXPECT_EQ(read("0x1.8p-3 +.5 -1e-3").sites, (Sites{{0.1875, 0.5, -1e-3}}));
}

TEST(TextSites, ReadsEverySeparator) {
    EXPECT_EQ(read("1\t2\t3\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("  1   2 \t 3  \n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("1,2,3\n4;5;6\n").sites, (Sites{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read("1 , 2\t,\t3\n").sites, (Sites{{1, 2, 3}}));
}

TEST(TextSites, ReadsEveryEndOfLine) {
    EXPECT_EQ(read("1 2 3\r\n4 5 6\r\n").sites, (Sites{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read("1,2\r\n4,5").sites, (Sites{{1, 2, 0}, {4, 5, 0}}));
    EXPECT_EQ(read("\n\n1 2\n \t \n\r\n3 4\n\n").sites, (Sites{{1, 2, 0}, {3, 4, 0}}));
}

/// All that a file says, or its refusal.
std::string outcome(const test::Scratch& scratch, const std::string& contents,
                    std::optional<int> dimension) {
    std::string told;
    const auto add = [&](const auto&... numbers) {
        ((told += std::to_string(numbers) + ' '), ...);
    };
    const auto add_position = [&](const std::optional<Position>& at) {
        if (at) add(at->line, at->column);
        told += ';';
    };
    try {
        const SitesFile file = read_sites(scratch.file("f", contents), {.dimension = dimension});
        for (const auto& [x, y, r] : file.sites) add(x, y, r);
        for (const auto& [x, y, z, r] : file.in_space) add(x, y, z, r);
        add_position(file.first_negative);
        add_position(file.first_beyond_single);
        add(file.dimension, file.third_may_be_z, static_cast<int>(file.third.has_value()));
        return told + file.note;
    } catch (const InputError& error) {
        return error.what();
    }
}

/// Lines of numbers alone are read many at a time. A comment behind each, or a tab where a mark
/// separates, makes them lines like any other, which say the same.
TEST(TextSites, ReadsPlainLinesAsAnyOther) {
    const test::Scratch scratch;
    std::mt19937_64 random(42);
    const auto one_of = [&](const std::vector<std::string>& texts) {
        return texts[random() % texts.size()];
    };
    const std::vector<std::string> heads = {
        "",           "",           "", "x y r\n", "x,y\n", "x,y,weight\n", "x\ty\tz\tr\n",
        "y x name\n", "# nothing\n"};
    const std::vector<std::string> numbers = {"1", "-2.5", "0.1", "1e-3", "+7", "0x1p3", "3"};
    const std::vector<std::string> odd = {"", "a", "1e39", "\"4\"", "nan", "1e999", "-0", "1."};
    for (int trial = 0; trial < (is_fast ? 4000 : 400); ++trial) {
        const std::string head = one_of(heads);
        const bool has_tabs = head.starts_with("x\t");
        const int dimension = has_tabs ? 3 : 2 + trial % 2;
        const std::string separator =
            has_tabs ? one_of({" ", "\t"})
                     : one_of({" ", " ", "\t", ",", ";", ", ", "  ", " ,", "\t\t"});
        std::vector<std::string> lines;
        for (int line = static_cast<int>(random() % 40); line >= 0; --line) {
            std::string text = one_of({"", "", "", "", " ", has_tabs ? "" : "\t"});
            const bool is_odd = random() % 40 == 0;
            const auto columns = static_cast<int>(is_odd ? random() % 6 : 3 + random() % 2);
            for (int column = 0; column < columns; ++column)
                text += (column > 0 ? separator : "") +
                        one_of(is_odd || random() % 300 == 0 ? odd : numbers);
            lines.push_back(text + one_of({"", "", "", "", " "}));
        }
        const std::string end = separator.find_first_of(",;") == std::string::npos ? "#\n" : "\t\n";
        std::string plain = head;
        std::string commented = head;
        for (const std::string& line : lines) {
            plain += line + '\n';
            // Behind a mark the tab would move the empty column.
            const std::size_t last = line.find_last_not_of(" \t");
            const bool is_open =
                last != std::string::npos && (line[last] == ',' || line[last] == ';');
            commented += line + (is_open ? "\n" : end);
        }
        ASSERT_EQ(outcome(scratch, plain, dimension), outcome(scratch, commented, dimension))
            << plain;
    }
}

/// What is wrong, or has to be told, far behind the first block is told where it stands.
TEST(TextSites, ReadsManyPlainLines) {
    std::string contents;
    Sites sites;
    for (int i = 0; i < 500'000; ++i) {
        contents += std::to_string(i) + ' ' + std::to_string(i % 77) + " 2\n";
        sites.push_back({static_cast<double>(i), static_cast<double>(i % 77), 2});
    }
    EXPECT_EQ(read(contents).sites, sites);
    EXPECT_EQ(error(contents + "1 2 x\n"), "500001:5: 'x'" + word);
    const SitesFile negative = read(contents + "1 2 3\n1 2 -3\n# 4\n1e39 2 -3\n7 8");
    EXPECT_EQ(negative.sites.size(), 500'004);
    EXPECT_EQ(negative.sites.back(), (Site{7, 8, 0}));
    EXPECT_EQ(negative.first_negative->line, 500'002);
    EXPECT_EQ(negative.first_beyond_single->line, 500'004);
}

TEST(TextSites, RefusesLinesThatEndInCarriageReturnsAlone) {
    const std::string lone =
        "a line that ends in CR alone; save the file with LF at the ends of lines";
    EXPECT_EQ(error("1 2\r3 4\r"), "1:4: " + lone);
    EXPECT_EQ(error("x y r\r1 2 3\r4 5 6\r"), "1:6: " + lone);
    EXPECT_EQ(error("1 2\n# a comment\r3 4\n"), "2:12: " + lone);
    std::string many;
    for (int i = 0; i < 100'000; ++i) many += "1 2 3\r";
    EXPECT_EQ(error(many), "1:6: " + lone);
}

TEST(TextSites, SkipsMarkCommentsAndHeader) {
    EXPECT_EQ(read("\xEF\xBB\xBF# made by hand\n1 2 3# here\n#\n4 5 6 # there\n").sites,
              (Sites{{1, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(read("\xEF\xBB\xBFx y r\n1 2 3\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("# comment\nlongitude latitude\n1 2\n").sites, (Sites{{1, 2, 0}}));
}

TEST(TextSites, PicksNamedColumns) {
    EXPECT_EQ(read("r,y,x\n1,2,3\n").sites, (Sites{{3, 2, 1}}));
    EXPECT_EQ(read("Y X\n1 2\n").sites, (Sites{{2, 1, 0}}));
    EXPECT_EQ(read("id;radius;x;name;y\n7;1;2;a, b c;3\n8;4;5;;6\n").sites,
              (Sites{{2, 3, 1}, {5, 6, 4}}));
    EXPECT_EQ(read(",\"x\",\"y\",\"r\",\"n\"\n0,1,2,3,\"a,#b\"\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("x\ty\tn\tr\n1\t2\t\t3\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("n x y r\n7 1 2 3\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("x,y,r\n1,2,3\n").note, "");
    EXPECT_EQ(read("x y r\n1,2,3\n").sites, (Sites{{1, 2, 3}}));
}

TEST(TextSites, RefusesRowsThatAreShorterThanTheHeader) {
    EXPECT_EQ(error("x,y,r\n1,2\n"), "2:4: 2 columns, but the header names 3; write as many");
    EXPECT_EQ(error("x y weight\n1 2 3\n\n4 5\n6 7\n"),
              "4:4: 2 columns, but the header names 3; write as many");
    // The mark of a comment that is none here shifts all columns by one.
    EXPECT_EQ(error("% x y r\n1 2 3\n"), "2:6: 3 columns, but the header names 4; write as many");
}

TEST(TextSites, NotesLinesThatEndBeforeTheRadiusThatWasChosen) {
    const auto note = [](const char* text, const Columns& columns) {
        const std::string whole = read(text, columns).note;
        return whole.substr(std::min(whole.find("f:"), whole.size()));
    };
    EXPECT_EQ(note("1 2 3\n1 2\n", {"1", "2", "3"}),
              "f:2: the line ends before its radius, which is 0 then (1 of 2 lines)");
    EXPECT_EQ(note("1 2\n1 2 3\n", {}), "") << "a site is x y [r] where no header says otherwise";
    EXPECT_EQ(note("1 2\n1 2 3\n", {"1", "2"}), "");
    EXPECT_EQ(note("x y\n1 2\n", {}), "");
}

TEST(TextSites, TakesNoColumnForARadiusBecauseItIsThird) {
    for (const char* text : {"lon,lat,elevation\n1,2,3\n", "lon lat elevation\n1 2 3\n",
                             "x;y;name\n1;2;a, b\n", "x\ty\tn\n1\t2\t\n"}) {
        const SitesFile file = read(text);
        EXPECT_EQ(file.sites, (Sites{{1, 2, 0}})) << text;
        EXPECT_NE(file.note.find("is left out"), std::string::npos) << text;
    }
    EXPECT_NE(
        read("\"where, north\",x,y\n3,1,2\n")
            .note.find(
                "/f:1: 'where, north' is left out: no radius, or it would "
                "be called r, radius or weight. --columns 2,3,1 takes it for one, --columns 2,3 "
                "leaves it out without a word"),
        std::string::npos);
    const SitesFile named = read("Radius,lon,lat\n3,1,2\n");
    EXPECT_EQ(named.sites, (Sites{{1, 2, 3}}));
    EXPECT_NE(named.note.find("'lon' is x and 'lat' is y"), std::string::npos);
    // What only numbers the rows is left out without a word.
    EXPECT_EQ(read("id,X,Y\n3,1,2\n").sites, (Sites{{1, 2, 0}}));
    EXPECT_EQ(read("id,X,Y\n3,1,2\n").note, "");
}

/// Whatever their order: a latitude is y.
TEST(TextSites, KnowsTheNamesThatProgramsGiveCoordinates) {
    struct Header {
        const char* names;
        Site site;  ///< of the row 1, 2, 3
        bool are_degrees = false;
    };
    const std::vector<Header> headers = {
        {"Latitude,Longitude,n", {2, 1, 0}, true},
        {"id,lon,lat", {2, 3, 0}, true},
        {"id\tLatitude\tLongitude", {3, 2, 0}, true},
        {"decimalLatitude;decimalLongitude;species", {2, 1, 0}, true},
        {"stop_lat,stop_lon,stop_id", {2, 1, 0}, true},
        {"LAT_DD LONG_DD radius", {2, 1, 3}, true},
        {"GPS Longitude,GPS Latitude,fid", {1, 2, 0}, true},
        {"northing;easting;r", {2, 1, 3}},
        {"OBJECTID,POINT_X,POINT_Y", {2, 3, 0}},
        {"gid,xcoord,ycoord", {2, 3, 0}},
        {"FID;X_UTM;Y_UTM", {2, 3, 0}},
        {"no,Easting (m),Northing (m)", {2, 3, 0}},
        {"Rechtswert;Hochwert;Nr", {1, 2, 0}},
        {"N,E,id", {2, 1, 0}},
        {"x_center,y_center,r", {1, 2, 3}},
        {"CoordX,CoordY,radius", {1, 2, 3}},
        {"pos.x,pos.y,id", {1, 2, 0}},
        {"centroid-x,centroid-y,area", {1, 2, 0}},
        {"X [um],Y [um],R", {1, 2, 3}},
        {"Position X,Position Y,Unit", {1, 2, 0}},
        // Names that say nothing, and what only numbers the rows.
        {"a,b,r", {1, 2, 3}},
        {"FID,a,b", {2, 3, 0}},
        {"Unnamed: 0,u,v", {2, 3, 0}},
    };
    for (const Header& header : headers) {
        const char separator =
            std::string_view(header.names).find('\t') != std::string_view::npos  ? '\t'
            : std::string_view(header.names).find(';') != std::string_view::npos ? ';'
            : std::string_view(header.names).find(',') != std::string_view::npos ? ','
                                                                                 : ' ';
        const SitesFile file = read(header.names + "\n1"s + separator + "2" + separator + "3\n");
        EXPECT_EQ(file.sites, Sites{header.site}) << header.names;
        EXPECT_EQ(file.are_degrees, header.are_degrees) << header.names;
        EXPECT_NE(file.note.find(" is x and "), std::string::npos) << header.names;
    }
    EXPECT_EQ(read("lat lon\n1 2\n", {"lon", "lat"}).note, "");
    EXPECT_EQ(read("lat lon\n1 2\n", {"lon", "lat"}).sites, (Sites{{2, 1, 0}}));
    EXPECT_EQ(error("POINT_X,POINT_Y,X_UTM,Y_UTM\n1,2,3,4\n"),
              "1:1: several columns may be x and y among 'POINT_X', 'POINT_Y', 'X_UTM', 'Y_UTM'; "
              "choose with --columns, as in --columns POINT_X,POINT_Y");
    EXPECT_EQ(error("lon,lat,easting,northing\n1,2,3,4\n"),
              "1:9: several columns may be x and y among 'lon', 'lat', 'easting', 'northing'; "
              "choose with --columns, as in --columns easting,northing");
}

TEST(TextSites, SaysThatAHeightIsLeftOut) {
    const SitesFile file = read("x y z r\n1 2 9 3\n");
    EXPECT_EQ(file.sites, (Sites{{1, 2, 3}}));
    EXPECT_NE(file.note.find("/f:1: 'z' is left out: sites lie in the plane here. --columns 1,2,4 "
                             "leaves it out without a word"),
              std::string::npos)
        << file.note;
    EXPECT_NE(read("n;\"Z\";weight;y;x\n0;9;3;2;1\n").note.find("--columns 5,4,3 leaves"),
              std::string::npos);
    EXPECT_EQ(read("x y z r\n1 2 9 3\n", {"x", "y", "r"}).note, "");
    EXPECT_EQ(read("n x y r\n9 1 2 3\n").note, "");
}

TEST(TextSites, TakesTheColumnsThatAreChosen) {
    const char* cities = "id;name;Lon;Lat;\"height; m\";r\n7;a, b;1;2;3;4\n";
    EXPECT_EQ(read(cities, {"lon", "LAT"}).sites, (Sites{{1, 2, 0}}));
    EXPECT_EQ(read(cities, {"lon", "lat", "Height; m"}).sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read(cities, {"3", "4", "r"}).sites, (Sites{{1, 2, 4}}));
    EXPECT_EQ(read("1,2,3\n4,5,6\n", {"2", "3"}).sites, (Sites{{2, 3, 0}, {5, 6, 0}}));
    EXPECT_EQ(read("\"1\",\"2\",\"3\"\n").sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("7 1 2 3 x\n", {"2", "3", "4"}).sites, (Sites{{1, 2, 3}}));
    EXPECT_EQ(read("lon,lat,height\n1,2,3\n", {"1", "2"}).note, "");
    EXPECT_EQ(read("a,b,weight\n1,2,3\n", {"1", "2", "3"}).third, WeightIs::weight);
    EXPECT_EQ(read("a,b,weight\n1,2,3\n", {"1", "2"}).third, std::nullopt);

    EXPECT_EQ(error(cities, {"lom", "lat"}),
              "1:1: no column is called 'lom'; did you mean 'Lon'? there are 'id', 'name', "
              "'Lon', 'Lat', 'height; m', 'r'");
    EXPECT_EQ(error(cities, {"1", "7"}),
              "1:1: there is no column 7; columns count from 1, and this line has 6");
    EXPECT_EQ(error(cities, {"0", "1"}),
              "1:1: there is no column 0; columns count from 1, and this line has 6");
    EXPECT_EQ(error(cities, {"lon", "3"}),
              "1:1: column 3 is chosen twice; x, y and r are different columns");
    EXPECT_EQ(error("a,b,a\n1,2,3\n", {"a", "b"}),
              "1:1: several columns are called 'a'; choose by number");
    EXPECT_EQ(
        error("\n1,2,3\n", {"x", "y"}),
        "2:1: column 'x' is chosen by name, and the first line is no header; choose by number, "
        "from 1 to 3");
    EXPECT_EQ(error("n;x;y\n1;2,5;3\n", {"x", "y"}),
              "2:3: '2,5' has a decimal comma; write a point in its place, or say --decimal ,");
    EXPECT_EQ(error("n;x;y\n1;2\n", {"x", "y"}),
              "2:4: 2 columns, but the header names 3; write as many");
    EXPECT_EQ(error("1;2\n", {"1", "3"}),
              "1:1: there is no column 3; columns count from 1, and this line has 2");
    EXPECT_EQ(error("1;2;3\n1;2\n", {"1", "3"}),
              "2:4: the line ends before the columns x and y; write both");
}

TEST(TextSites, ReadsWhatTheCallSaysOfALine) {
    const test::Scratch scratch;
    const auto with = [&](std::string_view text, const ReadOptions& options) {
        return read_sites(scratch.file("f", text), options);
    };
    const auto refused = [&](std::string_view text, const ReadOptions& options) {
        return test::refusal(text,
                             [&](const std::string& path) { return read_sites(path, options); });
    };
    const ReadOptions comma = {.dimension = 2, .decimal = ','};
    EXPECT_EQ(with("x;y;r\n1,5;-2,25e1;3\n", comma).sites, (Sites{{1.5, -22.5, 3}}));
    EXPECT_EQ(with("1,5 2\n3\t4,5\n", comma).sites, (Sites{{1.5, 2, 0}, {3, 4.5, 0}}));
    EXPECT_EQ(with("name;x;y\na, b;1,5;2\n", comma).sites, (Sites{{1.5, 2, 0}}));
    EXPECT_EQ(refused("1.5;2\n", comma),
              "1:1: '1.5' has a point, and --decimal says that a comma is it");
    EXPECT_EQ(refused("1.234,5;2\n", comma),
              "1:1: '1.234,5' has separators of thousands; write the digits alone");

    const ReadOptions two = {.dimension = 2, .skipped_lines = 2};
    EXPECT_EQ(with("Survey 7; \"unclosed\nMade by hand, 1 2 3\nx y\n1 2\n", two).sites,
              (Sites{{1, 2, 0}}));
    EXPECT_EQ(refused("a\nb\nx y\n1 two\n", two), "4:3: 'two'" + word);
    EXPECT_EQ(refused("a\nb\n", two), "2:1: no site in this file; write one site a line: x y [r]");

    const ReadOptions skipping = {.dimension = 2, .skips_missing = true};
    const SitesFile some =
        with("n,x,y\na,1,2\nb,,3\nc,NA,NaN\n,4,5\ne,null,1\nf,6,None\ng,7,n/a\n", skipping);
    EXPECT_EQ(some.sites, (Sites{{1, 2, 0}, {4, 5, 0}}));
    EXPECT_NE(some.note.find("f:3: a number is missing; 5 of 7 lines are passed over"),
              std::string::npos)
        << some.note;
    EXPECT_EQ(with("n,x,y\na,1,2\n", skipping).note.find("missing"), std::string::npos);
    EXPECT_EQ(refused("n,x,y\na,1,two\n", skipping), "2:5: 'two'" + word);
    EXPECT_EQ(refused("x,y\n1,NA\n", {.dimension = 2}), "2:3: 'NA'" + word);
}

/// Whatever may have been meant by a # behind the start of a line: no column and no attribute is
/// cut.
TEST(TextSites, BeginsAColumnWithTheMarkOfAComment) {
    EXPECT_EQ(read("# 0,x,y\nid#,x,y\n1,2,3\n# 4,5,6\n7,8,9\n").sites,
              (Sites{{2, 3, 0}, {8, 9, 0}}));
    EXPECT_EQ(read("Well #,Easting,Northing,Depth\n1,1000,2000,30\n").sites,
              (Sites{{1000, 2000, 0}}));
    EXPECT_EQ(read("x,y,color\n1,2,#ff0000\n3,4,#00ff00\n").sites, (Sites{{1, 2, 0}, {3, 4, 0}}));
    EXPECT_EQ(
        error("1,2 # three\n"),
        "1:5: where commas, semicolons or tabs separate, a comment begins at the start of its "
        "line");
    const test::Scratch scratch;
    const SitesFile colors = read_sites(scratch.file("f", "x,y,color\n1,2,#ff0000\n"),
                                        {.dimension = 2, .attributes = true});
    EXPECT_EQ(colors.attributes.front().values.front(), "#ff0000");
}

TEST(TextSites, NamesWhatANumberIsWrittenAs) {
    EXPECT_EQ(read("1.0D+00 -2d-1 .5D0\n").sites, (Sites{{1, -0.2, 0.5}}));
    for (const char* number : {"1,234,567", "1'234.5", "1 234 567", "1_000", "12.345.678"}) {
        const std::string quoted = "\""s + number + "\"";
        EXPECT_EQ(error("x;y\n" + quoted + ";2\n"),
                  "2:2: '"s + number + "' has separators of thousands; write the digits alone");
    }
    EXPECT_EQ(error("lat,lon\n52°31'12\"N\",1\n").substr(0, 4), "2:1:");
    EXPECT_EQ(
        error("x y\n52°31'12N 13°24'E\n"),
        "2:1: '52°31'12N' is in degrees, minutes and seconds, which are not read; write degrees "
        "as a decimal fraction");
}

TEST(TextSites, SaysWhereTheFirstNegativeThirdNumberStands) {
    EXPECT_FALSE(read("1 2 -0\n-1 -2 3\n").first_negative);
    const auto text = read("x y r\n1 2 3\n1 2 -3\n1 2 -4\n").first_negative;
    ASSERT_TRUE(text);
    EXPECT_EQ(text->line, 3);
    EXPECT_EQ(text->column, 5);
    const auto json = read("[[1,2,3],\n[1,2,-3]]").first_negative;
    ASSERT_TRUE(json);
    EXPECT_EQ(json->line, 2);
}

TEST(TextSites, SaysWhatTheHeaderSays) {
    EXPECT_EQ(read("x y weight\n1 2 3\n").third, WeightIs::weight);
    EXPECT_EQ(read("x y Radius\n1 2 3\n").third, WeightIs::radius);
    EXPECT_EQ(read("x y r\n1 2 3\n").third, std::nullopt);
    EXPECT_EQ(read("1 2 3\n").third, std::nullopt);
}

TEST(TextSites, RefusesWhatIsNoNumber) {
    EXPECT_EQ(error("1 2 3\n4 five 6\n"), "2:3: 'five'" + word);
    EXPECT_EQ(error("1 2 3x\n"), "1:5: '3x'" + word);
    EXPECT_EQ(error("1x 2y\n"), "1:1: '1x'" + word);
    EXPECT_EQ(error("\xEF\xBB\xBF"
                    "1 two\n"),
              "1:3: 'two'" + word);
    EXPECT_EQ(error("1 nan\n"), "1:3: 'nan' is not a finite number; write a finite one");
    EXPECT_EQ(error("nan nan\n"), "1:1: 'nan' is not a finite number; write a finite one");
    EXPECT_EQ(error("1 2 -inf\n"), "1:5: '-inf' is not a finite number; write a finite one");
    EXPECT_EQ(error("1 1e999\n"),
              "1:3: '1e999' is beyond the range of a double; the largest is about 1.797e308");
}

TEST(TextSites, RefusesWrongColumns) {
    EXPECT_EQ(error("1 2\n3\n"), "2:2: one column; a site has at least two: x y [r]");
    EXPECT_EQ(error("1 2 3 4\n"),
              "1:7: more than three columns; a site is x y [r], or name the columns x, y and r (or "
              "radius, weight) in a first line, or choose with --columns, as in --columns 1,2");
    EXPECT_EQ(
        error("1,5,2,5\n"),
        "1:7: more than three columns; a site is x y [r], a fraction has a point, or name the "
        "columns x, y and r (or radius, weight) in a first line, or choose with --columns, as "
        "in --columns 1,2");
    const std::string empty = "an empty column; write a number or remove the separator";
    EXPECT_EQ(error("1,,2\n"), "1:3: " + empty);
    EXPECT_EQ(error("1,2,\n"), "1:5: " + empty);
    EXPECT_EQ(error("1,2,3,\n"), "1:7: " + empty);
    EXPECT_EQ(error(",1,2\n"), "1:1: " + empty);
    EXPECT_EQ(
        error("1,5;2,5\n"),
        "1:4: commas and semicolons in one line; separate by one of them, and write fractions "
        "with a point");
}

TEST(TextSites, RefusesAnEmptyColumnBetweenTabs) {
    const std::string empty = "an empty column; write a number or remove the separator";
    EXPECT_EQ(error("x\ty\tr\n1\t\t3\n"), "2:3: " + empty);
    EXPECT_EQ(error("x\ty\tr\n\t2\t3\n"), "2:1: " + empty);
    EXPECT_EQ(error("1\t2\t3\n4\t\t6\n"), "2:3: " + empty);
    // Where the first line is aligned by tabs, so may be the others.
    EXPECT_EQ(read("1\t\t2\t3\n4\t5\t\t6\n").sites.size(), 2);
    EXPECT_EQ(read("\t1\t2\n\t3\t4\n").sites.size(), 2);
    EXPECT_EQ(read("\t\n\t# remark\nx\ty\n1\t2\n").sites.size(), 1);
}

TEST(TextSites, RefusesCommasBesideBlanks) {
    const std::string one =
        " and blanks in one line; separate by one of them, and write fractions with a point";
    EXPECT_EQ(error("1,5 2\n"), "1:5: commas" + one);
    EXPECT_EQ(error("1 2,5\n"), "1:4: commas" + one);
    EXPECT_EQ(error("1 2\n3\t4,5 # here\n"), "2:4: commas" + one);
    EXPECT_EQ(error("1,5 2,5\n"), "1:5: commas" + one);
    EXPECT_EQ(error("1; 2 3\n"), "1:6: semicolons" + one);
    EXPECT_EQ(error("x y r\n1 2 3\n1,5 2\n"), "3:5: commas" + one);
    EXPECT_EQ(read(" 1, 2 \n3 ,4\t, 5 \n8 , 9\n").sites, (Sites{{1, 2, 0}, {3, 4, 5}, {8, 9, 0}}));
}

TEST(TextSites, RefusesHeadersThatLeaveADoubt) {
    const std::string choose = "; choose them with --columns, as in --columns 1,2";
    EXPECT_EQ(error("id,height,name,pop\n1,2,3,4\n"),
              "1:1: none of the columns 'id', 'height', 'name', 'pop' is called x or y" + choose);
    EXPECT_EQ(error("x z\n1 2\n"),
              "1:1: the header does not name both x and y, but 'x', 'z'" + choose);
    EXPECT_EQ(error("name,lat,pop\n1,2,3\n"),
              "1:1: none of the columns 'name', 'lat', 'pop' is called x or y" + choose);
    EXPECT_EQ(error("x y x\n1 2 3\n"), "1:5: a second column x; name one");
    EXPECT_EQ(error("x y r weight\n1 2 3 4\n"),
              "1:7: a second column of radii or weights; name one column r, radius or weight");
    // Names of one column alone, of which none stands for the other.
    EXPECT_EQ(error("lat\n1\n"), "1:1: none of the columns 'lat' is called x or y" + choose);
    EXPECT_EQ(error("r\n1\n"), "1:1: none of the columns 'r' is called x or y" + choose);
    EXPECT_EQ(error("n,x,y,r\n1,2\n"), "2:4: 2 columns, but the header names 4; write as many");
    EXPECT_EQ(error("n,x,y,r\n1,2,3,4,5\n"),
              "2:9: 5 columns, but the header names 4; write as many");
    EXPECT_EQ(error("x,y,\"name\n1,2,3\n"),
              "1:5: a quotation mark that nothing on this line closes; close it");
    EXPECT_EQ(error("x y r\nx y r\n1 2 3\n"), "2:1: 'x'" + word);
}

TEST(TextSites, RefusesFilesWithoutSites) {
    EXPECT_EQ(error(""), "1:1: no site in this file; write one site a line: x y [r]");
    EXPECT_EQ(error("# nothing\n\n"), "2:1: no site in this file; write one site a line: x y [r]");
    EXPECT_EQ(error("x y r\n"), "1:1: a header and no site; write one site a line: x y [r]");
}

TEST(TextSites, RefusesBinaryFiles) {
    EXPECT_EQ(error("1 2\n3 \0 4\n"s),
              "2:3: a NUL byte, so this is a binary file; give a file of sites as text");
    // In a later block than the first.
    std::string far;
    for (int i = 0; i < 100'000; ++i) far += "1 2 3\n";
    EXPECT_EQ(error(far + "1 2\0"s),
              "100001:4: a NUL byte, so this is a binary file; give a file of sites as text");
    EXPECT_EQ(error("\xFF\xFE\x31\0"s),
              "1:1: this is UTF-16 text; save the file as UTF-8 or ASCII");
    EXPECT_EQ(error("ab\x1F\x8B q\n1 2\n"),
              "1:3: a control character, so this is no text; write one site a line: x y [r]");
}

TEST(TextSites, RefusesLongLines) {
    const std::string limit =
        "1:65537: a line of more than 65536 bytes; write one site a line: x y [r]";
    EXPECT_EQ(error(std::string(1'000'000, 'a')), limit);
    EXPECT_EQ(error(std::string(1'000'000, ' ') + "1 2\n"), limit);
    EXPECT_EQ(error("#" + std::string(70'000, '-') + "\n1 2\n"), limit);
    EXPECT_EQ(read("1 2" + std::string(65'533, ' ') + "\r\n3 4\n").sites,
              (Sites{{1, 2, 0}, {3, 4, 0}}));
    EXPECT_EQ(error("1 2" + std::string(65'534, ' ') + "\n"), limit);
}

TEST(TextSites, ReadsAcrossBlocks) {
    std::string text;
    Sites expected;
    for (int i = 0; i < 200'000; ++i) {
        text += std::to_string(i) + " " + std::to_string(-i) + " 0.5\n";
        expected.push_back({static_cast<double>(i), static_cast<double>(-i), 0.5});
    }
    EXPECT_EQ(read(text).sites, expected);
    EXPECT_EQ(error(text + "1 2 z"), "200001:5: 'z'" + word);
}

TEST(JsonSites, Reads) {
    EXPECT_EQ(read("[[1,2,3],[4.5,-5e0]]").sites, (Sites{{1, 2, 3}, {4.5, -5, 0}}));
    EXPECT_EQ(read("\xEF\xBB\xBF \r\n [ [1, 2, 3] ,\n [4, 5] ]\n\n").sites,
              (Sites{{1, 2, 3}, {4, 5, 0}}));
    EXPECT_EQ(read("[[0.1,1e-999],[9007199254740993,123456789012345678901234567890]]").sites,
              (Sites{{0.1, 0, 0}, {9007199254740992.0, 123456789012345678901234567890.0, 0}}));
}

TEST(JsonSites, TakesTheNumbersThatAreChosen) {
    const char* rows = "[[\"a\",1,null,2,3],\n[true,4,5,6]]";
    EXPECT_EQ(read(rows, {"2", "4", "5"}).sites, (Sites{{1, 2, 3}, {4, 6, 0}}));
    EXPECT_EQ(error(rows, {"2", "3"}), "1:9: null cannot stand here" + json);
    EXPECT_EQ(error(rows, {"2", "5"}), "2:1: a site that ends before x and y" + json);
    EXPECT_EQ(error(rows, {"2", "2"}),
              "1:1: number 2 is chosen twice; x, y and r are different numbers");
    EXPECT_EQ(error(rows, {"x", "2"}),
              "1:1: 'x' is chosen, and the numbers of a site in JSON have no names; choose by "
              "number, from 1");
}

TEST(JsonSites, RefusesWhatIsNoListOfSites) {
    EXPECT_EQ(error("[]"), "1:1: no site in this file" + json);
    EXPECT_EQ(error("[[]]"), "1:2: an empty site" + json);
    EXPECT_EQ(error("[[1,2,3],\n [4]]"), "2:2: a site of one number" + json);
    EXPECT_EQ(error("[[1,2,3,4]]"),
              "1:9: a fourth number in a site, as those in space have it; those of the plane are "
              "wanted here" +
                  json);
    EXPECT_EQ(error("[1,2]"), "1:2: a number outside of a site" + json);
    EXPECT_EQ(error("[[1,[2]]]"), "1:5: an array within a site" + json);
    EXPECT_EQ(error("[[1,\"two\"]]"), "1:5: a string cannot stand here" + json);
    EXPECT_EQ(error("[[1,null]]"), "1:5: null cannot stand here" + json);
    EXPECT_EQ(error("[[1,true]]"), "1:5: true cannot stand here" + json);
    EXPECT_EQ(error("{\"sites\": []}"),
              "1:1: no point in this file; of GeoJSON points are read, such as {\"type\": "
              "\"Point\", \"coordinates\": [x, y]}, alone, in features or in a collection");
    EXPECT_EQ(error("[{\"x\": 1}]"), "1:2: an object cannot stand here" + json);
    EXPECT_EQ(error("[[1,1e999]]"),
              "1:5: '1e999' is beyond the range of a double; the largest is about 1.797e308");
    EXPECT_EQ(error(std::string(1'000'000, '[')), "1:3: an array within a site" + json);
}

TEST(JsonSites, RefusesWhatIsNoJson) {
    EXPECT_EQ(error("[[1,2]"), "1:7: the file ends too early" + json);
    EXPECT_EQ(error("[[1,2]\n,\n[\"ab"), "3:5: the file ends too early" + json);
    EXPECT_EQ(error("[[1,2]] x"), "1:9: 'x' cannot stand here" + json);
    EXPECT_EQ(error("[[1,2]],[[3,4]]"), "1:8: ',' cannot stand here" + json);
    EXPECT_EQ(error("[[1,,2]]"), "1:5: ',' cannot stand here" + json);
    EXPECT_EQ(error("[[1 2]]"), "1:5: '2' cannot stand here" + json);
    EXPECT_EQ(error("[[1,nan]]"), "1:5: 'nan' cannot stand here" + json);
    EXPECT_EQ(error("[[1,2],\n [-Infinity,2]]"), "2:3: '-Infinity' cannot stand here" + json);
    EXPECT_EQ(error("[[0x10,2]]"), "1:3: '0x10' cannot stand here" + json);
    EXPECT_EQ(error("[[1,\"a\n\"]]"), "1:5: a string that is not valid JSON" + json);
    EXPECT_EQ(error("[[1,2]\0]"s),
              "1:7: a NUL byte, so this is a binary file; give a file of sites as text");
    EXPECT_EQ(error("[[\n" + std::string(1'000'000, '1') + ",2]]"),
              "2:1: a value of more than 65536 bytes; write shorter ones");
}

TEST(JsonSites, ReadsAcrossBlocks) {
    std::string text = "[[0,0]";
    for (int i = 1; i < 100'000; ++i) text += ",[" + std::to_string(i) + ",0.25]";
    const Sites sites = read(text + "]").sites;
    ASSERT_EQ(sites.size(), 100'000U);
    EXPECT_EQ(sites.back(), (Site{99'999, 0.25, 0}));
    EXPECT_EQ(error(text + "\n,x]"), "2:2: 'x' cannot stand here" + json);
    EXPECT_EQ(error(text + "\n,\0]"s),
              "2:2: a NUL byte, so this is a binary file; give a file of sites as text");
}

TEST(SitesFile, RefusesWhatCannotBeRead) {
    const test::Scratch scratch;
    const auto message = [](const std::string& path) {
        try {
            static_cast<void>(read_sites(path, {.dimension = 2}));
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    const std::string directory = scratch.path("");
    EXPECT_EQ(message(directory), directory + ": this is a directory; give a file of sites");
    const std::string missing = scratch.path("missing");
    EXPECT_EQ(message(missing), missing +
                                    ": cannot open it (No such file or directory); give a "
                                    "file of sites, or - for standard input");
}

TEST(SitesFile, ReadsAPipeThatComesInPieces) {
    const test::Scratch scratch;
    const std::string path = scratch.path("pipe");
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::jthread writer([&] {
        std::ofstream pipe(path);
        for (const char* piece : {"1 ", "2 3", "\n4", " 5\n"}) pipe << piece << std::flush;
    });
    EXPECT_EQ(read_sites(path, {.dimension = 2}).sites, (Sites{{1, 2, 3}, {4, 5, 0}}));
}

TEST(SitesFile, IsViewedAsRadiiOrWeights) {
    const Sites sites = {{1, 2, 3}, {4, 5, 6}};
    const StridedSites radii = strided_view(sites, WeightIs::radius);
    const StridedSites weights = strided_view(sites, WeightIs::weight);
    EXPECT_FALSE(radii.third_is_weight());
    EXPECT_TRUE(weights.third_is_weight());
    ASSERT_EQ(weights.size(), 2U);
    EXPECT_EQ(weights[1], sites[1]);
    EXPECT_EQ(strided_view({}, WeightIs::radius).size(), 0U);
}

}  // namespace
}  // namespace signum
