// signum: signs of geometric predicates that are never wrong.
// Made by single/make.py of version 0.1.0: edit the rooms that it names, not this file.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The signum authors

#include "signum_predicates.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#if !defined(__GNUC__)
#error \
    "signum needs GCC or Clang (on Windows MinGW or clang), for it tells their optimizers what must not move"
#endif
#if !defined(__SSE2__) && (defined(__i386__) || defined(__x86_64__))
#error "signum needs SSE2: compile with -msse2 -mfpmath=sse"
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#else
#include <cfenv>
#endif

// The library's sources define functions that these two files do not call.
#pragma GCC diagnostic ignored "-Wunused-function"
#if defined(__clang__)
// It does not tell that it may reassociate (-funsafe-math-optimizations): here it may not.
#pragma float_control(precise, on)
#pragma clang diagnostic ignored "-Wunused-const-variable"
#pragma clang diagnostic ignored "-Wunneeded-internal-declaration"
#endif

extern "C" {
extern float signum_environment_witness[4];
[[gnu::used]] alignas(16) float signum_environment_witness[4] = {0x1.8p-24F, -0x1.8p-24F, 0x1p-140F, 0.0F};
}

namespace {

// ---- single/parts/words.hpp ----------------------------------------------------------------------

namespace rooms {
namespace words {
template <class T>
using Bare = std::remove_cv_t<std::remove_reference_t<T>>;
template <class A, class B>
inline constexpr bool same = std::is_same_v<A, B>;
#define SIGNUM_MEMBER(name)                                                    \
    template <class T, class = void>                                           \
    struct Has_##name : std::false_type {};                                    \
    template <class T>                                                         \
    struct Has_##name<T, std::void_t<decltype(&T::name)>> : std::true_type {}; \
    template <class T>                                                         \
    inline constexpr bool has_##name = Has_##name<Bare<T>>::value;
SIGNUM_MEMBER(z)
SIGNUM_MEMBER(r)
SIGNUM_MEMBER(w)
SIGNUM_MEMBER(window)
SIGNUM_MEMBER(sign)
SIGNUM_MEMBER(filter)
SIGNUM_MEMBER(zero)
SIGNUM_MEMBER(difference)
SIGNUM_MEMBER(difference_of_squares)
#undef SIGNUM_MEMBER
template <class T, class = void>
inline constexpr bool has_exactly = false;
template <class T>
inline constexpr bool has_exactly<T, std::void_t<decltype(T::exactly(0.0))>> = true;
template <class T>
class span {
 public:
    constexpr span() noexcept = default;
    constexpr span(T* first, std::size_t size) noexcept : first_(first), size_(size) {}
    template <std::size_t n>
    constexpr span(T (&array)[n]) noexcept : first_(array), size_(n) {}
    [[nodiscard]] constexpr T* begin() const noexcept { return first_; }
    [[nodiscard]] constexpr T* end() const noexcept { return first_ + size_; }
    [[nodiscard]] constexpr T* data() const noexcept { return first_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T& front() const noexcept { return *first_; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) const noexcept { return first_[i]; }
    [[nodiscard]] constexpr span subspan(std::size_t from) const noexcept {
        return {first_ + from, size_ - from};
    }
 private:
    T* first_ = nullptr;
    std::size_t size_ = 0;
};
template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
[[nodiscard]] constexpr int countl_zero(std::uint64_t x) noexcept {
    return x == 0 ? 64 : __builtin_clzll(x);
}
[[nodiscard]] constexpr int countr_zero(std::uint64_t x) noexcept {
    return x == 0 ? 64 : __builtin_ctzll(x);
}
[[nodiscard]] constexpr int bit_width(std::uint64_t x) noexcept {
    return 64 - countl_zero(x);
}
[[nodiscard]] constexpr std::uint64_t bit_ceil(std::uint64_t x) noexcept {
    return x <= 1 ? 1 : std::uint64_t{1} << bit_width(x - 1);
}
}
}

// ---- core/contract.hpp ---------------------------------------------------------------------------

#define SIGNUM_EXPECTS(condition) static_cast<void>(0)
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error \
    "signum needs IEEE arithmetic: compile without -ffast-math, -funsafe-math-optimizations, -fassociative-math and -ffinite-math-only"
#endif
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && __FLT_EVAL_METHOD__ != 16
#error \
    "signum needs IEEE arithmetic: compile without -funsafe-math-optimizations and -fassociative-math, on x86 with -mfpmath=sse"
#endif
static_assert(0x1p-1000 > 0.0,
              "signum needs IEEE arithmetic: compile without -fsingle-precision-constant");
#if defined(__clang__)
#define SIGNUM_IEEE_BEGIN                                                \
    _Pragma("float_control(push)") _Pragma("float_control(precise, on)") \
        _Pragma("clang fp contract(off)")
#define SIGNUM_IEEE_END _Pragma("float_control(pop)")
#else
#define SIGNUM_IEEE_BEGIN
#define SIGNUM_IEEE_END
#endif

// ---- core/sign.hpp -------------------------------------------------------------------------------

namespace rooms {
using Sign = int;
[[nodiscard]] constexpr Sign sign_of(double value) noexcept {
    return static_cast<int>(value > 0.0) - static_cast<int>(value < 0.0);
}
}

// ---- core/site.hpp -------------------------------------------------------------------------------

namespace rooms {
struct Point {
    double x = 0.0;
    double y = 0.0;
};
struct Point3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
};
struct Site {
    double x = 0.0;
    double y = 0.0;
    double r = 0.0;
};
struct Site3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double r = 0.0;
};
namespace power {
struct Site {
    double x = 0.0;
    double y = 0.0;
    double w = 0.0;
};
struct Site3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double w = 0.0;
};
}
template <class... S>
[[nodiscard]] constexpr bool are_finite(const S&... sites) noexcept {
    const auto is_finite = [](double number) { return number - number == 0.0; };
    const auto is_one = [&](const auto& site) {
        bool others = true;
        if constexpr (words::has_z<decltype(site)>) others &= is_finite(site.z);
        if constexpr (words::has_r<decltype(site)>) others &= is_finite(site.r);
        if constexpr (words::has_w<decltype(site)>) others &= is_finite(site.w);
        return others && is_finite(site.x) && is_finite(site.y);
    };
    return (is_one(sites) && ...);
}
}

// ---- core/index.hpp ------------------------------------------------------------------------------

namespace rooms {
using Index = std::int32_t;
inline constexpr Index infinite = -1;
inline constexpr std::int64_t max_sites = 357'913'941;
inline constexpr std::int64_t max_sites_in_space = std::int64_t{1} << 28;
}

// ---- single/parts/error_free.hpp -----------------------------------------------------------------

namespace rooms {
template <class Number>
struct TwoTermsOf {
    Number high;
    Number low;
};
using TwoTerms = TwoTermsOf<double>;
[[nodiscard, gnu::always_inline]] inline double settled(double number) noexcept {
#if defined(__SSE2__)
    asm("" : "+x"(number));
#elif defined(__aarch64__)
    asm("" : "+w"(number));
#else
    asm("" : "+m"(number));
#endif
    return number;
}
template <class Number = double>
[[nodiscard, gnu::always_inline]] inline TwoTerms two_sum(double a, double b) noexcept {
    const double sum = a + b;
    const double b_virtual = sum - a;
    const double a_virtual = sum - b_virtual;
    return {sum, (a - a_virtual) + (b - b_virtual)};
}
template <class Number = double>
[[nodiscard, gnu::always_inline]] inline TwoTerms quick_two_sum(double a, double b) noexcept {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}
[[nodiscard, gnu::always_inline]] inline TwoTerms two_difference(double a, double b) noexcept {
    return two_sum(a, -b);
}
[[nodiscard, gnu::always_inline]] inline TwoTerms two_product(double a, double b) noexcept {
    const double product = settled(a * b);
#if defined(__FMA__) || defined(__aarch64__)
    return {product, settled(__builtin_fma(a, b, -product))};
#else
    constexpr double splitter = 0x1p27 + 1.0;
    const double scaled_a = settled(splitter * a);
    const double scaled_b = settled(splitter * b);
    const double high_a = scaled_a - settled(scaled_a - a);
    const double high_b = scaled_b - settled(scaled_b - b);
    const double low_a = a - high_a;
    const double low_b = b - high_b;
    const double rest = ((high_a * high_b - product) + high_a * low_b) + low_a * high_b;
    return {product, settled(low_a * low_b + rest)};
#endif
}
}

// ---- filters/environment.hpp ---------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::filters {
using ::signum_environment_witness;
[[nodiscard]] inline bool environment_is_default() noexcept {
    const auto& w = signum_environment_witness;
#if defined(__SSE2__)
    using Floats = float __attribute__((vector_size(16), may_alias));
    using Flags = int __attribute__((vector_size(16)));
    const Floats sums = *reinterpret_cast<const Floats*>(&w) + Floats{1.0F, -1.0F, 0x1p-140F, 0.0F};
    const Floats expected = {1.0F + 0x1p-23F, -1.0F - 0x1p-23F, 0x1p-139F, 0.0F};
    return __builtin_ia32_movmskps((Floats)((Flags)sums == (Flags)expected)) == 0xF;
#else
    return w[0] + 1.0F > 1.0F && w[1] - 1.0F < -1.0F && w[2] + 0x1p-140F != 0.0F;
#endif
}
#if defined(__SSE2__)
#define SIGNUM_REGISTER "+x"
#elif defined(__aarch64__)
#define SIGNUM_REGISTER "+w"
#else
#define SIGNUM_REGISTER "+m"
#endif
[[nodiscard, gnu::always_inline]] inline double opaque(double operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand));
    return operand;
}
[[nodiscard, gnu::always_inline]] inline double pinned(double operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand) : "m"(signum_environment_witness));
    return operand;
}
using Two = double __attribute__((vector_size(16)));
[[nodiscard, gnu::always_inline]] inline Two pinned(Two operand) noexcept {
    asm("" : SIGNUM_REGISTER(operand) : "m"(signum_environment_witness));
    return operand;
}
#undef SIGNUM_REGISTER
[[nodiscard, gnu::always_inline]] inline Point pinned(const Point& p) noexcept {
    return {pinned(p.x), pinned(p.y)};
}
[[nodiscard, gnu::always_inline]] inline Site pinned(const Site& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.r)};
}
[[nodiscard, gnu::always_inline]] inline power::Site pinned(const power::Site& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.w)};
}
[[nodiscard, gnu::always_inline]] inline Point3 pinned(const Point3& p) noexcept {
    return {pinned(p.x), pinned(p.y), pinned(p.z)};
}
[[nodiscard, gnu::always_inline]] inline Site3 pinned(const Site3& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.z), pinned(s.r)};
}
[[nodiscard, gnu::always_inline]] inline power::Site3 pinned(const power::Site3& s) noexcept {
    return {pinned(s.x), pinned(s.y), pinned(s.z), pinned(s.w)};
}
}
SIGNUM_IEEE_END

// ---- filters/bounds.hpp --------------------------------------------------------------------------

namespace rooms::filters {
inline constexpr double epsilon = 0x1p-52;
[[nodiscard]] constexpr double magnitude(double value) noexcept {
    return __builtin_fabs(value);
}
[[nodiscard]] constexpr float magnitude(float value) noexcept {
    return __builtin_fabsf(value);
}
[[nodiscard, gnu::always_inline]] inline Two magnitude(Two values) noexcept {
    using Bits = std::int64_t __attribute__((vector_size(16)));
    return (Two)((Bits)values & INT64_MAX);
}
[[nodiscard, gnu::always_inline]] inline Two max(Two a, Two b) noexcept {
    return a > b ? a : b;
}
[[nodiscard, gnu::always_inline]] inline bool all_exceed(Two values, Two bounds) noexcept {
#if defined(__SSE2__)
    return __builtin_ia32_movmskpd((Two)(values > bounds)) == 3;
#else
    return values[0] > bounds[0] && values[1] > bounds[1];
#endif
}
template <class Number>
struct Compared {
    Number value;
    Number bound;
};
[[nodiscard]] inline int sign_of_nonzero(double value) noexcept {
    return static_cast<int>(__builtin_bit_cast(std::int64_t, value) >> 63) | 1;
}
[[nodiscard]] inline bool same_number(double a, double b) noexcept {
    const auto a_bits = __builtin_bit_cast(std::uint64_t, a);
    const auto b_bits = __builtin_bit_cast(std::uint64_t, b);
    return a_bits == b_bits || ((a_bits | b_bits) << 1) == 0;
}
[[nodiscard]] inline int compare_numbers(double a, double b) noexcept {
    const auto place = [](double value) {
        const auto bits = __builtin_bit_cast(std::int64_t, value);
        return bits < 0 ? INT64_MIN - bits : bits;
    };
    return static_cast<int>(place(a) > place(b)) - static_cast<int>(place(a) < place(b));
}
}

// ---- filters/verdict.hpp -------------------------------------------------------------------------

namespace rooms::filters {
class [[nodiscard]] Verdict {
 public:
    static constexpr Verdict certain(Sign sign) noexcept { return Verdict(sign); }
    static constexpr Verdict uncertain() noexcept { return Verdict(unknown_); }
    [[nodiscard]] constexpr bool is_certain() const noexcept { return value_ != unknown_; }
    [[nodiscard]] constexpr Sign sign() const noexcept { return value_; }
 private:
    static constexpr int unknown_ = 2;
    explicit constexpr Verdict(int value) noexcept : value_(value) {}
    int value_;
};
}

// ---- filters/tally.hpp ---------------------------------------------------------------------------

namespace rooms {
enum class Stage : std::uint8_t {
    filter,
    refine,
    exact,
    essa,
    multiprecision
};
inline constexpr int stage_count = 5;
[[nodiscard]] constexpr const char* name_of(Stage stage) noexcept {
    constexpr const char* names[] = {"filter", "refine", "exact", "essa", "multiprecision"};
    return names[static_cast<int>(stage)];
}
struct Decision {
    Sign sign;
    Stage stage;
    bool tied = false;
};
}
namespace rooms::filters {
}

// ---- filters/rounding_count.hpp ------------------------------------------------------------------

namespace rooms::filters {
struct RoundingCount {
    int roundings = 0;
    constexpr RoundingCount() = default;
    explicit constexpr RoundingCount(double) noexcept {}
    [[nodiscard]] static constexpr RoundingCount of(int roundings) noexcept {
        RoundingCount result;
        result.roundings = roundings;
        return result;
    }
    friend constexpr RoundingCount operator*(RoundingCount a, RoundingCount b) noexcept {
        return of(a.roundings + b.roundings + 1);
    }
    friend constexpr RoundingCount operator+(RoundingCount a, RoundingCount b) noexcept {
        return of(max(a, b).roundings + 1);
    }
    friend constexpr RoundingCount operator-(RoundingCount a, RoundingCount b) noexcept {
        return a + b;
    }
    friend constexpr RoundingCount operator-(RoundingCount a) noexcept { return a; }
    friend constexpr RoundingCount max(RoundingCount a, RoundingCount b) noexcept {
        return a.roundings > b.roundings ? a : b;
    }
    friend constexpr RoundingCount magnitude(RoundingCount a) noexcept { return a; }
};
inline constexpr RoundingCount rounded_difference = RoundingCount(0.0) - RoundingCount(0.0);
}

// ---- filters/interval.hpp ------------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::filters {
template <class Number>
[[nodiscard]] constexpr Number min(Number a, Number b) noexcept {
    return a < b ? a : b;
}
template <class Number>
[[nodiscard]] constexpr Number max(Number a, Number b) noexcept {
    return a < b ? b : a;
}
struct Interval {
    double low;
    double high;
    Interval() = default;
    constexpr Interval(double from, double to) noexcept : low(from), high(to) {}
    explicit constexpr Interval(double number) noexcept : low(number), high(number) {}
    [[nodiscard]] static constexpr Interval everything() noexcept {
        constexpr double infinity = __builtin_huge_val();
        return {-infinity, infinity};
    }
    friend Interval operator-(const Interval& a) noexcept { return {-a.high, -a.low}; }
    friend Interval operator+(const Interval& a, const Interval& b) noexcept {
        return around(a.low + b.low, a.high + b.high, 0.0);
    }
    friend Interval operator-(const Interval& a, const Interval& b) noexcept { return a + -b; }
    friend Interval operator*(const Interval& a, const Interval& b) noexcept {
        const double p = a.low * b.low;
        const double q = a.low * b.high;
        const double r = a.high * b.low;
        const double s = a.high * b.high;
        if (!((magnitude(p) + magnitude(q)) + (magnitude(r) + magnitude(s)) <=
              0x1.fffffffffffffp1023))
            return everything();
        const double least = min(min(p, q), min(r, s));
        const double greatest = max(max(p, q), max(r, s));
        return around(least, greatest, 0x1p-1022);
    }
    friend Interval operator*(int a, const Interval& b) noexcept { return Interval(a) * b; }
 private:
    static Interval around(double low, double high, double underflow) noexcept {
        const double below = low - (epsilon * magnitude(low) + underflow);
        const double above = high + (epsilon * magnitude(high) + underflow);
        if (!(below <= above))
            return everything();
        return {below, above};
    }
};
[[nodiscard]] inline Interval magnitude(const Interval& a) noexcept {
    if (a.low >= 0.0) return a;
    if (a.high <= 0.0) return -a;
    return {0.0, max(-a.low, a.high)};
}
[[nodiscard]] inline Interval max(const Interval& a, const Interval& b) noexcept {
    return {max(a.low, b.low), max(a.high, b.high)};
}
[[nodiscard]] inline bool exceeds(double value, double bound) noexcept {
    return magnitude(value) > bound;
}
[[nodiscard]] inline bool exceeds(const Interval& value, double bound) noexcept {
    return (value.low > bound || value.high < -bound) && environment_is_default();
}
[[nodiscard]] inline int sign_of_nonzero(const Interval& value) noexcept {
    return value.low > 0.0 ? 1 : -1;
}
}
SIGNUM_IEEE_END

// ---- filters/double_double.hpp -------------------------------------------------------------------

namespace rooms::filters {
inline constexpr double double_double_epsilon = 0x1p-102;
template <class Number>
struct DoubleDoubleOf {
    Number high;
    Number low;
    [[gnu::noinline]] friend DoubleDoubleOf operator+(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> sum = two_sum(x.high, y.high);
        const TwoTermsOf<Number> result = two_sum<Number>(sum.high, sum.low + (x.low + y.low));
        return {result.high, result.low};
    }
    [[gnu::noinline]] friend DoubleDoubleOf operator-(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        return x + DoubleDoubleOf{-y.high, -y.low};
    }
    [[gnu::noinline]] friend DoubleDoubleOf operator*(
        const DoubleDoubleOf& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> product = two_product(x.high, y.high);
        const Number cross = x.high * y.low + x.low * y.high;
        const TwoTermsOf<Number> result = quick_two_sum<Number>(product.high, product.low + cross);
        return {result.high, result.low};
    }
    [[gnu::noinline]] friend DoubleDoubleOf operator*(
        const Number& x, const DoubleDoubleOf& y) noexcept {
        const TwoTermsOf<Number> product = two_product(x, y.high);
        const TwoTermsOf<Number> result =
            quick_two_sum<Number>(product.high, product.low + x * y.low);
        return {result.high, result.low};
    }
};
using DoubleDouble = DoubleDoubleOf<double>;
template <class Number>
[[nodiscard, gnu::always_inline]] inline DoubleDoubleOf<Number> exact_difference(
    const Number& a, const Number& b) noexcept {
    const TwoTermsOf<Number> difference = two_difference(a, b);
    return {difference.high, difference.low};
}
[[nodiscard, gnu::always_inline]] inline DoubleDouble exact_sum(double a, double b) noexcept {
    const TwoTerms sum = two_sum(a, b);
    return {sum.high, sum.low};
}
}

// ---- filters/bounded.hpp -------------------------------------------------------------------------

namespace rooms::filters {
struct Bounded {
    DoubleDouble value;
    double error;
    static constexpr double slack = 0x1.01p0;
    static constexpr double underflow = 0x1p-1070;
    [[nodiscard]] static Bounded exactly(double value) noexcept { return {{value, 0.0}, 0.0}; }
    [[nodiscard]] static Bounded exactly(const DoubleDouble& value) noexcept {
        return {value, 0.0};
    }
    [[nodiscard]] double size() const noexcept { return magnitude(value.high); }
    [[nodiscard]] Verdict sign() const noexcept {
        return size() * (1.0 - 0x1p-50) > error ? Verdict::certain(sign_of_nonzero(value.high))
                                                : Verdict::uncertain();
    }
    [[nodiscard]] bool is_positive() const noexcept {
        return value.high * (1.0 - 0x1p-50) - error > 0.0;
    }
    [[gnu::noinline]] friend Bounded operator-(const Bounded& a) noexcept {
        return {{-a.value.high, -a.value.low}, a.error};
    }
    [[gnu::noinline]] friend Bounded operator+(const Bounded& a, const Bounded& b) noexcept {
        return {a.value + b.value, slack * (a.error + b.error + 0x1p-102 * (a.size() + b.size()))};
    }
    [[gnu::noinline]] friend Bounded operator-(const Bounded& a, const Bounded& b) noexcept { return a + -b; }
    [[gnu::noinline]] friend Bounded operator*(const Bounded& a, const Bounded& b) noexcept {
        return {a.value * b.value, slack * (a.error * (b.size() + b.error) + a.size() * b.error +
                                            0x1p-102 * a.size() * b.size()) +
                                       underflow};
    }
    [[gnu::noinline]] friend Bounded operator/(const Bounded& a, const Bounded& b) noexcept {
        const double least = b.size() * (1.0 - 0x1p-50) - b.error;
        if (!(least > 0.0)) return {{0.0, 0.0}, std::numeric_limits<double>::infinity()};
        const double first = a.value.high / b.value.high;
        const DoubleDouble rest = a.value - DoubleDouble{first, 0.0} * b.value;
        const TwoTerms sum = two_sum(first, rest.high / b.value.high);
        const double quotient = magnitude(sum.high);
        return {{sum.high, sum.low},
                slack * ((a.error + underflow + quotient * b.error) / least + 0x1p-100 * quotient) +
                    underflow};
    }
    friend Bounded sqrt(const Bounded& a) noexcept {
        const double least = a.value.high * (1.0 - 0x1p-50) - a.error;
        if (!(least > 0.0)) return {{0.0, 0.0}, std::numeric_limits<double>::infinity()};
        const double first = std::sqrt(a.value.high);
        const TwoTerms square = two_product(first, first);
        const double rest = ((a.value.high - square.high) - square.low) + a.value.low;
        const TwoTerms sum = two_sum(first, rest / (2.0 * first));
        return {{sum.high, sum.low},
                slack * ((a.error + underflow) / std::sqrt(least) + 0x1p-100 * sum.high)};
    }
    [[nodiscard]] std::optional<double> rounded() const noexcept {
        const double below = value.high + (value.low - 2.0 * error);
        const double above = value.high + (value.low + 2.0 * error);
        const double size = magnitude(below);
        const bool in_range = 0x1p-900 < size && size <= std::numeric_limits<double>::max();
        if (below != above || !(in_range || (below == 0.0 && error == 0.0))) return std::nullopt;
        return below;
    }
};
}

// ---- exact/floating_environment.hpp --------------------------------------------------------------

