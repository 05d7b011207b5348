#pragma once
/// The page of a run of signum simulate.

#include <string>
#include <vector>

#include "../scenes/pair_correlation.hpp"
#include "../scenes/run_record.hpp"
#include "../study/scene_page.hpp"

#include "motion_summary.hpp"

namespace signum::cli {

/// As HTML; without curves where gnuplot is not there, which the page says. Throws MachineError
/// where it fails.
template <int D>
[[nodiscard]] std::string page_of_run(const study::SceneDescription& scene, std::string film,
                                      const RunRecord<D>& record,
                                      std::vector<PairCorrelation::Shell> pairs,
                                      const Summary<D>& summary);

}  // namespace signum::cli
