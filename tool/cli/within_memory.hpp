#pragma once
/// signum triangulate --memory: sites that are read slice by slice, into faces that are written as
/// they come.

#include <cstdint>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

/// Adds --memory; `memory` is empty where it is not given.
void add_memory(CLI::App& command, std::string& memory);

/// Precondition: the call has no option but those of add_sites() and --memory. Throws CallError
/// where the file, or what is to be written, cannot be had slice by slice.
void triangulate_within(const std::string& memory, const SitesCall& call,
                        std::span<const Target> targets);

}  // namespace signum::cli