#if defined(__SSE2__)
#else
#endif
namespace rooms::exact {
class IeeeEnvironment {
 public:
    IeeeEnvironment(const IeeeEnvironment&) = delete;
    IeeeEnvironment& operator=(const IeeeEnvironment&) = delete;
#if defined(__SSE2__)
    IeeeEnvironment() noexcept : saved_(_mm_getcsr()) {
        if (differs())
            _mm_setcsr(default_control);
    }
    ~IeeeEnvironment() {
        if (differs())
            _mm_setcsr(saved_);
    }
 private:
    static constexpr unsigned default_control = 0x1F80;
    static constexpr unsigned sticky_flags = 0x003F;
    [[nodiscard]] bool differs() const noexcept {
        return (saved_ & ~sticky_flags) != default_control;
    }
    unsigned saved_;
#else
    IeeeEnvironment() noexcept {
        std::fegetenv(&saved_);
        std::fesetenv(FE_DFL_ENV);
    }
    ~IeeeEnvironment() {
        std::fesetenv(&saved_);
    }
 private:
    std::fenv_t saved_;
#endif
};
template <class Function, class... Operands>
[[nodiscard]] inline auto in_ieee_environment(Function function,
                                              const Operands&... operands) noexcept {
    const IeeeEnvironment environment;
    const auto opaque = [](const auto& value) -> const auto& {
        const auto* address = &value;
        asm volatile("" : "+r"(address) : : "memory");
        return *address;
    };
    auto result = function(opaque(operands)...);
    asm volatile("" : "+m"(result) : : "memory");
    return result;
}
}

// ---- exact/expansion.hpp -------------------------------------------------------------------------

namespace rooms::exact {
namespace window {
[[nodiscard, gnu::always_inline]] inline bool contains(double value, int exponent) noexcept {
    constexpr std::uint64_t bias = 1023;
    const auto power = [](std::uint64_t biased) { return biased << 53; };
    const std::uint64_t magnitude = words::bit_cast<std::uint64_t>(value) << 1;
    const auto reach = static_cast<std::uint64_t>(exponent);
    const std::uint64_t least = power(bias - reach);
    return magnitude == 0 || magnitude - least <= power(bias + reach) - least;
}
}
[[nodiscard, gnu::always_inline]] inline bool in_expansion_window(double coordinate) noexcept {
    return window::contains(coordinate, 200);
}
[[nodiscard, gnu::always_inline]] inline bool weight_in_expansion_window(double weight) noexcept {
    return window::contains(weight, 400);
}
namespace terms {
[[nodiscard]] int sum(words::span<const double> e, words::span<const double> f, double* h) noexcept;
[[nodiscard, gnu::always_inline]] inline int scale(words::span<const double> e, double b,
                                                   double* h) noexcept {
    int size = 0;
    double high = 0.0;
    const auto append = [&](double term) {
        h[size] = term;
        size += static_cast<int>(term != 0.0);
    };
    for (const double term : e) {
        const TwoTerms product = two_product(term, b);
        const TwoTerms inner = two_sum(high, product.low);
        append(inner.low);
        const TwoTerms outer = quick_two_sum(product.high, inner.high);
        append(outer.low);
        high = outer.high;
    }
    append(high);
    return size;
}
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
template <int Capacity>
class Expansion {
    static_assert(Capacity >= 1);
 public:
    Expansion() noexcept {}
    Expansion(double value) noexcept : size_(static_cast<int>(value != 0.0)) { terms_[0] = value; }
    Expansion(TwoTerms value) noexcept  { assign(value); }
    template <int Fewer>
     Expansion(const Expansion<Fewer>& other)
    noexcept { copy(other.terms()); }
    Expansion(const Expansion& other) noexcept { copy(other.terms()); }
    Expansion& operator=(const Expansion& other) noexcept {
        copy(other.terms());
        return *this;
    }
    ~Expansion() = default;
    [[nodiscard]] words::span<const double> terms() const noexcept {
        return {terms_, static_cast<std::size_t>(size_)};
    }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] Sign sign() const noexcept { return size_ == 0 ? 0 : sign_of(terms_[size_ - 1]); }
    [[nodiscard]] double approximate() const noexcept {
        double sum = 0.0;
        for (const double term : terms()) sum += term;
        return sum;
    }
    void assign_sum(words::span<const double> e,
                                           words::span<const double> f) noexcept {
        if (e.size() == 1 && f.size() == 1) {
            assign(two_sum(e[0], f[0]));
        } else if (e.empty() || f.empty()) {
            copy(e.empty() ? f : e);
        } else {
            size_ = terms::sum(e, f, terms_);
        }
    }
    void assign_scaled(words::span<const double> e, double b) noexcept {
        if (e.size() == 1) {
            assign(two_product(e[0], b));
        } else {
            size_ = terms::scale(e, b, terms_);
        }
    }
    void negate() noexcept {
        for (int i = 0; i < size_; ++i) terms_[i] = -terms_[i];
    }
 private:
    void assign(TwoTerms value) noexcept {
        if (value.low == 0.0) {
            terms_[0] = value.high;
            size_ = static_cast<int>(value.high != 0.0);
        } else {
            terms_[0] = value.low;
            terms_[1] = value.high;
            size_ = 2;
        }
    }
    void copy(words::span<const double> terms) noexcept {
        size_ = static_cast<int>(terms.size());
        for (std::size_t i = 0; i < terms.size(); ++i) terms_[i] = terms[i];
    }
    int size_ = 0;
    double terms_[Capacity];
};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
[[nodiscard]] inline Expansion<2> difference(double a, double b) noexcept {
    return two_difference(a, b);
}
[[nodiscard]] inline Expansion<2> product(double a, double b) noexcept {
    return two_product(a, b);
}
template <int M>
[[nodiscard]] inline Expansion<M> operator-(Expansion<M> e) noexcept {
    e.negate();
    return e;
}
template <int M, int N>
[[nodiscard]] inline Expansion<M + N> operator+(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    Expansion<M + N> result;
    result.assign_sum(e.terms(), f.terms());
    return result;
}
template <int M, int N>
[[nodiscard]] inline Expansion<M + N> operator-(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    return e + (-f);
}
template <int M>
[[nodiscard]] inline Expansion<2 * M> operator*(const Expansion<M>& e,
                                                                    double b) noexcept {
    Expansion<2 * M> result;
    result.assign_scaled(e.terms(), b);
    return result;
}
template <int M>
[[nodiscard]] inline Expansion<2 * M> operator*(
    double b, const Expansion<M>& e) noexcept {
    return e * b;
}
template <int M, int N>
[[nodiscard]] inline Expansion<2 * M * N> operator*(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    words::span<const double> longer = e.terms();
    words::span<const double> shorter = f.terms();
    if (longer.size() < shorter.size()) std::swap(longer, shorter);
    Expansion<2 * M * N> result;
    if (shorter.empty()) return result;
    result.assign_scaled(longer, shorter.front());
    for (const double term : shorter.subspan(1)) {
        Expansion<2 * (M > N ? M : N)> partial;
        partial.assign_scaled(longer, term);
        const Expansion<2 * M* N> before = result;
        result.assign_sum(before.terms(), partial.terms());
    }
    return result;
}
template <int M>
[[nodiscard]] inline Expansion<2 * M * M> square(
    const Expansion<M>& e) noexcept {
    return e * e;
}
}

// ---- exact/expansion.cpp -------------------------------------------------------------------------

namespace rooms::exact::terms {
int sum(words::span<const double> e, words::span<const double> f, double* h) noexcept {
    int size = 0;
    double high = 0.0;
    double carry = 0.0;
    const auto append = [&](double term) {
        h[size] = term;
        size += static_cast<int>(term != 0.0);
    };
    const auto compress = [&](double term) {
        const TwoTerms next = quick_two_sum(term, carry);
        append(next.low);
        carry = next.high;
    };
    const auto add = [&](double term) {
        const TwoTerms next = two_sum(high, term);
        compress(next.low);
        high = next.high;
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < e.size() && j < f.size()) {
        const bool from_e = std::fabs(e[i]) < std::fabs(f[j]);
        add(from_e ? e[i] : f[j]);
        i += static_cast<std::size_t>(from_e);
        j += static_cast<std::size_t>(!from_e);
    }
    while (i < e.size()) add(e[i++]);
    while (j < f.size()) add(f[j++]);
    compress(high);
    append(carry);
    return size;
}
}

// ---- exact/parts.hpp -----------------------------------------------------------------------------

namespace rooms::exact {
struct Parts {
    std::uint64_t significand;
    int exponent;
    bool negative;
};
[[nodiscard]] inline Parts parts(double value) noexcept {
    const auto bits = words::bit_cast<std::uint64_t>(value);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const int biased = static_cast<int>(bits >> 52 & 0x7FF);
    SIGNUM_EXPECTS(biased != 0x7FF);
    const std::uint64_t significand = fraction | std::uint64_t{biased != 0} << 52;
    if (significand == 0) return {0, 0, false};
    const int zeros = words::countr_zero(significand);
    return {significand >> zeros, (biased == 0 ? 1 : biased) - 1075 + zeros, bits >> 63 != 0};
}
}

// ---- exact/sign_of_sum.hpp -----------------------------------------------------------------------

namespace rooms {
[[nodiscard]] Sign sign_of_sum(words::span<const double> terms) noexcept;
namespace exact {
struct SumTrace {
    Sign sign;
    std::size_t steps;
};
[[nodiscard]] SumTrace trace_sign_of_sum(words::span<const double> terms) noexcept;
}
}

// ---- exact/sign_of_sum.cpp -----------------------------------------------------------------------

namespace rooms {
namespace exact {
namespace {
constexpr std::uint64_t hidden_bit = std::uint64_t{1} << 52;
constexpr std::uint64_t fraction = hidden_bit - 1;
constexpr int binades = 2098;
[[nodiscard]] int binade_of(double x) noexcept {
    const auto bits = words::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7FF);
    return biased != 0 ? biased + 51 : 63 - words::countl_zero(bits);
}
[[nodiscard]] double power_from(double x) noexcept {
    const auto bits = words::bit_cast<std::uint64_t>(x);
    return words::bit_cast<double>(bits >= hidden_bit ? (bits + fraction) & ~fraction
                                                    : words::bit_ceil(bits));
}
[[nodiscard]] bool outweighs(double a, int gap, std::size_t n) noexcept {
    if (gap > 53) return true;
    const auto bits = words::bit_cast<std::uint64_t>(a);
    const std::uint64_t significand =
        bits >= hidden_bit ? (bits & fraction) | hidden_bit : bits << (words::countl_zero(bits) - 11);
    return significand >> (53 - gap) >= n;
}
struct Term {
    double magnitude;
    std::uint32_t next;
};
class Side {
 public:
    explicit Side(Term* terms) noexcept : terms_(terms) {}
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    void push(std::uint32_t term) noexcept {
        const int binade = binade_of(terms_[term].magnitude);
        const int word = binade >> 6;
        const std::uint64_t others = (words_ & bit(word)) == 0 ? 0 : binades_[word];
        terms_[term].next = (others & bit(binade)) == 0 ? none : first_[binade];
        first_[binade] = term;
        binades_[word] = others | bit(binade);
        words_ |= bit(word);
        ++size_;
    }
    [[nodiscard]] int top() const noexcept {
        const int word = 63 - words::countl_zero(words_);
        return (word << 6) + 63 - words::countl_zero(binades_[word]);
    }
    [[nodiscard]] std::uint32_t first(int binade) const noexcept { return first_[binade]; }
    void pop(int binade) noexcept {
        first_[binade] = terms_[first_[binade]].next;
        const int word = binade >> 6;
        binades_[word] ^= bit(binade, first_[binade] == none);
        words_ ^= bit(word, binades_[word] == 0);
        --size_;
    }
 private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr int words = binades / 64 + 1;
    static std::uint64_t bit(int index, bool value = true) noexcept {
        return std::uint64_t{value} << (index & 63);
    }
    Term* terms_;
    std::size_t size_ = 0;
    std::uint64_t words_ = 0;
    std::uint64_t binades_[words];
    std::uint32_t first_[64 * words];
};
[[gnu::noinline]] SumTrace essa(words::span<const double> input, Term* terms, Side& positive,
                                Side& negative) noexcept {
    const auto keep = [terms](Side& side, std::uint32_t term, double magnitude) {
        if (magnitude == 0.0) return;
        terms[term].magnitude = magnitude;
        side.push(term);
    };
    std::uint32_t count = 0;
    for (const double value : input) {
        SIGNUM_EXPECTS(std::isfinite(value));
        keep(value > 0.0 ? positive : negative, count++, std::fabs(value));
    }
    for (std::size_t steps = 0;; ++steps) {
        if (negative.empty()) return {positive.empty() ? 0 : +1, steps};
        if (positive.empty()) return {-1, steps};
        const int e = positive.top();
        const int f = negative.top();
        Side& larger = e >= f ? positive : negative;
        Side& smaller = e >= f ? negative : positive;
        const std::uint32_t i = larger.first(std::max(e, f));
        const std::uint32_t j = smaller.first(std::min(e, f));
        const double a = terms[i].magnitude;
        const double b = terms[j].magnitude;
        if (outweighs(a, std::abs(e - f), smaller.size())) return {e > f ? +1 : -1, steps};
        larger.pop(std::max(e, f));
        smaller.pop(std::min(e, f));
        const TwoTerms difference = quick_two_sum(a, -b);
        if (difference.low == 0.0) {
            keep(difference.high > 0.0 ? larger : smaller, i, std::fabs(difference.high));
        } else {
            const double u = power_from(b);
            keep(larger, i, a - u);
            keep(larger, j, u - b);
        }
    }
}
SumTrace with_memory(words::span<const double> input) noexcept {
    constexpr std::size_t on_stack = 512;
    Term few[on_stack];
    std::unique_ptr<Term[]> many;
    if (input.size() > on_stack) many = std::unique_ptr<Term[]>(new Term[input.size()]);
    Term* terms = many ? many.get() : few;
    Side positive(terms);
    Side negative(terms);
    return essa(input, terms, positive, negative);
}
}
SumTrace trace_sign_of_sum(words::span<const double> terms) noexcept {
    SIGNUM_EXPECTS(terms.size() <= std::numeric_limits<std::uint32_t>::max());
    return in_ieee_environment(with_memory, terms);
}
}
Sign sign_of_sum(words::span<const double> terms) noexcept {
    return exact::trace_sign_of_sum(terms).sign;
}
}

// ---- single/parts/dyadic.hpp ---------------------------------------------------------------------

namespace rooms::exact {
template <class Number>
struct ComparedBySign {
    friend bool operator==(const Number& a, const Number& b) { return (a - b).sign() == 0; }
    friend bool operator<(const Number& a, const Number& b) { return (a - b).sign() < 0; }
    friend bool operator>(const Number& a, const Number& b) { return (a - b).sign() > 0; }
    friend bool operator<=(const Number& a, const Number& b) { return (a - b).sign() <= 0; }
    friend bool operator>=(const Number& a, const Number& b) { return (a - b).sign() >= 0; }
    friend bool operator==(const Number& a, int) { return a.sign() == 0; }
    friend bool operator!=(const Number& a, int) { return a.sign() != 0; }
    friend bool operator<(const Number& a, int) { return a.sign() < 0; }
    friend bool operator>(const Number& a, int) { return a.sign() > 0; }
    friend bool operator<=(const Number& a, int) { return a.sign() <= 0; }
    friend bool operator>=(const Number& a, int) { return a.sign() >= 0; }
};
class Natural {
 public:
    using Digits = std::vector<std::uint32_t>;
    [[nodiscard]] static Digits of(std::uint64_t low, std::uint64_t high) {
        Digits digits = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
                         static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(high >> 32)};
        trim(digits);
        return digits;
    }
    [[nodiscard]] static int compare(const Digits& a, const Digits& b) noexcept {
        if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
        for (std::size_t k = a.size(); k-- > 0;)
            if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
        return 0;
    }
    [[nodiscard]] static Digits shifted(const Digits& a, int bits) {
        if (a.empty()) return a;
        const auto words = static_cast<std::size_t>(bits / 32);
        const int rest = bits % 32;
        Digits result(words + a.size() + 1);
        for (std::size_t k = 0; k < a.size(); ++k) {
            const std::uint64_t wide = std::uint64_t{a[k]} << rest;
            result[words + k] |= static_cast<std::uint32_t>(wide);
            result[words + k + 1] = static_cast<std::uint32_t>(wide >> 32);
        }
        trim(result);
        return result;
    }
    [[nodiscard]] static Digits sum(const Digits& a, const Digits& b) {
        const Digits& longer = a.size() < b.size() ? b : a;
        const Digits& shorter = a.size() < b.size() ? a : b;
        Digits result(longer.size() + 1);
        std::uint64_t carry = 0;
        for (std::size_t k = 0; k < longer.size(); ++k) {
            carry += std::uint64_t{longer[k]} + (k < shorter.size() ? shorter[k] : 0U);
            result[k] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        result[longer.size()] = static_cast<std::uint32_t>(carry);
        trim(result);
        return result;
    }
    [[nodiscard]] static Digits difference(const Digits& a, const Digits& b) {
        Digits result(a.size());
        std::int64_t borrow = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            borrow += std::int64_t{a[k]} - (k < b.size() ? std::int64_t{b[k]} : 0);
            result[k] = static_cast<std::uint32_t>(borrow);
            borrow >>= 32;
        }
        trim(result);
        return result;
    }
    [[nodiscard]] static Digits product(const Digits& a, const Digits& b) {
        Digits result(a.size() + b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t k = 0; k < b.size(); ++k) {
                carry += std::uint64_t{a[i]} * b[k] + result[i + k];
                result[i + k] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            result[i + b.size()] = static_cast<std::uint32_t>(carry);
        }
        trim(result);
        return result;
    }
 private:
    static void trim(Digits& digits) noexcept {
        while (!digits.empty() && digits.back() == 0) digits.pop_back();
    }
};
class Dyadic : public ComparedBySign<Dyadic> {
#if defined(__SIZEOF_INT128__)
    using Small = __int128;
    using Magnitude = unsigned __int128;
#else
    using Small = std::int64_t;
    using Magnitude = std::uint64_t;
#endif
    using Digits = Natural::Digits;
 public:
    Dyadic() noexcept = default;
    [[gnu::noinline]] Dyadic(const Dyadic& other) noexcept = default;
    Dyadic(Dyadic&& other) noexcept = default;
    [[gnu::noinline]] Dyadic& operator=(const Dyadic& other) noexcept = default;
    Dyadic& operator=(Dyadic&& other) noexcept = default;
    [[gnu::noinline]] ~Dyadic() = default;
    [[gnu::noinline]] explicit Dyadic(double number) noexcept {
        const Parts of_number = parts(number);
        small_ = static_cast<Small>(of_number.significand);
        if (of_number.negative) small_ = -small_;
        exponent_ = of_number.exponent;
    }
    [[gnu::noinline]] friend Dyadic operator-(Dyadic a) noexcept {
        a.small_ = -a.small_;
        a.is_negative_ = !a.is_negative_;
        return a;
    }
    [[gnu::noinline]] friend Dyadic operator+(const Dyadic& a, const Dyadic& b) noexcept {
        if (b.sign() == 0) return a;
        if (a.sign() == 0) return b;
        const Dyadic& coarse = a.exponent_ < b.exponent_ ? b : a;
        const Dyadic& fine = a.exponent_ < b.exponent_ ? a : b;
        const int shift = coarse.exponent_ - fine.exponent_;
        if (coarse.bits() + shift <= most_bits - 1 && fine.bits() <= most_bits - 1)
            return {(coarse.small_ * (Small{1} << shift)) + fine.small_, fine.exponent_};
        const Digits one = Natural::shifted(coarse.digits(), shift);
        const Digits other = fine.digits();
        const bool is_negative = coarse.sign() < 0;
        if (is_negative == (fine.sign() < 0))
            return {Natural::sum(one, other), is_negative, fine.exponent_};
        return Natural::compare(one, other) >= 0
                   ? Dyadic(Natural::difference(one, other), is_negative, fine.exponent_)
                   : Dyadic(Natural::difference(other, one), !is_negative, fine.exponent_);
    }
    [[gnu::noinline]] friend Dyadic operator-(const Dyadic& a, const Dyadic& b) noexcept {
        return a + -b;
    }
    Dyadic& operator+=(const Dyadic& other) noexcept {
        return *this = *this + other;
    }
    [[gnu::noinline]] friend Dyadic operator*(const Dyadic& a, const Dyadic& b) noexcept {
        if (a.bits() + b.bits() <= most_bits)
            return {a.small_ * b.small_, a.exponent_ + b.exponent_};
        return {Natural::product(a.digits(), b.digits()), (a.sign() < 0) != (b.sign() < 0),
                a.exponent_ + b.exponent_};
    }
    friend Dyadic operator*(int a, const Dyadic& b) noexcept {
        return Dyadic(Small{a}, 0) * b;
    }
    [[nodiscard]] Sign sign() const noexcept {
        if (!large_.empty()) return is_negative_ ? -1 : 1;
        return static_cast<int>(small_ > 0) - static_cast<int>(small_ < 0);
    }
 private:
    static constexpr int most_bits = 8 * static_cast<int>(sizeof(Small)) - 1;
    Dyadic(Small m, int exponent) noexcept : small_(m), exponent_(exponent) {}
    Dyadic(Digits digits, bool is_negative, int exponent)
        : exponent_(exponent), is_negative_(is_negative), large_(std::move(digits)) {}
    [[nodiscard]] Magnitude magnitude() const noexcept {
        return small_ < 0 ? -static_cast<Magnitude>(small_) : static_cast<Magnitude>(small_);
    }
    [[nodiscard]] Digits digits() const {
        if (!large_.empty()) return large_;
        const Magnitude m = magnitude();
#if defined(__SIZEOF_INT128__)
        return Natural::of(static_cast<std::uint64_t>(m), static_cast<std::uint64_t>(m >> 64));
#else
        return Natural::of(m, 0);
#endif
    }
    [[nodiscard]] int bits() const noexcept {
        if (!large_.empty()) return most_bits + 1;
        const Magnitude m = magnitude();
#if defined(__SIZEOF_INT128__)
        const auto high = static_cast<std::uint64_t>(m >> 64);
        if (high != 0) return 64 + words::bit_width(high);
#endif
        return words::bit_width(static_cast<std::uint64_t>(m));
    }
    Small small_ = 0;
    int exponent_ = 0;
    bool is_negative_ = false;
    Digits large_;
};
}

// ---- exact/integer_rows.hpp ----------------------------------------------------------------------

