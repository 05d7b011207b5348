#pragma once
/// How a number of an effect is described: its name, what it measures, which numbers are allowed,
/// and what to say of it. Each effect describes its fields beside them (effects.hpp), and whoever
/// reads, writes or checks effects takes them from there.

#include <limits>
#include <optional>
#include <string_view>

namespace signum::motion {

/// The powers of what is measured.
struct Dimension {
    int length = 0;  ///< in metres, say
    int time = 0;    ///< in seconds
    int mass = 0;    ///< in kilograms
    int angle = 0;   ///< in radians
    friend bool operator==(const Dimension&, const Dimension&) = default;
};

/// Those that have names.
namespace dimensions {
inline constexpr Dimension number{};                                    ///< of plain numbers
inline constexpr Dimension length{.length = 1};                         ///< metres
inline constexpr Dimension time{.time = 1};                             ///< seconds
inline constexpr Dimension mass{.mass = 1};                             ///< kilograms
inline constexpr Dimension angle{.angle = 1};                           ///< radians
inline constexpr Dimension speed{.length = 1, .time = -1};              ///< metres a second
inline constexpr Dimension acceleration{.length = 1, .time = -2};       ///< that a second
inline constexpr Dimension rate{.time = -1};                            ///< a second
inline constexpr Dimension angular_speed{.time = -1, .angle = 1};       ///< radians a second
inline constexpr Dimension energy{.length = 2, .time = -2, .mass = 1};  ///< joules
}  // namespace dimensions

/// Which numbers are allowed, and how that is said.
struct Range {
    double least = std::numeric_limits<double>::lowest();  ///< the least one
    double most = std::numeric_limits<double>::max();      ///< the largest one
    bool is_open = false;                                  ///< the least itself is not allowed
    std::string_view words = "a finite number";            ///< behind "give"
    bool is_fine = false;  ///< numbers that are not 0 may be as near to it as doubles are

    /// Whether a number is in it. NaN and infinities are not.
    [[nodiscard]] constexpr bool has(double x) const noexcept {
        return x >= least && x <= most && !(is_open && x == least);
    }
};
inline constexpr Range any_number{};                                ///< all of them
inline constexpr Range from_0{.least = 0.0, .words = "0 or more"};  ///< 0, too
/// Without 0.
inline constexpr Range above_0{.least = 0.0, .is_open = true, .words = "a number above 0"};
/// With both.
inline constexpr Range from_0_to_1{
    .least = 0.0, .most = 1.0, .words = "a number from 0 to 1", .is_fine = true};

/// A number, a vector, a table of numbers or a switch among what acts on balls.
struct Field {
    std::string_view name;         ///< by which files, the tool and Python know it
    Dimension dimension = {};      ///< of each number
    Range range = any_number;      ///< of each number
    std::string_view advice = {};  ///< what to say where it is missing; empty: it may be
    /// The range where a person writes the number, who would not mean all of the other one.
    Range written = range;
    /// Its default in space, where that is another one.
    std::optional<double> in_space = {};

    // Of what an effect is as a whole:
    std::string_view section = "effects";  ///< in which section of a scene it stands
    bool is_always_kept = false;           ///< a state has it, on or off
    std::string_view stepped = {};         ///< what of it needs time steps, where it does
    /// How it is told where it is on, its members in place of {}; what it costs; what is so where
    /// it is off.
    std::string_view told = {};
    std::string_view costs = {};    ///< see told
    std::string_view without = {};  ///< see told
};

/// What describes its members by each_field().
template <class Value>
concept Described = requires {
    Value::each_field([](auto, const Field&) {});
};
/// An effect with members, on or off.
template <class Value>
concept DescribedIfOn = requires(Value value) {
    value.has_value();
}
&&Described<typename Value::value_type>;

}  // namespace signum::motion
