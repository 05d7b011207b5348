/// signum simulate: balls that move and strike, to the log of their strikes.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../draw/movie.hpp"
#include "../io/motion_state.hpp"
#include "../io/output_file.hpp"
#include "../io/read_balls.hpp"
#include "../io/write_motion.hpp"
#include "../motion/queries.hpp"
#include "../motion/simulation.hpp"

#include "borders.hpp"
#include "commands.hpp"
#include "outputs.hpp"
#include "progress.hpp"
#include "sites_call.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct SimulateCall : OutputsCall {
    std::string input;
    std::optional<double> until;
    std::optional<std::uint64_t> events;
    std::string structure = "auto";
    std::string arithmetic = "exact";
    std::vector<double> box;
    bool periodic = false;
    std::vector<double> gravity;
    std::optional<double> restitution;
    std::optional<double> wall_restitution;
    std::optional<double> every;
    std::string show;
    std::string closest;
    std::string save;
    std::string resume;
    bool statistics = false;
    bool quiet = false;
};

constexpr std::array<Format, 3> simulate_formats = {
    {{"csv", "the log: time,kind,a,b,impulse"},
     {"xyz", "frames in extended XYZ, as OVITO and VMD read them"},
     {"svg", "a movie"}}};

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int signal) {
    interrupted = signal;
}

/// While it lives, the first Ctrl-C (or what ends a session or a batch job) is noted, and the
/// second one ends the program.
class InterruptNoted {
 public:
    InterruptNoted() {
        struct sigaction action = {};
        action.sa_handler = note_interrupt;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        for (std::size_t k = 0; k < signals.size(); ++k) {
            is_set_[k] = ::sigaction(signals[k], nullptr, &before_[k]) == 0 &&
                         before_[k].sa_handler != SIG_IGN &&
                         ::sigaction(signals[k], &action, nullptr) == 0;
        }
    }
    InterruptNoted(const InterruptNoted&) = delete;
    InterruptNoted& operator=(const InterruptNoted&) = delete;
    ~InterruptNoted() {
        for (std::size_t k = 0; k < signals.size(); ++k)
            if (is_set_[k]) ::sigaction(signals[k], &before_[k], nullptr);
    }

 private:
    static constexpr std::array signals = {SIGINT, SIGTERM, SIGHUP};
    std::array<struct sigaction, signals.size()> before_ = {};
    std::array<bool, signals.size()> is_set_ = {};
};

motion::Structure structure_of(const std::string& name) {
    return *std::ranges::find_if(motion::all_structures, [&](motion::Structure each) {
        return motion::name_of(each) == name;
    });
}

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

constexpr std::size_t at(int axis) noexcept {
    return static_cast<std::size_t>(axis);
}

/// The balls at a time, in the box where it is periodic.
template <int D>
class Snapshot {
 public:
    Snapshot(const motion::State<D>& state, const motion::Effects<D>& effects, double time) {
        frame_.time = time;
        frame_.dimension = D;
        frame_.periodic = effects.periodic;
        balls_.reserve(state.balls.size());
        for (const motion::Ball<D>& ball : state.balls) {
            MotionFrame::Ball shown;
            for (int k = 0; k < D; ++k) {
                shown.x[at(k)] = in_box(coordinate(ball, k, time, effects), k, effects);
                shown.v[at(k)] = speed(ball, k, time, effects);
            }
            shown.radius = ball.radius;
            balls_.push_back(shown);
        }
        frame_.balls = balls_;
    }
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;
    [[nodiscard]] MotionFrame& frame() noexcept { return frame_; }

 private:
    std::vector<MotionFrame::Ball> balls_;
    MotionFrame frame_;
};

/// Kinetic energy, and that of height where there is gravity.
template <int D>
struct Energy {
    double kinetic = 0.0;
    double total = 0.0;

    Energy(const motion::State<D>& state, const motion::Effects<D>& effects, double time) {
        Snapshot<D> snapshot(state, effects, time);
        std::size_t i = 0;
        for (const MotionFrame::Ball& ball : snapshot.frame().balls) {
            const double mass = state.masses[i++];
            for (int k = 0; k < D; ++k) {
                kinetic += 0.5 * mass * ball.v[at(k)] * ball.v[at(k)];
                total -= mass * effects.gravity[k] * ball.x[at(k)];
            }
        }
        total += kinetic;
    }
};

