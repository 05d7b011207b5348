#pragma once
/// Moving balls as an animated SVG that a browser plays, over and over.

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace signum {

/// Collects frames, and writes them all at the end.
///
/// Laws:
///  1. Same frames: the same bytes.
///  2. A browser bears it: of more than `most_balls` balls the smallest are left out, of more than
///     `most_frames` frames every second one, and again; the legend says so.
class Movie {
 public:
    static constexpr std::size_t most_balls = 600;
    static constexpr std::size_t most_frames = 240;

    struct Ball {
        double x = 0.0;
        double y = 0.0;
        double depth = 0.0;  ///< from 0, near, to 1
    };

    /// The radii of all balls, and the corners of what is shown. `periodic`: balls leave on one
    /// side and come in on the other, so that what lies between two frames is not shown.
    Movie(std::vector<double> radii, std::array<double, 2> low, std::array<double, 2> high,
          bool periodic);

    /// A ball for each radius.
    void add(double time, const std::vector<Ball>& balls);
    /// `title` stands in the legend.
    void write(std::ostream& out, const std::string& title) const;

 private:
    std::vector<double> radii_;
    std::array<double, 2> low_;
    std::array<double, 2> high_;
    bool periodic_;
    std::vector<std::size_t> shown_;  // numbers of balls, far ones first
    std::size_t every_ = 1;
    std::size_t added_ = 0;
    std::vector<double> times_;
    std::vector<std::vector<Ball>> frames_;  // of the balls shown
};

}  // namespace signum
