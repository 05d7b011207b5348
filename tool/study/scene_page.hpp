#pragma once
/// A run of a scene as a page that needs nothing beside it: what the scene is, its film, curves, a
/// table of the run, and the run's own checks.

#include <span>
#include <string>
#include <vector>

#include "../scenes/checks.hpp"
#include "../scenes/pair_correlation.hpp"
#include "../scenes/run_record.hpp"
#include "plot.hpp"
#include "template.hpp"

namespace signum::study {

/// What a scene says of itself; empty where balls come from a file of nothing else.
struct SceneDescription {
    std::string title;
    std::string explanation;  ///< lines, as explain() writes them
    /// The names of units, for axes; empty for plain numbers.
    std::string length;
    std::string time;
    std::string energy;
};

/// What the curves are drawn from.
struct SceneCurves {
    std::span<const Moment> moments;
    bool has_spin = false;
    bool has_height = false;
    bool has_growth = false;
    /// Empty where it is not told.
    std::vector<PairCorrelation::Shell> pairs;
};
/// Energies and strikes over time; g(r) and packing where they are there. Of more than 500 moments
/// every second one, and so on. None of fewer than two.
[[nodiscard]] std::vector<Plot> plots_of_scene(const SceneDescription& scene,
                                               const SceneCurves& curves);

/// `values`: the film and the curves (see inline_svg()), or why there are none, `without_curves`,
/// and the lines of the table of the run. Texts of the scene and of checks may hold any characters.
[[nodiscard]] std::string scene_page(const SceneDescription& scene,
                                     const std::vector<Check>& checks, Values values);

}  // namespace signum::study
