#pragma once
/// Polynomials over a number type: what a form is written in once, to be evaluated in
/// approximations and in dyadic numbers. For sources only.
///
/// The degree is part of the type, so that loops have constant bounds and nothing is allocated. It
/// is what the formula says; the first coefficients may be 0.

#include <algorithm>
#include <array>

#include "../exact/dyadic.hpp"
#include "approximation.hpp"

namespace signum::roots {

/// The highest degree that a polynomial may have.
inline constexpr int most_degree = 8;

template <class Number, int Degree>
struct PolynomialIn {
    static_assert(0 <= Degree && Degree <= most_degree);
    static constexpr int degree = Degree;
    /// From the constant one upwards.
    std::array<Number, Degree + 1> c{};
};

/// The double itself. What enters a filter is pinned (filters/environment.hpp).
template <class Number>
[[nodiscard]] inline PolynomialIn<Number, 0> constant(double x) {
    return {{Number(filters::pinned(x))}};
}
/// x + v t. Precondition, here as in constant(): finite doubles.
template <class Number>
[[nodiscard]] inline PolynomialIn<Number, 1> line(double x, double v) {
    return {{Number(filters::pinned(x)), Number(filters::pinned(v))}};
}

/// The same one, for who knows a higher degree.
template <int N, class Number, int M>
[[nodiscard]] constexpr PolynomialIn<Number, N> widened(const PolynomialIn<Number, M>& p) {
    static_assert(N >= M);
    PolynomialIn<Number, N> result{};
    for (std::size_t i = 0; i < p.c.size(); ++i) result.c[i] = p.c[i];
    return result;
}

template <class Number, int M, int N>
[[nodiscard]] constexpr PolynomialIn<Number, std::max(M, N)> operator+(
    const PolynomialIn<Number, M>& p, const PolynomialIn<Number, N>& q) {
    PolynomialIn<Number, std::max(M, N)> sum{};
    for (int i = 0; i <= std::max(M, N); ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (i <= M && i <= N) {
            sum.c[k] = p.c[k] + q.c[k];
        } else {
            sum.c[k] = i <= M ? p.c[k] : q.c[k];
        }
    }
    return sum;
}
template <class Number, int M>
[[nodiscard]] constexpr PolynomialIn<Number, M> operator-(const PolynomialIn<Number, M>& p) {
    PolynomialIn<Number, M> result{};
    for (std::size_t i = 0; i < p.c.size(); ++i) result.c[i] = -p.c[i];
    return result;
}
template <class Number, int M, int N>
[[nodiscard]] constexpr PolynomialIn<Number, std::max(M, N)> operator-(
    const PolynomialIn<Number, M>& p, const PolynomialIn<Number, N>& q) {
    return p + -q;
}
template <class Number, int M, int N>
[[nodiscard]] constexpr PolynomialIn<Number, M + N> operator*(const PolynomialIn<Number, M>& p,
                                                              const PolynomialIn<Number, N>& q) {
    PolynomialIn<Number, M + N> product{};
    std::array<bool, M + N + 1> begun{};
    for (std::size_t i = 0; i <= M; ++i)
        for (std::size_t j = 0; j <= N; ++j) {
            const Number term = p.c[i] * q.c[j];
            product.c[i + j] = begun[i + j] ? product.c[i + j] + term : term;
            begun[i + j] = true;
        }
    return product;
}
template <class Number, int M>
[[nodiscard]] constexpr PolynomialIn<Number, M> operator*(int a, const PolynomialIn<Number, M>& p) {
    PolynomialIn<Number, M> result{};
    for (std::size_t i = 0; i < p.c.size(); ++i) result.c[i] = a * p.c[i];
    return result;
}

}  // namespace signum::roots
