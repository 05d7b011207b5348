#pragma once
/// What a strike does: every number rounded once.
///
/// The balls concerned are brought to the time of the strike: each coordinate of x and of v becomes
/// the double nearest to its exact value then (in a periodic box x less as many lengths as bring it
/// back into the box). Of these doubles, with V = v_a - v_b, D = x_a - x_b, the law without
/// friction
///
///     v_a' = v_a - (1+e) m_b/(m_a+m_b) c D,     v_b' = v_b + (1+e) m_a/(m_a+m_b) c D,
///     c = V·D / D·D - ρ / √(D·D),     ρ the rate at which the sum of the radii grows,
///
/// is exact, and each component of the new velocities the double nearest to it; halves to even, a
/// zero is +0. Against a side of the box at rest only the normal component changes, to -e v rounded
/// once; other walls are those of wall_strike.hpp.
///
/// It is no strike, and changes nothing, where the two do not approach at the rounded time or where
/// no component of a velocity would change.

#include "ball.hpp"

namespace signum::motion {

/// Which of the two stages told a strike's doubles.
struct StrikeTally {
    std::uint64_t refined = 0;
    std::uint64_t exact = 0;
};

/// The ball at time t, each coordinate rounded once. Precondition: t is not before its own time.
template <int D>
[[nodiscard]] Ball<D> arrived(const Ball<D>& ball, double t, const Effects<D>& effects,
                              StrikeTally& tally);

/// What a strike goes by.
struct Law {
    double restitution = 1.0;
    double growth = 0.0;  ///< ρ
};

/// What two balls exchange, or a ball and a wall.
struct Exchange {
    bool struck = false;
    /// |V·D - ρ √(D·D)|, where they strike, and D·D; off by less than a part in 2^40. Of a wall w -
    /// n·v + q √(n·n) and n·n (wall_strike.hpp), rounded.
    double approach = 0.0;
    double square = 0.0;
    /// Of two balls (1+e) μ times that, which is the impulse times the distance; rounded somehow.
    double virial = 0.0;
    /// Of a wall the momentum along the normal, the nearest double.
    double impulse = 0.0;
};

/// Whether a ball has stayed in place since its last strike: (V·D)² Δ² <= 2^-80 s² D·D, where Δ is
/// the time since, V and D are those of the strike (V·D the normal speed and D·D = 1 at a wall) and
/// s is the largest of the ball's coordinates and radius. The squares are told in doubles.
enum class InPlace { no, yes, uncertain };
template <int D>
[[nodiscard]] InPlace stayed_in_place(const Ball<D>& ball, double since, double approach,
                                      double square) noexcept;
/// The same, exactly.
template <int D>
[[nodiscard]] bool stayed_in_place_exactly(const Ball<D>& a, const Ball<D>& b,
                                           const Image<D>& image, const Effects<D>& effects,
                                           double before);

/// Changes the velocities of two balls at the same time, or says that it is no strike.
template <int D>
[[nodiscard]] Exchange strike(Ball<D>& a, Ball<D>& b, const Image<D>& image, double mass_a,
                              double mass_b, const Law& law, const Effects<D>& effects,
                              StrikeTally& tally);

/// The momentum that strike() exchanges: (1+e) μ (|V·D| / |D| + ρ), the nearest double. Of the
/// balls before the strike.
template <int D>
[[nodiscard]] double impulse(const Ball<D>& a, const Ball<D>& b, const Image<D>& image,
                             double mass_a, double mass_b, const Law& law,
                             const Effects<D>& effects, StrikeTally& tally);

/// The same of a ball and a side of the box at rest; radii that grow are for wall_strike.hpp.
template <int D>
[[nodiscard]] bool strike(Ball<D>& ball, Wall wall, const Law& law);
template <int D>
[[nodiscard]] double impulse(const Ball<D>& ball, Wall wall, double mass, const Law& law);

}  // namespace signum::motion
