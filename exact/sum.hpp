#pragma once
/// Sums: exact numbers as lists of doubles that nobody adds up, for the thesis's exact sign of a
/// sum. Included by sources only.
///
/// A polynomial in sums is its own expanded form: every product is that of each term of the one
/// factor by each of the other, split without error into two doubles, and sign_of_sum (ESSA)
/// decides the whole list. In the power metric that is all: where the differences of coordinates
/// are doubles in_circle is a sum of 96 terms for points and 144 for circles; where they are sums
/// of two, of up to 1536 and 2304.
///
/// A polynomial of degree 8 would have 10^5 terms, or 10^7. So the factors of a product of more
/// than Sum::most_terms are first added up, each to as few doubles as hold it: in the Euclidean
/// metric the polynomials A and H are expanded from the exact numbers of degree 2 and 4 that they
/// consist of, everything of degree 4 and below from the differences.
///
/// Laws, in the environment of exact/floating_environment.hpp, and while no product of terms
/// overflows and every one is 0 or at least 2^-968 (a window that the caller keeps):
///  1. the number is the exact sum of the terms, which come in any order; none is 0;
///  2. every operation is exact.
/// Source: Gavrilova 1998, section 4.7.2.

#include <compare>
#include <vector>

#include "../core/sign.hpp"

namespace signum::exact {

/// Comparisons of numbers that have a difference and a sign.
template <class Number>
struct ComparedBySign {
    friend bool operator==(const Number& a, const Number& b) { return (a - b).sign() == 0; }
    friend std::weak_ordering operator<=>(const Number& a, const Number& b) {
        return (a - b).sign() <=> 0;
    }
    /// With 0.
    friend bool operator==(const Number& a, int) { return a.sign() == 0; }
    friend std::weak_ordering operator<=>(const Number& a, int) { return a.sign() <=> 0; }
};

class Sum : public ComparedBySign<Sum> {
 public:
    /// A product of more terms is made from factors that are added up.
    static constexpr std::size_t most_terms = 1024;

    /// 0.
    Sum() = default;
    explicit Sum(double number);

    /// A difference of two doubles is one where it can be.
    friend Sum operator+(Sum a, const Sum& b);
    friend Sum operator-(Sum a);
    friend Sum operator-(const Sum& a, const Sum& b) { return -b + a; }
    friend Sum operator*(const Sum& a, const Sum& b);
    friend Sum operator*(int a, const Sum& b) { return Sum(a) * b; }

    /// By ESSA.
    [[nodiscard]] Sign sign() const noexcept;
    [[nodiscard]] std::size_t terms() const noexcept { return terms_.size(); }

 private:
    void append(double term);
    [[nodiscard]] Sum added_up() const;

    std::vector<double> terms_;
};

}  // namespace signum::exact