#if defined(__SIZEOF_INT128__)
namespace rooms::exact {
using Integer128 = __int128;
template <class Square, class Cube = Integer128>
struct Word {
    std::int64_t value;
    friend Square operator*(Word a, Word b) noexcept {
        return Square{Integer128{a.value} * b.value};
    }
    friend Cube operator*(Word a, Integer128 b) noexcept { return Cube{a.value} * Cube{b}; }
};
class Integer256 {
 public:
    Integer256(Integer128 a) noexcept : low_(static_cast<Half>(a)), high_(a < 0 ? -1 : 0) {}
    Integer256(Integer128 a, Integer128 b) noexcept {
        const auto magnitude_of = [](Integer128 x) {
            return x < 0 ? -static_cast<Half>(x) : static_cast<Half>(x);
        };
        const auto low_of = [](Half x) { return Half{static_cast<std::uint64_t>(x)}; };
        const Half p = magnitude_of(a);
        const Half q = magnitude_of(b);
        const Half middle = low_of(p) * (q >> 64) + (p >> 64) * low_of(q);
        low_ = low_of(p) * low_of(q);
        high_ = static_cast<Integer128>((p >> 64) * (q >> 64) + (middle >> 64));
        *this += {middle << 64, 0};
        if ((a < 0) != (b < 0)) {
            low_ = -low_;
            high_ = -high_ - (low_ != 0 ? 1 : 0);
        }
    }
    friend Integer256 operator+(Integer256 a, const Integer256& b) noexcept {
        a += {b.low_, b.high_};
        return a;
    }
    friend Integer256 operator-(const Integer256& a, const Integer256& b) noexcept {
        return {a.low_ - b.low_, static_cast<Half>(a.high_) - static_cast<Half>(b.high_) -
                                     (a.low_ < b.low_ ? 1 : 0)};
    }
    friend Integer256 operator*(const Integer256& a, const Integer256& b) noexcept {
        const auto low_of = [](Half x) { return Half{static_cast<std::uint64_t>(x)}; };
        const Half both_low = low_of(a.low_) * low_of(b.low_);
        const Half first = low_of(a.low_) * (b.low_ >> 64) + (both_low >> 64);
        const Half second = (a.low_ >> 64) * low_of(b.low_) + low_of(first);
        return {second << 64 | low_of(both_low),
                (a.low_ >> 64) * (b.low_ >> 64) + (first >> 64) + (second >> 64) +
                    a.low_ * static_cast<Half>(b.high_) + static_cast<Half>(a.high_) * b.low_};
    }
    [[nodiscard]] Sign sign() const noexcept {
        return high_ < 0 ? -1 : static_cast<Sign>(high_ > 0 || low_ > 0);
    }
 private:
    using Half = unsigned __int128;
    Integer256(Half low, Half high) noexcept : low_(low), high_(static_cast<Integer128>(high)) {}
    struct Halves {
        Half low;
        Integer128 high;
    };
    void operator+=(const Halves& b) noexcept {
        low_ += b.low;
        high_ += b.high + (low_ < b.low ? 1 : 0);
    }
    Half low_;
    Integer128 high_;
};
struct Factor {
    Integer128 value;
    friend Factor operator+(Factor a, Factor b) noexcept { return {a.value + b.value}; }
    friend Factor operator-(Factor a, Factor b) noexcept { return {a.value - b.value}; }
    friend Integer256 operator*(Factor a, Factor b) noexcept { return {a.value, b.value}; }
};
template <std::size_t d>
class IntegerRows {
 public:
    struct IntegerRow {
        std::array<std::int64_t, d> offset;
        Integer128 weight;
    };
    template <class S>
    IntegerRows(const std::array<const S*, d + 1>& sites, const S& q) noexcept {
        TwoTerms offsets[d + 1][d];
        double largest = 0.0;
        for (std::size_t m = 0; m <= d; ++m) {
            offsets[m][0] = two_difference(sites[m]->x, q.x);
            offsets[m][1] = two_difference(sites[m]->y, q.y);
            if constexpr (d == 3) offsets[m][2] = two_difference(sites[m]->z, q.z);
            for (const TwoTerms& each : offsets[m]) {
                are_exact_ &= each.low == 0.0;
                largest = std::max(largest, std::fabs(each.high));
            }
        }
        if (!are_exact_) return;
        if constexpr (words::has_r<decltype(q)>) {
            largest = std::max(largest, std::fabs(q.r));
            for (const S* site : sites) largest = std::max(largest, std::fabs(site->r));
        }
        constexpr std::uint64_t exponent_bits = 0x7FF0'0000'0000'0000;
        constexpr std::uint64_t sum_of_exponents = std::uint64_t{2 * 1023 + 59} << 52;
        const double scale = words::bit_cast<double>(
            sum_of_exponents - (words::bit_cast<std::uint64_t>(largest) & exponent_bits));
        for (std::size_t m = 0; m <= d; ++m) {
            for (std::size_t k = 0; k < d; ++k)
                rows_[m].offset[k] = integer(offsets[m][k].high * scale);
            rows_[m].weight = weight(*sites[m], q, scale);
        }
    }
    [[nodiscard]] bool are_exact() const noexcept { return are_exact_; }
    [[nodiscard]] const IntegerRow& operator[](std::size_t m) const noexcept { return rows_[m]; }
    [[nodiscard]] bool divide_by_power_of_two(int power) noexcept {
        std::int64_t bits = 0;
        Integer128 weight_bits = 0;
        for (const IntegerRow& row : rows_) {
            for (const std::int64_t each : row.offset) bits |= each;
            weight_bits |= row.weight;
        }
        const std::int64_t low = (std::int64_t{1} << power) - 1;
        const Integer128 weight_low = (Integer128{1} << 2 * power) - 1;
        if ((bits & low) != 0 || (weight_bits & weight_low) != 0) return false;
        for (IntegerRow& row : rows_) {
            for (std::int64_t& each : row.offset) each >>= power;
            row.weight >>= 2 * power;
        }
        return true;
    }
 private:
    [[nodiscard]] std::int64_t integer(double value) noexcept {
        if (!(std::fabs(value) < 0x1p60)) {
            are_exact_ = false;
            return 0;
        }
        const auto result = static_cast<std::int64_t>(value);
        are_exact_ &= static_cast<double>(result) == value;
        return result;
    }
    template <class S>
    [[nodiscard]] Integer128 weight(const S& m, const S& q, double scale) noexcept {
        if constexpr (words::has_w<decltype(m)>) {
            const TwoTerms difference = two_difference(m.w, q.w);
            const double value = difference.high * scale * scale;
            if (difference.low != 0.0 || !(std::fabs(value) < 0x1p122)) {
                are_exact_ = false;
                return 0;
            }
            const auto result = static_cast<Integer128>(value);
            are_exact_ &= static_cast<double>(result) == value;
            return result;
        } else if constexpr (words::has_r<decltype(m)>) {
            const Integer128 m_radius = integer(m.r * scale);
            const Integer128 q_radius = integer(q.r * scale);
            return (m_radius - q_radius) * (m_radius + q_radius);
        } else {
            return 0;
        }
    }
    bool are_exact_ = true;
    std::array<IntegerRow, d + 1> rows_;
};
}
#endif

// ---- predicates/arithmetic.hpp -------------------------------------------------------------------

namespace rooms {
enum class Arithmetic : std::uint8_t {
    exact,
    naive,
    single,
    interval,
    sum,
    multiprecision,
    judging
};
[[nodiscard]] constexpr bool is_exact(Arithmetic arithmetic) noexcept {
    return arithmetic != Arithmetic::naive && arithmetic != Arithmetic::single;
}
namespace predicates {
[[nodiscard]] constexpr bool is_filtered(Arithmetic arithmetic) noexcept {
    return arithmetic == Arithmetic::exact || arithmetic == Arithmetic::judging;
}
template <Arithmetic arithmetic>
using NumberOf = std::conditional_t<
    arithmetic == Arithmetic::single, float,
    std::conditional_t<arithmetic == Arithmetic::interval, filters::Interval, double>>;
[[nodiscard]] constexpr Site rounded(Arithmetic arithmetic, const Site& site) noexcept {
    if (arithmetic != Arithmetic::single) return site;
    return {static_cast<float>(site.x), static_cast<float>(site.y), static_cast<float>(site.r)};
}
}
}

// ---- predicates/ladder/decision.hpp --------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::predicates {
template <Arithmetic arithmetic, class Formula, class... Sites>
[[nodiscard, gnu::always_inline]] inline Decision decide(const Sites&... sites) noexcept {
    if constexpr (is_filtered(arithmetic)) {
        if constexpr (words::has_filter<Formula>) {
            const filters::Verdict verdict = Formula::filter(sites...);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return Formula::template behind<arithmetic>(sites...);
    } else if constexpr (is_exact(arithmetic) && arithmetic != Arithmetic::interval) {
        return Formula::template behind<arithmetic>(sites...);
    } else {
        const auto number = Formula::template value<NumberOf<arithmetic>>(sites...);
        if (filters::exceeds(number, 0.0))
            return {filters::sign_of_nonzero(number), Stage::filter};
        if constexpr (is_exact(arithmetic))
            return Formula::template behind<Arithmetic::sum>(sites...);
        else
            return {0, Stage::filter};
    }
}
}
SIGNUM_IEEE_END

// ---- predicates/formulas/difference.hpp ----------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::predicates {
template <class Number, class Operand>
[[nodiscard, gnu::always_inline]] constexpr auto difference(const Operand& a,
                                                            const Operand& b) noexcept {
    if constexpr (words::has_difference<Number>)
        return Number::difference(a, b);
    else
        return Number(a) - Number(b);
}
template <class Number, class Operand>
[[nodiscard, gnu::always_inline]] constexpr auto difference_of_squares(const Operand& a,
                                                                       const Operand& b) noexcept {
    if constexpr (words::has_difference_of_squares<Number>)
        return Number::difference_of_squares(a, b);
    else
        return (Number(a) - Number(b)) * (Number(a) + Number(b));
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto zero() noexcept {
    if constexpr (words::has_zero<Number>)
        return Number::zero();
    else
        return Number(0.0);
}
}
SIGNUM_IEEE_END

// ---- predicates/formulas/orientation.hpp ---------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::predicates {
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto ccw_determinant(const Number& ax, const Number& ay,
                                                                 const Number& bx,
                                                                 const Number& by) {
    return ax * by - ay * bx;
}
template <class Number>
struct Offset3 {
    Number x;
    Number y;
    Number z;
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto offset(const S& to, const S& from) noexcept {
    return Offset3<decltype(difference<Number>(to.x, from.x))>{difference<Number>(to.x, from.x),
                                                               difference<Number>(to.y, from.y),
                                                               difference<Number>(to.z, from.z)};
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr auto ccw_determinant(const Offset3<Number>& b,
                                                                 const Offset3<Number>& c,
                                                                 const Offset3<Number>& d) {
    return b.x * (c.y * d.z - c.z * d.y) + b.y * (c.z * d.x - c.x * d.z) +
           b.z * (c.x * d.y - c.y * d.x);
}
}
SIGNUM_IEEE_END

// ---- predicates/formulas/lifted.hpp --------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto weight_difference(const S& m,
                                                                   const S& q) noexcept {
    if constexpr (words::has_w<decltype(m)>)
        return predicates::difference<Number>(m.w, q.w);
    else if constexpr (words::has_r<decltype(m)>)
        return predicates::difference_of_squares<Number>(m.r, q.r);
    else
        return predicates::zero<Number>();
}
template <class Number, class Weight = Number>
struct Row {
    Number x;
    Number y;
    Weight weight;
    [[nodiscard, gnu::always_inline]] constexpr auto height() const {
        return (x * x + y * y) - weight;
    }
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto row(const S& m, const S& q) noexcept {
    using predicates::difference;
    return Row<decltype(difference<Number>(m.x, q.x)), decltype(weight_difference<Number>(m, q))>{
        difference<Number>(m.x, q.x), difference<Number>(m.y, q.y),
        weight_difference<Number>(m, q)};
}
template <class Row, class Number>
[[nodiscard]] constexpr auto in_segment_determinant(const Row& a, const Row& b, const Number& t_a,
                                                    const Number& t_b) {
    return a.height() * t_b - b.height() * t_a;
}
template <class Row>
[[nodiscard, gnu::always_inline]] constexpr auto in_circle_determinant(const Row& i, const Row& j,
                                                                       const Row& k) {
    return i.height() * (j.x * k.y - k.x * j.y) + j.height() * (k.x * i.y - i.x * k.y) +
           k.height() * (i.x * j.y - j.x * i.y);
}
template <class Number, class Weight = Number>
struct LiftedRow {
    predicates::Offset3<Number> offset;
    Weight weight;
    [[nodiscard, gnu::always_inline]] constexpr auto height() const {
        const auto& [x, y, z] = offset;
        return (x * x + y * y + z * z) - weight;
    }
};
template <class Number = double, class S>
[[nodiscard, gnu::always_inline]] constexpr auto lifted_row(const S& m, const S& q) noexcept {
    using predicates::difference;
    return LiftedRow<decltype(difference<Number>(m.x, q.x)),
                     decltype(weight_difference<Number>(m, q))>{predicates::offset<Number>(m, q),
                                                                weight_difference<Number>(m, q)};
}
template <class Row>
[[nodiscard, gnu::always_inline]] constexpr auto in_sphere_determinant(const Row& i, const Row& j,
                                                                       const Row& k, const Row& l) {
    const auto& a = i.offset;
    const auto& b = j.offset;
    const auto& c = k.offset;
    const auto& d = l.offset;
    const auto ab = a.x * b.y - b.x * a.y;
    const auto bc = b.x * c.y - c.x * b.y;
    const auto cd = c.x * d.y - d.x * c.y;
    const auto da = d.x * a.y - a.x * d.y;
    const auto ac = a.x * c.y - c.x * a.y;
    const auto bd = b.x * d.y - d.x * b.y;
    return (i.height() * (b.z * cd - c.z * bd + d.z * bc) +
            k.height() * (d.z * ab + a.z * bd + b.z * da)) -
           (j.height() * (c.z * da + d.z * ac + a.z * cd) +
            l.height() * (a.z * bc - b.z * ac + c.z * ab));
}
template <class Number = double, class P, class Q>
[[nodiscard, gnu::always_inline]] constexpr auto squared_distance(const P& p, const Q& q) noexcept {
    using predicates::difference;
    const auto x = difference<Number>(p.x, q.x);
    const auto y = difference<Number>(p.y, q.y);
    if constexpr (words::has_z<decltype(q)>) {
        const auto z = difference<Number>(p.z, q.z);
        return x * x + y * y + z * z;
    } else {
        return x * x + y * y;
    }
}
template <class Number, class P, class S>
[[nodiscard, gnu::always_inline]] constexpr auto nearer_difference(const P& p, const S& a,
                                                                   const S& b) noexcept {
    return (squared_distance<Number>(p, b) - squared_distance<Number>(p, a)) +
           weight_difference<Number>(a, b);
}
}
SIGNUM_IEEE_END

// ---- predicates/ccw.hpp --------------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms {
namespace predicates {
inline constexpr double ccw_error = 5 * filters::epsilon;
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_ccw(
    const Number& ax, const Number& ay, const Number& bx, const Number& by) noexcept {
    using filters::magnitude;
    return {ccw_determinant(ax, ay, bx, by), ccw_error * magnitude(ax * by + ay * bx) + 0x1p-1000};
}
template <class S>
[[nodiscard]] inline filters::Verdict ccw_filter(const S& a, const S& b, const S& c) noexcept {
    const Point origin = {filters::opaque(c.x), filters::opaque(c.y)};
    const double ax = filters::pinned(a.x) - origin.x;
    const double ay = filters::pinned(a.y) - origin.y;
    const double bx = filters::pinned(b.x) - origin.x;
    const double by = filters::pinned(b.y) - origin.y;
    const auto [determinant, bound] = compared_ccw(ax, ay, bx, by);
    if (!filters::environment_is_default())
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound))
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}
struct Ccw {
    static constexpr std::size_t origin = 2;
    static constexpr int window = 200;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& c) noexcept {
        return ccw_determinant(difference<Number>(a.x, c.x), difference<Number>(a.y, c.y),
                               difference<Number>(b.x, c.x), difference<Number>(b.y, c.y));
    }
    template <class S>
    [[nodiscard]] static filters::Verdict filter(const S& a, const S& b, const S& c) noexcept {
        return ccw_filter(a, b, c);
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::cold, gnu::pure, gnu::noinline]] static Decision behind(const S& a,
                                                                              const S& b,
                                                                              const S& c) noexcept {
        return of_points<arithmetic>({a.x, a.y}, {b.x, b.y}, {c.x, c.y});
    }
    template <Arithmetic arithmetic>
    [[nodiscard, gnu::pure]] static Decision of_points(Point a, Point b, Point c) noexcept;
};
}
template <class S>
[[nodiscard]] inline Decision ccw_decision(const S& a, const S& b, const S& c) noexcept {
    return predicates::decide<Arithmetic::exact, predicates::Ccw>(a, b, c);
}
template <class S>
[[nodiscard]] inline Sign ccw(const S& a, const S& b, const S& c) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, c));
    return ccw_decision(a, b, c).sign;
}
[[nodiscard]] inline Decision ccw_decision(const Point& a, const Point& b,
                                           const Point& c) noexcept {
    return ccw_decision<Point>(a, b, c);
}
[[nodiscard]] inline Sign ccw(const Point& a, const Point& b, const Point& c) noexcept {
    return ccw<Point>(a, b, c);
}
}
SIGNUM_IEEE_END

// ---- single/parts/ladder.hpp ---------------------------------------------------------------------

namespace rooms::predicates {
template <Arithmetic>
using ExactNumber = exact::Dyadic;
template <Arithmetic>
[[nodiscard]] inline exact::Dyadic exactly(double value) {
    return exact::Dyadic(value);
}
namespace ladder {
using filters::Verdict;
struct Refined {
    using Number = filters::DoubleDouble;
    [[nodiscard]] static Number difference(double a, double b) noexcept {
        return filters::exact_difference(a, b);
    }
    [[nodiscard]] static Number difference_of_squares(double a, double b) noexcept {
        return filters::exact_difference(a, b) * filters::exact_sum(a, b);
    }
    [[nodiscard]] static Number zero() noexcept { return {0.0, 0.0}; }
};
struct Expanded {
    [[nodiscard]] static exact::Expansion<2> difference(double a, double b) noexcept {
        return exact::difference(a, b);
    }
    [[nodiscard]] static exact::Expansion<4> difference_of_squares(double a, double b) noexcept {
        return exact::product(a, a) - exact::product(b, b);
    }
    [[nodiscard]] static exact::Expansion<1> zero() noexcept { return {}; }
};
struct Exactly {
    using Number = exact::Dyadic;
    [[nodiscard]] static Number difference(double a, double b) { return Number(a) - Number(b); }
    [[nodiscard]] static Number difference_of_squares(double a, double b) {
        return Number(a) * Number(a) - Number(b) * Number(b);
    }
    [[nodiscard]] static Number zero() { return {}; }
};
[[nodiscard]] inline Verdict judged(double value, double bound) noexcept {
    if (filters::magnitude(value) > bound) return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}
template <class Formula>
struct FilterAgain {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        return Formula::filter(sites...);
    }
};
template <class Formula>
struct Bounded {
    static constexpr Stage stage = Stage::filter;
    template <class... Sites>
    [[nodiscard]] static Verdict ask(const Sites&... sites) noexcept {
        const auto [value, bound] = Formula::bounded(sites...);
        return judged(value, bound);
    }
};
template <class Formula>
struct InExactNumbers {
    static constexpr Stage stage = Stage::multiprecision;
    template <class... Sites>
    [[nodiscard, gnu::cold, gnu::noinline]] static Verdict ask(const Sites&... sites) noexcept {
        return Verdict::certain(Formula::template value<Exactly>(sites...).sign());
    }
};
template <class Formula>
struct InExpansions : InExactNumbers<Formula> {};
template <>
struct InExpansions<Ccw> {
    static constexpr Stage stage = Stage::exact;
    [[nodiscard, gnu::noinline]] static Verdict ask(const Point& a, const Point& b,
                                                    const Point& c) noexcept {
        return Verdict::certain(Ccw::value<Expanded>(a, b, c).sign());
    }
};
template <class First, class... Others>
struct Steps {
    template <class... Sites>
    [[nodiscard]] static Decision climb(const Sites&... sites) noexcept {
        const Verdict verdict = First::ask(sites...);
        if constexpr (sizeof...(Others) > 0)
            if (!verdict.is_certain()) return Steps<Others...>::climb(sites...);
        return {verdict.sign(), First::stage};
    }
};
template <class Formula>
using Beyond = Steps<InExactNumbers<Formula>>;
template <int exponent, class S>
[[nodiscard]] inline bool in_window(const S& s) noexcept {
    using exact::window::contains;
    bool holds = contains(s.x, exponent) && contains(s.y, exponent);
    if constexpr (words::has_z<S>) holds = holds && contains(s.z, exponent);
    if constexpr (words::has_r<S>) holds = holds && contains(s.r, exponent);
    if constexpr (words::has_w<S>) holds = holds && contains(s.w, 2 * exponent);
    return holds;
}
template <class Formula, class Within, class Outside, class... Sites>
[[nodiscard, gnu::noinline]] Decision climb_one(const Sites&... sites) noexcept {
    if constexpr (words::has_window<Formula>)
        if ((in_window<Formula::window>(sites) && ...)) return Within::climb(sites...);
    return Outside::climb(sites...);
}
template <Arithmetic, class Formula, class Within, class Outside, class... Sites>
[[nodiscard]] inline Decision climb(const Sites&... sites) noexcept {
    return exact::in_ieee_environment(climb_one<Formula, Within, Outside, Sites...>, sites...);
}
}
}

// ---- predicates/ladder/doubted.hpp ---------------------------------------------------------------

namespace rooms::euclidean {
template <class Number>
class Doubted : public exact::ComparedBySign<Doubted<Number>> {
 public:
    Doubted() = default;
    Doubted(double number, bool& doubt) noexcept : number_(exactly(number)), doubt_(&doubt) {}
    friend Doubted operator+(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ + b.number_, a.doubt_};
    }
    friend Doubted operator-(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ - b.number_, a.doubt_};
    }
    friend Doubted operator*(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ * b.number_, a.doubt_};
    }
    friend Doubted operator*(int a, const Doubted& b) noexcept {
        return {exactly(a) * b.number_, b.doubt_};
    }
    [[nodiscard]] Sign sign() const noexcept {
        const filters::Verdict verdict = sign_of_number(number_);
        *doubt_ |= !verdict.is_certain();
        return verdict.is_certain() ? verdict.sign() : 0;
    }
 private:
    Doubted(const Number& number, bool* doubt) noexcept : number_(number), doubt_(doubt) {}
    [[nodiscard]] static Number exactly(double number) noexcept {
        if constexpr (words::has_exactly<Number>)
            return Number::exactly(number);
        else
            return Number(number);
    }
    template <class Any>
    [[nodiscard]] static filters::Verdict sign_of_number(const Any& number) noexcept {
        return number.sign();
    }
    [[nodiscard]] static filters::Verdict sign_of_number(const filters::Interval& number) noexcept {
        const Sign least = sign_of(number.low);
        return least == sign_of(number.high) ? filters::Verdict::certain(least)
                                             : filters::Verdict::uncertain();
    }
    Number number_ = exactly(0.0);
    bool* doubt_ = nullptr;
};
}

// ---- predicates/ccw.cpp --------------------------------------------------------------------------

namespace rooms::predicates {
template <Arithmetic arithmetic>
Decision Ccw::of_points(Point a, Point b, Point c) noexcept {
    using Within = ladder::Steps<ladder::FilterAgain<Ccw>, ladder::InExpansions<Ccw>>;
    return ladder::climb<arithmetic, Ccw, Within, ladder::Beyond<Ccw>>(a, b, c);
}
}

// ---- predicates/power/weight.hpp -----------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
template <class S>
[[nodiscard]] inline double weight_key(const S& s) noexcept {
    if constexpr (words::has_w<decltype(s)>)
        return s.w;
    else if constexpr (words::has_r<decltype(s)>)
        return filters::magnitude(s.r);
    else
        return 0.0;
}
template <class S>
[[nodiscard]] inline Point centre(const S& s) noexcept {
    return {s.x, s.y};
}
template <class S>
[[nodiscard]] inline S made_of(const rooms::Site& site) noexcept {
    if constexpr (words::same<S, Point>)
        return {site.x, site.y};
    else
        return {site.x, site.y, site.r};
}
}
SIGNUM_IEEE_END

