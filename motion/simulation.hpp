#pragma once
/// Balls that move, strike and go on: the log of all strikes in the exact order.
///
/// Law: the log is a function of the balls and the effects alone. Neither the structure that
/// proposes the pairs, nor the order in memory, nor the machine has a part in it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ball.hpp"

namespace signum::motion {

/// A ball as it is at the start, t = 0.
template <int D>
struct Body {
    Vector<D> x{};        ///< centre at t = 0
    Vector<D> v{};        ///< velocity
    double radius = 0.0;  ///< at t = 0
    double mass = 1.0;    ///< above 0
    Spin<D> spin{};       ///< heeded where there is friction
};

/// A meeting that was no strike: of two balls, or of ball `a` and wall -1 - b.
struct Passed {
    std::int32_t a = 0;  ///< a ball
    std::int32_t b = 0;  ///< a ball, or wall -1 - b
    double time = 0.0;   ///< of the meeting
    friend bool operator==(const Passed&, const Passed&) = default;
};

/// Two balls, or ball `a` and wall -1 - b, that stay in contact, and the momenta that they
/// exchanged in the last time step: along the normal towards a, and along their surfaces.
template <int D>
struct StandingContact {
    std::int32_t a = 0;  ///< a ball
    std::int32_t b = 0;  ///< a ball, or wall -1 - b
    double push = 0.0;   ///< along the normal
    Vector<D> rub{};     ///< along the surfaces
    friend bool operator==(const StandingContact&, const StandingContact&) = default;
};

/// A ball that has struck, where balls grow, walls move or strikes have a duration: how often in a
/// row in narrow gaps (docs/motion.md). 2^k is the greatest power of two that is not above that.
struct Pressed {
    std::int32_t ball = 0;      ///< its number
    std::uint32_t strikes = 0;  ///< in a row
    bool by_wall = false;       ///< whether a wall that moves was among what it struck
    double half = 0.0;          ///< time of strike 2^k of the row
    double quarter = 0.0;       ///< time of strike 2^(k-1)
    double last = -std::numeric_limits<double>::infinity();  ///< time of its last strike
    friend bool operator==(const Pressed&, const Pressed&) = default;
};

/// Where a simulation stands: what it needs to go on with the very log it would have had.
template <int D>
struct State {
    /// Nothing is left to do before it.
    double time = 0.0;
    /// In the order of the input, each at its own time.
    std::vector<Ball<D>> balls;
    std::vector<double> masses;  ///< in their order
    /// How many strikes in a row found each ball in place.
    std::vector<std::uint32_t> in_place;
    std::vector<Passed> passed;  ///< meetings that were no strikes
    /// Those of all balls where there is friction, and none otherwise.
    std::vector<Spin<D>> spins = {};
    /// When each ball has struck last, -infinity where it has not, where a contact has a duration;
    /// none otherwise.
    std::vector<double> last_strikes = {};
    std::vector<StandingContact<D>> contacts = {};  ///< that stand
    /// Where there are time steps: 2 k + 1 in step k, counted from 0, 2 k between two steps.
    std::uint64_t half_steps = 0;
    std::vector<Pressed> pressed = {};  ///< in the order of the balls
};

/// What is to be seen of a structure at work, and of the loop over it, at one time. Balls by their
/// numbers.
template <int D>
struct Sketch {
    /// A box.
    struct Area {
        Box<D> box;  ///< where it is
        /// Of cells: 0 the finest, each next one of cells four times as wide.
        int level = 0;
        /// Of segments: whose it is.
        std::int32_t ball = -1;
    };
    /// A disc or a ball.
    struct Round {
        std::int32_t ball = 0;  ///< whose it is
        Vector<D> centre{};     ///< where it is
        double radius = 0.0;    ///< how large
    };
    /// What a ball will strike first, as far as it knows: another one, or wall -1 - partner.
    struct Expected {
        std::int32_t ball = 0;     ///< who expects it
        std::int32_t partner = 0;  ///< whom, or wall -1 - partner
        /// Then or a little later.
        double time = 0.0;
    };
    /// Cells, each once: of cells those in which centres lie, of levels those of the shells'
    /// centres; of segments all balls' boxes, in their order.
    std::vector<Area> areas;
    /// Of lists and levels the balls' shells, in their order; in a periodic box their centres lie
    /// in it.
    std::vector<Round> rounds;
    /// Of lists, levels and segments the pairs they hold, a < b, in order.
    std::vector<std::pair<std::int32_t, std::int32_t>> links;
    /// At most one a ball, in their order; not what is no more to be expected, since the partner
    /// has struck something else.
    std::vector<Expected> expected;
};

/// What is wrong with a ball; what() says it, and what would be right.
class BallError : public std::invalid_argument {
 public:
    /// Of a ball, and what to say of it.
    BallError(std::int64_t ball, const std::string& what)
        : std::invalid_argument(what), ball_(ball) {}
    /// Its number.
    [[nodiscard]] std::int64_t ball() const noexcept { return ball_; }

