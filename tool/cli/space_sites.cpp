#include "space_sites.hpp"

#include <optional>
#include <stdexcept>

#include "../../triangulation/space/validate.hpp"

#include "progress.hpp"

namespace signum::cli {

SpaceTessellation construct_in_space(const SitesCall& call, const InputSites& sites) {
    std::optional<Progress> progress;
    Options options;
    options.arithmetic = arithmetic_of(call.arithmetic);
    options.seed = call.seed;
    if (!call.quiet) {
        progress.emplace();
        options.progress = [&progress](double share) { progress->show(share); };
    }
    try {
        return with_sites_in_space(
            sites, [&](auto those) { return triangulate(those, Power{}, options); });
    } catch (const BrokenStructure& error) {
        throw CheckFailure(broken_words(call.arithmetic, error));
    } catch (const std::invalid_argument& error) {
        throw CallError(error.what());
    }
}

Validation validate_in_space(const SpaceTessellation& tessellation, const InputSites& sites,
                             bool quiet) {
    std::optional<Progress> progress;
    ValidationOptions options;
    if (!quiet) {
        progress.emplace();
        options.progress = [&progress](double share) { progress->show(share); };
    }
    return with_sites_in_space(sites,
                               [&](auto those) { return validate(tessellation, those, options); });
}

void refuse_option(const SitesCall& call, std::string_view option, std::string_view what,
                   std::string_view has) {
    throw CallError(fmt::format("{}: {}, as those of {} are, {}; leave {} out", option, what,
                                call.input, has, option.substr(0, option.find(' '))));
}

void say_sites_in_space(std::int64_t sites, WeightIs third) {
    say("sites    {}, in space{}\n", sites,
        third == WeightIs::weight ? ", the fourth number a weight" : "");
}

}  // namespace signum::cli