// ---- predicates/power/in_circle.hpp --------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
inline constexpr double in_circle_error = 13 * filters::epsilon;
inline constexpr auto rounded_row = row<filters::RoundingCount>(rooms::Site{}, rooms::Site{});
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_in_circle(
    const Row<Number>& a, const Row<Number>& b, const Row<Number>& c) noexcept {
    using filters::magnitude;
    const Number a_square = a.x * a.x + a.y * a.y;
    const Number b_square = b.x * b.x + b.y * b.y;
    const Number c_square = c.x * c.x + c.y * c.y;
    const Number s = (a_square + magnitude(a.weight)) + (b_square + magnitude(b.weight)) +
                     (c_square + magnitude(c.weight));
    return {in_circle_determinant(a, b, c),
            5 * filters::epsilon * (s * s) + (0x1p-1000 * s + 0x1p-1000)};
}
template <class Number>
[[nodiscard]] constexpr Number determinant_magnitude(const Row<Number>& a, const Row<Number>& b,
                                                     const Row<Number>& c) noexcept {
    using filters::magnitude;
    const auto absolute = [](const Row<Number>& row) {
        return Row<Number>{magnitude(row.x), magnitude(row.y), magnitude(row.weight)};
    };
    const Row<Number> i = absolute(a);
    const Row<Number> j = absolute(b);
    const Row<Number> k = absolute(c);
    return (i.x * i.x + i.y * i.y + i.weight) * (j.x * k.y + k.x * j.y) +
           (j.x * j.x + j.y * j.y + j.weight) * (k.x * i.y + i.x * k.y) +
           (k.x * k.x + k.y * k.y + k.weight) * (i.x * j.y + j.x * i.y);
}
template <class Number>
[[nodiscard]] constexpr filters::Compared<Number> compared_in_circle_finely(
    const Row<Number>& a, const Row<Number>& b, const Row<Number>& c) noexcept {
    return {in_circle_determinant(a, b, c), in_circle_error * determinant_magnitude(a, b, c)};
}
template <class S>
[[nodiscard]] inline filters::Verdict in_circle_filter(const S& i, const S& j, const S& k,
                                                       const S& q,
                                                       double exact_below = 0.0) noexcept {
    const S origin = filters::pinned(q);
    const Row<double> a = row(filters::pinned(i), origin);
    const Row<double> b = row(filters::pinned(j), origin);
    const Row<double> c = row(filters::pinned(k), origin);
    const auto [determinant, bound] = compared_in_circle(a, b, c);
    if (!filters::environment_is_default())
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound))
        return bound < exact_below ? filters::Verdict::certain(sign_of(determinant))
                                   : filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}
template <class S>
[[nodiscard, gnu::always_inline]] inline std::optional<std::array<bool, 2>> in_circles_filter(
    const std::array<const S*, 3>& first, const std::array<const S*, 3>& second,
    const S& q) noexcept {
    using filters::Two;
    const S origin = filters::pinned(q);
    const auto beside = [&](std::size_t m) {
        const Row<double> a = row(filters::pinned(*first[m]), origin);
        const Row<double> b = row(filters::pinned(*second[m]), origin);
        return Row<Two>{Two{a.x, b.x}, Two{a.y, b.y}, Two{a.weight, b.weight}};
    };
    const auto [determinants, bounds] = compared_in_circle(beside(0), beside(1), beside(2));
    if (!filters::environment_is_default())
        return std::nullopt;
    if (!filters::all_exceed(filters::magnitude(determinants), bounds))
        return std::nullopt;
    return std::array{filters::sign_of_nonzero(determinants[0]) > 0,
                      filters::sign_of_nonzero(determinants[1]) > 0};
}
struct InCircle {
    static constexpr std::size_t origin = 3;
    static constexpr int window = 200;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& i, const S& j,
                                                                  const S& k, const S& q) noexcept {
        return in_circle_determinant(row<Number>(i, q), row<Number>(j, q), row<Number>(k, q));
    }
    template <class S>
    [[nodiscard]] static filters::Verdict filter(const S& i, const S& j, const S& k,
                                                 const S& q) noexcept {
        return in_circle_filter(i, j, k, q);
    }
    template <class S>
    [[nodiscard]] static filters::Compared<double> bounded(const S& i, const S& j, const S& k,
                                                           const S& q) noexcept {
        return compared_in_circle_finely(row(i, q), row(j, q), row(k, q));
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision behind(const S& i, const S& j, const S& k,
                                                               const S& q) noexcept;
};
template <class S>
[[nodiscard]] inline Decision in_circle_decision(const S& i, const S& j, const S& k,
                                                 const S& q) noexcept {
    SIGNUM_EXPECTS(ccw(i, j, k) > 0);
    return predicates::decide<Arithmetic::exact, InCircle>(i, j, k, q);
}
}
SIGNUM_IEEE_END

// ---- predicates/power/infinite.hpp ---------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
inline constexpr double in_segment_error = 9 * filters::epsilon;
template <class Number>
[[nodiscard]] constexpr filters::Compared<Number> compared_in_segment(const Row<Number>& a,
                                                                      const Row<Number>& b,
                                                                      const Number& t_a,
                                                                      const Number& t_b) noexcept {
    using filters::magnitude;
    const Number a_square = a.x * a.x + a.y * a.y;
    const Number b_square = b.x * b.x + b.y * b.y;
    return {in_segment_determinant(a, b, t_a, t_b),
            in_segment_error * ((a_square + magnitude(a.weight)) * magnitude(t_b) +
                                (b_square + magnitude(b.weight)) * magnitude(t_a))};
}
struct InSegment {
    static constexpr int window = 200;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& q) noexcept {
        const auto determinant = along<Number>(
            a, b, q, [](const auto&... numbers) { return in_segment_determinant(numbers...); });
        return rises(a, b) ? determinant : -determinant;
    }
    template <class S>
    [[nodiscard]] static filters::Compared<double> bounded(const S& a, const S& b,
                                                           const S& q) noexcept {
        const auto [determinant, bound] = along<double>(
            a, b, q, [](const auto&... numbers) { return compared_in_segment(numbers...); });
        return {rises(a, b) ? determinant : -determinant, bound};
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::pure]] static Decision behind(const S& a, const S& b, const S& q) noexcept;
 private:
    template <class Number, class S, class Of>
    [[nodiscard, gnu::always_inline]] static constexpr auto along(const S& a, const S& b,
                                                                  const S& q, Of of) noexcept {
        const auto row_a = row<Number>(a, q);
        const auto row_b = row<Number>(b, q);
        return filters::same_number(a.x, b.x) ? of(row_a, row_b, row_a.y, row_b.y)
                                              : of(row_a, row_b, row_a.x, row_b.x);
    }
    template <class S>
    [[nodiscard, gnu::always_inline]] static bool rises(const S& a, const S& b) noexcept {
        const Sign by_x = filters::compare_numbers(b.x, a.x);
        return (by_x != 0 ? by_x : filters::compare_numbers(b.y, a.y)) > 0;
    }
};
template <class S>
[[nodiscard]] inline Decision in_segment_decision(const S& a, const S& b, const S& q) noexcept {
    return predicates::decide<Arithmetic::exact, InSegment>(a, b, q);
}
}
SIGNUM_IEEE_END

// ---- predicates/power/infinite.cpp ---------------------------------------------------------------

namespace rooms::power {
template <Arithmetic arithmetic, class S>
Decision InSegment::behind(const S& a, const S& b, const S& q) noexcept {
    namespace ladder = predicates::ladder;
    using Within = ladder::Steps<ladder::Bounded<InSegment>, ladder::InExpansions<InSegment>>;
    return ladder::climb<arithmetic, InSegment, Within,
                         ladder::Steps<ladder::InExactNumbers<InSegment>>>(a, b, q);
}
}

// ---- predicates/power/edge.hpp -------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
inline constexpr double nearer_in_plane_error = 7 * filters::epsilon;
template <class Number, class S>
[[nodiscard]] constexpr filters::Compared<Number> compared_nearer(const Point& p, const S& a,
                                                                  const S& b) noexcept {
    using filters::magnitude;
    const Number size = squared_distance<Number>(p, a) + squared_distance<Number>(p, b) +
                        magnitude(weight_difference<Number>(a, b));
    return {nearer_difference<Number>(p, a, b), nearer_in_plane_error * size};
}
struct Nearer {
    static constexpr int window = 200;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const Point& p, const S& a,
                                                                  const S& b) noexcept {
        return nearer_difference<Number>(p, a, b);
    }
    template <class S>
    [[nodiscard]] static filters::Compared<double> bounded(const Point& p, const S& a,
                                                           const S& b) noexcept {
        return compared_nearer<double>(p, a, b);
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::pure]] static Decision behind(const Point& p, const S& a,
                                                    const S& b) noexcept;
};
template <class S>
[[nodiscard]] inline Decision nearer_decision(const Point& p, const S& a, const S& b) noexcept {
    return predicates::decide<Arithmetic::exact, Nearer>(p, a, b);
}
}
SIGNUM_IEEE_END

// ---- predicates/power/edge.cpp -------------------------------------------------------------------

namespace rooms::power {
template <Arithmetic arithmetic, class S>
Decision Nearer::behind(const Point& p, const S& a, const S& b) noexcept {
    namespace ladder = predicates::ladder;
    using Within = ladder::Steps<ladder::Bounded<Nearer>, ladder::InExpansions<Nearer>>;
    return ladder::climb<arithmetic, Nearer, Within, ladder::Beyond<Nearer>>(p, a, b);
}
}

// ---- predicates/power/ties.hpp -------------------------------------------------------------------

namespace rooms::power {
template <class S>
[[nodiscard]] bool precedes(const S& a, Index a_index, const S& b, Index b_index) noexcept {
    using filters::compare_numbers;
    int order = compare_numbers(weight_key(b), weight_key(a));
    if (order == 0) order = compare_numbers(a.x, b.x);
    if (order == 0) order = compare_numbers(a.y, b.y);
    return order != 0 ? order < 0 : a_index < b_index;
}
[[nodiscard]] Sign in_circle_tie(Point i, Point j, Point k, Point q,
                                 const std::array<Index, 4>& ranks) noexcept;
[[nodiscard]] Sign in_segment_tie(Point a, Point b, Point q,
                                  const std::array<Index, 3>& ranks) noexcept;
}

// ---- predicates/power/ties.cpp -------------------------------------------------------------------

namespace rooms::power {
namespace {
template <std::size_t n, class Coefficient>
Sign last_nonzero(std::array<Index, n> ranks, Coefficient coefficient) noexcept {
    for (std::size_t round = 0; round < n; ++round) {
        const auto last = std::max_element(ranks.begin(), ranks.end());
        const Sign sign = coefficient(last - ranks.begin());
        if (sign != 0) return sign;
        *last = std::numeric_limits<Index>::min();
    }
    SIGNUM_EXPECTS(false && "the coefficient of q is not 0");
    return -1;
}
}
Sign in_circle_tie(Point i, Point j, Point k, Point q, const std::array<Index, 4>& ranks) noexcept {
    return last_nonzero(ranks, [&](std::ptrdiff_t m) {
        return m == 0 ? ccw(j, k, q) : m == 1 ? ccw(k, i, q) : m == 2 ? ccw(i, j, q) : -1;
    });
}
namespace {
Sign decide_in_segment(const Point& a, const Point& b, const Point& q,
                       const std::array<Index, 3>& ranks) noexcept {
    const bool along_x = a.x != b.x;
    const auto order = [along_x](Point from, Point to) -> Sign {
        return along_x ? (from.x < to.x) - (from.x > to.x) : (from.y < to.y) - (from.y > to.y);
    };
    const Sign direction = order(a, b);
    return last_nonzero(ranks, [&](std::ptrdiff_t m) {
        return m == 0 ? order(q, b) * direction : m == 1 ? order(a, q) * direction : -1;
    });
}
}
Sign in_segment_tie(Point a, Point b, Point q, const std::array<Index, 3>& ranks) noexcept {
    return exact::in_ieee_environment(decide_in_segment, a, b, q, ranks);
}
}

// ---- predicates/power.hpp ------------------------------------------------------------------------

namespace rooms::power {
template <class S>
[[nodiscard]] inline bool exists(const S& i, const S& j, const S& k) noexcept {
    return ccw(i, j, k) > 0;
}
template <class S>
[[nodiscard]] inline Sign in_circle(const S& i, const S& j, const S& k, const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return in_circle_decision(i, j, k, q).sign;
}
template <class S>
[[nodiscard]] inline Sign in_circle_infinite(const S& a, const S& b, const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    const Sign side = ccw(a, b, q);
    return side != 0 ? -side : in_segment_decision(a, b, q).sign;
}
template <class S>
[[nodiscard]] inline Sign nearer(Point p, const S& a, const S& b) noexcept {
    SIGNUM_EXPECTS(are_finite(p, a, b));
    return nearer_decision(p, a, b).sign;
}
template <class S>
[[nodiscard]] inline bool hidden(const S& q, const S& i) noexcept {
    return filters::same_number(q.x, i.x) && filters::same_number(q.y, i.y) &&
           nearer(centre(q), q, i) <= 0;
}
template <class S>
[[nodiscard]] inline Sign in_circle_perturbed(const S& i, const S& j, const S& k, const S& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    const Sign sign = in_circle(i, j, k, q);
    return sign != 0 ? sign : in_circle_tie(centre(i), centre(j), centre(k), centre(q), ranks);
}
template <class S>
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const S& a, const S& b, const S& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    const Sign sign = in_circle_infinite(a, b, q);
    return sign != 0 ? sign : in_segment_tie(centre(a), centre(b), centre(q), ranks);
}
}

// ---- predicates/space/ccw.hpp --------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms {
template <class S>
[[nodiscard]] constexpr Point3 centre3(const S& s) noexcept {
    return {s.x, s.y, s.z};
}
namespace predicates {
template <class Number>
[[nodiscard]] inline Offset3<Number> reach(const Offset3<Number>& b, const Offset3<Number>& c,
                                           const Offset3<Number>& d) noexcept {
    using filters::magnitude;
    using filters::max;
    const auto largest = [](const Number& p, const Number& q, const Number& r) {
        return max(max(magnitude(p), magnitude(q)), magnitude(r));
    };
    return {largest(b.x, c.x, d.x), largest(b.y, c.y, d.y), largest(b.z, c.z, d.z)};
}
[[nodiscard]] inline bool in_filter_window(const Offset3<double>& largest) noexcept {
    using filters::max;
    using filters::min;
    return min(min(largest.x, largest.y), largest.z) >= 0x1p-150 &&
           max(max(largest.x, largest.y), largest.z) <= 0x1p150;
}
inline constexpr double ccw3_error = 6 * 9 * filters::epsilon;
inline constexpr auto rounded_offset = offset<filters::RoundingCount>(Point3{}, Point3{});
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_ccw(
    const Offset3<Number>& largest) noexcept {
    return ccw3_error * (largest.x * largest.y * largest.z);
}
template <class S>
[[nodiscard]] inline filters::Verdict ccw_filter(const S& a, const S& b, const S& c,
                                                 const S& d) noexcept {
    const Point3 origin = filters::pinned(centre3(a));
    const Offset3<double> u = offset(filters::pinned(centre3(b)), origin);
    const Offset3<double> v = offset(filters::pinned(centre3(c)), origin);
    const Offset3<double> w = offset(filters::pinned(centre3(d)), origin);
    const double determinant = ccw_determinant(u, v, w);
    const Offset3<double> largest = reach(u, v, w);
    const double bound = bound_of_ccw(largest);
    if (!filters::environment_is_default() || !in_filter_window(largest))
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(determinant) > bound))
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}
template <class Number>
[[nodiscard]] inline filters::Compared<Number> compared_ccw_finely(
    const Offset3<Number>& u, const Offset3<Number>& v, const Offset3<Number>& w) noexcept {
    const auto absolute = [](const Offset3<Number>& offset) {
        using filters::magnitude;
        return Offset3<Number>{magnitude(offset.x), magnitude(offset.y), magnitude(offset.z)};
    };
    const Offset3<Number> a = absolute(u);
    const Offset3<Number> b = absolute(v);
    const Offset3<Number> c = absolute(w);
    const Number magnitude = a.x * (b.y * c.z + b.z * c.y) + a.y * (b.z * c.x + b.x * c.z) +
                             a.z * (b.x * c.y + b.y * c.x);
    return {ccw_determinant(u, v, w), 9 * filters::epsilon * magnitude};
}
struct Ccw3 {
    static constexpr std::size_t origin = 0;
    static constexpr int window = 200;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& a, const S& b,
                                                                  const S& c, const S& d) noexcept {
        return ccw_determinant(offset<Number>(b, a), offset<Number>(c, a), offset<Number>(d, a));
    }
    template <class S>
    [[nodiscard]] static filters::Verdict filter(const S& a, const S& b, const S& c,
                                                 const S& d) noexcept {
        return ccw_filter(a, b, c, d);
    }
    [[nodiscard]] static filters::Compared<double> bounded(const Point3& a, const Point3& b,
                                                           const Point3& c,
                                                           const Point3& d) noexcept {
        return compared_ccw_finely(offset(b, a), offset(c, a), offset(d, a));
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::cold, gnu::pure, gnu::noinline]] static Decision behind(const S& a,
                                                                              const S& b,
                                                                              const S& c,
                                                                              const S& d) noexcept {
        return of_points<arithmetic>(centre3(a), centre3(b), centre3(c), centre3(d));
    }
    template <Arithmetic arithmetic>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision of_points(const Point3& a, const Point3& b,
                                                                  const Point3& c,
                                                                  const Point3& d) noexcept;
};
}
template <class S>
[[nodiscard]] inline Decision ccw_decision(const S& a, const S& b, const S& c,
                                           const S& d) noexcept {
    return predicates::decide<Arithmetic::exact, predicates::Ccw3>(a, b, c, d);
}
template <class S>
[[nodiscard]] inline Sign ccw(const S& a, const S& b, const S& c, const S& d) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, c, d));
    return ccw_decision(a, b, c, d).sign;
}
[[nodiscard]] inline Decision ccw_decision(const Point3& a, const Point3& b, const Point3& c,
                                           const Point3& d) noexcept {
    return ccw_decision<Point3>(a, b, c, d);
}
[[nodiscard]] inline Sign ccw(const Point3& a, const Point3& b, const Point3& c,
                              const Point3& d) noexcept {
    return ccw<Point3>(a, b, c, d);
}
}
SIGNUM_IEEE_END

// ---- single/parts/small_integers.hpp -------------------------------------------------------------

namespace rooms::predicates {
[[nodiscard, gnu::noinline]] inline bool are_small_integers(
    double most, std::initializer_list<const Point3*> points) noexcept {
    bool are_small = true;
    for (const Point3* p : points)
        for (const double x : {p->x, p->y, p->z})
            are_small &=
                filters::magnitude(x) <= most && static_cast<double>(static_cast<int>(x)) == x;
    return are_small;
}
namespace ladder {
template <>
struct InExpansions<Ccw3> {
    static constexpr Stage stage = Stage::exact;
    [[nodiscard]] static Verdict ask(const Point3& a, const Point3& b, const Point3& c,
                                     const Point3& d) noexcept {
        if (are_small_integers(0x1p15, {&a, &b, &c, &d}))
            return Verdict::certain(sign_of(Ccw3::value<double>(a, b, c, d)));
        return InExactNumbers<Ccw3>::ask(a, b, c, d);
    }
};
}
}

// ---- predicates/space/ccw.cpp --------------------------------------------------------------------

namespace rooms::predicates {
template <Arithmetic arithmetic>
Decision Ccw3::of_points(const Point3& a, const Point3& b, const Point3& c,
                         const Point3& d) noexcept {
    using Within = ladder::Steps<ladder::Bounded<Ccw3>, ladder::InExpansions<Ccw3>>;
    return ladder::climb<arithmetic, Ccw3, Within, ladder::Beyond<Ccw3>>(a, b, c, d);
}
}

// ---- predicates/space/in_sphere.hpp --------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
inline constexpr double in_sphere_error = 18 * filters::epsilon;
inline constexpr auto rounded_lifted_row =
    lifted_row<filters::RoundingCount>(rooms::Site3{}, rooms::Site3{});
inline constexpr double refined_in_sphere_error = 24 * 0x1p-102;
inline constexpr LiftedRow<filters::RoundingCount> refined_lifted_row{
    {filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount()},
    filters::RoundingCount::of(1)};
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_in_sphere(
    const predicates::Offset3<Number>& largest, const Number& weight) noexcept {
    const Number height =
        largest.x * largest.x + largest.y * largest.y + largest.z * largest.z + weight;
    return 24 * in_sphere_error * ((largest.x * largest.y) * (largest.z * height));
}
inline constexpr double largest_double = 0x1.fffffffffffffp1023;
struct PairedRow {
    filters::Two xy;
    filters::Two zw;
    [[nodiscard, gnu::always_inline]] operator LiftedRow<double>() const noexcept {
        return {{xy[0], xy[1], zw[0]}, zw[1]};
    }
};
template <class S>
[[nodiscard, gnu::always_inline]] inline PairedRow pinned_row(const S& m) noexcept {
    double last = 0.0;
    if constexpr (words::has_w<decltype(m)>) last = m.w;
    if constexpr (words::has_r<decltype(m)>) last = m.r;
    return {filters::pinned(filters::Two{m.x, m.y}), filters::pinned(filters::Two{m.z, last})};
}
template <class S>
[[nodiscard, gnu::always_inline]] inline PairedRow paired_row(const S& m,
                                                              const PairedRow& origin) noexcept {
    const PairedRow site = pinned_row(m);
    PairedRow row = {site.xy - origin.xy, site.zw - origin.zw};
    if constexpr (words::has_r<decltype(m)>) row.zw[1] *= site.zw[1] + origin.zw[1];
    return row;
}
template <class S>
[[nodiscard]] inline filters::Verdict in_sphere_filter(const S& i, const S& j, const S& k,
                                                       const S& l, const S& q) noexcept {
    using filters::magnitude;
    using filters::max;
    const PairedRow origin = pinned_row(q);
    const PairedRow a = paired_row(i, origin);
    const PairedRow b = paired_row(j, origin);
    const PairedRow c = paired_row(k, origin);
    const PairedRow d = paired_row(l, origin);
    const filters::Two xy =
        max(max(magnitude(a.xy), magnitude(b.xy)), max(magnitude(c.xy), magnitude(d.xy)));
    const filters::Two zw =
        max(max(magnitude(a.zw), magnitude(b.zw)), max(magnitude(c.zw), magnitude(d.zw)));
    const predicates::Offset3<double> largest = {xy[0], xy[1], zw[0]};
    const double bound = bound_of_in_sphere(largest, zw[1]);
    const double determinant = in_sphere_determinant<LiftedRow<double>>(a, b, c, d);
    if (!filters::environment_is_default() || !predicates::in_filter_window(largest))
        return filters::Verdict::uncertain();
    if (!(magnitude(determinant) > bound && magnitude(determinant) <= largest_double))
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
}
[[nodiscard, gnu::always_inline]] inline double determinant_magnitude(
    const LiftedRow<double> (&rows)[4]) noexcept {
    using filters::magnitude;
    const auto of_minor = [&](int j, int k, int l) {
        const auto& [bx, by, bz] = rows[j].offset;
        const auto& [cx, cy, cz] = rows[k].offset;
        const auto& [dx, dy, dz] = rows[l].offset;
        return magnitude(bz) * (magnitude(cx * dy) + magnitude(cy * dx)) +
               magnitude(cz) * (magnitude(dx * by) + magnitude(dy * bx)) +
               magnitude(dz) * (magnitude(bx * cy) + magnitude(by * cx));
    };
    const auto height = [&](int m) {
        const auto& [x, y, z] = rows[m].offset;
        return (x * x + y * y + z * z) + magnitude(rows[m].weight);
    };
    return height(0) * of_minor(1, 2, 3) + height(1) * of_minor(2, 3, 0) +
           height(2) * of_minor(3, 0, 1) + height(3) * of_minor(0, 1, 2);
}
struct InSphere {
    static constexpr std::size_t origin = 4;
    static constexpr int window = 150;
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const S& i, const S& j,
                                                                  const S& k, const S& l,
                                                                  const S& q) noexcept {
        return in_sphere_determinant(lifted_row<Number>(i, q), lifted_row<Number>(j, q),
                                     lifted_row<Number>(k, q), lifted_row<Number>(l, q));
    }
    template <class S>
    [[nodiscard]] static filters::Verdict filter(const S& i, const S& j, const S& k, const S& l,
                                                 const S& q) noexcept {
        return in_sphere_filter(i, j, k, l, q);
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::cold, gnu::pure]] static Decision behind(const S& i, const S& j, const S& k,
                                                               const S& l, const S& q) noexcept;
};
template <class S>
[[nodiscard]] inline Decision in_sphere_decision(const S& i, const S& j, const S& k, const S& l,
                                                 const S& q) noexcept {
    SIGNUM_EXPECTS(ccw(i, j, k, l) > 0);
    return predicates::decide<Arithmetic::exact, InSphere>(i, j, k, l, q);
}
template <class S>
[[nodiscard]] inline Sign in_sphere(const S& i, const S& j, const S& k, const S& l,
                                    const S& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, l, q));
    return in_sphere_decision(i, j, k, l, q).sign;
}
}
SIGNUM_IEEE_END

