#pragma once
/// A call of signum triangulate as it was typed.

#include <string>
#include <vector>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

struct TriangulateCall : SitesCall, OutputsCall {
    std::string method = "incremental";
    std::vector<double> clip;
    bool vertices = false;
    bool check = false;
};

}  // namespace signum::cli
