/// signum simulate from outside: its log, what it refuses, how it ends and goes on.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::Outcome;
using test::run;
using test::Scratch;
using test::Words;

class Simulate : public testing::Test {
 protected:
    /// Discs on a grid, with velocities of all kinds.
    std::string gas(int side) {
        std::ostringstream text;
        text << "x y r vx vy\n";
        for (int i = 0; i < side; ++i)
            for (int j = 0; j < side; ++j)
                text << i + 0.5 << ' ' << j + 0.5 << " 0.3 " << (i * 7 + j * 3) % 5 - 2.25 << ' '
                     << (i * 5 + j * 11) % 7 - 3.125 << '\n';
        return scratch.file("gas.txt", text.str());
    }

    Scratch scratch;
};

TEST_F(Simulate, TwoDiscsStrikeAndTheWallsToo) {
    const std::string two = scratch.file("two.txt", "0 0 1 1 0\n4 0 1 0 0\n");
    const Outcome result =
        run({"simulate", two, "--box", "-1", "-1", "6", "1", "--until", "6", "--quiet"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.out,
              "time,kind,a,b,impulse\n"
              "2,ball,0,1,1\n"
              "3,wall,1,1,2\n"
              "4,ball,0,1,1\n"
              "6,wall,0,0,2\n");
}

TEST_F(Simulate, SpheresAndAHeader) {
    const std::string two =
        scratch.file("two.csv", "mass,vx,vy,vz,x,y,z,radius\n1,0,0,1,0,0,0,1\n3,0,0,0,0,0,4,1\n");
    const Outcome result = run({"simulate", two, "--until", "10", "--quiet"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "time,kind,a,b,impulse\n2,ball,0,1,1.5\n");
}

TEST_F(Simulate, EveryStructureWritesTheSameBytes) {
    const std::string balls = gas(8);
    std::string expected;
    for (const std::string structure :
         {"auto", "pairs", "cells", "tree", "segments", "levels", "lists"}) {
        const Outcome result = run({"simulate", balls, "--box", "0", "0", "8", "8", "--events",
                                    "2000", "--structure", structure, "--quiet"});
        EXPECT_EQ(result.code, 0) << result.err;
        if (expected.empty()) expected = result.out;
        EXPECT_EQ(result.out, expected) << structure;
    }
    EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), 2001);
}

TEST_F(Simulate, AStateGoesOnWithTheLogItWouldHaveHad) {
    const std::string balls = gas(6);
    const std::string state = scratch.path("state.json");
    const Words box = {"--box",
                       "0",
                       "0",
                       "6",
                       "6",
                       "--gravity",
                       "0",
                       "-1",
                       "--restitution",
                       "0.95",
                       "--wall-restitution",
                       "1",
                       "--quiet"};
    const auto with = [&](Words words) {
        words.insert(words.end(), box.begin(), box.end());
        return words;
    };
    const Outcome whole = run(with({"simulate", balls, "--events", "900"}));
    const Outcome first = run(with({"simulate", balls, "--events", "333", "--save", state}));
    const Outcome rest = run({"simulate", "--resume", state, "--events", "567", "--quiet"});
    EXPECT_EQ(whole.code, 0);
    EXPECT_EQ(rest.code, 0) << rest.err;
    EXPECT_EQ(first.out + rest.out.substr(rest.out.find('\n') + 1), whole.out);
    EXPECT_EQ(run({"simulate", "--resume", balls, "--events", "1"}).code, 2);
    EXPECT_EQ(run({"simulate", "--resume", state, "--events", "1", "--periodic"}).code, 2);
}

