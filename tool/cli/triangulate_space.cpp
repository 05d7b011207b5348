#include "triangulate_space.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../draw/space_svg.hpp"
#include "../io/write_csv.hpp"
#include "../io/write_json.hpp"
#include "../io/write_nodes.hpp"
#include "../io/write_obj.hpp"
#include "../io/write_ply.hpp"
#include "../io/write_vtk.hpp"

#include "commands.hpp"
#include "formats.hpp"
#include "space_sites.hpp"

namespace signum::cli {
namespace {

/// Options that are heeded in the plane alone.
void refuse_options_of_the_plane(const TriangulateCall& call) {
    constexpr std::string_view what = "sites in space";
    if (call.method != name_of(Method::incremental))
        refuse_option(call, "--method " + call.method, what, "have the method incremental alone");
    check_arithmetic_in_space(call, "--arithmetic", call.arithmetic);
    if (!call.clip.empty())
        refuse_option(call, "--clip", what, "have pictures of all of them alone");
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

/// Judges the tessellation from scratch. An exact one must be the canonical one, too.
Validation checked_in_space(const TriangulateCall& call, const SpaceTessellation& tessellation,
                            const InputSites& sites) {
    Validation result = validate_in_space(tessellation, sites, call.quiet);
    const bool is_bad = !result.canonical && is_exact(arithmetic_of(call.arithmetic));
    if (!result.valid || is_bad) throw CheckFailure(words_of_failed_check(result));
    return result;
}

void summarize(const Timed& timed, WeightIs third, const std::optional<Validation>& checked,
               std::span<const Target> targets) {
    const SpaceTessellation& tessellation = timed.tessellation;
    const auto infinite_cells = std::ranges::count_if(
        tessellation.cells, [](const SpaceCell& cell) { return cell[0] == infinite; });
    const auto hidden = static_cast<std::int64_t>(tessellation.hidden.size());
    say_sites_in_space(tessellation.sites, third);
    constexpr std::string_view spans[] = {"in one place", "on a line", "in a plane"};
    if (tessellation.dimension < 3) say("flat     all lie {}\n", spans[tessellation.dimension]);
    say("visible  {}\n", tessellation.sites - hidden);
    say("hidden   {}\n", hidden);
    say("cells    {}, {} of them infinite\n", tessellation.cells.size(), infinite_cells);
    say("seconds  {:.3g}\n", timed.statistics.seconds);
    say("{}", written(targets));
    if (checked) say("check    valid, {}canonical\n", checked->canonical ? "" : "not ");
}

}  // namespace

void triangulate_in_space(const TriangulateCall& call, const InputSites& sites,
                          std::span<const Target> targets) {
    refuse_options_of_the_plane(call);
    require_formats_of(Dimension::three, targets, triangulate_formats, call.input);
    const Outputs outputs(targets);
    const Timed result = timed(call, sites);
    const SpaceTessellation& tessellation = result.tessellation;
    const std::vector<Site3>& balls = sites.file.in_space;
    std::vector<SpaceVertex> diagram;
    if (call.vertices) {
        diagram =
            with_sites_in_space(sites, [&](auto those) { return vertices(tessellation, those); });
    }
    // Before anything is written: what fails its check is not left under the name asked for.
    std::optional<Validation> checked;
    if (call.check) checked = checked_in_space(call, tessellation, sites);
    outputs.write(
        {{"svg", [&](std::ostream& out) { write_svg(out, tessellation, balls, sites.third); }},
         {"csv", [&](std::ostream& out) { write_csv(out, tessellation); }},
         {"obj", [&](std::ostream& out) { write_obj(out, tessellation, balls); }},
         {"vtk",
          [&](std::ostream& out) { write_vtk(out, vtk_grid(tessellation, balls, sites.third)); }},
         {"vtu",
          [&](std::ostream& out) { write_vtu(out, vtk_grid(tessellation, balls, sites.third)); }},
         {"ply", [&](std::ostream& out) { write_ply(out, balls, sites.third); }},
         {"node", [&](std::ostream& out) { write_node(out, balls); }},
         {"ele", [&](std::ostream& out) { write_ele(out, tessellation); }},
         {"neigh", [&](std::ostream& out) { write_neigh(out, tessellation); }},
         {"json", [&](std::ostream& out) {
              write_json(out, tessellation, metric_of(call.metric), sites.third,
                         call.statistics ? std::optional(result.statistics) : std::nullopt,
                         diagram);
          }}});
    if (!call.quiet) summarize(result, sites.third, checked, targets);
}

}  // namespace signum::cli
