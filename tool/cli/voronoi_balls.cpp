#include "voronoi_balls.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

#include "../../voronoi/balls/diagram.hpp"
#include "../io/write_ball_diagram.hpp"

#include "commands.hpp"
#include "progress.hpp"
#include "space_sites.hpp"

namespace signum::cli {
namespace {

/// Options and formats that are of other diagrams: cells of balls are not computed.
void refuse_what_is_not_of_balls(const VoronoiCall& call, std::span<const Target> targets) {
    constexpr std::string_view what = "the diagram of balls";
    if (!call.clip.empty())
        refuse_option(call, "--clip", what,
                      "has vertices and edges alone, which are written whole");
    if (call.tolerance) refuse_option(call, "--tolerance", what, "has no polygons");
    if (call.merge) refuse_option(call, "--merge", what, "has one vertex a sphere anyway");
    if (call.carry) refuse_option(call, "--carry", what, "has tables of vertices alone");
    for (const Target& target : targets) {
        if (target.format == "json" || target.format == "csv") continue;
        throw CallError(
            fmt::format("{}: the diagram of balls, as those of {} are, is written as json or csv; "
                        "name one of them",
                        target.format, call.input));
    }
}

BallDiagram diagram_of(const VoronoiCall& call, const InputSites& sites) {
    std::optional<Progress> progress;
    Options options;
    if (!call.quiet) {
        progress.emplace();
        options.progress = [&progress](double share) { progress->show(share); };
    }
    try {
        return ball_diagram(sites.file.in_space, options);
    } catch (const std::invalid_argument& error) {
        throw CallError(error.what());
    }
}

void summarize(const BallDiagram& diagram, std::span<const Target> targets) {
    const auto count_ends = [&](Index end) {
        return std::ranges::count_if(diagram.ends, [end](const std::array<Index, 2>& ends) {
            return ends[0] == end || ends[1] == end;
        });
    };
    const auto hidden = static_cast<std::int64_t>(diagram.hidden.size());
    say_sites_in_space(diagram.balls, WeightIs::radius);
    say("diagram  of balls, euclidean: vertices and edges; --metric power measures cells\n");
    say("cells    {}\n", diagram.balls - hidden);
    say("hidden   {}\n", hidden);
    say("vertices {}\n", diagram.vertices.size());
    say("edges    {}, {} of them infinite, {} closed\n", diagram.edges.size(), count_ends(infinite),
        count_ends(no_end));
    say("{}", written(targets));
}

}  // namespace

void voronoi_of_balls(const VoronoiCall& call, const InputSites& sites,
                      std::span<const Target> targets) {
    refuse_what_is_not_of_balls(call, targets);
    const Outputs outputs(targets);
    const BallDiagram diagram = diagram_of(call, sites);
    outputs.write({{"csv", [&](std::ostream& out) { write_csv(out, diagram); }},
                   {"json", [&](std::ostream& out) { write_json(out, diagram); }}});
    if (!call.quiet) summarize(diagram, targets);
}

}  // namespace signum::cli
