#pragma once
/// What a run leaves behind for its curves and checks: numbers at each frame, and whole states at
/// some of them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../motion/simulation.hpp"
#include "overlaps.hpp"

namespace signum {

/// A frame in numbers, in the units of the scene.
struct Moment {
    double time = 0.0;
    double kinetic = 0.0;
    double spin = 0.0;
    double total = 0.0;
    /// The sum of the terms of `total` without their signs: what its rounding is measured by.
    double terms_of_total = 0.0;
    std::array<double, 3> momentum{};
    /// The sum of mass times speed.
    double terms_of_momentum = 0.0;
    double fastest = 0.0;
    /// Of all balls together; 0 where no box tells what they are a share of.
    double packing = 0.0;
    std::uint64_t strikes = 0;  ///< since the run began
    double virial = 0.0;        ///< motion::Counts
    Overlaps overlaps;
};

template <int D>
class RunRecord {
 public:
    /// A whole state, with what had been counted by then.
    struct Look {
        double time = 0.0;
        std::uint64_t strikes = 0;
        motion::State<D> state;
    };
    static constexpr std::size_t most_looks = 64;

    explicit RunRecord(const motion::Effects<D>& effects) : effects_(effects) {}

    /// The next frame; times rise. O(n log n) expected.
    void add(const motion::State<D>& state, double time, const motion::Counts& counts);

    [[nodiscard]] const motion::Effects<D>& effects() const noexcept { return effects_; }
    [[nodiscard]] const std::vector<Moment>& moments() const noexcept { return moments_; }
    /// Of the frames every one, or every second one, and so on, from the first.
    [[nodiscard]] const std::vector<Look>& looks() const noexcept { return looks_; }
    /// Of the last frame. Precondition: there is one.
    [[nodiscard]] const motion::State<D>& end() const noexcept { return end_; }

 private:
    motion::Effects<D> effects_;
    std::vector<Moment> moments_;
    std::vector<Look> looks_;
    motion::State<D> end_;
    std::size_t every_ = 1;
};

}  // namespace signum
