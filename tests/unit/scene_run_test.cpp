/// Scenes at work: a run that is saved and resumed writes the log of the whole one, whatever the
/// effect; dense starts are as dense as asked for; results go where the scene and -o say.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/io/motion_state.hpp"
#include "../../tool/io/program.hpp"
#include "../../tool/scenes/overlaps.hpp"
#include "../../tool/scenes/read_scene.hpp"
#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::Outcome;
using test::run;
using test::Scratch;
using test::Words;

/// Shows the first line that differs, not all of them.
void expect_same_lines(const std::string& a, const std::string& b) {
    std::istringstream left(a);
    std::istringstream right(b);
    std::string left_line;
    std::string right_line;
    while (std::getline(left, left_line) && std::getline(right, right_line))
        ASSERT_EQ(left_line, right_line);
    EXPECT_EQ(a.size(), b.size());
}

class SceneRuns : public testing::Test {
 protected:
    Scratch scratch;
    const std::string box = "[box]\nlow = [0, 0]\nhigh = [20, 20]\n";
    const std::string gas = "[balls]\nnumber = 60\nradius = [0.4, 1]\ntemperature = 2\n";
};

TEST_F(SceneRuns, GoOnFromAStateWithTheLogTheyWouldHaveHad) {
    const std::string shake = "[box.shake]\namplitude = [0, 0.5]\nfrequency = 3\n";
    const std::string lossy = "gravity = [0, -1]\nrestitution = 0.9\n";
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"shake", box + shake + gas + "[effects]\nrestitution = 0.95\n"},
        {"speed law", box + gas + "[effects]\n" + lossy + "speed_law = {speed = 1}\n"},
        {"contact duration", box + gas + "[effects]\n" + lossy + "contact_duration = 0.01\n"},
        {"friction", box + gas + "[effects]\n" + lossy + "friction = {coefficient = 0.3}\n"},
        {"growth", box + gas + "[effects]\ngrowth = {rate = 0.02, until = 4}\n"},
        {"walls",
         "[[wall]]\nkind = \"circle\"\ncentre = [0, 0]\nradius = 12\nside = \"inside\"\n"
         "[[wall]]\nkind = \"half-space\"\nnormal = [0.25, 1]\noffset = -8\n"
         "[[wall]]\nkind = \"polyline\"\npoints = [[-3, 0], [3, 1], [4, 5]]\n" +
             gas},
        {"fluid", box + gas +
                      "[effects]\nrestitution = 0.9\nfluid = {velocity = [1, 0], gradient = [[0, "
                      "0.1], [0, 0]], linear = 0.2, quadratic = 0.1}\n[run]\ntime_step = 0.05\n"},
        {"contacts", box + gas +
                         "[effects]\ngravity = [0, -5]\nrestitution = 0.5\nfriction = {coefficient "
                         "= 0.4}\ncontacts = {speed = 0.5}\n[run]\ntime_step = 0.02\n"}};
    for (const auto& [name, text] : cases) {
        SCOPED_TRACE(name);
        const std::string scene = scratch.file("scene.toml", text);
        const std::string state = scratch.path("state.json");
        const auto logged = [&](const Words& words) {
            const Outcome result = run(words);
            EXPECT_EQ(result.code, 0) << result.err;
            return result.out;
        };
        const std::string whole = logged({"simulate", scene, "--events", "600", "--quiet"});
        const std::string first =
            logged({"simulate", scene, "--events", "250", "--save", state, "--quiet"});
        const std::string rest =
            logged({"simulate", "--resume", state, "--events", "350", "--quiet"});
        EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 601);
        expect_same_lines(first + rest.substr(rest.find('\n') + 1), whole);
        // The effect is heeded: without it the log is another one.
        const std::string plain = scratch.file("plain.toml", box + gas);
        EXPECT_TRUE(logged({"simulate", plain, "--events", "600", "--quiet"}) != whole);
    }
}

