#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "../../tool/io/read_balls.hpp"

#include "io_refusal.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using namespace std::string_literals;

BallsFile read(std::string_view contents) {
    const test::Scratch scratch;
    return read_balls(scratch.file("f", contents));
}

/// The balls, x y z vx vy vz r m each.
std::vector<std::array<double, 8>> balls(std::string_view contents) {
    std::vector<std::array<double, 8>> result;
    for (const BallLine& ball : read(contents).balls) {
        const auto& [x, v, radius, mass, position] = ball;
        result.push_back({x[0], x[1], x[2], v[0], v[1], v[2], radius, mass});
    }
    return result;
}
using Balls = std::vector<std::array<double, 8>>;

/// The error message that the contents give, without the path.
std::string error(std::string_view contents) {
    return test::refusal(contents, [](const std::string& path) { return read_balls(path); });
}

/// The note, without the path.
std::string note(std::string_view contents) {
    const test::Scratch scratch;
    const std::string path = scratch.file("f", contents);
    const std::string note = read_balls(path).note;
    if (note.empty()) return "";
    EXPECT_TRUE(note.starts_with(path + ":")) << note;
    return note.substr(std::min(path.size() + 1, note.size()));
}

const std::string word =
    " is not a number; write a decimal or hexadecimal float, such as 1.5, -2e-3 or 0x1.8p-3";
const std::string forms =
    "a ball is x y r vx vy [mass] in the plane and x y z r vx vy vz [mass] in space";
const std::string advice =
    "; write one ball a line: x y r vx vy [mass], in space x y z r vx vy vz [mass]";
const std::string names =
    "; name the columns x, y, r (or radius), vx and vy, in space also z and vz";
const std::string empty = "an empty column; write a number or remove the separator";

TEST(ReadBalls, ReadsThePlane) {
    EXPECT_EQ(read("1 2 3 4 5\n").dimension, 2);
    EXPECT_EQ(balls("1 2 3 4 5\n"), (Balls{{1, 2, 0, 4, 5, 0, 3, 9}}));
    EXPECT_EQ(balls("1 2 3 4 5 6"), (Balls{{1, 2, 0, 4, 5, 0, 3, 6}}));
    EXPECT_EQ(balls("-1 -.5 0x1p-3 -4 1e-3 .5\n"), (Balls{{-1, -0.5, 0, -4, 1e-3, 0, 0.125, 0.5}}));
    EXPECT_EQ(balls("1 2 0 4 5 6\n"), (Balls{{1, 2, 0, 4, 5, 0, 0, 6}}));
}

TEST(ReadBalls, ReadsSpace) {
    EXPECT_EQ(read("1 2 3 4 5 6 7\n").dimension, 3);
    EXPECT_EQ(balls("1 2 3 4 5 6 7\n"), (Balls{{1, 2, 3, 5, 6, 7, 4, 64}}));
    EXPECT_EQ(balls("1 2 3 4 5 6 7 8\n"), (Balls{{1, 2, 3, 5, 6, 7, 4, 8}}));
}

TEST(ReadBalls, ReadsAMassOrNoneInEveryLineForItself) {
    EXPECT_EQ(
        balls("1 2 3 4 5\n1 2 3 4 5 6\n6 5 4 3 2\n"),
        (Balls{{1, 2, 0, 4, 5, 0, 3, 9}, {1, 2, 0, 4, 5, 0, 3, 6}, {6, 5, 0, 3, 2, 0, 4, 16}}));
    EXPECT_EQ(balls("1 2 3 4 5 6 7 8\n1 2 3 4 5 6 7\n"),
              (Balls{{1, 2, 3, 5, 6, 7, 4, 8}, {1, 2, 3, 5, 6, 7, 4, 64}}));
}

