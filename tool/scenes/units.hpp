#pragma once
/// Quantities as people write them, "9.81 m/s^2", and the units in which a scene means its plain
/// numbers.
///
/// A unit is a product of powers of named ones: "mm", "kg m/s^2", "1/s", "rad/s". Names may have
/// the prefixes n, u, m, c, k, M. An angle is a dimension of its own, so that 1 Hz, 60 rpm and
/// 6.28 rad/s are angular frequencies, and 1/s is not.
///
/// A unit's size is kept as a fraction, a power of ten and one of π: who writes "5 mm" in a scene
/// of metres gets the double nearest to 0.005, and in one of millimetres 5.

#include <string>
#include <string_view>
#include <variant>

#include "../../motion/field.hpp"

namespace signum {

using motion::Dimension;
namespace dimensions = motion::dimensions;

/// How many metres, seconds, kilograms and radians: numerator / denominator · 10^tens · π^pis.
struct Unit {
    Dimension dimension;
    double numerator = 1.0;  ///< a whole number, as the denominator is
    double denominator = 1.0;
    int tens = 0;
    int pis = 0;
};

/// The unit of a text, or what is wrong with it in a sentence.
[[nodiscard]] std::variant<Unit, std::string> parse_unit(std::string_view text);

/// In what a scene means plain numbers. Angles are radians.
class Units {
 public:
    /// Metres, seconds and kilograms.
    Units() = default;

    /// Takes a unit of length, time or mass for that dimension. Precondition: it is of one of
    /// these, to the first power.
    void take(const Unit& unit, std::string_view name);

    /// A quantity of the unit as a plain number: one rounding where the fraction is 1, three at
    /// most.
    [[nodiscard]] double plain(double value, const Unit& unit) const;
    /// How the unit of a dimension is written here: "mm/s^2"; empty for plain numbers.
    [[nodiscard]] std::string name_of(const Dimension& dimension) const;

 private:
    Unit length_{dimensions::length};
    Unit time_{dimensions::time};
    Unit mass_{dimensions::mass};
    std::string names_[3] = {"m", "s", "kg"};
};

/// "an acceleration", "a plain number".
[[nodiscard]] std::string in_words(const Dimension& dimension);

/// Where the unit begins in a text like "9.81 m/s^2": behind the number and blanks.
[[nodiscard]] std::size_t begin_of_unit(std::string_view quantity);

}  // namespace signum
