#pragma once
/// A peer's construction in a process of its own: its time and memory are no one else's, and it may
/// crash.
///
/// Such a process reads the sites from standard input, x, y and r as doubles, and writes as bytes
/// to standard output: seconds and bytes of the construction as doubles; the number of faces as a
/// double, the faces as 32-bit integers; neighbours likewise, or 0.

#include <optional>
#include <string>
#include <vector>

#include "construction.hpp"

namespace signum::benchmarks {

struct Outcome {
    double seconds = 0.0;
    double peak_bytes = 0.0;  ///< resident memory beyond what was there before
    std::vector<Face> faces;
    std::vector<Face> neighbours;
};

/// No construction takes longer, reading and writing included.
inline constexpr unsigned most_seconds = 30;

/// Runs a command, a program and its arguments; nothing where it failed or took too long. Faces at
/// infinity are added where there are none.
[[nodiscard]] std::optional<Outcome> run(const std::vector<std::string>& command,
                                         const std::vector<Site>& sites);

/// The part of such a process. Returns its exit status.
[[nodiscard]] int attempt(const Prepare& prepare);

}  // namespace signum::benchmarks
