#pragma once
/// Numbers for the oracles: a rational and, behind it, rational multiples of infinitesimals, one
/// for each site. This is the tie rule taken at its word (docs: every radius or weight is reduced
/// by its own infinitesimal, infinitely larger for the later site); no rule derived from it is
/// used.

#include <boost/multiprecision/gmp.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace signum::oracle {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

/// Every finite double, denormals included, without rounding.
inline Rational exactly(double value) {
    if (!std::isfinite(value)) throw std::invalid_argument("oracle: a number is not finite");
    return Rational(value);
}

/// a + sum of c_m e_m, where e_m > 0 is the infinitesimal of the m-th site in the tie order: below
/// every positive rational, and e_m above every multiple of e_(m-1). There is no product of two
/// forms: nothing the oracles ask needs one.
class LinearForm {
 public:
    LinearForm() = default;
    explicit LinearForm(Rational value) : value_(std::move(value)) {}

    static LinearForm infinitesimal(std::size_t rank) {
        LinearForm form;
        form.coefficients_.emplace(rank, 1);
        return form;
    }

    LinearForm& operator+=(const LinearForm& other) {
        value_ += other.value_;
        for (const auto& [rank, coefficient] : other.coefficients_)
            coefficients_[rank] += coefficient;
        return *this;
    }
    LinearForm& operator-=(const LinearForm& other) {
        value_ -= other.value_;
        for (const auto& [rank, coefficient] : other.coefficients_)
            coefficients_[rank] -= coefficient;
        return *this;
    }
    LinearForm& operator*=(const Rational& factor) {
        value_ *= factor;
        for (auto& [rank, coefficient] : coefficients_) coefficient *= factor;
        return *this;
    }
    friend LinearForm operator+(LinearForm a, const LinearForm& b) { return std::move(a += b); }
    friend LinearForm operator-(LinearForm a, const LinearForm& b) { return std::move(a -= b); }
    friend LinearForm operator*(LinearForm a, const Rational& b) { return std::move(a *= b); }

    const Rational& value() const { return value_; }

    /// The value decides, then the coefficient of the largest infinitesimal, and so on; 0 only when
    /// all of them are 0.
    int sign() const {
        if (!value_.is_zero()) return value_.sign();
        for (const auto& [rank, coefficient] : coefficients_)
            if (!coefficient.is_zero()) return coefficient.sign();
        return 0;
    }
    friend bool operator<(const LinearForm& a, const LinearForm& b) { return (a - b).sign() < 0; }

 private:
    Rational value_ = 0;
    std::map<std::size_t, Rational, std::greater<>> coefficients_;  // the largest comes first
};

/// Is a < b, for two forms that the tie rule promises to tell apart?
inline bool less(const LinearForm& a, const LinearForm& b) {
    const int sign = (a - b).sign();
    if (sign == 0) throw std::logic_error("oracle: the tie rule does not decide");
    return sign < 0;
}

/// What the tie order looks at: falling size (radius or weight), rising x, rising y, index.
struct TieKey {
    Rational size;
    Rational x;
    Rational y;
};

/// The rank of each site: how many others precede it in the tie order.
inline std::vector<std::size_t> tie_ranks(const std::vector<TieKey>& keys) {
    const auto precedes = [&](std::size_t a, std::size_t b) {
        if (keys[a].size != keys[b].size) return keys[a].size > keys[b].size;
        if (keys[a].x != keys[b].x) return keys[a].x < keys[b].x;
        if (keys[a].y != keys[b].y) return keys[a].y < keys[b].y;
        return a < b;
    };
    std::vector<std::size_t> ranks(keys.size(), 0);
    for (std::size_t a = 0; a < keys.size(); ++a)
        for (std::size_t b = 0; b < keys.size(); ++b)
            if (precedes(a, b)) ++ranks[b];
    return ranks;
}

}  // namespace signum::oracle
