#pragma once
/// A call of signum voronoi as it was typed.

#include <optional>
#include <vector>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

struct VoronoiCall : SitesCall, OutputsCall {
    std::vector<double> clip;
    std::optional<double> tolerance;
    bool merge = false;
    bool carry = false;
};

}  // namespace signum::cli