TEST(ReadBalls, ReadsEverySeparatorAndSkipsComments) {
    const Balls two = {{1, 2, 0, 4, 5, 0, 3, 9}, {1, 2, 0, 4, 5, 0, 3, 6}};
    EXPECT_EQ(balls("1,2,3,4,5\n1;2;3;4;5;6\n"), two);
    EXPECT_EQ(balls("1\t2\t3\t4\t5\n1 , 2,3\t,4,5,6\r\n"), two);
    EXPECT_EQ(balls("\xEF\xBB\xBF# two\n\n 1  2 3 4 5# here\n \t\r\n1 2 3 4 5 6 # 7 8\n#"), two);
    EXPECT_EQ(balls("\"1\",\"2\",\"3\",\"4\",\"5\"\n1 2 3 4 5 6"), two);
}

TEST(ReadBalls, SaysWhereItsLinesBegin) {
    const BallsFile file = read("# two\n  1 2 3 4 5\n\n1 2 3 4 5\n");
    ASSERT_EQ(file.balls.size(), 2U);
    EXPECT_EQ(file.balls[0].position.line, 2);
    EXPECT_EQ(file.balls[0].position.column, 1);
    EXPECT_EQ(file.balls[1].position.line, 4);
}

TEST(ReadBalls, PicksNamedColumns) {
    const Balls plane = {{1, 2, 0, 4, 5, 0, 3, 9}};
    const Balls space = {{1, 2, 3, 5, 6, 7, 4, 8}};
    EXPECT_EQ(balls("x y r vx vy\n1 2 3 4 5\n"), plane);
    EXPECT_EQ(balls("VY;Vx;Radius;Y;X\n5;4;3;2;1\n"), plane);
    EXPECT_EQ(balls("\"x\",\"y\",\"r\",\"vx\",\"vy\",\"m\"\n1,2,3,4,5,9\n"), plane);
    EXPECT_EQ(balls("x y r vx vy mass\n1,2,3,4,5,9\n"), plane);
    EXPECT_EQ(balls("x,y,z,r,vx,vy,vz,m\n1,2,3,4,5,6,7,8\n"), space);
    EXPECT_EQ(balls("MASS\tvz\tvy\tvx\tradius\tz\ty\tx\n8\t7\t6\t5\t4\t3\t2\t1\n"), space);
    EXPECT_EQ(balls("x y z r vx vy vz\n1 2 3 2 5 6 7\n"), (Balls{{1, 2, 3, 5, 6, 7, 2, 8}}));
    EXPECT_EQ(read("x y r vx vy\n1 2 3 4 5\n").dimension, 2);
    EXPECT_EQ(read("x y z r vx vy vz\n1 2 3 4 5 6 7\n").dimension, 3);
    EXPECT_EQ(note("x y r vx vy\n1 2 3 4 5\n"), "");
    EXPECT_EQ(note("1 2 3 4 5\n"), "");
}

TEST(ReadBalls, LeavesOtherColumnsOutWithAWord) {
    const char* named =
        "# made by hand\nid,x,y,r,vx,vy,\"name, or none\"\n7,1,2,3,4,5,\"a, b\"\n,1,2,"
        "3,4,5,\n";
    const Balls two = {{1, 2, 0, 4, 5, 0, 3, 9}, {1, 2, 0, 4, 5, 0, 3, 9}};
    EXPECT_EQ(balls(named), two);
    const std::string all =
        " left out: a ball has x, y, r (or radius), vx and vy, in space also z and vz, and m (or "
        "mass)";
    EXPECT_EQ(note(named), "2: 'id' and 'name, or none' are" + all);
    EXPECT_EQ(note("x y r vx vy Colour\n1 2 3 4 5 red\n"), "1: 'Colour' is" + all);
    EXPECT_EQ(note("x,y,r,vx,vy,a,,c\n1,2,3,4,5,,,c d\n"), "1: 'a', '' and 'c' are" + all);
    EXPECT_EQ(
        note("a b c d e f g h i j k l x y r vx vy n o\n1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9\n"),
        "1: 'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h', 'i', 'j', 'k', 'l' and 2 more are" + all);
    // What is left out may be no number, and the separator of the header alone separates then.
    EXPECT_EQ(error("id,x,y,r,vx,vy\n1;2;3;4;5;6\n"),
              "2:12: one column, but the header names 6; "
              "write as many");
}

