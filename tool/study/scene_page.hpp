#pragma once
/// A run of a scene as a page that needs nothing beside it: what the scene is, its film, curves, a
/// table of the run, and the run's own checks.

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../scenes/checks.hpp"
#include "../scenes/pair_correlation.hpp"
#include "../scenes/run_record.hpp"
#include "plot.hpp"

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

struct ScenePage {
    SceneDescription scene;
    std::string film;                 ///< SVG
    std::vector<std::string> curves;  ///< see inline_svg()
    /// Why there are no curves, where there are none.
    std::string without_curves;
    std::vector<std::pair<std::string, std::string>> run;  ///< names and values
    std::vector<Check> checks;
};

/// Texts may hold any characters; film and curves are taken as they are.
[[nodiscard]] std::string html_of(const ScenePage& page);

}  // namespace signum::study
