#pragma once
/// What a simulation leaves behind: its log, its closest pairs, and frames of it.

#include <array>
#include <iosfwd>
#include <span>

#include "../../motion/queries.hpp"
#include "../../motion/simulation.hpp"
#include "text_writer.hpp"

namespace signum {

/// The log as CSV, a strike a line: time,kind,a,b,impulse, in the order in which they happen.
class LogWriter {
 public:
    /// Writes the header.
    explicit LogWriter(std::ostream& out);
    void put(const motion::Strike& strike);
    /// To be called at the end.
    void finish() { text_.flush(); }

 private:
    TextWriter text_;
};

/// The list of closest pairs as CSV: time,a,b,gap.
void write_closest(std::ostream& out, std::span<const motion::ClosestPair> list);

/// Where the balls are at one time.
struct MotionFrame {
    double time = 0.0;
    int dimension = 2;
    bool periodic = false;
    /// The corners of the box, or of what the frame shows.
    std::array<double, 3> low{};
    std::array<double, 3> high{};
    struct Ball {
        std::array<double, 3> x{};
        std::array<double, 3> v{};
        double radius = 0.0;
    };
    std::span<const Ball> balls;
};

/// A frame in extended XYZ, which OVITO, VMD and ASE read; of the plane z is 0.
void write_xyz(std::ostream& out, const MotionFrame& frame);

}  // namespace signum
