#include "polynomial.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "../core/contract.hpp"
#include "nearest_double.hpp"

namespace signum::exact {
namespace {

using Coefficients = std::vector<Integer>;

void trim(Coefficients& c) {
    while (!c.empty() && c.back().is_zero()) c.pop_back();
}

/// Divided by the greatest common divisor of the coefficients.
Polynomial primitive(Coefficients c) {
    Integer common = 0;
    for (const Integer& number : c) common = gcd(common, number);
    if (common > 1)
        for (Integer& number : c) number /= common;
    return {std::move(c), 0};
}

Coefficients derivative_of(const Coefficients& c) {
    Coefficients result;
    for (std::size_t i = 1; i < c.size(); ++i) result.push_back(static_cast<unsigned>(i) * c[i]);
    return result;
}

/// Long division of p by q, not 0: a positive multiple of the remainder, and the quotient times
/// some number.
struct Division {
    Coefficients quotient;
    Coefficients rest;
};
Division divide(const Coefficients& p, const Coefficients& q) {
    const std::size_t size = p.size() < q.size() ? 0 : p.size() - q.size() + 1;
    Division result{Coefficients(size), p};
    const Integer factor = abs(q.back());
    Coefficients& rest = result.rest;
    while (rest.size() >= q.size()) {
        const std::size_t shift = rest.size() - q.size();
        const Integer lead = q.back().sign() < 0 ? Integer(-rest.back()) : rest.back();
        for (Integer& number : result.quotient) number *= factor;
        result.quotient[shift] += lead;
        for (Integer& number : rest) number *= factor;
        for (std::size_t i = 0; i < q.size(); ++i) rest[i + shift] -= lead * q[i];
        trim(rest);
    }
    return result;
}

/// p / q, but for a factor. Precondition: q divides p.
Polynomial quotient(const Polynomial& p, const Polynomial& q) {
    return primitive(divide(p.coefficients(), q.coefficients()).quotient);
}

/// The greatest common divisor of p and its derivative: the roots of p, each once less.
Polynomial repeated(const Polynomial& p) {
    return common_divisor(p, p.derivative());
}

}  // namespace

Polynomial::Polynomial(std::vector<Integer> coefficients, int exponent)
    : c_(std::move(coefficients)), exponent_(exponent) {
    trim(c_);
}

Polynomial::Polynomial(std::span<const Dyadic> coefficients) {
    exponent_ = std::numeric_limits<int>::max();
    for (const Dyadic& number : coefficients)
        if (number.sign() != 0) exponent_ = std::min(exponent_, number.exponent());
    for (const Dyadic& number : coefficients) {
        c_.push_back(number.significand());
        if (number.sign() != 0) c_.back() <<= number.exponent() - exponent_;
    }
    trim(c_);
    if (c_.empty()) exponent_ = 0;
}

Polynomial operator+(const Polynomial& p, const Polynomial& q) {
    if (p.c_.empty()) return q;
    if (q.c_.empty()) return p;
    const int exponent = std::min(p.exponent_, q.exponent_);
    Coefficients sum(std::max(p.c_.size(), q.c_.size()));
    for (const Polynomial* term : {&p, &q})
        for (std::size_t i = 0; i < term->c_.size(); ++i)
            sum[i] += term->c_[i] << (term->exponent_ - exponent);
    return {std::move(sum), exponent};
}

Polynomial operator-(const Polynomial& p, const Polynomial& q) {
    Polynomial negative = q;
    for (Integer& number : negative.c_) number = -number;
    return p + negative;
}

Polynomial operator*(const Polynomial& p, const Polynomial& q) {
    if (p.c_.empty() || q.c_.empty()) return {};
    Coefficients product(p.c_.size() + q.c_.size() - 1);
    for (std::size_t i = 0; i < p.c_.size(); ++i)
        for (std::size_t j = 0; j < q.c_.size(); ++j) product[i + j] += p.c_[i] * q.c_[j];
    return {std::move(product), p.exponent_ + q.exponent_};
}

Polynomial Polynomial::derivative() const {
    return {derivative_of(c_), exponent_};
}

Dyadic Polynomial::value_at(const Dyadic& x) const {
    Dyadic value;
    for (std::size_t i = c_.size(); i-- > 0;) value = value * x + Dyadic(c_[i], exponent_);
    return value;
}

/// At m / 2^k, times 2^(k · degree), by Horner's rule.
Sign Polynomial::sign_at(const Dyadic& x) const {
    if (c_.empty()) return 0;
    Integer m = x.significand();
    if (x.exponent() > 0) m <<= x.exponent();
    const int k = std::max(-x.exponent(), 0);
    Integer value = c_.back();
    int shift = 0;
    for (std::size_t i = c_.size() - 1; i-- > 0;) {
        shift += k;
        value *= m;
        value += c_[i] << shift;
    }
    return value.sign();
}

Polynomial common_divisor(const Polynomial& p, const Polynomial& q) {
    SIGNUM_EXPECTS(p.degree() >= 0 || q.degree() >= 0);
    Polynomial a = primitive(p.coefficients());
    Polynomial b = primitive(q.coefficients());
    while (b.degree() >= 0) {
        Polynomial rest = primitive(divide(a.coefficients(), b.coefficients()).rest);
        a = std::exchange(b, std::move(rest));
    }
    return a;
}

Sign sign_after(Polynomial p, const Dyadic& x) {
    for (; p.degree() >= 0; p = p.derivative())
        if (const Sign sign = p.sign_at(x)) return sign;
    return 0;
}

/// With p repeated k - 1 and k times, the quotient has each root of multiplicity k or more once.
std::vector<Polynomial> square_free_factors(const Polynomial& p) {
    SIGNUM_EXPECTS(p.degree() >= 0);
    std::vector<Polynomial> at_least;
    for (Polynomial rest = p; rest.degree() > 0;) {
        Polynomial next = repeated(rest);
        at_least.push_back(quotient(rest, next));
        rest = std::move(next);
    }
    for (std::size_t k = 0; k + 1 < at_least.size(); ++k)
        at_least[k] = quotient(at_least[k], at_least[k + 1]);
    return at_least;
}

/// Roots that p has once are those of p and of what repeats them, less those that the latter has
/// at least once; to repeat it twice takes two from every multiplicity, which leaves it odd.
Polynomial odd_part(const Polynomial& p) {
    SIGNUM_EXPECTS(p.degree() >= 0);
    const Polynomial twice = repeated(p);
    if (twice.degree() == 0) return p;
    const Polynomial thrice = repeated(twice);
    const Polynomial once = quotient(quotient(p, twice), quotient(twice, thrice));
    return once * odd_part(thrice);
}

Roots::Roots(const Polynomial& p) : chain_{primitive(p.coefficients())} {
    SIGNUM_EXPECTS(p.degree() >= 0);
    Polynomial next = primitive(derivative_of(p.coefficients()));
    while (next.degree() >= 0) {
        chain_.push_back(next);
        Coefficients rest =
            divide(chain_[chain_.size() - 2].coefficients(), next.coefficients()).rest;
        for (Integer& number : rest) number = -number;
        next = primitive(std::move(rest));
    }
    SIGNUM_EXPECTS(chain_.back().degree() == 0);
}

template <class SignOf>
int Roots::changes(const SignOf& sign_of) const {
    int count = 0;
    Sign last = 0;
    for (const Polynomial& member : chain_) {
        const Sign sign = sign_of(member);
        if (sign == 0) continue;
        if (sign == -last) ++count;
        last = sign;
    }
    return count;
}

int Roots::after(const Dyadic& x) const {
    return changes([&](const Polynomial& p) { return p.sign_at(x); }) -
           changes([](const Polynomial& p) { return p.sign_at_infinity(); });
}

int Roots::between(const Dyadic& low, const Dyadic& high) const {
    return after(low) - after(high);
}

/// Roots are counted by how many follow, for which one chain of signs is enough.
std::optional<Roots::Isolated> Roots::isolate(const Dyadic& x, int k) const {
    const int rest = after(x) - k;
    if (rest < 0) return std::nullopt;
    Dyadic step(1.0);
    Isolated root{x, x + step};
    int after_low = rest + k;
    int after_high = after(root.high);
    while (after_high > rest) {
        root.low = root.high;
        after_low = after_high;
        step = 2 * step;
        root.high = x + step;
        after_high = after(root.high);
    }
    return isolate(root, after_low - rest);
}

Roots::Isolated Roots::isolate(const Isolated& within, int k) const {
    Isolated root = within;
    int after_low = after(root.low);
    int after_high = after(root.high);
    const int rest = after_low - k;
    SIGNUM_EXPECTS(after_high <= rest && k > 0);
    while (after_low != rest + 1 || after_high != rest) {
        const Dyadic middle = Dyadic(0.5) * (root.low + root.high);
        const int after_middle = after(middle);
        if (after_middle > rest) {
            root.low = middle;
            after_low = after_middle;
        } else {
            root.high = middle;
            after_high = after_middle;
        }
    }
    return root;
}

/// In (low, high] the sign changes once.
Sign Roots::compare(const Isolated& root, const Dyadic& x) const {
    if (x <= root.low) return 1;
    if (x > root.high) return -1;
    const Sign sign = chain_.front().sign_at(x);
    if (sign == 0) return 0;
    const Sign last = chain_.front().sign_at(root.high);
    return sign == last ? -1 : 1;
}

void Roots::halve(Isolated& root) const {
    const Dyadic middle = Dyadic(0.5) * (root.low + root.high);
    (compare(root, middle) > 0 ? root.low : root.high) = middle;
}

double Roots::nearest_double(const Isolated& root) const {
    return exact::nearest_double([&](const Dyadic& x) { return compare(root, x); });
}

double Roots::nearest_double(const Dyadic& x, int k) const {
    const std::optional<Isolated> root = isolate(x, k);
    return root ? nearest_double(*root) : std::numeric_limits<double>::infinity();
}

}  // namespace signum::exact