// ---- predicates/space/nearer.hpp -----------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::power {
inline constexpr double nearer_error = 9 * filters::epsilon;
template <class Number, class S>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_nearer(
    const Point3& p, const S& a, const S& b) noexcept {
    using filters::magnitude;
    const Number to_a = squared_distance<Number>(p, a);
    const Number to_b = squared_distance<Number>(p, b);
    const Number weight = weight_difference<Number>(a, b);
    return {(to_b - to_a) + weight, to_a + to_b + magnitude(weight)};
}
template <class S>
[[nodiscard]] inline filters::Verdict nearer_filter(const Point3& p, const S& a,
                                                    const S& b) noexcept {
    const Point3 eye = filters::pinned(p);
    const S one = filters::pinned(a);
    const S other = filters::pinned(b);
    const auto [difference, magnitude] = compared_nearer<double>(eye, one, other);
    if (!filters::environment_is_default() || !(magnitude >= 0x1p-890))
        return filters::Verdict::uncertain();
    if (!(filters::magnitude(difference) > nearer_error * magnitude))
        return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(difference));
}
struct Nearer3 {
    template <class Number, class S>
    [[nodiscard, gnu::always_inline]] static constexpr auto value(const Point3& p, const S& a,
                                                                  const S& b) noexcept {
        return nearer_difference<Number>(p, a, b);
    }
    template <class S>
    [[nodiscard]] static filters::Verdict filter(const Point3& p, const S& a, const S& b) noexcept {
        return nearer_filter(p, a, b);
    }
    template <Arithmetic arithmetic, class S>
    [[nodiscard, gnu::cold]] static Decision behind(const Point3& p, const S& a,
                                                    const S& b) noexcept;
};
template <class S>
[[nodiscard]] inline Decision nearer_decision(const Point3& p, const S& a, const S& b) noexcept {
    return predicates::decide<Arithmetic::exact, Nearer3>(p, a, b);
}
}
SIGNUM_IEEE_END

// ---- predicates/space/nearer.cpp -----------------------------------------------------------------

namespace rooms::power {
template <Arithmetic arithmetic, class S>
Decision Nearer3::behind(const Point3& p, const S& a, const S& b) noexcept {
    namespace ladder = predicates::ladder;
    using Beyond = ladder::Beyond<Nearer3>;
    return ladder::climb<arithmetic, Nearer3, Beyond, Beyond>(p, a, b);
}
}

// ---- predicates/additive.hpp ---------------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::additive {
struct Distance {
    double to_centre;
    double magnitude;
    double radius;
};
template <class Number>
[[nodiscard]] constexpr Number nearer_difference(Number to_a, Number to_b, Number radii) noexcept {
    return (to_b - to_a) + radii;
}
[[nodiscard]] inline filters::Verdict nearer(const Distance& a, const Distance& b) noexcept {
    const double radii = a.radius - b.radius;
    const double difference = nearer_difference(a.to_centre, b.to_centre, radii);
    const double bound =
        8 * filters::epsilon * ((a.magnitude + b.magnitude) + filters::magnitude(radii));
    static_assert(nearer_difference(filters::RoundingCount::of(3), filters::RoundingCount::of(3),
                                    filters::rounded_difference)
                      .roundings == 5);
    if (filters::magnitude(difference) > bound && filters::environment_is_default())
        return filters::Verdict::certain(filters::sign_of_nonzero(difference));
    return filters::Verdict::uncertain();
}
[[nodiscard]] inline bool precedes(const Site& a, Index a_index, const Site& b,
                                   Index b_index) noexcept {
    if (const Sign by_r = filters::compare_numbers(a.r, b.r); by_r != 0) return by_r > 0;
    if (const Sign by_x = filters::compare_numbers(a.x, b.x); by_x != 0) return by_x < 0;
    if (const Sign by_y = filters::compare_numbers(a.y, b.y); by_y != 0) return by_y < 0;
    return a_index < b_index;
}
template <std::size_t n>
[[nodiscard]] inline std::array<Index, n> ranks_of(const std::array<const Site*, n>& sites,
                                                   const std::array<Index, n>& numbers) noexcept {
    std::array<Index, n> ranks{};
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b)
            ++ranks[precedes(*sites[a], numbers[a], *sites[b], numbers[b]) ? b : a];
    return ranks;
}
template <std::size_t n>
[[nodiscard]] inline std::array<Index, n> ranks_of(
    const std::array<const Site*, n>& sites) noexcept {
    std::array<Index, n> numbers{};
    for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<Index>(i);
    return ranks_of(sites, numbers);
}
template <class Perturbed>
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k));
    return Perturbed::exists(i, j, k, ranks_of<3>({&i, &j, &k})).sign > 0;
}
template <auto decision>
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return decision(i, j, k, q, ranks_of<4>({&i, &j, &k, &q})).sign;
}
template <auto decision>
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    return decision(a, b, q, ranks_of<3>({&a, &b, &q})).sign;
}
template <class Perturbed>
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    SIGNUM_EXPECTS(are_finite(q, i));
    return Perturbed::hides(i, q, {0, 1}).sign > 0;
}
template <class Perturbed>
[[nodiscard]] inline Sign nearer_site(Point p, const Site& a, const Site& b) noexcept {
    SIGNUM_EXPECTS(are_finite(p, a, b));
    return Perturbed::nearer(p, a, b, {0, 1}).sign;
}
template <class Perturbed>
[[nodiscard]] inline Sign in_circle_perturbed(const Site& i, const Site& j, const Site& k,
                                              const Site& q,
                                              const std::array<Index, 4>& ranks) noexcept {
    SIGNUM_EXPECTS(are_finite(i, j, k, q));
    return Perturbed::in_circle(i, j, k, q, ranks).sign;
}
template <class Perturbed>
[[nodiscard]] inline Sign in_circle_infinite_perturbed(const Site& a, const Site& b, const Site& q,
                                                       const std::array<Index, 3>& ranks) noexcept {
    SIGNUM_EXPECTS(are_finite(a, b, q));
    return Perturbed::in_circle_infinite(a, b, q, ranks).sign;
}
}
SIGNUM_IEEE_END

// ---- predicates/ladder/forms.hpp -----------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::rectangular {
struct Supremum {
    static constexpr double x[4] = {1, 0, -1, 0};
    static constexpr double y[4] = {0, 1, 0, -1};
};
struct Manhattan {
    static constexpr double x[4] = {1, -1, -1, 1};
    static constexpr double y[4] = {1, 1, -1, -1};
};
struct Addend {
    const Site* site;
    Index rank;
    int side;
    int factor;
};
template <class Directions, Arithmetic arithmetic>
[[nodiscard, gnu::cold]] Decision decide_forms(const Addend* first, std::size_t count) noexcept;
template <class Directions, Arithmetic arithmetic>
[[nodiscard, gnu::cold]] Decision compare_distances(const Point& p, const Site& a,
                                                    const Site& b) noexcept;
[[nodiscard]] Sign sign_of_infinitesimals(const Addend* first, std::size_t count) noexcept;
template <class Directions, class Number>
[[nodiscard]] constexpr Number rounded_form(const Site& m, int side) noexcept {
    return (Number(Directions::x[side] * m.x) + Number(Directions::y[side] * m.y)) - Number(m.r);
}
template <class Number>
[[nodiscard]] constexpr Number difference_of_widths(const Number& a, const Number& b,
                                                    const Number& c, const Number& d) noexcept {
    return (a + c) - (b + d);
}
template <class Number>
[[nodiscard]] constexpr Number with_term(const Number& sum, int factor,
                                         const Number& form) noexcept {
    return sum + Number(factor) * form;
}
namespace count {
using filters::RoundingCount;
constexpr RoundingCount form = rounded_form<Manhattan, RoundingCount>(Site{}, 0);
constexpr RoundingCount sum_of_eight() noexcept {
    RoundingCount sum;
    for (int t = 0; t < 8; ++t) sum = with_term(sum, 1, form);
    return sum;
}
}
template <class Directions, Arithmetic arithmetic>
[[nodiscard]] inline Decision decide_behind(const predicates::NumberOf<arithmetic>& value,
                                            [[maybe_unused]] bool exact, const Addend* first,
                                            std::size_t count) noexcept {
    if constexpr (!is_exact(arithmetic)) {
        return {sign_of(value), Stage::filter};
    } else {
        if constexpr (arithmetic == Arithmetic::exact)
            if (exact) return {sign_of(value), Stage::filter};
        return decide_forms<Directions, arithmetic>(first, count);
    }
}
inline constexpr double error_of_four = 20 * filters::epsilon;
inline constexpr int eight_by_four = 5;
template <class Directions, Arithmetic arithmetic, std::size_t n>
class Forms {
    using Number = predicates::NumberOf<arithmetic>;
 public:
    Forms(const std::array<const Site*, n>& sites, const std::array<Index, n>& ranks) noexcept
        : sites_(sites), ranks_(ranks) {
        double magnitude = 0.0;
        for (std::size_t m = 0; m < n; ++m) {
            const Site site = filters::pinned(*sites[m]);
            for (int d = 0; d < 4; ++d) forms_[m][d] = rounded_form<Directions, Number>(site, d);
            const double size = (filters::magnitude(site.x) + filters::magnitude(site.y)) +
                                filters::magnitude(site.r);
            magnitude = magnitude < size ? size : magnitude;
        }
        bound_ = bound(magnitude);
    }
    [[nodiscard]] Sign compare(int side, std::size_t a, std::size_t b) noexcept {
        const Number difference = forms_[a][side] - forms_[b][side];
        if (filters::exceeds(difference, bound_))
            return filters::sign_of_nonzero(difference);
        return resolve(difference, {addend(side, a, 1), addend(side, b, -1)});
    }
    [[nodiscard]] Sign compare_widths(int s, std::size_t a, std::size_t b, std::size_t c,
                                      std::size_t d) noexcept {
        const int sides[4] = {s, (s + 1) & 3, (s + 2) & 3, (s + 3) & 3};
        const Number difference = difference_of_widths(forms_[a][sides[0]], forms_[b][sides[1]],
                                                       forms_[c][sides[2]], forms_[d][sides[3]]);
        if (filters::exceeds(difference, bound_))
            return filters::sign_of_nonzero(difference);
        return resolve(difference, {addend(sides[0], a, 1), addend(sides[1], b, -1),
                                    addend(sides[2], c, 1), addend(sides[3], d, -1)});
    }
    struct Term {
        int side;
        std::size_t site;
        int factor;
    };
    template <std::size_t count>
    [[nodiscard]] Sign compare_sum(const std::array<Term, count>& terms) noexcept {
        static_assert(count <= 8);
        Number sum(0.0);
        Addend addends[count];
        for (std::size_t t = 0; t < count; ++t) {
            const Term& term = terms[t];
            sum = with_term(sum, term.factor, forms_[term.site][term.side]);
            addends[t] = addend(term.side, term.site, term.factor);
        }
        if (filters::exceeds(sum, eight_by_four * bound_)) return filters::sign_of_nonzero(sum);
        return resolve(sum, addends);
    }
    [[nodiscard]] Decision decide(Sign sign) const noexcept { return {sign, stage_, tied_}; }
    void forget_ties() noexcept { tied_ = false; }
    void leave_ties() noexcept { perturbed_ = false; }
 private:
    [[nodiscard]] static double bound(double magnitude) noexcept {
        constexpr double everything = __builtin_huge_val();
        if constexpr (!is_exact(arithmetic) || arithmetic == Arithmetic::interval) return 0.0;
        if constexpr (arithmetic == Arithmetic::sum || arithmetic == Arithmetic::multiprecision)
            return everything;
        return magnitude < 0x1p1000 && filters::environment_is_default() ? error_of_four * magnitude
                                                                         : everything;
    }
    [[nodiscard]] Addend addend(int side, std::size_t m, int factor) const noexcept {
        return {sites_[m], ranks_[m], side, factor};
    }
    template <std::size_t count>
    [[nodiscard, gnu::cold, gnu::noinline]] Sign resolve(const Number& rounded,
                                                         const Addend (&addends)[count]) noexcept {
        const Decision decision =
            decide_behind<Directions, arithmetic>(rounded, false, addends, count);
        if (stage_ < decision.stage) stage_ = decision.stage;
        if (decision.sign != 0) return decision.sign;
        tied_ = true;
        return perturbed_ ? sign_of_infinitesimals(addends, count) : 0;
    }
    std::array<const Site*, n> sites_;
    std::array<Index, n> ranks_;
    Number forms_[n][4];
    double bound_;
    Stage stage_ = Stage::filter;
    bool tied_ = false;
    bool perturbed_ = true;
};
}
SIGNUM_IEEE_END

// ---- predicates/ladder/forms.cpp -----------------------------------------------------------------

namespace rooms::rectangular {
namespace {
constexpr std::size_t most_addends = 8;
struct Terms {
    std::array<double, 3 * most_addends> values;
    std::size_t count;
};
struct Operand {
    Site site;
    int side;
    int factor;
};
struct Operands {
    std::array<Operand, most_addends> addends;
    std::size_t count;
};
template <class Directions>
void add(Terms& terms, const Site& site, int side, int factor) noexcept {
    const double times = factor;
    if (Directions::x[side] != 0)
        terms.values[terms.count++] = times * Directions::x[side] * site.x;
    if (Directions::y[side] != 0)
        terms.values[terms.count++] = times * Directions::y[side] * site.y;
    terms.values[terms.count++] = -times * site.r;
}
template <Arithmetic arithmetic>
Decision decide_terms(const Terms& terms) noexcept {
    const auto by_essa = [&]() -> Decision {
        return {sign_of_sum({terms.values.data(), terms.count}), Stage::essa};
    };
    if constexpr (arithmetic != Arithmetic::exact) return by_essa();
    double sum = 0.0;
    bool rounded = false;
    for (std::size_t i = 0; i < terms.count; ++i) {
        const double next = sum + terms.values[i];
        const double shared = next - sum;
        rounded |= !((sum - (next - shared)) + (terms.values[i] - shared) == 0.0);
        sum = next;
    }
    return rounded ? by_essa() : Decision{sign_of(sum), Stage::exact};
}
template <class Directions, Arithmetic arithmetic>
Sign sign_of_exact_numbers(const Addend* first, std::size_t count) noexcept {
    predicates::ExactNumber<arithmetic> sum;
    for (const Addend* addend = first; addend != first + count; ++addend) {
        const auto add = [&](int factor, double value) {
            if (factor != 0) sum += factor * predicates::exactly<arithmetic>(value);
        };
        add(addend->factor * static_cast<int>(Directions::x[addend->side]), addend->site->x);
        add(addend->factor * static_cast<int>(Directions::y[addend->side]), addend->site->y);
        add(-addend->factor, addend->site->r);
    }
    return sum.sign();
}
}
template <class Directions, Arithmetic arithmetic>
Decision decide_forms(const Addend* first, std::size_t count) noexcept {
    SIGNUM_EXPECTS(count <= most_addends);
    if constexpr (arithmetic == Arithmetic::multiprecision || arithmetic == Arithmetic::judging)
        return {sign_of_exact_numbers<Directions, arithmetic>(first, count), Stage::multiprecision};
    if (filters::environment_is_default()) {
        Terms terms;
        terms.count = 0;
        for (std::size_t i = 0; i < count; ++i)
            add<Directions>(terms, *first[i].site, first[i].side, first[i].factor);
        return decide_terms<arithmetic>(terms);
    }
    Operands operands;
    operands.count = count;
    for (std::size_t i = 0; i < count; ++i)
        operands.addends[i] = {*first[i].site, first[i].side, first[i].factor};
    return exact::in_ieee_environment(
        [](const Operands& given) {
            Terms terms;
            terms.count = 0;
            for (std::size_t i = 0; i < given.count; ++i)
                add<Directions>(terms, given.addends[i].site, given.addends[i].side,
                                given.addends[i].factor);
            return decide_terms<arithmetic>(terms);
        },
        operands);
}
template <class Directions, Arithmetic arithmetic>
Decision compare_distances(const Point& p, const Site& a, const Site& b) noexcept {
    const Site point{p.x, p.y, 0.0};
    Stage stage = Stage::exact;
    const auto compare = [&](const Site& m, int s, const Site& other, int t) {
        const Addend addends[4] = {
            {&m, 0, s, 1}, {&point, 0, s, -1}, {&other, 0, t, -1}, {&point, 0, t, 1}};
        const Decision decision = decide_forms<Directions, arithmetic>(addends, 4);
        stage = std::max(stage, decision.stage);
        return decision.sign;
    };
    const auto farthest = [&](const Site& m) {
        int side = 0;
        for (int other = 1; other < 4; ++other)
            if (compare(m, other, m, side) > 0) side = other;
        return side;
    };
    const int farthest_of_b = farthest(b);
    const Sign sign = compare(b, farthest_of_b, a, farthest(a));
    return {sign, stage};
}
Sign sign_of_infinitesimals(const Addend* first, std::size_t count) noexcept {
    Index below = std::numeric_limits<Index>::max();
    for (;;) {
        Index last = std::numeric_limits<Index>::min();
        for (std::size_t i = 0; i < count; ++i)
            if (first[i].rank < below) last = std::max(last, first[i].rank);
        if (last == std::numeric_limits<Index>::min()) return 0;
        int factor = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (first[i].rank == last) factor += first[i].factor;
        if (factor != 0) return factor > 0 ? 1 : -1;
        below = last;
    }
}
}

