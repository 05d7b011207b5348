#pragma once
/// Sines, cosines, exponentials and powers: those of MPFR or, where the library is built without
/// GMP, their series in integers. For sources only.
///
/// Laws:
///  1. exponential and power are the nearest double, denormals rounded once; so they are the same
///     everywhere;
///  2. sine and cosine are off by less than they say, which is all that may be relied on;
///  3. no rounding mode, no flushing of denormals.

#include "dyadic.hpp"

namespace signum::exact {

/// The sine of x, |x| < 2^size, off by at most 2^(min(size, 0) - bits). Precondition: x is not 0.
[[nodiscard]] Dyadic sine(const Dyadic& x, int bits);
/// The cosine of x, off by at most 2^-bits. Precondition: x is not 0.
[[nodiscard]] Dyadic cosine(const Dyadic& x, int bits);

/// e^x; an infinity where that is beyond the doubles. Precondition: x is not NaN.
[[nodiscard]] double exponential(double x);
/// x^y; an infinity where that is beyond the doubles. Preconditions: x >= 0, possibly infinite; y >
/// 0 is finite.
[[nodiscard]] double power(double x, double y);

/// The same from integers alone, whatever the library is built with.
namespace series {

[[nodiscard]] Dyadic sine(const Dyadic& x, int bits);
[[nodiscard]] Dyadic cosine(const Dyadic& x, int bits);
[[nodiscard]] double exponential(double x);
[[nodiscard]] double power(double x, double y);

}  // namespace series

/// |x| < 2^size, and at least half of that. Precondition: x is not 0.
[[nodiscard]] inline int size_of(const Dyadic& x) {
    return static_cast<int>(bits_of(x.significand())) + x.exponent();
}

}  // namespace signum::exact
