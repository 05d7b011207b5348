#pragma once
/// Moving balls from a text file; the format is described in docs/motion.md.
///
/// Laws: as of read_sites().

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "errors.hpp"

namespace signum {

/// A ball in the plane (third coordinates 0) or in space.
struct BallLine {
    std::array<double, 3> x{};
    std::array<double, 3> v{};
    double radius = 0.0;
    double mass = 0.0;
    Position position;  ///< where its line begins
};

struct BallsFile {
    int dimension = 2;
    std::vector<BallLine> balls;
    /// What was left out, in a sentence, or empty.
    std::string note;
};

/// The mass of a ball without one: radius^dimension, rounded to nearest. Precondition: the result
/// is a normal double. O(1).
[[nodiscard]] double mass_of_radius(double radius, int dimension);

/// Reads the file `path`, or standard input for "-": lines x y r vx vy [mass] or
/// x y z r vx vy vz [mass], told apart by their number of columns or by the names of a header
/// (x, y, z, r or radius, vx, vy, vz, m or mass; others are left out). A mass that is missing is
/// the radius to the power of the dimension, rounded to nearest. Throws InputError and
/// MachineError. O(bytes).
[[nodiscard]] BallsFile read_balls(const std::string& path);

}  // namespace signum
