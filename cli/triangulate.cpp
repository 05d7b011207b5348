/// signum triangulate: from a file of sites to files of the tessellation.

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <signum/draw/svg.hpp>
#include <signum/io/output_file.hpp>
#include <signum/io/read_sites.hpp>
#include <signum/io/write_csv.hpp>
#include <signum/io/write_json.hpp>
#include <signum/io/write_obj.hpp>
#include <signum/triangulation/triangulate.hpp>
#include <signum/triangulation/validate.hpp>

#include "commands.hpp"
#include "progress.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct Call {
    std::string input;
    std::string metric;
    std::string weight_is;
    std::string method = "incremental";
    std::string arithmetic = "exact";
    std::vector<std::string> outputs;
    bool vertices = false;
    bool statistics = false;
    bool check = false;
    bool quiet = false;
    std::uint64_t seed = 1;
};

Arithmetic arithmetic_of(const std::string& name) {
    for (const Arithmetic arithmetic :
         {Arithmetic::exact, Arithmetic::naive, Arithmetic::multiprecision}) {
        if (name_of(arithmetic) == name) return arithmetic;
    }
    throw CallError(
        fmt::format("--arithmetic {} is not in this version, which has exact, naive and "
                    "multiprecision; add --arithmetic exact",
                    name));
}

void require_incremental(const std::string& method) {
    if (method == "incremental") return;
    throw CallError(
        fmt::format("--method {} is not in this version, which has incremental alone; "
                    "leave --method out",
                    method));
}

/// The ending of a path with its point, in small letters; empty where there is none.
std::string ending_of(const std::string& path) {
    const std::size_t point = path.rfind('.');
    if (point == std::string::npos || path.find('/', point) != std::string::npos) return "";
    std::string ending = path.substr(point);
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

bool is_same_file(const std::string& a, const std::string& b) {
    struct stat first = {};
    struct stat second = {};
    return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 &&
           S_ISREG(first.st_mode) && first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

void check_outputs(const Call& call) {
    for (auto output = call.outputs.begin(); output != call.outputs.end(); ++output) {
        const std::string ending = ending_of(*output);
        if (ending != ".json" && ending != ".svg" && ending != ".csv" && ending != ".obj") {
            throw CallError(
                fmt::format("-o {}: the ending says what to write; give it .json, .svg, "
                            ".csv or .obj",
                            *output));
        }
        if (std::find(call.outputs.begin(), output, *output) != output) {
            throw CallError(fmt::format("-o {} is given twice; give it once", *output));
        }
        if (is_same_file(call.input, *output)) {
            throw CallError(
                fmt::format("-o {} would overwrite the input; give another name", *output));
        }
    }
    if (!call.vertices || call.outputs.empty()) return;
    if (std::none_of(call.outputs.begin(), call.outputs.end(),
                     [](const std::string& path) { return ending_of(path) == ".json"; })) {
        throw CallError("--vertices goes into JSON alone; add -o FILE.json");
    }
}

void write(std::ostream& out, const std::string& ending, const Tessellation& tessellation,
           const JsonOptions& options) {
    if (ending == ".svg") {
        write_svg(out, tessellation, {});
    } else if (ending == ".csv") {
        write_csv(out, tessellation);
    } else if (ending == ".obj") {
        write_obj(out, tessellation);
    } else {
        write_json(out, tessellation, options);
    }
}

Tessellation construct(const Call& call, StridedSites sites) {
    std::optional<Progress> progress;
    Options options;
    options.arithmetic = arithmetic_of(call.arithmetic);
    options.seed = call.seed;
    options.count = call.statistics;
    if (!call.quiet) {
        progress.emplace();
        options.progress = [&progress](double share) { progress->show(share); };
    }
    try {
        return triangulate(sites, metric_of(call.metric), options);
    } catch (const BrokenStructure& error) {
        throw CheckFailure(
            fmt::format("the structure broke, because {} arithmetic rounds its signs: "
                        "{}; nothing is written, --arithmetic exact cannot break",
                        call.arithmetic, error.what()));
    } catch (const std::invalid_argument& error) {
        throw CallError(error.what());
    }
}

/// A line of the summary. Nobody loses a result because nobody reads its summary: failures to write
/// are ignored.
template <typename... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::fputs(fmt::format(format, std::forward<Arguments>(arguments)...).c_str(), stderr);
}

void summarize(const Tessellation& tessellation, const std::vector<std::string>& outputs) {
    const auto faces = tessellation.faces();
    const std::size_t sites = tessellation.sites().size();
    const std::size_t hidden = tessellation.hidden().size();
    const auto infinite_faces = std::count_if(faces.begin(), faces.end(),
                                              [](const Face& face) { return face[0] == infinite; });
    const bool weighted = tessellation.weight_is() == WeightIs::weight;
    say("sites    {}{}\n", sites, weighted ? ", the third number a weight" : "");
    say("visible  {}\n", sites - hidden);
    say("hidden   {}\n", hidden);
    say("faces    {}, {} of them infinite\n", faces.size(), infinite_faces);
    say("seconds  {:.3g}\n", tessellation.statistics().seconds);
    if (!outputs.empty()) say("written  {}\n", fmt::join(outputs, ", "));
}

void summarize_statistics(const Statistics& s) {
    say("calls    {} ccw, {} in_circle, {} ties\n", s.ccw, s.in_circle, s.ties);
    say("decided  {} by the filter, {} refined, {} by ESSA, {} in multiprecision\n", s.filtered,
        s.refined, s.essa, s.multiprecision);
}

/// Judges the tessellation from scratch. An exact one must be the canonical one, too.
void check(const Call& call, const Tessellation& tessellation) {
    const Validation result = validate(
        tessellation.arrays(), strided_view(tessellation.sites(), tessellation.weight_is()));
    if (!result.valid) {
        throw CheckFailure(fmt::format("--check: not valid: {}", result.message));
    }
    if (!result.canonical && arithmetic_of(call.arithmetic) != Arithmetic::naive) {
        throw CheckFailure(fmt::format("--check: valid, not canonical: {}", result.message));
    }
    if (call.quiet) return;
    say("check    valid, {}canonical\n", result.canonical ? "" : "not ");
}

void run(const Call& call) {
    require_incremental(call.method);
    static_cast<void>(arithmetic_of(call.arithmetic));
    const Metric metric = metric_of(call.metric);
    check_weight_is(call.weight_is, metric);
    check_outputs(call);

    const SitesFile file = read_sites(call.input);
    WeightIs third = file.third.value_or(WeightIs::radius);
    if (third == WeightIs::weight && metric != Metric::power) {
        throw CallError(
            fmt::format("{}: its header says weight, and the {} metric has radii alone; name the "
                        "column radius, or add --metric power",
                        call.input, call.metric));
    }
    if (!call.weight_is.empty()) {
        third = call.weight_is == "weight" ? WeightIs::weight : WeightIs::radius;
    }
    // Opened before the work: a directory that cannot be written should not cost minutes.
    std::vector<std::unique_ptr<OutputFile>> outputs;
    for (const std::string& path : call.outputs) {
        outputs.push_back(std::make_unique<OutputFile>(path));
    }
    const Tessellation tessellation = construct(call, strided_view(file.sites, third));

    const JsonOptions json = {call.vertices, call.statistics};
    for (const auto& output : outputs) {
        write(output->stream(), ending_of(output->path()), tessellation, json);
        output->finish();
    }
    for (const auto& output : outputs) output->publish();
    if (outputs.empty()) {
        DescriptorStream out(1, "standard output");
        write_json(out, tessellation, json);
        out.flush();
    }
    if (!call.quiet) {
        summarize(tessellation, call.outputs);
        if (call.statistics) summarize_statistics(tessellation.statistics());
    }
    if (call.check) check(call, tessellation);
}

}  // namespace

