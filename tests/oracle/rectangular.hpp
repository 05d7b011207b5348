#pragma once
/// Brute force for the supremum and the Manhattan metric: every square that three sites pin,
/// against every other site, in rationals with the infinitesimals of the tie rule.

#include <signum/core/site.hpp>

#include "oracle/oracle.hpp"

#include <span>

namespace signum::oracle {

Tessellation supremum(std::span<const signum::Site> sites);
Tessellation manhattan(std::span<const signum::Site> sites);

}  // namespace signum::oracle