/// What a movie shows of a structure.
template <int D>
Movie::Shapes shapes_of(const motion::Sketch<D>& sketch) {
    Movie::Shapes shapes;
    for (const auto& [box, level, ball] : sketch.areas)
        shapes.boxes.push_back({{box.low[0], box.low[1]}, {box.high[0], box.high[1]}, level, ball});
    for (const auto& [ball, centre, radius] : sketch.rounds)
        shapes.rounds.push_back({centre[0], centre[1], radius, ball});
    for (const auto& [a, b] : sketch.links)
        shapes.links.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    for (const auto& expected : sketch.expected) {
        if (expected.partner >= 0)
            shapes.expected.emplace_back(static_cast<std::size_t>(expected.ball),
                                         static_cast<std::size_t>(expected.partner));
    }
    return shapes;
}

Movie::Meaning meaning_of(motion::Structure structure) {
    const std::string expected = "whom a ball expects to strike next";
    switch (structure) {
        case motion::Structure::cells:
        case motion::Structure::tree:
            return {"cells with balls in them", "", expected};
        case motion::Structure::levels:
            return {"the cells in which balls live, a colour a size", "", expected};
        case motion::Structure::segments:
            return {"boxes", "partners, whose boxes overlap", expected};
        case motion::Structure::lists:
            return {"shells", "pairs in the lists", expected};
        case motion::Structure::delaunay:
            return {"", "neighbours", expected};
        case motion::Structure::automatic:
        case motion::Structure::pairs:
            break;
    }
    return {"", "", expected};
}

/// Where everything goes while the simulation runs.
template <int D>
class Recording {
 public:
    Recording(const SimulateCall& call, std::span<const Target> targets,
              const MotionState<D>& start, motion::Structure structure)
        : effects_(start.effects), structure_(structure), show_(call.show) {
        for (const Target& target : targets) {
            Sink sink;
            sink.format = target.format;
            if (target.path == standard_output) {
                sink.standard = std::make_unique<DescriptorStream>(1, "standard output");
            } else {
                sink.file = std::make_unique<OutputFile>(target.path);
            }
            sinks_.push_back(std::move(sink));
        }
        if (!call.save.empty()) save_ = std::make_unique<OutputFile>(call.save);
        if (!call.closest.empty()) closest_ = std::make_unique<OutputFile>(call.closest);
        for (Sink& sink : sinks_)
            if (sink.format == "csv") sink.log = std::make_unique<LogWriter>(sink.stream());
        shown_ = effects_.box ? *effects_.box : around(start);
        if (is_written(targets, "svg")) {
            std::vector<double> radii;
            for (const motion::Ball<D>& ball : start.state.balls) radii.push_back(ball.radius);
            movie_.emplace(std::move(radii), std::array{shown_.low[0], shown_.low[1]},
                           std::array{shown_.high[0], shown_.high[1]}, effects_.periodic);
        }
        has_frames_ = movie_.has_value() || is_written(targets, "xyz");
    }

