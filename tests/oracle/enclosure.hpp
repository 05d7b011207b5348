#pragma once
/// Enclosures of real numbers: lo·2^e <= x <= hi·2^e, rounded outward to a precision that the
/// caller raises until a sign is certain. Big integers only, so exponents never overflow and an
/// enclosure of 1 - 2^-100000 costs no more than one of 1/3.

#include <boost/multiprecision/gmp.hpp>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <utility>

namespace signum::oracle {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Thrown by a comparison that needs more precision.
struct Undecided {};

class Enclosure {
 public:
    /// Bits kept by every operation that rounds.
    static inline thread_local std::int64_t precision = 64;

    Enclosure() = default;
    Enclosure(int n) : Enclosure(Integer{n}, Integer{n}, 0) {}
    /// The number n·2^exponent.
    explicit Enclosure(const Integer& n, std::int64_t exponent = 0) : Enclosure(n, n, exponent) {}

    /// The sign, which must not be 0: throws Undecided while the enclosure contains 0 and
    /// std::logic_error when the number is exactly 0.
    int sign() const {
        if (lo_ > 0) return 1;
        if (hi_ < 0) return -1;
        if (is_zero()) throw std::logic_error("enclosure: a sign is 0 where none may be");
        throw Undecided{};
    }

    /// Certainly 0.
    bool is_zero() const { return lo_ == 0 && hi_ == 0; }

    friend Enclosure operator-(const Enclosure& a) { return {-a.hi_, -a.lo_, a.exponent_}; }

    friend Enclosure operator+(const Enclosure& a, const Enclosure& b) {
        if (a.bits() == 0) return b;
        if (b.bits() == 0) return a;
        // A grid fine enough for the precision, and not much finer.
        const std::int64_t top = std::max(a.exponent_ + a.bits(), b.exponent_ + b.bits());
        const std::int64_t grid = std::max(std::min(a.exponent_, b.exponent_), top - precision - 4);
        return {down(a.lo_, a.exponent_ - grid) + down(b.lo_, b.exponent_ - grid),
                up(a.hi_, a.exponent_ - grid) + up(b.hi_, b.exponent_ - grid), grid};
    }

    friend Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + (-b); }

    friend Enclosure operator*(const Enclosure& a, const Enclosure& b) {
        const std::int64_t exponent = a.exponent_ + b.exponent_;
        if (a.lo_ >= 0 && b.lo_ >= 0) return {a.lo_ * b.lo_, a.hi_ * b.hi_, exponent};
        const auto [lo, hi] =
            std::minmax({a.lo_ * b.lo_, a.lo_ * b.hi_, a.hi_ * b.lo_, a.hi_ * b.hi_});
        return {lo, hi, exponent};
    }

    friend Enclosure operator/(const Enclosure& a, const Enclosure& b) {
        b.sign();
        const std::int64_t shift = precision + b.bits() + 2;
        const Integer lo = a.lo_ << shift;
        const Integer hi = a.hi_ << shift;
        return {std::min({floor_of(lo, b.lo_), floor_of(lo, b.hi_), floor_of(hi, b.lo_),
                          floor_of(hi, b.hi_)}),
                std::max({ceiling_of(lo, b.lo_), ceiling_of(lo, b.hi_), ceiling_of(hi, b.lo_),
                          ceiling_of(hi, b.hi_)}),
                a.exponent_ - b.exponent_ - shift};
    }

    /// Of a number known to be positive.
    friend Enclosure sqrt(const Enclosure& a) {
        if (a.sign() < 0) throw std::logic_error("enclosure: square root of a negative number");
        std::int64_t shift = 2 * precision;
        if ((a.exponent_ - shift) % 2 != 0) ++shift;
        Integer lo;
        Integer hi;
        const Integer low = a.lo_ << shift;
        const Integer high = a.hi_ << shift;
        mpz_sqrt(lo.backend().data(), low.backend().data());
        mpz_sqrt(hi.backend().data(), high.backend().data());
        return {lo, hi + 1, (a.exponent_ - shift) / 2};
    }

 private:
    Integer lo_ = 0;
    Integer hi_ = 0;
    std::int64_t exponent_ = 0;

    Enclosure(Integer lo, Integer hi, std::int64_t exponent)
        : lo_(std::move(lo)), hi_(std::move(hi)), exponent_(exponent) {
        const std::int64_t excess = bits() - precision;
        if (excess <= 0) return;
        lo_ = down(lo_, -excess);
        hi_ = up(hi_, -excess);
        exponent_ += excess;
    }

    /// Bits of the larger end, 0 for the number 0.
    std::int64_t bits() const { return std::max(bits_of(lo_), bits_of(hi_)); }
    static std::int64_t bits_of(const Integer& n) {
        return n == 0 ? 0 : static_cast<std::int64_t>(mpz_sizeinbase(n.backend().data(), 2));
    }

    /// n·2^shift, rounded down (up) to an integer.
    static Integer down(const Integer& n, std::int64_t shift) {
        if (shift >= 0) return n << shift;
        Integer result;
        mpz_fdiv_q_2exp(result.backend().data(), n.backend().data(),
                        static_cast<mp_bitcnt_t>(-shift));
        return result;
    }
    static Integer up(const Integer& n, std::int64_t shift) { return -down(-n, shift); }

    static Integer floor_of(const Integer& n, const Integer& d) {
        Integer result;
        mpz_fdiv_q(result.backend().data(), n.backend().data(), d.backend().data());
        return result;
    }
    static Integer ceiling_of(const Integer& n, const Integer& d) { return -floor_of(-n, d); }
};

}  // namespace signum::oracle