void add_triangulate(CLI::App& tool) {
    auto call = std::make_shared<Call>();
    CLI::App* command = tool.add_subcommand("triangulate", "Computes the tessellation of sites");
    command->add_option("FILE", call->input, "Sites, one a line: x y [r]; - for standard input")
        ->required()
        ->type_name("");
    add_metric(*command, call->metric);
    add_weight_is(*command, call->weight_is);
    command
        ->add_option("--method", call->method,
                     "incremental, flips or sweep;\nthis version has incremental alone")
        ->check(one_of({"incremental", "flips", "sweep"}))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option(
            "--arithmetic", call->arithmetic,
            "exact, naive, single, interval, sum or\nmultiprecision; this version has exact,\n"
            "naive and multiprecision")
        ->check(one_of({"exact", "naive", "single", "interval", "sum", "multiprecision"}))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("-o,--output", call->outputs,
                     "Where the result goes, by its ending:\n"
                     ".json  faces, neighbours, hidden sites\n"
                     ".svg   a picture\n"
                     ".csv   a table a,b,c of faces, -1 is infinity\n"
                     ".obj   a mesh of the finite faces\n"
                     "Several are allowed; without it JSON goes to\nstandard output")
        ->type_name("FILE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    command->add_flag("--vertices", call->vertices,
                      "Adds centre and distance of every finite face\nto the JSON");
    command->add_flag("--stats", call->statistics,
                      "Adds counters and time to the JSON and to the\nsummary");
    command->add_flag(
        "--check", call->check,
        "Judges the result from scratch, in exact\narithmetic; exit 1 when it is wrong");
    command
        ->add_option("--seed", call->seed,
                     "Of the order of insertion; the result does not\ndepend on it")
        ->check(whole_number())
        ->type_name("N")
        ->capture_default_str();
    command->add_flag("--quiet", call->quiet, "No summary and no progress on standard error");
    command->footer(
        "Examples:\n"
        "  signum triangulate sites.txt --metric power -o out.json -o out.svg --check\n"
        "  signum triangulate sites.txt --metric supremum --stats -o squares.svg");
    command->callback([call] { run(*call); });
}

}  // namespace signum::cli
