#pragma once
/// Moving balls as an animated SVG that a browser plays, over and over.

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace signum {

/// Collects frames, and writes them all at the end.
///
/// Laws:
///  1. Same frames: the same bytes.
///  2. A browser bears it: of more than `most_balls` balls the smallest are left out, of more than
///     `most_frames` frames every second one, and again; shapes of balls that are left out are,
///     too, and of more than `most_shapes` of one kind in a frame the last ones; the legend says
///     so.
///  3. Shapes lie under the balls, and are those of the nearest frame; a shape of several frames in
///     a row is written once.
class Movie {
 public:
    static constexpr std::size_t most_balls = 600;
    static constexpr std::size_t most_frames = 240;
    static constexpr std::size_t most_shapes = 2000;

    struct Ball {
        double x = 0.0;
        double y = 0.0;
        double depth = 0.0;  ///< from 0, near, to 1
    };

    /// What else is to be seen in a frame: outlines, and lines between balls, by their numbers. In
    /// a periodic movie lines across more than half of what is shown are left out.
    struct Shapes {
        struct Box {
            std::array<double, 2> low{};
            std::array<double, 2> high{};
            int level = 0;  ///< of another colour, and under those of lower ones
            int ball = -1;  ///< whose it is, if it is a ball's
        };
        struct Round {
            double x = 0.0;
            double y = 0.0;
            double radius = 0.0;
            int ball = -1;
        };
        std::vector<Box> boxes;
        std::vector<Round> rounds;
        std::vector<std::pair<std::size_t, std::size_t>> links;
        std::vector<std::pair<std::size_t, std::size_t>> expected;
    };
    /// What the legend says of them; nothing of a kind that is not there.
    struct Meaning {
        std::string outlines;
        std::string links;
        std::string expected;
    };

    /// The radii of all balls, and the corners of what is shown. `periodic`: balls leave on one
    /// side and come in on the other, so that what lies between two frames is not shown.
    Movie(std::vector<double> radii, std::array<double, 2> low, std::array<double, 2> high,
          bool periodic);

    /// A ball for each radius.
    void add(double time, const std::vector<Ball>& balls, const Shapes& shapes = {});
    /// `title` stands in the legend.
    void write(std::ostream& out, const std::string& title, const Meaning& meaning = {}) const;

 private:
    /// Kinds of shapes: outlines by their levels from the highest on, links, what is expected.
    static constexpr std::size_t most_levels = 4;
    static constexpr std::size_t finest = most_levels - 1;
    static constexpr std::size_t links = most_levels;
    static constexpr std::size_t expected = most_levels + 1;
    /// Of each kind the shapes, as data of paths.
    using Drawn = std::array<std::vector<std::string>, most_levels + 2>;

    [[nodiscard]] Drawn drawn(const std::vector<Ball>& balls, const Shapes& shapes);
    [[nodiscard]] bool is_shown(int ball) const;
    void write_shapes(std::ostream& out, std::size_t kind) const;
    [[nodiscard]] double scale() const;
    [[nodiscard]] double x_of(double x) const;
    [[nodiscard]] double y_of(double y) const;

    std::vector<double> radii_;
    std::array<double, 2> low_;
    std::array<double, 2> high_;
    bool periodic_;
    std::vector<std::size_t> shown_;  // numbers of balls, far ones first
    std::size_t every_ = 1;
    std::size_t added_ = 0;
    std::vector<double> times_;
    std::vector<std::vector<Ball>> frames_;  // of the balls shown
    std::vector<bool> is_shown_;
    std::vector<Drawn> shapes_;
    bool leaves_out_shapes_ = false;
};

}  // namespace signum
