#pragma once
/// Where everything goes while a simulation runs.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../motion/queries.hpp"
#include "../draw/movie.hpp"
#include "../io/motion_state.hpp"
#include "../io/output_file.hpp"
#include "../io/write_motion.hpp"
#include "../scenes/drawn_walls.hpp"
#include "../scenes/energy.hpp"
#include "../scenes/frame_picture.hpp"
#include "../scenes/pair_correlation.hpp"
#include "../scenes/pictures.hpp"
#include "../scenes/snapshot.hpp"

#include "borders.hpp"
#include "motion_summary.hpp"
#include "simulate_run.hpp"

namespace signum::cli {

/// Whether any of them is made from frames.
[[nodiscard]] inline bool has_frames(std::span<const Target> targets) {
    return std::ranges::any_of(targets,
                               [](const Target& target) { return target.format != "csv"; });
}

/// What a movie shows of a structure.
template <int D>
[[nodiscard]] Movie::Shapes shapes_of(const motion::Sketch<D>& sketch) {
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

/// Where everything goes while the simulation runs.
template <int D>
class Recording {
 public:
    /// The call must outlive the object.
    Recording(const SimulateCall& call, std::span<const Target> targets,
              const MotionState<D>& start, motion::Structure structure)
        : call_(call), effects_(start.effects), structure_(structure) {
        for (const Target& target : targets) {
            // These are many files, or made by another program.
            if (target.format == "images" || target.format == "video") continue;
            Sink sink;
            sink.format = target.format;
            if (target.path == standard_output) {
                sink.standard = std::make_unique<DescriptorStream>(1, "standard output");
            } else {
                sink.file = std::make_unique<OutputFile>(target.path);
            }
            if (sink.format == "csv") sink.log = std::make_unique<LogWriter>(sink.stream());
            if (sink.format == "energies")
                sink.energies = std::make_unique<EnergyWriter<D>>(sink.stream(), effects_);
            sinks_.push_back(std::move(sink));
        }
        if (!call.save.empty()) save_ = std::make_unique<OutputFile>(call.save);
        if (!call.closest.empty()) closest_ = std::make_unique<OutputFile>(call.closest);
        if (is_written(targets, "images") || is_written(targets, "video"))
            pictures_ =
                std::make_unique<Pictures>(path_of(targets, "images"), path_of(targets, "video"));
        const bool has_page = is_written(targets, "html");
        if (has_page) run_.emplace(effects_);
        has_pairs_ = is_written(targets, "pair_correlation") || (has_page && effects_.periodic);
        halfway_ = start.state.time + 0.5 * (call.until.value_or(0.0) - start.state.time);
        box_ = effects_.box ? *effects_.box : around(start);
        shown_ = swept(box_, effects_);
        walls_ = drawn_walls(effects_, shown_);
        if (is_written(targets, "svg") || has_page) {
            for (const motion::Ball<D>& ball : start.state.balls) radii_.push_back(ball.radius);
            movie_.emplace(radii_, std::array{shown_.low[0], shown_.low[1]},
                           std::array{shown_.high[0], shown_.high[1]}, effects_.periodic);
            for (const Movie::Wall& wall : walls_) movie_->add_wall(wall);
        }
        has_frames_ = cli::has_frames(targets);
    }

    [[nodiscard]] bool has_log() const {
        return std::ranges::any_of(sinks_, [](const Sink& sink) { return sink.log != nullptr; });
    }
    [[nodiscard]] bool has_frames() const noexcept { return has_frames_; }
    [[nodiscard]] bool shows_structure() const noexcept { return call_.show == "structure"; }
    void strike(const motion::Strike& strike) {
        for (Sink& sink : sinks_)
            if (sink.log) sink.log->put(strike);
    }
    void frame(const motion::State<D>& state, double time, const motion::Counts& counts,
               const motion::Sketch<D>& sketch) {
        if (run_) run_->add(state, time, counts);
        Snapshot<D> snapshot(state, effects_, time);
        MotionFrame& frame = snapshot.frame();
        const motion::Box<D> box = box_at(box_, effects_, time);
        std::ranges::copy(box.low, frame.low.begin());
        std::ranges::copy(box.high, frame.high.begin());
        for (Sink& sink : sinks_) {
            if (sink.format == "xyz") write_xyz(sink.stream(), frame);
            if (sink.energies) sink.energies->put(state, time);
        }
        // The first half is left to whatever settles.
        if (has_pairs_ && time >= halfway_) {
            if (!pairs_) pairs_.emplace(frame);
            pairs_->add(frame);
        }
        std::ranges::copy(shown_.low, frame.low.begin());
        std::ranges::copy(shown_.high, frame.high.begin());
        if (pictures_) pictures_->add(frame_picture(frame, walls_, call_.scene.time));
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
        movie_->add(time, balls, shapes, growth_of(frame));
    }
    /// All files under their names.
    void publish(const Summary<D>& summary, const std::optional<motion::ClosestPairs>& closest) {
        for (Sink& sink : sinks_) {
            if (sink.log) sink.log->finish();
            if (sink.energies) sink.energies->finish();
            if (sink.format == "pair_correlation" && pairs_) pairs_->write(sink.stream());
            if (sink.format == "svg") write_film(sink.stream());
            if (sink.format == "html") {
                std::ostringstream film;
                write_film(film);
                sink.stream() << page_of_run<D>(
                    call_.scene, std::move(film).str(), *run_,
                    pairs_ ? pairs_->shells() : std::vector<PairCorrelation::Shell>{}, summary);
            }
            if (sink.file) sink.file->finish();
            if (sink.standard) sink.standard->flush();
        }
        if (save_) write_motion_state(save_->stream(), summary.end);
        if (closest) write_closest(closest_->stream(), closest->pairs);
        for (Sink& sink : sinks_)
            if (sink.file) sink.file->publish();
        if (save_) save_->publish();
        if (closest) closest_->publish();
        if (pictures_) pictures_->publish();
    }

 private:
    struct Sink {
        std::string format;
        std::unique_ptr<OutputFile> file;  // or else
        std::unique_ptr<DescriptorStream> standard;
        std::unique_ptr<LogWriter> log;
        std::unique_ptr<EnergyWriter<D>> energies;
        [[nodiscard]] std::ostream& stream() { return file ? file->stream() : *standard; }
    };

    void write_film(std::ostream& out) const {
        const std::string structure =
            shows_structure() ? fmt::format("; structure {}", name_of(structure_)) : std::string();
        movie_->write(out,
                      fmt::format("{} ball{}{}{}", radii_.size(), radii_.size() == 1 ? "" : "s",
                                  D == 3 ? ", seen along z" : "", structure),
                      meaning());
    }

    [[nodiscard]] bool shows_cells() const noexcept { return call_.show == "cells"; }
    [[nodiscard]] Movie::Meaning meaning() const {
        if (shows_structure()) {
            const auto& row = motion::structure_table[static_cast<std::size_t>(structure_)];
            return {std::string(row.shapes), std::string(row.links),
                    "whom a ball expects to strike next"};
        }
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

    /// By how much all radii have grown since the start.
    [[nodiscard]] double growth_of(const MotionFrame& frame) const {
        for (std::size_t i = 0; effects_.growth && i < radii_.size(); ++i)
            if (radii_[i] > 0.0) return frame.balls[i].radius / radii_[i];
        return 1.0;
    }
    static std::string path_of(std::span<const Target> targets, std::string_view format) {
        const auto target = std::ranges::find(targets, format, &Target::format);
        return target == targets.end() ? std::string() : target->path;
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

    const SimulateCall& call_;
    motion::Effects<D> effects_;
    motion::Structure structure_;
    std::optional<RunRecord<D>> run_;  ///< for the page
    motion::Box<D> box_;
    motion::Box<D> shown_;  ///< by pictures
    std::vector<Movie::Wall> walls_;
    std::vector<Sink> sinks_;
    std::unique_ptr<OutputFile> save_;
    std::unique_ptr<OutputFile> closest_;
    std::optional<Movie> movie_;
    std::vector<double> radii_;
    std::unique_ptr<Pictures> pictures_;
    std::optional<PairCorrelation> pairs_;
    bool has_pairs_ = false;
    double halfway_ = 0.0;
    bool has_frames_ = false;
};

}  // namespace signum::cli