    [[nodiscard]] bool has_log() const {
        return std::ranges::any_of(sinks_, [](const Sink& sink) { return sink.log != nullptr; });
    }
    [[nodiscard]] bool has_frames() const noexcept { return has_frames_; }
    [[nodiscard]] bool shows_structure() const noexcept { return show_ == "structure"; }
    void strike(const motion::Strike& strike) {
        for (Sink& sink : sinks_)
            if (sink.log) sink.log->put(strike);
    }
    void frame(const motion::State<D>& state, double time, const motion::Sketch<D>& sketch) {
        Snapshot<D> snapshot(state, effects_, time);
        MotionFrame& frame = snapshot.frame();
        std::ranges::copy(shown_.low, frame.low.begin());
        std::ranges::copy(shown_.high, frame.high.begin());
        for (Sink& sink : sinks_)
            if (sink.format == "xyz") write_xyz(sink.stream(), frame);
        if (!movie_) return;
        Movie::Shapes shapes = shapes_of(sketch);
        if constexpr (D == 2)
            if (shows_cells() && movie_->keeps_next()) shapes.borders = borders_of(frame);
        std::vector<Movie::Ball> balls;
        for (const MotionFrame::Ball& ball : frame.balls) {
            const double depth =
                D == 3 ? (frame.high[2] - ball.x[2]) / (frame.high[2] - frame.low[2]) : 0.0;
            balls.push_back({ball.x[0], ball.x[1], depth});
        }
        movie_->add(time, balls, shapes);
    }
    /// All files under their names.
    void publish(const MotionState<D>& end, const std::optional<motion::ClosestPairs>& closest) {
        for (Sink& sink : sinks_) {
            if (sink.log) sink.log->finish();
            if (sink.format == "svg") {
                const std::string title = fmt::format(
                    "{} ball{}{}{}", end.state.balls.size(), end.state.balls.size() == 1 ? "" : "s",
                    D == 3 ? ", seen along z" : "",
                    shows_structure() ? fmt::format("; structure {}", name_of(structure_))
                                      : std::string());
                movie_->write(sink.stream(), title, meaning());
            }
            if (sink.file) sink.file->finish();
            if (sink.standard) sink.standard->flush();
        }
        if (save_) write_motion_state(save_->stream(), end);
        if (closest) write_closest(closest_->stream(), closest->pairs);
        for (Sink& sink : sinks_)
            if (sink.file) sink.file->publish();
        if (save_) save_->publish();
        if (closest) closest_->publish();
    }

 private:
    struct Sink {
        std::string format;
        std::unique_ptr<OutputFile> file;  // or else
        std::unique_ptr<DescriptorStream> standard;
        std::unique_ptr<LogWriter> log;
        [[nodiscard]] std::ostream& stream() { return file ? file->stream() : *standard; }
    };

    [[nodiscard]] bool shows_cells() const noexcept { return show_ == "cells"; }
    [[nodiscard]] Movie::Meaning meaning() const {
        if (shows_structure()) return meaning_of(structure_);
        if (shows_cells())
            return {.borders = "borders of cells (power diagram)", .new_borders = "new neighbours"};
        return {};
    }
    [[nodiscard]] std::vector<Movie::Border> borders_of(const MotionFrame& frame) const {
        std::vector<Site> discs;
        for (const MotionFrame::Ball& ball : frame.balls)
            discs.push_back({ball.x[0], ball.x[1], ball.radius});
        return borders_of_cells(discs,
                                {shown_.low[0], shown_.low[1], shown_.high[0], shown_.high[1]},
                                effects_.periodic);
    }

    static motion::Box<D> around(const MotionState<D>& start) {
        motion::Box<D> box;
        box.low.fill(std::numeric_limits<double>::infinity());
        box.high.fill(-std::numeric_limits<double>::infinity());
        for (const motion::Ball<D>& ball : start.state.balls) {
            for (int k = 0; k < D; ++k) {
                const double reach = std::max(ball.radius, 1e-3 * std::fabs(ball.x[k]));
                box.low[k] = std::min(box.low[k], ball.x[k] - reach);
                box.high[k] = std::max(box.high[k], ball.x[k] + reach);
            }
        }
        for (int k = 0; k < D; ++k)
            if (!(box.low[k] < box.high[k])) box.high[k] = box.low[k] + 1.0;
        return box;
    }

    motion::Effects<D> effects_;
    motion::Structure structure_;
    std::string show_;
    motion::Box<D> shown_;
    std::vector<Sink> sinks_;
    std::unique_ptr<OutputFile> save_;
    std::unique_ptr<OutputFile> closest_;
    std::optional<Movie> movie_;
    bool has_frames_ = false;
};

/// What the statistics tell beside the counts.
template <int D>
struct Summary {
    const MotionState<D>& start;
    const MotionState<D>& end;
    motion::Choice choice;
    motion::Counts counts;
    double seconds = 0.0;
};

/// Z = p V / (N k T), from the virial of the strikes.
template <int D>
std::optional<double> compressibility(const Summary<D>& summary, const Energy<D>& before,
                                      const Energy<D>& after) {
    const double time = summary.end.state.time - summary.start.state.time;
    const double kinetic = before.kinetic + after.kinetic;
    if (summary.start.effects.gravity != motion::Vector<D>{} || !(time > 0.0) || !(kinetic > 0.0))
        return std::nullopt;
    return 1.0 + summary.counts.virial / (kinetic * time);
}

