#pragma once
/// The sites of a cell, and its contestants by name. For the sources of study/.

#include <optional>
#include <string>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "plan.hpp"

namespace signum::study {

/// The sites of one set; `seed` counts from 1.
[[nodiscard]] std::vector<Site> sites_of(const Setting& setting, std::size_t seed);

[[nodiscard]] std::vector<Site3> sites_in_space_of(const Setting& setting, std::size_t seed);

/// How the contestant of that name builds: with an arithmetic, or exactly by a method. On one
/// thread, for so do those that round.
[[nodiscard]] std::optional<Options> options_named(const std::string& name);

}  // namespace signum::study
