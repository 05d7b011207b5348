#pragma once
/// From a file of sites to their tessellation: what several subcommands begin with.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../io/read_sites.hpp"

#include "commands.hpp"

namespace signum::cli {

/// The part of a call that says what to tessellate.
struct SitesCall {
    std::string input;
    TextCall text;
    /// Of the sites; nothing: what the file says.
    std::optional<int> dimension = 2;
    std::string read_as;  ///< of the names of --read-as; empty: by the ending
    std::string metric;
    std::string weight_is;
    std::string arithmetic = "exact";
    std::uint64_t seed = 1;
    int threads = 0;
    bool attributes = false;  ///< of the sites, as what is written wants them
    bool statistics = false;
    bool quiet = false;
    /// The metrics that the subcommand has of sites in space.
    std::vector<Metric> metrics_in_space = {Metric::power};
};

/// Adds FILE, what lines of text may be like, --metric, --weight-is, --seed, --threads and --quiet.
void add_sites(CLI::App& command, SitesCall& call);

/// Adds --dimension and --read-as, for a subcommand that takes sites of space, too, in those
/// metrics that the call knows.
void add_space(CLI::App& command, SitesCall& call);

/// Adds to what --columns says of itself what holds in space.
void describe_columns_in_space(CLI::Option& columns);

/// Adds --read-as; empty when it is not given.
void add_read_as(CLI::App& command, std::string& read_as);

/// What a file is taken for: what --read-as says, else what its ending says.
SitesInput input_of(const std::string& path, const std::string& read_as);

/// Accepts the name of an arithmetic.
[[nodiscard]] CLI::Validator name_of_arithmetic();

/// The arithmetic of a name that name_of_arithmetic() let through.
Arithmetic arithmetic_of(const std::string& name);

struct InputSites {
    SitesFile file;
    WeightIs third;  ///< what the third numbers are
};

/// Reads the file, and warns of negative radii where they will be squared and nobody has said that
/// they are radii. Throws InputError, or CallError where metric and weights do not fit.
InputSites read_input(const SitesCall& call);

/// Where more than half of the sites in the plane are hidden, and the file does not say that its
/// third numbers are radii, says how to read them as z.
void hint_at_space(const SitesCall& call, const SitesFile& file, std::size_t hidden);

/// Throws InputError where the file has a number that this arithmetic has not.
void check_reach(const std::string& path, const SitesFile& file, const std::string& arithmetic);

/// With a progress bar unless quiet. Throws CheckFailure where inexact arithmetic broke the
/// structure.
Tessellation construct(const SitesCall& call, const InputSites& sites,
                       Method method = Method::incremental, Order order = Order::index);
/// The same of sites in space.
SpaceTessellation construct_in_space(const SitesCall& call, const InputSites& sites);

/// What `call` makes of sites in space: of balls, or of sites that carry a weight.
template <class Call>
auto with_sites_in_space(const InputSites& sites, const Call& call) {
    const std::vector<Site3>& balls = sites.file.in_space;
    if (sites.third == WeightIs::radius) return call(std::span<const Site3>(balls));
    std::vector<power::Site3> weighted;
    weighted.reserve(balls.size());
    for (const auto& [x, y, z, w] : balls) weighted.push_back({x, y, z, w});
    return call(std::span<const power::Site3>(weighted));
}

/// Throws CallError for an option that `what`, such as "sites in space", does not heed, for it
/// `has` something else: "have no arcs". Of an option with its value, the message leaves out both.
[[noreturn]] void refuse_option(const SitesCall& call, std::string_view option,
                                std::string_view what, std::string_view has);

/// Throws CallError for an arithmetic that space has not, given to `option`.
void check_arithmetic_in_space(const SitesCall& call, std::string_view option,
                               const std::string& arithmetic);

/// A line of a summary, to standard error. Nobody loses a result because nobody reads its summary:
/// failures to write are ignored.
template <typename... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::fputs(fmt::format(format, std::forward<Arguments>(arguments)...).c_str(), stderr);
}

/// The line of a summary that says how many sites in space there are.
void say_sites_in_space(std::int64_t sites, WeightIs third);

}  // namespace signum::cli
