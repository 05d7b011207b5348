#pragma once
/// What is said of a simulation when it is over.

#include <optional>
#include <string>
#include <string_view>

#include "../../motion/simulation.hpp"
#include "../io/motion_state.hpp"

namespace signum::cli {

/// What the statistics tell beside the counts.
template <int D>
struct Summary {
    const MotionState<D>& start;
    const MotionState<D>& end;
    motion::Choice choice;
    motion::Counts counts;
    double seconds = 0.0;
};

/// Z = p V / (N k T) from the virial of the strikes; none under gravity, of no time and of no
/// motion.
template <int D>
[[nodiscard]] std::optional<double> compressibility(const Summary<D>& summary);

/// As JSON, one line.
template <int D>
[[nodiscard]] std::string statistics_of(const Summary<D>& summary);

/// How a run ended.
[[nodiscard]] std::string_view in_words(motion::Ending ending);
/// The last strike of a collapse, and what would let such balls go on, if there is something.
template <int D>
[[nodiscard]] std::string describe_collapse(const motion::Strike& last,
                                            const motion::Effects<D>& effects);

}  // namespace signum::cli
