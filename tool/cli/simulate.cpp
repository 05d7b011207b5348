/// signum simulate: balls that move and strike, to the log of their strikes.

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "../../motion/simulation.hpp"
#include "../io/motion_state.hpp"
#include "../io/names.hpp"
#include "../io/output_file.hpp"
#include "../io/read_balls.hpp"
#include "../scenes/explain.hpp"
#include "../scenes/read_scene.hpp"

#include "commands.hpp"
#include "interrupt.hpp"
#include "outputs.hpp"
#include "simulate_run.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

template <int D>
motion::Vector<D> vector_of(const double* numbers) {
    motion::Vector<D> v{};
    std::copy_n(numbers, D, v.begin());
    return v;
}

template <int D>
void require_count(std::string_view option, const std::vector<double>& numbers, std::size_t count) {
    if (numbers.empty() || numbers.size() == count) return;
    throw CallError(fmt::format("{}: {} numbers, but the balls lie in {}; give {}", option,
                                numbers.size(), D == 2 ? "the plane" : "space", count));
}

template <int D>
motion::Effects<D> effects_of(const SimulateCall& call) {
    require_count<D>("--box", call.box, 2 * D);
    require_count<D>("--gravity", call.gravity, D);
    motion::Effects<D> effects;
    if (!call.box.empty())
        effects.box =
            motion::Box<D>{vector_of<D>(call.box.data()), vector_of<D>(call.box.data() + D)};
    effects.periodic = call.periodic;
    if (!call.gravity.empty()) effects.gravity = vector_of<D>(call.gravity.data());
    effects.restitution = call.restitution.value_or(1.0);
    effects.wall_restitution = call.wall_restitution.value_or(effects.restitution);
    return effects;
}

/// What the file says, checked; a ball that cannot be is named by its line.
template <int D>
MotionState<D> started(const SimulateCall& call, const BallsFile& file) {
    std::vector<motion::Body<D>> bodies;
    bodies.reserve(file.balls.size());
    for (const BallLine& ball : file.balls) {
        bodies.push_back(
            {vector_of<D>(ball.x.data()), vector_of<D>(ball.v.data()), ball.radius, ball.mass});
    }
    const motion::Effects<D> effects = effects_of<D>(call);
    try {
        return {motion::start<D>(bodies, effects), effects};
    } catch (const motion::BallError& error) {
        throw InputError(call.input, file.balls[static_cast<std::size_t>(error.ball())].position,
                         error.what());
    } catch (const std::invalid_argument& error) {
        throw CallError(error.what());
    }
}

void refuse_effects_of_state(const SimulateCall& call) {
    if (!call.box.empty() || call.periodic || !call.gravity.empty() || call.restitution ||
        call.wall_restitution) {
        throw CallError(
            "--resume: box, gravity and restitution are those of the state; leave their options "
            "out");
    }
}

/// Options that say what a scene says win over it, as --set does.
std::vector<Override> overrides_of(const SimulateCall& call) {
    std::vector<Override> overrides;
    for (const std::string& setting : call.settings)
        overrides.push_back({fmt::format("--set {}", setting), setting});
    const auto put = [&](const std::string& option, const std::string& toml) {
        overrides.push_back({option, toml});
    };
    if (!call.box.empty()) {
        const std::string option = fmt::format("--box {}", fmt::join(call.box, " "));
        if (call.box.size() % 2 != 0)
            throw CallError(fmt::format("{}: {} numbers; give 4 in the plane and 6 in space",
                                        option, call.box.size()));
        const auto middle = call.box.begin() + static_cast<std::ptrdiff_t>(call.box.size() / 2);
        put(option, fmt::format("box.low = [{}]", fmt::join(call.box.begin(), middle, ", ")));
        put(option, fmt::format("box.high = [{}]", fmt::join(middle, call.box.end(), ", ")));
    }
    if (call.periodic) put("--periodic", "box.periodic = true");
    if (!call.gravity.empty())
        put(fmt::format("--gravity {}", fmt::join(call.gravity, " ")),
            fmt::format("effects.gravity = [{}]", fmt::join(call.gravity, ", ")));
    const auto put_number = [&](std::string_view option, std::string_view key, const auto& number) {
        if (number)
            put(fmt::format("{} {}", option, *number), fmt::format("{} = {}", key, *number));
    };
    put_number("--restitution", "effects.restitution", call.restitution);
    put_number("--wall-restitution", "effects.wall_restitution", call.wall_restitution);
    put_number("--until", "run.until", call.until);
    put_number("--events", "run.events", call.events);
    put_number("--every", "record.every", call.every);
    const auto put_word = [&](std::string_view option, std::string_view key,
                              const std::string& word) {
        if (!word.empty())
            put(fmt::format("{} {}", option, word), fmt::format("{} = \"{}\"", key, word));
    };
    put_word("--structure", "run.structure", call.structure);
    put_word("--arithmetic", "run.arithmetic", call.arithmetic);
    return overrides;
}

