#pragma once
/// A call of signum compare as it was typed.

#include <string>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

/// SitesCall::arithmetic is the one that is judged.
struct CompareCall : SitesCall, OutputsCall {
    std::string against = "exact";
    double seconds = 1.0;
    bool json = false;
};

}  // namespace signum::cli
