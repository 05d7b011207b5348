/// What scenes record: pair correlations of points that are known, energies, images, and the
/// numbers behind made balls.

#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../tool/generate/uniform.hpp"
#include "../../tool/io/program.hpp"
#include "../../tool/scenes/arrangement.hpp"
#include "../../tool/scenes/frame_picture.hpp"
#include "../../tool/scenes/normal.hpp"
#include "../../tool/scenes/pair_correlation.hpp"
#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::run;
using test::Scratch;

MotionFrame frame_of(const std::vector<MotionFrame::Ball>& balls, int dimension, double side,
                     bool periodic) {
    MotionFrame frame;
    frame.dimension = dimension;
    frame.periodic = periodic;
    frame.high = {side, side, dimension == 3 ? side : 0.0};
    frame.balls = balls;
    return frame;
}

std::vector<double> column_g(const PairCorrelation& pairs) {
    std::ostringstream text;
    pairs.write(text);
    std::istringstream lines(text.str());
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "r,g");
    std::vector<double> result;
    while (std::getline(lines, line)) result.push_back(std::stod(line.substr(line.find(',') + 1)));
    return result;
}

/// On a lattice of unit squares a ball has four neighbours at 1, four at √2, four at 2.
TEST(PairCorrelation, CountsTheNeighboursOfALattice) {
    for (const bool periodic : {true, false}) {
        std::vector<MotionFrame::Ball> balls;
        for (int i = 0; i < 20; ++i)
            for (int j = 0; j < 20; ++j) balls.push_back({{i + 0.25, j + 0.5, 0}, {}, 0.25});
        const MotionFrame frame = frame_of(balls, 2, 20.0, periodic);
        PairCorrelation pairs(frame);
        pairs.add(frame);
        const std::vector<double> neighbours = pairs.neighbours();
        const double thickness = pairs.thickness();
        double within = 0.0;
        for (std::size_t i = 0; i < neighbours.size(); ++i) {
            const double r = static_cast<double>(i) * thickness;
            within += neighbours[i];
            if (r < 0.9) {
                EXPECT_EQ(within, 0.0) << r;
            }
            if (r > 1.1 && r < 1.3) {
                EXPECT_EQ(within, 4.0) << r;
            }
            if (r > 1.5 && r < 1.9) {
                EXPECT_EQ(within, 8.0) << r;
            }
            if (r > 2.1 && r < 2.2) {
                EXPECT_EQ(within, 12.0) << r;
            }
        }
    }
}

TEST(PairCorrelation, OfRandomPointsIsOne) {
    Uniform uniform(5);
    for (const int dimension : {2, 3}) {
        for (const bool periodic : {true, false}) {
            double sum = 0.0;
            std::size_t count = 0;
            std::vector<double> g;
            std::optional<PairCorrelation> pairs;
            std::vector<MotionFrame::Ball> balls(1000);
            for (int trial = 0; trial < 12; ++trial) {
                for (MotionFrame::Ball& ball : balls)
                    ball.x = {7.0 * uniform(), 7.0 * uniform(),
                              dimension == 3 ? 7.0 * uniform() : 0.0};
                const MotionFrame frame = frame_of(balls, dimension, 7.0, periodic);
                if (!pairs) pairs.emplace(frame);
                pairs->add(frame);
            }
            g = column_g(*pairs);
            for (std::size_t i = g.size() / 2; i < g.size(); ++i, ++count) sum += g[i];
            EXPECT_NEAR(sum / static_cast<double>(count), 1.0, 0.02) << dimension << periodic;
        }
    }
}

