/// signum simulate from outside: its log, what it refuses, how it ends and goes on.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../thoroughness.hpp"
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
    for (const std::string option : {"--closest", "--save", "--resume"})
        refused({option, ""}, option + ": an empty name; give the name of a file");
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
        const bool has_lists = structure == "lists" || structure == "levels";
        EXPECT_EQ(outlines.find(" 0 0 1 ") != std::string::npos, has_lists);
        EXPECT_EQ(links.find("<path") != std::string::npos, has_lists || structure == "segments");
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

/// The lines of a group's paths in pixels, each path once for each time that it is shown.
std::vector<std::array<double, 4>> lines_of(const std::string& group) {
    std::vector<std::array<double, 4>> lines;
    std::istringstream text(group);
    for (std::string word; std::getline(text, word, 'M');) {
        std::array<double, 4> line{};
        if (std::sscanf(word.c_str(), "%lf %lfL%lf %lf", &line[0], &line[1], &line[2], &line[3]) ==
            4)
            lines.push_back(line);
    }
    return lines;
}
const std::string borders = "fill=\"none\" stroke=\"#777\"";
const std::string new_borders = "fill=\"none\" stroke=\"#d0007f\"";

/// A disc in pixels.
struct Disc {
    double x, y, r;
};
/// Which is the nearest disc, |p - c|^2 - r^2, of all and of their copies.
std::size_t nearest_disc(const std::vector<Disc>& discs, double x, double y, double width,
                         double height) {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < discs.size(); ++i) {
        for (const double shift_x : {-width, 0.0, width}) {
            for (const double shift_y : {-height, 0.0, height}) {
                const double dx = discs[i].x + shift_x - x;
                const double dy = discs[i].y + shift_y - y;
                const double power = dx * dx + dy * dy - discs[i].r * discs[i].r;
                if (power < least) nearest = i;
                least = std::min(least, power);
            }
        }
    }
    return nearest;
}
double distance(const std::array<double, 4>& line, double x, double y) {
    const double dx = line[2] - line[0];
    const double dy = line[3] - line[1];
    const double along = ((x - line[0]) * dx + (y - line[1]) * dy) / (dx * dx + dy * dy);
    const double s = std::clamp(along, 0.0, 1.0);
    return std::hypot(line[0] + s * dx - x, line[1] + s * dy - y);
}

