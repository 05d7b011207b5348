#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "../../core/parallel.hpp"
#include "../io/elements.hpp"
#include "../io/names.hpp"
#include "../io/nearest_word.hpp"
#include "../io/number.hpp"
#include "../io/threads.hpp"

#include "commands.hpp"
#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

CLI::Validator one_of(std::vector<std::string> words) {
    const auto find = [words = std::move(words)](std::string& word) {
        for (const std::string& each : words) {
            if (in_small_letters(each) != in_small_letters(word)) continue;
            word = each;
            return std::string();
        }
        const auto meant = nearest_word(word, words);
        return fmt::format("{} is unknown; {}it is one of {}", in_quotes(word),
                           meant ? fmt::format("did you mean {}? ", *meant) : "",
                           fmt::join(words, ", "));
    };
    return {find, ""};
}

CLI::Validator whole_number() {
    const auto check = [](const std::string& word) {
        if (parse_whole_number(word)) return std::string();
        return fmt::format("{} is no whole number from 0 to 2^64 - 1", in_quotes(word));
    };
    return {check, ""};
}

CLI::Validator whole_number_to(std::uint64_t most) {
    const auto check = [most](const std::string& word) {
        const auto number = parse_whole_number(word);
        if (number && *number <= most) return std::string();
        return fmt::format("{} is no whole number from 0 to {}", in_quotes(word), most);
    };
    return {check, ""};
}

CLI::Validator number_from(double least, double most) {
    const auto check = [=](const std::string& word) {
        const Number number = parse_number(word);
        if (number.fault != NumberFault::none) return explain(number.fault, word);
        if (least <= number.value && number.value <= most) return std::string();
        return fmt::format("{} is not from {} to {}", in_quotes(word), least, most);
    };
    return {check, ""};
}

CLI::Validator finite_number() {
    constexpr double largest = std::numeric_limits<double>::max();
    return number_from(-largest, largest);
}

CLI::Validator name_of_file() {
    const auto check = [](const std::string& word) {
        return std::string(word.empty() ? "an empty name; give the name of a file" : "");
    };
    return {check, ""};
}

CLI::Validator name_of_metric() {
    const auto find = [](std::string& word) {
        if (const std::optional<Metric> metric = metric_named(word)) {
            word = name_of(*metric);
            return std::string();
        }
        // Whatever the word, this says what is wrong with it.
        return one_of(names_of(all_metrics))(word);
    };
    return {find, ""};
}

CLI::Option* add_metric(CLI::App& command, std::string& metric) {
    metric = name_of(Metric::euclidean);
    std::string distances = "The distance of a point p from a site (c, r):";
    for (const MetricTraits& traits : metric_table)
        distances += fmt::format("\n{:<9}  {}: {}s", traits.name, traits.distance, traits.site);
    return add_checked(command, "--metric", metric, "NAME", name_of_metric(), distances)
        ->capture_default_str();
}

Metric metric_of(const std::string& name) {
    return metric_named(name).value();
}

CLI::Option* add_threads(CLI::App& command, int& threads) {
    return add_checked(command, "--threads", threads, "N", whole_number_to(most_threads),
                       "How many threads work; the result does not depend\non it. 0: as many as "
                       "there are cores to use. Few\nsites, and work that rounds or counts, stay on one")
        ->each([](const std::string& text) {
            if (const auto number = parse_whole_number(text))
                threads_of_files = static_cast<int>(std::min<std::uint64_t>(*number, most_threads));
        })
        ->capture_default_str();
}

CLI::Option* add_text(CLI::App& command, TextCall& call) {
    CLI::Option* const columns =
        command
            .add_option("--columns", call.columns,
                        "Which columns of FILE are x, y and, where there\n"
                        "are three, r: by the header's names or by number,\n"
                        "as in lon,lat or 2,3,5. Default: those that a\n"
                        "header calls x, y, r (or radius, weight), or as\n"
                        "programs do (POINT_X, easting, longitude), else\n"
                        "the first three without a header, two under one")
            ->type_name("X,Y[,R]");
    add_checked(command, "--decimal", call.decimal, ".|,", one_of({".", ","}),
                "What stands before a fraction; where it is a comma,\n"
                "semicolons, tabs or blanks separate columns");
    add_checked(command, "--skip-lines", call.skipped_lines, "N", whole_number(),
                "How many lines before the header, or the first\nsite, are passed over");
    command.add_flag("--skip-missing", call.skips_missing,
                     "Passes over lines where a number is empty, NA, NaN,\nnull or none");
    command
        .add_option(
            "--radius", call.radii,
            "Of an element of a molecule, in Angstrom, in place\nof the one that is known; as "
            "often as need be")
        ->allow_extra_args(false)
        ->type_name("EL=R");
    return columns;
}

