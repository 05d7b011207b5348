#pragma once
/// Expansions: exact numbers as unevaluated sums of doubles, and their arithmetic.
///
/// Laws, in the environment of exact/floating_environment.hpp and inside the window below:
///  1. every operation is exact;
///  2. the terms grow in magnitude and none is 0: no terms is the number 0, and the last term has
///     the sign of the whole;
///  3. the terms are nonadjacent (Shewchuk): there is a bit between those of one and those of the
///     next, and so all terms before another add up to less than half its last bit.
///
/// Nothing is allocated and unused capacity is never touched. A number of no term or one takes a
/// short cut everywhere: on grids and integers, where ties abound, an operation costs little more
/// than the double operation.
///
/// The window. Let every coordinate be 0 or of magnitude in [2^-200, 2^200], every weight 0 or in
/// [2^-400, 2^400], a weight counting as degree 2. Such coordinates are multiples of 2^-252 and
/// weights of 2^-452, so that all numbers of degree d, the errors of the transforms among them, are
/// multiples of 2^-252d: up to degree 4 of 2^-1008, and so 0 or normal, even where denormals are
/// flushed. Numbers of degree 4 stay below 2^800 times the number of their monomials: no overflow.
///
/// Source: Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997.

#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include "../core/error_free.hpp"
#include "../core/sign.hpp"

namespace signum::exact {

namespace window {

/// Whether |value| is 0 or in [2^-exponent, 2^exponent]; by integers, for a comparison of doubles
/// would take a denormal for 0 where denormals are flushed.
[[nodiscard, gnu::always_inline]] inline bool contains(double value, int exponent) noexcept {
    constexpr std::uint64_t bias = 1023;
    const auto power = [](std::uint64_t biased) { return biased << 53; };  // of 2, without a sign
    const std::uint64_t magnitude = std::bit_cast<std::uint64_t>(value) << 1;
    const auto reach = static_cast<std::uint64_t>(exponent);
    const std::uint64_t least = power(bias - reach);
    return magnitude == 0 || magnitude - least <= power(bias + reach) - least;
}

}  // namespace window

/// Whether expansions are exact up to degree 4 in this coordinate (and others like it).
[[nodiscard, gnu::always_inline]] inline bool in_expansion_window(double coordinate) noexcept {
    return window::contains(coordinate, 200);
}

/// The same for a weight, which counts as degree 2.
[[nodiscard, gnu::always_inline]] inline bool weight_in_expansion_window(double weight) noexcept {
    return window::contains(weight, 400);
}

namespace terms {

/// h = e + f, where h has room for both; returns the number of terms of h. One pass over the terms
/// of both by increasing magnitude. Out of line, for it is long and needs no fused multiply-add,
/// and in a source, so that no other program's copy takes its place.
[[nodiscard]] int sum(std::span<const double> e, std::span<const double> f, double* h) noexcept;

/// h = e·b, where h has room for twice the terms of e; returns the number of terms of h.
/// SCALE-EXPANSION (Shewchuk's theorem 19): the terms of h are nonadjacent because those of e are.
[[nodiscard, gnu::always_inline]] inline int scale(std::span<const double> e, double b,
                                                   double* h) noexcept {
    int size = 0;
    double high = 0.0;
    const auto append = [&](double term) {
        h[size] = term;
        size += static_cast<int>(term != 0.0);
    };
    for (const double term : e) {
        const TwoTerms product = two_product(term, b);
        const TwoTerms inner = two_sum(high, product.low);
        append(inner.low);
        const TwoTerms outer = quick_two_sum(product.high, inner.high);
        append(outer.low);
        high = outer.high;
    }
    append(high);
    return size;
}

}  // namespace terms

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // it cannot see that size_ guards terms_
#endif

/// An exact number of at most Capacity terms.
template <int Capacity>
class Expansion {
    static_assert(Capacity >= 1);

 public:
    /// 0. Not defaulted, so that Expansion<N>{} leaves the terms alone as well.
    Expansion() noexcept {}  // NOLINT(modernize-use-equals-default)

    // NOLINTBEGIN(google-explicit-constructor): all of these are the same number
    Expansion(double value) noexcept : size_(static_cast<int>(value != 0.0)) { terms_[0] = value; }
    /// Precondition: the result of an error-free transform.
    Expansion(TwoTerms value) noexcept requires(Capacity >= 2) { assign(value); }
    template <int Fewer>
    requires(Fewer < Capacity) Expansion(const Expansion<Fewer>& other)
    noexcept { copy(other.terms()); }
    // NOLINTEND(google-explicit-constructor)

