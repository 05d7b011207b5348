#include "real_roots.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace signum::oracle {
namespace {

void trim(IntegerPolynomial& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
}

IntegerPolynomial primitive(IntegerPolynomial p) {
    trim(p);
    mpz_class common = 0;
    for (const mpz_class& c : p) common = gcd(common, c);
    if (common > 1)
        for (mpz_class& c : p) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), common.get_mpz_t());
    return p;
}

IntegerPolynomial derivative(const IntegerPolynomial& p) {
    IntegerPolynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned>(i));
    return result;
}

/// The remainder of p by q but for a factor.
IntegerPolynomial rest(IntegerPolynomial p, const IntegerPolynomial& q) {
    while (p.size() >= q.size()) {
        const mpz_class lead = p.back();
        const std::size_t shift = p.size() - q.size();
        for (mpz_class& c : p) c *= q.back();
        for (std::size_t i = 0; i < q.size(); ++i) p[i + shift] -= lead * q[i];
        p = primitive(std::move(p));
    }
    return p;
}

IntegerPolynomial common_divisor(IntegerPolynomial p, IntegerPolynomial q) {
    p = primitive(std::move(p));
    q = primitive(std::move(q));
    while (!q.empty()) {
        IntegerPolynomial next = rest(p, q);
        p = std::move(q);
        q = std::move(next);
    }
    return p;
}

/// p / q, which is one of integers where q is primitive and divides p.
IntegerPolynomial quotient(IntegerPolynomial p, const IntegerPolynomial& q) {
    trim(p);
    if (p.empty()) return p;
    IntegerPolynomial result(p.size() - q.size() + 1);
    for (std::size_t i = result.size(); i-- > 0;) {
        result[i] = p[i + q.size() - 1] / q.back();
        for (std::size_t j = 0; j < q.size(); ++j) p[i + j] -= result[i] * q[j];
    }
    return result;
}

/// Yun's algorithm: the k-th factor, from 1, has the roots of multiplicity k.
std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& polynomial) {
    const IntegerPolynomial p = primitive(polynomial);
    std::vector<IntegerPolynomial> factors;
    const IntegerPolynomial repeated = common_divisor(p, derivative(p));
    IntegerPolynomial b = quotient(p, repeated);
    IntegerPolynomial d = quotient(derivative(p), repeated) - derivative(b);
    while (b.size() > 1) {
        trim(d);
        const IntegerPolynomial factor = d.empty() ? primitive(b) : common_divisor(b, d);
        factors.push_back(factor);
        b = quotient(b, factor);
        d = d.empty() ? d : quotient(d, factor) - derivative(b);
    }
    return factors;
}

/// p(x + 1)
IntegerPolynomial shifted(IntegerPolynomial p) {
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t j = p.size() - 1; j-- > i;) p[j] += p[j + 1];
    return p;
}

/// Descartes' bound on the roots in (0, 1): the changes of sign of (x + 1)^n p(1 / (x + 1)).
int bound_between_0_and_1(const IntegerPolynomial& p) {
    const IntegerPolynomial q = shifted({p.rbegin(), p.rend()});
    int changes = 0;
    int last = 0;
    for (const mpz_class& c : q) {
        if (sgn(c) == 0) continue;
        changes += static_cast<int>(sgn(c) == -last);
        last = sgn(c);
    }
    return changes;
}

mpq_class power_of_two(int exponent) {
    mpq_class result = 1;
    if (exponent >= 0) {
        mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return result;
}

}  // namespace

IntegerPolynomial operator+(const IntegerPolynomial& p, const IntegerPolynomial& q) {
    IntegerPolynomial sum(std::max(p.size(), q.size()));
    for (std::size_t i = 0; i < p.size(); ++i) sum[i] += p[i];
    for (std::size_t i = 0; i < q.size(); ++i) sum[i] += q[i];
    return sum;
}

IntegerPolynomial operator-(const IntegerPolynomial& p, const IntegerPolynomial& q) {
    IntegerPolynomial negative = q;
    for (mpz_class& c : negative) c = -c;
    return p + negative;
}

IntegerPolynomial operator*(const IntegerPolynomial& p, const IntegerPolynomial& q) {
    if (p.empty() || q.empty()) return {};
    IntegerPolynomial product(p.size() + q.size() - 1);
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < q.size(); ++j) product[i + j] += p[i] * q[j];
    return product;
}

int sign_at(const IntegerPolynomial& p, const mpq_class& x) {
    mpz_class value = 0;
    mpz_class scale = 1;
    for (std::size_t i = p.size(); i-- > 0;) {
        value = value * x.get_num() + p[i] * scale;
        scale *= x.get_den();
    }
    return sgn(value);
}