TEST_F(Simulate, BordersLieWhereTheNearestDiscChanges) {
    struct Case {
        std::string name;
        std::string balls;
        double width, height;
        bool walls, periodic;
    };
    std::string random;
    std::string row;
    unsigned state = 1;
    const auto next = [&state] { return (state = state * 1103515245U + 12345U) >> 16 & 1023U; };
    for (int i = 0; i < 48; ++i) {
        random += fmt::format("{} {} {} 1 0 1\n", i % 8 + 0.5 + next() / 4096.0,
                              i / 8 + 0.5 + next() / 4096.0, 0.3 * next() / 1024.0);
        row += fmt::format("{} 3 {} 0 0 1\n", 0.5 * i + 0.25, 0.0625 * (i % 5));
    }
    const std::vector<Case> cases = {
        {"walls", random, 9, 7, true, false},
        {"periodic", random, 9, 7, true, true},
        {"on one line", row, 24, 6, true, false},
        {"on one line, periodic", row, 24, 6, true, true},
        {"a lattice that touches", "1 1 1 0 0 1\n3 1 1 0 0 1\n1 3 1 0 0 1\n3 3 1 0 0 1\n", 4, 4,
         true, false},
        {"one, periodic", "1 2 0.25 0 0 1\n", 4, 4, true, true},
        {"two, periodic", "1 2 0.25 0 0 1\n3.5 0.5 0.4 0 0 1\n", 4, 4, true, true},
        // A copy that is almost half a side away is seen.
        {"below, periodic", "1 1.5 0.25 0 0 1\n1 2 0.25 0 0 1\n", 4, 4, true, true},
        {"above, periodic", "1 2.5 0.25 0 0 1\n1 2 0.25 0 0 1\n", 4, 4, true, true},
        {"left, periodic", "1.5 1 0.25 0 0 1\n2 1 0.25 0 0 1\n", 4, 4, true, true},
        {"right, periodic", "2.5 1 0.25 0 0 1\n2 1 0.25 0 0 1\n", 4, 4, true, true},
        {"one", "1 2 0.25 0 0 1\n", 4, 4, true, false},
        {"points at one place", "1 2 0 0 0 1\n1 2 0 0 0 1\n3 2 1 0 0 1\n", 4, 4, true, false},
        {"no walls", "0 0 0 0 0 1\n4 0 0 0 0 1\n0 4 0 0 0 1\n4 4 0 0 0 1\n1.5 2 1 0 0 1\n", 4, 4,
         false, false}};
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        const std::string movie = scratch.path("movie.svg");
        Words words = {"simulate", scratch.file("balls.txt", each.balls),
                       "--until",  "0",
                       "--show",   "cells",
                       "-o",       movie,
                       "--quiet"};
        if (each.walls)
            for (const std::string& word :
                 {std::string("--box"), std::string("0"), std::string("0"),
                  fmt::format("{}", each.width), fmt::format("{}", each.height)})
                words.push_back(word);
        if (each.periodic) words.emplace_back("--periodic");
        const Outcome result = run(words);
        ASSERT_EQ(result.code, 0) << result.err;
        const std::string svg = contents(movie);
        EXPECT_TRUE(is_well_formed(svg));
        EXPECT_EQ(lines_of(group(svg, new_borders)).size(), 0U);
        const double scale = 640.0 / std::max(each.width, each.height);
        const double wide = scale * each.width;
        const double high = scale * each.height;
        std::vector<Disc> discs;
        std::istringstream text(each.balls);
        for (double x, y, r, vx, vy, mass; text >> x >> y >> r >> vx >> vy >> mass;)
            discs.push_back({scale * x, high - scale * y, scale * r});
        const double beyond = each.periodic ? 1.0 : 1e9;  // where copies are not
        const auto nearest = [&](double x, double y) {
            return nearest_disc(discs, x, y, beyond * wide, beyond * high);
        };
        const auto lines = lines_of(group(svg, borders));
        // Each line has another disc on either side; two discs may have one another's copies there.
        for (const auto& line : lines) {
            const double length = std::hypot(line[2] - line[0], line[3] - line[1]);
            if (length < 2.0 || discs.size() < 3) continue;
            const double x = 0.5 * (line[0] + line[2]);
            const double y = 0.5 * (line[1] + line[3]);
            const double nx = (line[3] - line[1]) / length;
            const double ny = (line[0] - line[2]) / length;
            EXPECT_NE(nearest(x + nx, y + ny), nearest(x - nx, y - ny)) << x << " " << y;
        }
        // Where the nearest disc changes there is a line.
        constexpr double step = 4.0;
        std::size_t changes = 0;
        for (double y = 2.0; y + step < high; y += step) {
            for (double x = 2.0; x + step < wide; x += step) {
                const std::size_t here = nearest(x, y);
                for (const auto& [right, down] : {std::pair{x + step, y}, std::pair{x, y + step}}) {
                    if (nearest(right, down) == here) continue;
                    ++changes;
                    EXPECT_TRUE(std::ranges::any_of(lines,
                                                    [&](const auto& line) {
                                                        return distance(line, 0.5 * (x + right),
                                                                        0.5 * (y + down)) <=
                                                               0.5 * step + 0.2;
                                                    }))
                        << x << " " << y;
                }
            }
        }
        EXPECT_EQ(changes > 0, discs.size() > 1);
        EXPECT_EQ(lines.empty(), each.name == "one");
    }
}