TEST_F(Simulate, ClosestPairsAreListed) {
    const std::string balls = scratch.file("three.txt", "0 0 1 1 0\n9 0 1 -1 0\n0 5 1 0 0\n");
    const std::string list = scratch.path("closest.csv");
    const std::string log = scratch.path("log.csv");
    const Outcome result =
        run({"simulate", balls, "--until", "5", "--closest", list, "-o", log, "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    // The gaps are 7 - 2t and √(t² + 25) - 2, equal where 3t² - 36t + 56 = 0; the strike at 3.5
    // sends the two back.
    EXPECT_EQ(contents(list),
              "time,a,b,gap\n"
              "0,0,2,3\n"
              "1.8366680010677345,0,1,3.326663997864531\n");
    EXPECT_EQ(contents(log), "time,kind,a,b,impulse\n3.5,ball,0,1,2\n");
    // Until the last strike, where no time is given; from a state as well.
    const std::string state = scratch.path("state.json");
    EXPECT_EQ(
        run({"simulate", balls, "--events", "1", "--closest", list, "--save", state, "--quiet"})
            .code,
        0);
    EXPECT_EQ(
        run({"simulate", "--resume", state, "--until", "9", "--closest", list, "--quiet"}).code, 0);
    EXPECT_EQ(contents(list).substr(0, 21), "time,a,b,gap\n3.5,0,1,");
}

TEST_F(Simulate, WhereClosestPairsCannotGoIsSaid) {
    const std::string balls = scratch.file("two.txt", "0 0 1 1 0\n5 0 1 0 0\n");
    const std::string other = scratch.path("other.csv");
    const auto refused = [&](const Words& more, const std::string& reason) {
        Words words = {"simulate", balls, "--until", "1"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    };
    refused({"--closest", "-"}, "goes to a file");
    refused({"--closest", balls}, "would overwrite the input");
    refused({"--closest", other, "-o", other}, "is where -o goes");
    refused({"--closest", other, "--save", other}, "is where --save goes");
    refused({"--save", "-"}, "a state goes to a file");
}

TEST_F(Simulate, FramesAndAMovie) {
    const std::string balls = gas(3);
    const std::string frames = scratch.path("frames.xyz");
    const std::string movie = scratch.path("movie.svg");
    const std::string log = scratch.path("log.csv");
    const Outcome result = run({"simulate", balls, "--box", "0", "0", "3", "3", "--until", "2",
                                "--every", "0.5", "-o", frames, "-o", movie, "-o", log, "--stats"});
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string text = contents(frames);
    std::size_t count = 0;
    for (std::size_t at = text.find("Lattice="); at != std::string::npos;
         at = text.find("Lattice=", at + 1))
        ++count;
    EXPECT_EQ(count, 5U);
    EXPECT_EQ(text.substr(0, 2), "9\n");
    EXPECT_NE(contents(movie).find("<animate"), std::string::npos);
    const auto statistics = nlohmann::json::parse(result.out);
    EXPECT_EQ(statistics.at("balls"), 9);
    EXPECT_NEAR(statistics.at("energy_end").get<double>(),
                statistics.at("energy_start").get<double>(), 1e-12);
    EXPECT_EQ(statistics.at("structure"), "pairs");
    EXPECT_GT(statistics.at("pressure").get<double>(), 1.0);
    const std::string lines = contents(log);
    EXPECT_EQ(statistics.at("strikes").get<std::int64_t>() + 1,
              std::count(lines.begin(), lines.end(), '\n'));
}

/// Tags are closed in their order, and no number is infinite or none.
bool is_well_formed(const std::string& svg) {
    std::vector<std::string> open;
    for (auto at = svg.find('<'); at != svg.npos; at = svg.find('<', at + 1)) {
        const auto end = svg.find('>', at);
        if (end == svg.npos) return false;
        const std::string tag = svg.substr(at + 1, end - at - 1);
        if (tag.find('<') != tag.npos || std::ranges::count(tag, '"') % 2 != 0) return false;
        if (tag.back() == '/') continue;
        if (tag.front() != '/') {
            open.push_back(tag.substr(0, tag.find(' ')));
        } else {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
        }
    }
    return open.empty() && svg.find("nan") == svg.npos && svg.find("inf") == svg.npos;
}
/// What lies between a group's tag that has a word in it and its end.
std::string group(const std::string& svg, const std::string& word) {
    const auto at = svg.find("<g " + word);
    return at == svg.npos ? "" : svg.substr(at, svg.find("</g>", at) - at);
}

TEST_F(Simulate, AMovieShowsTheStructure) {
    const std::string balls = gas(6);
    const auto movie_of = [&](const std::string& structure, Words more = {}) {
        const std::string movie = scratch.path("movie.svg");
        Words words = {"simulate", balls,     "--box",   "0",      "0",           "6",
                       "6",        "--until", "1",       "--show", "structure",   "-o",
                       movie,      "--quiet", "--every", "0.1",    "--structure", structure};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 0) << result.err;
        return contents(movie);
    };
    for (const std::string structure : {"pairs", "cells", "tree", "segments", "levels", "lists"}) {
        SCOPED_TRACE(structure);
        const std::string movie = movie_of(structure);
        EXPECT_TRUE(is_well_formed(movie));
        EXPECT_NE(movie.find("; structure " + structure), std::string::npos);
        EXPECT_EQ(movie_of(structure), movie);
        const std::string outlines = group(movie, "fill=\"#0072b2\"");
        const std::string links = group(movie, "fill=\"none\" stroke=\"#666\"");
        const std::string expected = group(movie, "fill=\"none\" stroke=\"#d0007f\"");
        EXPECT_EQ(outlines.find("<path") == std::string::npos, structure == "pairs");
        EXPECT_EQ(outlines.find(" 0 0 1 ") != std::string::npos, structure == "lists");
        EXPECT_EQ(links.find("<path") != std::string::npos,
                  structure == "lists" || structure == "segments");
        EXPECT_NE(expected.find("<path"), std::string::npos);
        // Shapes come and go, and lie under the balls.
        EXPECT_NE(expected.find("none;inline;none"), std::string::npos);
        EXPECT_LT(movie.find(expected), movie.find("<circle"));
    }
    // In a periodic box no line crosses the page.
    const std::string periodic = movie_of("lists", {"--periodic"});
    EXPECT_TRUE(is_well_formed(periodic));
    std::istringstream links(group(periodic, "fill=\"none\" stroke=\"#666\""));
    std::size_t lines = 0;
    for (std::string text; std::getline(links, text, 'M');) {
        double x = 0.0;
        double y = 0.0;
        double right = 0.0;
        double down = 0.0;
        if (std::sscanf(text.c_str(), "%lf %lfl%lf %lf", &x, &y, &right, &down) != 4) continue;
        ++lines;
        EXPECT_LE(std::fabs(right), 321.0);
        EXPECT_LE(std::fabs(down), 321.0);
    }
    EXPECT_GT(lines, 100U);
}

TEST_F(Simulate, AMovieOfManyBallsSaysWhatItLeavesOut) {
    const std::string movie = scratch.path("movie.svg");
    const Outcome result =
        run({"simulate", gas(50), "--box", "0", "0", "50", "50", "--until", "0.1", "--every",
             "0.05", "--structure", "cells", "--show", "structure", "-o", movie, "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string text = contents(movie);
    EXPECT_TRUE(is_well_formed(text));
    EXPECT_NE(text.find("the 600 largest of 2500 balls"), std::string::npos);
    EXPECT_NE(text.find("of a kind the first 2000 alone"), std::string::npos);
}

TEST_F(Simulate, WhatCannotBeShownIsSaid) {
    const std::string plane = gas(3);
    const std::string space = scratch.file("space.txt", "0 0 0 1 1 0 0\n");
    const std::string movie = scratch.path("movie.svg");
    const auto fails = [](const Words& words, const std::string& what) {
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
    };
    fails({"simulate", plane, "--until", "1", "--show", "structure"}, "add -o FILE.svg");
    fails({"simulate", plane, "--until", "1", "--show", "structure", "-o", scratch.path("a.xyz")},
          "add -o FILE.svg");
    fails({"simulate", plane, "--until", "1", "--show", "balls", "-o", movie},
          "it is one of structure");
    fails({"simulate", space, "--until", "1", "--show", "structure", "-o", movie},
          "in the plane alone");
}

TEST_F(Simulate, WhatCannotBeIsNamedByItsLine) {
    const auto fails = [&](const std::string& text, const std::string& place, Words more = {}) {
        const std::string balls = scratch.file("bad.txt", text);
        Words words = {"simulate", balls, "--until", "1"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 2) << text;
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err.substr(0, balls.size() + place.size()), balls + place) << result.err;
    };
    fails("0 0 1 0 0\n1 0 1 0 0\n", ":2:1: a ball that overlaps ball 0");
    fails("0 0 1 0 0\n9 0 -1 0 0\n", ":2:5:");
    fails("0 0 1 0 0 0\n", ":1:11:");
    fails("0 0 1 nan 0\n", ":1:7:");
    fails("0 0 1 0 0\n", ":1:1: a ball outside its walls", {"--box", "0", "0", "5", "5"});
    const std::string one = scratch.file("one.txt", "0 0 1 0 0\n");
    EXPECT_EQ(run({"simulate", one}).code, 2);
    EXPECT_EQ(run({"simulate", one, "--until", "1", "--box", "0", "0", "0", "1", "1", "1"}).code,
              2);
    EXPECT_EQ(run({"simulate", one, "--until", "1", "--restitution", "1.5"}).code, 2);
    EXPECT_EQ(run({"simulate", one, "--until", "1", "--periodic"}).code, 2);
    EXPECT_EQ(run({"simulate", one, "--events", "1", "-o", scratch.path("a.xyz")}).code, 2);
}

TEST_F(Simulate, ACollapseEndsWithACompleteLog) {
    const std::string balls = scratch.file("bounce.txt", "0 2 1 0 0\n");
    const std::string log = scratch.path("log.csv");
    const Outcome result = run({"simulate", balls, "--box", "-5", "0", "5", "9", "--gravity", "0",
                                "-2", "--restitution", "0.5", "--until", "10", "-o", log});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("at time 3"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("ball 0 and wall 2"), std::string::npos) << result.err;
    EXPECT_EQ(contents(log).substr(0, 37), "time,kind,a,b,impulse\n1,wall,0,2,3\n2,");
}

TEST_F(Simulate, AnInterruptLeavesACompleteLog) {
    const std::string balls = gas(10);
    const std::string log = scratch.path("log.csv");
    const Outcome result = run(
        {"simulate", balls, "--box", "0", "0", "10", "10", "--until", "1e9", "-o", log, "--quiet"},
        {.signal_after_ms = 400});
    EXPECT_EQ(result.code, -SIGINT);
    const std::string text = contents(log);
    ASSERT_GT(text.size(), 1000U);
    EXPECT_EQ(text.back(), '\n');
    const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
    EXPECT_EQ(std::count(last.begin(), last.end(), ','), 4);
}

}  // namespace
}  // namespace signum