TEST(ReadBalls, RefusesHeadersThatLackAName) {
    EXPECT_EQ(error("x y r vx\n1 2 3 4\n"), "1:1: the header does not name vy" + names);
    EXPECT_EQ(error("y r vx vy\n1 2 3 4\n"), "1:1: the header does not name x" + names);
    EXPECT_EQ(error("x r vx vy\n1 2 3 4\n"), "1:1: the header does not name y" + names);
    EXPECT_EQ(error("x y m vx vy\n1 2 3 4 5\n"), "1:1: the header does not name r" + names);
    EXPECT_EQ(error("# c\n x,y,r\n1,2,3\n"), "2:2: the header does not name vx and vy" + names);
    EXPECT_EQ(error("a b c d e\n1 2 3 4 5\n"),
              "1:1: the header does not name x, y, r, vx and vy" + names);
    EXPECT_EQ(error("x y z r vx vy\n1 2 3 4 5 6\n"), "1:1: the header does not name vz" + names);
    EXPECT_EQ(error("x y r vx vy vz\n1 2 3 4 5 6\n"), "1:1: the header does not name z" + names);
    EXPECT_EQ(error("z\n1\n"), "1:1: the header does not name x, y, r, vx, vy and vz" + names);
}

TEST(ReadBalls, RefusesNamesThatComeTwice) {
    EXPECT_EQ(error("x y r vx vy X\n1 2 3 4 5 6\n"), "1:13: a second column x; name one");
    EXPECT_EQ(error("x y r vx vx vy\n1 2 3 4 5 6\n"), "1:10: a second column vx; name one");
    EXPECT_EQ(error("x,y,r,radius,vx,vy\n1,2,3,4,5,6\n"),
              "1:7: a second column of radii; name one column r or radius");
    EXPECT_EQ(error("mass,m,x,y,r,vx,vy\n1,2,3,4,5,6,7\n"),
              "1:6: a second column of masses; name one column m or mass");
    EXPECT_EQ(balls("x y r vx vy id id\n1 2 3 4 5 6 6\n"), (Balls{{1, 2, 0, 4, 5, 0, 3, 9}}));
}

TEST(ReadBalls, RefusesWrongNumbersOfColumns) {
    const std::string header = ", or name the columns in a first line";
    EXPECT_EQ(error("1\n"), "1:2: one column; " + forms + header);
    EXPECT_EQ(error("1 2 3 4 # 5\n"), "1:8: 4 columns; " + forms + header);
    EXPECT_EQ(error("1 2 3 4 5 6 7 8 9\n"), "1:17: 9 columns; " + forms + header);
    EXPECT_EQ(error("1,5,2,5,3,5,4,5,0,0\n"),
              "1:17: 10 columns; " + forms + ", a fraction has a point" + header);
    EXPECT_EQ(error("1 2 3 4 5 6 7 8 9 # 1,5\n"), "1:17: 9 columns; " + forms + header);
    EXPECT_EQ(error("1,5 2 3 4 5\n"),
              "1:5: commas and blanks in one line; separate by one of them, and write fractions "
              "with a point");
}

