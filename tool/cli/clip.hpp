#pragma once
/// The option --clip: a box, and what is wrong with one.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "../../voronoi/clip.hpp"
#include "../../voronoi/space/cells.hpp"

#include "outputs.hpp"

namespace signum::cli {

/// Adds the option, which is empty when it is not given; `in_space`: for a subcommand that takes
/// sites of space, too: four numbers or six.
void add_clip(CLI::App& command, std::vector<double>& clip, const std::string& description,
              bool in_space = false);

/// Throws CallError where numbers are given and there are not `count` of them, those of a box
/// around the sites of `input`.
void require_numbers(const std::vector<double>& clip, std::size_t count, const std::string& input);

/// Nothing without numbers. Throws CallError where the six are no box.
std::optional<Box3> box_in_space_of(const std::vector<double>& clip);

/// Throws CallError where the four numbers are no box, or one that a picture among `targets` could
/// not show.
std::optional<Box> box_of(const std::vector<double>& clip, std::span<const Target> targets);

/// Throws CallError where doubles cannot compute with the box.
void require_fit(const Box& box, const Voronoi& diagram);

}  // namespace signum::cli
