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
    metric = name_of(Metric::euclidean);
    std::vector<std::string> names;
    for (const Metric each : all_metrics) names.emplace_back(name_of(each));
    return command
        .add_option("--metric", metric,
                    "The distance of a point p from a site (c, r):\n"
                    "power      |p - c|^2 - r^2\n"
                    "euclidean  |p - c| - r, sites are discs\n"
                    "manhattan  the same with |x| + |y|: diamonds\n"
                    "supremum   the same with max(|x|, |y|): squares")
        ->check(one_of(names))
        ->type_name("NAME")
        ->capture_default_str();
}

Metric metric_of(const std::string& name) {
    return *std::find_if(all_metrics.begin(), all_metrics.end(),
                         [&](Metric metric) { return name_of(metric) == name; });
}

CLI::Option* add_weight_is(CLI::App& command, std::string& weight_is) {
    return command
        .add_option("--weight-is", weight_is,
                    "Power metric only: the third number of a site is\n"
                    "its radius or its weight; a radius r weighs r^2.\n"
                    "Default: what a header of the file says, else\n"
                    "radius")
        ->check(one_of({"radius", "weight"}))
        ->type_name("radius|weight");
}

void check_weight_is(const std::string& weight_is, Metric metric) {
    if (weight_is.empty() || traits_of(metric).has_weights) return;
    throw CallError(
        fmt::format("--weight-is {}: only the power metric has weights, and this is --metric {}; "
                    "leave --weight-is out, or add --metric power",
                    weight_is, name_of(metric)));
}

}  // namespace signum::cli
