#pragma once
/// Degenerate geometry made of moves: what random sites never are, and what predicates are wrong
/// about when they are wrong.
///
/// Laws:
///  1. Before anything is moved by ulps, put on a circle of three or made of raw bits all numbers
///     are integers times a power of two, and what is said to touch, to lie on one line or to be
///     nested does so exactly.
///  2. One seed gives the same doubles everywhere.

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string_view>

namespace signum::hard {

/// A site of the plane (d = 2) or of space (d = 3).
template <std::size_t d>
struct Ball {
    std::array<double, d> centre = {};
    double size = 0.0;  ///< radius or weight
    friend bool operator==(const Ball&, const Ball&) = default;
};

/// What it is to touch: the power metric by three kinds of sites, and the metrics with additive
/// weights.
enum class Kind : std::uint8_t {
    points,   ///< power, all sizes 0
    weights,  ///< power, the size is a weight
    radii,    ///< power, the size is a radius, whose square is the weight
    euclidean,
    supremum,
    manhattan
};
inline constexpr std::array<Kind, 6> all_kinds = {Kind::points,    Kind::weights,  Kind::radii,
                                                  Kind::euclidean, Kind::supremum, Kind::manhattan};
[[nodiscard]] std::string_view name_of(Kind kind) noexcept;

/// Makes and moves the balls of one pattern, at most a few dozen.
template <std::size_t d>
class Moves {
 public:
    using Balls = std::span<Ball<d>>;

    explicit Moves(std::uint64_t seed) : bits_(seed) {}

    /// Uniform from `least` to `most`.
    [[nodiscard]] std::int64_t integer(std::int64_t least, std::int64_t most);
    /// Once in so many times.
    [[nodiscard]] bool once_in(std::int64_t times) { return integer(1, times) == 1; }

    // ---- what makes a pattern of small integers ------------------------------------------------

    /// Anywhere among few places, so that copies, lines and common circles are frequent.
    void lattice(Kind kind, Balls balls);
    /// All touch one sphere from outside, or lie on one.
    void tangent(Kind kind, Balls balls);
    /// All touch one line, in space one plane, from the same side; or their centres lie on it.
    void in_line(Kind kind, Balls balls);
    /// Each touches the one before it from inside; of the power metric: concentric ones, of lattice
    /// sizes.
    void nest(Kind kind, Balls balls);
    /// (t, t², r = t²), in space (s, t, s² + t², r = s² + t²): all touch one line, or one plane.
    void parabola(Kind kind, Balls balls);

    // ---- what keeps integers integers ----------------------------------------------------------

    /// One becomes another one.
    void copy(Balls balls);
    /// One becomes the mirror image of another one, in a line or plane that exchanges two axes or
    /// turns one around, at a third one's centre.
    void mirror(Balls balls);
    /// The last one's centre goes where the mirror that exchanges the first two has that of the
    /// third: onto the circle of these three, if they are points or their sizes are equal. Exact
    /// where the quotient in it is; otherwise rounded, and then off by ulps.
    void put_on_circle_of_three(Balls balls);
    /// All are multiplied by an integer below 2^bits, weights by its square.
    void enlarge(Kind kind, Balls balls, int bits);
    /// All centres are moved by integers below 2^bits, and all radii by one, where only their
    /// differences matter.
    void shift(Kind kind, Balls balls, int bits);

    // ---- what does not -------------------------------------------------------------------------

    /// All are multiplied by 2^exponent, weights by its square.
    void scale(Kind kind, Balls balls, int exponent);
    /// So many numbers of all the balls are moved by at most so many ulps, to either side, perhaps
    /// by none. The ulp of a 0 is that of the largest number.
    void move_by_ulps(Kind kind, Balls balls, int numbers, int most);
    /// Any finite bit patterns.
    void raw(Kind kind, Balls balls);
    /// Any significands, with exponents at most so many apart from one another.
    void raw(Kind kind, Balls balls, int exponents);

    /// One of the patterns, with copies and mirror images, enlarged and shifted: integers below
    /// 2^53.
    void any_pattern(Kind kind, Balls balls);

    /// Balls whose numbers have a few magnitudes far apart, at the ends of the doubles' range and
    /// about those where products begin to overflow or to underflow: a pattern of which axes and
    /// sizes, or some balls, or some sizes alone, have one of their own; or numbers of few
    /// significands, so that many are equal.
    void extremes(Kind kind, Balls balls);

 private:
    [[nodiscard]] int extreme_exponent();
    template <class Many>
    [[nodiscard]] auto& any_of(Many& many);

    std::mt19937_64 bits_;
};

extern template class Moves<2>;
extern template class Moves<3>;

}  // namespace signum::hard
