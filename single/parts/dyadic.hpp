/// Dyadic numbers m·2^e: what doubles are, and all their sums and products. m is an integer of the
/// greatest size that the machine has while that surely holds it, and of any size otherwise.
/// Every operation is exact, and done in integers: no rounding mode, no flushing of denormals.

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace signum::exact {

/// Comparisons of numbers that have a difference and a sign.
template <class Number>
struct ComparedBySign {
    friend bool operator==(const Number& a, const Number& b) { return (a - b).sign() == 0; }
    friend bool operator<(const Number& a, const Number& b) { return (a - b).sign() < 0; }
    friend bool operator>(const Number& a, const Number& b) { return (a - b).sign() > 0; }
    friend bool operator<=(const Number& a, const Number& b) { return (a - b).sign() <= 0; }
    friend bool operator>=(const Number& a, const Number& b) { return (a - b).sign() >= 0; }
    friend bool operator==(const Number& a, int) { return a.sign() == 0; }
    friend bool operator!=(const Number& a, int) { return a.sign() != 0; }
    friend bool operator<(const Number& a, int) { return a.sign() < 0; }
    friend bool operator>(const Number& a, int) { return a.sign() > 0; }
    friend bool operator<=(const Number& a, int) { return a.sign() <= 0; }
    friend bool operator>=(const Number& a, int) { return a.sign() >= 0; }
};

/// Integers of any size: a sign, and digits to the base 2^32, the least first, the last one not 0.
class Natural {
 public:
    using Digits = std::vector<std::uint32_t>;

    [[nodiscard]] static Digits of(std::uint64_t low, std::uint64_t high) {
        Digits digits = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
                         static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(high >> 32)};
        trim(digits);
        return digits;
    }
    /// -1, 0, +1: which is the greater.
    [[nodiscard]] static int compare(const Digits& a, const Digits& b) noexcept {
        if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
        for (std::size_t k = a.size(); k-- > 0;)
            if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
        return 0;
    }
    [[nodiscard]] static Digits shifted(const Digits& a, int bits) {
        if (a.empty()) return a;
        const auto words = static_cast<std::size_t>(bits / 32);
        const int rest = bits % 32;
        Digits result(words + a.size() + 1);
        for (std::size_t k = 0; k < a.size(); ++k) {
            const std::uint64_t wide = std::uint64_t{a[k]} << rest;
            result[words + k] |= static_cast<std::uint32_t>(wide);
            result[words + k + 1] = static_cast<std::uint32_t>(wide >> 32);
        }
        trim(result);
        return result;
    }
    [[nodiscard]] static Digits sum(const Digits& a, const Digits& b) {
        const Digits& longer = a.size() < b.size() ? b : a;
        const Digits& shorter = a.size() < b.size() ? a : b;
        Digits result(longer.size() + 1);
        std::uint64_t carry = 0;
        for (std::size_t k = 0; k < longer.size(); ++k) {
            carry += std::uint64_t{longer[k]} + (k < shorter.size() ? shorter[k] : 0U);
            result[k] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        result[longer.size()] = static_cast<std::uint32_t>(carry);
        trim(result);
        return result;
    }
    /// Precondition: a >= b.
    [[nodiscard]] static Digits difference(const Digits& a, const Digits& b) {
        Digits result(a.size());
        std::int64_t borrow = 0;
        for (std::size_t k = 0; k < a.size(); ++k) {
            borrow += std::int64_t{a[k]} - (k < b.size() ? std::int64_t{b[k]} : 0);
            result[k] = static_cast<std::uint32_t>(borrow);
            borrow >>= 32;
        }
        trim(result);
        return result;
    }
    [[nodiscard]] static Digits product(const Digits& a, const Digits& b) {
        Digits result(a.size() + b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            std::uint64_t carry = 0;
            for (std::size_t k = 0; k < b.size(); ++k) {
                carry += std::uint64_t{a[i]} * b[k] + result[i + k];
                result[i + k] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            result[i + b.size()] = static_cast<std::uint32_t>(carry);
        }
        trim(result);
        return result;
    }

 private:
    static void trim(Digits& digits) noexcept {
        while (!digits.empty() && digits.back() == 0) digits.pop_back();
    }
};

/// What it does is out of line and never throws: the predicates that ask it stay short.
class Dyadic : public ComparedBySign<Dyadic> {
#if defined(__SIZEOF_INT128__)
    using Small = __int128;
    using Magnitude = unsigned __int128;
#else
    using Small = std::int64_t;
    using Magnitude = std::uint64_t;
#endif
    using Digits = Natural::Digits;

 public:
    /// 0.
    Dyadic() noexcept = default;
    [[gnu::noinline]] Dyadic(const Dyadic& other) noexcept = default;
    Dyadic(Dyadic&& other) noexcept = default;
    [[gnu::noinline]] Dyadic& operator=(const Dyadic& other) noexcept = default;
    Dyadic& operator=(Dyadic&& other) noexcept = default;
    [[gnu::noinline]] ~Dyadic() = default;
    /// Precondition: the number is finite.
    [[gnu::noinline]] explicit Dyadic(double number) noexcept {
        const Parts of_number = parts(number);
        small_ = static_cast<Small>(of_number.significand);
        if (of_number.negative) small_ = -small_;
        exponent_ = of_number.exponent;
    }

    [[gnu::noinline]] friend Dyadic operator-(Dyadic a) noexcept {
        a.small_ = -a.small_;
        a.is_negative_ = !a.is_negative_;
        return a;
    }
    /// Small where both numbers, as multiples of one power of two, are below half of the greatest.
    [[gnu::noinline]] friend Dyadic operator+(const Dyadic& a, const Dyadic& b) noexcept {
        if (b.sign() == 0) return a;
        if (a.sign() == 0) return b;
        const Dyadic& coarse = a.exponent_ < b.exponent_ ? b : a;
        const Dyadic& fine = a.exponent_ < b.exponent_ ? a : b;
        const int shift = coarse.exponent_ - fine.exponent_;
        if (coarse.bits() + shift <= most_bits - 1 && fine.bits() <= most_bits - 1)
            return {(coarse.small_ * (Small{1} << shift)) + fine.small_, fine.exponent_};
        const Digits one = Natural::shifted(coarse.digits(), shift);
        const Digits other = fine.digits();
        const bool is_negative = coarse.sign() < 0;
        if (is_negative == (fine.sign() < 0))
            return {Natural::sum(one, other), is_negative, fine.exponent_};
        return Natural::compare(one, other) >= 0
                   ? Dyadic(Natural::difference(one, other), is_negative, fine.exponent_)
                   : Dyadic(Natural::difference(other, one), !is_negative, fine.exponent_);
    }
    [[gnu::noinline]] friend Dyadic operator-(const Dyadic& a, const Dyadic& b) noexcept {
        return a + -b;
    }
    Dyadic& operator+=(const Dyadic& other) noexcept {
        return *this = *this + other;
    }
    [[gnu::noinline]] friend Dyadic operator*(const Dyadic& a, const Dyadic& b) noexcept {
        if (a.bits() + b.bits() <= most_bits)
            return {a.small_ * b.small_, a.exponent_ + b.exponent_};
        return {Natural::product(a.digits(), b.digits()), (a.sign() < 0) != (b.sign() < 0),
                a.exponent_ + b.exponent_};
    }
    friend Dyadic operator*(int a, const Dyadic& b) noexcept {
        return Dyadic(Small{a}, 0) * b;
    }

    [[nodiscard]] Sign sign() const noexcept {
        if (!large_.empty()) return is_negative_ ? -1 : 1;
        return static_cast<int>(small_ > 0) - static_cast<int>(small_ < 0);
    }

 private:
    /// The magnitude of a small number is below 2^most_bits.
    static constexpr int most_bits = 8 * static_cast<int>(sizeof(Small)) - 1;

    Dyadic(Small m, int exponent) noexcept : small_(m), exponent_(exponent) {}
    /// An empty list of digits is the number 0.
    Dyadic(Digits digits, bool is_negative, int exponent)
        : exponent_(exponent), is_negative_(is_negative), large_(std::move(digits)) {}

    [[nodiscard]] Magnitude magnitude() const noexcept {
        return small_ < 0 ? -static_cast<Magnitude>(small_) : static_cast<Magnitude>(small_);
    }
    [[nodiscard]] Digits digits() const {
        if (!large_.empty()) return large_;
        const Magnitude m = magnitude();
#if defined(__SIZEOF_INT128__)
        return Natural::of(static_cast<std::uint64_t>(m), static_cast<std::uint64_t>(m >> 64));
#else
        return Natural::of(m, 0);
#endif
    }
    /// The magnitude of m is below 2^bits(); more than most_bits where m is large.
    [[nodiscard]] int bits() const noexcept {
        if (!large_.empty()) return most_bits + 1;
        const Magnitude m = magnitude();
#if defined(__SIZEOF_INT128__)
        const auto high = static_cast<std::uint64_t>(m >> 64);
        if (high != 0) return 64 + std::bit_width(high);
#endif
        return std::bit_width(static_cast<std::uint64_t>(m));
    }

    Small small_ = 0;  // m, unless it is large
    int exponent_ = 0;
    bool is_negative_ = false;  // of a large one
    Digits large_;
};

}  // namespace signum::exact
