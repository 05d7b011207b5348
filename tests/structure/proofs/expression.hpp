#pragma once
/// A number that writes down how it is computed: a filter's own formula, evaluated on it, is what
/// is proved.
///
/// For each result it keeps, computed being what the machine has and exact what the formula means:
///     |computed - exact| <= error · magnitude + underflow
///     |exact| <= magnitude <= size
/// The magnitude is a polynomial in the magnitudes of *atoms*, which are inputs and sums and
/// differences of two of them; the error is a number; size and underflow are polynomials, too, the
/// latter in units of 2^-1074. Every step from error to error is noted, for gappa to prove.

#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include "polynomial.hpp"

namespace signum::proofs {

/// Numbers in units of 2^-80, rounded upwards.
using Units = unsigned long long;
inline constexpr long double unit = 0x1p-80L;
/// What one operation may err by, in any rounding mode.
inline constexpr Units rounding = Units{1} << 28;

/// One operation on numbers with errors so great: what its result's error is.
struct Step {
    char operation;
    Units left;
    Units right;
    Units result;

    friend auto operator<=>(const Step&, const Step&) = default;
};

/// What is noted of one filter: its steps, and the atoms by name.
struct Notes {
    std::set<Step> steps;
    std::map<std::string, int> atoms;
    std::map<int, Monomial> sizes;
    /// What an atom is bounded by: variables of the size polynomials.
    Monomial (*size_of_atom)(const std::string& name) = nullptr;
    /// The name of what an atom stands for; those of one name are bounded by one number, the
    /// greatest of them.
    std::string (*kind_of_atom)(const std::string& name) = nullptr;
};
inline Notes* notes = nullptr;

class Expression {
 public:
    Expression() = default;
    /// An input, told by its value (see input()), or 0.
    explicit Expression(double value) {
        if (value != 0) *this = Expression(input_name(value < 0 ? -value : value));
    }
    /// A factor of a formula.
    explicit Expression(int factor) : Expression(constant(factor)) {}
    [[nodiscard]] static Expression constant(double value) {
        Expression result;
        result.magnitude_[{}] = value;
        result.size_ = result.magnitude_;
        return result;
    }

    friend Expression operator-(const Expression& a) { return a; }
    friend Expression magnitude(const Expression& a) { return a; }
    friend Expression operator+(const Expression& a, const Expression& b) { return sum(a, b, '+'); }
    friend Expression operator-(const Expression& a, const Expression& b) { return sum(a, b, '-'); }
    friend Expression operator*(const Expression& a, const Expression& b) {
        Expression result;
        result.magnitude_ = a.magnitude_ * b.magnitude_;
        result.size_ = a.size_ * b.size_;
        result.underflow_ = a.size_ * b.underflow_ + b.size_ * a.underflow_;
        result.underflow_ = 1.001L * (result.underflow_ + Polynomial{{{}, 1.0L}});
        result.error_ = note('*', a.error_, b.error_);
        return result;
    }
    friend Expression operator*(double a, const Expression& b) { return constant(a) * b; }
    /// Of magnitudes that are bounded by the same.
    friend Expression max(const Expression& a, const Expression& b) {
        if (a.magnitude_ != b.magnitude_) throw std::logic_error("a maximum of different kinds");
        return a.error_ < b.error_ ? b : a;
    }
    friend Expression operator+(const Expression& a, double b) { return a + constant(b); }

    [[nodiscard]] Units error() const { return error_; }
    [[nodiscard]] const Polynomial& magnitude() const { return magnitude_; }
    [[nodiscard]] const Polynomial& size() const { return size_; }
    [[nodiscard]] const Polynomial& underflow() const { return underflow_; }

 private:
    explicit Expression(const std::string& name) : name_(name) { become_atom(); }

    /// Sites are made of these: 1001, 1002 and so on are x, y, z, r or w of the first, and so on.
    [[nodiscard]] static std::string input_name(double value) {
        const int number = static_cast<int>(value);
        if (number < 1000) throw std::logic_error("not an input");
        return std::string(1, "xyzrw"[number % 1000 - 1]) + std::to_string(number / 1000);
    }

    void become_atom() {
        const std::string kind =
            notes->kind_of_atom == nullptr ? name_ : notes->kind_of_atom(name_);
        const int atom =
            notes->atoms.try_emplace(kind, static_cast<int>(notes->atoms.size())).first->second;
        notes->sizes[atom] = notes->size_of_atom(name_);
        magnitude_ = {{{atom}, 1.0L}};
        size_ = {{notes->size_of_atom(name_), 1.0L}};
    }

    [[nodiscard]] static Units note(char operation, Units left, Units right) {
        const long double a = unit * static_cast<long double>(left);
        const long double b = unit * static_cast<long double>(right);
        const long double e = unit * static_cast<long double>(rounding);
        const long double before = operation == '*' ? a + b + a * b : std::max(a, b);
        const auto result = static_cast<Units>((before + e * (1 + before)) / unit) + 2;
        notes->steps.insert({operation, left, right, result});
        return result;
    }

    [[nodiscard]] static Expression sum(const Expression& a, const Expression& b, char sign) {
        Expression result;
        if (!a.name_.empty() && !b.name_.empty()) {
            // Either order is one magnitude.
            result.name_ = std::min(a.name_, b.name_) + sign + std::max(a.name_, b.name_);
            result.become_atom();
            result.name_.clear();
            result.error_ = note('+', 0, 0);
            return result;
        }
        result.magnitude_ = a.magnitude_ + b.magnitude_;
        result.size_ = a.size_ + b.size_;
        result.underflow_ = 1.001L * (a.underflow_ + b.underflow_);
        result.error_ = note('+', a.error_, b.error_);
        return result;
    }

    /// Of inputs alone, whose differences are known as well as themselves.
    std::string name_;
    Polynomial magnitude_;
    Polynomial size_;
    Polynomial underflow_;
    Units error_ = 0;
};

/// The site of this number for which a filter is evaluated.
template <class S>
[[nodiscard]] S input(int number) {
    S site{};
    const auto name = [number](int part) { return 1000.0 * number + part; };
    site.x = name(1);
    site.y = name(2);
    if constexpr (requires { site.z; }) site.z = name(3);
    if constexpr (requires { site.r; }) site.r = name(4);
    if constexpr (requires { site.w; }) site.w = name(5);
    return site;
}

}  // namespace signum::proofs
