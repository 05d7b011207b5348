#include "metric.hpp"

#include <algorithm>

namespace signum {
namespace {

/// In small letters, without hyphens and underscores.
std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name)
        if (c != '-' && c != '_')
            result += static_cast<char>('A' <= c && c <= 'Z' ? c - 'A' + 'a' : c);
    return result;
}

}  // namespace

std::optional<Metric> metric_named(std::string_view name) {
    const std::string sought = plain(name);
    for (const MetricTraits& traits : metric_table) {
        const bool is_alias = std::ranges::find(traits.aliases, sought) != traits.aliases.end();
        if (traits.name == sought || (is_alias && !sought.empty())) return traits.metric;
    }
    return std::nullopt;
}

std::string no_weights(Metric metric) {
    return "sites of the " + std::string(traits_of(metric).title) +
           " metric have radii, not weights";
}

}  // namespace signum
