#pragma once
/// A run held against what is known to be true of it: conserved quantities, equations of state,
/// distributions, balances of forces.
///
/// Laws:
///  1. A check is there only where what it expects holds: each function says of what runs, and of
///     others returns nothing.
///  2. Where there are too few data to tell good from not good, it says so; what is expected and
///     found depends on the record alone.

#include <optional>
#include <string>
#include <vector>

#include "run_record.hpp"

namespace signum {

enum class Judgement { good, not_good, not_told };

struct Check {
    std::string what;
    std::string expected;  ///< a value or a formula, and where it is from
    std::string found;
    std::string deviation;
    Judgement judgement = Judgement::not_told;
};

/// Of elastic strikes at walls at rest, without friction, growth, fluid and time steps, and without
/// gravity in a periodic box: energy stays, but for rounding.
template <int D>
[[nodiscard]] std::optional<Check> energy_is_conserved(const RunRecord<D>& record);

/// In a periodic box without gravity, fluid and obstacles: momentum stays, but for rounding.
template <int D>
[[nodiscard]] std::optional<Check> momentum_is_conserved(const RunRecord<D>& record);

/// Of an elastic gas of one size in a periodic box: Z = pV/NkT, from the virial of the strikes of
/// the second half and with the error of ten blocks of it, is that of Henderson (Mol. Phys. 30:971,
/// 1975) up to packing 0.6 in the plane, or of Carnahan and Starling (J. Chem. Phys. 51:635, 1969)
/// up to 0.49 in space, within 0.5 %. Told of 200 balls and more.
template <int D>
[[nodiscard]] std::optional<Check> gas_has_known_pressure(const RunRecord<D>& record);

/// Of an elastic gas in a periodic box: energies of balls are those of Maxwell, by chi squared over
/// looks at the second half, which begins after twenty strikes of each ball, with four between.
template <int D>
[[nodiscard]] std::optional<Check> speeds_are_maxwellian(const RunRecord<D>& record);

/// Of a gas of one restitution below 1 in a periodic box, without friction, gravity and time steps:
/// T = T0 / (1 + t/τ)^2 (Haff, J. Fluid Mech. 134:401, 1983) until T is a tenth; the exponent is
/// fitted, and may be off by 0.2, since vortices slow the cooling from early on.
template <int D>
[[nodiscard]] std::optional<Check> gas_cools_as_haff_says(const RunRecord<D>& record);

/// Of an elastic gas under gravity along an axis in a box at rest without obstacles, that would
/// fill less than a fiftieth of the space above the floor: heights are distributed as exp(-m g h /
/// T), by chi squared over looks at the second half between which balls have struck forty times
/// each.
template <int D>
[[nodiscard]] std::optional<Check> heights_are_barometric(const RunRecord<D>& record);

/// Of contacts that stand, under gravity and between walls at rest: all is at rest at the end; at
/// rest the walls bear the weight; and what lies on a floor in a heap lies at less than the angle
/// of friction: its slope from the means of height and of distance from the middle, as a triangle
/// and a cone have them.
template <int D>
[[nodiscard]] std::vector<Check> heap_is_at_rest(const RunRecord<D>& record);

/// In a fluid, without gravity: balls that are farther than three radii from others and from walls,
/// as far as looks tell for as long as drag takes, have the velocity of the current at the end.
template <int D>
[[nodiscard]] std::optional<Check> fluid_carries_balls(const RunRecord<D>& record);

/// Of every run: in no frame are two balls, or a ball and a wall, deeper in one another than
/// rounding, or contacts that stand, make them. On which side of a segment a ball is, is not looked
/// at.
template <int D>
[[nodiscard]] std::vector<Check> nothing_overlaps(const RunRecord<D>& record);

/// All that apply, in this order. Precondition: the record has a moment. O(balls² looks) where
/// there is a fluid, else O(balls · looks) and the frames.
template <int D>
[[nodiscard]] std::vector<Check> check_run(const RunRecord<D>& record);

}  // namespace signum