/// Denser than chance places discs (0.547) and spheres (0.382).
TEST_F(SceneRuns, StartDenselyByGrowth) {
    const auto packing_of = [&]<int D>(const Scene<D>& scene) {
        double filled = 0.0;
        for (const motion::Ball<D>& ball : scene.start.balls) filled += std::pow(ball.radius, D);
        for (int k = 0; k < D; ++k)
            filled /= scene.effects.box->high[k] - scene.effects.box->low[k];
        return filled * (D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi);
    };
    const std::string end = "[run]\nuntil = 1\n";
    for (const std::string periodic : {"true", "false"}) {
        const AnyScene plane = read_scene(
            scratch.file("plane.toml", box + "periodic = " + periodic +
                                           "\n[balls]\nnumber = 150\npacking = 0.76\nradius = [1, "
                                           "1.4]\narrangement = \"growth\"\n" +
                                           end),
            {});
        EXPECT_NEAR(packing_of(std::get<Scene<2>>(plane)), 0.76, 1e-9);
    }
    const AnyScene space = read_scene(
        scratch.file("space.toml",
                     "[box]\nlow = [0, 0, 0]\nhigh = [5, 5, 5]\nperiodic = true\n[balls]\nnumber = "
                     "100\npacking = 0.5\narrangement = \"growth\"\n" +
                         end),
        {});
    EXPECT_NEAR(packing_of(std::get<Scene<3>>(space)), 0.5, 1e-9);
    const auto refused = [&](const std::string& balls, const std::string& why) {
        const std::string scene = scratch.file(
            "dense.toml", box + "[balls]\n" + balls + "arrangement = \"growth\"\n" + end);
        try {
            static_cast<void>(read_scene(scene, {}));
            FAIL();
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(":4:1: [balls]: " + why), std::string::npos)
                << error.what();
        }
    };
    refused("number = 20\npacking = 0.93\n", "the balls jam");
    refused("number = 60\nradius = 40\n", "balls of ");
}

/// A wall that begins among the balls and ends where no double tells how far they are from it.
TEST_F(SceneRuns, StartBesideAWallThatGoesFarAway) {
    for (const std::string points : {"[[10, 1e45], [2.2, 10]]", "[[2.2, 10], [10, 1e45]]"})
        for (const std::string arrangement : {"growth", "random"}) {
            const std::string text =
                "[box]\nlow = [-18, 0]\nhigh = [18, 36]\n[[wall]]\nkind = \"polyline\"\npoints = " +
                points +
                "\n[balls]\nnumber = 20\nradius = [0.4, 0.6]\nregion = {low = [-4, 18], high = [4, "
                "36]}\narrangement = \"" +
                arrangement + "\"\n[run]\nuntil = 1\n";
            const auto scene = std::get<Scene<2>>(read_scene(scratch.file("scene.toml", text), {}));
            for (const motion::Ball<2>& ball : scene.start.balls)
                EXPECT_GE(std::fabs(ball.x[0] - 2.2), ball.radius);
        }
}

