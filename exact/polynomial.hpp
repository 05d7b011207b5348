#pragma once
/// Polynomials in one variable with dyadic coefficients, and their real roots, all exact. For
/// sources only.
///
/// Laws:
///  1. a root is known by an interval and by signs at dyadic points, never by a rounded number;
///  2. all is done in integers: no rounding mode, no flushing of denormals.
///
/// Source: Sturm's theorem, with remainders that are kept primitive: they are divided by the
/// greatest common divisor of their coefficients, which keeps them short and their signs as they
/// are.

#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "dyadic.hpp"

namespace signum::exact {

class Polynomial {
 public:
    /// 0.
    Polynomial() = default;
    /// From the constant coefficient upwards.
    Polynomial(std::initializer_list<Dyadic> coefficients)
        : Polynomial(std::span<const Dyadic>(coefficients.begin(), coefficients.size())) {}
    explicit Polynomial(std::span<const Dyadic> coefficients);
    /// The same of integers, times a power of two.
    Polynomial(std::vector<Integer> coefficients, int exponent);

    friend Polynomial operator+(const Polynomial& p, const Polynomial& q);
    friend Polynomial operator-(const Polynomial& p, const Polynomial& q);
    friend Polynomial operator*(const Polynomial& p, const Polynomial& q);
    [[nodiscard]] Polynomial derivative() const;

    /// -1 of 0.
    [[nodiscard]] int degree() const noexcept { return static_cast<int>(c_.size()) - 1; }
    [[nodiscard]] Dyadic value_at(const Dyadic& x) const;
    [[nodiscard]] Sign sign_at(const Dyadic& x) const;
    /// The sign beyond all roots.
    [[nodiscard]] Sign sign_at_infinity() const { return c_.empty() ? 0 : c_.back().sign(); }
    /// From the constant one upwards, the last one not 0, without a common power of two.
    [[nodiscard]] const std::vector<Integer>& coefficients() const noexcept { return c_; }

 private:
    std::vector<Integer> c_;
    int exponent_ = 0;
};

/// A polynomial with the roots of odd multiplicity, each of them simple: it changes its sign where
/// p does. Precondition: p is not 0.
[[nodiscard]] Polynomial odd_part(const Polynomial& p);
/// The k-th one, from 0, has the roots of multiplicity k + 1, each of them simple; the last one is
/// no constant. Precondition: p is not 0.
[[nodiscard]] std::vector<Polynomial> square_free_factors(const Polynomial& p);
/// The greatest one, but for a factor. Precondition: not both are 0.
[[nodiscard]] Polynomial common_divisor(const Polynomial& p, const Polynomial& q);
/// The sign right after x: that of the first derivative that is not 0 there.
[[nodiscard]] Sign sign_after(Polynomial p, const Dyadic& x);

/// The real roots of a polynomial without multiple ones.
class Roots {
 public:
    /// Precondition: p is not 0 and has no multiple root.
    explicit Roots(const Polynomial& p);

    /// How many are in (low, high].
    [[nodiscard]] int between(const Dyadic& low, const Dyadic& high) const;
    /// How many are greater than x.
    [[nodiscard]] int after(const Dyadic& x) const;

    /// The only root in (low, high].
    struct Isolated {
        Dyadic low;
        Dyadic high;
    };
    /// The k-th root after x, counted from 1; nothing where there are fewer.
    [[nodiscard]] std::optional<Isolated> isolate(const Dyadic& x, int k) const;
    /// The k-th root after low, where that is known to be no greater than high.
    [[nodiscard]] Isolated isolate(const Isolated& within, int k) const;
    void halve(Isolated& root) const;
    /// The sign of root - x.
    [[nodiscard]] Sign compare(const Isolated& root, const Dyadic& x) const;
    /// Infinity where the nearest one would be beyond the doubles.
    [[nodiscard]] double nearest_double(const Isolated& root) const;
    /// The same of the k-th root after x; infinity where there are fewer.
    [[nodiscard]] double nearest_double(const Dyadic& x, int k) const;

 private:
    template <class SignOf>
    [[nodiscard]] int changes(const SignOf& sign_of) const;

    std::vector<Polynomial> chain_;
};

}  // namespace signum::exact
