#pragma once
/// A call of signum simulate as it was typed, or as a scene completes it, and its run, from the
/// state at its start to the summary.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../io/motion_state.hpp"
#include "../study/scene_page.hpp"

#include "outputs.hpp"

namespace signum::cli {

/// The call as it was typed.
struct SimulateCall : OutputsCall {
    std::string input;
    std::optional<double> until;
    std::optional<std::uint64_t> events;
    std::string structure;  ///< empty where nobody says one
    std::string arithmetic;
    std::vector<double> box;
    bool periodic = false;
    std::vector<double> gravity;
    std::optional<double> restitution;
    std::optional<double> wall_restitution;
    std::optional<double> every;
    std::string show;
    std::string closest;
    std::string save;
    /// KEY=VALUE, of scenes alone.
    std::vector<std::string> settings;
    /// What a scene records beside what -o says: its path, and a format or "energies",
    /// "pair_correlation", "images", "video".
    std::vector<Target> records;
    /// What its page says of it.
    study::SceneDescription scene;
    std::string resume;
    bool explain = false;
    bool statistics = false;
    bool quiet = false;
};

inline constexpr std::array<Format, 4> simulate_formats = {
    {{"csv", "the log: time,kind,a,b,impulse"},
     {"xyz", "frames in extended XYZ, as OVITO and VMD read them"},
     {"svg", "a movie"},
     {"html", "a page: film, curves, and what is known\nto be true"}}};

/// Whether -o or a scene's record asks for what is made from frames. Throws CallError where -o says
/// what cannot be.
[[nodiscard]] bool wants_frames(const SimulateCall& call);

/// Where results go, as people are told: names of files, "the log to standard output". Throws as
/// wants_frames().
[[nodiscard]] std::string results_in_words(const SimulateCall& call);

/// Throws what keeps the call from being run, as run_simulation() would before it begins: its files
/// are opened, and nothing stays of them.
template <int D>
void check_simulation(const SimulateCall& call, const MotionState<D>& start);

/// Runs, records and says how it went. Throws CallError where the call does not fit the state, or
/// the clock ends the run, CheckFailure for a collapse, MachineError.
template <int D>
void run_simulation(const SimulateCall& call, const MotionState<D>& start);

}  // namespace signum::cli
