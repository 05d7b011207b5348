/// signum validate: judges a tessellation, whoever made it.

#include <memory>

#include <fmt/format.h>

#include "../io/read_tessellation.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct ValidateCall {
    std::string tessellation;
    std::string sites;
    std::string columns;
    std::string read_as;
    int threads = 0;
    bool quiet = false;
};

Validation judged_in_space(const ValidateCall& call, const ReadTessellation& read) {
    if (!traits_of(read.arrays.metric).edges_are_straight) {
        throw CallError(fmt::format(
            "{}: its metric is {}, and in space there are tessellations of the power metric alone",
            call.tessellation, name_of(read.arrays.metric)));
    }
    const InputSites sites = {
        read_sites_by_columns(call.sites, call.columns, 3, input_of(call.sites, call.read_as)),
        read.arrays.weight_is};
    return with_sites_in_space(sites, [&](auto those) {
        return validate_with_progress(*read.in_space, those, call.quiet, call.threads);
    });
}

Validation judged_in_plane(const ValidateCall& call, const TessellationArrays& arrays) {
    const SitesInput input = input_of(call.sites, call.read_as);
    if (!call.read_as.empty() && is_of_space(input)) {
        throw CallError(
            fmt::format("--read-as {}: it holds sites in space, and the tessellation of {} is one "
                        "of the plane",
                        call.read_as, call.tessellation));
    }
    const SitesFile file = read_sites_by_columns(call.sites, call.columns, 2,
                                                 is_of_space(input) ? SitesInput::text : input);
    return validate_with_progress(arrays, strided_view(file.sites, arrays.weight_is), call.quiet,
                                  call.threads);
}

void run(const ValidateCall& call) {
    if (call.tessellation == "-" && call.sites == "-") {
        throw CallError("only one of the two files can be standard input");
    }
    const ReadTessellation read = read_tessellation(call.tessellation);
    if (!read.note.empty()) say("signum: {}\n", read.note);
    const Validation result =
        read.in_space ? judged_in_space(call, read) : judged_in_plane(call, read.arrays);
    print(!result.valid       ? fmt::format("not valid: {}\n", result.message)
          : !result.canonical ? fmt::format("valid, not canonical: {}\n", result.message)
                              : "valid, canonical\n");
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
        ->add_option(
            "FILE", call->sites,
            "Its sites; the tessellation says whether of plane or\nspace, in which metric, and "
            "whether the last number\nis a weight")
        ->required()
        ->type_name("");
    describe_columns_in_space(*add_columns(*command, call->columns));
    add_read_as(*command, call->read_as);
    add_threads(*command, call->threads);
    command->add_flag("--quiet", call->quiet, "No progress on standard error");
    command->footer(
        "Prints \"valid, canonical\", \"valid, not canonical: WHY\" or \"not valid: WHY\";\n"
        "exit 1 when it is not valid.\n\n"
        "Examples:\n"
        "  signum validate out.json sites.txt\n"
        "  signum validate cells.json protein.pdb");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