    /// Copies the terms that exist, and no others.
    Expansion(const Expansion& other) noexcept { copy(other.terms()); }
    Expansion& operator=(const Expansion& other) noexcept {
        copy(other.terms());
        return *this;
    }
    ~Expansion() = default;

    /// By increasing magnitude; empty for 0.
    [[nodiscard]] std::span<const double> terms() const noexcept {
        return {terms_, static_cast<std::size_t>(size_)};
    }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] Sign sign() const noexcept { return size_ == 0 ? 0 : sign_of(terms_[size_ - 1]); }
    /// The number with a relative error below 2^-50.
    [[nodiscard]] double approximate() const noexcept {
        double sum = 0.0;
        for (const double term : terms()) sum += term;
        return sum;
    }

    /// *this = e + f. Precondition: room for the terms of both; *this is neither.
    [[gnu::always_inline]] void assign_sum(std::span<const double> e,
                                           std::span<const double> f) noexcept {
        if (e.size() == 1 && f.size() == 1) {
            assign(two_sum(e[0], f[0]));
        } else if (e.empty() || f.empty()) {
            copy(e.empty() ? f : e);
        } else {
            size_ = terms::sum(e, f, terms_);
        }
    }
    /// *this = e·b. Precondition: room for twice the terms of e; *this is not e.
    [[gnu::always_inline]] void assign_scaled(std::span<const double> e, double b) noexcept {
        if (e.size() == 1) {
            assign(two_product(e[0], b));
        } else {
            size_ = terms::scale(e, b, terms_);
        }
    }
    void negate() noexcept {
        for (int i = 0; i < size_; ++i) terms_[i] = -terms_[i];
    }

 private:
    /// A branch, for on grids and integers low is always 0, and nothing need wait to know it.
    void assign(TwoTerms value) noexcept {
        if (value.low == 0.0) {
            terms_[0] = value.high;
            size_ = static_cast<int>(value.high != 0.0);
        } else {
            terms_[0] = value.low;
            terms_[1] = value.high;
            size_ = 2;
        }
    }
    void copy(std::span<const double> terms) noexcept {
        size_ = static_cast<int>(terms.size());
        for (std::size_t i = 0; i < terms.size(); ++i) terms_[i] = terms[i];
    }

    int size_ = 0;
    double terms_[Capacity];
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

/// a - b.
[[nodiscard, gnu::always_inline]] inline Expansion<2> difference(double a, double b) noexcept {
    return two_difference(a, b);
}

/// a·b.
[[nodiscard, gnu::always_inline]] inline Expansion<2> product(double a, double b) noexcept {
    return two_product(a, b);
}

template <int M>
[[nodiscard, gnu::always_inline]] inline Expansion<M> operator-(Expansion<M> e) noexcept {
    e.negate();
    return e;
}

template <int M, int N>
[[nodiscard, gnu::always_inline]] inline Expansion<M + N> operator+(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    Expansion<M + N> result;
    result.assign_sum(e.terms(), f.terms());
    return result;
}

template <int M, int N>
[[nodiscard, gnu::always_inline]] inline Expansion<M + N> operator-(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    return e + (-f);
}

template <int M>
[[nodiscard, gnu::always_inline]] inline Expansion<2 * M> operator*(const Expansion<M>& e,
                                                                    double b) noexcept {
    Expansion<2 * M> result;
    result.assign_scaled(e.terms(), b);
    return result;
}

template <int M>
[[nodiscard, gnu::always_inline]] inline Expansion<2 * M> operator*(
    double b, const Expansion<M>& e) noexcept {
    return e * b;
}

/// The one of more terms, scaled by each term of the other, summed up.
template <int M, int N>
[[nodiscard, gnu::always_inline]] inline Expansion<2 * M * N> operator*(
    const Expansion<M>& e, const Expansion<N>& f) noexcept {
    std::span<const double> longer = e.terms();
    std::span<const double> shorter = f.terms();
    if (longer.size() < shorter.size()) std::swap(longer, shorter);

    Expansion<2 * M * N> result;
    if (shorter.empty()) return result;
    result.assign_scaled(longer, shorter.front());
    for (const double term : shorter.subspan(1)) {
        Expansion<2 * (M > N ? M : N)> partial;
        partial.assign_scaled(longer, term);
        const Expansion<2 * M* N> before = result;
        result.assign_sum(before.terms(), partial.terms());
    }
    return result;
}

template <int M>
[[nodiscard, gnu::always_inline]] inline Expansion<2 * M * M> square(
    const Expansion<M>& e) noexcept {
    return e * e;
}

}  // namespace signum::exact
