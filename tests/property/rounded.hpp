#pragma once
/// Rounding of rationals, for tests of what the library rounds: shares nothing with it.

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace signum {

/// The double nearest to value, halves to even; NaN beyond the doubles. Finds the 53 (or fewer)
/// bits by an integer division and assembles them with ldexp, which is exact here.
inline double rounded(const mpq_class& value) {
    if (value == 0) return 0.0;
    const mpq_class magnitude = abs(value);
    // 2^(e-1) <= magnitude < 2^e
    auto e = static_cast<long>(mpz_sizeinbase(magnitude.get_num_mpz_t(), 2)) -
             static_cast<long>(mpz_sizeinbase(magnitude.get_den_mpz_t(), 2));
    const auto power = [](long exponent) {
        mpq_class result = 1;
        if (exponent >= 0) {
            mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(),
                         static_cast<mp_bitcnt_t>(exponent));
        } else {
            mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(),
                         static_cast<mp_bitcnt_t>(-exponent));
        }
        return result;
    };
    while (magnitude >= power(e)) ++e;
    while (magnitude < power(e - 1)) --e;
    const long unit = std::max(e - 53, -1074L);
    const mpq_class units = magnitude / power(unit);
    mpz_class whole = units.get_num() / units.get_den();
    const mpq_class rest = units - whole;
    const mpq_class half(1, 2);
    if (rest > half || (rest == half && mpz_odd_p(whole.get_mpz_t()))) ++whole;
    // At most 2^53: exact, and exact times a power of two where no bit falls below 2^-1074.
    const double result = std::ldexp(static_cast<double>(whole.get_ui()), static_cast<int>(unit));
    if (!std::isfinite(result)) return std::numeric_limits<double>::quiet_NaN();
    return value < 0 ? -result : result;
}

}  // namespace signum