template <int D>
std::string statistics_of(const Summary<D>& summary) {
    const Energy<D> before(summary.start.state, summary.start.effects, summary.start.state.time);
    const Energy<D> after(summary.end.state, summary.end.effects, summary.end.state.time);
    const motion::Counts& counts = summary.counts;
    const std::optional<double> z = compressibility(summary, before, after);
    return fmt::format(
        "{{\"balls\": {}, \"strikes\": {}, \"checks\": {}, \"own\": {}, \"stale\": {}, \"stages\": "
        "{{\"filter\": {}, \"exact\": {}, \"multiprecision\": {}}}, \"seconds\": {}, "
        "\"structure\": \"{}\", \"why\": \"{}\", \"time\": {}, \"energy_start\": {}, "
        "\"energy_end\": {}, \"pressure\": {}}}\n",
        summary.end.state.balls.size(), counts.strikes, counts.checks, counts.own, counts.stale,
        counts.checks - std::min(counts.checks, counts.exact), counts.refined, counts.exact,
        summary.seconds, motion::name_of(summary.choice.structure), summary.choice.why,
        summary.end.state.time, before.total, after.total,
        z ? fmt::format("{}", *z) : std::string("null"));
}

std::string_view in_words(motion::Ending ending) {
    switch (ending) {
        case motion::Ending::until:
            return "the time came";
        case motion::Ending::strikes:
            return "the strikes are done";
        case motion::Ending::nothing:
            return "nothing meets any more";
        case motion::Ending::stopped:
            return "interrupted";
        case motion::Ending::collapse:
            break;
    }
    return "a collapse";
}

std::string describe_collapse(const motion::Strike& last) {
    return fmt::format(
        "at time {} ball {} and {} {} strike without end, an inelastic collapse or a ball that "
        "comes to rest; the log up to there is complete",
        last.time, last.a, last.wall ? "wall" : "ball", last.b);
}

/// Runs from one frame to the next, or to the end.
template <int D>
motion::Outcome run_all(motion::Simulation<D>& simulation, const SimulateCall& call,
                        Recording<D>& recording, double begin) {
    const double until = call.until.value_or(std::numeric_limits<double>::infinity());
    std::optional<Progress> progress;
    if (!call.quiet) progress.emplace();
    const std::uint64_t most = call.events.value_or(std::numeric_limits<std::uint64_t>::max());
    std::uint64_t done = 0;
    double now = begin;
    typename motion::Simulation<D>::Record record;
    const auto show = [&] {
        if (!progress) return;
        const double of_time = until < 1e300 ? (now - begin) / (until - begin) : 0.0;
        const double of_strikes =
            call.events ? static_cast<double>(done) / static_cast<double>(*call.events) : 0.0;
        progress->show(std::max(of_time, of_strikes));
    };
    const auto note = [&](const motion::Strike& strike) {
        ++done;
        now = strike.time;
        recording.strike(strike);
    };
    motion::Limits limits;
    limits.stop = [&] {
        show();
        return interrupted != 0;
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
                simulation.state(), limits.until,
                recording.shows_structure() ? simulation.sketch() : motion::Sketch<D>{});
        }
        if (is_last) return outcome;
        if (interrupted != 0) return {motion::Ending::stopped, {}};
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
void refuse_bad_files(const SimulateCall& call, std::span<const Target> targets) {
    refuse_bad_file("--save", call.save, "a state", call, targets);
    refuse_bad_file("--closest", call.closest, "the list", call, targets);
    if (!call.closest.empty() && is_same_path(call.closest, call.save))
        throw CallError(
            fmt::format("--closest {} is where --save goes, too; give another name", call.closest));
}