TEST_F(Simulate, NewNeighboursAreMarked) {
    // Two points go apart between two that rest; on one circle they are at t = 0.5.
    const std::string balls =
        scratch.file("four.txt", "-1 0 0 -1 0 1\n1 0 0 1 0 1\n0 1.5 0 0 0 1\n0 -1.5 0 0 0 1\n");
    const auto marks_of = [&](const std::string& every) {
        const std::string movie = scratch.path("movie.svg");
        const Words words = {"simulate", balls,     "--box", "-4",      "-4",  "4",
                             "4",        "--until", "1",     "--every", every, "--show",
                             "cells",    "-o",      movie,   "--quiet"};
        EXPECT_EQ(run(words).code, 0);
        const std::string svg = contents(movie);
        EXPECT_TRUE(is_well_formed(svg));
        EXPECT_EQ(run(words).code, 0);
        EXPECT_EQ(contents(movie), svg);
        EXPECT_LT(svg.find(group(svg, borders)), svg.find(group(svg, new_borders)));
        EXPECT_LT(svg.find(group(svg, new_borders)), svg.find("<circle"));
        return group(svg, new_borders);
    };
    const std::string marks = marks_of("0.125");
    EXPECT_NE(marks.find("values=\"none;inline;none\" keyTimes=\"0;0.5625;0.6875\""),
              std::string::npos);
    const auto lines = lines_of(marks);
    ASSERT_EQ(lines.size(), 1U);
    // At t = 0.625 between those that rest: (x + 1.625)^2 = x^2 + 1.5^2.
    const double half = 80.0 * (1.625 * 1.625 - 2.25) / 3.25;
    EXPECT_NEAR(std::min(lines[0][0], lines[0][2]), 320.0 - half, 0.06);
    EXPECT_NEAR(std::max(lines[0][0], lines[0][2]), 320.0 + half, 0.06);
    EXPECT_EQ(lines[0][1], 320.0);
    EXPECT_EQ(lines[0][3], 320.0);
    // Half a second: of 129 frames in 12 seconds five, and of 257, of which every second one is
    // shown, the same.
    EXPECT_EQ(lines_of(marks_of("0.0078125")).size(), 5U);
    EXPECT_EQ(marks_of("0.00390625"), marks_of("0.0078125"));
}

