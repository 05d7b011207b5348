#pragma once
/// Sites of space as the library wants them.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/validate.hpp"

#include "commands.hpp"
#include "sites_call.hpp"

namespace signum::cli {

/// What `call` makes of the sites: of balls, or of sites that carry a weight.
template <class Call>
auto with_sites_in_space(const InputSites& sites, const Call& call) {
    const std::vector<Site3>& balls = sites.file.in_space;
    if (sites.third == WeightIs::radius) return call(std::span<const Site3>(balls));
    std::vector<power::Site3> weighted;
    weighted.reserve(balls.size());
    for (const auto& [x, y, z, w] : balls) weighted.push_back({x, y, z, w});
    return call(std::span<const power::Site3>(weighted));
}

/// With a progress bar unless quiet. Throws CheckFailure where naive arithmetic broke the
/// structure.
SpaceTessellation construct_in_space(const SitesCall& call, const InputSites& sites);

/// validate() with a progress bar unless quiet.
Validation validate_in_space(const SpaceTessellation& tessellation, const InputSites& sites,
                             bool quiet);

/// Throws CallError for an option that `what`, such as "sites in space", does not heed, for it
/// `has` something else: "have no arcs". Of an option with its value, the message leaves out both.
[[noreturn]] void refuse_option(const SitesCall& call, std::string_view option,
                                std::string_view what, std::string_view has);

/// The line of a summary that says how many sites there are.
void say_sites_in_space(std::int64_t sites, WeightIs third);

/// Throws CallError for an arithmetic that space has not, given to `option`.
inline void check_arithmetic_in_space(const SitesCall& call, std::string_view option,
                                      const std::string& arithmetic) {
    const Arithmetic asked = arithmetic_of(arithmetic);
    if (asked == Arithmetic::exact || asked == Arithmetic::naive) return;
    throw CallError(
        fmt::format("{} {}: sites in space, as those of {} are, have the arithmetics exact and "
                    "naive alone; leave {} out, or name one of them",
                    option, arithmetic, call.input, option));
}

}  // namespace signum::cli
