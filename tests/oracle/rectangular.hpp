#pragma once
/// Brute force for the supremum and the Manhattan metric: every square that three sites pin,
/// against every other site, in rationals with the infinitesimals of the tie rule.

#include "../../core/site.hpp"

#include "oracle.hpp"

#include <span>

namespace signum::oracle {

/// `ranks` are places in the order of ties, where that is to be another than the rule's.
Tessellation supremum(std::span<const signum::Site> sites, const Ranks& ranks = {});
Tessellation manhattan(std::span<const signum::Site> sites, const Ranks& ranks = {});

}  // namespace signum::oracle