// ---- predicates/rectangular/squares.hpp ----------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::rectangular {
struct Touching {
    int open;
    std::array<std::size_t, 4> site;
};
template <class AnyForms>
[[nodiscard]] inline Touching touching(AnyForms& forms,
                                       const std::array<std::size_t, 3>& corners = {0, 1,
                                                                                    2}) noexcept {
    Touching result{-1, {}};
    std::array<std::size_t, 4> touches{};
    for (int side = 0; side < 4; ++side) {
        std::size_t most = forms.compare(side, corners[1], corners[0]) > 0 ? 1 : 0;
        if (forms.compare(side, corners[2], corners[most]) > 0) most = 2;
        touches[static_cast<std::size_t>(side)] = most;
        result.site[static_cast<std::size_t>(side)] = corners[most];
    }
    const auto fits = [&](std::size_t open) {
        const std::size_t first = touches[(open + 1) & 3];
        return touches[(open + 2) & 3] == (first + 1) % 3 &&
               touches[(open + 3) & 3] == (first + 2) % 3;
    };
    if (!fits(0) && !fits(1) && !fits(2) && !fits(3)) return result;
    const auto& at = result.site;
    const bool wide = forms.compare_widths(0, at[0], at[1], at[2], at[3]) > 0;
    for (int open = wide ? 1 : 0; open < 4; open += 2)
        if (fits(static_cast<std::size_t>(open))) result.open = open;
    return result;
}
template <class AnyForms>
[[nodiscard]] inline Sign meets(AnyForms& forms, const Touching& square) noexcept {
    constexpr std::size_t q = 3;
    Sign least = 1;
    for (int turn = 1; turn < 4; ++turn) {
        const int side = (square.open + turn) & 3;
        const Sign sign = forms.compare(side, square.site[static_cast<std::size_t>(side)], q);
        if (sign < 0) return sign;
        least = least < sign ? least : sign;
    }
    const auto at = [&](int turn) {
        return square.site[static_cast<std::size_t>((square.open + turn) & 3)];
    };
    const Sign sign = forms.compare_widths((square.open + 1) & 3, at(1), at(2), at(3), q);
    return least < sign ? least : sign;
}
template <class AnyForms>
[[nodiscard]] inline Sign compare_centres(AnyForms& forms, const Touching& a, const Touching& b,
                                          int side) noexcept {
    std::array<typename AnyForms::Term, 8> terms{};
    std::size_t count = 0;
    for (const int factor : {1, -1}) {
        const Touching* const square = factor > 0 ? &a : &b;
        const auto add = [&](int at, int times) {
            terms[count++] = {at & 3, square->site[static_cast<std::size_t>(at & 3)], times};
        };
        const bool ahead = square->open == side;
        if (ahead || square->open == ((side + 2) & 3)) {
            const int sign = ahead ? factor : -factor;
            add(side + 1, sign);
            add(side + 3, sign);
            add(ahead ? side + 2 : side, -sign);
            add(ahead ? side + 2 : side, -sign);
        } else {
            add(side, factor);
            add(side + 2, -factor);
            terms[count++] = {0, 0, 0};
            terms[count++] = {0, 0, 0};
        }
    }
    return forms.compare_sum(terms);
}
struct Quadrant {
    int side;
    std::size_t a;
    std::size_t b;
};
template <class AnyForms>
[[nodiscard]] inline Quadrant quadrant(AnyForms& forms, std::size_t a, std::size_t b) noexcept {
    for (int side = 0; side < 4; ++side)
        if (forms.compare(side, b, a) > 0 && forms.compare((side + 1) & 3, a, b) > 0)
            return {(side + 2) & 3, a, b};
    return {-1, a, b};
}
template <class AnyForms>
[[nodiscard]] inline bool stands_before(AnyForms& forms, const Quadrant& x,
                                        const Quadrant& y) noexcept {
    if (x.side != y.side) return x.side < y.side;
    const int opposite = (x.side + 2) & 3;
    const int next = (x.side + 3) & 3;
    return forms.compare_sum(std::array<typename AnyForms::Term, 4>{
               {{next, x.a, 1}, {opposite, x.b, -1}, {next, y.a, -1}, {opposite, y.b, 1}}}) > 0;
}
template <class Directions, class Number>
[[nodiscard]] constexpr Number distance_to_centre(const Point& p, const Site& m) noexcept {
    using filters::magnitude;
    using filters::max;
    const Number x = Number(m.x) - Number(p.x);
    const Number y = Number(m.y) - Number(p.y);
    const auto along = [&](int side) {
        return magnitude(Number(Directions::x[side]) * x + Number(Directions::y[side]) * y);
    };
    return max(along(0), along(1));
}
template <class Directions, Arithmetic arithmetic = Arithmetic::exact>
struct Perturbed {
    static constexpr Arithmetic arithmetic_used = arithmetic;
    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const std::array<Index, 2>& ranks) noexcept {
        Forms<Directions, arithmetic, 2> forms({&i, &q}, ranks);
        for (int side = 0; side < 4; ++side)
            if (forms.compare(side, 1, 0) < 0) return forms.decide(-1);
        return forms.decide(1);
    }
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&i, &j, &k}, ranks);
        return forms.decide(touching(forms).open >= 0 ? 1 : -1);
    }
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&i, &j, &k, &q}, ranks);
        const Touching square = touching(forms);
        SIGNUM_EXPECTS(!is_exact(arithmetic) || square.open >= 0);
        forms.forget_ties();
        return forms.decide(square.open < 0 ? -1 : meets(forms, square));
    }
    [[nodiscard]] static Decision in_circle_of_visible(const Site& i, const Site& j, const Site& k,
                                                       const Site& q,
                                                       const std::array<Index, 4>& ranks) noexcept {
        return in_circle(i, j, k, q, ranks);
    }
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&a, &b, &q}, ranks);
        const int side = quadrant(forms, 0, 1).side;
        SIGNUM_EXPECTS(!is_exact(arithmetic) || side >= 0);
        if (side < 0) return forms.decide(-1);
        forms.forget_ties();
        const bool conflict =
            forms.compare((side + 2) & 3, 1, 2) > 0 && forms.compare((side + 3) & 3, 0, 2) > 0;
        return forms.decide(conflict ? 1 : -1);
    }
    [[nodiscard]] static Decision exists_twice(const Site& i, const Site& j, const Site& k,
                                               const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&i, &j, &k}, ranks);
        const bool both = touching(forms).open >= 0 && touching(forms, {1, 0, 2}).open >= 0;
        return forms.decide(both ? 1 : -1);
    }
    [[nodiscard]] static Decision precedes_on_bisector(const Site& i, const Site& j, const Site& q,
                                                       const Site& k,
                                                       const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&i, &j, &q, &k}, ranks);
        const Touching of_q = touching(forms, {1, 0, 2});
        const Touching of_k = touching(forms, {1, 0, 3});
        SIGNUM_EXPECTS(!is_exact(arithmetic) || (of_q.open >= 0 && of_k.open >= 0));
        if (of_q.open < 0 || of_k.open < 0) return forms.decide(-1);
        using Term = typename Forms<Directions, arithmetic, 4>::Term;
        const auto along = [](int side, int factor) {
            return std::array<Term, 4>{{{side, 1, factor},
                                        {side, 0, -factor},
                                        {side + 2, 1, -factor},
                                        {side + 2, 0, factor}}};
        };
        const Sign right = forms.compare_sum(along(0, 1));
        const Sign top = forms.compare_sum(along(1, 1));
        const auto width = along(0, right);
        const auto height = along(1, -top);
        const Sign wide = forms.compare_sum(std::array<Term, 8>{
            width[0], width[1], width[2], width[3], height[0], height[1], height[2], height[3]});
        const int side = wide >= 0 ? (right >= 0 ? 1 : 3) : (top >= 0 ? 2 : 0);
        return forms.decide(compare_centres(forms, of_q, of_k, side) < 0 ? 1 : -1);
    }
    [[nodiscard]] static Decision in_order_at_infinity(const Site& s, const Site& k, const Site& q,
                                                       const Site& l, bool /*rest*/,
                                                       const std::array<Index, 4>& ranks) noexcept {
        Forms<Directions, arithmetic, 4> forms({&s, &k, &q, &l}, ranks);
        const Quadrant first = quadrant(forms, 1, 0);
        const Quadrant second = quadrant(forms, 0, 2);
        const Quadrant third = quadrant(forms, 0, 3);
        const int falls = static_cast<int>(!stands_before(forms, first, second)) +
                          static_cast<int>(!stands_before(forms, second, third)) +
                          static_cast<int>(!stands_before(forms, third, first));
        return forms.decide(falls == 1 ? 1 : -1);
    }
    [[nodiscard]] static Decision holds_first_direction(
        const Site& k, const Site& s, const Site& l, const std::array<Index, 3>& ranks) noexcept {
        Forms<Directions, arithmetic, 3> forms({&k, &s, &l}, ranks);
        const Quadrant first = quadrant(forms, 0, 1);
        const Quadrant last = quadrant(forms, 1, 2);
        return forms.decide(stands_before(forms, last, first) ? 1 : -1);
    }
    [[nodiscard]] static additive::Distance distance(const Point& p, const Site& m) noexcept {
        const Site site = filters::pinned(m);
        const Point point = filters::pinned(p);
        const double size =
            filters::magnitude(site.x - point.x) + filters::magnitude(site.y - point.y);
        return {distance_to_centre<Directions, double>(point, site), size, site.r};
    }
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const std::array<Index, 2>& ranks) noexcept {
        if constexpr (predicates::is_filtered(arithmetic)) {
            const filters::Verdict verdict = additive::nearer(distance(p, a), distance(p, b));
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        } else if constexpr (!is_exact(arithmetic) || arithmetic == Arithmetic::interval) {
            const auto difference = rounded_distance(p, b) - rounded_distance(p, a);
            if (filters::exceeds(difference, 0.0))
                return {filters::sign_of_nonzero(difference), Stage::filter};
        }
        Decision decision{0, Stage::filter};
        if constexpr (is_exact(arithmetic))
            decision = compare_distances<Directions, arithmetic>(p, a, b);
        if (decision.sign != 0) return decision;
        return {ranks[0] < ranks[1] ? 1 : -1, decision.stage, true};
    }
 private:
    using Number = predicates::NumberOf<arithmetic>;
    [[nodiscard]] static Number rounded_distance(const Point& p, const Site& m) noexcept {
        return distance_to_centre<Directions, Number>(p, m) - Number(m.r);
    }
};
template <class Directions>
[[nodiscard]] inline Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                                 const Site& q,
                                                 const std::array<Index, 4>& ranks) noexcept {
    Forms<Directions, Arithmetic::exact, 4> forms({&i, &j, &k, &q}, ranks);
    const Touching square = touching(forms);
    SIGNUM_EXPECTS(square.open >= 0);
    forms.leave_ties();
    return forms.decide(meets(forms, square));
}
template <class Directions>
[[nodiscard]] inline Decision in_circle_infinite_decision(
    const Site& a, const Site& b, const Site& q, const std::array<Index, 3>& ranks) noexcept {
    Forms<Directions, Arithmetic::exact, 3> forms({&a, &b, &q}, ranks);
    const int side = quadrant(forms, 0, 1).side;
    SIGNUM_EXPECTS(side >= 0);
    forms.leave_ties();
    const Sign first = forms.compare((side + 2) & 3, 1, 2);
    const Sign second = forms.compare((side + 3) & 3, 0, 2);
    return forms.decide(first < second ? first : second);
}
}
SIGNUM_IEEE_END

// ---- predicates/manhattan.hpp --------------------------------------------------------------------

namespace rooms::manhattan {
template <Arithmetic arithmetic = Arithmetic::exact>
using Perturbed = rectangular::Perturbed<rectangular::Manhattan, arithmetic>;
inline constexpr auto& exists = additive::exists<Perturbed<>>;
inline constexpr auto& in_circle =
    additive::in_circle<rectangular::in_circle_decision<rectangular::Manhattan>>;
inline constexpr auto& in_circle_infinite =
    additive::in_circle_infinite<rectangular::in_circle_infinite_decision<rectangular::Manhattan>>;
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return additive::hidden<Perturbed<>>(q, i);
}
inline constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
inline constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
inline constexpr auto& in_circle_infinite_perturbed =
    additive::in_circle_infinite_perturbed<Perturbed<>>;
}

// ---- predicates/supremum.hpp ---------------------------------------------------------------------

namespace rooms::supremum {
template <Arithmetic arithmetic = Arithmetic::exact>
using Perturbed = rectangular::Perturbed<rectangular::Supremum, arithmetic>;
inline constexpr auto& exists = additive::exists<Perturbed<>>;
inline constexpr auto& in_circle =
    additive::in_circle<rectangular::in_circle_decision<rectangular::Supremum>>;
inline constexpr auto& in_circle_infinite =
    additive::in_circle_infinite<rectangular::in_circle_infinite_decision<rectangular::Supremum>>;
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return additive::hidden<Perturbed<>>(q, i);
}
inline constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
inline constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
inline constexpr auto& in_circle_infinite_perturbed =
    additive::in_circle_infinite_perturbed<Perturbed<>>;
}

// ---- predicates/formulas/apollonius.hpp ----------------------------------------------------------

namespace rooms::euclidean {
template <class Number>
struct Uniform {
    using Linear = Number;
    using Quadratic = Number;
    using Quartic = Number;
    using Octic = Number;
};
template <class Degrees>
struct Disc {
    typename Degrees::Linear x;
    typename Degrees::Linear y;
    typename Degrees::Linear r;
};
namespace polynomials {
template <class Wide, class Number>
[[nodiscard]] decltype(auto) as(const Number& number) {
    if constexpr (std::is_same_v<Wide, Number>) {
        return (number);
    } else {
        return Wide(number);
    }
}
template <class Number>
[[nodiscard]] Sign sign(const Number& number) {
    if constexpr (words::has_sign<decltype(number)>) {
        return number.sign();
    } else {
        return static_cast<int>(number > 0) - static_cast<int>(number < 0);
    }
}
template <class Wide, class A, class B>
[[nodiscard]] Wide product(const A& a, const B& b) {
    return as<Wide>(a) * as<Wide>(b);
}
template <class Wide, class A, class B, class C, class D>
[[nodiscard]] Wide minor(const A& a, const B& b, const C& c, const D& d) {
    return product<Wide>(a, d) - product<Wide>(b, c);
}
template <class Resultant>
[[nodiscard]] Sign sign_of_difference(Sign u, Sign v, Resultant resultant) {
    if (v == 0 || u == -v) return u;
    if (u == 0) return -v;
    return u * resultant();
}
template <class Wide, class Number>
[[nodiscard]] Wide casey(const Number& a, const Number& b, const Number& c) {
    const Number rest = a - b - c;
    return product<Wide>(rest, rest) - 4 * product<Wide>(b, c);
}
template <class D>
[[nodiscard]] typename D::Quadratic power(const Disc<D>& a, const Disc<D>& b) {
    const typename D::Quadratic x = a.x - b.x;
    const typename D::Quadratic y = a.y - b.y;
    const typename D::Quadratic r = a.r - b.r;
    return x * x + y * y - r * r;
}
template <class D>
struct Row {
    typename D::Linear x;
    typename D::Linear y;
    typename D::Linear r;
    typename D::Quadratic p;
    Row(const typename D::Linear& dx, const typename D::Linear& dy, const typename D::Linear& dr)
        : x(dx), y(dy), r(dr), p(dx * dx + dy * dy - dr * dr) {}
};
template <class D>
[[nodiscard]] Row<D> row(const Disc<D>& m, const Disc<D>& i) {
    return {m.x - i.x, m.y - i.y, m.r - i.r};
}
template <class D>
struct Minors {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;
    Row<D> j;
    Row<D> k;
    Quadratic xy;
    Quadratic xr;
    Quadratic yr;
    Quartic q;
    Minors(const Row<D>& row_j, const Row<D>& row_k)
        : j(row_j),
          k(row_k),
          xy(minor<Quadratic>(j.x, j.y, k.x, k.y)),
          xr(minor<Quadratic>(j.x, j.r, k.x, k.r)),
          yr(minor<Quadratic>(j.y, j.r, k.y, k.r)),
          q(product<Quartic>(xr, xr) + product<Quartic>(yr, yr) - product<Quartic>(xy, xy)) {}
    [[nodiscard]] Quartic xp() const { return minor<Quartic>(j.x, j.p, k.x, k.p); }
    [[nodiscard]] Quartic yp() const { return minor<Quartic>(j.y, j.p, k.y, k.p); }
    [[nodiscard]] Quartic rp() const { return minor<Quartic>(j.r, j.p, k.r, k.p); }
    [[nodiscard]] Octic twice_ab() const {
        return product<Octic>(xp(), xr) + product<Octic>(yp(), yr);
    }
    [[nodiscard]] Quartic l(const Row<D>& m) const {
        return product<Quartic>(m.x, yr) - product<Quartic>(m.y, xr) + product<Quartic>(m.r, xy);
    }
    [[nodiscard]] Quartic xyp(const Row<D>& m) const {
        return product<Quartic>(m.x, yp()) - product<Quartic>(m.y, xp()) +
               product<Quartic>(m.p, xy);
    }
    [[nodiscard]] Octic a(const Row<D>& m) const {
        const Quartic of_x = xp();
        const Quartic of_y = yp();
        const Quartic of_r = rp();
        const Quartic xyp =
            product<Quartic>(m.x, of_y) - product<Quartic>(m.y, of_x) + product<Quartic>(m.p, xy);
        const Quartic xrp =
            product<Quartic>(m.x, of_r) - product<Quartic>(m.r, of_x) + product<Quartic>(m.p, xr);
        const Quartic yrp =
            product<Quartic>(m.y, of_r) - product<Quartic>(m.r, of_y) + product<Quartic>(m.p, yr);
        return product<Octic>(xy, xyp) - product<Octic>(xr, xrp) - product<Octic>(yr, yrp);
    }
};
template <class D>
struct Triple : Minors<D> {
    typename D::Quadratic jk;
    Triple(const Disc<D>& i, const Disc<D>& site_j, const Disc<D>& site_k)
        : Minors<D>(row(site_j, i), row(site_k, i)), jk(power(site_j, site_k)) {}
    [[nodiscard]] bool apart() const { return this->j.p > 0 && this->k.p > 0 && jk > 0; }
    [[nodiscard]] bool touch() const { return this->j.p >= 0 && this->k.p >= 0 && jk >= 0; }
};
template <class D>
struct Powers {
    typename D::Quadratic ij, ik, jk, iq, jq, kq;
    Powers(const Triple<D>& t, const std::array<Disc<D>, 4>& d)
        : ij(t.j.p),
          ik(t.k.p),
          jk(t.jk),
          iq(power(d[0], d[3])),
          jq(power(d[1], d[3])),
          kq(power(d[2], d[3])) {}
    [[nodiscard]] Sign sign_of_h() const {
        using Quartic = typename D::Quartic;
        return sign(casey<typename D::Octic>(product<Quartic>(ij, kq), product<Quartic>(ik, jq),
                                             product<Quartic>(iq, jk)));
    }
};
}
}

// ---- predicates/formulas/discs.hpp ---------------------------------------------------------------

namespace rooms::euclidean::polynomials {
struct Answer {
    Sign sign;
    bool tied = false;
};
template <class D>
[[nodiscard]] Answer hides_one(const Disc<D>& i, const Disc<D>& q, bool i_precedes_q) {
    if (q.r > i.r) return {-1};
    const auto p = power(i, q);
    if (!(p <= 0)) return {-1};
    if (q.r == i.r) return {i_precedes_q ? 1 : -1, true};
    return {1, p == 0};
}
template <class D>
[[nodiscard]] Answer hides(const std::array<Disc<D>, 2>& d, const std::array<Index, 2>& ranks) {
    return hides_one(d[0], d[1], ranks[0] < ranks[1]);
}
template <class D>
[[nodiscard]] Sign compare_distances(const std::array<Disc<D>, 3>& discs) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    const auto square = [&](const Disc<D>& s) {
        const Quadratic x = s.x - discs[0].x;
        const Quadratic y = s.y - discs[0].y;
        return Quadratic(x * x + y * y);
    };
    const Quadratic u = square(discs[2]);
    const Quadratic v = square(discs[1]);
    const Quadratic d = discs[1].r - discs[2].r;
    const Sign of_radii = sign(d);
    const Sign of_centres = sign(Quadratic(u - v));
    if (of_radii == 0 || of_centres != -of_radii) return of_centres != 0 ? of_centres : of_radii;
    const Quadratic& near = of_radii > 0 ? u : v;
    const Quadratic& far = of_radii > 0 ? v : u;
    const Quadratic square_d = d * d;
    const Quadratic rest = near + square_d - far;
    const Sign of_rest = sign(rest);
    if (of_rest >= 0) return near == 0 ? of_radii * of_rest : of_radii;
    return of_radii *
           sign(Quartic(4 * product<Quartic>(square_d, near) - product<Quartic>(rest, rest)));
}
template <class D>
[[nodiscard]] Answer nearer(const std::array<Disc<D>, 3>& d, const std::array<Index, 2>& ranks) {
    const Sign sign = compare_distances(d);
    if (sign != 0) return {sign};
    return {ranks[0] < ranks[1] ? 1 : -1, true};
}
template <class D>
[[nodiscard]] bool has_finite_circle(const Triple<D>& t) {
    const Sign of_q = sign(t.q);
    if (of_q < 0) return t.xy > 0;
    if (of_q > 0) return sign(t.twice_ab()) > 0;
    return t.xy > 0 && sign(t.twice_ab()) > 0;
}
template <std::size_t n>
[[nodiscard]] std::size_t last_of(const std::array<Index, n>& ranks, std::size_t count) {
    return static_cast<std::size_t>(
        std::max_element(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(count)) -
        ranks.begin());
}
template <class D>
[[nodiscard]] bool last_lies_between(const Triple<D>& t, const std::array<Index, 3>& ranks) {
    const std::array<const typename D::Quadratic*, 3> opposite = {&t.jk, &t.k.p, &t.j.p};
    const std::size_t m = last_of(ranks, 3);
    const auto& others = *opposite[m];
    return others > *opposite[(m + 1) % 3] && others > *opposite[(m + 2) % 3];
}
template <class D>
[[nodiscard]] Answer exists(const std::array<Disc<D>, 3>& d, const std::array<Index, 3>& ranks) {
    const Triple<D> t(d[0], d[1], d[2]);
    if (!t.apart()) return {-1, t.touch()};
    if (t.q != 0) return {has_finite_circle(t) ? 1 : -1};
    const bool at_infinity = sign(t.xy) * sign(t.twice_ab()) < 0 && last_lies_between(t, ranks);
    return {has_finite_circle(t) || at_infinity ? 1 : -1, true};
}
template <class D>
[[nodiscard]] Answer exists_twice(const std::array<Disc<D>, 3>& d,
                                  const std::array<Index, 3>& ranks) {
    const Triple<D> t(d[0], d[1], d[2]);
    if (t.q < 0) return {-1};
    if (!t.apart()) return {-1, t.touch()};
    const bool above = sign(t.twice_ab()) > 0;
    if (t.q != 0) return {above ? 1 : -1};
    return {above && last_lies_between(t, ranks) ? 1 : -1, true};
}
template <class D>
[[nodiscard]] Answer precedes_on_bisector(const std::array<Disc<D>, 4>& d) {
    using Quartic = typename D::Quartic;
    using Octic = typename D::Octic;
    const Triple<D> q(d[0], d[1], d[2]);
    const Triple<D> k(d[0], d[1], d[3]);
    const auto middle = [](const Triple<D>& t) -> Quartic {
        return product<Quartic>(t.xy, Quartic(as<Quartic>(t.j.p) - t.k.p - t.jk));
    };
    const Quartic of_q = middle(q);
    const Quartic of_k = middle(k);
    const bool tied = q.q == 0 || k.q == 0;
    if (q.q == 0 && k.q == 0) return {sign(of_k) > sign(of_q) ? 1 : -1, tied};
    const bool rises = product<Octic>(of_k, q.q) > product<Octic>(of_q, k.q);
    return {rises ? 1 : -1, tied};
}
template <class D>
[[nodiscard]] Sign in_finite_circle(const Triple<D>& t, const Powers<D>& p, const Row<D>& q) {
    const Sign of_l = sign(t.l(q));
    const Sign of_q = sign(t.q);
    if (of_q == 0) return of_l != 0 ? p.sign_of_h() * of_l : -sign(t.xy) * sign(t.xyp(q));
    const Sign of_a = sign(t.a(q));
    return of_q * sign_of_difference(of_a, of_l, [&] { return of_q * p.sign_of_h(); });
}
template <class D>
[[nodiscard]] Sign in_circle_tie(const Powers<D>& p, const std::array<Index, 4>& ranks) {
    using Quartic = typename D::Quartic;
    const std::size_t m = last_of(ranks, 4);
    if (m == 3) return -1;
    const std::array<Quartic, 3> products = {
        product<Quartic>(p.iq, p.jk), product<Quartic>(p.jq, p.ik), product<Quartic>(p.kq, p.ij)};
    const Quartic& opposite = products[m];
    return opposite > products[(m + 1) % 3] && opposite > products[(m + 2) % 3] ? -1 : 1;
}
template <class D>
[[nodiscard]] Sign in_circle_infinite_touch(const std::array<Disc<D>, 3>& d) {
    using Quadratic = typename D::Quadratic;
    using Quartic = typename D::Quartic;
    const Row<D> u = row(d[1], d[0]);
    const Row<D> w = row(d[2], d[0]);
    const Quadratic square = product<Quadratic>(u.x, u.x) + product<Quadratic>(u.y, u.y);
    const Quadratic inner = product<Quadratic>(u.x, w.x) + product<Quadratic>(u.y, w.y);
    const Sign rational = sign(minor<Quartic>(w.r, u.r, inner, square));
    const Sign cross = sign(minor<Quadratic>(u.x, u.y, w.x, w.y));
    return sign_of_difference(rational, cross,
                              [&] { return sign(casey<Quartic>(u.p, w.p, power(d[1], d[2]))); });
}
template <class D>
[[nodiscard]] Sign in_circle_touch(const std::array<Disc<D>, 4>& d,
                                   const std::array<Index, 4>& ranks) {
    const Triple<D> t(d[0], d[1], d[2]);
    if (t.q == 0 && !has_finite_circle(t)) {
        const std::size_t m = last_of(ranks, 3);
        return in_circle_infinite_touch(std::array{d[(m + 1) % 3], d[(m + 2) % 3], d[3]});
    }
    return in_finite_circle(t, Powers<D>(t, d), row(d[3], d[0]));
}
template <class D>
[[nodiscard]] Answer in_circle(const std::array<Disc<D>, 4>& d, const std::array<Index, 4>& ranks) {
    for (std::size_t m = 0; m < 3; ++m) {
        const Answer hidden = hides_one(d[m], d[3], ranks[m] < ranks[3]);
        if (hidden.sign > 0) return {-1, hidden.tied};
    }
    const Sign sign = in_circle_touch(d, ranks);
    if (sign != 0) return {sign};
    const Triple<D> t(d[0], d[1], d[2]);
    return {in_circle_tie(Powers<D>(t, d), ranks), true};
}
template <class D>
[[nodiscard]] Answer in_circle_infinite(const std::array<Disc<D>, 3>& d,
                                        const std::array<Index, 3>& ranks) {
    const auto& [a, b, q] = d;
    const Sign sign = in_circle_infinite_touch(d);
    if (sign != 0) return {sign};
    if (hides_one(a, q, ranks[0] < ranks[2]).sign > 0 ||
        hides_one(b, q, ranks[1] < ranks[2]).sign > 0)
        return {-1, true};
    const std::size_t m = last_of(ranks, 3);
    if (m == 2) return {-1, true};
    const auto opposite = power(d[m], q);
    const bool between = opposite > power(a, b) && opposite > power(d[1 - m], q);
    return {between ? -1 : 1, true};
}
}