RealRoots::RealRoots(const std::vector<IntegerPolynomial>& polynomials)
    : polynomials_(polynomials), product_{1} {
    for (const IntegerPolynomial& p : polynomials) {
        factors_.push_back(square_free_factors(p));
        for (const IntegerPolynomial& factor : factors_.back())
            product_ = product_ * quotient(factor, common_divisor(factor, product_));
    }
    product_ = primitive(product_);
    slope_ = derivative(product_);

    // All roots are below 2^bound: Cauchy.
    std::size_t bits = 0;
    for (const mpz_class& c : product_) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
    const auto bound = static_cast<int>(bits) -
                       static_cast<int>(mpz_sizeinbase(product_.back().get_mpz_t(), 2)) + 2;
    // Of 2^bound (2x - 1), with roots in (0, 1).
    IntegerPolynomial p = product_;
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] <<= static_cast<mp_bitcnt_t>(static_cast<int>(i) * std::max(bound, 0));
    // x -> 2x - 1 = 2 (x - 1) + 1: first x + 1 with the signs of odd powers turned twice.
    for (std::size_t i = 1; i < p.size(); i += 2) p[i] = -p[i];
    p = shifted(p);
    for (std::size_t i = 1; i < p.size(); i += 2) p[i] = -p[i];
    for (std::size_t i = 0; i < p.size(); ++i) p[i] <<= static_cast<mp_bitcnt_t>(i);
    const mpq_class half = power_of_two(std::max(bound, 0));
    isolate(p, -half, 2 * half);

    // So that there is a gap between any two: an end may be the root beside it.
    for (Isolated& root : roots_)
        while (root.low < root.high && (oracle::sign_at(product_, root.low) == 0 ||
                                        oracle::sign_at(product_, root.high) == 0))
            halve(root);
    for (std::size_t i = 1; i < roots_.size(); ++i)
        while (roots_[i - 1].high >= roots_[i].low) {
            halve(roots_[i - 1]);
            halve(roots_[i]);
        }
    nearest_.resize(roots_.size());
}

/// p, of x in (0, 1), is the product at low + width x.
void RealRoots::isolate(const IntegerPolynomial& p, const mpq_class& low, const mpq_class& width) {
    const int bound = bound_between_0_and_1(p);
    if (bound == 0) return;
    if (bound == 1) {
        roots_.push_back({low, low + width, 0});
        return;
    }
    IntegerPolynomial left = p;
    const std::size_t degree = p.size() - 1;
    for (std::size_t i = 0; i <= degree; ++i) left[i] <<= static_cast<mp_bitcnt_t>(degree - i);
    IntegerPolynomial right = shifted(left);
    const mpq_class half = width / 2;
    isolate(left, low, half);
    if (right.front() == 0) roots_.push_back({low + half, low + half, 0});
    isolate(right, low + half, half);
}

int RealRoots::sign_right_of(const mpq_class& x) const {
    const int sign = oracle::sign_at(product_, x);
    return sign != 0 ? sign : oracle::sign_at(slope_, x);
}

void RealRoots::halve(Isolated& root) const {
    if (root.low == root.high) return;
    if (root.sign == 0) root.sign = sign_right_of(root.low);
    const mpq_class middle = (root.low + root.high) / 2;
    const int sign = oracle::sign_at(product_, middle);
    if (sign == 0) {
        root = {middle, middle, 0};
    } else if (sign == root.sign) {
        root.low = middle;
    } else {
        root.high = middle;
    }
}

int RealRoots::multiplicity(int i, int polynomial) const {
    const Isolated& root = roots_[static_cast<std::size_t>(i)];
    const auto& factors = factors_[static_cast<std::size_t>(polynomial)];
    for (std::size_t k = 0; k < factors.size(); ++k) {
        const int below = oracle::sign_at(factors[k], root.low);
        const int above = oracle::sign_at(factors[k], root.high);
        if (below == 0 || below != above) return static_cast<int>(k) + 1;
    }
    return 0;
}

int RealRoots::sign_at(int i, int polynomial) const {
    return multiplicity(i, polynomial) > 0 ? 0 : sign_after(i, polynomial);
}

int RealRoots::sign_after(int i, int polynomial) const {
    const auto place = static_cast<std::size_t>(i);
    mpq_class between = roots_[place].high;
    if (roots_[place].low == between)
        between = place + 1 == roots_.size() ? mpq_class(between + 1)
                                             : mpq_class((between + roots_[place + 1].low) / 2);
    return oracle::sign_at(polynomials_[static_cast<std::size_t>(polynomial)], between);
}

int RealRoots::compare(int i, const mpq_class& x) const {
    return compare(roots_[static_cast<std::size_t>(i)], x);
}

int RealRoots::compare(const Isolated& root, const mpq_class& x) const {
    if (root.low == root.high) return sgn(mpq_class(root.low - x));
    if (x <= root.low) return 1;
    if (x >= root.high) return -1;
    const int sign = oracle::sign_at(product_, x);
    if (sign == 0) return 0;
    return sign == sign_right_of(root.low) ? 1 : -1;
}

double RealRoots::nearest_double(int i) const {
    std::optional<double>& nearest = nearest_[static_cast<std::size_t>(i)];
    if (!nearest) nearest = round(roots_[static_cast<std::size_t>(i)]);
    return *nearest;
}

double RealRoots::round(Isolated root) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double most = std::numeric_limits<double>::max();
    // Infinity counts as 2^1024.
    const auto number = [](double x) {
        if (std::isinf(x)) return mpq_class(x > 0 ? power_of_two(1024) : -power_of_two(1024));
        return mpq_class(x);
    };
    const mpq_class least = power_of_two(-1080);
    const mpq_class unit = power_of_two(-60);
    while (root.high - root.low > least && root.high - root.low > unit * abs(root.low)) halve(root);
    double x = abs(root.low) >= power_of_two(1024) ? std::copysign(most, sgn(root.low))
                                                   : mpq_get_d(root.low.get_mpq_t());
    const auto even = [](double y) { return std::bit_cast<std::uint64_t>(y) % 2 == 0; };
    for (;;) {
        if (std::isinf(x)) return x;
        const double next = std::nextafter(x, infinity);
        const double last = std::nextafter(x, -infinity);
        const int above = compare(root, (number(x) + number(next)) / 2);
        const int below = compare(root, (number(last) + number(x)) / 2);
        if (above > 0) {
            x = next;
        } else if (below < 0) {
            x = last;
        } else if (above == 0) {
            return even(x) ? x : next;
        } else if (below == 0) {
            return even(x) ? x : last;
        } else {
            return x;
        }
    }
}

}  // namespace signum::oracle
