#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "commands.hpp"

namespace signum::cli {

CLI::Validator one_of(std::vector<std::string> words) {
    const auto check = [words = std::move(words)](const std::string& word) {
        if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
        return fmt::format("'{}' is unknown; it is one of {}", word, fmt::join(words, ", "));
    };
    return {check, ""};
}

CLI::Validator whole_number() {
    const auto check = [](const std::string& word) {
        std::uint64_t value = 0;
        const char* end = word.data() + word.size();
        const auto result = std::from_chars(word.data(), end, value);
        if (result.ec == std::errc{} && result.ptr == end) return std::string();
        return fmt::format("'{}' is no whole number from 0 to 2^64 - 1", word);
    };
    return {check, ""};
}

CLI::Option* add_metric(CLI::App& command, std::string& metric) {
    metric = "euclidean";
    return command
        .add_option("--metric", metric,
                    "power, euclidean, manhattan or supremum;\nthis version has power alone")
        ->check(one_of({"power", "euclidean", "manhattan", "supremum"}))
        ->type_name("NAME")
        ->capture_default_str();
}

CLI::Option* add_weight_is(CLI::App& command, std::string& weight_is) {
    return command
        .add_option("--weight-is", weight_is,
                    "The third number of a site is its radius or its\n"
                    "weight; a radius r weighs r^2. Default: what a\n"
                    "header of the file says, else radius")
        ->check(one_of({"radius", "weight"}))
        ->type_name("radius|weight");
}

void require_power(const std::string& metric, const CLI::Option& option) {
    if (metric == "power") return;
    throw CallError(
        fmt::format("--metric {}{} is not in this version, which has power alone; add "
                    "--metric power",
                    metric, option.count() == 0 ? " (the default)" : ""));
}

}  // namespace signum::cli
