#pragma once
/// Signs and real roots of polynomials of degree 8 at most, whose coefficients are sums of products
/// of doubles: what kinetic structures ask for. For sources only.
///
/// A polynomial is known twice: by approximate coefficients, which are always there, and by dyadic
/// ones, which are made when a question needs them. Both come of one form, which a user writes as
///
///     struct Ccw {
///         MovingPoint a, b, c;
///         template <class Number> PolynomialIn<Number, 2> in() const;
///     };
///
/// Who asks about times far from 0 writes `in<Number>(double origin)` instead, for the polynomial
/// in t - origin, and gives an origin nearby: there the approximate coefficients are what they
/// would be at 0, and the answers about t are the same.
///
/// Laws:
///  1. Every answer is exact, for all finite doubles. Where these are 0 or within 2^±150 the
///     approximations of polynomials of degree 4 do not leave a double's range.
///  2. Each question is asked of the approximations first (filter.hpp) and, where these cannot
///     tell, of integers (exact/polynomial.hpp): of coefficients that are rounded only at the very
///     place, and at last of Sturm's chains. Between them the sign at a double is asked of
///     double-doubles (refined.hpp): the doubles beside a root are too near for the filter. A
///     question that the filter answers allocates nothing. Outside the default floating-point
///     environment all answers are exact ones.
///  3. Equal roots of different polynomials are found equal by the greatest common divisor; no loop
///     waits for two numbers to part that may be the same.
///
/// A root is a small record apart from its polynomial, as events wait in queues by the million; who
/// asks about it brings the polynomial again (RootOf), the same one or another made of the same
/// form. Better coefficients and chains are kept in the polynomial for the next question, so that
/// one polynomial is not for two threads at a time.

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "../core/sign.hpp"
#include "../exact/polynomial.hpp"
#include "../filters/verdict.hpp"
#include "polynomial_in.hpp"
#include "refined.hpp"

namespace signum::roots {

/// Questions by what answered them.
struct Tally {
    std::uint64_t filtered = 0;
    std::uint64_t exact = 0;
};

/// A real root of a polynomial. One of these holds:
///  - low == high, and the root is this double;
///  - `alone`: the root is the only one in [low, high] and is neither, and the polynomial changes
///    its sign there;
///  - low and high are neighbours among the doubles with both infinities, and it is the place-th of
///    the distinct roots that are greater than low; less than high.
struct Root {
    double low;
    double high;
    std::int8_t multiplicity;
    std::int8_t place;  ///< from 1
    std::int8_t after;  ///< the sign of the polynomial right after the root
    bool alone;

    [[nodiscard]] bool is_double() const noexcept { return filters::same_number(low, high); }
    [[nodiscard]] bool changes_sign() const noexcept { return multiplicity % 2 == 1; }
    /// The sign right before the root.
    [[nodiscard]] Sign before() const noexcept { return changes_sign() ? -after : after; }
    /// The same root of the polynomial times -1.
    [[nodiscard]] Root of_negative() const noexcept {
        Root result = *this;
        result.after = static_cast<std::int8_t>(-after);
        return result;
    }
};

/// All real roots in order, each once; where the polynomial is 0, `everywhere` and none.
struct RealRoots {
    bool everywhere = false;
    int count = 0;
    std::array<Root, most_degree> roots{};

    [[nodiscard]] const Root* begin() const noexcept { return roots.data(); }
    [[nodiscard]] const Root* end() const noexcept { return roots.data() + count; }
    [[nodiscard]] int size() const noexcept { return count; }
    [[nodiscard]] const Root& operator[](int i) const noexcept {
        return roots[static_cast<std::size_t>(i)];
    }
};

static_assert(sizeof(Root) == 24);

class Polynomial;

/// A root and a polynomial of which it is one. The root may be one of its negative, too, if
/// of_negative() was asked for.
struct RootOf {
    const Polynomial& polynomial;
    Root root;
};

/// Coefficients of powers of t - origin, in double-doubles.
using RefinedCoefficients = std::array<Refined, most_degree + 1>;

/// What filter and exact stages know the polynomial by.
struct Approximations {
    std::array<Approximation, most_degree + 1> c;
    /// Coefficients from here on are exactly 0; -1 where all are.
    int degree;
    /// They are those of powers of t - origin.
    double origin = 0.0;
};

class Polynomial {
 public:
    /// The form has to outlive the polynomial.
    template <class Form>
    explicit Polynomial(const Form& form)
        : Polynomial(
              &form,
              [](const void* f) {
                  return exact_of(static_cast<const Form*>(f)->template in<exact::Dyadic>().c);
              },
              [](const void* f, double /*origin*/, RefinedCoefficients& c) {
                  copy(static_cast<const Form*>(f)->template in<Refined>().c, c);
              }) {
        know(form.template in<Approximation>().c, 0.0);
    }
    /// The same; the origin is finite.
    template <class Form>
    Polynomial(const Form& form, double origin)
        : Polynomial(
              &form,
              [](const void* f) {
                  return exact_of(static_cast<const Form*>(f)->template in<exact::Dyadic>(0.0).c);
              },
              [](const void* f, double about, RefinedCoefficients& c) {
                  copy(static_cast<const Form*>(f)->template in<Refined>(about).c, c);
              }) {
        know(form.template in<Approximation>(filters::pinned(origin)).c, origin);
    }