TEST(Normal, HasTheMomentsOfTheNormalDistribution) {
    Normal normal(3);
    constexpr int trials = 200'000;
    double moments[5] = {};
    int below_one = 0;
    for (int i = 0; i < trials; ++i) {
        const double x = normal();
        double power = 1.0;
        for (double& moment : moments) {
            moment += power / trials;
            power *= x;
        }
        if (std::fabs(x) < 1.0) ++below_one;
    }
    EXPECT_NEAR(moments[1], 0.0, 0.01);
    EXPECT_NEAR(moments[2], 1.0, 0.02);
    EXPECT_NEAR(moments[3], 0.0, 0.05);
    EXPECT_NEAR(moments[4], 3.0, 0.1);
    EXPECT_NEAR(below_one / static_cast<double>(trials), 0.6826895, 0.005);
}

template <int D>
Region<D> cube(double side, bool periodic) {
    Region<D> region;
    region.volume = 1.0;
    for (int k = 0; k < D; ++k) {
        region.box.high[k] = side;
        region.volume *= side;
    }
    region.periodic = periodic;
    return region;
}

/// motion::start judges exactly whether balls overlap, or stand out of their box.
template <int D>
void expect_apart(const Region<D>& region, const std::vector<double>& radii,
                  const std::vector<motion::Vector<D>>& centres) {
    ASSERT_EQ(radii.size(), centres.size());
    std::vector<motion::Body<D>> bodies;
    for (std::size_t i = 0; i < radii.size(); ++i)
        bodies.push_back({centres[i], {}, radii[i], 1.0});
    motion::Effects<D> effects;
    effects.box = region.box;
    effects.periodic = region.periodic;
    EXPECT_NO_THROW(static_cast<void>(motion::start<D>(bodies, effects)));
}

template <int D>
void places(double random_packing, double lattice_packing) {
    for (const bool periodic : {true, false}) {
        const Region<D> region = cube<D>(20.0, periodic);
        const auto number = [&](double packing) {
            return static_cast<std::size_t>(packing * region.volume /
                                            (motion::ball_volume<D>(1.0) * std::pow(0.5, D)));
        };
        const std::vector<double> some(number(random_packing), 0.5);
        expect_apart<D>(region, some, place_by_chance<D>(region, some, {}, 7));
        EXPECT_EQ(place_by_chance<D>(region, some, {}, 7), place_by_chance<D>(region, some, {}, 7));
        const std::vector<double> many(number(lattice_packing), 0.5);
        expect_apart<D>(region, many, place_on_lattice<D>(region, many, {}));
        EXPECT_THROW(static_cast<void>(
                         place_by_chance<D>(region, std::vector<double>(number(0.7), 0.5), {}, 7)),
                     NoPlaceError);
        EXPECT_THROW(static_cast<void>(
                         place_on_lattice<D>(region, std::vector<double>(number(0.95), 0.5), {})),
                     NoPlaceError);
    }
}

TEST(Arrangement, KeepsBallsApart) {
    places<2>(0.45, 0.82);
    places<3>(0.25, 0.6);
}

TEST(Arrangement, KeepsAwayFromWhatIsThere) {
    const Region<2> region = cube<2>(20.0, false);
    const std::vector<motion::Obstacle<2>> obstacles = {
        motion::Sphere<2>{{10, 10}, {}, 9.0, motion::Sphere<2>::Side::inside},
        motion::HalfSpace<2>{{0, 2}, 12.0, 0.0}, motion::Segment{{10, 0}, {10, 20}}};
    const std::vector<motion::Body<2>> bodies = {{{14, 12}, {}, 2.0, 1.0}};
    const Surroundings<2> surroundings{bodies, obstacles};
    const std::vector<double> radii(60, 0.4);
    for (const auto& centres : {place_by_chance<2>(region, radii, surroundings, 3),
                                place_on_lattice<2>(region, radii, surroundings)}) {
        ASSERT_EQ(centres.size(), radii.size());
        for (const motion::Vector<2>& x : centres) {
            EXPECT_LE(std::hypot(x[0] - 10, x[1] - 10) + 0.4, 9.0);
            EXPECT_GE(x[1] - 0.4, 6.0);
            EXPECT_GE(std::fabs(x[0] - 10), 0.4);
            EXPECT_GE(std::hypot(x[0] - 14, x[1] - 12), 2.4);
        }
    }
}

