/// Fixed point: an Integer n stands for n units of 2^-places. Every step rounds by a few units, and
/// there are at most as many steps as places. Multiples of π and of ln 2 that are taken off are so
/// few that 2^size bounds them, and the constants have that many places more. So with fewer than
/// 2^20 places all is off by less than 2^48 units, which 64 places beyond the bits that are asked
/// for make up for.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "../core/contract.hpp"
#include "elementary.hpp"

namespace signum::exact::series {
namespace {

constexpr int guard = 64;
constexpr int off = 48;

[[nodiscard]] Integer in_units(const Dyadic& x, int places) {
    const int shift = x.exponent() + places;
    return shift < 0 ? Integer(x.significand() >> -shift) : Integer(x.significand() << shift);
}

/// The inverse tangent of 1/n, or the inverse hyperbolic one.
[[nodiscard]] Integer inverse_tangent(int n, bool hyperbolic, int places) {
    Integer power = (Integer(1) << places) / n;
    Integer sum = power;
    for (int k = 1; !power.is_zero(); ++k) {
        power /= n * n;
        const Integer term = power / (2 * k + 1);
        if (!hyperbolic && k % 2 != 0) {
            sum -= term;
        } else {
            sum += term;
        }
    }
    return sum;
}

/// Machin 1706.
[[nodiscard]] Integer half_pi(int places) {
    return 8 * inverse_tangent(5, false, places) - 2 * inverse_tangent(239, false, places);
}
[[nodiscard]] Integer ln2(int places) {
    return 18 * inverse_tangent(26, true, places) - 2 * inverse_tangent(4801, true, places) +
           8 * inverse_tangent(8749, true, places);
}

/// x = times · unit + rest, the rest in [0, unit).
struct Reduced {
    Integer times;
    Integer rest;
};

/// By a unit that constant(places) tells.
[[nodiscard]] Reduced reduced(const Dyadic& x, Integer (*constant)(int), int places) {
    const int size = std::max(size_of(x), 0) + 1;
    const Integer unit = constant(places + size);
    const Integer number = in_units(x, places) << size;
    Integer times = floor_of(number, unit);
    Integer rest = (number - times * unit) >> size;
    return {std::move(times), std::move(rest)};
}

/// The sine or cosine of a number in [0, 2).
[[nodiscard]] Integer first_wave(const Integer& x, bool is_sine, int places) {
    const Integer square = (x * x) >> places;
    Integer term = is_sine ? x : Integer(1) << places;
    Integer sum = term;
    for (int n = is_sine ? 1 : 0; !term.is_zero(); n += 2) {
        term = ((term * square) >> places) / ((n + 1) * (n + 2));
        if (n / 2 % 2 == 0) {
            sum -= term;
        } else {
            sum += term;
        }
    }
    return sum;
}

/// sin(x + quarters · π/2).
[[nodiscard]] Dyadic wave(const Dyadic& x, int quarters, int bits) {
    const int places = bits + guard;
    const auto [times, rest] = reduced(x, half_pi, places);
    const int quarter = (Integer(times - 4 * floor_of(times, 4)).convert_to<int>() + quarters) % 4;
    Integer value = first_wave(rest, quarter % 2 == 0, places);
    if (quarter >= 2) value.backend().negate();
    return {std::move(value), -places};
}

struct Enclosed {
    Dyadic low;
    Dyadic high;
};

/// e^x, for x that is itself off by less than 2^off units of 2^(-bits - guard) at most.
[[nodiscard]] Enclosed enclosed_exponential(const Dyadic& x, int bits) {
    const int places = bits + guard;
    const auto [times, rest] = reduced(x, ln2, places);
    Integer term = Integer(1) << places;
    Integer sum = term;
    for (int n = 1; !term.is_zero(); ++n) {
        term = ((term * rest) >> places) / n;
        sum += term;
    }
    const Integer error = Integer(1) << (off + 4);
    const int exponent = times.convert_to<int>() - places;
    return {Dyadic(Integer(sum - error), exponent), Dyadic(Integer(sum + error), exponent)};
}

/// ln x, x > 0, off by less than 2^off units of 2^-places: x = f · 2^size, f in [1/2, 1), and ln f
/// is -2 artanh((1 - f) / (1 + f)).
[[nodiscard]] Dyadic logarithm(const Dyadic& x, int places) {
    const int size = size_of(x);
    const Integer one = Integer(1) << places;
    const Integer f = in_units(Dyadic(x.significand(), x.exponent() - size), places);
    const Integer quotient = ((one - f) << places) / (one + f);
    const Integer square = (quotient * quotient) >> places;
    Integer power = quotient;
    Integer sum = quotient;
    for (int k = 1; !power.is_zero(); ++k) {
        power = (power * square) >> places;
        sum += power / (2 * k + 1);
    }
    return {Integer(size * ln2(places) - 2 * sum), -places};
}

/// Where it is a number with few digits; otherwise it has more digits than a double and one half of
/// its last place, or is irrational. With y = n · 2^-k, n odd, x must be a 2^k-th power.
[[nodiscard]] std::optional<Dyadic> exact_power(double x, double y) {
    auto [m, e, below_zero] = parts(x);
    auto [n, f, inverse] = parts(y);
    SIGNUM_EXPECTS(!below_zero && !inverse);
    if (m == 1 && e == 0) return Dyadic(1.0);
    for (; f < 0; ++f) {
        Integer rest;
        const Integer root = sqrt(Integer(m), rest);
        if (e % 2 != 0 || !rest.is_zero()) return {};
        m = root.convert_to<std::uint64_t>();
        e /= 2;
    }
    // A power of two that is beyond the doubles is found to be so.
    const std::uint64_t most = m == 1 ? 2200 : 64;
    if (f > 11 || n > most || n << f > most) return {};
    const auto times = static_cast<unsigned>(n << f);
    return Dyadic(Integer(pow(Integer(m), times)), e * static_cast<int>(times));
}

[[nodiscard]] double to_double(const Dyadic& x) {
    const double result = round_to_double(x);
    return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
}

/// Of enclosures, enclose(bits), as narrow as it takes. Precondition: the number is neither a
/// double nor half way between two.
template <class Enclose>
[[nodiscard]] double nearest(const Enclose& enclose) {
    for (int bits = 128;; bits *= 2) {
        const Enclosed number = enclose(bits);
        const double low = to_double(number.low);
        if (low == to_double(number.high)) return low;
    }
}

/// e^x is beyond the doubles for greater and for lesser x.
constexpr double most = 710.0;
constexpr double least = -746.0;

}  // namespace

Dyadic sine(const Dyadic& x, int bits) {
    return wave(x, 0, bits + std::max(-size_of(x), 0));
}
Dyadic cosine(const Dyadic& x, int bits) {
    return wave(x, 1, bits);
}

double exponential(double x) {
    if (x > most) return std::numeric_limits<double>::infinity();
    if (x < least) return 0.0;
    const Dyadic exponent(x);
    if (exponent.sign() == 0) return 1.0;
    return nearest([&](int bits) { return enclosed_exponential(exponent, bits); });
}

double power(double x, double y) {
    if (x == std::numeric_limits<double>::infinity()) return x;
    const Dyadic base(x);
    const Dyadic exponent(y);
    if (base.sign() == 0) return 0.0;
    if (const std::optional<Dyadic> exact = exact_power(x, y)) return to_double(*exact);
    // y ln x, the logarithm as much finer as y is large.
    const auto in_exponent = [&](int bits) {
        const int places = bits + guard + std::max(size_of(exponent), 0);
        return exponent * logarithm(base, places);
    };
    const Dyadic rough = in_exponent(64);
    if (rough > Dyadic(most)) return std::numeric_limits<double>::infinity();
    if (rough < Dyadic(least)) return 0.0;
    return nearest([&](int bits) { return enclosed_exponential(in_exponent(bits), bits); });
}

}  // namespace signum::exact::series
