#include "simulate_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "../../motion/queries.hpp"
#include "../../motion/simulation.hpp"

#include "commands.hpp"
#include "interrupt.hpp"
#include "motion_summary.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "recording.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// Runs from one frame to the next, or to the end.
template <int D>
motion::Outcome run_all(motion::Simulation<D>& simulation, const SimulateCall& call,
                        Recording<D>& recording, double begin) {
    const double until = call.until.value_or(std::numeric_limits<double>::infinity());
    Progress progress(call.quiet);
    const std::uint64_t most = call.events.value_or(std::numeric_limits<std::uint64_t>::max());
    std::uint64_t done = 0;
    double now = begin;
    typename motion::Simulation<D>::Record record;
    const auto show = [&] {
        const double of_time = until < 1e300 ? (now - begin) / (until - begin) : 0.0;
        const double of_strikes =
            call.events ? static_cast<double>(done) / static_cast<double>(*call.events) : 0.0;
        progress.show(std::max(of_time, of_strikes));
    };
    const auto note = [&](const motion::Strike& strike) {
        ++done;
        now = strike.time;
        recording.strike(strike);
    };
    motion::Limits limits;
    limits.stop = [&] {
        show();
        return interrupted() != 0;
    };
    if (recording.has_log() || call.events) record = note;
    const double step = call.every.value_or((until - begin) / 100.0);
    for (std::uint64_t number = 0;; ++number) {
        const double next = begin + static_cast<double>(number) * step;
        const bool is_last = !recording.has_frames() || !(next < until);
        limits.until = is_last ? until : next;
        limits.strikes = most - done;
        const std::uint64_t before = simulation.counts().strikes;
        const motion::Outcome outcome = simulation.run(limits, record);
        if (!record) done += simulation.counts().strikes - before;
        const bool goes_on =
            outcome.ending == motion::Ending::until || outcome.ending == motion::Ending::nothing;
        if (!goes_on) return outcome;
        if (recording.has_frames()) {
            recording.frame(
                simulation.state(), limits.until, simulation.counts(),
                recording.shows_structure() ? simulation.sketch() : motion::Sketch<D>{});
        }
        if (is_last) return outcome;
        if (interrupted() != 0) return {motion::Ending::stopped, {}};
        now = limits.until;
        show();
    }
}

/// A file beside those of -o: its option, its name and what goes there.
void refuse_bad_file(std::string_view option, const std::string& path, std::string_view what,
                     const SimulateCall& call, std::span<const Target> targets) {
    if (path.empty()) return;
    if (path == standard_output)
        throw CallError(fmt::format("{} -: {} goes to a file; give its name", option, what));
    if (is_same_file(call.input, path))
        throw CallError(
            fmt::format("{} {} would overwrite the input; give another name", option, path));
    for (const Target& target : targets) {
        if (is_same_path(target.path, path))
            throw CallError(
                fmt::format("{} {} is where -o goes, too; give another name", option, path));
    }
}
/// Who is near whom is told of free flights alone.
template <int D>
void refuse_list_of_pairs(const SimulateCall& call, const motion::Effects<D>& effects) {
    if (call.closest.empty() || (!effects.growth && effects.time_step == 0.0)) return;
    throw CallError(
        fmt::format("--closest is for balls that fly freely; leave it out, or leave out {}",
                    effects.growth ? "effects.growth" : "run.time_step"));
}
void refuse_bad_files(const SimulateCall& call, std::span<const Target> targets) {
    refuse_bad_file("--save", call.save, "a state", call, targets);
    refuse_bad_file("--closest", call.closest, "the list", call, targets);
    if (!call.closest.empty() && is_same_path(call.closest, call.save))
        throw CallError(
            fmt::format("--closest {} is where --save goes, too; give another name", call.closest));
}