/// From the start to where the run has come, in a run of its own. Who ends the first run waits for
/// the list of that; who ends the second one has it up to there.
template <int D>
std::optional<motion::ClosestPairs> closest_until(double end, const SimulateCall& call,
                                                  const MotionState<D>& start,
                                                  const motion::Options& options) {
    if (call.closest.empty()) return std::nullopt;
    const double begin = start.state.time;
    std::optional<Progress> progress;
    if (!call.quiet) progress.emplace();
    const int before = interrupted;
    interrupted = 0;
    const InterruptNoted noted_again;
    const auto stop = [&](double time) {
        if (progress && begin < end) progress->show((time - begin) / (end - begin));
        return interrupted != 0;
    };
    motion::ClosestPairs list =
        motion::closest_pairs(start.state, start.effects, begin, end, options, stop);
    if (interrupted == 0) interrupted = before;
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

template <int D>
void run(const SimulateCall& call, const MotionState<D>& start) {
    if (call.until && *call.until < start.state.time)
        throw CallError(fmt::format("--until {}: the state is that of time {}; give a later one",
                                    *call.until, start.state.time));
    const std::vector<Target> targets = targets_of(call, call.input, simulate_formats);
    const bool wants_frames = is_written(targets, "xyz") || is_written(targets, "svg");
    if (wants_frames && !call.until) throw CallError("frames need to know the end; add --until T");
    if (call.every && !wants_frames)
        throw CallError("--every is for frames; add -o FILE.xyz or -o FILE.svg");
    if (call.every) {
        constexpr double most_frames = 1e7;
        if ((*call.until - start.state.time) / *call.every > most_frames)
            throw CallError(fmt::format(
                "--every {}: more than 10 million frames; give a longer one", *call.every));
    }
    refuse_bad_files(call, targets);
    if (!call.show.empty() && !is_written(targets, "svg"))
        throw CallError("--show is for a movie; add -o FILE.svg");
    if (D == 3 && !call.show.empty())
        throw CallError(fmt::format(
            "--show {}: drawn in the plane alone, but the balls lie in space; leave it out",
            call.show));
    motion::Options options;
    options.structure = structure_of(call.structure);
    options.kernel = call.arithmetic == "naive" ? motion::Kernel::naive : motion::Kernel::exact;
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
        const InterruptNoted noted;
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
    recording.publish(end, closest);
    if (!too_fast.empty()) throw CallError(too_fast);
    const Summary<D> summary{start, end, choice, simulation.counts(), seconds.count()};
    if (call.statistics) {
        const bool log_is_there = std::ranges::any_of(
            targets, [](const Target& target) { return target.path == standard_output; });
        if (log_is_there) {
            std::fputs(statistics_of(summary).c_str(), stderr);
        } else {
            DescriptorStream out(1, "standard output");
            out << statistics_of(summary);
            out.flush();
        }
    }
    if (outcome->ending == motion::Ending::collapse) {
        std::string what = describe_collapse(outcome->last);
        if (is_interrupted(closest))
            what += "; closest pairs: " + describe_list(call, *closest, seconds_of_list.count());
        throw CheckFailure(what);
    }
    if (!call.quiet) {
        say("balls    {}\n", end.state.balls.size());
        say("strikes  {}\n", summary.counts.strikes);
        say("time     {:.6g}, {}\n", end.state.time, in_words(outcome->ending));
        say("seconds  {:.3g}\n", summary.seconds);
        say("{}", written(targets));
        if (closest) say("closest  {}\n", describe_list(call, *closest, seconds_of_list.count()));
    }
    // As if nobody had caught it.
    if (outcome->ending == motion::Ending::stopped || is_interrupted(closest))
        ::raise(static_cast<int>(interrupted));
}

/// A state that can be; a damaged one is named.
template <int D>
MotionState<D> resumed(const std::string& path) {
    MotionState<D> result = read_motion_state<D>(path);
    try {
        motion::check(result.state, result.effects);
    } catch (const motion::BallError& error) {
        throw InputError(path,
                         fmt::format("a damaged state; ball {}: {}", error.ball(), error.what()));
    } catch (const std::invalid_argument& error) {
        throw InputError(path, fmt::format("a damaged state; {}", error.what()));
    }
    return result;
}

void refuse_effects_of_state(const SimulateCall& call) {
    if (!call.box.empty() || call.periodic || !call.gravity.empty() || call.restitution ||
        call.wall_restitution) {
        throw CallError(
            "--resume: box, gravity and restitution are those of the state; leave their options "
            "out");
    }
}

void simulate(const SimulateCall& call) {
    if (!call.until && !call.events) throw CallError("say when to end: --until T, or --events N");
    if (call.periodic && call.box.empty())
        throw CallError("--periodic: say of what box; add --box");
    if (!call.resume.empty()) {
        refuse_effects_of_state(call);
        if (!call.input.empty())
            throw CallError("FILE and --resume: the state holds the balls; leave FILE out");
        if (dimension_of_motion_state(call.resume) == 2) {
            run(call, resumed<2>(call.resume));
        } else {
            run(call, resumed<3>(call.resume));
        }
        return;
    }
    if (call.input.empty()) throw CallError("a file of balls is missing; give FILE, or --resume");
    const BallsFile file = read_balls(call.input);
    if (!file.note.empty() && !call.quiet) say("{}\n", file.note);
    if (file.dimension == 2) {
        run(call, started<2>(call, file));
    } else {
        run(call, started<3>(call, file));
    }
}

}  // namespace

