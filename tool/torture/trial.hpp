#pragma once
/// The trial of a plugin: it is asked in processes of their own, so that one that crashes or hangs
/// takes nothing along. Loading it, and its --init, run in the tool itself.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "own_points.hpp"
#include "plugin.hpp"

namespace signum::torture {

/// What the signs of a function mean.
enum class Convention : std::uint8_t {
    unknown,          ///< its answers fit none of those below
    shewchuk,         ///< his
    opposite,         ///< his, with the other sign
    bounded,          ///< inside and outside, whichever way the points turn
    bounded_opposite  ///< the same with the other sign
};
[[nodiscard]] std::string_view name_of(Convention convention) noexcept;

struct Example {
    Question question;
    double said;  ///< by the plugin
    Sign right;   ///< in its convention
};
/// Of one function and one family.
struct Count {
    std::uint64_t asked = 0;
    std::uint64_t wrong = 0;
    std::uint64_t not_a_number = 0;  ///< of these
};
/// A call that did not come back.
struct Lost {
    Question question;
    std::size_t family;
    int signal;  ///< that ended it; 0 where it went on for too long
};
struct Trial {
    bool is_there = false;
    Convention convention = Convention::unknown;
    std::vector<Count> counts;  ///< a family each
    std::optional<Example> smallest;
    std::vector<Lost> lost;
    /// The signs of 256 x 256 neighbours, row by row from below: said and right; of orient2d and
    /// incircle, empty where the plugin did not come back.
    std::vector<std::int8_t> said;
    std::vector<std::int8_t> right;
    [[nodiscard]] std::uint64_t asked() const noexcept;
    [[nodiscard]] std::uint64_t wrong() const noexcept;
    [[nodiscard]] bool is_faultless() const noexcept;
};

struct Options {
    double seconds = 60.0;
    double patience = 2.0;  ///< how long a call may take before it counts as lost, in seconds
    std::uint64_t seed = 1;
    std::vector<OwnPoints> own;            ///< of which the functions are asked, too
    std::function<void(double)> progress;  ///< the share that is done
};

inline constexpr int picture_side = 256;

/// The points of a picture: Kettner's for orient2d, of a rectangle for incircle; the moving point
/// is the first one.
[[nodiscard]] Question question_of_picture(Asked asked, int column, int row);

/// A trial of each function. Throws MachineError where no process can be made.
[[nodiscard]] std::array<Trial, functions> torture(const Plugin& plugin, const Options& options);

}  // namespace signum::torture