/// Those of -o, and what a scene records that they do not; the log goes to standard output where
/// there is neither.
std::vector<Target> all_targets(const SimulateCall& call) {
    std::vector<Target> targets;
    if (call.records.empty() || !call.outputs.empty() || !call.format.empty())
        targets = targets_of(call, call.input, simulate_formats);
    const std::size_t of_options = targets.size();
    for (const Target& record : call.records) {
        const auto typed = std::span(targets).first(of_options);
        if (is_written(typed, record.format)) continue;
        for (const Target& target : typed)
            if (is_same_path(target.path, record.path))
                throw CallError(
                    fmt::format("-o {} is where the scene records its {}, too; give another name",
                                target.path, record.format));
        targets.push_back(record);
    }
    return targets;
}

/// With the state at the end, which is none of a format of -o.
std::vector<Target> with_state(std::vector<Target> targets, const SimulateCall& call) {
    if (!call.save.empty()) targets.push_back({call.save, "state"});
    return targets;
}

/// From the start to where the run has come, in a run of its own. Who ends the first run waits for
/// the list of that; who ends the second one has it up to there.
template <int D>
std::optional<motion::ClosestPairs> closest_until(double end, const SimulateCall& call,
                                                  const MotionState<D>& start,
                                                  const motion::Options& options) {
    if (call.closest.empty()) return std::nullopt;
    const double begin = start.state.time;
    Progress progress(call.quiet);
    const int before = interrupted();
    set_interrupted(0);
    const InterruptHandled noted_again = interrupt_noted();
    const auto stop = [&](double time) {
        if (begin < end) progress.show((time - begin) / (end - begin));
        return interrupted() != 0;
    };
    motion::ClosestPairs list =
        motion::closest_pairs(start.state, start.effects, begin, end, options, stop);
    if (interrupted() == 0) set_interrupted(before);
    return list;
}

bool is_interrupted(const std::optional<motion::ClosestPairs>& closest) {
    return closest && closest->outcome.ending == motion::Ending::stopped;
}

std::string describe_list(const SimulateCall& call, const motion::ClosestPairs& closest,
                          double seconds) {
    std::string text =
        fmt::format("{}, {} lines, {:.3g} seconds", call.closest, closest.pairs.size(), seconds);
    if (is_interrupted(closest))
        text += fmt::format(", up to time {:.6g}, interrupted", closest.time);
    return text;
}

/// Where all goes; throws what keeps the call from being run.
template <int D>
std::vector<Target> checked_targets(const SimulateCall& call, const MotionState<D>& start) {
    if (!call.until && !call.events) throw CallError("say when to end: --until T, or --events N");
    if (call.until && *call.until < start.state.time)
        throw CallError(fmt::format("--until {}: the state is that of time {}; give a later one",
                                    *call.until, start.state.time));
    std::vector<Target> targets = all_targets(call);
    const bool is_in_frames = has_frames(targets);
    if (is_in_frames && !call.until) throw CallError("frames need to know the end; add --until T");
    if (call.every && !is_in_frames)
        throw CallError("--every is for frames; add -o FILE.xyz or -o FILE.svg");
    if (call.every) {
        constexpr double most_frames = 1e7;
        if ((*call.until - start.state.time) / *call.every > most_frames)
            throw CallError(fmt::format(
                "--every {}: more than 10 million frames; give a longer one", *call.every));
    }
    refuse_bad_files(call, targets);
    refuse_list_of_pairs(call, start.effects);
    if (!call.show.empty() && !is_written(targets, "svg") && !is_written(targets, "html"))
        throw CallError("--show is for a movie; add -o FILE.svg");
    if (D == 3 && !call.show.empty())
        throw CallError(fmt::format(
            "--show {}: drawn in the plane alone, but the balls lie in space; leave it out",
            call.show));
    return targets;
}

motion::Options options_of(const SimulateCall& call) {
    motion::Options options;
    options.structure = *motion::structure_named(call.structure);
    options.kernel = call.arithmetic == "naive" ? motion::Kernel::naive : motion::Kernel::exact;
    return options;
}

}  // namespace

bool wants_frames(const SimulateCall& call) {
    return has_frames(all_targets(call));
}

