/// Scenes that are right: quantities, every kind of wall, effect and ball, and that the page of the
/// documentation and the reader know the same keys.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/scenes/explain.hpp"
#include "../../tool/scenes/keys.hpp"
#include "../../tool/scenes/read_scene.hpp"
#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::Scratch;

TEST(SceneUnits, AreExactWhereTheyAreDecimal) {
    const auto in = [](const Units& units, double value, std::string_view unit) {
        return units.plain(value, std::get<Unit>(parse_unit(unit)));
    };
    const Units metres;
    EXPECT_EQ(in(metres, 5, "mm"), 0.005);
    EXPECT_EQ(in(metres, 3, "ft"), 0.9144);
    EXPECT_EQ(in(metres, 9.81, "m/s^2"), 9.81);
    EXPECT_EQ(in(metres, 1, "kg m/s^2"), 1.0);
    EXPECT_EQ(in(metres, 1, "N"), 1.0);
    EXPECT_EQ(in(metres, 36, "km/h"), 10.0);
    EXPECT_EQ(in(metres, 33, "%"), 0.33);
    EXPECT_EQ(in(metres, 2, "1/min"), 2.0 / 60.0);
    EXPECT_DOUBLE_EQ(in(metres, 20, "Hz"), 40.0 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(in(metres, 60, "rpm"), 2.0 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(in(metres, 180, "deg"), std::numbers::pi);
    Units small;
    small.take(std::get<Unit>(parse_unit("mm")), "mm");
    small.take(std::get<Unit>(parse_unit("ms")), "ms");
    small.take(std::get<Unit>(parse_unit("g")), "g");
    EXPECT_EQ(in(small, 20, "cm"), 200.0);
    EXPECT_EQ(in(small, 2, "m/s"), 2.0);
    EXPECT_EQ(in(small, 1, "kg"), 1000.0);
    EXPECT_EQ(in(small, 1, "J"), 1000.0);
    EXPECT_EQ(small.name_of(dimensions::acceleration), "mm/ms^2");
    for (const std::string wrong : {"", "sec", "m/", "m^", "m^22", "/", "5"})
        EXPECT_TRUE(std::holds_alternative<std::string>(parse_unit(wrong))) << wrong;
}

class RightScene : public testing::Test {
 protected:
    template <int D>
    Scene<D> read(const std::string& text, std::vector<Override> overrides = {}) {
        return std::get<Scene<D>>(read_scene(scratch.file("scene.toml", text), overrides));
    }
    Scratch scratch;
    const std::string box = "[box]\nlow = [0, 0]\nhigh = [20, 20]\n";
    const std::string one = "[balls]\nlist = [[5, 5, 1, 1, 0]]\n";
    const std::string end = "[run]\nuntil = 1\n";
};

TEST_F(RightScene, OfAllEffects) {
    const Scene<2> scene = read<2>(
        "title = \"All\"\n[units]\nlength = \"cm\"\n" + box +
        "[box.shake]\namplitude = [0, \"5 mm\"]\nfrequency = \"10 Hz\"\nphase = \"90 deg\"\n" +
        one +
        "[effects]\ngravity = [0, \"-9.81 m/s^2\"]\nrestitution = 0.9\ncontact_duration = "
        "\"1 ms\"\nspeed_law = {speed = \"1 m/s\"}\nfriction = {coefficient = 0.5, "
        "tangential_restitution = -0.5}\nfluid = {velocity = [1, 2], gradient = [[0, 1], [2, 0]], "
        "linear = 3, quadratic = 4}\ncontacts = {speed = 0.25, sweeps = 7}\n"
        "[run]\nuntil = 2\nevents = 9\ntime_step = \"5 ms\"\nstructure = \"Cells\"\narithmetic = "
        "\"naive\"\n");
    const motion::Effects<2>& e = scene.effects;
    EXPECT_EQ(scene.title, "All");
    EXPECT_EQ(e.box->high[1], 20.0);
    EXPECT_EQ(e.shake->amplitude[1], 0.5);
    EXPECT_DOUBLE_EQ(e.shake->frequency, 20.0 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(e.shake->phase, 0.5 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(e.gravity[1], -981.0);
    EXPECT_EQ(e.restitution, 0.9);
    EXPECT_EQ(e.wall_restitution, 0.9);
    EXPECT_EQ(e.contact_duration, 0.001);
    EXPECT_EQ(e.speed_law->speed, 100.0);
    EXPECT_EQ(e.speed_law->power, 0.2);
    EXPECT_EQ(e.friction->wall_coefficient, 0.5);
    EXPECT_EQ(e.friction->tangential_restitution, -0.5);
    EXPECT_EQ(e.friction->inertia, 0.5);
    EXPECT_EQ(e.fluid->gradient[1][0], 2.0);
    EXPECT_EQ(e.fluid->quadratic, 4.0);
    EXPECT_EQ(e.contacts->speed, 0.25);
    EXPECT_EQ(e.contacts->sweeps, 7);
    EXPECT_EQ(e.time_step, 0.005);
    EXPECT_EQ(scene.run.until, 2.0);
    EXPECT_EQ(scene.run.events, 9U);
    EXPECT_EQ(scene.run.structure, motion::Structure::cells);
    EXPECT_EQ(scene.run.kernel, motion::Kernel::naive);
    const std::string text = explain(scene, "a.csv");
    EXPECT_NE(text.find("\nrecords    a.csv\n"), std::string::npos);
    const std::size_t left_out = text.find("\nLeft out");
    for (const std::string name : {"gravity", "restitution", "speed_law", "contact_duration",
                                   "friction", "shake", "fluid", "contacts"})
        EXPECT_LT(text.find("\n  " + name), left_out) << name;
    EXPECT_GT(text.find("\n  growth"), left_out);
    EXPECT_NE(text.find("steps of 0.005 s"), std::string::npos);
}

TEST_F(RightScene, OfAllWalls) {
    const Scene<2> plane = read<2>(
        "[[wall]]\nkind = \"half-space\"\nnormal = [0, 2]\npoint = [7, -3]\nspeed = 0.5\n"
        "[[wall]]\nkind = \"circle\"\ncentre = [5, 5]\nradius = 9\nside = \"inside\"\n"
        "[[wall]]\nkind = \"polyline\"\npoints = [[1, 1], [2, 2], [1, 3]]\nclosed = true\n" +
        one + end);
    ASSERT_EQ(plane.effects.obstacles.size(), 5U);
    const auto& floor = std::get<motion::HalfSpace<2>>(plane.effects.obstacles[0]);
    EXPECT_EQ(floor.offset, -6.0);
    EXPECT_EQ(floor.speed, 0.5);
    const auto& circle = std::get<motion::Sphere<2>>(plane.effects.obstacles[1]);
    EXPECT_EQ(circle.side, motion::Sphere<2>::Side::inside);
    const auto& last = std::get<motion::Segment>(plane.effects.obstacles[4]);
    EXPECT_EQ(last.from, (motion::Vector<2>{1, 3}));
    EXPECT_EQ(last.to, (motion::Vector<2>{1, 1}));
    const Scene<3> space = read<3>(
        "[[wall]]\nkind = \"sphere\"\ncentre = [0, 0, 0]\nradius = 9\nside = \"outside\"\n"
        "velocity = [1, 2, 3]\n[balls]\nlist = [[5, 9, 9, 1, 0, 0, 1]]\n" +
        end);
    const auto& sphere = std::get<motion::Sphere<3>>(space.effects.obstacles[0]);
    EXPECT_EQ(sphere.velocity[2], 3.0);
    EXPECT_EQ(space.start.masses[0], 1.0);
}

TEST_F(RightScene, OfAllKindsOfBalls) {
    scratch.file("some.csv", "x,y,r,vx,vy,m\n1,1,1,2,3,4\n");
    const Scene<2> scene = read<2>(
        box +
        "[[balls]]\nfile = \"some.csv\"\n[[balls]]\nlist = [[5, 5, 2, 0, \"1 m/s\"], [9, 5, 1, "
        "0, 0, 8]]\ndensity = 3\n[[balls]]\nnumber = 30\nradius = [0.2, 0.4]\nsizes = \"area\"\n"
        "temperature = 2\nregion = {low = [0, 10], high = [20, 20]}\n[[balls]]\nnumber = 7\nradius "
        "= 0.5\nspeed = 4\narrangement = \"lattice\"\nregion = {low = [12, 1], high = [19, 9]}\n" +
        end);
    ASSERT_EQ(scene.start.balls.size(), 40U);
    EXPECT_EQ(scene.start.masses[0], 4.0);
    EXPECT_DOUBLE_EQ(scene.start.masses[1], 12.0 * std::numbers::pi);
    EXPECT_EQ(scene.start.masses[2], 8.0);
    ASSERT_EQ(scene.files.size(), 2U);
    motion::Vector<2> momentum{};
    double kinetic = 0.0;
    for (std::size_t i = 3; i < 33; ++i) {
        const motion::Ball<2>& ball = scene.start.balls[i];
        EXPECT_GE(ball.radius, 0.2);
        EXPECT_LE(ball.radius, 0.4);
        EXPECT_DOUBLE_EQ(scene.start.masses[i], ball.radius * ball.radius);
        EXPECT_GE(ball.x[1] - ball.radius, 10.0);
        for (int k = 0; k < 2; ++k) {
            momentum[k] += scene.start.masses[i] * ball.v[k];
            kinetic += 0.5 * scene.start.masses[i] * ball.v[k] * ball.v[k];
        }
    }
    EXPECT_NEAR(momentum[0], 0.0, 1e-12);
    EXPECT_NEAR(momentum[1], 0.0, 1e-12);
    EXPECT_NEAR(kinetic, 60.0, 1e-10);
    for (std::size_t i = 33; i < 40; ++i)
        EXPECT_NEAR(std::hypot(scene.start.balls[i].v[0], scene.start.balls[i].v[1]), 4.0, 1e-12);
}

TEST_F(RightScene, SpinIsTheLastEntryOfABall) {
    const std::string friction = "[effects.friction]\ncoefficient = 0.5\n";
    const Scene<2> plane =
        read<2>(box + "[balls]\nlist = [[5, 5, 1, 1, 0, 2, \"-1 turn/s\"], [9, 9, 1, 0, 0]]\n" +
                end + friction);
    EXPECT_DOUBLE_EQ(plane.start.spins[0][0], -2.0 * std::numbers::pi);
    EXPECT_EQ(plane.start.spins[1][0], 0.0);
    const Scene<3> space =
        read<3>("[balls]\nlist = [[0, 0, 0, 1, 0, 0, 0, 2, 3, 4, 5]]\n" + end + friction);
    EXPECT_EQ(space.start.spins[0], (motion::Spin<3>{3, 4, 5}));
    EXPECT_EQ(space.effects.friction->inertia, 0.4);
}

/// A glass marble of 8 mm weighs 0.67 g, and a disc cut from a sheet of 2 mm 0.25 g.
TEST_F(RightScene, ADensityIsThatOfTheMaterial) {
    const Scene<3> marbles = read<3>(
        "dimension = 3\n[balls]\nlist = [[0, 0, 0, \"4 mm\", 0, 0, 0], [1, 0, 0, \"4 mm\", 0, 0, "
        "0]]\ndensity = "
        "\"2500 kg/m^3\"\n" +
        end);
    EXPECT_NEAR(marbles.start.masses[0], 6.702e-4, 1e-7);
    EXPECT_NE(explain(marbles, "").find("\nmass       0.00134 kg in all\n"), std::string::npos)
        << explain(marbles, "");
    const Scene<2> discs = read<2>(
        "[units]\nmass = \"g\"\n[balls]\nlist = [[0, 0, \"4 mm\", 0, "
        "0]]\ndensity = \"5 kg/m^2\"\n" +
        end);
    EXPECT_NEAR(discs.start.masses[0], 0.2513, 1e-4);
    EXPECT_EQ(read<2>("[balls]\nlist = [[0, 0, 3, 0, 0]]\n" + end).start.masses[0], 9.0);
}

/// A ball that cannot be is named where it is said.
TEST_F(RightScene, ABallIsNamedInItsFile) {
    const std::string balls = scratch.file("some.csv", "x,y,r,vx,vy\n1,1,1,0,0\n2,1,1,0,0\n");
    try {
        static_cast<void>(read<2>(box + "[balls]\nfile = \"some.csv\"\n" + end));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), balls + ":3:1: a ball that overlaps ball 0; balls may touch");
    }
}

TEST_F(RightScene, PackingTellsRadiiOrTheirNumber) {
    const auto filled = [](const Scene<2>& scene) {
        double sum = 0.0;
        for (const motion::Ball<2>& ball : scene.start.balls)
            sum += std::numbers::pi * ball.radius * ball.radius;
        return sum / 400.0;
    };
    const Scene<2> radii =
        read<2>(box + "[balls]\nnumber = 50\nradius = [1, 3]\npacking = \"30 %\"\n" + end);
    EXPECT_EQ(radii.start.balls.size(), 50U);
    EXPECT_NEAR(filled(radii), 0.3, 1e-12);
    const Scene<3> spheres = read<3>(
        "[box]\nlow = [0, 0, 0]\nhigh = [9, 9, 9]\n[balls]\nnumber = 60\nradius = [1, 2]\n"
        "packing = 0.2\n" +
        end);
    double volume = 0.0;
    for (const motion::Ball<3>& ball : spheres.start.balls)
        volume += 4.0 / 3.0 * std::numbers::pi * std::pow(ball.radius, 3);
    EXPECT_NEAR(volume / 729.0, 0.2, 1e-12);
    const Scene<2> number = read<2>(box + "[balls]\nradius = 0.5\npacking = 0.3\n" + end);
    EXPECT_EQ(number.start.balls.size(), 152U);
    const Scene<2> equal = read<2>(box + "[balls]\nnumber = 50\npacking = 0.3\n" + end);
    EXPECT_EQ(equal.start.balls[0].radius, equal.start.balls[49].radius);
    // Every size fills as much: of all that balls fill, radii up to the middle fill half.
    const Scene<2> sizes = read<2>(
        "[box]\nlow = [0, 0]\nhigh = [400, 400]\n[balls]\nnumber = 4000\nradius = [0.5, 2.5]\n"
        "sizes = \"area\"\n" +
        end);
    double small = 0.0;
    double all = 0.0;
    for (const motion::Ball<2>& ball : sizes.start.balls) {
        all += ball.radius * ball.radius;
        if (ball.radius < 1.5) small += ball.radius * ball.radius;
    }
    EXPECT_NEAR(small / all, 0.5, 0.03);
}

TEST_F(RightScene, SeedsTellTheBalls) {
    const std::string text = box + "[balls]\nnumber = 20\nradius = 1\nspeed = 1\n" + end;
    const auto places = [&](const std::string& seed) {
        std::vector<double> result;
        for (const motion::Ball<2>& ball :
             read<2>(text, {{"--set", "balls.seed = " + seed}}).start.balls)
            result.push_back(ball.x[0]);
        return result;
    };
    EXPECT_EQ(places("1"), places("1"));
    EXPECT_NE(places("1"), places("2"));
}

TEST_F(RightScene, OptionsWinOverTheFile) {
    const std::string text =
        box + "[[balls]]\nlist = [[5, 5, 1, 1, 0]]\n[[balls]]\nlist = [[9, 9, 1, 1, 0]]\n" + end;
    const Scene<2> scene =
        read<2>(text, {{"a", "effects.friction.coefficient = 0.25"},
                       {"b", "box.high.0 = 30"},
                       {"c", "balls.1.list = [[15, 9, 2, 0, 0], [3, 3, 0.5, 0, 0]]"},
                       {"d", "run = {events = 5}"}});
    EXPECT_EQ(scene.effects.friction->coefficient, 0.25);
    EXPECT_EQ(scene.effects.box->high[0], 30.0);
    EXPECT_EQ(scene.start.balls.size(), 3U);
    EXPECT_FALSE(scene.run.until);
    EXPECT_EQ(scene.run.events, 5U);
    EXPECT_DOUBLE_EQ(read<2>(box + one + end, {{"e", "balls.density = 2"}}).start.masses[0],
                     2.0 * std::numbers::pi);
}

TEST_F(RightScene, AWholeNumberMayBeWrittenWithAPower) {
    const std::string text = box + "[balls]\nnumber = 2e1\nradius = 0.5\n" + end;
    EXPECT_EQ(read<2>(text).start.balls.size(), 20U);
    EXPECT_EQ(read<2>(text, {{"--set", "balls.number = 1.2e1"}}).start.balls.size(), 12U);
    EXPECT_EQ(read<2>(text, {{"--set", "run.events = 1e6"}}).run.events, 1'000'000U);
}

/// A scene and a file of balls with options write the same log.
TEST_F(RightScene, RunsAsItsBallsWould) {
    const std::string root = SIGNUM_SOURCES;
    const std::string path = testing::TempDir() + "/break.toml";
    std::ofstream(path)
        << "[box]\nlow = [0, 0]\nhigh = [\"254 cm\", \"127 cm\"]\n[balls]\nfile = \"" << root
        << "/examples/pool.csv\"\n[effects]\nrestitution = 0.96\n"
        << "wall_restitution = 0.8\n[run]\nuntil = \"3 s\"\n";
    const test::Outcome scene = test::run({"simulate", path, "--quiet"});
    const test::Outcome balls = test::run({"simulate", root + "/examples/pool.csv", "--box", "0",
                                           "0", "2.54", "1.27", "--restitution", "0.96",
                                           "--wall-restitution", "0.8", "--until", "3", "--quiet"});
    EXPECT_EQ(scene.code, 0) << scene.err;
    EXPECT_EQ(scene.out, balls.out);
    EXPECT_GT(scene.out.size(), 1000U);
}

/// Its keys by sections, as its tables have them.
std::map<std::string, std::set<std::string>> documented() {
    std::ifstream page(std::string(SIGNUM_SOURCES) + "/docs/scenes.md");
    std::map<std::string, std::set<std::string>> result;
    std::optional<std::string> section;
    std::string line;
    while (std::getline(page, line)) {
        if (line.starts_with("#")) {
            section.reset();
            if (line == "### The file") section = "";
            if (line.starts_with("### `[")) {
                const std::size_t begin = line.find_first_not_of("#` [");
                section = line.substr(begin, line.find(']') - begin);
            }
        }
        if (!section || !line.starts_with("| ")) continue;
        const std::size_t begin = line.find('`');
        if (begin == std::string::npos || begin > 4) continue;
        EXPECT_TRUE(result[*section]
                        .insert(line.substr(begin + 1, line.find('`', begin + 1) - begin - 1))
                        .second)
            << line;
    }
    return result;
}

TEST(SceneKeys, AreThoseOfTheDocumentation) {
    std::map<std::string, std::set<std::string>> known;
    for (const auto& [section, keys] : all_sections())
        known[std::string(section)] = {keys.begin(), keys.end()};
    EXPECT_EQ(documented(), known);
    EXPECT_GT(known.size(), 10U);
}

}  // namespace
}  // namespace signum