// ---- predicates/euclidean/filter.hpp -------------------------------------------------------------

SIGNUM_IEEE_BEGIN
namespace rooms::euclidean::filter {
using filters::epsilon;
using filters::magnitude;
using filters::Verdict;
template <class Number>
struct DifferenceOf {
    Number x;
    Number y;
    Number r;
    Number l;
    Number p;
    [[gnu::always_inline]] constexpr DifferenceOf(const Site& m, const Site& i) noexcept
        : x(Number(m.x) - Number(i.x)),
          y(Number(m.y) - Number(i.y)),
          r(Number(m.r) - Number(i.r)),
          l(magnitude(x) + magnitude(y) + magnitude(r)),
          p((x * x + y * y) - r * r) {}
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_power() const {
        return {p, 7 * epsilon * (l * l)};
    }
};
using Difference = DifferenceOf<double>;
using CountedDifference = DifferenceOf<filters::RoundingCount>;
inline constexpr CountedDifference counted_difference(Site{}, Site{});
template <class... Size>
[[nodiscard]] inline bool in_window(double first, Size... others) noexcept {
    double least = first;
    double greatest = first;
    ((least = others < least ? others : least), ...);
    ((greatest = others > greatest ? others : greatest), ...);
    return least >= 0x1p-110 && greatest <= 0x1p110;
}
[[nodiscard]] inline double square_root(double value) noexcept {
#if __has_builtin(__builtin_ia32_sqrtsd)
    return __builtin_ia32_sqrtsd(filters::Two{value, 0.0})[0];
#else
    return __builtin_sqrt(value);
#endif
}
[[nodiscard]] inline float square_root(float value) noexcept {
#if __has_builtin(__builtin_ia32_sqrtss)
    using Four = float __attribute__((vector_size(16)));
    return __builtin_ia32_sqrtss(Four{value, 0.0F, 0.0F, 0.0F})[0];
#else
    return __builtin_sqrtf(value);
#endif
}
[[nodiscard]] inline double root_of_positive(double value) noexcept {
    return square_root(value > 0.0 ? value : 0.0);
}
[[nodiscard]] inline Verdict sign(double value, double bound) noexcept {
    if (magnitude(value) > bound)
        return Verdict::certain(filters::sign_of_nonzero(value));
    return Verdict::uncertain();
}
[[nodiscard]] inline Verdict sign(const filters::Compared<double>& compared) noexcept {
    return sign(compared.value, compared.bound);
}
template <class Number>
struct TripleOf {
    DifferenceOf<Number> j;
    DifferenceOf<Number> k;
    DifferenceOf<Number> jk;
    Number xy;
    Number xr;
    Number yr;
    Number q;
    Number l_jk;
    [[gnu::always_inline]] constexpr TripleOf(const Site& i, const Site& site_j,
                                              const Site& site_k) noexcept
        : j(site_j, i),
          k(site_k, i),
          jk(site_k, site_j),
          xy(j.x * k.y - j.y * k.x),
          xr(j.x * k.r - j.r * k.x),
          yr(j.y * k.r - j.r * k.y),
          q((xr * xr + yr * yr) - xy * xy),
          l_jk(j.l * k.l) {}
    [[nodiscard]] bool in_window() const noexcept { return filter::in_window(j.l, k.l, jk.l); }
    [[nodiscard]] constexpr Number xp() const noexcept { return j.x * k.p - j.p * k.x; }
    [[nodiscard]] constexpr Number yp() const noexcept { return j.y * k.p - j.p * k.y; }
    [[nodiscard]] constexpr Number rp() const noexcept { return j.r * k.p - j.p * k.r; }
    [[nodiscard]] constexpr Number gamma() const noexcept { return j.p * k.p * jk.p; }
    [[nodiscard]] constexpr Number twice_ab() const noexcept { return xp() * xr + yp() * yr; }
    [[nodiscard]] constexpr Number middle() const noexcept { return xy * ((j.p - k.p) - jk.p); }
    [[nodiscard]] Verdict apart() const noexcept;
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_twice_ab()
        const {
        return {twice_ab(), 17 * epsilon * (l_jk * l_jk) * (j.l + k.l)};
    }
    [[nodiscard]] Verdict sign_of_twice_ab() const noexcept { return sign(compared_twice_ab()); }
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_q() const {
        return {q, 13 * epsilon * (l_jk * l_jk)};
    }
    [[nodiscard]] Verdict sign_of_q() const noexcept { return sign(compared_q()); }
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_q_anywhere()
        const {
        return {q, 13 * epsilon * (l_jk * l_jk) + (0x1p-1000 * l_jk + 0x1p-1000)};
    }
    [[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_xy() const {
        return {xy, 5 * epsilon * l_jk};
    }
};
using Triple = TripleOf<double>;
using CountedTriple = TripleOf<filters::RoundingCount>;
inline constexpr CountedTriple counted_triple(Site{}, Site{}, Site{});
[[nodiscard]] inline Verdict sign_of_power(const Difference& m) noexcept {
    return sign(m.compared_power());
}
template <class Number>
inline Verdict TripleOf<Number>::apart() const noexcept {
    Verdict result = Verdict::certain(1);
    for (const DifferenceOf<Number>* m : {&j, &k, &jk}) {
        const Verdict of_power = sign_of_power(*m);
        if (!of_power.is_certain())
            return of_power;
        if (of_power.sign() < 0) result = of_power;
    }
    return result;
}
[[nodiscard]] inline Verdict hides(const Difference& q) noexcept {
    if (q.r > 0.0) return Verdict::certain(-1);
    if (!in_window(q.l))
        return Verdict::uncertain();
    const Verdict of_power = sign_of_power(q);
    return of_power.is_certain() ? Verdict::certain(-of_power.sign()) : of_power;
}
[[nodiscard]] inline Verdict hides(const Site& m, const Site& q) noexcept {
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    return hides(Difference(filters::pinned(q), filters::pinned(m)));
}
[[nodiscard]] inline Verdict exists(const Site& i, const Site& j, const Site& k) noexcept {
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    const Triple t(filters::pinned(i), filters::pinned(j), filters::pinned(k));
    if (!t.in_window())
        return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain())
        return apart;
    if (apart.sign() < 0) return apart;
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain())
        return of_q;
    if (of_q.sign() < 0) return sign(t.compared_xy());
    return t.sign_of_twice_ab();
}
[[nodiscard]] inline Verdict exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    const Triple t(filters::pinned(i), filters::pinned(j), filters::pinned(k));
    const double bound = t.compared_q_anywhere().bound;
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    if (t.q < -bound)
        return Verdict::certain(-1);
    if (!(t.q > bound) || !t.in_window()) return Verdict::uncertain();
    const Verdict apart = t.apart();
    if (!apart.is_certain() || apart.sign() < 0) return apart;
    return t.sign_of_twice_ab();
}
template <class Number>
[[nodiscard]] constexpr Number order_of_middles(const TripleOf<Number>& q,
                                                const TripleOf<Number>& k) noexcept {
    return k.middle() * q.q - q.middle() * k.q;
}
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr filters::Compared<Number> compared_order_of_middles(
    const TripleOf<Number>& first, const TripleOf<Number>& second) noexcept {
    const auto size = [](const TripleOf<Number>& t) {
        return t.l_jk * (t.j.l * t.j.l + t.k.l * t.k.l + t.jk.l * t.jk.l);
    };
    return {order_of_middles(first, second), 29 * epsilon *
                                                 (size(second) * (first.l_jk * first.l_jk) +
                                                  size(first) * (second.l_jk * second.l_jk))};
}
[[nodiscard]] inline Verdict precedes_on_bisector(const Site& i, const Site& j, const Site& q,
                                                  const Site& k) noexcept {
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    const Site first_site = filters::pinned(i);
    const Site second_site = filters::pinned(j);
    const Triple first(first_site, second_site, filters::pinned(q));
    const Triple second(first_site, second_site, filters::pinned(k));
    if (!in_window(first.j.l, first.k.l, first.jk.l, second.k.l, second.jk.l))
        return Verdict::uncertain();
    const Verdict of_first = first.sign_of_q();
    const Verdict of_second = second.sign_of_q();
    if (!of_first.is_certain() || !of_second.is_certain())
        return Verdict::uncertain();
    return sign(compared_order_of_middles(first, second));
}
template <class Number>
struct ConflictOf {
    Number a;
    Number l;
    Number gamma;
    [[gnu::always_inline]] constexpr ConflictOf(const TripleOf<Number>& t,
                                                const DifferenceOf<Number>& c) noexcept
        : a((c.x * (t.xy * t.yp() - t.xr * t.rp()) - c.y * (t.xy * t.xp() + t.yr * t.rp())) +
            (c.r * t.twice_ab() - c.p * t.q)),
          l((c.x * t.yr - c.y * t.xr) + c.r * t.xy),
          gamma(t.gamma()) {}
    [[nodiscard, gnu::always_inline]] static constexpr Number size_of_a(
        const TripleOf<Number>& t, const DifferenceOf<Number>& c) noexcept {
        return c.l * (t.l_jk * t.l_jk) * (t.j.l + t.k.l + c.l);
    }
    [[nodiscard, gnu::always_inline]] static constexpr Number root_of_gamma_size(
        const TripleOf<Number>& t) noexcept {
        return t.l_jk * t.jk.l;
    }
};
using Conflict = ConflictOf<double>;
inline constexpr ConflictOf<filters::RoundingCount> counted_conflict(counted_triple,
                                                                     counted_difference);
inline constexpr int conflict_error_of_a = 34;
inline constexpr int conflict_error_of_root = 22;
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_conflict(const Number& m,
                                                                     const Number& l,
                                                                     const Number& g,
                                                                     const Number& root) noexcept {
    return epsilon *
           (conflict_error_of_a * m * root + conflict_error_of_root * magnitude(l) * g * g);
}
[[nodiscard, gnu::always_inline]] inline Verdict in_circle_of_visible(const Site& i, const Site& j,
                                                                      const Site& k,
                                                                      const Site& q) noexcept {
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    const Site origin = filters::pinned(i);
    const Triple t(origin, filters::pinned(j), filters::pinned(k));
    const Difference c(filters::pinned(q), origin);
    if (!in_window(t.j.l, t.k.l, t.jk.l, c.l))
        return Verdict::uncertain();
    const Conflict conflict(t, c);
    const double root = root_of_positive(conflict.gamma);
    const double difference = conflict.a - conflict.l * root;
    const double g = Conflict::root_of_gamma_size(t);
    const double m = Conflict::size_of_a(t, c);
    const double bound = bound_of_conflict(m, conflict.l, g, root);
    if (!(magnitude(difference) * root > bound))
        return Verdict::uncertain();
    const Verdict of_q = t.sign_of_q();
    if (!of_q.is_certain())
        return of_q;
    return Verdict::certain(of_q.sign() * filters::sign_of_nonzero(difference));
}
[[nodiscard]] inline Verdict in_circle(const Site& i, const Site& j, const Site& k,
                                       const Site& q) noexcept {
    const Verdict verdict = in_circle_of_visible(i, j, k, q);
    if (!verdict.is_certain() || verdict.sign() < 0) return verdict;
    for (const Site* m : {&i, &j, &k}) {
        const Verdict hidden = hides(*m, q);
        if (!hidden.is_certain())
            return hidden;
        if (hidden.sign() > 0) return Verdict::certain(-1);
    }
    return verdict;
}
template <class Number>
struct InfiniteConflictOf {
    Number t;
    Number cross;
    constexpr InfiniteConflictOf(const DifferenceOf<Number>& u,
                                 const DifferenceOf<Number>& w) noexcept
        : t(w.r * (u.x * u.x + u.y * u.y) - u.r * (u.x * w.x + u.y * w.y)),
          cross(u.x * w.y - u.y * w.x) {}
};
using InfiniteConflict = InfiniteConflictOf<double>;
inline constexpr InfiniteConflictOf<filters::RoundingCount> counted_infinite_conflict(
    counted_difference, counted_difference);
inline constexpr int infinite_error_of_t = 18;
inline constexpr int infinite_error_of_root = 10;
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number bound_of_infinite_conflict(
    const Number& l_u, const Number& l_w, const Number& cross, const Number& root) noexcept {
    const Number square = l_u * l_u;
    return epsilon * square *
           (infinite_error_of_t * l_w * root + infinite_error_of_root * magnitude(cross));
}
[[nodiscard]] inline Verdict in_circle_infinite(const Site& a, const Site& b,
                                                const Site& q) noexcept {
    if (!filters::environment_is_default())
        return Verdict::uncertain();
    const Site origin = filters::pinned(a);
    const Difference u(filters::pinned(b), origin);
    const Difference w(filters::pinned(q), origin);
    if (!in_window(u.l, w.l))
        return Verdict::uncertain();
    const InfiniteConflict conflict(u, w);
    const double root = root_of_positive(u.p);
    return sign((conflict.t - root * conflict.cross) * root,
                bound_of_infinite_conflict(u.l, w.l, conflict.cross, root));
}
template <class Number>
[[nodiscard]] constexpr Number square_of_distance(const Point& p, const Site& m) noexcept {
    const Number x = Number(p.x) - Number(m.x);
    const Number y = Number(p.y) - Number(m.y);
    return x * x + y * y;
}
[[nodiscard]] inline additive::Distance distance(const Point& p, const Site& m) noexcept {
    const Site site = filters::pinned(m);
    const double to_centre = square_root(square_of_distance<double>(filters::pinned(p), site));
    return {to_centre, to_centre + 0x1p-440, site.r};
}
[[nodiscard]] inline Verdict nearer(const Point& p, const Site& a, const Site& b) noexcept {
    return additive::nearer(distance(p, a), distance(p, b));
}
namespace rounded {
template <class Number>
[[nodiscard]] inline Sign in_circle(const Site& i, const Site& j, const Site& k,
                                    const Site& q) noexcept {
    using Difference = DifferenceOf<Number>;
    const TripleOf<Number> t(i, j, k);
    const ConflictOf<Number> conflict(t, Difference(q, i));
    const Sign sign = sign_of(t.q) * sign_of(conflict.a - conflict.l * square_root(conflict.gamma));
    if (sign > 0)
        for (const Site* m : {&i, &j, &k}) {
            const Difference row(q, *m);
            if (row.r <= 0 && row.p <= 0) return -1;
        }
    return sign;
}
template <class Number>
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    using Difference = DifferenceOf<Number>;
    const Difference u(b, a);
    const InfiniteConflictOf<Number> conflict(u, Difference(q, a));
    return sign_of(conflict.t - square_root(u.p) * conflict.cross);
}
template <class Number>
[[nodiscard]] inline Sign exists_twice(const Site& i, const Site& j, const Site& k) noexcept {
    return TripleOf<Number>(i, j, k).q < 0 ? -1 : 0;
}
template <class Number>
[[nodiscard]] inline Sign nearer(const Point& p, const Site& a, const Site& b) noexcept {
    const auto distance = [&p](const Site& m) -> Number {
        return square_root(square_of_distance<Number>(p, m)) - Number(m.r);
    };
    return sign_of(distance(b) - distance(a));
}
}
}
SIGNUM_IEEE_END

// ---- predicates/euclidean.hpp --------------------------------------------------------------------

