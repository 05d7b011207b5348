#pragma once
/// Real roots of several polynomials together, in GMP's integers: Yun's square-free factors and
/// Vincent's bisection by Descartes' rule of signs (Collins and Akritas). It shares nothing with
/// the library, which counts by Sturm's theorem.
///
/// All questions are answered from one table: the roots of the product in order, and between any
/// two of them a point that is no root. Which polynomial vanishes at a root, and how often, is then
/// told by changes of sign of its square-free factors, and no two roots are ever compared.

#include <optional>
#include <vector>

#include <gmpxx.h>

namespace signum::oracle {

/// From the constant coefficient upwards.
using IntegerPolynomial = std::vector<mpz_class>;

[[nodiscard]] IntegerPolynomial operator+(const IntegerPolynomial& p, const IntegerPolynomial& q);
[[nodiscard]] IntegerPolynomial operator-(const IntegerPolynomial& p, const IntegerPolynomial& q);
[[nodiscard]] IntegerPolynomial operator*(const IntegerPolynomial& p, const IntegerPolynomial& q);
[[nodiscard]] int sign_at(const IntegerPolynomial& p, const mpq_class& x);

class RealRoots {
 public:
    /// No polynomial is 0.
    explicit RealRoots(const std::vector<IntegerPolynomial>& polynomials);

    /// How many distinct roots there are in all.
    [[nodiscard]] int count() const { return static_cast<int>(roots_.size()); }
    /// Of the i-th root, 0 where the polynomial does not vanish there.
    [[nodiscard]] int multiplicity(int i, int polynomial) const;
    /// At the i-th root and right after it.
    [[nodiscard]] int sign_at(int i, int polynomial) const;
    [[nodiscard]] int sign_after(int i, int polynomial) const;
    /// The sign of the i-th root less x.
    [[nodiscard]] int compare(int i, const mpq_class& x) const;
    /// Halves to even; infinity beyond the doubles.
    [[nodiscard]] double nearest_double(int i) const;

 private:
    /// In (low, high), or low and high itself.
    struct Isolated {
        mpq_class low;
        mpq_class high;
        int sign = 0;  // of the product right after low, once it is known
    };
    void isolate(const IntegerPolynomial& p, const mpq_class& low, const mpq_class& width);
    void halve(Isolated& root) const;
    [[nodiscard]] double round(Isolated root) const;
    [[nodiscard]] int compare(const Isolated& root, const mpq_class& x) const;
    [[nodiscard]] int sign_right_of(const mpq_class& x) const;

    std::vector<IntegerPolynomial> polynomials_;
    std::vector<std::vector<IntegerPolynomial>> factors_;
    IntegerPolynomial product_;  // of all, without multiple roots
    IntegerPolynomial slope_;
    std::vector<Isolated> roots_;
    mutable std::vector<std::optional<double>> nearest_;
};

}  // namespace signum::oracle
