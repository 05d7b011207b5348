// Sines, cosines, exponentials and powers, those of the library and those of series in integers,
// against MPFR's with 2500 bits.

#include "../../exact/elementary.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>
#include <mpfr.h>

#include "exact_reference.hpp"

namespace {

using signum::exact::Dyadic;
using signum::reference::Hostile;
using signum::reference::in_environment;
using signum::reference::Random;
namespace exact = signum::exact;
namespace series = signum::exact::series;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least = std::numeric_limits<double>::denorm_min();

class Reference {
 public:
    Reference() { mpfr_init2(number_, 2500); }
    explicit Reference(double x) : Reference() { mpfr_set_d(number_, x, MPFR_RNDN); }
    explicit Reference(const Dyadic& x) : Reference() {
        mpfr_set_str(number_, x.significand().str().c_str(), 10, MPFR_RNDN);
        mpfr_mul_2si(number_, number_, x.exponent(), MPFR_RNDN);
    }
    ~Reference() { mpfr_clear(number_); }
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;
    [[nodiscard]] mpfr_ptr get() noexcept { return number_; }
    [[nodiscard]] double nearest() const { return mpfr_get_d(number_, MPFR_RNDN); }

 private:
    mpfr_t number_;
};

void expect_exponential(double x, int trial) {
    Reference expected(x);
    mpfr_exp(expected.get(), expected.get(), MPFR_RNDN);
    const int mode = trial % Hostile::modes;
    ASSERT_EQ(
        in_environment(mode, [&] { return std::bit_cast<std::uint64_t>(series::exponential(x)); }),
        std::bit_cast<std::uint64_t>(expected.nearest()))
        << std::hexfloat << x << " in environment " << mode;
    ASSERT_EQ(
        in_environment(mode, [&] { return std::bit_cast<std::uint64_t>(exact::exponential(x)); }),
        std::bit_cast<std::uint64_t>(expected.nearest()))
        << std::hexfloat << x << " in environment " << mode;
}

TEST(Elementary, ExponentialsAreTheNearestDoubles) {
    Random random(1);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random.engine()() >> 11), -53); };
    for (int trial = 0; trial < 1000; ++trial) {
        expect_exponential(-760.0 + 1480.0 * unit(), trial);
        expect_exponential(
            (trial % 2 == 0 ? 1.0 : -1.0) * std::ldexp(unit(), -random.between(0, 60)), trial);
        // Denormals, which are rounded once.
        expect_exponential(-708.0 - 38.0 * unit(), trial);
        if (HasFatalFailure()) return;
    }
    for (const double x :
         {0.0, -0.0, least, -least, 709.782712893384, 709.7827128933841, -745.1332191019411,
          -745.1332191019412, -infinity, infinity, 1e300, -1e300})
        expect_exponential(x, 0);
}

void expect_power(double x, double y, int trial) {
    Reference base(x);
    Reference expected(y);
    mpfr_pow(expected.get(), base.get(), expected.get(), MPFR_RNDN);
    const int mode = trial % Hostile::modes;
    ASSERT_EQ(
        in_environment(mode, [&] { return std::bit_cast<std::uint64_t>(series::power(x, y)); }),
        std::bit_cast<std::uint64_t>(expected.nearest()))
        << std::hexfloat << x << " to the " << y << " in environment " << mode;
    ASSERT_EQ(
        in_environment(mode, [&] { return std::bit_cast<std::uint64_t>(exact::power(x, y)); }),
        std::bit_cast<std::uint64_t>(expected.nearest()))
        << std::hexfloat << x << " to the " << y << " in environment " << mode;
}

TEST(Elementary, PowersAreTheNearestDoublesAndTheEvenOneOfTwo) {
    Random random(2);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random.engine()() >> 11), -53); };
    for (int trial = 0; trial < 700; ++trial) {
        expect_power(4.0 * unit(), 8.0 * unit(), trial);
        expect_power(std::fabs(random.finite()), 2.0 * unit(), trial);
        expect_power(1.0 + std::ldexp(unit(), -random.between(0, 52)), std::fabs(random.finite()),
                     trial);
        // Exact ones: squares of 27 digits lie half way between two doubles, roots of squares are
        // doubles; so are those of powers of two, some of them denormal.
        const double few = std::ldexp(random.between(1 << 25, 1 << 27), random.between(-560, 400));
        expect_power(few, 2.0, trial);
        expect_power(few * few, 0.5, trial);
        expect_power(std::nextafter(few * few, infinity), 0.5, trial);
        expect_power(random.between(2, 40), random.between(2, 12) * 0.25, trial);
        expect_power(std::ldexp(1.0, random.between(-1074, 1023)), random.between(1, 64) * 0.125,
                     trial);
        if (HasFatalFailure()) return;
    }
    for (const double y : {least, 1e-300, 0.5, 1.0, 3.0, 1e300})
        for (const double x :
             {0.0, least, 0.5, std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0), 2.0, 3.0,
              std::numeric_limits<double>::max(), infinity})
            expect_power(x, y, 0);
}

/// |number - reference| <= 2^place.
bool is_within(const Dyadic& number, Reference& reference, int place) {
    Reference off(number);
    mpfr_sub(off.get(), off.get(), reference.get(), MPFR_RNDA);
    return mpfr_cmpabs_ui(off.get(), 0) == 0 || mpfr_get_exp(off.get()) <= place + 1;
}

void expect_waves(const Dyadic& x, int bits) {
    const int size = exact::size_of(x);
    Reference argument(x);
    Reference sine;
    Reference cosine;
    mpfr_sin_cos(sine.get(), cosine.get(), argument.get(), MPFR_RNDN);
    ASSERT_TRUE(is_within(series::sine(x, bits), sine, std::min(size, 0) - bits))
        << size << ' ' << bits;
    ASSERT_TRUE(is_within(series::cosine(x, bits), cosine, -bits)) << size << ' ' << bits;
    ASSERT_TRUE(is_within(exact::sine(x, bits), sine, std::min(size, 0) - bits))
        << size << ' ' << bits;
    ASSERT_TRUE(is_within(exact::cosine(x, bits), cosine, -bits)) << size << ' ' << bits;
}

TEST(Elementary, WavesAreOffByNoMoreThanTheySay) {
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        const double significand = static_cast<double>(random.engine()() >> 11) + 1.0;
        const double x =
            std::ldexp(trial % 2 == 0 ? significand : -significand, random.between(-140, 200));
        expect_waves(Dyadic(x), random.between(100, 700));
        expect_waves(Dyadic(x) * Dyadic(significand) + Dyadic(0.125), 128);
        // Next to a multiple of a quarter.
        expect_waves(Dyadic(random.between(-5000, 5000) * std::numbers::pi / 2 + 0x1p-60), 200);
        if (HasFatalFailure()) return;
    }
}

}  // namespace
