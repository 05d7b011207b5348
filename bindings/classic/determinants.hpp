#pragma once
/// The classic determinants: their operands, and one text for every type of number.
///
/// A struct holds the operands; determinant<Number>() is the number. minus<Number>(a, b) makes a
/// Number of the difference of two doubles, which is all that a determinant knows of its operands.
/// ceiling() is not below the determinant's size, the same formula with every difference replaced
/// by its magnitude and every subtraction by an addition, but for its roundings: it is a product of
/// sums of magnitudes, in which every product of the formula occurs. It is above 2^200, or NaN,
/// where a difference is above 2^100.

#include <array>
#include <limits>

#include "../../predicates/ccw.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum::classic {

/// a - b as a Number.
template <class Number>
struct Minus;
template <class Number>
[[nodiscard, gnu::always_inline]] constexpr Number minus(double a, double b) noexcept {
    return Minus<Number>::of(a, b);
}

/// In the environment of the caller.
template <>
struct Minus<double> {
    [[gnu::always_inline]] static constexpr double of(double a, double b) noexcept { return a - b; }
};
template <>
struct Minus<filters::RoundingCount> {
    static constexpr filters::RoundingCount of(double, double) noexcept {
        return filters::rounded_difference;
    }
};

template <class Number>
[[nodiscard, gnu::always_inline]] constexpr predicates::Offset3<Number> offset(
    const double* m, const double* q) noexcept {
    return {minus<Number>(m[0], q[0]), minus<Number>(m[1], q[1]), minus<Number>(m[2], q[2])};
}
/// The sum of the magnitudes.
[[nodiscard, gnu::always_inline]] inline double length(const double* m, const double* q,
                                                       int dimension) noexcept {
    double sum = 0.0;
    for (int k = 0; k < dimension; ++k) sum += filters::magnitude(m[k] - q[k]);
    return sum;
}

/// Where operands are before they are told, to count roundings.
inline constexpr double origin[3] = {};

struct Orient2d {
    const double *a = origin, *b = origin, *c = origin;

    template <class Number>
    [[nodiscard, gnu::always_inline]] constexpr Number determinant() const {
        return predicates::ccw_determinant<Number>(
            minus<Number>(a[0], c[0]), minus<Number>(a[1], c[1]), minus<Number>(b[0], c[0]),
            minus<Number>(b[1], c[1]));
    }
    [[nodiscard, gnu::always_inline]] double ceiling() const noexcept {
        const double sum = length(a, c, 2) + length(b, c, 2);
        return sum * sum;
    }
    template <class Predicate>
    [[nodiscard]] bool all_coordinates(const Predicate& hold) const noexcept {
        for (const double* p : {a, b, c})
            if (!hold(p[0]) || !hold(p[1])) return false;
        return true;
    }
};

struct Orient3d {
    const double *a = origin, *b = origin, *c = origin, *d = origin;

    template <class Number>
    [[nodiscard, gnu::always_inline]] constexpr Number determinant() const {
        return predicates::ccw_determinant(offset<Number>(a, d), offset<Number>(b, d),
                                           offset<Number>(c, d));
    }
    [[nodiscard, gnu::always_inline]] double ceiling() const noexcept {
        const double sum = (length(a, d, 3) + length(b, d, 3)) + length(c, d, 3);
        return sum * sum * sum;
    }
    template <class Predicate>
    [[nodiscard]] bool all_coordinates(const Predicate& hold) const noexcept {
        for (const double* p : {a, b, c, d})
            if (!hold(p[0]) || !hold(p[1]) || !hold(p[2])) return false;
        return true;
    }
};

struct Incircle {
    const double *a = origin, *b = origin, *c = origin, *d = origin;

    template <class Number>
    [[nodiscard, gnu::always_inline]] constexpr Number determinant() const {
        const Number ax = minus<Number>(a[0], d[0]);
        const Number ay = minus<Number>(a[1], d[1]);
        const Number bx = minus<Number>(b[0], d[0]);
        const Number by = minus<Number>(b[1], d[1]);
        const Number cx = minus<Number>(c[0], d[0]);
        const Number cy = minus<Number>(c[1], d[1]);
        return (ax * ax + ay * ay) * (bx * cy - cx * by) +
               (bx * bx + by * by) * (cx * ay - ax * cy) +
               (cx * cx + cy * cy) * (ax * by - bx * ay);
    }
    [[nodiscard, gnu::always_inline]] double ceiling() const noexcept {
        const double sum = (length(a, d, 2) + length(b, d, 2)) + length(c, d, 2);
        return (sum * sum) * (sum * sum);
    }
    template <class Predicate>
    [[nodiscard]] bool all_coordinates(const Predicate& hold) const noexcept {
        for (const double* p : {a, b, c, d})
            if (!hold(p[0]) || !hold(p[1])) return false;
        return true;
    }
};

/// A row of a determinant of space with a fourth column.
template <class Number>
struct Lifted {
    predicates::Offset3<Number> offset;
    Number lift;
    [[nodiscard, gnu::always_inline]] constexpr Number height() const { return lift; }
};

struct Insphere {
    const double *a = origin, *b = origin, *c = origin, *d = origin, *e = origin;

    template <class Number>
    [[nodiscard, gnu::always_inline]] constexpr Number determinant() const {
        const auto row = [this](const double* m) __attribute__((always_inline)) {
            const auto [x, y, z] = offset<Number>(m, e);
            return Lifted<Number>{{x, y, z}, x * x + y * y + z * z};
        };
        return -power::in_sphere_determinant(row(a), row(b), row(c), row(d));
    }
    [[nodiscard, gnu::always_inline]] double ceiling() const noexcept {
        const double sum =
            (length(a, e, 3) + length(b, e, 3)) + (length(c, e, 3) + length(d, e, 3));
        return (sum * sum) * (sum * sum) * sum;
    }
    template <class Predicate>
    [[nodiscard]] bool all_coordinates(const Predicate& hold) const noexcept {
        for (const double* p : {a, b, c, d, e})
            if (!hold(p[0]) || !hold(p[1]) || !hold(p[2])) return false;
        return true;
    }
};

struct Orient4d {
    const double *a = origin, *b = origin, *c = origin, *d = origin, *e = origin;
    std::array<double, 5> heights{};

    template <class Number>
    [[nodiscard, gnu::always_inline]] constexpr Number determinant() const {
        const auto row = [this](const double* m, std::size_t n) __attribute__((always_inline)) {
            return Lifted<Number>{offset<Number>(m, e), minus<Number>(heights[n], heights[4])};
        };
        return -power::in_sphere_determinant(row(a, 0), row(b, 1), row(c, 2), row(d, 3));
    }
    [[nodiscard, gnu::always_inline]] double ceiling() const noexcept {
        const double sum =
            (length(a, e, 3) + length(b, e, 3)) + (length(c, e, 3) + length(d, e, 3));
        double height = 0.0;
        for (const double each : heights) height += filters::magnitude(each - heights[4]);
        if (!(sum <= 0x1p100 && height <= 0x1p100)) return std::numeric_limits<double>::infinity();
        return (sum * sum) * (sum * height);
    }
    template <class Predicate>
    [[nodiscard]] bool all_coordinates(const Predicate& hold) const noexcept {
        for (const double height : heights)
            if (!hold(height)) return false;
        return Insphere{a, b, c, d, e}.all_coordinates(hold);
    }
};

}  // namespace signum::classic
