#pragma once
/// What is said of a simulation when it is over: statistics, and a page.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../motion/simulation.hpp"
#include "../io/motion_state.hpp"
#include "../scenes/pair_correlation.hpp"
#include "../scenes/run_record.hpp"
#include "../study/scene_page.hpp"

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

/// The page of a run, as HTML; without curves where gnuplot is not there, which the page says.
/// Throws MachineError where it fails.
template <int D>
[[nodiscard]] std::string page_of_run(const study::SceneDescription& scene, std::string film,
                                      const RunRecord<D>& record,
                                      std::vector<PairCorrelation::Shell> pairs,
                                      const Summary<D>& summary);

}  // namespace signum::cli
