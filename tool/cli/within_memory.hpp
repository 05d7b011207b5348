#pragma once
/// signum triangulate --memory: sites that are read slice by slice, into faces that are written as
/// they come. With --resume, a call that is cut off leaves pieces of its work to the next one.

#include <cstdint>
#include <span>
#include <string>

#include <CLI/CLI.hpp>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

struct MemoryCall {
    std::string memory;  ///< empty where it is not given
    bool resume = false;
};

/// Adds --memory and --resume.
void add_memory(CLI::App& command, MemoryCall& call);

/// Precondition: the call has no option but those of add_sites(), --memory and --resume. Throws
/// CallError where the file, or what is to be written, cannot be had slice by slice, and where
/// there are pieces of another call.
void triangulate_within(const MemoryCall& memory, const SitesCall& call,
                        std::span<const Target> targets);

}  // namespace signum::cli