namespace {

/// Reads sites as the plane's columns. Where that fails in a file whose ending says that it holds
/// sites in space, this is what is said.
SitesFile read_in_plane(const std::string& path, const ReadOptions& options) {
    try {
        return read_sites(path, options);
    } catch (const InputError& error) {
        if (!is_of_space(input_by_ending(ending_of_input(path)))) throw;
        throw CallError(fmt::format(
            "{}: by its ending it holds sites in space, and sites of the plane are "
            "wanted here; signum triangulate, voronoi and compare take it with --metric "
            "power (as lines x y [r] it is wrong: {})",
            path, error.what()));
    }
}

}  // namespace

SitesFile read_sites_of_call(const std::string& path, const TextCall& text,
                             std::optional<int> dimension, SitesInput input, bool attributes) {
    const std::string& columns = text.columns;
    Columns chosen;
    for (std::size_t start = 0; !columns.empty() && start <= columns.size();) {
        const std::size_t end = std::min(columns.find(',', start), columns.size());
        std::string_view column(columns.data() + start, end - start);
        while (column.starts_with(' ')) column.remove_prefix(1);
        while (column.ends_with(' ')) column.remove_suffix(1);
        chosen.emplace_back(column);
        start = end + 1;
    }
    const bool has_gap = std::ranges::count(chosen, std::string()) > 0;
    const std::size_t least = dimension == 3 ? 3 : 2;
    const std::size_t most = dimension == 2 ? 3 : 4;
    if (!chosen.empty() && (chosen.size() < least || chosen.size() > most || has_gap)) {
        throw CallError(fmt::format(
            "--columns {}: give {} with commas between, by name or number, as in {}", columns,
            dimension == 2   ? "two or three"
            : dimension == 3 ? "three or four"
                             : "two or three, in space three or four,",
            dimension == 3 ? "--columns x,y,z or --columns 2,3,4,6"
                           : "--columns lon,lat or --columns 2,3,5"));
    }
    if (!chosen.empty() && is_of_space(input)) {
        throw CallError(fmt::format(
            "--columns {}: {} has columns of its own; leave --columns out, or add --read-as text",
            columns, path));
    }
    if (dimension == 2 && is_of_space(input)) {
        throw CallError(fmt::format(
            "--dimension 2: the sites of {} lie in space; leave it out, or add --read-as text",
            path));
    }
    ReadOptions options = {.columns = chosen,
                           .dimension = dimension,
                           .input = input,
                           .attributes = attributes,
                           .decimal = text.decimal.front(),
                           .skipped_lines = text.skipped_lines,
                           .skips_missing = text.skips_missing};
    for (const std::string& each : text.radii) {
        const std::size_t mark = std::min(each.find('='), each.size());
        const std::string element = each.substr(0, mark);
        const Number radius = parse_number(each.substr(std::min(mark + 1, each.size())));
        if (!is_element(element) || radius.fault != NumberFault::none || radius.value < 0.0)
            throw CallError(
                fmt::format("--radius {}: give an element and its radius in Ångström, as in "
                            "--radius Mo=2.1",
                            each));
        options.radii[in_small_letters(element)] = radius.value;
    }
    SitesFile file = dimension == 2 ? read_in_plane(path, options) : read_sites(path, options);
    if (!file.note.empty()) say("signum: {}\n", file.note);
    return file;
}

CLI::Option* add_weight_is(CLI::App& command, std::string& weight_is, std::string_view otherwise) {
    return add_checked(command, "--weight-is", weight_is, "radius|weight",
                       one_of({"radius", "weight"}),
                       fmt::format("Power metric only: the third number of a site is\n"
                                   "its radius or its weight; a radius r weighs r^2.\n"
                                   "Default: {}",
                                   otherwise));
}

void check_weight_is(const std::string& weight_is, Metric metric) {
    if (weight_is.empty() || traits_of(metric).has_weights) return;
    throw CallError(
        fmt::format("--weight-is {}: only the power metric has weights, and this is --metric {}; "
                    "leave --weight-is out, or add --metric power",
                    weight_is, name_of(metric)));
}

}  // namespace signum::cli