void add_simulate(CLI::App& tool) {
    auto call = std::make_shared<SimulateCall>();
    std::vector<std::string> structures;
    for (const motion::Structure each : motion::all_structures)
        structures.emplace_back(motion::name_of(each));
    CLI::App* command = tool.add_subcommand(
        "simulate", "Lets balls move and strike, in the exact order of their strikes");
    command
        ->add_option("FILE", call->input,
                     "Balls, one a line: x y r vx vy [mass], or\n"
                     "x y z r vx vy vz [mass]; - is standard input")
        ->type_name("");
    command->add_option("--until", call->until, "The time to stop at; strikes then are included")
        ->check(number_from(0.0, 1e150))
        ->type_name("T");
    command->add_option("--events", call->events, "Stop after so many strikes")
        ->check(whole_number())
        ->type_name("N");
    command
        ->add_option("--box", call->box,
                     "Walls: the lower corner, then the upper one;\nX0 Y0 Z0 X1 Y1 Z1 in space. A "
                     "movie without it\nshows the place where the balls are at the start")
        ->check(finite_number())
        ->type_name("X0 Y0 [Z0] X1 Y1 [Z1]")
        ->option_text("X0 Y0 X1 Y1")
        ->expected(4, 6);
    command->add_flag("--periodic", call->periodic,
                      "No walls: who leaves the box comes in on the other\nside");
    command->add_option("--gravity", call->gravity, "The acceleration of all balls")
        ->check(finite_number())
        ->type_name("GX GY [GZ]")
        ->option_text("GX GY [GZ]")
        ->expected(2, 3);
    command
        ->add_option("--restitution", call->restitution,
                     "The ratio of speeds after and before a strike; 1,\nelastic, without it")
        ->check(number_from(0.0, 1.0))
        ->type_name("E");
    command
        ->add_option("--wall-restitution", call->wall_restitution,
                     "The same against walls; that of balls without it")
        ->check(number_from(0.0, 1.0))
        ->type_name("E");
    command
        ->add_option("--structure", call->structure,
                     fmt::format("What proposes the pairs; the log is the same: {},\n{};\nthe "
                                 "last one in the plane alone",
                                 structures.front(),
                                 fmt::join(structures.begin() + 1, structures.end(), ", ")))
        ->transform(one_of(structures))
        ->type_name("NAME")
        ->capture_default_str();
    command
        ->add_option("--arithmetic", call->arithmetic,
                     "exact, or naive: plain doubles, for comparison")
        ->transform(one_of({"exact", "naive"}))
        ->type_name("NAME")
        ->capture_default_str();
    add_outputs(*command, *call, simulate_formats, "without it the log goes to standard output");
    command
        ->add_option("--every", call->every, "The time between frames; a hundredth of all without")
        ->check(number_from(std::numeric_limits<double>::min(), 1e150))
        ->type_name("DT");
    command
        ->add_option(
            "--show", call->show,
            "In a movie of the plane. structure: what proposes the\npairs, and whom each ball "
            "expects to strike next;\ncells: those of the power diagram, and who has become\na "
            "neighbour of whom")
        ->transform(one_of({"structure", "cells"}))
        ->type_name("WHAT");
    command
        ->add_option("--closest", call->closest,
                     "Where the list of closest pairs goes: CSV, a line from\n"
                     "each time on at which another pair is the closest one")
        ->check(name_of_file())
        ->type_name("LIST");
    command->add_option("--save", call->save, "Where the state at the end goes")
        ->check(name_of_file())
        ->type_name("STATE");
    command->add_option("--resume", call->resume, "Goes on from a state, instead of FILE")
        ->check(name_of_file())
        ->type_name("STATE");
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
