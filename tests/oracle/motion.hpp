#pragma once
/// Brute force for balls that move and strike: every meeting of two by Sturm's theorem on the exact
/// polynomial of their gap, every strike in rationals, every double rounded by comparing.
///
/// The rule, and how it is read here where it leaves something open:
///
/// A meeting is the least t >= T (the latest own time) at which the gap F is at most 0 and strictly
/// decreasing immediately afterwards, rounded to nearest. What rounds to infinity is never.
/// - A wall whose n is one coordinate alone, +1 or -1, has F = s - r, whatever its kind; `side`
///   demands such an n. A ball without radius has F = s, too: s² would only touch 0, never cross
///   it.
/// - In a periodic box there are no walls, and `until` is finite.
///
/// A strike rounds the state at its time once, then the new velocities once.
/// - It is none when the two do not approach in these doubles or when no velocity changes. That
///   meeting is then passed over until one of them has struck something else (in a periodic box the
///   meetings of other images come later).
/// - But where a ball and a wall are about to be left alone while F'' < 0 at that time, the wall
///   would be left behind: the run ends with a collapse, nothing is changed and nothing logged.
///   This is read to hold for both reasons to leave alone.
/// - In a periodic box D gets the shift that brings every component into [-L/2, L/2).
/// - The impulse at a circle is (1 + e) m |(v - u)·n| / |n|, as at the other walls.
/// - A strike finds a ball in place where it has flown, along the normal and at the speed of the
///   strike, at most 2^-40 of the largest of its coordinates and radius since its last strike, or
///   where that strike is at most 2^-45 of the time ago. A ball's 1000th strike in a row of this
///   kind (100 000th where restitution is 1 and there is no gravity) is logged and ends the run
///   with a collapse.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace signum::oracle::motion {

/// In the plane every third coordinate is 0. The radius at time t is r + growth·t.
struct Ball {
    std::array<double, 3> x{}, v{};
    double r = 0, m = 1;
    double t0 = 0;
    double growth = 0;
    bool operator==(const Ball&) const = default;
};

struct Wall {
    enum class Kind { side, half_space, outside, inside } kind = Kind::side;
    std::array<double, 3> n{};  // side, half_space: n·x >= c + w t
    double c = 0, w = 0;
    std::array<double, 3> centre{}, u{};  // outside, inside
    double radius = 0;
};

struct World {
    int dimension = 2;
    std::array<double, 3> g{};
    double restitution = 1, wall_restitution = 1;
    std::vector<Wall> walls;
    bool periodic = false;
    std::array<double, 3> low{}, high{};  // of the periodic box
};

/// The sides of a box: left, right, bottom, top, near, far.
std::vector<Wall> box_walls(const std::array<double, 3>& low, const std::array<double, 3>& high,
                            int dimension);

struct Strike {
    double time;
    bool wall;
    int a, b;  // a < b, or a ball and a wall
    double impulse;
    bool operator==(const Strike&) const = default;
};

struct Run {
    std::vector<Strike> log;
    bool collapsed = false;
    std::vector<Ball> balls;  // each at its own time
};

/// Meetings later than `until` are none.
std::optional<double> meeting_time(const Ball& a, const Ball& b, const World& world,
                                   double until = std::numeric_limits<double>::infinity());
std::optional<double> meeting_time(const Ball& ball, const Wall& wall, const World& world,
                                   double until = std::numeric_limits<double>::infinity());

/// Throws std::invalid_argument for radii that grow, std::overflow_error for a state or an impulse
/// beyond the doubles.
Run simulate(std::vector<Ball> balls, const World& world, double until, std::size_t most);

/// The doubles nearest to p / q and to p / sqrt(q), p >= 0 and q > 0, halves to even:
/// what this oracle rounds with, for its tests.
double nearest_quotient(double p, double q);
double nearest_quotient_by_root(double p, double q);

}  // namespace signum::oracle::motion
