/// signum generate: sites to try things on.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../../core/index.hpp"
#include "../generate/generate.hpp"
#include "../io/input_file.hpp"
#include "../io/names.hpp"
#include "../io/number.hpp"
#include "../io/write_sites.hpp"

#include "commands.hpp"
#include "outputs.hpp"

namespace signum::cli {
namespace {

/// Which are no distribution, and are of both dimensions.
constexpr std::string_view hard_sites = "hard";

/// The call as it was typed.
struct GenerateCall {
    std::string distribution;
    int dimension = 2;
    std::int64_t count = 0;
    std::string radius = "0";
    std::string perturb = "0";
    std::uint64_t seed = 1;
    std::string output{"-"};
    std::string format;
};

/// The one of `all` that has this name. Throws CallError where it is one of the other dimension.
template <class Distributions>
auto distribution_of(const GenerateCall& call, const Distributions& all) {
    if (const auto found = named(all, call.distribution)) return *found;
    std::vector<std::string> names = names_of(all);
    names.emplace_back(hard_sites);
    throw CallError(
        fmt::format("{} lies in {}; {}, or take one of {}", call.distribution,
                    call.dimension == 3 ? "the plane" : "space",
                    call.dimension == 3 ? "leave --dimension 3 out" : "add --dimension 3",
                    fmt::join(names, ", ")));
}

std::vector<std::string> names_of_distributions() {
    std::vector<std::string> names = names_of(all_distributions);
    for (const SpaceDistribution each : all_space_distributions)
        if (std::ranges::count(names, name_of(each)) == 0) names.emplace_back(name_of(each));
    names.emplace_back(hard_sites);
    return names;
}

double number_of(const std::string& option, std::string_view text) {
    const Number number = parse_number(text);
    if (number.fault == NumberFault::none) return number.value;
    throw CallError(fmt::format("{}: {}", option, explain(number.fault, text)));
}

/// By --format, else by the ending, where there is one. Throws CallError for that of another
/// format.
SitesFormat format_of(const GenerateCall& call) {
    const std::string name = call.format.empty() ? ending_of(call.output) : call.format;
    if (name == "csv") return SitesFormat::csv;
    if (name == "json") return SitesFormat::json;
    if (name == "npy") return SitesFormat::npy;
    if (name == "f64") return SitesFormat::f64;
    for (const std::string_view text : {"", "text", "txt", "xyr", "dat"})
        if (name == text) return SitesFormat::text;
    throw CallError(fmt::format(
        "-o {}: the ending says what to write; give it .txt, .csv, .json, .npy or .f64, "
        "or say it with --format",
        call.output));
}

/// The file is opened before the work.
template <class Make>
void generate_to_output(const GenerateCall& call, Make make, SitesFormat format) {
    const std::vector<Target> targets = {{call.output, "sites"}};
    const Outputs outputs(targets);
    decltype(make()) sites;
    try {
        sites = make();
    } catch (const std::invalid_argument& error) {
        throw CallError(error.what());
    }
    outputs.write({{"sites", [&](std::ostream& out) { write_sites(out, sites, format); }}});
}

void run(const GenerateCall& call) {
    const std::int64_t most = call.dimension == 3 ? max_sites_in_space : max_sites;
    if (call.count < 1 || call.count > most) {
        throw CallError(
            fmt::format("-n {}: give a number of sites from 1 to {}", call.count, most));
    }
    GenerateOptions options;
    options.count = call.count;
    const std::size_t colon = call.radius.find(':');
    options.radius_from = number_of("--radius", call.radius.substr(0, colon));
    options.radius_to = colon == std::string::npos
                            ? options.radius_from
                            : number_of("--radius", call.radius.substr(colon + 1));
    options.perturb = number_of("--perturb", call.perturb);
    options.seed = call.seed;
    if (options.radius_from > options.radius_to) {
        throw CallError(fmt::format("--radius {}: give the smaller number first", call.radius));
    }
    if (options.perturb < 0.0) {
        throw CallError(
            fmt::format("--perturb {}: give a number that is not negative", call.perturb));
    }
    const SitesFormat format = format_of(call);
    const auto write = [&](auto make) { generate_to_output(call, make, format); };
    const bool is_hard = call.distribution == hard_sites;
    if (is_hard && call.dimension == 3)
        return write([&] { return generate_hard_in_space(options); });
    if (is_hard) return write([&] { return generate_hard(options); });
    if (call.dimension == 3)
        return write(
            [&] { return generate(distribution_of(call, all_space_distributions), options); });
    write([&] { return generate(distribution_of(call, all_distributions), options); });
}

}  // namespace

void add_generate(CLI::App& tool) {
    auto call = std::make_shared<GenerateCall>();
    CLI::App* command =
        tool.add_subcommand("generate", "Makes sites; the same options make the same sites");
    add_checked(*command, "DISTRIBUTION", call->distribution, "", one_of(names_of_distributions()),
                "random   in the square [0, 700] x [0, 700]\n"
                "circle   on the largest circle in it, radius 350\n"
                "square   on its boundary\n"
                "grid     on a grid of square cells filling it\n"
                "lattice  integers on circles, 192 on each, exactly\n"
                "rings    on circles side by side, 1000 on each\n"
                "offset   on a fine grid far away: sums round\n"
                "tangent  discs that touch circles, 192 on each,\n"
                "         exactly\n"
                "hard     patterns of sixteen: tangent, nested, collinear,\n"
                "         mirrored, exactly or but for a few ulps\n"
                "With --dimension 3:\n"
                "random   in the cube [0, 700] x [0, 700] x [0, 700]\n"
                "sphere   on the largest sphere in it, radius 350\n"
                "cube     on its boundary\n"
                "grid     on a grid of cubes filling it\n"
                "hard     as in the plane")
        ->required();
    add_checked(*command, "--dimension", call->dimension, "2|3", one_of({"2", "3"}),
                "2: in the plane; 3: in space")
        ->capture_default_str();
    add_checked(*command, "-n", call->count, "N", whole_number(), "How many sites")->required();
    command->add_option("--radius", call->radius, "The radius of all, or uniform from A to B")
        ->type_name("A[:B]")
        ->capture_default_str();
    command
        ->add_option("--perturb", call->perturb,
                     "Adds to each coordinate a number, uniform from\n0 to P")
        ->type_name("P")
        ->capture_default_str();
    add_checked(*command, "--seed", call->seed, "N", whole_number(), "Other seeds, other sites")
        ->capture_default_str();
    command
        ->add_option("-o,--output", call->output,
                     "Where the sites go, by its ending: .csv, .json,\n"
                     ".npy, .f64, or\n"
                     "lines x y r, in space x y z r, in .txt, .xyr, .dat\n"
                     "and without one;\n"
                     "- is standard output")
        ->type_name("FILE")
        ->capture_default_str();
    add_checked(*command, "--format", call->format, "NAME",
                one_of({"text", "csv", "json", "npy", "f64"}),
                "What is written, whatever the ending: text, csv,\njson; npy, an array of NumPy's, "
                "and f64, doubles\nwithout a head");
    command->footer(
        "Examples:\n"
        "  signum generate random -n 1000 --radius 1:20 --seed 7 -o sites.txt\n"
        "  signum generate sphere --dimension 3 -n 1000 -o sphere.csv");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