/// Grains that rest on one another overlap a little, fall and spin; the next stage begins with them
/// as they are, but apart, and other walls and effects.
TEST_F(SceneRuns, BeginWithWhatAnotherOneLeft) {
    const std::string state = scratch.path("state.json");
    const std::string frames = scratch.path("frames.xyz");
    const std::string pour =
        box + gas +
        "density = 3\n[effects]\ngravity = [0, -5]\nrestitution = 0.5\nfriction = {coefficient = "
        "0.4}\ncontacts = {speed = 0.5}\n[run]\nuntil = 3\ntime_step = 0.02\n";
    EXPECT_EQ(run({"simulate", scratch.file("pour.toml", pour), "--save", state, "-o", frames,
                   "--every", "0.75", "--quiet"})
                  .code,
              0);
    const MotionState<2> left = read_motion_state<2>(state);
    // Deeper than a strike may find them.
    EXPECT_GT(deepest_overlaps(left.state, left.effects, 3.0).of_balls, 0x1p-10);
    const auto next = [&](const std::string& file, const std::string& more) {
        return std::get<Scene<2>>(
            read_scene(scratch.file("next.toml",
                                    "[[wall]]\nkind = \"half-space\"\nnormal = [0, 1]\noffset = "
                                    "-1\n[balls]\nfile = \"" +
                                        file + "\"\n" + more + "[run]\nuntil = 1\n"),
                       {}));
    };
    const std::string friction = "[effects.friction]\ncoefficient = 0.1\n";
    const Scene<2> scene = next("state.json", friction);
    EXPECT_EQ(scene.start.time, 0.0);
    EXPECT_EQ(scene.start.masses, left.state.masses);
    EXPECT_EQ(scene.start.spins, left.state.spins);
    EXPECT_TRUE(next("state.json", "").start.spins.empty());
    const Scene<2> of_frames = next("frames.xyz", "density = 3\n");
    std::size_t smaller = 0;
    for (std::size_t i = 0; i < left.state.balls.size(); ++i) {
        const motion::Ball<2>& ball = left.state.balls[i];
        for (const Scene<2>* each : {&scene, &of_frames}) {
            const motion::Ball<2>& now = each->start.balls[i];
            for (int k = 0; k < 2; ++k) {
                EXPECT_EQ(now.x[k], coordinate(ball, k, 3.0, left.effects));
                EXPECT_EQ(now.v[k], speed(ball, k, 3.0, left.effects));
            }
            EXPECT_LE(now.radius, ball.radius);
            EXPECT_GE(now.radius, ball.radius * (1.0 - 0x1.4p-8));
            EXPECT_EQ(now.time, 0.0);
        }
        smaller += scene.start.balls[i].radius < ball.radius ? 1U : 0U;
        EXPECT_DOUBLE_EQ(of_frames.start.masses[i], left.state.masses[i]);
    }
    EXPECT_GT(smaller, 0U);
    EXPECT_LT(smaller, left.state.balls.size());
    // With other effects, and no ball falls through another one.
    for (const Words& effects :
         {Words{"--gravity", "5", "0"}, Words{"--set", "effects={}", "--set", "run={until=2}"}}) {
        Words words = {"simulate", scratch.path("pour.toml"), "--set",
                       "balls={file=\"state.json\"}"};
        words.insert(words.end(), effects.begin(), effects.end());
        words.insert(words.end(), {"-o", scratch.path("page.html"), "--quiet"});
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 0) << result.err;
        const std::string page = contents(scratch.path("page.html"));
        for (const std::string what :
             {"no two balls overlap", "no ball is in a wall, or outside"}) {
            const std::size_t row = page.find("<td>" + what + "</td>");
            EXPECT_NE(page.substr(row, page.find("</tr>", row) - row).find("class=\"good\""),
                      std::string::npos)
                << what;
        }
    }
}

/// Radii as they have grown, and places in a periodic box.
TEST_F(SceneRuns, BeginWithWhatHasGrown) {
    const std::string state = scratch.path("state.json");
    const std::string grow = scratch.file(
        "grow.toml", box + "periodic = true\n" + gas +
                         "[effects]\ngrowth = {rate = 0.125, until = 2}\n[run]\nuntil = 1.5\n");
    const std::string log = scratch.path("log.csv");
    EXPECT_EQ(run({"simulate", grow, "--save", state, "-o", log, "--quiet"}).code, 0);
    const MotionState<2> left = read_motion_state<2>(state);
    const auto scene = std::get<Scene<2>>(read_scene(
        scratch.file("next.toml", box + "periodic = true\n[balls]\nfile = \"state.json\"\n[run]\n"
                                        "until = 1\n"),
        {}));
    for (std::size_t i = 0; i < left.state.balls.size(); ++i)
        EXPECT_EQ(scene.start.balls[i].radius, radius_at(left.state.balls[i], 1.5, left.effects));
    const auto before = std::get<Scene<2>>(read_scene(grow, {}));
    EXPECT_DOUBLE_EQ(scene.start.balls[0].radius, 1.1875 * before.start.balls[0].radius);
}

