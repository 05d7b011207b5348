#pragma once
/// Which integers and rationals stand behind the multiprecision stages, and what they are asked in
/// words of their own: GMP's, or with SIGNUM_WITHOUT_GMP those of Boost.Multiprecision, which need
/// no library. Nothing else knows. For sources only.
///
/// Law: whichever they are, every sign and every rounded number is the same, for both are exact.

#include <cstdint>

#if defined(SIGNUM_WITHOUT_GMP)
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <boost/multiprecision/gmp.hpp>
#endif

namespace signum::exact {

#if defined(SIGNUM_WITHOUT_GMP)
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
#else
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
#endif

/// The magnitude is below 2^bits, and at least half of that; of 0 it is 0.
[[nodiscard]] inline std::int64_t bits_of(const Integer& number) {
#if defined(SIGNUM_WITHOUT_GMP)
    return number.is_zero() ? 0 : static_cast<std::int64_t>(msb(abs(number))) + 1;
#else
    return number.is_zero() ? 0
                            : static_cast<std::int64_t>(mpz_sizeinbase(number.backend().data(), 2));
#endif
}

/// number · 2^exponent.
[[nodiscard]] inline Rational scaled(Rational number, int exponent) {
#if defined(SIGNUM_WITHOUT_GMP)
    const Integer power = Integer(1) << (exponent < 0 ? -exponent : exponent);
    if (exponent < 0) {
        number /= power;
    } else {
        number *= power;
    }
#else
    const mpq_ptr data = number.backend().data();
    if (exponent < 0) {
        mpq_div_2exp(data, data, static_cast<mp_bitcnt_t>(-exponent));
    } else {
        mpq_mul_2exp(data, data, static_cast<mp_bitcnt_t>(exponent));
    }
#endif
    return number;
}

/// The greatest integer not above a / b, b > 0.
[[nodiscard]] inline Integer floor_of(const Integer& a, const Integer& b) {
    Integer quotient;
#if defined(SIGNUM_WITHOUT_GMP)
    Integer rest;
    divide_qr(a, b, quotient, rest);
    if (rest.sign() < 0) --quotient;
#else
    mpz_fdiv_q(quotient.backend().data(), a.backend().data(), b.backend().data());
#endif
    return quotient;
}

/// A number is fraction · 2^exponent, but for what is cut off behind the 53rd digit; the fraction's
/// magnitude is in [1/2, 1).
struct LeadingDigits {
    double fraction;
    std::int64_t exponent;
};

/// Precondition: the number is not 0.
[[nodiscard]] inline LeadingDigits leading_digits(const Integer& number) {
#if defined(SIGNUM_WITHOUT_GMP)
    const std::int64_t exponent = bits_of(number);
    Integer magnitude = abs(number);
    if (exponent > 53) magnitude >>= exponent - 53;
    const double digits = static_cast<double>(magnitude.convert_to<std::uint64_t>());
    const double one = exponent > 53 ? 0x1p53 : static_cast<double>(std::uint64_t{1} << exponent);
    return {number.sign() < 0 ? -digits / one : digits / one, exponent};
#else
    long exponent = 0;
    const double fraction = mpz_get_d_2exp(&exponent, number.backend().data());
    return {fraction, exponent};
#endif
}

}  // namespace signum::exact
