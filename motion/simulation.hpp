#pragma once
/// Balls that move, strike and go on: the log of all strikes in the exact order.
///
/// Law: the log is a function of the balls and the effects alone. Neither the structure that
/// proposes the pairs, nor the order in memory, nor the machine has a part in it.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ball.hpp"

namespace signum::motion {

/// A ball as it is at the start, t = 0.
template <int D>
struct Body {
    Vector<D> x{};
    Vector<D> v{};
    double radius = 0.0;
    double mass = 1.0;
};

/// A line of the log.
struct Strike {
    double time = 0.0;
    bool wall = false;
    /// Numbers of balls, a < b; or of a ball and a wall.
    std::int32_t a = 0;
    std::int32_t b = 0;
    /// The momentum exchanged along the normal; 0 where nobody asked for it.
    double impulse = 0.0;
    friend bool operator==(const Strike&, const Strike&) = default;
};

/// What a run has done.
struct Counts {
    std::uint64_t strikes = 0;
    /// Pairs that were asked when they meet.
    std::uint64_t checks = 0;
    /// Events of the structure.
    std::uint64_t own = 0;
    /// Events whose partner had struck something else.
    std::uint64_t stale = 0;
    /// Meeting times told by double-doubles, and by rationals.
    std::uint64_t refined = 0;
    std::uint64_t exact = 0;
    /// Coordinates and strikes rounded by double-doubles, and by rationals.
    std::uint64_t rounded = 0;
    std::uint64_t rounded_exactly = 0;
    /// The sum of (1+e) μ |V·D| over all strikes of two balls.
    double virial = 0.0;
};

enum class Ending { until, most, nothing, stopped, collapse };

/// How a run ended, and of a collapse which balls (or ball and wall) struck last.
struct Outcome {
    Ending ending = Ending::until;
    Strike last;
};

enum class Kernel { exact, naive };
enum class StructureName { pairs, cells, tree, segments, levels, lists };

struct Options {
    StructureName structure = StructureName::lists;
    Kernel kernel = Kernel::exact;
};

/// The balls of one simulation.
template <int D>
class Simulation {
 public:
    Simulation(std::span<const Body<D>> bodies, const Effects<D>& effects, const Options& options);
    ~Simulation();
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;

    /// Called with each strike.
    using Record = std::function<void(const Strike&)>;
    /// Goes on until a time, or until so many strikes more have happened.
    Outcome run(double until, std::uint64_t most = ~std::uint64_t{0}, const Record& record = {});

    /// The balls in the order of the input, each at its own time.
    [[nodiscard]] std::vector<Ball<D>> balls() const;
    [[nodiscard]] const Counts& counts() const;

    class Engine;

 private:
    std::unique_ptr<Engine> engine_;
};

}  // namespace signum::motion
