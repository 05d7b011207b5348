/// signum validate: judges a tessellation, whoever made it.

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "../../triangulation/validate_finite.hpp"
#include "../draw/draw_faults.hpp"
#include "../io/read_faces.hpp"
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
    TextCall text;
    std::string read_as;
    std::string weight_is;  ///< of finite faces, which do not tell
    int threads = 0;
    bool quiet = false;
    bool finite = false;
    bool from_one = false;
    OutputsCall outputs;
};

constexpr std::array<Format, 2> judgement_formats = {{{"json", "the judgement, with all faces at fault"},
                                            {"svg", "a picture of them", Dimension::two, ""}}};

Validation judged_in_space(const ValidateCall& call, const ReadTessellation& read) {
    if (!traits_of(read.arrays.metric).edges_are_straight) {
        throw CallError(fmt::format(
            "{}: its metric is {}, and in space there are tessellations of the power metric alone",
            call.tessellation, name_of(read.arrays.metric)));
    }
    const InputSites sites = {
        read_sites_of_call(call.sites, call.text, 3, input_of(call.sites, call.read_as)),
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
    const SitesFile file =
        read_sites_of_call(call.sites, call.text, 2, is_of_space(input) ? SitesInput::text : input);
    return validate_with_progress(arrays, strided_view(file.sites, arrays.weight_is), call.quiet,
                                  call.threads);
}

// ---- faces as others give them -----------------------------------------------------------------

/// So many of a fault.
std::int64_t count_of(const FiniteValidation& judged, FiniteFault fault) {
    return std::ranges::count(judged.faults, fault, &FiniteValidation::Fault::fault);
}
constexpr std::array<std::pair<FiniteFault, std::string_view>, 4> faults = {
    {{FiniteFault::number, "wrong numbers"},
     {FiniteFault::flat, "flat"},
     {FiniteFault::overlap, "overlapping"},
     {FiniteFault::conflict, "in conflict"}}};

/// Faces and sites are numbered as in the file: from `first`.
std::string as_json(const FiniteValidation& judged, int first) {
    nlohmann::ordered_json json;
    json["valid"] = judged.valid;
    json["message"] = judged.message;
    json["faults"] = nlohmann::ordered_json::array();
    for (const auto& [face, fault] : judged.faults)
        json["faults"].push_back(
            {{"face", face + first},
             {"fault",
              std::ranges::find(faults, fault, &decltype(faults)::value_type::first)->second}});
    json["open"] = nlohmann::ordered_json::array();
    for (const auto& [face, between] : judged.open)
        json["open"].push_back(
            {{"face", face + first}, {"between", {between[0] + first, between[1] + first}}});
    json["missing"] = nlohmann::ordered_json::array();
    for (const std::int64_t site : judged.missing) json["missing"].push_back(site + first);
    return json.dump() + "\n";
}

/// Whether the numbers go from 1 to as many as there are sites, though nobody says so.
bool are_from_one(const FacesFile& read, const ValidateCall& call, Index sites) {
    if (read.are_from_one || call.from_one) return false;
    Index least = sites;
    Index greatest = 0;
    const auto look_at = [&](const auto& rows) {
        for (const auto& row : rows)
            for (const Index each : row) {
                least = std::min(least, each);
                greatest = std::max(greatest, each);
            }
    };
    look_at(read.faces);
    look_at(read.cells);
    return least == 1 && greatest == sites;
}

/// Whether a face has that number in the file.
bool has_number(const FacesFile& read, Index number) {
    const auto has = [&](const auto& row) { return std::ranges::find(row, number) != row.end(); };
    return std::ranges::any_of(read.faces, has) || std::ranges::any_of(read.cells, has);
}

void run_finite(const ValidateCall& call) {
    const FacesFile read = read_faces(call.tessellation);
    const auto renumbered = [&](auto faces) {
        if (call.from_one && !read.are_from_one)
            for (auto& face : faces)
                for (Index& site : face) --site;
        return faces;
    };
    const bool in_space = !read.cells.empty();
    const SitesFile sites = read_sites_of_call(call.sites, call.text, in_space ? 3 : 2,
                                               input_of(call.sites, call.read_as));
    const InputSites given = {
        sites, call.weight_is == name_of(WeightIs::weight) ? WeightIs::weight : WeightIs::radius};
    std::vector<Target> targets;
    if (!call.outputs.outputs.empty() || !call.outputs.format.empty())
        targets = targets_of(call.outputs, call.tessellation, judgement_formats);
    if (in_space && is_written(targets, "svg"))
        throw CallError("pictures are of the plane; give .json for space");
    const Outputs outputs(targets);
    const auto faces = renumbered(read.faces);
    const StridedSites in_plane = strided_view(sites.sites, given.third);
    const int first = read.are_from_one || call.from_one ? 1 : 0;
    const ValidationOptions options{.threads = call.threads};
    const FiniteValidation judged =
        in_space ? with_sites_in_space(given,
                                       [&](auto those) {
                                           const auto cells = renumbered(read.cells);
                                           return validate_finite(cells, those, options, first);
                                       })
                 : validate_finite(faces, in_plane, options, first);
    outputs.write(
        {{"json", [&](std::ostream& out) { out << as_json(judged, first); }},
         {"svg", [&](std::ostream& out) { draw_faults(out, faces, in_plane, judged, first); }}});
    // What goes to standard output is the result alone.
    const bool is_taken = std::ranges::count(targets, standard_output, &Target::path) > 0;
    const auto tell = [&](std::string_view text) { is_taken ? say("{}", text) : print(text); };
    const auto count = static_cast<Index>(sites.sites.size() + sites.in_space.size());
    std::string_view hint;
    if (are_from_one(read, call, count)) hint = "; --from-one takes them as numbered from 1";
    if (call.from_one && has_number(read, 0))
        hint = "; without --from-one they are taken as numbered from 0";
    tell(judged.valid ? "valid\n" : fmt::format("not valid: {}{}\n", judged.message, hint));
    if (judged.valid) return;
    const std::string_view face = in_space ? "cells" : "faces";
    if (!judged.faults.empty()) {
        std::string line =
            fmt::format("{} of {} {} at fault:", judged.faults.size(), read.size(), face);
        for (const auto& [fault, name] : faults)
            if (const std::int64_t count = count_of(judged, fault); count > 0)
                line += fmt::format(" {} {},", count, name);
        line.back() = '\n';
        tell(line);
    }
    if (!judged.open.empty())
        tell(fmt::format("edges of one face that are not on the hull: {}\n", judged.open.size()));
    if (!judged.missing.empty())
        tell(fmt::format("sites that are of no {}, and should be: {}\n", in_space ? "cell" : "face",
                         judged.missing.size()));
    const auto weighs = [](const auto& site) { return site.r != 0.0; };
    const bool is_regular =
        std::ranges::any_of(sites.sites, weighs) || std::ranges::any_of(sites.in_space, weighs);
    throw CheckFailure(fmt::format("{} is not a {} triangulation of {}", call.tessellation,
                                   is_regular ? "regular" : "Delaunay", call.sites));
}

void run(const ValidateCall& call) {
    if (call.finite) return run_finite(call);
    if (call.from_one || !call.outputs.outputs.empty() || !call.outputs.format.empty() ||
        !call.weight_is.empty())
        throw CallError(
            "--from-one, --weight-is, -o and --format are of finite faces; add --finite");
    if (call.tessellation == "-" && call.sites == "-") {
        throw CallError("only one of the two files can be standard input");
    }
    if (is_ending_of_faces(ending_of_input(call.tessellation)))
        throw CallError(
            fmt::format("{}: that is a file of faces as other programs give them; add --finite",
                        call.tessellation));
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
                     "The JSON that triangulate writes; - for standard\ninput. With --finite "
                     "anybody's faces or cells: .json,\n.npy, .ele, .obj, .ply, .vtk, or three or "
                     "four numbers\na line")
        ->required()
        ->type_name("");
    command
        ->add_option(
            "FILE", call->sites,
            "Its sites; the tessellation says whether of plane or\nspace, in which metric, and "
            "whether the last number\nis a weight")
        ->required()
        ->type_name("");
    describe_columns_in_space(*add_text(*command, call->text));
    add_read_as(*command, call->read_as);
    command->add_flag("--finite", call->finite,
                      "Triangles or tetrahedra alone, in any order and\norientation: are they a "
                      "Delaunay triangulation, or of\nsites with a last number a regular one? "
                      "Whichever\nties allow");
    command->add_flag("--from-one", call->from_one,
                      "With --finite: the faces number the sites from 1, not 0");
    add_weight_is(*command, call->weight_is, "with --finite radius");
    add_outputs(*command, call->outputs, judgement_formats, "with --finite; nothing without -o");
    add_threads(*command, call->threads);
    command->add_flag("--quiet", call->quiet, "No progress on standard error");
    command->footer(
        "Prints \"valid, canonical\", \"valid, not canonical: WHY\" or \"not valid: WHY\", with\n"
        "--finite \"valid\" or \"not valid: WHY\" and how many faces are at fault; exit 1 when\n"
        "it is not valid.\n\n"
        "Examples:\n"
        "  signum validate out.json sites.txt\n"
        "  signum validate cells.json protein.pdb\n"
        "  signum validate simplices.npy points.npy --finite -o faults.svg");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
