#pragma once
/// The option --clip: a box, and what is wrong with one.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "../voronoi/clip.hpp"

#include "outputs.hpp"

namespace signum::cli {

/// Adds the option, which is empty when it is not given.
void add_clip(CLI::App& command, std::vector<double>& clip, const std::string& description);

/// Throws CallError where the four numbers are no box, or one that a picture among `targets` could
/// not show.
std::optional<Box> box_of(const std::vector<double>& clip, std::span<const Target> targets);

/// Throws CallError where doubles cannot compute with the box.
void require_fit(const Box& box, const Voronoi& diagram);

}  // namespace signum::cli