TEST(ReadBalls, RefusesThePlaneBesideSpace) {
    const std::string plane =
        ", but the first ball lies in the plane; write x y r vx vy [mass] in every line";
    const std::string space =
        ", but the first ball lies in space; write x y z r vx vy vz [mass] in every line";
    EXPECT_EQ(error("1 2 3 4 5\n1 2 3 4 5 6 7\n"), "2:13: 7 columns" + plane);
    EXPECT_EQ(error("1 2 3 4 5\n1 2 3 4 5 6 7 8\n"), "2:13: 8 columns" + plane);
    EXPECT_EQ(error("1 2 3 4 5 6\n\n1 2 3 4\n"), "3:8: 4 columns" + plane);
    EXPECT_EQ(error("1 2 3 4 5 6 7\n1 2 3 4 5 6\n"), "2:12: 6 columns" + space);
    EXPECT_EQ(error("1 2 3 4 5 6 7\n1 2 3 4 5\n"), "2:10: 5 columns" + space);
    EXPECT_EQ(error("1 2 3 4 5 6 7\n1 2 3 4 5 6 7 8 9\n"), "2:17: 9 columns" + space);
}

TEST(ReadBalls, RefusesLinesUnlikeTheirHeader) {
    EXPECT_EQ(error("x y r vx vy m\n1 2 3 4 5 6\n1 2 3 4 5\n"),
              "3:10: 5 columns, but the header names 6; write as many");
    EXPECT_EQ(error("x y r vx vy\n1 2 3 4 5 6\n"),
              "2:11: 6 columns, but the header names 5; write as many");
    EXPECT_EQ(error("x,y,r,vx,vy,m\n1,2,3,4,5,\n"), "2:11: " + empty);
}

TEST(ReadBalls, RefusesEmptyColumns) {
    EXPECT_EQ(error("1,,3,4,5\n"), "1:3: " + empty);
    EXPECT_EQ(error(",2,3,4,5\n"), "1:1: " + empty);
    EXPECT_EQ(error("1,2,3,4,5,\n"), "1:11: " + empty);
    EXPECT_EQ(error("1,2,3,4,5\n1,2,3,4,5,6,\n"), "2:13: " + empty);
    EXPECT_EQ(error("1,2,3,4,5,6,7,8,\n"), "1:17: " + empty);
}

TEST(ReadBalls, RefusesWhatIsNoFiniteNumber) {
    EXPECT_EQ(error("1 2 3 4 five\n"), "1:9: 'five'" + word);
    EXPECT_EQ(error("1 2 3 4 5\n1 2x 3 4 y\n"), "2:3: '2x'" + word);
    EXPECT_EQ(error("vy,vx,r,y,x\n5,4,3,\"two\",1\n"), "2:8: 'two'" + word);
    EXPECT_EQ(error("1 2 3 4 nan\n"), "1:9: 'nan' is not a finite number; write a finite one");
    EXPECT_EQ(error("1 2 inf 4 5\n"), "1:5: 'inf' is not a finite number; write a finite one");
    EXPECT_EQ(error("1 2 3 4 5 -inf\n"), "1:11: '-inf' is not a finite number; write a finite one");
    EXPECT_EQ(error("1e999 2 3 4 5\n"),
              "1:1: '1e999' is beyond the range of a double; the largest is about 1.797e308");
    EXPECT_EQ(
        error("1;2,5;3;4;5\n"),
        "1:4: commas and semicolons in one line; separate by one of them, and write fractions "
        "with a point");
    EXPECT_EQ(error("n;x;y;r;vx;vy\n1;2,5;3;4;5;6\n"),
              "2:3: '2,5' has a decimal comma; write a point in its place");
}

TEST(ReadBalls, RefusesNegativeRadii) {
    EXPECT_EQ(error("1 2 3 4 5\n1 2 -3 4 5\n"), "2:5: '-3' is a negative radius; write 0 or more");
    EXPECT_EQ(error("1 2 3 -1e-300 5 6 7 8\n"),
              "1:7: '-1e-300' is a negative radius; write 0 or more");
    EXPECT_EQ(error("r x y vx vy\n-3 2 1 4 5\n"),
              "2:1: '-3' is a negative radius; write 0 or more");
    EXPECT_EQ(balls("1 2 -0 4 5 6\n"), (Balls{{1, 2, 0, 4, 5, 0, 0, 6}}));
}

