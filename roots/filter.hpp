#pragma once
/// Signs and roots from approximate coefficients, or the answer that these cannot tell. For sources
/// only.
///
/// Roots after t are those of q(s) = p(t + s), s > 0. With s = h x / (1 - x), h > 0 any,
///     (1 - x)^n q(s) = sum_i q_i h^i x^i (1 - x)^(n-i),
/// so q_i h^i / binomial(n, i) are the Bernstein coefficients of a polynomial on 0 < x < 1 with the
/// same signs. De Casteljau's rule bisects it, and on each piece Descartes' rule of signs bounds
/// the number of roots by the changes of sign of its coefficients: none means no root, one means
/// one, a simple one. All of these coefficients carry bounds on their errors, so that only what is
/// certain is said; averages do not let the errors grow beyond one rounding a step.
///
/// Source: Lane and Riesenfeld's bisection; Collins and Akritas's use of Descartes' rule.

#include "../filters/verdict.hpp"
#include "polynomial.hpp"

namespace signum::roots::filter {

/// Of a number that is known approximately, in the default environment.
[[nodiscard]] filters::Verdict sign(const Approximation& value) noexcept;

[[nodiscard]] Approximation value_at(const Approximations& p, double t) noexcept;
/// In all of [low, high].
[[nodiscard]] filters::Verdict sign_between(const Approximations& p, double low,
                                            double high) noexcept;

struct Found {
    bool certain;
    std::optional<Root> root;
};
/// The first root after t, a simple one; where it may be another one, nothing is certain. Who knows
/// the sign at t says so (not 0): it may be too near to a root for the filter. `shifted`, if there
/// is one, is p(t + s), known better than from p, or times a positive number. Precondition: of both
/// the degrees are the same.
[[nodiscard]] Found first_root(const Approximations& p, double t, Sign known = 0,
                               const Approximations* shifted = nullptr) noexcept;

/// All roots, each of them simple; nothing where that is not certain, or the origin is not 0.
[[nodiscard]] std::optional<RealRoots> real_roots(const Approximations& p) noexcept;

}  // namespace signum::roots::filter
