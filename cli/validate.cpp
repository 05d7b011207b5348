/// signum validate: judges a tessellation, whoever made it.

#include <memory>

#include <fmt/format.h>

#include "../io/output_file.hpp"
#include "../io/read_tessellation.hpp"

#include "commands.hpp"
#include "progress.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct ValidateCall {
    std::string tessellation;
    std::string sites;
    std::string columns;
    bool quiet = false;
};

void run(const ValidateCall& call) {
    if (call.tessellation == "-" && call.sites == "-") {
        throw CallError("only one of the two files can be standard input");
    }
    const TessellationArrays arrays = read_tessellation(call.tessellation);
    const SitesFile file = read_sites_by_columns(call.sites, call.columns);
    const Validation result =
        validate_with_progress(arrays, strided_view(file.sites, arrays.weight_is), call.quiet);
    DescriptorStream out(1, "standard output");
    if (!result.valid) {
        out << fmt::format("not valid: {}\n", result.message);
    } else if (!result.canonical) {
        out << fmt::format("valid, not canonical: {}\n", result.message);
    } else {
        out << "valid, canonical\n";
    }
    out.flush();
    if (!result.valid) {
        throw CheckFailure(
            fmt::format("{} is not a valid tessellation of {}", call.tessellation, call.sites));
    }
}

}  // namespace

void add_validate(CLI::App& tool) {
    auto call = std::make_shared<ValidateCall>();
    CLI::App* command =
        tool.add_subcommand("validate", "Judges a tessellation from scratch, whoever made it");
    command
        ->add_option("TESSELLATION", call->tessellation,
                     "The JSON that triangulate writes; - for standard\ninput")
        ->required()
        ->type_name("");
    command
        ->add_option("FILE", call->sites,
                     "Its sites; the tessellation says in which metric,\nand whether the third "
                     "number is a weight")
        ->required()
        ->type_name("");
    add_columns(*command, call->columns);
    command->add_flag("--quiet", call->quiet, "No progress on standard error");
    command->footer(
        "Prints \"valid, canonical\", \"valid, not canonical: WHY\" or \"not valid: WHY\";\n"
        "exit 1 when it is not valid.\n\n"
        "Example:\n  signum validate out.json sites.txt");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
