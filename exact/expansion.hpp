#pragma once
/// Expansions: exact numbers as unevaluated sums of doubles, and their arithmetic.
///
/// Laws, in the environment of exact/floating_environment.hpp and inside the window below:
///  1. every operation is exact;
///  2. the terms grow in magnitude and none is 0: no terms is the number 0, and the last term has
///     the sign of the whole;
///  3. the terms are nonadjacent (Shewchuk): all set bits of each lie above those of the one
///  before,
///     with at least one bit between.
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

#include <signum/core/error_free.hpp>
#include <signum/core/sign.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

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
/// of both by increasing magnitude. Out of line, for it is long and needs no fused multiply-add.
///
/// FAST-EXPANSION-SUM (theorem 13) leaves terms that are strongly nonoverlapping: some may be
/// adjacent, pair by pair, if both are powers of two. That is not enough for scale() below, though
/// its usual description says so: (-2^-105, -2^-52, -1, 2)·(2^53 - 1) ends in -1, 2^53 - 2, which
/// is adjacent and no such pair. So a pair is fused: 2^k ± 2^(k-1) is a double and adjacent to
/// neither neighbour. A nonoverlapping term that is just twice the one before is always half of a
/// pair.
[[nodiscard, gnu::noinline]] inline int sum(std::span<const double> e, std::span<const double> f,
                                            double* h) noexcept {
    int size = 0;
    double last = 0.0;
    const auto append = [&](double term) {
        if (term == 0.0) return;
        const bool adjacent = std::fabs(term) == 2.0 * std::fabs(last);
        if (!adjacent) ++size;
        last = adjacent ? last + term : term;
        h[size - 1] = last;
    };
    double high = 0.0;
    const auto add = [&](double term) {
        const TwoTerms next = two_sum(high, term);
        append(next.low);
        high = next.high;
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < e.size() && j < f.size()) {
        const bool from_e = std::fabs(e[i]) < std::fabs(f[j]);
        add(from_e ? e[i] : f[j]);
        i += static_cast<std::size_t>(from_e);
        j += static_cast<std::size_t>(!from_e);
    }
    while (i < e.size()) add(e[i++]);
    while (j < f.size()) add(f[j++]);
    append(high);
    return size;
}

/// h = e·b, where h has room for twice the terms of e; returns the number of terms of h.
/// SCALE-EXPANSION (theorem 19): the terms of h are nonadjacent because those of e are.
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

/// An exact number of at most Capacity terms.
template <int Capacity>
class Expansion {
    static_assert(Capacity >= 1);

 public:
    /// 0. Not defaulted, so that Expansion<N>{} leaves the terms alone as well.
    Expansion() noexcept {}  // NOLINT(modernize-use-equals-default)

    // NOLINTBEGIN(google-explicit-constructor): all of these are the same number
    Expansion(double value) noexcept { append(value); }
    /// Precondition: the result of an error-free transform.
    Expansion(TwoTerms value) noexcept requires(Capacity >= 2) {
        append(value.low);
        append(value.high);
    }
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
    void append(double term) noexcept {
        terms_[size_] = term;
        size_ += static_cast<int>(term != 0.0);
    }
    void assign(TwoTerms value) noexcept {
        size_ = 0;
        append(value.low);
        append(value.high);
    }
    void copy(std::span<const double> terms) noexcept {
        size_ = static_cast<int>(terms.size());
        for (std::size_t i = 0; i < terms.size(); ++i) terms_[i] = terms[i];
    }

    int size_ = 0;
    double terms_[Capacity];
};

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
