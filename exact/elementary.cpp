#include "elementary.hpp"

#include <algorithm>

#if !defined(SIGNUM_WITHOUT_GMP)
#include <mpfr.h>

#include "floating_environment.hpp"
#endif

namespace signum::exact {

#if defined(SIGNUM_WITHOUT_GMP)

Dyadic sine(const Dyadic& x, int bits) {
    return series::sine(x, bits);
}
Dyadic cosine(const Dyadic& x, int bits) {
    return series::cosine(x, bits);
}
double exponential(double x) {
    return series::exponential(x);
}
double power(double x, double y) {
    return series::power(x, y);
}

#else

namespace {

/// MPFR keeps constants and integers for each thread, and lets go of them only when told to: at the
/// end of a thread that computed with it here. What it keeps it makes anew when it is asked again.
struct CachesOfThread {
    ~CachesOfThread() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
    void hold() const noexcept {}
};
thread_local const CachesOfThread caches_of_thread;

class MpfrNumber {
 public:
    explicit MpfrNumber(mpfr_prec_t bits) {
        caches_of_thread.hold();  // made, so that it will be destroyed
        mpfr_init2(number_, bits);
    }
    ~MpfrNumber() { mpfr_clear(number_); }
    MpfrNumber(const MpfrNumber&) = delete;
    MpfrNumber& operator=(const MpfrNumber&) = delete;
    [[nodiscard]] mpfr_ptr get() noexcept { return number_; }

 private:
    mpfr_t number_;
};

/// A sine or cosine. With |x| < 2^size, x is rounded by at most 2^(min(size, 0) - bits - 1). That
/// moves the result by no more, which is rounded by at most as much again, or a cosine next to 1 by
/// 2^(-bits - 1).
Dyadic wave(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const Dyadic& x, int bits) {
    const Integer significand = x.significand();
    MpfrNumber argument(bits + std::max(size_of(x), 0));
    mpfr_set_z_2exp(argument.get(), significand.backend().data(), x.exponent(), MPFR_RNDN);
    MpfrNumber result(bits);
    function(result.get(), argument.get(), MPFR_RNDN);
    Integer rounded;
    const mpfr_exp_t exponent = mpfr_get_z_2exp(rounded.backend().data(), result.get());
    return {rounded, static_cast<int>(exponent)};
}

/// What compute(number, way) rounds one way, to the nearest double. A denormal has fewer digits
/// than 53 and would be rounded twice: it is enclosed instead.
template <class Compute>
double nearest(const Compute& compute) {
    MpfrNumber result(53);
    compute(result.get(), MPFR_RNDN);
    if (mpfr_regular_p(result.get()) == 0 || mpfr_get_exp(result.get()) > -1022)
        return mpfr_get_d(result.get(), MPFR_RNDN);
    for (mpfr_prec_t bits = 128;; bits *= 2) {
        MpfrNumber below(bits);
        MpfrNumber above(bits);
        compute(below.get(), MPFR_RNDD);
        compute(above.get(), MPFR_RNDU);
        const double low = mpfr_get_d(below.get(), MPFR_RNDN);
        if (low == mpfr_get_d(above.get(), MPFR_RNDN)) return low;
    }
}

}  // namespace

Dyadic sine(const Dyadic& x, int bits) {
    return wave(mpfr_sin, x, bits);
}
Dyadic cosine(const Dyadic& x, int bits) {
    return wave(mpfr_cos, x, bits);
}

// MPFR takes doubles apart, and puts them together, by arithmetic that loses denormals where they
// are flushed.

double exponential(double x) {
    return in_ieee_environment(
        [](double number) {
            MpfrNumber argument(53);
            mpfr_set_d(argument.get(), number, MPFR_RNDN);
            return nearest(
                [&](mpfr_ptr result, mpfr_rnd_t way) { mpfr_exp(result, argument.get(), way); });
        },
        x);
}

double power(double x, double y) {
    return in_ieee_environment(
        [](double first, double second) {
            MpfrNumber base(53);
            MpfrNumber exponent(53);
            mpfr_set_d(base.get(), first, MPFR_RNDN);
            mpfr_set_d(exponent.get(), second, MPFR_RNDN);
            return nearest([&](mpfr_ptr result, mpfr_rnd_t way) {
                mpfr_pow(result, base.get(), exponent.get(), way);
            });
        },
        x, y);
}

#endif

}  // namespace signum::exact
