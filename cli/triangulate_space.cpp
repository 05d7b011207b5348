#include "triangulate_space.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "../draw/space_svg.hpp"
#include "../io/write_csv.hpp"
#include "../io/write_json.hpp"
#include "../io/write_obj.hpp"
#include "../io/write_vtk.hpp"
#include "../spatial/triangulate.hpp"
#include "../spatial/vertices.hpp"

#include "commands.hpp"
#include "progress.hpp"
#include "space_sites.hpp"

namespace signum::cli {
namespace {

/// Options that are heeded in the plane alone.
void refuse_options_of_the_plane(const TriangulateCall& call) {
    const auto refuse = [&](std::string_view option, std::string_view what) {
        throw CallError(fmt::format("{}: sites in space, as those of {} are, have {}; leave {} out",
                                    option, call.input, what, option.substr(0, option.find(' '))));
    };
    if (call.method != name_of(Method::incremental))
        refuse("--method " + call.method, "the method incremental alone");
    check_arithmetic_in_space(call, "--arithmetic", call.arithmetic);
    if (call.check) refuse("--check", "no check yet");
    if (!call.clip.empty()) refuse("--clip", "pictures of all of them alone");
}

/// Throws CheckFailure where naive arithmetic broke the structure.
SpaceTessellation construct_in_space(const TriangulateCall& call, const InputSites& sites) {
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

/// What a construction in space tells about itself: its time; nothing is counted.
struct Timed {
    SpaceTessellation tessellation;
    Statistics statistics;
};

Timed timed(const TriangulateCall& call, const InputSites& sites) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Timed result = {construct_in_space(call, sites), {}};
    result.statistics.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
}

void summarize(const Timed& timed, WeightIs third, std::span<const Target> targets) {
    const SpaceTessellation& tessellation = timed.tessellation;
    const auto infinite_cells = std::ranges::count_if(
        tessellation.cells, [](const SpaceCell& cell) { return cell[0] == infinite; });
    const auto hidden = static_cast<std::int64_t>(tessellation.hidden.size());
    say("sites    {}, in space{}\n", tessellation.sites,
        third == WeightIs::weight ? ", the fourth number a weight" : "");
    constexpr std::string_view spans[] = {"in one place", "on a line", "in a plane"};
    if (tessellation.dimension < 3) say("flat     all lie {}\n", spans[tessellation.dimension]);
    say("visible  {}\n", tessellation.sites - hidden);
    say("hidden   {}\n", hidden);
    say("cells    {}, {} of them infinite\n", tessellation.cells.size(), infinite_cells);
    say("seconds  {:.3g}\n", timed.statistics.seconds);
    say("{}", written(targets));
}

}  // namespace

void triangulate_in_space(const TriangulateCall& call, const InputSites& sites,
                          std::span<const Target> targets) {
    refuse_options_of_the_plane(call);
    const Outputs outputs(targets);
    const Timed result = timed(call, sites);
    const SpaceTessellation& tessellation = result.tessellation;
    const std::vector<Site3>& balls = sites.file.in_space;
    std::vector<SpaceVertex> diagram;
    if (call.vertices) {
        diagram =
            with_sites_in_space(sites, [&](auto those) { return vertices(tessellation, those); });
    }
    outputs.write([&](std::ostream& out, std::string_view format) {
        if (format == "svg") {
            write_svg(out, tessellation, balls, sites.third);
        } else if (format == "csv") {
            write_csv(out, tessellation);
        } else if (format == "obj") {
            write_obj(out, tessellation, balls);
        } else if (format == "vtk") {
            write_vtk(out, tessellation, balls, sites.third);
        } else {
            write_json(out, tessellation, metric_of(call.metric), sites.third,
                       call.statistics ? std::optional(result.statistics) : std::nullopt, diagram);
        }
    });
    if (!call.quiet) summarize(result, sites.third, targets);
}

}  // namespace signum::cli