TEST(Records, EnergiesStayWhereStrikesAreElastic) {
    const Scratch scratch;
    const std::string energies = scratch.path("energies.csv");
    const std::string scene = scratch.file(
        "scene.toml",
        "[box]\nlow = [0, 0]\nhigh = [20, 20]\n[balls]\nnumber = 40\nradius = 0.5\ntemperature = "
        "3\n[effects]\ngravity = [0, -2]\n[run]\nuntil = 4\n[record]\nevery = 0.5\n");
    const test::Outcome result =
        run({"simulate", scene, "--set", "record.energies=\"" + energies + "\"", "--quiet"});
    EXPECT_EQ(result.code, 0) << result.err;
    // Something is recorded, and the log not asked for.
    EXPECT_EQ(result.out, "");
    std::istringstream lines(contents(energies));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "time,kinetic,height,total");
    double first_total = 0.0;
    int count = 0;
    while (std::getline(lines, line)) {
        double time = 0.0;
        double kinetic = 0.0;
        double height = 0.0;
        double total = 0.0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &kinetic, &height, &total),
                  4);
        EXPECT_EQ(time, 0.5 * count);
        if (count++ == 0) {
            first_total = total;
            EXPECT_NEAR(kinetic, 40 * 3.0, 1e-9);
        }
        EXPECT_NEAR(kinetic + height, total, 1e-9);
        EXPECT_NEAR(total, first_total, 1e-9 * first_total);
    }
    EXPECT_EQ(count, 9);
}

/// Below the box, so that it hides no ball.
TEST(Records, APictureTellsItsTime) {
    const std::vector<MotionFrame::Ball> balls = {{{1, 3, 0}, {}, 1.0}};
    MotionFrame frame = frame_of(balls, 2, 4.0, false);
    frame.time = 1.25;
    const std::string square = frame_picture(frame, {}, "ms");
    EXPECT_NE(square.find(">t = 1.25 ms</text>"), std::string::npos);
    // 800 pixels, of which the strip below takes some from the box.
    EXPECT_NE(square.find("width=\"780\" height=\"800\""), std::string::npos);
    EXPECT_NE(square.find("<rect x=\"8.00\" y=\"8.00\" width=\"764.00\" height=\"764.00\"/>"),
              std::string::npos);
    EXPECT_NE(square.find("<text x=\"8\" y=\"792\""), std::string::npos);
    EXPECT_NE(frame_picture(frame, {}, "").find(">t = 1.25</text>"), std::string::npos);
}

TEST(Records, ImagesAreDrawnWhereTheProgramIsThere) {
    const Scratch scratch;
    const std::string scene =
        scratch.file("scene.toml",
                     "[box]\nlow = [0, 0]\nhigh = [9, 4]\n[balls]\nlist = [[2, 2, 1, 1, 0]]\n"
                     "[run]\nuntil = 1\n[record]\nevery = 0.5\nimages = \"" +
                         scratch.path("i-%02d.png") + "\"\n");
    const test::Outcome result = run({"simulate", scene, "--quiet"});
    if (!has_program("rsvg-convert", "--version")) {
        EXPECT_EQ(result.code, 3);
        EXPECT_NE(result.err.find("apt-get install librsvg2-bin"), std::string::npos);
        return;
    }
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(scratch.size(), 4U);
    for (const std::string name : {"i-00.png", "i-01.png", "i-02.png"}) {
        const std::string png = contents(scratch.path(name));
        ASSERT_GT(png.size(), 24U);
        EXPECT_EQ(png.substr(1, 3), "PNG");
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(png[i]); };
        EXPECT_EQ(byte(18) * 256 + byte(19), 800);
        EXPECT_EQ((byte(22) * 256 + byte(23)) % 2, 0);
    }
    EXPECT_NE(contents(scratch.path("i-00.png")), contents(scratch.path("i-02.png")));
}

}  // namespace
}  // namespace signum
