#pragma once
/// Integers of any size for oracles: GMP's, whose memory is kept for the next one, so that those of
/// a few words cost some nanoseconds an operation. For programs of one thread.

#include <cstdint>
#include <utility>
#include <vector>

#include <gmp.h>

namespace signum::fuzz {

class Integer {
 public:
    Integer() : limbs_(taken()) { mpz_set_si(limbs_, 0); }
    explicit Integer(std::int64_t value) : limbs_(taken()) { mpz_set_si(limbs_, value); }
    /// value · 2^shift
    Integer(std::int64_t value, std::uint64_t shift) : Integer(value) {
        mpz_mul_2exp(limbs_, limbs_, shift);
    }
    Integer(const Integer& other) : limbs_(taken()) { mpz_set(limbs_, other.limbs_); }
    Integer(Integer&& other) noexcept : limbs_(std::exchange(other.limbs_, nullptr)) {}
    Integer& operator=(const Integer& other) {
        if (limbs_ == nullptr) limbs_ = taken();
        mpz_set(limbs_, other.limbs_);
        return *this;
    }
    Integer& operator=(Integer&& other) noexcept {
        std::swap(limbs_, other.limbs_);
        return *this;
    }
    ~Integer() {
        if (limbs_ != nullptr) kept().push_back(limbs_);
    }

    [[nodiscard]] int sign() const { return mpz_sgn(limbs_); }
    [[nodiscard]] std::uint64_t bits() const { return mpz_sizeinbase(limbs_, 2); }

    friend Integer operator+(const Integer& a, const Integer& b) {
        Integer result(nothing);
        mpz_add(result.limbs_, a.limbs_, b.limbs_);
        return result;
    }
    friend Integer operator-(const Integer& a, const Integer& b) {
        Integer result(nothing);
        mpz_sub(result.limbs_, a.limbs_, b.limbs_);
        return result;
    }
    friend Integer operator*(const Integer& a, const Integer& b) {
        Integer result(nothing);
        mpz_mul(result.limbs_, a.limbs_, b.limbs_);
        return result;
    }
    friend Integer operator<<(const Integer& a, std::uint64_t shift) {
        Integer result(nothing);
        mpz_mul_2exp(result.limbs_, a.limbs_, shift);
        return result;
    }
    friend Integer operator-(Integer a) {
        mpz_neg(a.limbs_, a.limbs_);
        return a;
    }
    Integer& operator+=(const Integer& other) {
        mpz_add(limbs_, limbs_, other.limbs_);
        return *this;
    }
    Integer& operator-=(const Integer& other) {
        mpz_sub(limbs_, limbs_, other.limbs_);
        return *this;
    }
    Integer& add_product(const Integer& a, const Integer& b) {
        mpz_addmul(limbs_, a.limbs_, b.limbs_);
        return *this;
    }
    Integer& subtract_product(const Integer& a, const Integer& b) {
        mpz_submul(limbs_, a.limbs_, b.limbs_);
        return *this;
    }
    friend bool operator<(const Integer& a, const Integer& b) {
        return mpz_cmp(a.limbs_, b.limbs_) < 0;
    }
    friend bool operator==(const Integer& a, const Integer& b) {
        return mpz_cmp(a.limbs_, b.limbs_) == 0;
    }

 private:
    struct Nothing {};
    static constexpr Nothing nothing{};
    explicit Integer(Nothing) : limbs_(taken()) {}

    /// Never freed: a program of oracles needs a few hundred.
    [[nodiscard]] static std::vector<mpz_ptr>& kept() {
        static auto* const all = new std::vector<mpz_ptr>();
        return *all;
    }
    [[nodiscard]] static mpz_ptr taken() {
        std::vector<mpz_ptr>& all = kept();
        if (all.empty()) {
            auto* const made = new __mpz_struct;
            mpz_init2(made, 512);
            return made;
        }
        const mpz_ptr last = all.back();
        all.pop_back();
        return last;
    }

    mpz_ptr limbs_;
};

/// a·d - b·c
[[nodiscard]] inline Integer minor(const Integer& a, const Integer& b, const Integer& c,
                                   const Integer& d) {
    Integer result = a * d;
    result.subtract_product(b, c);
    return result;
}

/// The sign of a + b √s. Precondition: s >= 0.
[[nodiscard]] inline int sign_with_root(const Integer& a, const Integer& b, const Integer& s) {
    const int of_b = s.sign() == 0 ? 0 : b.sign();
    const int of_a = a.sign();
    if (of_a == 0 || of_b == 0 || of_a == of_b) return of_a != 0 ? of_a : of_b;
    Integer difference = a * a;
    difference.subtract_product(b * b, s);
    return of_a * difference.sign();
}

}  // namespace signum::fuzz