/// What is recorded, as targets.
std::vector<Target> targets_of_record(const SceneRecord& record) {
    std::vector<Target> targets;
    for (const auto& [path, format] :
         {std::pair(&record.log, "csv"), std::pair(&record.frames, "xyz"),
          std::pair(&record.film, "svg"), std::pair(&record.energies, "energies"),
          std::pair(&record.pair_correlation, "pair_correlation"),
          std::pair(&record.images, "images"), std::pair(&record.video, "video"),
          std::pair(&record.page, "html")})
        if (!path->empty()) targets.push_back({*path, format});
    return targets;
}

/// The call with what the scene says where options say nothing: these it has heeded already.
template <int D>
SimulateCall completed(SimulateCall call, const Scene<D>& scene) {
    call.until = scene.run.until;
    call.events = scene.run.events;
    call.structure = motion::name_of(scene.run.structure);
    call.arithmetic = scene.run.kernel == motion::Kernel::naive ? "naive" : "exact";
    call.records = targets_of_record(scene.record);
    if (call.save.empty()) call.save = scene.record.state;
    const auto refuse_file_of_scene = [&](std::string_view option, const std::string& output) {
        for (const std::string& file : scene.files)
            if (is_same_file(file, output))
                throw CallError(
                    fmt::format("{} {} would overwrite a file of the scene; give another name",
                                option, output));
    };
    for (const std::string& output : call.outputs) refuse_file_of_scene("-o", output);
    refuse_file_of_scene("--save", call.save);
    refuse_file_of_scene("--closest", call.closest);
    // A scene may say it for who asks for frames.
    if (!call.every && wants_frames(call)) call.every = scene.record.every;
    call.scene = {.title = scene.title,
                  .explanation = explain(scene, results_in_words(call)),
                  .length = scene.units.name_of(dimensions::length),
                  .time = scene.units.name_of(dimensions::time),
                  .energy = scene.units.name_of(dimensions::energy)};
    return call;
}

/// Dense balls take their time to be placed.
AnyScene scene_of(const SimulateCall& call) {
    const InterruptHandled says =
        interrupt_says("signum: interrupted while balls were placed; nothing was written\n");
    return read_scene(call.input, overrides_of(call));
}

void simulate_scene(const SimulateCall& call) {
    try {
        const AnyScene any = scene_of(call);
        std::visit(
            [&]<int D>(const Scene<D>& scene) {
                const SimulateCall whole = completed(call, scene);
                if (call.explain) {
                    check_simulation<D>(whole, {scene.start, scene.effects});
                    return print(whole.scene.explanation);
                }
                for (const std::string& note : scene.notes) say("{}\n", note);
                run_simulation<D>(whole, {scene.start, scene.effects});
            },
            any);
    } catch (const OverrideError& error) {
        throw CallError(error.what());
    }
}

void simulate(SimulateCall call) {
    if (is_name_of_scene(call.input) && call.resume.empty()) {
        simulate_scene(call);
        return;
    }
    if (!call.settings.empty()) throw CallError("--set is for scenes; give FILE.toml");
    if (call.explain) throw CallError("--explain is for scenes; give FILE.toml");
    if (call.structure.empty()) call.structure = "auto";
    if (call.arithmetic.empty()) call.arithmetic = "exact";
    if (call.periodic && call.box.empty())
        throw CallError("--periodic: say of what box; add --box");
    if (!call.resume.empty()) {
        refuse_effects_of_state(call);
        if (!call.input.empty())
            throw CallError("FILE and --resume: the state holds the balls; leave FILE out");
        if (dimension_of_motion_state(call.resume) == 2) {
            run_simulation(call, checked_motion_state<2>(call.resume));
        } else {
            run_simulation(call, checked_motion_state<3>(call.resume));
        }
        return;
    }
    if (call.input.empty()) throw CallError("a file of balls is missing; give FILE, or --resume");
    const BallsFile file = read_balls(call.input);
    if (!file.note.empty()) say("{}\n", file.note);
    if (file.dimension == 2) {
        run_simulation(call, started<2>(call, file));
    } else {
        run_simulation(call, started<3>(call, file));
    }
}

}  // namespace