TEST_F(SceneRuns, SayWhatIsWrongWithWhatAnotherOneLeft) {
    const auto said = [&](const std::string& more) {
        const Outcome result =
            run({"simulate",
                 scratch.file("next.toml", box + "[balls]\n" + more + "[run]\nuntil = 1\n")});
        EXPECT_EQ(result.code, 2);
        return result.err;
    };
    const std::string plane = scratch.path("plane.json");
    const std::string grid = scratch.file("two.txt", "5 5 1 0 0\n15 5 1 0 0\n");
    EXPECT_EQ(run({"simulate", grid, "--until", "0", "--save", plane, "--quiet"}).code, 0);
    const std::string next = scratch.path("next.toml");
    EXPECT_EQ(said("file = \"plane.json\"\ndensity = 2\n"),
              next +
                  ":6:11: density: is for balls that are made or listed; a file says the "
                  "masses\n");
    EXPECT_EQ(said("file = \"plane.json\"\n[effects]\n[[wall]]\nkind = \"half-space\"\nnormal = "
                   "[-1, 0]\noffset = -10\n"),
              plane + ": ball 1: a ball that overlaps wall 4; it may touch it\n");
    // A later stage does not take the place of the one before.
    scratch.file("next.toml", box + "[balls]\nfile = \"plane.json\"\n[run]\nuntil = 1\n");
    for (const std::string option : {"--save", "--closest"})
        EXPECT_EQ(run({"simulate", next, option, plane}).err,
                  "signum: " + option + " " + plane +
                      " would overwrite a file of the scene; give another name\n");
    scratch.file("none.json", "{\"x\": 1}\n");
    EXPECT_EQ(
        said("file = \"none.json\"\n"),
        scratch.path("none.json") + ": no state of a simulation; give a file that --save wrote\n");
    const std::string space = scratch.file("space.txt", "5 5 5 1 0 0 0\n");
    EXPECT_EQ(run({"simulate", space, "--until", "0", "--save", scratch.path("space.json"), "-o",
                   scratch.path("space.xyz"), "--quiet"})
                  .code,
              0);
    for (const std::string file : {"space.json", "space.xyz"})
        EXPECT_EQ(said("file = \"" + file + "\"\n"),
                  next + ":5:8: file: the balls of " + scratch.path(file) +
                      " lie in space, and the scene in the plane; give one dimension to both\n");
    const std::string head =
        "Lattice=\"9 0 0 0 9 0 0 0 1\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1 "
        "Time=0\n";
    const std::string frames = scratch.path("frames.xyz");
    const auto said_of = [&](const std::string& text) {
        scratch.file("frames.xyz", text);
        return said("file = \"frames.xyz\"\n");
    };
    const std::string ball = "A 5 5 0 0 0 0 1 0\n";
    EXPECT_EQ(said_of("2\n" + head + ball + "A 6 5 0 0 0 0 1 1\n"),
              frames + ":4:1: a ball that overlaps ball 0; balls may touch\n");
    EXPECT_EQ(said_of("1\n" + head + "A 5 5 0 0 0 0 0 0\n"),
              frames +
                  ":3:1: a ball of radius 0, which needs a mass, and frames have none; give a "
                  "state, or lines of balls\n");
    const std::string advice = "; give frames as signum writes them\n";
    EXPECT_EQ(said_of("2\n" + head + ball), frames + ":3:1: the file ends within a frame" + advice);
    EXPECT_EQ(said_of("1\n" + head + ball + "x\n"), frames + ":4:1: no number of balls" + advice);
    EXPECT_EQ(said_of("1\n" + head + "A 5 5 0 0 0 0\n"),
              frames + ":3:14: a ball without all of its numbers" + advice);
    EXPECT_EQ(said_of("1\n" + head + "A 5 5 0 0 0 0 1 0 7\n"),
              frames + ":3:18: more behind a ball than its numbers" + advice);
    EXPECT_TRUE(said_of("1\n" + head + "A 5 y 0 0 0 0 1 0\n").starts_with(frames + ":3:5: "));
    EXPECT_EQ(
        said_of("1\nProperties=pos:R:3\nA 5 5 0\n"),
        frames + ":2:1: no Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1" + advice);
    EXPECT_EQ(said_of("0\n" + head), frames + ":2:1: no ball in the last frame" + advice);
}