 private:
    std::int64_t ball_;
};

/// The state of bodies at t = 0. Throws BallError for a number that is not finite or beyond the
/// window of 2^±150, a negative radius, a mass that is not positive, a ball outside its walls or
/// wider than they are apart, one in a periodic box that grows wider than a quarter of it, one of
/// radius 0 where there are segments, and one that overlaps an earlier one; std::invalid_argument
/// for effects that make no sense. O(n) expected, for balls of like sizes.
template <int D>
[[nodiscard]] State<D> start(std::span<const Body<D>> bodies, const Effects<D>& effects);

/// Throws std::invalid_argument for effects that make no sense and BallError for balls that cannot
/// be, as start() does, at any time, with these differences: centres, velocities, spins and times
/// may be up to 2^200, and tiny; and where balls lie is not looked at, for rounding may leave them
/// an ulp inside each other. O(n).
template <int D>
void check(const State<D>& state, const Effects<D>& effects);

/// A line of the log.
struct Strike {
    double time = 0.0;  ///< when
    bool wall = false;  ///< whether b is a wall
    /// Numbers of balls, a < b; or of a ball and a wall.
    std::int32_t a = 0;
    std::int32_t b = 0;  ///< see a
    /// The momentum exchanged along the normal; 0 where nobody asked for it.
    double impulse = 0.0;
    friend bool operator==(const Strike&, const Strike&) = default;
};

/// What a run has done.
struct Counts {
    std::uint64_t strikes = 0;  ///< that were done
    /// Pairs that were asked when they meet.
    std::uint64_t checks = 0;
    /// Events of the structure.
    std::uint64_t own = 0;
    /// Of the pairs asked, those at events of the structure.
    std::uint64_t own_checks = 0;
    /// Events whose partner had struck something else.
    std::uint64_t stale = 0;
    /// Meeting times told by double-doubles, and by rationals.
    std::uint64_t refined = 0;
    std::uint64_t exact = 0;  ///< by rationals
    /// Coordinates and strikes rounded by double-doubles, and by rationals.
    std::uint64_t rounded = 0;
    std::uint64_t rounded_exactly = 0;  ///< by rationals
    /// The sum of (1+e) μ |V·D| over all strikes of two balls.
    double virial = 0.0;
    /// Balls whose velocity was found anew at a time step.
    std::uint64_t predictions = 0;
    /// Contacts that began to stand, and that ended.
    std::uint64_t joins = 0;
    std::uint64_t breaks = 0;  ///< of contacts that stood
    /// Of the reactions of standing contacts, the largest one of all steps (contact_forces.hpp),
    /// and in how many steps it stayed above the tolerance.
    double residual = 0.0;
    std::uint64_t unsolved = 0;  ///< steps
};

/// How far to go.
struct Limits {
    /// Events at that time are included, but those that kicks between two time steps bring about at
    /// once: they come when the next step has begun.
    double until = std::numeric_limits<double>::infinity();
    /// Strikes from now on.
    std::uint64_t strikes = std::numeric_limits<std::uint64_t>::max();
    /// Asked now and then, if there is one: whether to stop.
    std::function<bool()> stop = {};
};

/// Why a run ended: the time came, the strikes are done, nothing meets any more, it was stopped, or
/// balls strike without end (docs/motion.md, "A collapse").
enum class Ending { until, strikes, nothing, stopped, collapse };

/// How a run ended, and of a collapse which balls (or ball and wall) struck last.
struct Outcome {
    Ending ending = Ending::until;  ///< why it ended
    Strike last;                    ///< the last strike
};

/// What proposes pairs; automatic chooses one of the others.
enum class Structure { automatic, pairs, cells, tree, segments, levels, lists, delaunay };
/// What is known of a structure without using it.
struct StructureTraits {
    Structure structure;           ///< whose row this is
    std::string_view name;         ///< in files and on the command line
    std::string_view shapes = {};  ///< what the areas and rounds of a sketch are
    std::string_view links = {};   ///< what its links are
};
/// A row for every structure, in the order of the enumerators.
inline constexpr std::array<StructureTraits, 8> structure_table = {{
    {Structure::automatic, "auto"},
    {Structure::pairs, "pairs"},
    {Structure::cells, "cells", "cells with balls in them"},
    {Structure::tree, "tree", "cells with balls in them"},
    {Structure::segments, "segments", "boxes", "partners, whose boxes overlap"},
    {Structure::levels, "levels", "shells, and the cells in which they lie, a colour a size",
     "pairs in the lists"},
    {Structure::lists, "lists", "shells", "pairs in the lists"},
    {Structure::delaunay, "delaunay", "", "neighbours"},
}};
/// In the order of the table.
inline constexpr auto all_structures = [] {
    std::array<Structure, structure_table.size()> structures{};
    for (std::size_t i = 0; i < structures.size(); ++i)
        structures[i] = structure_table[i].structure;
    return structures;
}();
/// The one of that name, if there is one.
[[nodiscard]] constexpr std::optional<Structure> structure_named(std::string_view name) noexcept {
    for (const StructureTraits& row : structure_table)
        if (row.name == name) return row.structure;
    return std::nullopt;
}
/// The name by which files and the tool know it.
[[nodiscard]] std::string_view name_of(Structure structure) noexcept;

/// How to simulate; the log depends on neither, but where the kernel rounds.
struct Options {
    Structure structure = Structure::automatic;  ///< what proposes pairs
    Kernel kernel = Kernel::exact;               ///< what decides
};

/// A structure that can be used, and why it is that one.
struct Choice {
    Structure structure;  ///< never automatic
    std::string why;      ///< a sentence
};
/// What is chosen for a wish, which is followed where the structure can do it.
template <int D>
[[nodiscard]] Choice choose(Structure wish, const State<D>& state, const Effects<D>& effects);

/// The balls of one simulation.
template <int D>
class Simulation {
 public:
    /// Preconditions: as start() sees to; of a later state, that it comes from state(), with the
    /// same effects. Throws as check() does.
    Simulation(const State<D>& state, const Effects<D>& effects, const Options& options = {});
    ~Simulation();
    /// What was moved from may only be destroyed or given a new value.
    Simulation(Simulation&&) noexcept;
    /// Likewise.
    Simulation& operator=(Simulation&&) noexcept;