TEST_F(Simulate, AMovieOfManyBallsSaysWhatItLeavesOut) {
    const std::string movie = scratch.path("movie.svg");
    const Outcome result =
        run({"simulate", gas(70), "--box", "0", "0", "70", "70", "--until", "0.1", "--every",
             "0.05", "--structure", "cells", "--show", "structure", "-o", movie, "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    const std::string text = contents(movie);
    EXPECT_TRUE(is_well_formed(text));
    EXPECT_NE(text.find("the 600 largest of 4900 balls"), std::string::npos);
    EXPECT_NE(text.find("not all are drawn, at most 4000 of a kind"), std::string::npos);

    EXPECT_EQ(run({"simulate", gas(50), "--box", "0", "0", "50", "50", "--periodic", "--until",
                   "0.1", "--every", "0.05", "--show", "cells", "-o", movie, "--quiet"})
                  .code,
              0);
    const std::string cells = contents(movie);
    EXPECT_TRUE(is_well_formed(cells));
    EXPECT_NE(cells.find("600 of them, in the middle at the start"), std::string::npos);
    EXPECT_NE(cells.find("borders of cells (power diagram) of the 600 balls shown"),
              std::string::npos);
    EXPECT_EQ(cells.find("not all are drawn"), std::string::npos);
    // They lie around the middle, and at the start each is in a cell that is closed: from its
    // centre the first border is met within a few pixels, wherever one looks.
    const auto lines = lines_of(group(cells, borders));
    std::vector<std::array<double, 2>> centres;
    for (auto at = cells.find("<circle"); at != cells.npos; at = cells.find("<circle", at + 1)) {
        std::array<double, 2> centre{};
        ASSERT_EQ(std::sscanf(cells.c_str() + cells.find("cx=", at), "cx=\"%lf\" cy=\"%lf\"",
                              &centre[0], &centre[1]),
                  2);
        centres.push_back(centre);
    }
    ASSERT_EQ(centres.size(), 600U);
    for (const auto& [x, y] : centres) {
        EXPECT_LT(std::hypot(x - 320.0, y - 320.0), 640.0 / 50.0 * 15.0);
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            const bool is_closed = std::ranges::any_of(lines, [&](const auto& line) {
                const double from = dx * (line[1] - y) - dy * (line[0] - x);
                const double to = dx * (line[3] - y) - dy * (line[2] - x);
                if (from * to > 0.0 || from == to) return false;
                const double s = from / (from - to);
                const double ahead = dx * (line[0] + s * (line[2] - line[0]) - x) +
                                     dy * (line[1] + s * (line[3] - line[1]) - y);
                return ahead > 0.0 && ahead < 32.0;
            });
            EXPECT_TRUE(is_closed) << x << " " << y << " " << dx << " " << dy;
        }
    }
}

TEST_F(Simulate, APeriodicMovieShowsABallAcrossASideOnBoth) {
    const std::string movie = scratch.path("movie.svg");
    // Across a side from the start on, in a corner, on its way across a side, and far from all.
    const std::string balls = scratch.file(
        "four.txt", "0.5 5 1 0 0 1\n7.5 7.5 1 0 0 1\n3 1.25 1 0 -1 1\n4.25 4.5 1 0 0 1\n");
    const Outcome result = run({"simulate", balls, "--box", "0", "0", "8", "8", "--periodic",
                                "--until", "1", "--every", "0.5", "-o", movie, "--quiet"});
    ASSERT_EQ(result.code, 0) << result.err;
    const std::string svg = contents(movie);
    EXPECT_TRUE(is_well_formed(svg));
    std::vector<std::string> copies;
    for (auto at = svg.find("<use"); at != svg.npos; at = svg.find("<use", at + 1))
        copies.push_back(svg.substr(at, svg.find('>', at) + 1 - at));
    std::ranges::sort(copies);
    const std::vector<std::string> expected = {"<use href=\"#ball0\" x=\"640.0\" y=\"0.0\"/>",
                                               "<use href=\"#ball1\" x=\"-640.0\" y=\"0.0\"/>",
                                               "<use href=\"#ball1\" x=\"-640.0\" y=\"640.0\"/>",
                                               "<use href=\"#ball1\" x=\"0.0\" y=\"640.0\"/>",
                                               "<use href=\"#ball2\" x=\"0.0\" y=\"-640.0\"/>"};
    EXPECT_EQ(copies, expected);
    for (const int ball : {0, 1, 2})
        EXPECT_NE(svg.find(fmt::format("<circle id=\"ball{}\"", ball)), std::string::npos);
    EXPECT_EQ(svg.find("id=\"ball3\""), std::string::npos);
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
          "it is one of structure, cells");
    for (const std::string what : {"structure", "cells"}) {
        fails({"simulate", space, "--until", "1", "--show", what, "-o", movie},
              "in the plane alone");
        fails({"simulate", plane, "--until", "1", "--show", what}, "add -o FILE.svg");
    }
    fails(
        {"simulate", plane, "--until", "1", "--show", "structure", "--show", "cells", "-o", movie},
        "--show is given 2 times");
    // Cells that doubles cannot compute beside the box; the log is there.
    const std::string far = scratch.file("far.txt", "0 0 1 1e45 0\n0 5 1 -1e45 0\n");
    const std::string log = scratch.path("log.csv");
    fails({"simulate", far, "--until", "1e150", "--every", "1e150", "--show", "cells", "-o", movie,
           "-o", log, "--quiet"},
          "too far away for their cells");
    EXPECT_EQ(contents(log), "time,kind,a,b,impulse\n");
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

/// Whose name does not say so: as FILE, as standard input, as a scene's file of balls.
TEST_F(Simulate, ASceneIsKnownByItsText) {
    const std::string text = "# two\n[box]\nlow = [0, 0]\nhigh = [9, 9]\n";
    const std::string scene = scratch.file("scene.txt", text);
    const std::string said = ":1:1: this looks like a scene";
    EXPECT_EQ(run({"simulate", scene}).err, scene + said + "; its name must end in .toml\n");
    EXPECT_EQ(
        run({"simulate", "-"}, {.in = scene}).err,
        "-" + said + ", which is read from a file alone; give one whose name ends in .toml\n");
    const std::string outer =
        scratch.file("outer.toml", text + "[balls]\nfile = \"outer.toml\"\n[run]\nuntil = 1\n");
    const Outcome result = run({"simulate", outer});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, outer + said + "; its name must end in .toml\n");
}

/// Plane and space take different numbers of words.
TEST_F(Simulate, TooFewWordsAreCounted) {
    const std::string one = scratch.file("one.txt", "0 0 1 0 0\n");
    const auto refused = [&](const Words& more, const std::string& reason) {
        Words words = {"simulate", one, "--until", "1"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.err, "signum: " + reason + "\n");
    };
    const std::string help = "; see signum simulate --help";
    refused({"--box", "0", "0", "8"},
            "--box takes 4 or 6 words after it, X0 Y0 [Z0] X1 Y1 [Z1]; 3 are given" + help);
    refused({"--gravity", "0"},
            "--gravity takes 2 or 3 words after it, GX GY [GZ]; one is given" + help);
    refused({"--box", "0", "0", "8", "8", "8"},
            "--box: 5 numbers, but the balls lie in the plane; give 4");
}