    /// Whether it is 0 everywhere.
    [[nodiscard]] bool is_zero(Tally* tally = nullptr) const;

    // Preconditions: t is finite.
    [[nodiscard]] Sign sign_at(double t, Tally* tally = nullptr) const;
    /// Right after t: 0 only where the polynomial is 0 everywhere.
    [[nodiscard]] Sign sign_after(double t, Tally* tally = nullptr) const;
    [[nodiscard]] Sign sign_at(const RootOf& t, Tally* tally = nullptr) const;
    [[nodiscard]] Sign sign_after(const RootOf& t, Tally* tally = nullptr) const;

    /// The least root greater than t, of whatever multiplicity.
    [[nodiscard]] std::optional<Root> first_root(double t, Tally* tally = nullptr) const;
    [[nodiscard]] std::optional<Root> first_root(const RootOf& t, Tally* tally = nullptr) const;
    [[nodiscard]] RealRoots real_roots(Tally* tally = nullptr) const;

    /// The same root between neighbouring doubles, or as a double.
    [[nodiscard]] Root narrowed(const Root& root, Tally* tally = nullptr) const;
    /// Halves to even; infinity where that would be beyond the doubles.
    [[nodiscard]] double nearest_double(const Root& root, Tally* tally = nullptr) const;

    /// The sign of root - x.
    friend Sign compare(const RootOf& a, double x, Tally* tally);
    /// The sign of a - b.
    friend Sign compare(const RootOf& a, const RootOf& b, Tally* tally);

    [[nodiscard]] const Approximations& approximate() const noexcept { return approximate_; }

 private:
    struct Exact;
    struct Forget {
        void operator()(Exact* known) const noexcept;
    };
    /// Whether a question went on to the exact stage.
    struct Asked;

    using MakeExact = exact::Polynomial (*)(const void* form);
    using MakeRefined = void (*)(const void* form, double origin, RefinedCoefficients& c);
    Polynomial(const void* form, MakeExact make_exact, MakeRefined make_refined)
        : form_(form), exact_(make_exact), refined_(make_refined) {}
    [[nodiscard]] static exact::Polynomial exact_of(std::span<const exact::Dyadic> c) {
        return exact::Polynomial(c);
    }
    template <std::size_t n>
    static void copy(const std::array<Refined, n>& from, RefinedCoefficients& to) noexcept {
        for (std::size_t i = 0; i < n; ++i) to[i] = from[i];
    }
    template <std::size_t n>
    void know(const std::array<Approximation, n>& c, double origin) noexcept {
        const bool usable = filters::environment_is_default();
        for (std::size_t i = 0; i < n; ++i) {
            approximate_.c[i] = c[i];
            if (!usable) approximate_.c[i].error = std::numeric_limits<double>::infinity();
        }
        approximate_.origin = origin;
        approximate_.degree = static_cast<int>(n) - 1;
        while (approximate_.degree >= 0 &&
               approximate_.c[static_cast<std::size_t>(approximate_.degree)].is_zero())
            --approximate_.degree;
    }

    [[nodiscard]] Exact& exact() const;
    [[nodiscard]] filters::Verdict refined_sign(double t) const;
    [[nodiscard]] Sign sign_at(double t, Asked& asked) const;
    [[nodiscard]] std::optional<Root> first(double t, Asked& asked) const;
    [[nodiscard]] std::optional<Root> first(const Root& mine, Asked& asked) const;
    [[nodiscard]] std::optional<Root> first(const RootOf& t, Asked& asked) const;
    [[nodiscard]] Root narrowed(const Root& root, Asked& asked) const;
    [[nodiscard]] static Sign compare(const RootOf& a, double x, Asked& asked);
    [[nodiscard]] static Sign compare(const RootOf& a, const RootOf& b, Asked& asked);

    Approximations approximate_;
    const void* form_;
    MakeExact exact_;
    MakeRefined refined_;
    mutable std::unique_ptr<RefinedCoefficients> better_known_;
    mutable std::unique_ptr<Exact, Forget> known_;
};

[[nodiscard]] Sign compare(const RootOf& a, double x, Tally* tally = nullptr);
[[nodiscard]] Sign compare(const RootOf& a, const RootOf& b, Tally* tally = nullptr);

}  // namespace signum::roots