std::string results_in_words(const SimulateCall& call) {
    std::vector<std::string> names;
    for (const Target& target : with_state(all_targets(call), call)) {
        const auto format = std::ranges::find(simulate_formats, target.format, &Format::name);
        names.push_back(target.path != standard_output ? target.path
                        : format == simulate_formats.begin()
                            ? "the log to standard output"
                            : fmt::format("{} to standard output", target.format));
    }
    if (!call.closest.empty()) names.push_back(call.closest);
    return fmt::format("{}", fmt::join(names, ", "));
}

template <int D>
void run_simulation(const SimulateCall& call, const MotionState<D>& start) {
    const std::vector<Target> targets = checked_targets(call, start);
    const motion::Options options = options_of(call);
    const motion::Choice choice = motion::choose(options.structure, start.state, start.effects);
    Recording<D> recording(call, targets, start, choice.structure);
    if (!call.quiet && choice.structure != options.structure)
        say("{}\n", fmt::format("structure {}: {}", motion::name_of(choice.structure), choice.why));
    const auto begin = std::chrono::steady_clock::now();
    motion::Simulation<D> simulation(start.state, start.effects, options);
    std::optional<motion::Outcome> outcome;
    std::optional<motion::ClosestPairs> closest;
    std::chrono::duration<double> seconds{};
    std::chrono::duration<double> seconds_of_list{};
    std::string too_fast;
    {
        const InterruptHandled noted = interrupt_noted();
        try {
            outcome = run_all(simulation, call, recording, start.state.time);
            seconds = std::chrono::steady_clock::now() - begin;
            closest = closest_until(simulation.state().time, call, start, options);
            seconds_of_list = std::chrono::steady_clock::now() - begin - seconds;
        } catch (const std::range_error& error) {
            too_fast = fmt::format("{}; the log {}is complete", error.what(),
                                   outcome ? "" : "up to there ");
            if (!call.closest.empty())
                too_fast += fmt::format("; the list {} is not written", call.closest);
        }
    }
    const MotionState<D> end = {simulation.state(), start.effects};
    const Summary<D> summary{start, end, choice, simulation.counts(), seconds.count()};
    recording.publish(summary, closest);
    if (!too_fast.empty()) throw CallError(too_fast);
    if (call.statistics) {
        const bool log_is_there = std::ranges::any_of(
            targets, [](const Target& target) { return target.path == standard_output; });
        if (log_is_there) {
            std::fputs(statistics_of(summary).c_str(), stderr);
        } else {
            print(statistics_of(summary));
        }
    }
    if (outcome->ending == motion::Ending::collapse) {
        std::string what = describe_collapse(outcome->last, start.effects);
        if (is_interrupted(closest))
            what += "; closest pairs: " + describe_list(call, *closest, seconds_of_list.count());
        throw CheckFailure(what);
    }
    if (!call.quiet) {
        say("balls    {}\n", end.state.balls.size());
        say("strikes  {}\n", summary.counts.strikes);
        say("time     {:.6g}, {}\n", end.state.time, in_words(outcome->ending));
        say("seconds  {:.3g}\n", summary.seconds);
        say("{}", written(with_state(targets, call)));
        if (closest) say("closest  {}\n", describe_list(call, *closest, seconds_of_list.count()));
    }
    // As if nobody had caught it.
    if (outcome->ending == motion::Ending::stopped || is_interrupted(closest))
        ::raise(interrupted());
}

template <int D>
void check_simulation(const SimulateCall& call, const MotionState<D>& start) {
    const std::vector<Target> targets = checked_targets(call, start);
    const motion::Choice choice =
        motion::choose(options_of(call).structure, start.state, start.effects);
    // Its files are beside their places, and go with it.
    const Recording<D> opened(call, targets, start, choice.structure);
}

template void check_simulation(const SimulateCall&, const MotionState<2>&);
template void check_simulation(const SimulateCall&, const MotionState<3>&);
template void run_simulation(const SimulateCall&, const MotionState<2>&);
template void run_simulation(const SimulateCall&, const MotionState<3>&);

}  // namespace signum::cli
