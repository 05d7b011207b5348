#include "units.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "../io/errors.hpp"
#include "../io/nearest_word.hpp"
#include "../io/number.hpp"

namespace signum {
namespace {

struct NamedUnit {
    std::string_view name;
    bool takes_prefix;
    Unit unit;
};
constexpr Dimension force{.length = 1, .time = -2, .mass = 1};
constexpr std::array<NamedUnit, 18> named_units = {{
    {"m", true, {dimensions::length}},
    {"s", true, {dimensions::time}},
    {"g", true, {.dimension = dimensions::mass, .tens = -3}},
    {"t", false, {.dimension = dimensions::mass, .tens = 3}},
    {"in", false, {.dimension = dimensions::length, .numerator = 254, .tens = -4}},
    {"ft", false, {.dimension = dimensions::length, .numerator = 3048, .tens = -4}},
    {"lb", false, {.dimension = dimensions::mass, .numerator = 45359237, .tens = -8}},
    {"min", false, {.dimension = dimensions::time, .numerator = 60}},
    {"h", false, {.dimension = dimensions::time, .numerator = 3600}},
    {"rad", false, {dimensions::angle}},
    {"deg", false, {.dimension = dimensions::angle, .denominator = 180, .pis = 1}},
    {"turn", false, {.dimension = dimensions::angle, .numerator = 2, .pis = 1}},
    {"Hz", true, {.dimension = dimensions::angular_speed, .numerator = 2, .pis = 1}},
    {"rpm", false, {.dimension = dimensions::angular_speed, .denominator = 30, .pis = 1}},
    {"N", true, {force}},
    {"J", true, {dimensions::energy}},
    {"%", false, {.dimension = dimensions::number, .tens = -2}},
    {"1", false, {dimensions::number}},
}};
struct Prefix {
    std::string_view name;
    int tens;
};
constexpr std::array<Prefix, 6> prefixes = {
    {{"n", -9}, {"u", -6}, {"m", -3}, {"c", -2}, {"k", 3}, {"M", 6}}};

std::optional<Unit> unit_named(std::string_view name) {
    for (const NamedUnit& each : named_units)
        if (each.name == name) return each.unit;
    for (const Prefix& prefix : prefixes) {
        if (!name.starts_with(prefix.name)) continue;
        for (const NamedUnit& each : named_units) {
            if (!each.takes_prefix || each.name != name.substr(prefix.name.size())) continue;
            Unit unit = each.unit;
            unit.tens += prefix.tens;
            return unit;
        }
    }
    return std::nullopt;
}

/// In the order in which they are proposed.
std::vector<std::string> names_of_units() {
    std::vector<std::string> names = {"mm", "cm", "um", "km", "ms", "us", "kg", "mg"};
    for (const NamedUnit& each : named_units)
        if (each.name != "1") names.emplace_back(each.name);
    return names;
}

void multiply(Unit& product, const Unit& unit, int power) {
    product.dimension.length += power * unit.dimension.length;
    product.dimension.time += power * unit.dimension.time;
    product.dimension.mass += power * unit.dimension.mass;
    product.dimension.angle += power * unit.dimension.angle;
    product.tens += power * unit.tens;
    product.pis += power * unit.pis;
    for (int i = 0; i < std::abs(power); ++i) {
        product.numerator *= power > 0 ? unit.numerator : unit.denominator;
        product.denominator *= power > 0 ? unit.denominator : unit.numerator;
    }
}

/// Common factors go out, so that like units cancel.
void reduce(Unit& unit) {
    constexpr double largest = 0x1p53;
    if (unit.numerator > largest || unit.denominator > largest) return;
    const auto common = static_cast<double>(
        std::gcd(static_cast<long long>(unit.numerator), static_cast<long long>(unit.denominator)));
    unit.numerator /= common;
    unit.denominator /= common;
}

bool separates_factors(char c) {
    return c == ' ' || c == '\t';
}

std::string to_the_power(std::string_view name, int power) {
    return power == 1 ? std::string(name) : fmt::format("{}^{}", name, power);
}

}  // namespace

std::variant<Unit, std::string> parse_unit(std::string_view text) {
    constexpr std::string_view operators = " \t*/^";
    Unit result;
    bool divides = false;
    bool is_empty = true;
    std::size_t i = 0;
    while (i < text.size()) {
        if (separates_factors(text[i]) || text[i] == '*') {
            ++i;
            continue;
        }
        if (text[i] == '/') {
            divides = true;
            ++i;
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(operators, i), text.size());
        const std::string_view name = text.substr(i, end - i);
        const std::optional<Unit> unit = unit_named(name);
        if (!unit) {
            const auto meant = nearest_word(name, names_of_units());
            return fmt::format(
                "{} is no unit{}; there are m, s, g, in, ft, lb, t, min, h, rad, "
                "deg, turn, Hz, rpm, N, J and %, with the prefixes n, u, m, c, k, M",
                in_quotes(name), meant ? fmt::format("; did you mean {}?", *meant) : "");
        }
        i = end;
        int power = 1;
        if (i < text.size() && text[i] == '^') {
            const std::size_t first = ++i;
            if (i < text.size() && text[i] == '-') ++i;
            const std::size_t digit = i;
            while (i < text.size() && text[i] >= '0' && text[i] <= '9') ++i;
            if (i == digit || i > digit + 1)
                return fmt::format("a power that is no digit; write it like {}^2", name);
            power = std::atoi(std::string(text.substr(first, i - first)).c_str());
        }
        multiply(result, *unit, divides ? -power : power);
        divides = false;
        is_empty = false;
    }
    if (is_empty || divides) return std::string("a unit is missing");
    reduce(result);
    return result;
}

void Units::take(const Unit& unit, std::string_view name) {
    const int which = unit.dimension.length != 0 ? 0 : unit.dimension.time != 0 ? 1 : 2;
    (which == 0 ? length_ : which == 1 ? time_ : mass_) = unit;
    names_[which] = name;
}

double Units::plain(double value, const Unit& unit) const {
    Unit ratio = unit;
    multiply(ratio, length_, -unit.dimension.length);
    multiply(ratio, time_, -unit.dimension.time);
    multiply(ratio, mass_, -unit.dimension.mass);
    reduce(ratio);
    // Powers of ten up to the 22nd are doubles; those of negative powers are not, and divide.
    double tens = 1.0;
    for (int i = 0; i < std::abs(ratio.tens); ++i) tens *= 10.0;
    double upper = ratio.numerator * (ratio.tens > 0 ? tens : 1.0);
    const double lower = ratio.denominator * (ratio.tens < 0 ? tens : 1.0);
    for (int i = 0; i < ratio.pis; ++i) upper *= std::numbers::pi;
    return value * upper / lower;
}

std::string Units::name_of(const Dimension& dimension) const {
    std::string above;
    std::string below;
    const auto put = [&](std::string_view name, int power) {
        if (power > 0) above += (above.empty() ? "" : " ") + to_the_power(name, power);
        if (power < 0) below += "/" + to_the_power(name, -power);
    };
    put(names_[2], dimension.mass);
    put("rad", dimension.angle);
    put(names_[0], dimension.length);
    put(names_[1], dimension.time);
    if (above.empty() && !below.empty()) above = "1";
    return above + below;
}

std::string in_words(const Dimension& dimension) {
    using namespace dimensions;
    constexpr std::array<std::pair<Dimension, std::string_view>, 10> names = {
        {{number, "a plain number"},
         {length, "a length"},
         {time, "a time"},
         {mass, "a mass"},
         {angle, "an angle"},
         {speed, "a speed"},
         {acceleration, "an acceleration"},
         {rate, "a rate"},
         {angular_speed, "an angular frequency"},
         {energy, "an energy"}}};
    for (const auto& [each, name] : names)
        if (each == dimension) return std::string(name);
    return fmt::format("a quantity in {}", Units().name_of(dimension));
}

std::size_t begin_of_unit(std::string_view quantity) {
    const auto is_digit = [&](std::size_t i) {
        return i < quantity.size() && quantity[i] >= '0' && quantity[i] <= '9';
    };
    const auto is_sign = [&](std::size_t i) {
        return i < quantity.size() && (quantity[i] == '+' || quantity[i] == '-');
    };
    std::size_t i = is_sign(0) ? 1 : 0;
    while (is_digit(i) || (i < quantity.size() && quantity[i] == '.')) ++i;
    if (i < quantity.size() && (quantity[i] == 'e' || quantity[i] == 'E')) {
        const std::size_t exponent = is_sign(i + 1) ? i + 2 : i + 1;
        if (is_digit(exponent)) {
            i = exponent;
            while (is_digit(i)) ++i;
        }
    }
    while (i < quantity.size() && separates_factors(quantity[i])) ++i;
    return i;
}

}  // namespace signum