TEST(ReadBalls, RefusesMassesThatAreNotPositive) {
    const std::string positive = " is a mass that is not positive; write one above 0";
    EXPECT_EQ(error("1 2 3 4 5 0\n"), "1:11: '0'" + positive);
    EXPECT_EQ(error("1 2 3 4 5 -0.0\n"), "1:11: '-0.0'" + positive);
    EXPECT_EQ(error("1 2 3 4 5 6 7 -8\n"), "1:15: '-8'" + positive);
    EXPECT_EQ(error("1 2 3 4 5 1e-999\n"), "1:11: '1e-999'" + positive);
    EXPECT_EQ(error("m x y r vx vy\n1 1 1 1 1 1\n0 1 1 1 1 1\n"), "3:1: '0'" + positive);
}

TEST(ReadBalls, RefusesRadiiThatTellNoMass) {
    const std::string last = "; write it in one more column, the last";
    const std::string header = "; write it in a column that the header calls m or mass";
    EXPECT_EQ(error("1 2 3 4 5\n1 2 0 4 5\n"), "2:5: a ball of radius 0 needs a mass" + last);
    EXPECT_EQ(error("1 2 3 -0.0 5 6 7\n"), "1:7: a ball of radius 0 needs a mass" + last);
    EXPECT_EQ(error("x y vx vy radius\n1 2 3 4 0\n"),
              "2:9: a ball of radius 0 needs a mass" + header);
    const auto beyond = [](std::string_view radius, int power) {
        return fmt::format(
            "a ball of radius '{}' needs a mass, since r^{} is beyond the range of a "
            "double",
            radius, power);
    };
    EXPECT_EQ(error("1 2 1e155 4 5\n"), "1:5: " + beyond("1e155", 2) + last);
    EXPECT_EQ(error("1 2 1e-155 4 5\n"), "1:5: " + beyond("1e-155", 2) + last);
    EXPECT_EQ(error("1 2 3 1e103 5 6 7\n"), "1:7: " + beyond("1e103", 3) + last);
    EXPECT_EQ(error("1 2 3 1e-103 5 6 7\n"), "1:7: " + beyond("1e-103", 3) + last);
    EXPECT_EQ(error("x y z r vx vy vz\n1 2 3 5e-324 5 6 7\n"),
              "2:7: " + beyond("5e-324", 3) + header);
    EXPECT_EQ(balls("1 2 3 1e103 5 6 7 8\n"), (Balls{{1, 2, 3, 5, 6, 7, 1e103, 8}}));
}

/// Whether the double is the nearest to the number, of two the even one.
bool is_nearest(double value, const mpq_class& exact) {
    const bool even = std::bit_cast<std::uint64_t>(value) % 2 == 0;
    for (const double bound : {0.0, std::numeric_limits<double>::infinity()}) {
        const mpq_class middle = (mpq_class(value) + mpq_class(std::nextafter(value, bound))) / 2;
        const int side = cmp(exact, middle);
        if (side == 0 ? !even : (side < 0) == (bound == 0.0)) return false;
    }
    return true;
}

