#pragma once
/// A scene: what moves, what acts on it, how far to go and what to record.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "../../motion/simulation.hpp"
#include "../io/errors.hpp"
#include "units.hpp"

namespace signum {

/// What the command line says instead of a key of the file: its TOML, and the option as it was
/// typed, for messages.
struct Override {
    std::string option;  ///< "--set effects.restitution=0.8"
    std::string toml;    ///< "effects.restitution = 0.8"
};

/// An option that sets a key is wrong; what() begins with the option and says what would be right.
class OverrideError : public ShownError {
 public:
    using ShownError::ShownError;
};

/// Where something of a scene is said: in its file, or in an option.
struct ScenePlace {
    std::string file;  ///< empty where an option says it
    Position position;
    std::string option;
    /// Throws InputError or OverrideError.
    [[noreturn]] void fail(std::string_view message) const;
};

/// How far a run goes, and how.
struct SceneRun {
    std::optional<double> until;
    std::optional<std::uint64_t> events;
    motion::Structure structure = motion::Structure::automatic;
    motion::Kernel kernel = motion::Kernel::exact;
};

/// What is written, by the names of files; empty is nothing.
struct SceneRecord {
    std::optional<double> every;
    std::string log;
    std::string frames;
    std::string film;
    std::string energies;
    std::string pair_correlation;
    std::string images;
    std::string video;
    std::string page;
    std::string state;
};

template <int D>
struct Scene {
    std::string title;
    Units units;
    motion::Effects<D> effects;
    motion::State<D> start;
    SceneRun run;
    SceneRecord record;
    /// The files that it was read from, itself first.
    std::vector<std::string> files;
    /// What was left out of files of balls, a sentence each.
    std::vector<std::string> notes;
};
using AnyScene = std::variant<Scene<2>, Scene<3>>;

}  // namespace signum
