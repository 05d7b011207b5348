#pragma once
/// Moving balls as an animated SVG that a browser plays, over and over.

#include <array>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace signum {

/// Collects frames, and writes them all at the end.
///
/// Laws:
///  1. Same frames: the same bytes.
///  2. A browser bears it: of more than `most_balls` balls the smallest are left out, and, where
///     cells are shown, those that are far from the middle in the first frame, so that the cells of
///     the others lie side by side; of more than `most_frames` frames every second one, and again;
///     shapes of balls that are left out are, too, and of more than `most_shapes` of one kind in a
///     frame the last ones; the legend says so.
///  3. Shapes lie under the balls, and are those of the nearest frame; a shape of several frames in
///     a row is written once.
///  4. The border of two balls that had none in the frame before is marked as new, for half a
///     second of the movie and for a frame at least. A border too short to be seen is none.
///  5. In a periodic movie a ball across a side is seen on both.
class Movie {
 public:
    static constexpr std::size_t most_balls = 600;
    static constexpr std::size_t most_frames = 240;
    /// As cells have six borders on the average, all those of `most_balls` are drawn.
    static constexpr std::size_t most_shapes = 4000;

    struct Ball {
        double x = 0.0;
        double y = 0.0;
        double depth = 0.0;  ///< from 0, near, to 1
    };

    /// A straight part of the border between two balls' cells, a < b, or a == b where a periodic
    /// world makes a ball its own neighbour.
    struct Border {
        std::size_t a = 0;
        std::size_t b = 0;
        std::array<double, 2> from{};
        std::array<double, 2> to{};
    };

    /// What else is to be seen in a frame: outlines, borders of cells, and lines between balls, by
    /// their numbers. In a periodic movie lines across more than half of what is shown are left
    /// out.
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
        std::vector<Border> borders;
        std::vector<std::pair<std::size_t, std::size_t>> links;
        std::vector<std::pair<std::size_t, std::size_t>> expected;
    };
    /// What the legend says of them; nothing of a kind that is not there.
    struct Meaning {
        std::string outlines{};
        std::string links{};
        std::string expected{};
        std::string borders{};
        std::string new_borders{};
    };

    /// A line or a circle that balls do not cross, and where it has gone at a time.
    struct Wall {
        std::vector<std::array<double, 2>> points{};  ///< of a line; empty for a circle
        std::array<double, 2> centre{};
        double radius = 0.0;
        std::function<std::array<double, 2>(double)> shift{};  ///< empty where it rests
    };

    /// The radii of all balls, and the corners of what is shown. `periodic`: balls leave on one
    /// side and come in on the other, so that what lies between two frames is not shown.
    Movie(std::vector<double> radii, std::array<double, 2> low, std::array<double, 2> high,
          bool periodic);

    /// Whether the next frame is one that is kept, as far as is known: of another one no shapes are
    /// needed.
    [[nodiscard]] bool keeps_next() const noexcept { return added_ % every_ == 0; }
    /// Seen in all frames, under the balls.
    void add_wall(Wall wall) { walls_.push_back(std::move(wall)); }
    /// A ball for each radius; `growth` is by how much all radii have grown.
    void add(double time, const std::vector<Ball>& balls, const Shapes& shapes = {},
             double growth = 1.0);
    /// `title` stands in the legend.
    void write(std::ostream& out, const std::string& title, const Meaning& meaning) const;

 private:
    /// Kinds of shapes: outlines by their levels from the highest on, borders and those that are
    /// new, links, what is expected.
    static constexpr std::size_t most_levels = 4;
    enum Kind : std::size_t {
        finest = most_levels - 1,
        borders,
        new_borders,
        links,
        expected,
        kinds
    };
    /// Shapes of a frame, as data of paths.
    using Paths = std::vector<std::string>;
    /// Of each kind, and between whom borders lie, those left out, too.
    struct Drawn {
        std::array<Paths, kinds> paths;
        std::vector<std::pair<std::size_t, std::size_t>> neighbours;
    };

    /// Which balls are shown, by the first frame.
    void choose(const std::vector<Ball>& balls, const Shapes& shapes);
    [[nodiscard]] Drawn drawn(const std::vector<Ball>& balls, const Shapes& shapes);
    static void mark_new_borders(std::vector<Drawn>& frames);
    [[nodiscard]] bool is_shown(int ball) const;
    void write_shapes(std::ostream& out, std::span<const Drawn> frames, std::size_t kind) const;
    void write_walls(std::ostream& out) const;
    /// In pixels.
    [[nodiscard]] double drawn_radius(std::size_t ball) const;
    /// By how many pixels the copies of the k-th ball shown are shifted that are seen in a frame.
    [[nodiscard]] std::vector<std::array<double, 2>> copies_of(std::size_t k) const;
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
    std::vector<double> growths_;
    std::vector<Wall> walls_;
    std::vector<std::vector<Ball>> frames_;  // of the balls shown
    std::vector<bool> is_shown_;
    std::vector<Drawn> shapes_;
    bool shows_middle_ = false;
    bool leaves_out_shapes_ = false;
};

}  // namespace signum
