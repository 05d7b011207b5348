#include "contestants.hpp"

#include "../generate/generate.hpp"
#include "../io/names.hpp"

namespace signum::study {
namespace {

GenerateOptions options_of(const Setting& setting, std::size_t seed) {
    return {.count = setting.count,
            .radius_from = setting.radius_from,
            .radius_to = setting.radius_to,
            .perturb = setting.perturbation,
            .seed = seed};
}

}  // namespace

std::vector<Site> sites_of(const Setting& setting, std::size_t seed) {
    return generate(named(all_distributions, setting.distribution).value(),
                    options_of(setting, seed));
}
std::vector<Site3> sites_in_space_of(const Setting& setting, std::size_t seed) {
    return generate(named(all_space_distributions, setting.distribution).value(),
                    options_of(setting, seed));
}

std::optional<Options> options_named(const std::string& name) {
    Options options;
    options.threads = 1;
    if (const auto method = named(all_methods, name))
        options.method = *method;
    else if (const auto arithmetic = named(all_arithmetics, name))
        options.arithmetic = *arithmetic;
    else
        return std::nullopt;
    return options;
}

}  // namespace signum::study