TEST_F(Simulate, TheHelpNamesTheStructures) {
    const std::string text = run({"simulate", "--help"}).out;
    EXPECT_NE(text.find("auto,"), std::string::npos);
    EXPECT_NE(text.find("pairs, cells, tree, segments, levels, lists, delaunay"),
              std::string::npos);
    EXPECT_EQ(text.find(" x 4"), std::string::npos);
    EXPECT_EQ(text.find(" x 2"), std::string::npos);
}

/// Where delaunay cannot be used the true reason is said.
TEST_F(Simulate, WhyDelaunayIsNotUsedIsSaid) {
    const auto note_of = [&](const std::string& text) {
        const std::string balls = scratch.file("balls.txt", text);
        return run({"simulate", balls, "--until", "1", "--structure", "delaunay"}).err;
    };
    EXPECT_TRUE(note_of("0 0 0 1 0 1\n4 0 0 0 0 1\n")
                    .starts_with("structure levels: delaunay needs radii above 0"));
    EXPECT_TRUE(note_of("0 0 1 1 0\n9000 0 5000 0 0\n")
                    .starts_with("structure levels: delaunay is for discs whose radii are within"));
    EXPECT_TRUE(note_of("0 0 0 1 1 0 0\n")
                    .starts_with("structure levels: delaunay is a structure of the plane"));
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

/// The run takes a tenth of a second, and the list of its closest pairs many.
TEST_F(Simulate, AListThatIsInterruptedSaysHowFarItGoes) {
    const std::string balls = gas(100);
    const std::string list = scratch.path("closest.csv");
    const std::string log = scratch.path("log.csv");
    const int strikes = is_fast ? 16'000 : 1000;
    const Outcome result = run({"simulate", balls, "--box", "0", "0", "100", "100", "--events",
                                std::to_string(strikes), "-o", log, "--closest", list},
                               {.signal_after_ms = 1500});
    EXPECT_EQ(result.code, -SIGINT);
    EXPECT_NE(result.err.find("the strikes are done"), std::string::npos) << result.err;
    const std::string whole_log = contents(log);
    EXPECT_EQ(std::count(whole_log.begin(), whole_log.end(), '\n'), strikes + 1);
    const std::string text = contents(list);
    const auto lines = std::count(text.begin(), text.end(), '\n') - 1;
    ASSERT_GE(lines, 1);
    const std::string line = fmt::format("closest  {}, {} lines, ", list, lines);
    const std::size_t place = result.err.find(line);
    ASSERT_NE(place, std::string::npos) << result.err;
    double seconds = 0.0;
    double reached = 0.0;
    ASSERT_EQ(std::sscanf(result.err.c_str() + place + line.size(),
                          "%lf seconds, up to time %lf, interrupted", &seconds, &reached),
              2)
        << result.err;
    EXPECT_TRUE(result.err.ends_with(", interrupted\n")) << result.err;
    EXPECT_GT(seconds, 0.0);
    const double last_of_list = std::stod(text.substr(text.rfind('\n', text.size() - 2) + 1));
    const double last_of_log =
        std::stod(whole_log.substr(whole_log.rfind('\n', whole_log.size() - 2) + 1));
    EXPECT_GE(reached, last_of_list * (1.0 - 1e-5));
    EXPECT_LT(reached, last_of_log);
}

TEST_F(Simulate, WhereTheClockEndsARunItsListIsSaidToBeMissing) {
    const std::string balls =
        scratch.file("fast.txt", "-1e17 0 0.5 1e7 0\n0 0 0.5 0 0\n0 9 0.5 1 0\n9 9 0.5 0 0\n");
    const std::string list = scratch.file("closest.csv", "old\n");
    const Outcome result = run({"simulate", balls, "--until", "1e11", "--closest", list});
    EXPECT_EQ(result.code, 2);
    EXPECT_TRUE(result.err.ends_with("; the log up to there is complete; the list " + list +
                                     " is not written\n"))
        << result.err;
    EXPECT_EQ(contents(list), "old\n");
    EXPECT_EQ(result.out, "time,kind,a,b,impulse\n8,ball,2,3,0.25\n");
}

}  // namespace
}  // namespace signum
