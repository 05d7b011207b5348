#include "contestants.hpp"

#include <algorithm>
#include <stdexcept>

#include "../generate/generate.hpp"

namespace signum::study {
namespace {

/// The value of a name among several; std::invalid_argument where there is none.
template <class Values>
auto named(const Values& values, const std::string& name) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const auto& each) { return name_of(each) == name; });
    if (found == values.end()) throw std::invalid_argument(name + " is unknown");
    return *found;
}

GenerateOptions options_of(const Setting& setting, std::size_t seed) {
    GenerateOptions options;
    options.count = setting.count;
    options.radius_from = setting.radius_from;
    options.radius_to = setting.radius_to;
    options.perturb = setting.perturbation;
    options.seed = seed;
    return options;
}

}  // namespace

std::vector<Site> sites_of(const Setting& setting, std::size_t seed) {
    return generate(named(all_distributions, setting.distribution), options_of(setting, seed));
}
std::vector<Site3> sites_in_space_of(const Setting& setting, std::size_t seed) {
    return generate(named(all_space_distributions, setting.distribution),
                    options_of(setting, seed));
}

std::optional<Options> options_named(const std::string& name) {
    Options options;
    for (const Method method : all_methods)
        if (name_of(method) == name) {
            options.method = method;
            return options;
        }
    for (const Arithmetic arithmetic : all_arithmetics)
        if (name_of(arithmetic) == name) {
            options.arithmetic = arithmetic;
            return options;
        }
    return std::nullopt;
}

}  // namespace signum::study