namespace rooms::euclidean {
namespace cold {
template <std::size_t n>
using Ranks = std::array<Index, n>;
[[nodiscard, gnu::cold, gnu::pure]] Decision hides(Arithmetic arithmetic, const Site& i,
                                                   const Site& q, const Ranks<2>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision nearer(Arithmetic arithmetic, const Point& p,
                                                    const Site& a, const Site& b,
                                                    const Ranks<2>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision exists(Arithmetic arithmetic, const Site& i,
                                                    const Site& j, const Site& k,
                                                    const Ranks<3>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision exists_twice(Arithmetic arithmetic, const Site& i,
                                                          const Site& j, const Site& k,
                                                          const Ranks<3>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision precedes_on_bisector(Arithmetic arithmetic,
                                                                  const Site& i, const Site& j,
                                                                  const Site& q,
                                                                  const Site& k) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision in_circle(Arithmetic arithmetic, const Site& i,
                                                       const Site& j, const Site& k, const Site& q,
                                                       const Ranks<4>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision in_circle_infinite(Arithmetic arithmetic,
                                                                const Site& a, const Site& b,
                                                                const Site& q,
                                                                const Ranks<3>& ranks) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision reaches_farther(Arithmetic arithmetic, const Site& a,
                                                             const Site& b,
                                                             bool a_precedes_b) noexcept;
[[nodiscard, gnu::cold, gnu::pure]] Decision turn(Arithmetic arithmetic, const Site& a,
                                                  const Site& b, const Site& c) noexcept;
}
template <class... Others>
[[nodiscard]] inline bool same_radius(const Site& first, const Others&... others) noexcept {
    return ((first.r == others.r) && ...) && (filters::same_number(first.r, others.r) && ...);
}
template <Arithmetic arithmetic = Arithmetic::exact>
struct Perturbed {
    static constexpr Arithmetic arithmetic_used = arithmetic;
    [[nodiscard]] static Decision hides(const Site& i, const Site& q,
                                        const std::array<Index, 2>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::hides(i, q);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return cold::hides(arithmetic, i, q, ranks);
    }
    [[nodiscard]] static Decision exists(const Site& i, const Site& j, const Site& k,
                                         const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::exists(i, j, k);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return cold::exists(arithmetic, i, j, k, ranks);
    }
    [[nodiscard]] static Decision exists_twice(const Site& i, const Site& j, const Site& q,
                                               const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (same_radius(i, j, q))
                return {-1, Stage::filter};
            const auto verdict = filter::exists_twice(i, j, q);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::exists_twice<Number>(i, j, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::exists_twice(arithmetic, i, j, q, ranks);
    }
    [[nodiscard]] static Decision precedes_on_bisector(
        const Site& i, const Site& j, const Site& q, const Site& k,
        const std::array<Index, 4>& /*ranks*/) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::precedes_on_bisector(i, j, q, k);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return cold::precedes_on_bisector(arithmetic, i, j, q, k);
    }
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(i, j, k, q))
                return in_circle_of_points(i, j, k, q, ranks);
            const auto verdict = filter::in_circle(i, j, k, q);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::in_circle<Number>(i, j, k, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::in_circle(arithmetic, i, j, k, q, ranks);
    }
    [[nodiscard, gnu::always_inline]] static Decision in_circle_of_visible(
        const Site& i, const Site& j, const Site& k, const Site& q,
        const std::array<Index, 4>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(i, j, k, q))
                return in_circle_of_points(i, j, k, q, ranks);
            const auto verdict = filter::in_circle_of_visible(i, j, k, q);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return in_circle(i, j, k, q, ranks);
    }
    [[nodiscard]] static Decision in_circle_infinite(const Site& a, const Site& b, const Site& q,
                                                     const std::array<Index, 3>& ranks) noexcept {
        if constexpr (is_filtered) {
            if (asks_points && same_radius(a, b, q))
                return in_circle_infinite_of_points(a, b, q, ranks);
            const auto verdict = filter::in_circle_infinite(a, b, q);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::in_circle_infinite<Number>(a, b, q);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::in_circle_infinite(arithmetic, a, b, q, ranks);
    }
    [[nodiscard]] static Decision in_order_at_infinity(
        const Site& s, const Site& k, const Site& q, const Site& l, bool rest,
        const std::array<Index, 4>& /*ranks*/) noexcept {
        const Sign side = rest ? -1 : 1;
        const Decision to_q = turn(s, k, q);
        const Decision from_q = turn(s, q, l);
        const Stage stage = to_q.stage < from_q.stage ? from_q.stage : to_q.stage;
        const Sign sum = side * (to_q.sign + from_q.sign);
        if (sum != 0) return {sum > 0 ? 1 : -1, stage};
        const Decision back = turn(s, l, k);
        return {back.sign > 0 ? 1 : -1, stage < back.stage ? back.stage : stage};
    }
    [[nodiscard]] static Decision holds_first_direction(
        const Site& k, const Site& s, const Site& l, const std::array<Index, 3>& ranks) noexcept {
        Stage stage = Stage::filter;
        const auto is_positive = [&stage](const Decision& decision) {
            if (stage < decision.stage) stage = decision.stage;
            return decision.sign > 0;
        };
        if (is_positive(cold::reaches_farther(arithmetic, k, s, ranks[0] < ranks[1])) ||
            is_positive(cold::reaches_farther(arithmetic, l, s, ranks[2] < ranks[1])))
            return {-1, stage};
        if (ranks[0] == ranks[2] ||
            is_positive(in_circle_infinite(s, k, l, {ranks[1], ranks[0], ranks[2]})) ||
            is_positive(in_circle_infinite(l, s, k, {ranks[2], ranks[1], ranks[0]})))
            return {1, stage};
        const Sign sum = filters::compare_numbers(s.y, k.y) + filters::compare_numbers(l.y, s.y);
        const bool holds = sum != 0 ? sum > 0 : is_positive(turn(s, l, k));
        return {holds ? 1 : -1, stage};
    }
    [[nodiscard]] static additive::Distance distance(const Point& p, const Site& m) noexcept {
        return filter::distance(p, m);
    }
    [[nodiscard]] static Decision nearer(const Point& p, const Site& a, const Site& b,
                                         const std::array<Index, 2>& ranks) noexcept {
        if constexpr (is_filtered) {
            const auto verdict = filter::nearer(p, a, b);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        if constexpr (!is_exact(arithmetic)) {
            const Sign sign = filter::rounded::nearer<Number>(p, a, b);
            if (sign != 0) return {sign, Stage::filter};
        }
        return cold::nearer(arithmetic, p, a, b, ranks);
    }
 private:
    static constexpr bool is_filtered = predicates::is_filtered(arithmetic);
    static constexpr bool asks_points = arithmetic == Arithmetic::exact;
    using Number = predicates::NumberOf<arithmetic>;
    [[nodiscard]] static Decision in_circle_of_points(const Site& i, const Site& j, const Site& k,
                                                      const Site& q,
                                                      const std::array<Index, 4>& ranks) noexcept {
        const auto centre = [](const Site& m) -> Point { return {m.x, m.y}; };
        const Decision decision =
            power::in_circle_decision(centre(i), centre(j), centre(k), centre(q));
        if (decision.sign != 0)
            return decision;
        return {power::in_circle_tie(centre(i), centre(j), centre(k), centre(q), ranks),
                decision.stage, true};
    }
    [[nodiscard]] static Decision in_circle_infinite_of_points(
        const Site& a, const Site& b, const Site& q, const std::array<Index, 3>& ranks) noexcept {
        const Decision side = ccw_decision(a, b, q);
        if (side.sign != 0)
            return {-side.sign, side.stage};
        const auto order = [](const Site& m, const Site& n) {
            const Sign by_x = filters::compare_numbers(m.x, n.x);
            return by_x != 0 ? by_x : filters::compare_numbers(m.y, n.y);
        };
        const Sign from_a = order(a, q);
        const Sign to_b = order(q, b);
        const bool conflict = from_a == 0 ? ranks[2] < ranks[0]
                              : to_b == 0 ? ranks[2] < ranks[1]
                                          : from_a == to_b;
        return {conflict ? 1 : -1, side.stage, true};
    }
    [[nodiscard]] static Decision turn(const Site& a, const Site& b, const Site& c) noexcept {
        if constexpr (arithmetic == Arithmetic::exact) return ccw_decision(a, b, c);
        if constexpr (is_filtered) {
            const auto verdict = predicates::ccw_filter(a, b, c);
            if (verdict.is_certain())
                return {verdict.sign(), Stage::filter};
        }
        return cold::turn(arithmetic, a, b, c);
    }
};
[[nodiscard]] Decision in_circle_decision(const Site& i, const Site& j, const Site& k,
                                          const Site& q,
                                          const std::array<Index, 4>& ranks) noexcept;
[[nodiscard]] Decision in_circle_infinite_decision(const Site& a, const Site& b,
                                                   const Site& q) noexcept;
[[nodiscard]] inline bool exists(const Site& i, const Site& j, const Site& k) noexcept {
    return additive::exists<Perturbed<>>(i, j, k);
}
inline constexpr auto& in_circle = additive::in_circle<in_circle_decision>;
[[nodiscard]] inline Sign in_circle_infinite(const Site& a, const Site& b, const Site& q) noexcept {
    return in_circle_infinite_decision(a, b, q).sign;
}
[[nodiscard]] inline bool hidden(const Site& q, const Site& i) noexcept {
    return additive::hidden<Perturbed<>>(q, i);
}
inline constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
inline constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
inline constexpr auto& in_circle_infinite_perturbed =
    additive::in_circle_infinite_perturbed<Perturbed<>>;
}

// ---- single/parts/stages.cpp ---------------------------------------------------------------------

namespace rooms::power {
namespace {
namespace ladder = predicates::ladder;
constexpr double refined_in_circle_error = 16 * filters::double_double_epsilon;
struct Rounded {
    [[nodiscard]] static double difference(double a, double b) noexcept { return a - b; }
    [[nodiscard]] static double difference_of_squares(double a, double b) noexcept {
        return (a - b) * (a + b);
    }
    [[nodiscard]] static double zero() noexcept { return 0.0; }
};
template <class Number>
using CircleRows = std::array<Row<Number>, 3>;
template <class Number, class S>
[[nodiscard]] CircleRows<decltype(Number::zero())> circle_rows(const S& i, const S& j, const S& k,
                                                               const S& q) noexcept {
    return {row<Number>(i, q), row<Number>(j, q), row<Number>(k, q)};
}
template <class Number>
using SphereRows = std::array<LiftedRow<Number>, 4>;
template <class Number, class S>
[[nodiscard]] SphereRows<decltype(Number::zero())> sphere_rows(const S& i, const S& j, const S& k,
                                                               const S& l, const S& q) noexcept {
    return {lifted_row<Number>(i, q), lifted_row<Number>(j, q), lifted_row<Number>(k, q),
            lifted_row<Number>(l, q)};
}
[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(const CircleRows<double>& r) noexcept {
    const auto [value, bound] = compared_in_circle_finely(r[0], r[1], r[2]);
    return ladder::judged(value, bound);
}
[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(
    const CircleRows<filters::DoubleDouble>& r) noexcept {
    const auto high = [&](std::size_t m) -> Row<double> {
        return {r[m].x.high, r[m].y.high, r[m].weight.high};
    };
    return ladder::judged(
        in_circle_determinant(r[0], r[1], r[2]).high,
        refined_in_circle_error * determinant_magnitude(high(0), high(1), high(2)));
}
[[nodiscard, gnu::cold]] Sign sign_of_circle(const CircleRows<exact::Dyadic>& r) noexcept {
    return in_circle_determinant(r[0], r[1], r[2]).sign();
}
#if defined(__SIZEOF_INT128__)
[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(
    const exact::IntegerRows<2>& given) noexcept {
    exact::IntegerRows<2> rows = given;
    if (!rows.are_exact()) return filters::Verdict::uncertain();
    const auto determinant = [&](auto square) {
        using Square = decltype(square);
        const auto row = [&](std::size_t m) -> Row<exact::Word<Square>, Square> {
            return {{rows[m].offset[0]}, {rows[m].offset[1]}, Square{rows[m].weight}};
        };
        return in_circle_determinant(row(0), row(1), row(2));
    };
    if (!rows.divide_by_power_of_two(30))
        return filters::Verdict::certain(determinant(exact::Factor{0}).sign());
    const exact::Integer128 narrow = determinant(exact::Integer128{0});
    return filters::Verdict::certain((narrow > 0) - (narrow < 0));
}
#endif
struct CircleBeyond {
    template <class S>
    [[nodiscard, gnu::cold]] static Decision climb(const S& i, const S& j, const S& k,
                                                   const S& q) noexcept {
        return {sign_of_circle(circle_rows<ladder::Exactly>(i, j, k, q)), Stage::multiprecision};
    }
};
struct CircleWithin {
    template <class S>
    [[nodiscard]] static Decision climb(const S& i, const S& j, const S& k, const S& q) noexcept {
        filters::Verdict verdict = judge_circle(circle_rows<Rounded>(i, j, k, q));
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
#if defined(__SIZEOF_INT128__)
        if constexpr (words::same<S, Point>) {
            verdict = judge_circle(exact::IntegerRows<2>({&i, &j, &k}, q));
            if (verdict.is_certain()) return {verdict.sign(), Stage::exact};
        }
#endif
        verdict = judge_circle(circle_rows<ladder::Refined>(i, j, k, q));
        if (verdict.is_certain()) return {verdict.sign(), Stage::refine};
        return CircleBeyond::climb(i, j, k, q);
    }
};
[[nodiscard, gnu::noinline]] double size_of_sphere(const SphereRows<double>& r) noexcept {
    const LiftedRow<double> rows[4] = {r[0], r[1], r[2], r[3]};
    return determinant_magnitude(rows);
}
[[nodiscard, gnu::noinline]] double determinant_of_sphere(const SphereRows<double>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]);
}
[[nodiscard, gnu::noinline]] double determinant_of_sphere(
    const SphereRows<filters::DoubleDouble>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]).high;
}
[[nodiscard, gnu::cold]] Sign sign_of_sphere(const SphereRows<exact::Dyadic>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]).sign();
}
struct SphereBeyond {
    template <class S>
    [[nodiscard, gnu::cold]] static Decision climb(const S& i, const S& j, const S& k, const S& l,
                                                   const S& q) noexcept {
        return {sign_of_sphere(sphere_rows<ladder::Exactly>(i, j, k, l, q)), Stage::multiprecision};
    }
};
[[nodiscard, gnu::noinline]] bool are_corners_of_a_box(const Point3& i, const Point3& j,
                                                       const Point3& k, const Point3& l,
                                                       const Point3& q) noexcept {
    const auto are_two = [](double a, double b, double c, double d, double one) {
        double other = one;
        for (const double here : {a, b, c, d}) {
            if (here != one && other != one && here != other) return false;
            if (here != one) other = here;
        }
        return true;
    };
    return are_two(i.x, j.x, k.x, l.x, q.x) && are_two(i.y, j.y, k.y, l.y, q.y) &&
           are_two(i.z, j.z, k.z, l.z, q.z);
}
struct SphereWithin {
    template <class S>
    [[nodiscard]] static Decision climb(const S& i, const S& j, const S& k, const S& l,
                                        const S& q) noexcept {
        const auto rows = sphere_rows<Rounded>(i, j, k, l, q);
        const double size = size_of_sphere(rows);
        const double value = determinant_of_sphere(rows);
        filters::Verdict verdict = ladder::judged(value, in_sphere_error * size);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
        if constexpr (words::same<S, Point3>) {
            if (predicates::are_small_integers(0x1p8, {&i, &j, &k, &l, &q}))
                return {sign_of(value), Stage::exact};
            if (are_corners_of_a_box(i, j, k, l, q)) return {0, Stage::exact};
        }
        verdict = ladder::judged(determinant_of_sphere(sphere_rows<ladder::Refined>(i, j, k, l, q)),
                                 refined_in_sphere_error * size);
        if (verdict.is_certain()) return {verdict.sign(), Stage::refine};
        return SphereBeyond::climb(i, j, k, l, q);
    }
};
}
template <Arithmetic arithmetic, class S>
Decision InCircle::behind(const S& i, const S& j, const S& k, const S& q) noexcept {
    return ladder::climb<arithmetic, InCircle, CircleWithin, CircleBeyond>(i, j, k, q);
}
template <Arithmetic arithmetic, class S>
Decision InSphere::behind(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
    return ladder::climb<arithmetic, InSphere, SphereWithin, SphereBeyond>(i, j, k, l, q);
}
}
namespace rooms::euclidean {
namespace {
template <class Number, std::size_t n, class Make>
[[nodiscard]] std::array<Disc<Uniform<Number>>, n> discs_of(const std::array<Site, n>& sites,
                                                            const Make& make) {
    std::array<Disc<Uniform<Number>>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {make(sites[m].x), make(sites[m].y), make(sites[m].r)};
    return result;
}
template <std::size_t n, class Question>
[[nodiscard, gnu::cold]] Decision decide_exactly(const std::array<Site, n>& sites,
                                                 const Question& question) {
    const auto answer = question(
        discs_of<exact::Dyadic>(sites, [](double number) { return exact::Dyadic(number); }));
    return {answer.sign, Stage::multiprecision, answer.tied};
}
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_discs(const std::array<Site, n>& sites, const Question& question) {
    const Decision refined = exact::in_ieee_environment(
        [&](const std::array<Site, n>& given) -> Decision {
            using Number = Doubted<filters::Bounded>;
            bool doubt = false;
            const auto answer = question(
                discs_of<Number>(given, [&](double number) { return Number(number, doubt); }));
            return doubt ? Decision{} : Decision{answer.sign, Stage::refine, answer.tied};
        },
        sites);
    return refined.stage == Stage::refine ? refined : decide_exactly(sites, question);
}
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Filter filter, Question question, const Sites&... sites) noexcept {
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide_discs(std::array<Site, sizeof...(Sites)>{sites...}, question);
}
}
namespace cold {
Decision hides(Arithmetic, const Site& i, const Site& q, const Ranks<2>& ranks) noexcept {
    return decide([](const Site& m, const Site& other) { return filter::hides(m, other); },
                  [&](const auto& d) { return polynomials::hides(d, ranks); }, i, q);
}
Decision nearer(Arithmetic, const Point& p, const Site& a, const Site& b,
                const Ranks<2>& ranks) noexcept {
    return decide(
        [](const Site& point, const Site& first, const Site& second) {
            return filter::nearer({point.x, point.y}, first, second);
        },
        [&](const auto& d) { return polynomials::nearer(d, ranks); }, Site{p.x, p.y, a.r}, a, b);
}
Decision exists(Arithmetic, const Site& i, const Site& j, const Site& k,
                const Ranks<3>& ranks) noexcept {
    return decide(
        filter::exists, [&](const auto& d) { return polynomials::exists(d, ranks); }, i, j, k);
}
Decision in_circle(Arithmetic, const Site& i, const Site& j, const Site& k, const Site& q,
                   const Ranks<4>& ranks) noexcept {
    return decide(
        filter::in_circle, [&](const auto& d) { return polynomials::in_circle(d, ranks); }, i, j, k,
        q);
}
Decision in_circle_infinite(Arithmetic, const Site& a, const Site& b, const Site& q,
                            const Ranks<3>& ranks) noexcept {
    return decide(
        filter::in_circle_infinite,
        [&](const auto& d) { return polynomials::in_circle_infinite(d, ranks); }, a, b, q);
}
}
Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    const filters::Verdict verdict = filter::in_circle(i, j, k, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        filter::in_circle,
        [&](const auto& d) { return polynomials::Answer{polynomials::in_circle_touch(d, ranks)}; },
        i, j, k, q);
}
Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    const filters::Verdict verdict = filter::in_circle_infinite(a, b, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        filter::in_circle_infinite,
        [](const auto& d) { return polynomials::Answer{polynomials::in_circle_infinite_touch(d)}; },
        a, b, q);
}
}

}  // namespace

namespace {

struct Given {
    const double* numbers;
    std::size_t size;
};
[[gnu::noinline]] bool are_there(std::initializer_list<Given> all) noexcept {
    bool finite = true;
    for (const Given& each : all) {
        if (each.numbers == nullptr) return false;
        for (std::size_t k = 0; k < each.size; ++k)
            finite &= each.numbers[k] - each.numbers[k] == 0.0;
    }
    return finite;
}
template <class S>
struct Of;
template <>
struct Of<rooms::Point> {
    static constexpr std::size_t size = 2;
    static rooms::Point from(const double* n) noexcept { return {n[0], n[1]}; }
};
template <>
struct Of<rooms::Point3> {
    static constexpr std::size_t size = 3;
    static rooms::Point3 from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::Site> {
    static constexpr std::size_t size = 3;
    static rooms::Site from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::power::Site> {
    static constexpr std::size_t size = 3;
    static rooms::power::Site from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::Site3> {
    static constexpr std::size_t size = 4;
    static rooms::Site3 from(const double* n) noexcept { return {n[0], n[1], n[2], n[3]}; }
};
template <>
struct Of<rooms::power::Site3> {
    static constexpr std::size_t size = 4;
    static rooms::power::Site3 from(const double* n) noexcept { return {n[0], n[1], n[2], n[3]}; }
};
template <class... S, class Predicate, class... Numbers>
int answer(const Predicate& predicate, const Numbers*... numbers) noexcept {
    if (!are_there({{numbers, Of<S>::size}...})) return SIGNUM_NO_SIGN;
    return static_cast<int>(predicate(Of<S>::from(numbers)...));
}
template <class... S, class Predicate, class... Numbers>
[[gnu::cold, gnu::noinline]] int answer_behind(const Predicate& predicate,
                                               const Numbers*... numbers) noexcept {
    return answer<S...>(predicate, numbers...);
}
template <class... S, class Filter, class Predicate, class... Numbers>
[[gnu::always_inline]] inline int answer_filtered(const Filter& filter, const Predicate& predicate,
                                                  const Numbers*... numbers) noexcept {
    if (!((numbers != nullptr) && ...)) return SIGNUM_NO_SIGN;
    const rooms::filters::Verdict verdict = filter(Of<S>::from(numbers)...);
    if (verdict.is_certain()) return verdict.sign();
    return answer_behind<S...>(predicate, numbers...);
}
template <class Ask>
int answer_batch(std::initializer_list<const double*> rows, std::size_t count, int8_t* signs,
                 const Ask& ask) noexcept {
    if (count == 0) return 0;
    if (signs == nullptr) return SIGNUM_NO_SIGN;
    const double* at[4] = {};
    std::size_t operands = 0;
    for (const double* each : rows) {
        if (!are_there({{each, 2 * count}})) return SIGNUM_NO_SIGN;
        at[operands++] = each;
    }
    for (std::size_t m = 0; m < count; ++m) {
        signs[m] = static_cast<int8_t>(ask(at));
        for (std::size_t o = 0; o < operands; ++o) at[o] += 2;
    }
    return 0;
}
#define SIGNUM_IN_METRIC(metric, call)       \
    switch (metric) {                        \
        case SIGNUM_POWER: {                 \
            namespace in = rooms::power;     \
            return call;                     \
        }                                    \
        case SIGNUM_EUCLIDEAN: {             \
            namespace in = rooms::euclidean; \
            return call;                     \
        }                                    \
        case SIGNUM_MANHATTAN: {             \
            namespace in = rooms::manhattan; \
            return call;                     \
        }                                    \
        case SIGNUM_SUPREMUM: {              \
            namespace in = rooms::supremum;  \
            return call;                     \
        }                                    \
        default:                             \
            return SIGNUM_NO_SIGN;           \
    }

using rooms::predicates::Ccw;
using rooms::predicates::Ccw3;
using P = rooms::Point;
using S = rooms::Site;
using W = rooms::power::Site;
using P3 = rooms::Point3;
using S3 = rooms::Site3;
using W3 = rooms::power::Site3;

template <std::size_t n>
std::array<rooms::Index, n> ranks_from(const int32_t* ranks) noexcept {
    std::array<rooms::Index, n> result;
    for (std::size_t k = 0; k < n; ++k) result[k] = ranks[k];
    return result;
}

}

extern "C" {

int signum_ccw(const double* a, const double* b, const double* c) {
    return answer_filtered<P, P, P>(
        [](const P& x, const P& y, const P& z) { return rooms::predicates::ccw_filter(x, y, z); },
        [](const P& x, const P& y, const P& z) {
            return Ccw::behind<rooms::Arithmetic::exact>(x, y, z).sign;
        },
        a, b, c);
}
int signum_exists(signum_metric metric, const double* i, const double* j, const double* k) {
    SIGNUM_IN_METRIC(
        metric,
        (answer<S, S, S>([](const S& x, const S& y, const S& z) { return in::exists(x, y, z); }, i,
                         j, k)))
}
int signum_in_circle(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* q) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S, S, S>([](const S& x, const S& y, const S& z,
                                            const S& t) { return in::in_circle(x, y, z, t); },
                                         i, j, k, q)))
}
int signum_in_circle_points(const double* i, const double* j, const double* k, const double* q) {
    return answer_filtered<P, P, P, P>(
        [](const P& x, const P& y, const P& z, const P& t) {
            return rooms::power::in_circle_filter(x, y, z, t);
        },
        [](const P& x, const P& y, const P& z, const P& t) {
            return rooms::power::InCircle::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        i, j, k, q);
}
int signum_in_circle_weights(const double* i, const double* j, const double* k, const double* q) {
    return answer_filtered<W, W, W, W>(
        [](const W& x, const W& y, const W& z, const W& t) {
            return rooms::power::in_circle_filter(x, y, z, t);
        },
        [](const W& x, const W& y, const W& z, const W& t) {
            return rooms::power::InCircle::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        i, j, k, q);
}
int signum_in_circle_infinite(signum_metric metric, const double* a, const double* b,
                              const double* q) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S, S>([](const S& x, const S& y,
                                         const S& z) { return in::in_circle_infinite(x, y, z); },
                                      a, b, q)))
}
int signum_in_circle_infinite_points(const double* a, const double* b, const double* q) {
    return answer<P, P, P>(rooms::power::in_circle_infinite<P>, a, b, q);
}
int signum_in_circle_infinite_weights(const double* a, const double* b, const double* q) {
    return answer<W, W, W>(rooms::power::in_circle_infinite<W>, a, b, q);
}
int signum_in_circle_perturbed(signum_metric metric, const double* i, const double* j,
                               const double* k, const double* q, const int32_t* ranks) {
    if (ranks == nullptr) return SIGNUM_NO_SIGN;
    SIGNUM_IN_METRIC(metric, (answer<S, S, S, S>(
                                 [&](const S& x, const S& y, const S& z, const S& t) {
                                     return in::in_circle_perturbed(x, y, z, t,
                                                                    ranks_from<4>(ranks));
                                 },
                                 i, j, k, q)))
}
int signum_in_circle_infinite_perturbed(signum_metric metric, const double* a, const double* b,
                                        const double* q, const int32_t* ranks) {
    if (ranks == nullptr) return SIGNUM_NO_SIGN;
    SIGNUM_IN_METRIC(metric, (answer<S, S, S>(
                                 [&](const S& x, const S& y, const S& z) {
                                     return in::in_circle_infinite_perturbed(x, y, z,
                                                                             ranks_from<3>(ranks));
                                 },
                                 a, b, q)))
}
int signum_hidden(signum_metric metric, const double* q, const double* i) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S>([](const S& x, const S& y) { return in::hidden(x, y); }, q, i)))
}
int signum_hidden_weights(const double* q, const double* i) {
    return answer<W, W>(rooms::power::hidden<W>, q, i);
}
int signum_nearer(signum_metric metric, const double* p, const double* a, const double* b) {
    SIGNUM_IN_METRIC(
        metric,
        (answer<P, S, S>([](const P& x, const S& y, const S& z) { return in::nearer(x, y, z); }, p,
                         a, b)))
}
int signum_nearer_weights(const double* p, const double* a, const double* b) {
    return answer<P, W, W>(rooms::power::nearer<W>, p, a, b);
}

int signum_ccw_space(const double* a, const double* b, const double* c, const double* d) {
    return answer_filtered<P3, P3, P3, P3>(
        [](const P3& x, const P3& y, const P3& z, const P3& t) {
            return rooms::predicates::ccw_filter(x, y, z, t);
        },
        [](const P3& x, const P3& y, const P3& z, const P3& t) {
            return Ccw3::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        a, b, c, d);
}
int signum_in_sphere_points(const double* i, const double* j, const double* k, const double* l,
                            const double* q) {
    return answer_filtered<P3, P3, P3, P3, P3>(
        [](const P3& x, const P3& y, const P3& z, const P3& t, const P3& u) {
            return rooms::power::in_sphere_filter(x, y, z, t, u);
        },
        [](const P3& x, const P3& y, const P3& z, const P3& t, const P3& u) {
            return rooms::power::InSphere::behind<rooms::Arithmetic::exact>(x, y, z, t, u).sign;
        },
        i, j, k, l, q);
}
int signum_in_sphere_weights(const double* i, const double* j, const double* k, const double* l,
                             const double* q) {
    return answer_filtered<W3, W3, W3, W3, W3>(
        [](const W3& x, const W3& y, const W3& z, const W3& t, const W3& u) {
            return rooms::power::in_sphere_filter(x, y, z, t, u);
        },
        [](const W3& x, const W3& y, const W3& z, const W3& t, const W3& u) {
            return rooms::power::InSphere::behind<rooms::Arithmetic::exact>(x, y, z, t, u).sign;
        },
        i, j, k, l, q);
}
int signum_nearer_space(const double* p, const double* a, const double* b) {
    return answer<P3, S3, S3>(
        [](const P3& x, const S3& y, const S3& z) {
            return rooms::power::nearer_decision(x, y, z).sign;
        },
        p, a, b);
}

int signum_ccw_batch(const double* a, const double* b, const double* c, size_t count,
                     int8_t* signs) {
    return answer_batch({a, b, c}, count, signs,
                        [](const double* const* p) { return signum_ccw(p[0], p[1], p[2]); });
}
int signum_in_circle_points_batch(const double* i, const double* j, const double* k,
                                  const double* q, size_t count, int8_t* signs) {
    return answer_batch({i, j, k, q}, count, signs, [](const double* const* p) {
        return signum_in_circle_points(p[0], p[1], p[2], p[3]);
    });
}

int signum_sign_of_sum(const double* terms, size_t count) {
    if (count == 0) return 0;
    if (terms == nullptr || static_cast<std::uint64_t>(count) >> 32 != 0) return SIGNUM_NO_SIGN;
    for (std::size_t k = 0; k < count; ++k)
        if (!(terms[k] - terms[k] == 0.0)) return SIGNUM_NO_SIGN;
    return rooms::sign_of_sum({terms, count});
}

}