TEST_F(SceneRuns, RecordWhereTheSceneSaysUnlessAnOptionDoes) {
    const auto name = [&](const std::string& file) { return scratch.path(file); };
    const std::string scene =
        scratch.file("scene.toml", box + gas + "[run]\nuntil = 0.5\n[record]\nlog = \"" +
                                       name("log.csv") + "\"\nframes = \"" + name("f.xyz") +
                                       "\"\nstate = \"" + name("s.json") + "\"\n");
    EXPECT_EQ(run({"simulate", scene, "--quiet"}).out, "");
    const std::string log = contents(name("log.csv"));
    EXPECT_TRUE(log.starts_with("time,kind,a,b,impulse\n"));
    EXPECT_TRUE(contents(name("f.xyz")).starts_with("60\n"));
    EXPECT_EQ(read_motion_state<2>(name("s.json")).state.time, 0.5);
    EXPECT_EQ(run({"simulate", scene, "-o", name("other.csv"), "--until", "0.25", "--quiet"}).code,
              0);
    EXPECT_TRUE(log.starts_with(contents(name("other.csv"))));
    EXPECT_LT(contents(name("other.csv")).size(), log.size());
    EXPECT_EQ(contents(name("log.csv")), log);
    const Outcome clash = run({"simulate", scene, "-o", name("f.xyz"), "--quiet"});
    EXPECT_EQ(clash.code, 0) << clash.err;
    EXPECT_EQ(run({"simulate", scene, "--save", name("log.csv")}).err,
              "signum: --save " + name("log.csv") + " is where -o goes, too; give another name\n");
}

TEST_F(SceneRuns, AreNotExplainedWhereTheyWouldBeRefused) {
    const std::string scene = scratch.file("scene.toml", box + gas + "[run]\nuntil = 0.5\n");
    const std::string nowhere = scratch.path("missing/log.csv");
    for (const Words& words :
         {Words{"-o", nowhere}, Words{"--save", nowhere}, Words{"--closest", nowhere},
          Words{"--every", "0.1"}, Words{"--until", "-1"},
          Words{"--save", scratch.path("a.csv"), "-o", scratch.path("a.csv")}}) {
        Words call = {"simulate", scene, "--quiet"};
        call.insert(call.end(), words.begin(), words.end());
        const Outcome refused = run(call);
        call.emplace_back("--explain");
        const Outcome explained = run(call);
        EXPECT_NE(refused.code, 0) << words[0];
        EXPECT_EQ(explained.code, refused.code) << words[0];
        EXPECT_EQ(explained.err, refused.err);
        EXPECT_EQ(explained.out, "");
    }
    const std::string balls = scratch.file("balls.txt", "0 0 1 1 0\n");
    EXPECT_EQ(run({"simulate", balls, "--until", "1", "--explain"}).err,
              "signum: --explain is for scenes; give FILE.toml\n");
    // Nothing stays of the files that it opens.
    EXPECT_EQ(run({"simulate", scene, "-o", scratch.path("b.csv"), "--explain"}).code, 0);
    EXPECT_FALSE(std::ifstream(scratch.path("b.csv")).good());
}

TEST_F(SceneRuns, SayWhatTheyWillWriteAndWhatTheyHaveWritten) {
    const auto name = [&](const std::string& file) { return scratch.path(file); };
    const std::string scene =
        scratch.file("scene.toml", box + gas + "[run]\nuntil = 0.5\n[record]\nlog = \"" +
                                       name("log.csv") + "\"\nenergies = \"" + name("e.csv") +
                                       "\"\nstate = \"" + name("s.json") + "\"\n");
    const std::string page = name("page.html");
    // -o and --save win over the record, and the page tells the same as --explain.
    const Words words = {"simulate", scene, "-o",     name("other.csv"),
                         "-o",       page,  "--save", name("t.json")};
    const std::string results =
        name("other.csv") + ", " + page + ", " + name("e.csv") + ", " + name("t.json");
    Words explained = words;
    explained.emplace_back("--explain");
    EXPECT_NE(run(explained).out.find("\nrecords    " + results + "\n"), std::string::npos)
        << run(explained).out;
    EXPECT_FALSE(std::ifstream(page).good());
    const Outcome result = run(words);
    EXPECT_NE(result.err.find("\nwritten  " + results + "\n"), std::string::npos) << result.err;
    EXPECT_NE(contents(page).find("\nrecords    " + results + "\n"), std::string::npos);
    const std::string plain = scratch.file("plain.toml", box + gas + "[run]\nuntil = 0.5\n");
    EXPECT_NE(
        run({"simulate", plain, "--explain"}).out.find("\nrecords    the log to standard output\n"),
        std::string::npos);
    EXPECT_NE(run({"simulate", plain, "--save", name("t.json")})
                  .err.find("\nwritten  " + name("t.json") + "\n"),
              std::string::npos);
}

