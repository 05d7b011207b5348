#pragma once
/// Questions about balls in flight: what strikes when, who is near whom.
///
/// They are asked of a state, and of a simulation by its state(): nothing of it is disturbed. What
/// lies ahead is told by a copy that runs there; it costs O(n) to make and then as much as
/// Simulation::run. What is past is not known, and a time before that of the state is refused.
///
/// Near is the gap between surfaces, |x_a - x_b| - (r_a + r_b), in a periodic box that of the
/// nearest image; below 0 where balls overlap. It is a number of exact doubles: which of two gaps
/// is less is decided exactly, and of equal ones the pair with the smaller numbers, a before b, is
/// taken as the closer one. What is reported is the nearest double.
///
/// All throw as Simulation does, and std::invalid_argument for times that are before the state's,
/// not finite or in the wrong order. Those about gaps throw std::range_error where, in a periodic
/// box, a ball has flown more than 2^29 box lengths, or where a pair may be nearest in a million
/// images, since it flies so far between two neighbouring doubles of time, or its radii are more
/// than 2^50 box lengths. A `stop` that throws ends a question with what it throws.
///
/// Source: M. Gavrilova, Proximity and Applications in General Metrics, thesis, Calgary 1998, 8.7.

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "simulation.hpp"

namespace signum::motion {

/// The state as it will be at a time, after the strikes at that time. Throws std::range_error where
/// the balls collapse before.
template <int D>
[[nodiscard]] State<D> state_at(const State<D>& state, const Effects<D>& effects, double time,
                                const Options& options = {});

/// What strikes in a stretch of time.
struct StrikeList {
    std::vector<Strike> strikes;  ///< in their order
    /// A collapse: the list is complete up to the time of outcome.last.
    Outcome outcome;
};
/// All strikes at `begin`, at `end` and between, in their order; without those that are done when
/// the state is as it is.
template <int D>
[[nodiscard]] StrikeList strikes_between(const State<D>& state, const Effects<D>& effects,
                                         double begin, double end, const Options& options = {});

/// The first strike later than a time and not later than `until`; none where nothing strikes then,
/// or the balls collapse before. In a periodic box balls that never meet fly for ever without
/// `until`.
template <int D>
[[nodiscard]] std::optional<Strike> next_strike(
    const State<D>& state, const Effects<D>& effects, double time,
    double until = std::numeric_limits<double>::infinity(), const Options& options = {});

/// Who is near.
struct Neighbour {
    std::int32_t ball = 0;  ///< its number
    double gap = 0.0;       ///< between the surfaces
    friend bool operator==(const Neighbour&, const Neighbour&) = default;
};
/// The nearest neighbour of a ball at the time of the state; none of a ball alone. Throws
/// std::out_of_range for a number that no ball has and, as all that tells who is near does,
/// std::invalid_argument for effects with growth or time steps. O(n).
template <int D>
[[nodiscard]] std::optional<Neighbour> nearest(const State<D>& state, const Effects<D>& effects,
                                               std::int32_t ball);

/// Two balls with the least gap of all.
struct ClosestPair {
    /// When it is the closest one, or begins to be.
    double time = 0.0;
    /// a < b.
    std::int32_t a = 0;
    std::int32_t b = 0;  ///< the larger number
    /// At that time.
    double gap = 0.0;
    friend bool operator==(const ClosestPair&, const ClosestPair&) = default;
};
/// The closest pair at the time of the state; none where there are fewer than two balls.
/// O(n log n) expected.
template <int D>
[[nodiscard]] std::optional<ClosestPair> closest_pair(const State<D>& state,
                                                      const Effects<D>& effects);

/// Which pair is the closest, as time goes on.
struct ClosestPairs {
    std::vector<ClosestPair> pairs;  ///< in the order of their times
    /// The list is complete up to here: the end, after a collapse the time of outcome.last, after a
    /// stop some time before.
    double time = 0.0;
    Outcome outcome;  ///< how the run ended
};
/// Which pair is the closest one from `begin` to `end`: the one right after `begin`, and from each
/// time on, right after which it is another one, that one. These times, which are roots of
/// polynomials, are in their exact order, so that two may have the same nearest double; at such a
/// time itself two gaps are equal. Of a time of strikes what is right after them. `stop` is told
/// at every strike and now and then between up to when the list is complete, and asked whether to
/// stop.
///
/// From strike to strike O(n log n) expected and O(k) a change, k the number of pairs that may come
/// as near as the closest one; where these are too many the time is halved.
template <int D>
[[nodiscard]] ClosestPairs closest_pairs(const State<D>& state, const Effects<D>& effects,
                                         double begin, double end, const Options& options = {},
                                         const std::function<bool(double)>& stop = {});

}  // namespace signum::motion
