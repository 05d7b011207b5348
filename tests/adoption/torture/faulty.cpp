/// Predicates of which one is at fault in one way, for signum torture to find: with FAULT = 8 f + k
/// function f has fault k, with FAULT = -1 none. Each is a filter with Shewchuk's bound, and behind
/// it the exact sign of single/.

#include <cmath>

#include <signum_predicates.hpp>

#ifndef FAULT
#define FAULT (-1)
#endif

namespace {

enum Fault {
    bound_too_small,  // by this much a rounded determinant can be wrong
    bound_left_out,
    exact_stage_left_out,
    one_tie_answered,  // a point that is there twice is on no side
    in_floats,
    overflow_believed,  // NaN exceeds every bound
    tails_dropped,      // the exact stage takes rounded differences
    one_sign_turned
};
constexpr double u = 0x1p-53;

template <int function>
constexpr bool has(Fault fault) {
    return FAULT == 8 * function + fault;
}
double size(double x) {
    return std::fabs(x);
}

/// The determinant and its magnitude, from differences to the last point.
struct Number {
    double value;
    double magnitude;
};
Number operator*(Number a, Number b) {
    return {a.value * b.value, a.magnitude * b.magnitude};
}
Number operator+(Number a, Number b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
}
Number operator-(Number a, Number b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
}
template <int function>
Number difference(double a, double b) {
    double x = a - b;
    if (has<function>(in_floats)) x = static_cast<float>(x);
    return {x, size(x)};
}

template <int function, int dimension, int points, class Determinant, class Exact>
double decide(const double* const (&p)[points], double bound, const Determinant& determinant,
              const Exact& exact) {
    Number d[points - 1][dimension];
    for (int m = 0; m + 1 < points; ++m)
        for (int k = 0; k < dimension; ++k)
            d[m][k] = difference<function>(p[m][k], p[points - 1][k]);
    const Number number = determinant(d);
    double error = bound * number.magnitude;
    constexpr double shares[] = {2.0, 5.0, 4.0, 8.0};
    if (has<function>(bound_too_small)) error /= shares[function];
    if (has<function>(bound_left_out)) error = 0;
    // Where products may underflow no bound is good.
    bool is_ordinary = true;
    for (auto& row : d)
        for (Number& x : row)
            is_ordinary &= x.magnitude == 0 || (x.magnitude > 0x1p-150 && x.magnitude < 0x1p150);
    if (is_ordinary && size(number.value) > error) return number.value;
    if (has<function>(overflow_believed) && !(size(number.value) <= error)) return number.value;
    if (has<function>(exact_stage_left_out)) return number.value;
    double rounded[points][dimension] = {};
    const double* q[points];
    for (int m = 0; m < points; ++m) q[m] = p[m];
    if (has<function>(tails_dropped))
        for (int m = 0; m < points; ++m) {
            for (int k = 0; k < dimension; ++k) rounded[m][k] = p[m][k] - p[points - 1][k];
            q[m] = rounded[m];
        }
    const int sign = exact(q);
    const bool are_same = p[0][0] == p[1][0] && p[0][1] == p[1][1];
    if (has<function>(one_tie_answered) && sign == 0 && are_same) return 1;
    if (has<function>(one_sign_turned) && sign < 0 && p[0][0] == p[1][0]) return 1;
    return sign;
}

template <class Row>
Number square(const Row& a, int dimension) {
    Number sum{0, 0};
    for (int k = 0; k < dimension; ++k) sum = sum + a[k] * a[k];
    return sum;
}
template <class Row>
Number minor(const Row& a, const Row& b) {
    return a[0] * b[1] - a[1] * b[0];
}
template <class Row>
Number minor(const Row& a, const Row& b, const Row& c) {
    return (a[2] * minor(b, c) - b[2] * minor(a, c)) + c[2] * minor(a, b);
}

}  // namespace

extern "C" {

double orient2d(const double* a, const double* b, const double* c) {
    return decide<0, 2, 3>(
        {a, b, c}, (3 + 16 * u) * u, [](auto& d) { return minor(d[0], d[1]); },
        [](const double* const* p) { return signum::shewchuk::orient2d(p[0], p[1], p[2]); });
}
double incircle(const double* a, const double* b, const double* c, const double* d) {
    return decide<1, 2, 4>(
        {a, b, c, d}, (10 + 96 * u) * u,
        [](auto& r) {
            return (square(r[0], 2) * minor(r[1], r[2]) + square(r[1], 2) * minor(r[2], r[0])) +
                   square(r[2], 2) * minor(r[0], r[1]);
        },
        [](const double* const* p) { return signum::shewchuk::incircle(p[0], p[1], p[2], p[3]); });
}
double orient3d(const double* a, const double* b, const double* c, const double* d) {
    return decide<2, 3, 4>(
        {a, b, c, d}, (7 + 56 * u) * u, [](auto& r) { return minor(r[0], r[1], r[2]); },
        [](const double* const* p) { return signum::shewchuk::orient3d(p[0], p[1], p[2], p[3]); });
}
double insphere(const double* a, const double* b, const double* c, const double* d,
                const double* e) {
    return decide<3, 3, 5>(
        {a, b, c, d, e}, (16 + 224 * u) * u,
        [](auto& r) {
            return (square(r[3], 3) * minor(r[0], r[1], r[2]) -
                    square(r[2], 3) * minor(r[3], r[0], r[1])) +
                   (square(r[1], 3) * minor(r[2], r[3], r[0]) -
                    square(r[0], 3) * minor(r[1], r[2], r[3]));
        },
        [](const double* const* p) {
            return signum::shewchuk::insphere(p[0], p[1], p[2], p[3], p[4]);
        });
}
}