TEST_F(SceneRuns, AnInterruptWhileBallsArePlacedIsSaid) {
    const std::string scene =
        scratch.file("scene.toml",
                     "[box]\nlow = [0, 0]\nhigh = [20, 20]\n[balls]\nnumber = 40000\npacking = "
                     "0.83\narrangement = \"growth\"\n[run]\nuntil = 1\n");
    const Outcome result =
        run({"simulate", scene, "-o", scratch.path("log.csv")}, {.signal_after_ms = 400});
    EXPECT_EQ(result.code, -SIGINT);
    EXPECT_EQ(result.err, "signum: interrupted while balls were placed; nothing was written\n");
    EXPECT_EQ(scratch.size(), 1U);
}

/// With curves where gnuplot is there, and without them where it is not.
TEST_F(SceneRuns, WriteAPageThatNeedsNothingBesideIt) {
    const std::string page = scratch.path("page.html");
    const std::string scene = scratch.file(
        "scene.toml", "title = \"A <gas> & walls\"\n" + box + "periodic = true\n" + gas +
                          "[run]\nuntil = 2\n[record]\npage = \"" + page + "\"\n");
    const auto count = [](const std::string& text, const std::string& part) {
        std::size_t found = 0;
        for (std::size_t at = text.find(part); at != std::string::npos;
             at = text.find(part, at + 1))
            ++found;
        return found;
    };
    EXPECT_EQ(run({"simulate", scene, "--quiet"}).code, 0);
    const std::string text = contents(page);
    EXPECT_TRUE(text.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(text.ends_with("</html>\n"));
    EXPECT_NE(text.find("<h1>A &lt;gas> &amp; walls</h1>"), std::string::npos);
    // The film, energies, strikes and pairs.
    EXPECT_EQ(count(text, "<svg"), 4U);
    for (const std::string what : {"energy is conserved", "momentum is conserved",
                                   "speeds are those of Maxwell", "no two balls overlap"})
        EXPECT_EQ(count(text, "<td>" + what + "</td>"), 1U) << what;
    EXPECT_EQ(count(text, "class=\"not_good\""), 0U);
    for (const std::string elsewhere : {"src=", "href=\"http", "url(http", "@import"})
        EXPECT_EQ(count(text, elsewhere), 0U) << elsewhere;

    const std::string path = std::getenv("PATH");
    ::setenv("PATH", scratch.path("").c_str(), 1);
    const Outcome without = run({"simulate", scene, "-o", page, "--quiet"});
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(without.code, 0) << without.err;
    EXPECT_EQ(count(contents(page), "<svg"), 1U);
    EXPECT_NE(contents(page).find("apt-get install gnuplot-nox"), std::string::npos);
}

/// By the names that everyone has for them.
TEST_F(SceneRuns, ThePageNamesItsEnergies) {
    if (!has_program("gnuplot", "--version")) GTEST_SKIP() << "no gnuplot";
    const std::string page = scratch.path("page.html");
    const std::string scene = scratch.file(
        "scene.toml", box + gas + "[effects]\ngravity = [0, -1]\nfriction = {coefficient = 0.5}\n" +
                          "[run]\nuntil = 1\n[record]\npage = \"" + page + "\"\n");
    EXPECT_EQ(run({"simulate", scene, "--quiet"}).code, 0);
    const std::string text = contents(page);
    for (const std::string name : {"kinetic", "rotational", "potential", "total"})
        EXPECT_NE(text.find(name + "</tspan>"), std::string::npos) << name;
}

/// The box goes up and down by 2 of 24 that are shown, in 640 pixels; radii double.
TEST_F(SceneRuns, ShowWallsAndGrowthInAFilm) {
    const std::string film = scratch.path("film.svg");
    const std::string scene = scratch.file(
        "scene.toml",
        box +
            "[box.shake]\namplitude = [0, 2]\nfrequency = \"1 Hz\"\n[[wall]]\nkind = "
            "\"circle\"\ncentre = [15, 10]\nradius = 3\nside = \"outside\"\n[balls]\nlist = "
            "[[5, 10, 1.5, 0, 0]]\n[effects]\ngrowth = {rate = 1, until = 1}\n[run]\nuntil = "
            "1\n[record]\nevery = 0.25\nfilm = \"" +
            film + "\"\n");
    EXPECT_EQ(run({"simulate", scene, "--quiet"}).code, 0);
    const std::string svg = contents(film);
    EXPECT_NE(svg.find("type=\"translate\" dur=\"12s\" repeatCount=\"indefinite\" "
                       "calcMode=\"linear\" values=\"0.00 0.00;0.00 -53.33;0.00 "),
              std::string::npos);
    EXPECT_NE(svg.find("r=\"80.0\""), std::string::npos);
    EXPECT_NE(svg.find("attributeName=\"r\" dur=\"12s\" repeatCount=\"indefinite\" "
                       "calcMode=\"linear\" values=\"40.00;50.00;60.00;70.00;80.00\""),
              std::string::npos);
}

/// Friction turns flight into spin, and elastic surfaces give all of it back.
TEST_F(SceneRuns, EnergiesTellSpin) {
    const std::string energies = scratch.path("energies.csv");
    const std::string scene = scratch.file(
        "scene.toml", box +
                          "[balls]\nlist = [[5, 5, 1, 1, 1, 2, 3]]\n[effects]\nfriction = "
                          "{coefficient = 10, tangential_restitution = 1}\n[run]\nuntil = "
                          "40\n[record]\nevery = 10\nenergies = \"" +
                          energies + "\"\n");
    const Outcome result = run({"simulate", scene, "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    std::istringstream lines(contents(energies));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "time,kinetic,spin,total");
    double first_spin = -1.0;
    bool changes = false;
    while (std::getline(lines, line)) {
        double time = 0.0;
        double kinetic = 0.0;
        double spin = 0.0;
        double total = 0.0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &kinetic, &spin, &total), 4);
        // m v² / 2 + m r² ω² / 4 of the start.
        EXPECT_NEAR(total, 2.0 + 4.5, 1e-9);
        EXPECT_NEAR(kinetic + spin, total, 1e-9);
        if (first_spin < 0.0) first_spin = spin;
        changes = changes || std::fabs(spin - first_spin) > 0.1;
    }
    EXPECT_EQ(first_spin, 4.5);
    EXPECT_TRUE(changes);
}

/// All pairs of many balls would take minutes.
TEST(Overlaps, ManyBallsInOnePlaceTakeNoLonger) {
    std::vector<motion::Body<2>> bodies(300'000);
    for (motion::Body<2>& body : bodies) body.radius = 1;
    bodies.back().x = {5, 5};
    const std::clock_t start = std::clock();
    part(std::span(bodies), motion::Effects<2>{});
    EXPECT_LT(std::clock() - start, 30 * CLOCKS_PER_SEC);
    // Nothing here can be taken apart.
    for (const motion::Body<2>& body : bodies) ASSERT_EQ(body.radius, 1);
}

TEST(Overlaps, AreThoseOfAllPairs) {
    // A grid that is shaken, in a periodic box: all overlaps are small enough to be undone.
    motion::Effects<3> effects;
    effects.box = {{0, 0, 0}, {12, 12, 12}};
    effects.periodic = true;
    std::vector<motion::Body<3>> bodies;
    std::uint32_t random = 1;
    const auto next = [&] { return (random = random * 1664525 + 1013904223) * 0x1p-32; };
    for (int i = 0; i < 216; ++i) {
        motion::Body<3>& body = bodies.emplace_back();
        body.x = {2.0 * (i % 6) + 1, 2.0 * (i / 6 % 6) + 1, 2.0 * (i / 36) + 1};
        for (double& x : body.x) x += 0.004 * (next() - 0.5);
        body.radius = i % 5 == 0 ? 0.5 : 1.0;
    }
    const std::vector<motion::Body<3>> before = bodies;
    part(std::span(bodies), effects);
    int undone = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            double square = 0;
            for (int k = 0; k < 3; ++k) {
                const double d = bodies[i].x[k] - bodies[j].x[k];
                const double nearest = d - 12 * std::nearbyint(d / 12);
                square += nearest * nearest;
            }
            undone += std::sqrt(square) < before[i].radius + before[j].radius ? 1 : 0;
            EXPECT_GE(std::sqrt(square), bodies[i].radius + bodies[j].radius) << i << " " << j;
        }
    EXPECT_GT(undone, 100);
}

}  // namespace
}  // namespace signum
