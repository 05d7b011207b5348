#pragma once
/// Whether what a peer built is right.

#include <string>

#include "../voronoi/contacts.hpp"

#include "peer_run.hpp"

namespace signum::benchmarks {

/// What signum says of it: right, or how many edges no choice of ties has, or how many are missing.
/// `contact` is that of `known`, the canonical tessellation of the same sites.
[[nodiscard]] std::string judge(const Outcome& outcome, const Canonical& known,
                                const Contacts& contact);

}  // namespace signum::benchmarks
