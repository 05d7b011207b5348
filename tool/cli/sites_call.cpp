#include "sites_call.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "../io/names.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"

namespace signum::cli {

void add_sites(CLI::App& command, SitesCall& call) {
    command.add_option("FILE", call.input, "Sites, one a line: x y [r]; - for standard input")
        ->required()
        ->type_name("");
    add_text(command, call.text);
    add_metric(command, call.metric);
    add_weight_is(command, call.weight_is, "what a header of the file says, else\nradius");
    add_checked(command, "--seed", call.seed, "N", whole_number(),
                "Of the order of insertion; the result does not\ndepend on it")
        ->capture_default_str();
    add_threads(command, call.threads);
    command.add_flag("--quiet", call.quiet, "No summary and no progress on standard error");
}

void describe_columns_in_space(CLI::Option& columns) {
    columns.type_name("X,Y[,Z][,R]");
    columns.description(columns.get_description() +
                        ".\nIn space x, y, z and, where there are four, r");
}

void add_space(CLI::App& command, SitesCall& call) {
    call.dimension.reset();
    command.get_option("FILE")->description(
        "Sites, one a line: x y [r], in space x y z [r];\n- for standard input");
    describe_columns_in_space(*command.get_option("--columns"));
    command
        .add_option_function<int>(
            "--dimension", [&call](int dimension) { call.dimension = dimension; },
            fmt::format("2: sites are x y [r]; 3: they are x y z [r], the\nmetric is {}.\nDefault: "
                        "what a header or the format of the\nfile says, else 2",
                        fmt::join(names_of(call.metrics_in_space), " or ")))
        ->check(one_of({"2", "3"}))
        ->type_name("2|3");
    add_read_as(command, call.read_as);
}

void add_read_as(CLI::App& command, std::string& read_as) {
    std::string help = "What FILE is, whatever its ending:";
    std::vector<std::string> names;
    for (const SitesInputKind& kind : sites_input_kinds()) {
        names.emplace_back(kind.name);
        std::string holds(kind.holds);
        for (std::size_t at = 0; (at = holds.find('\n', at)) != std::string::npos; at += 7)
            holds.insert(at + 1, "      ");
        help += fmt::format("\n{:<6}{}", kind.name, holds);
    }
    add_checked(command, "--read-as", read_as, "NAME", one_of(names), help);
}

CLI::Validator name_of_arithmetic() {
    return one_of(names_of(all_arithmetics));
}

Arithmetic arithmetic_of(const std::string& name) {
    return named(all_arithmetics, name).value();
}

namespace {

/// In the power metric a radius counts by its square, which has lost the sign.
void warn_of_negative_radii(const std::string& path, const SitesFile& file) {
    if (!file.first_negative) return;
    std::vector<double> negative;
    for (const Site& site : file.sites)
        if (site.r < 0.0) negative.push_back(site.r);
    for (const Site3& site : file.in_space)
        if (site.r < 0.0) negative.push_back(site.r);
    say("signum: {}:{}:{}: the radius {} is negative, {}, and the power metric squares radii; say "
        "--weight-is weight if weights are meant, --weight-is radius if not\n",
        path, file.first_negative->line, file.first_negative->column, negative.front(),
        negative.size() == 1 ? "the only one of the file"
                             : fmt::format("the first of {}", negative.size()));
}

/// What the file is taken for. Where sites lie in the plane, only what --read-as names, and the
/// ending of a file that may lie there, are other than text.
SitesInput input_of_call(const SitesCall& call) {
    const SitesInput input = input_of(call.input, call.read_as);
    const bool is_guessed = call.read_as.empty() && is_of_space(input);
    return call.dimension == 2 && is_guessed ? SitesInput::text : input;
}

/// Throws CallError where sites in space are asked for a metric that is of the plane alone.
void check_space(const SitesCall& call, const SitesFile& file) {
    const std::vector<Metric>& known = call.metrics_in_space;
    if (file.dimension == 2 || std::ranges::count(known, metric_of(call.metric)) > 0) return;
    const std::vector<std::string> names = names_of(known);
    throw CallError(fmt::format(
        "--metric {}: sites in space, as those of {} are, have tessellations of the {} metric "
        "alone; add --metric {}{}",
        call.metric, call.input, fmt::join(names, " and "), names.front(),
        call.dimension || input_of_call(call) != SitesInput::text
            ? ""
            : ", or say --dimension 2 to leave z out"));
}

}  // namespace

SitesInput input_of(const std::string& path, const std::string& read_as) {
    return input_by_ending(read_as.empty() ? ending_of_input(path) : read_as);
}

InputSites read_input(const SitesCall& call) {
    const Metric metric = metric_of(call.metric);
    check_weight_is(call.weight_is, metric);
    InputSites sites = {read_sites_of_call(call.input, call.text, call.dimension,
                                           input_of_call(call), call.attributes),
                        WeightIs::radius};
    check_space(call, sites.file);
    sites.third = sites.file.third.value_or(WeightIs::radius);
    if (sites.third == WeightIs::weight && !traits_of(metric).has_weights) {
        throw CallError(
            fmt::format("{}: its header says weight, and the {} metric has radii alone; name the "
                        "column radius, or add --metric power",
                        call.input, call.metric));
    }
    if (!call.weight_is.empty()) {
        sites.third = call.weight_is == "weight" ? WeightIs::weight : WeightIs::radius;
    } else if (traits_of(metric).has_weights && sites.third == WeightIs::radius) {
        warn_of_negative_radii(call.input, sites.file);
    }
    return sites;
}

void hint_at_space(const SitesCall& call, const SitesFile& file, std::size_t hidden) {
    if (!file.third_may_be_z || hidden <= file.sites.size() / 2) return;
    say("signum: {}: most sites are hidden, for the third number of a line is a radius; if it is "
        "z, "
        "say --dimension 3 --metric power\n",
        call.input);
}

void check_reach(const std::string& path, const SitesFile& file, const std::string& arithmetic) {
    if (arithmetic_of(arithmetic) != Arithmetic::single || !file.first_beyond_single) return;
    throw InputError(path, *file.first_beyond_single,
                     "a number beyond single precision, 3.4e38; take another arithmetic than "
                     "single, or write smaller numbers");
}

namespace {

/// What `build` makes of the options of a call.
template <class Build>
auto built(const SitesCall& call, const Build& build) {
    Options options;
    options.arithmetic = arithmetic_of(call.arithmetic);
    options.seed = call.seed;
    options.threads = call.threads;
    return with_progress(call.quiet, [&](const std::function<void(double)>& show) {
        options.progress = show;
        try {
            return build(options);
        } catch (const BrokenStructure& error) {
            throw CheckFailure(fmt::format(
                "the structure broke, because {} arithmetic rounds its signs: {}; nothing is "
                "written, --arithmetic exact cannot break",
                call.arithmetic, error.what()));
        } catch (const std::invalid_argument& error) {
            throw CallError(error.what());
        }
    });
}

}  // namespace

Tessellation construct(const SitesCall& call, const InputSites& sites, Method method, Order order) {
    check_reach(call.input, sites.file, call.arithmetic);
    return built(call, [&](Options& options) {
        options.order = order;
        options.method = method;
        options.count = call.statistics;
        return triangulate(strided_view(sites.file.sites, sites.third), metric_of(call.metric),
                           options);
    });
}

SpaceTessellation construct_in_space(const SitesCall& call, const InputSites& sites) {
    return built(call, [&](const Options& options) {
        return with_sites_in_space(
            sites, [&](auto those) { return triangulate(those, Power{}, options); });
    });
}

void refuse_option(const SitesCall& call, std::string_view option, std::string_view what,
                   std::string_view has) {
    throw CallError(fmt::format("{}: {}, as those of {} are, {}; leave {} out", option, what,
                                call.input, has, option.substr(0, option.find(' '))));
}

void check_arithmetic_in_space(const SitesCall& call, std::string_view option,
                               const std::string& arithmetic) {
    const Arithmetic asked = arithmetic_of(arithmetic);
    if (asked == Arithmetic::exact || asked == Arithmetic::naive) return;
    throw CallError(
        fmt::format("{} {}: sites in space, as those of {} are, have the arithmetics exact and "
                    "naive alone; leave {} out, or name one of them",
                    option, arithmetic, call.input, option));
}

void say_sites_in_space(std::int64_t sites, WeightIs third) {
    say("sites    {}, in space{}\n", sites,
        third == WeightIs::weight ? ", the fourth number a weight" : "");
}

}  // namespace signum::cli
