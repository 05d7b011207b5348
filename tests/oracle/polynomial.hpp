#pragma once
/// Polynomials with rational coefficients, their real roots by Sturm's theorem, and the doubles
/// nearest to such numbers: what the oracles of things that move have in common.

#include "linear_form.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace signum::oracle {

/// The n-th double above 0, or below it; the last ones are the infinities.
inline double double_at(std::int64_t n) {
    return n < 0 ? -double_at(-n) : std::bit_cast<double>(n);
}

/// Infinity is here the number that the next exponent would have.
inline Rational number_at(std::int64_t n) {
    const double value = double_at(n);
    return std::isfinite(value) ? exactly(value) : 2 * exactly(std::copysign(0x1p1023, value));
}

/// The double nearest to a number, halves to even, and +0. All that is asked of the number is
/// `compare(x)`, its sign after x is subtracted.
template <class Compare>
double nearest(const Compare& compare) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::int64_t high = std::bit_cast<std::int64_t>(infinity);
    std::int64_t low = -high;
    if (compare(number_at(high)) >= 0) return infinity;
    if (compare(number_at(low)) < 0) return -infinity;
    while (low + 1 < high) {  // low <= number < high
        const std::int64_t middle = std::midpoint(low, high);
        (compare(number_at(middle)) >= 0 ? low : high) = middle;
    }
    const int half = compare((number_at(low) + number_at(high)) / 2);
    return double_at(half < 0 || (half == 0 && low % 2 == 0) ? low : high);
}

inline double nearest(const Rational& number) {
    return nearest([&](const Rational& x) { return number.compare(x); });
}

inline Rational floor(const Rational& number) {
    boost::multiprecision::mpz_int whole;
    mpz_fdiv_q(whole.backend().data(), mpq_numref(number.backend().data()),
               mpq_denref(number.backend().data()));
    return Rational(whole);
}

class Polynomial {
 public:
    Polynomial(std::initializer_list<Rational> coefficients)
        : Polynomial(std::vector<Rational>(coefficients)) {}
    /// From the constant one upwards.
    explicit Polynomial(std::vector<Rational> coefficients) : c_(std::move(coefficients)) {
        while (!c_.empty() && c_.back().is_zero()) c_.pop_back();
    }

    bool is_zero() const { return c_.empty(); }
    std::size_t size() const { return c_.size(); }
    Rational coefficient(std::size_t i) const { return i < size() ? c_[i] : Rational(0); }
    int sign_at_infinity() const { return is_zero() ? 0 : c_.back().sign(); }
    Rational operator()(const Rational& t) const {
        Rational value = 0;
        for (std::size_t i = size(); i-- > 0;) value = value * t + c_[i];
        return value;
    }
    int sign(const Rational& t) const { return (*this)(t).sign(); }

    Polynomial derivative() const {
        std::vector<Rational> result;
        for (std::size_t i = 1; i < size(); ++i) result.push_back(c_[i] * i);
        return Polynomial(result);
    }

    friend Polynomial operator+(const Polynomial& p, const Polynomial& q) {
        std::vector<Rational> sum;
        for (std::size_t i = 0; i < std::max(p.size(), q.size()); ++i)
            sum.push_back(p.coefficient(i) + q.coefficient(i));
        return Polynomial(sum);
    }
    friend Polynomial operator*(const Polynomial& p, const Polynomial& q) {
        std::vector<Rational> product(p.size() + q.size());
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p.c_[i] * q.c_[j];
        return Polynomial(product);
    }
    friend Polynomial operator-(const Polynomial& p, const Polynomial& q) {
        return p + Polynomial{-1} * q;
    }

    /// Quotient and remainder.
    static std::pair<Polynomial, Polynomial> divide(const Polynomial& p, const Polynomial& q) {
        Polynomial quotient{}, rest = p;
        while (rest.size() >= q.size()) {
            std::vector<Rational> term(rest.size() - q.size() + 1);
            term.back() = rest.c_.back() / q.c_.back();
            quotient = quotient + Polynomial(term);
            rest = rest - Polynomial(term) * q;
        }
        return {quotient, rest};
    }
    /// With 1 or -1 as its last coefficient: the signs are the same.
    Polynomial scaled() const { return is_zero() ? *this : *this * Polynomial{1 / abs(c_.back())}; }

 private:
    std::vector<Rational> c_;
};

/// The greatest common divisor; that of 0 and 0 is 0. What is 0 at a root of both.
inline Polynomial gcd(Polynomial p, Polynomial q) {
    while (!q.is_zero()) {
        const Polynomial rest = Polynomial::divide(p, q).second;
        p = std::exchange(q, rest.scaled());
    }
    return p.scaled();
}

/// The different real roots of a polynomial other than 0, counted by Sturm's theorem.
class Roots {
 public:
    explicit Roots(const Polynomial& p) : chain_{p} {
        for (Polynomial next = p.derivative(); !next.is_zero();) {
            chain_.push_back(next);
            const Polynomial rest = Polynomial::divide(chain_[chain_.size() - 2], next).second;
            // Its size does not matter, but it would grow.
            next = rest.scaled() * Polynomial{-1};
        }
        const Polynomial common = chain_.back();  // what repeats roots
        for (Polynomial& member : chain_)
            member = Polynomial::divide(member, common).first.scaled();
    }

    /// The polynomial with each of its roots once.
    const Polynomial& square_free() const { return chain_.front(); }
    bool is_root(const Rational& x) const { return chain_.front().sign(x) == 0; }

    /// How many roots are greater than x.
    int beyond(const Rational& x) const {
        return changes([&](const Polynomial& p) { return p.sign(x); }) -
               changes([](const Polynomial& p) { return p.sign_at_infinity(); });
    }

    /// Points of (from, infinity), one in each of the gaps that the roots there leave, in order.
    std::vector<Rational> between(const Rational& from) const {
        Rational step = 1;
        while (beyond(from + step) > 0 || is_root(from + step)) step *= 2;
        std::vector<Rational> points;
        for (int left = beyond(from); left > 0; --left) {
            Rational low = points.empty() ? from : points.back(), high = from + step, middle;
            for (;;) {
                middle = (low + high) / 2;
                const int roots = beyond(middle);
                if (roots == left && !is_root(middle)) break;
                (roots < left ? high : low) = middle;
            }
            points.push_back(middle);
        }
        points.push_back(from + step);
        return points;
    }

    /// The only root between two points that are none.
    double nearest_root(const Rational& low, const Rational& high) const {
        const int after = chain_.front().sign(high);
        return nearest([&](const Rational& x) {
            return x <= low ? 1 : x >= high ? -1 : -after * chain_.front().sign(x);
        });
    }

 private:
    template <class Sign>
    int changes(const Sign& sign_of) const {
        int number = 0, last = 0;
        for (const Polynomial& member : chain_) {
            const int sign = sign_of(member);
            if (sign * last < 0) ++number;
            if (sign != 0) last = sign;
        }
        return number;
    }

    std::vector<Polynomial> chain_;
};

}  // namespace signum::oracle