TEST(ReadBalls, TakesForAMissingMassTheNearestPowerOfTheRadius) {
    EXPECT_EQ(balls("0 0 0.1 0 0").front().back(), 0.1 * 0.1);
    std::mt19937_64 random(1);
    std::string plane;
    std::string space;
    // Cubes of 17 to 19 bits often lie in the middle between two doubles.
    for (int i = 0; i < 20'000; ++i) {
        const int bits = i % 2 == 0 ? 53 : 17 + i / 2 % 3;
        const std::uint64_t mantissa = (random() >> (64 - bits)) | 1U << 16;
        const int exponent = static_cast<int>(random() % 600) - 350;
        const std::string radius =
            fmt::format("{:a}", std::ldexp(static_cast<double>(mantissa), exponent));
        plane += "0 0 " + radius + " 0 0\n";
        space += "0 0 0 " + radius + " 0 0 0\n";
    }
    int exact_cubes = 0;
    for (const std::string& text : {plane, space}) {
        const BallsFile file = read(text);
        ASSERT_EQ(file.balls.size(), 20'000U);
        for (const BallLine& ball : file.balls) {
            const mpq_class radius(ball.radius);
            mpq_class power = radius * radius;
            if (file.dimension == 3) power *= radius;
            ASSERT_TRUE(is_nearest(ball.mass, power)) << fmt::format("{:a}", ball.radius);
            exact_cubes += static_cast<int>(file.dimension == 3 && power == ball.mass);
        }
    }
    EXPECT_GT(exact_cubes, 0);
}

TEST(ReadBalls, RefusesFilesWithoutBalls) {
    EXPECT_EQ(error(""), "1:1: no ball in this file" + advice);
    EXPECT_EQ(error("# nothing\n\n"), "2:1: no ball in this file" + advice);
    EXPECT_EQ(error("x y r vx vy\n"), "1:1: a header and no ball" + advice);
    EXPECT_EQ(error("x y r vx vy\n\n# none\n"), "3:1: a header and no ball" + advice);
}

TEST(ReadBalls, RefusesJson) {
    const std::string json =
        "1:1: this looks like JSON, and balls are read from text alone, states by --resume";
    EXPECT_EQ(error("[[1, 2, 3, 4, 5]]"), json + advice);
    EXPECT_EQ(error("\n  {\"x\": 1}\n"), json + advice);
}

TEST(ReadBalls, KnowsFrames) {
    EXPECT_EQ(error("1\nProperties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1\nA 1 2 3 4 5 6 7 "
                    "0\n"),
              "1:1: these look like frames in XYZ, which a scene reads; give a scene of which "
              "[balls] has file, this one");
}

/// Whose first line is a table or a key.
TEST(ReadBalls, KnowsScenes) {
    const std::string scene = "1:1: this looks like a scene; its name must end in .toml";
    for (const std::string text :
         {"[box]\nlow = [0, 0]\n", "\n# gas\n  [[balls]]\r\n", "title = \"x\"\n", "run.until=3\n"})
        EXPECT_EQ(error(text), scene) << text;
    EXPECT_EQ(error("x = 3 4 5 6\n1 2 3 4 5\n"), scene);
    for (const std::string text : {"x y r vx = vy\n", "[1, 2]\n", "= 3\n", "title\n", "[]\n"})
        EXPECT_EQ(error(text).find("scene"), std::string::npos) << text;
}

TEST(ReadBalls, RefusesWhatIsNoText) {
    EXPECT_EQ(error("1 2 3 4 5\n1 \0"s),
              "2:3: a NUL byte, so this is a binary file; give a file of balls as text");
    EXPECT_EQ(error("ab\x1F\x8B q\n1 2\n"),
              "1:3: a control character, so this is no text" + advice);
    EXPECT_EQ(error(std::string(1'000'000, 'a')),
              "1:65537: a line of more than 65536 bytes" + advice);
    EXPECT_EQ(error("1 2 3 4 5\r1 2 3 4 5\r"),
              "1:10: a line that ends in CR alone; save the file with LF at the ends of lines");
    const test::Scratch scratch;
    const std::string missing = scratch.path("missing");
    try {
        static_cast<void>(read_balls(missing));
        ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), missing +
                                    ": cannot open it (No such file or directory); give a "
                                    "file of balls, or - for standard input");
    }
}

TEST(ReadBalls, ReadsAcrossBlocks) {
    std::string text;
    for (int i = 0; i < 50'000; ++i) text += std::to_string(i) + " 2 3 4 5\n";
    const BallsFile file = read(text);
    ASSERT_EQ(file.balls.size(), 50'000U);
    EXPECT_EQ(file.balls.back().x[0], 49'999.0);
    EXPECT_EQ(file.balls.back().position.line, 50'000);
    EXPECT_EQ(error(text + "1 2 3 4 z"), "50001:9: 'z'" + word);
}

}  // namespace
}  // namespace signum
