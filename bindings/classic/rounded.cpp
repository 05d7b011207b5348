#include "rounded.hpp"

#include <bit>
#include <cstdint>
#include <limits>

#include "../../exact/dyadic.hpp"
#include "../../exact/expansion.hpp"
#include "../../exact/floating_environment.hpp"

namespace signum::classic {
namespace {

using exact::Dyadic;

/// A pair and its size.
struct Sized {
    Pair value;
    double size;

    [[gnu::always_inline]] friend inline Sized operator*(const Sized& x, const Sized& y) noexcept {
        return {x.value * y.value, x.size * y.size};
    }
    [[gnu::always_inline]] friend inline Sized operator+(const Sized& x, const Sized& y) noexcept {
        return {x.value + y.value, x.size + y.size};
    }
    [[gnu::always_inline]] friend inline Sized operator-(const Sized& x) noexcept {
        return {-x.value, x.size};
    }
    [[gnu::always_inline]] friend inline Sized operator-(const Sized& x, const Sized& y) noexcept {
        return x + -y;
    }
};

}  // namespace

template <>
struct Minus<Sized> {
    [[gnu::always_inline]] static Sized of(double a, double b) noexcept {
        const Pair value = minus<Pair>(a, b);
        return {value, filters::magnitude(value.high)};
    }
};
template <>
struct Minus<Dyadic> {
    static Dyadic of(double a, double b) { return Dyadic(a) - Dyadic(b); }
};

namespace {

[[nodiscard]] bool is_finite(double x) noexcept {
    return (std::bit_cast<std::uint64_t>(x) >> 52 & 0x7FF) != 0x7FF;
}

/// The nearest double, halves to even; but never 0 for what is not, and infinity beyond the
/// doubles.
[[nodiscard]] double nearest(const Dyadic& number) {
    const Sign sign = number.sign();
    if (sign == 0) return 0.0;
    const double value = exact::round_to_double(number);
    const double infinity = std::numeric_limits<double>::infinity();
    const double least = std::numeric_limits<double>::denorm_min();
    if (!is_finite(value)) return sign < 0 ? -infinity : infinity;
    if (value == 0.0) return sign < 0 ? -least : least;
    return value;
}

/// The sum of the terms. Let |t| be the last; all before it add up to less than |t|/2, so that high
/// is at least |t|/2, and what the additions lost, which low sums up, is less than 2u|t|: to add it
/// up costs terms in u² alone.
template <int capacity>
[[nodiscard]] double nearest(const exact::Expansion<capacity>& number) noexcept {
    double high = 0.0;
    double low = 0.0;
    for (const double term : number.terms()) {
        const TwoTerms sum = two_sum(high, term);
        high = sum.high;
        low += sum.low;
    }
    return high + low;
}

/// In the window of expansions. Those of insphere would fill the stack; integers are as fast there.
[[nodiscard]] double exactly(const Orient2d& d) noexcept {
    const auto [a, b, c] = d;
    return nearest(exact::difference(a[0], c[0]) * exact::difference(b[1], c[1]) -
                   exact::difference(a[1], c[1]) * exact::difference(b[0], c[0]));
}
[[nodiscard]] double exactly(const Orient3d& d) noexcept {
    const auto minor = [&d](const double* p, const double* q) {
        return exact::difference(p[0], d.d[0]) * exact::difference(q[1], d.d[1]) -
               exact::difference(p[1], d.d[1]) * exact::difference(q[0], d.d[0]);
    };
    return nearest(minor(d.b, d.c) * exact::difference(d.a[2], d.d[2]) +
                   minor(d.c, d.a) * exact::difference(d.b[2], d.d[2]) +
                   minor(d.a, d.b) * exact::difference(d.c[2], d.d[2]));
}
[[nodiscard]] double exactly(const Incircle& d) noexcept {
    const auto minor = [&d](const double* p, const double* q) {
        return exact::difference(p[0], d.d[0]) * exact::difference(q[1], d.d[1]) -
               exact::difference(p[1], d.d[1]) * exact::difference(q[0], d.d[0]);
    };
    const auto lift = [&d](const double* p) {
        return exact::square(exact::difference(p[0], d.d[0])) +
               exact::square(exact::difference(p[1], d.d[1]));
    };
    return nearest(minor(d.b, d.c) * lift(d.a) + minor(d.c, d.a) * lift(d.b) +
                   minor(d.a, d.b) * lift(d.c));
}
/// The library's predicate is fast where the five are cospherical, as all of a grid may be.
[[nodiscard]] double exactly(const Insphere& d) noexcept {
    const auto point = [](const double* p) { return Point3{p[0], p[1], p[2]}; };
    const Decision decision = power::InSphere::behind<Arithmetic::exact>(
        point(d.a), point(d.b), point(d.c), point(d.d), point(d.e));
    return decision.sign == 0 ? 0.0 : nearest(d.determinant<Dyadic>());
}
template <class Determinant>
[[nodiscard]] double exactly(const Determinant& d) noexcept {
    return nearest(d.template determinant<Dyadic>());
}

/// In the window differences are multiples of 2^-202 below 2^151, so that of products of five of
/// them neither these nor their errors over- or underflow.
template <class Determinant>
[[nodiscard]] double decide(const Determinant& d) noexcept {
    if (d.all_coordinates([](double x) { return exact::window::contains(x, 150); })) {
        Sized result;
        as_wide_as_possible([&]() __attribute__((always_inline)) {
            result = d.template determinant<Sized>();
        });
        const double value = result.value.high + result.value.low;
        if (result.size == 0.0) return 0.0;
        if (filters::magnitude(value) >= least_of_pairs<Determinant> * result.size) return value;
        return exactly(d);
    }
    if (!d.all_coordinates(is_finite)) return std::numeric_limits<double>::quiet_NaN();
    return nearest(d.template determinant<Dyadic>());
}

}  // namespace

template <class Determinant>
double rounded_cold(const Determinant& d) noexcept {
    return exact::in_ieee_environment(decide<Determinant>, d);
}

template double rounded_cold(const Orient2d&) noexcept;
template double rounded_cold(const Orient3d&) noexcept;
template double rounded_cold(const Incircle&) noexcept;
template double rounded_cold(const Insphere&) noexcept;
template double rounded_cold(const Orient4d&) noexcept;

}  // namespace signum::classic
