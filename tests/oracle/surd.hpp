#pragma once
/// Numbers a + b√g with rational a, b and g: what is met where one quadratic equation is solved.
/// Signs and comparisons are exact, by squaring; whether g is a square never matters.

#include "linear_form.hpp"

#include <boost/multiprecision/gmp.hpp>

#include <stdexcept>
#include <utility>

namespace signum::oracle {

class Surd {
 public:
    Surd() = default;
    Surd(int a) : a_(a) {}
    Surd(Rational a) : a_(std::move(a)) {}
    /// g >= 0, else throws std::invalid_argument. A number without a root has b = g = 0.
    Surd(Rational a, Rational b, Rational g)
        : a_(std::move(a)), b_(std::move(b)), g_(std::move(g)) {
        if (g_.sign() < 0) throw std::invalid_argument("oracle: the root of a negative number");
        if (b_.is_zero() || g_.is_zero()) b_ = g_ = 0;
    }

    const Rational& a() const { return a_; }
    const Rational& b() const { return b_; }
    const Rational& g() const { return g_; }

    int sign() const {
        if (a_.sign() * b_.sign() >= 0) return a_.is_zero() ? b_.sign() : a_.sign();
        const Rational difference = a_ * a_ - b_ * b_ * g_;
        return difference.sign() * a_.sign();
    }

    Surd operator-() const { return {-a_, -b_, g_}; }
    /// Sums and products: of numbers with one g, or with one of them rational; else throws
    /// std::logic_error.
    friend Surd operator+(const Surd& x, const Surd& y) {
        return {x.a_ + y.a_, x.b_ + y.b_, common(x, y)};
    }
    friend Surd operator-(const Surd& x, const Surd& y) { return x + -y; }
    friend Surd operator*(const Surd& x, const Surd& y) {
        const Rational g = common(x, y);
        return {x.a_ * y.a_ + x.b_ * y.b_ * g, x.a_ * y.b_ + x.b_ * y.a_, g};
    }

    /// Comparisons: of any two. Of the numbers x and b√g the one is larger whose square is, if both
    /// are positive; the other way round if both are negative.
    friend bool operator==(const Surd& x, const Surd& y) { return compare(x, y) == 0; }
    friend bool operator<(const Surd& x, const Surd& y) { return compare(x, y) < 0; }

 private:
    static Rational common(const Surd& x, const Surd& y) {
        if (x.g_.is_zero()) return y.g_;
        if (!y.g_.is_zero() && x.g_ != y.g_) throw std::logic_error("oracle: two different roots");
        return x.g_;
    }
    static int compare(const Surd& x, const Surd& y) {
        const Surd left(x.a_ - y.a_, x.b_, x.g_);
        const int sign = left.sign();
        if (sign != y.b_.sign()) return sign < y.b_.sign() ? -1 : 1;
        return (left * left - Surd(y.b_ * y.b_ * y.g_)).sign() * sign;
    }

    Rational a_ = 0;
    Rational b_ = 0;
    Rational g_ = 0;
};

/// Of x < y a rational number between them.
inline Rational between(const Surd& x, const Surd& y) {
    using Integer = decltype(numerator(Rational()));
    for (unsigned bits = 8;; bits *= 2) {
        const Integer scale = Integer(1) << bits;
        const Rational square = x.b() * x.b() * x.g() * Rational(scale * scale);
        // The root, less than 1 / scale below itself; so 2 / scale above the sum is above x.
        const Rational root(sqrt(Integer(numerator(square) / denominator(square))), scale);
        const Rational above =
            x.a() + (x.b().sign() < 0 ? Rational(-root) : root) + Rational(2, scale);
        if (Surd(above) < y) return above;
    }
}

}  // namespace signum::oracle