    /// Called with each strike, right before it is done. Neither this nor `stop` may call run().
    /// What one of them throws run() throws, and nothing is lost: the next run begins with the
    /// strike that was being told, or where it was asked to stop.
    using Record = std::function<void(const Strike&)>;
    /// Goes on as far as the limits say, not back: nothing happens where `until` is over. Balls in
    /// a periodic box that never meet fly for ever where there is no limit, and so do more than
    /// 2^17 without a box. Throws std::invalid_argument for a time that is NaN, std::range_error
    /// where a ball flies so fast, or so late, or is so small, that the clock cannot tell its
    /// strike from a miss; who goes on after that gets no promise, and whoever is left by
    /// std::bad_alloc may only be destroyed or given a new value. O(1) expected a strike for lists
    /// and cells in a gas.
    Outcome run(const Limits& limits, const Record& record = {});

    /// Where it stands, to be kept or gone on from. O(n).
    [[nodiscard]] State<D> state() const;
    /// What was done up to now.
    [[nodiscard]] const Counts& counts() const;
    /// For pictures: nothing of it is kept while the simulation runs. O(n log n), and the links.
    [[nodiscard]] Sketch<D> sketch() const;

    class Engine;

 private:
    std::unique_ptr<Engine> engine_;
};

}  // namespace signum::motion
