#pragma once
/// The balls of a scene, group by group: from files, from lists, or made.

#include <cstddef>
#include <string>
#include <vector>

#include "../../motion/simulation.hpp"
#include "section.hpp"

namespace signum {

/// Balls in the order of the file, and who said them.
template <int D>
struct BallsOfScene {
    struct Origin {
        std::size_t first = 0;  ///< this and all up to the next origin's
        ScenePlace place;
        bool is_made = false;      ///< by a group that tells their number
        bool is_of_state = false;  ///< of a file without lines
        /// Of balls from another file where each is.
        std::vector<Position> lines = {};
    };
    std::vector<motion::Body<D>> bodies;
    std::vector<Origin> origins;
    std::vector<std::string> files;
    std::vector<std::string> notes;

    /// Throws at the place where the ball is said.
    [[noreturn]] void fail(std::size_t ball, std::string_view message) const;
};

/// Reads [balls] or all [[balls]]. Throws as Document::fail, and InputError in files of balls.
template <int D>
[[nodiscard]] BallsOfScene<D> read_groups(const Section& file, const motion::Effects<D>& effects);

/// 2 or 3, where a group tells it: by a region, by the length of its lines, by its file; else 0.
[[nodiscard]] int dimension_of_groups(const Section& file);

}  // namespace signum
