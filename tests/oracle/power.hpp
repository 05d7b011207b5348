#pragma once
/// Brute force for the power metric: the lower hull of the lifted sites, every plane against every
/// site, in rationals with the infinitesimals of the tie rule.

#include "../../core/site.hpp"

#include "oracle.hpp"

#include <span>

namespace signum::oracle {

/// The weight of a site is the exact square of its radius. `ranks` are places in the order of ties,
/// where that is to be another than the rule's.
Tessellation power(std::span<const signum::Site> sites, const Ranks& ranks = {});

/// The sites carry their weights themselves.
Tessellation power_weights(std::span<const signum::power::Site> sites, const Ranks& ranks = {});

}  // namespace signum::oracle
