#pragma once
/// Where balls are put that nobody has placed: by chance, on a lattice, or by growing.
///
/// Laws:
///  1. No two balls overlap, none overlaps a ball that was there before, the sides of the region or
///     an obstacle at t = 0; a part in 10^9 is left between them.
///  2. The same arguments give the same doubles on every machine.

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "../../motion/simulation.hpp"

namespace signum {

/// Where balls may be put: all of each lies in it, but in a periodic one, where centres do.
template <int D>
struct Region {
    motion::Box<D> box;
    bool periodic = false;
    /// Of what balls can fill: less than that of the box where an obstacle bounds the place.
    double volume = 0.0;

    [[nodiscard]] const motion::Box<D>* periodic_box() const { return periodic ? &box : nullptr; }
};

/// There is no place for all; what() says what would help.
class NoPlaceError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// What is there already.
template <int D>
struct Surroundings {
    std::span<const motion::Body<D>> balls;
    std::span<const motion::Obstacle<D>> obstacles;
};

/// Centres in the order of the radii: large balls first, each where a random place is free. Throws
/// NoPlaceError after 20 000 places in vain, which is to be expected above half of the plane or a
/// third of space. O(n) expected well below that.
template <int D>
[[nodiscard]] std::vector<motion::Vector<D>> place_by_chance(const Region<D>& region,
                                                             std::span<const double> radii,
                                                             const Surroundings<D>& surroundings,
                                                             std::uint64_t seed);

/// On the lattice of points whose coordinates are whole and even in sum (in the plane that of a
/// hexagonal packing where the box allows it, in space face-centred cubic), stretched to fill the
/// region; all cells are for the largest ball. Where there are more points than balls, those that
/// stay empty lie evenly. Throws NoPlaceError. O(n log n).
template <int D>
[[nodiscard]] std::vector<motion::Vector<D>> place_on_lattice(const Region<D>& region,
                                                              std::span<const double> radii,
                                                              const Surroundings<D>& surroundings);

/// From small balls at random, which fly, strike and grow until they have their radii (Lubachevsky,
/// Stillinger, J. Stat. Phys. 60:561, 1990). Throws NoPlaceError where they jam before, or where
/// the region holds balls already. About a thousand strikes a ball near jamming.
template <int D>
[[nodiscard]] std::vector<motion::Vector<D>> place_by_growth(const Region<D>& region,
                                                             std::span<const double> radii,
                                                             const Surroundings<D>& surroundings,
                                                             std::uint64_t seed);

}  // namespace signum