void add_simulate(CLI::App& tool) {
    auto call = std::make_shared<SimulateCall>();
    const std::vector<std::string> structures = names_of(motion::all_structures);
    CLI::App* command = tool.add_subcommand(
        "simulate", "Lets balls move and strike, in the exact order of their strikes");
    command
        ->add_option("FILE", call->input,
                     "Balls, one a line: x y r vx vy [mass], or\n"
                     "x y z r vx vy vz [mass]; - is standard input.\n"
                     "Or a scene, FILE.toml, which options win over")
        ->type_name("");
    command
        ->add_option("--set", call->settings,
                     "A key of a scene, in place of what the file says:\n"
                     "--set effects.restitution=0.8; several are allowed")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    add_checked(*command, "--until", call->until, "T", number_from(0.0, 1e150),
                "The time to stop at; strikes then are included");
    add_checked(*command, "--events", call->events, "N", whole_number(),
                "Stop after so many strikes");
    add_checked(*command, "--box", call->box, "X0 Y0 [Z0] X1 Y1 [Z1]", finite_number(),
                "Walls: the lower corner, then the upper one;\nX0 Y0 Z0 X1 Y1 Z1 in space. A "
                "movie without it\nshows the place where the balls are at the start")
        ->option_text("X0 Y0 X1 Y1")
        ->expected(4, 6);
    command->add_flag("--periodic", call->periodic,
                      "No walls: who leaves the box comes in on the other\nside");
    add_checked(*command, "--gravity", call->gravity, "GX GY [GZ]", finite_number(),
                "The acceleration of all balls")
        ->option_text("GX GY [GZ]")
        ->expected(2, 3);
    add_checked(*command, "--restitution", call->restitution, "E", number_from(0.0, 1.0),
                "The ratio of speeds after and before a strike; 1,\nelastic, without it");
    add_checked(*command, "--wall-restitution", call->wall_restitution, "E", number_from(0.0, 1.0),
                "The same against walls; that of balls without it");
    add_checked(
        *command, "--structure", call->structure, "NAME", one_of(structures),
        fmt::format("What proposes the pairs; the log is the same: {},\n{};\nthe "
                    "last one in the plane alone",
                    structures.front(), fmt::join(structures.begin() + 1, structures.end(), ", ")))
        ->default_str("auto");
    add_checked(*command, "--arithmetic", call->arithmetic, "NAME", one_of({"exact", "naive"}),
                "exact, or naive: plain doubles, for comparison")
        ->default_str("exact");
    add_outputs(*command, *call, simulate_formats, "without it the log goes to standard output");
    add_checked(*command, "--every", call->every, "DT",
                number_from(std::numeric_limits<double>::min(), 1e150),
                "The time between frames; a hundredth of all without");
    add_checked(*command, "--show", call->show, "WHAT", one_of({"structure", "cells"}),
                "In a movie of the plane. structure: what proposes the\npairs, and whom each ball "
                "expects to strike next;\ncells: those of the power diagram, and who has become\na "
                "neighbour of whom");
    add_checked(*command, "--closest", call->closest, "LIST", name_of_file(),
                "Where the list of closest pairs goes: CSV, a line from\n"
                "each time on at which another pair is the closest one");
    add_checked(*command, "--save", call->save, "STATE", name_of_file(),
                "Where the state at the end goes");
    add_checked(*command, "--resume", call->resume, "STATE", name_of_file(),
                "Goes on from a state, instead of FILE");
    command->add_flag("--explain", call->explain,
                      "Says what a scene computes and what it leaves out, and\ndoes not run it");
    command->add_flag("--stats", call->statistics,
                      "Counts, energies and pressure as JSON, to standard\n"
                      "output where the log is not there, else to standard\nerror");
    command->add_flag("--quiet", call->quiet, "No summary and no progress on standard error");
    command->footer(
        "Example:\n"
        "  printf '%s\\n' '0 0 1 1 0' '5 0.5 1 0 0' > two.txt\n"
        "  signum simulate two.txt --until 10 --box -2 -2 8 2 -o log.csv -o movie.svg\n"
        "  signum simulate two.txt --until 10 --structure lists --show structure -o lists.svg");
    command->callback([call] { simulate(*call); });
}

}  // namespace signum::cli
