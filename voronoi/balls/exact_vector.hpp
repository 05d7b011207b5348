#pragma once
/// Spheres as vectors of rationals, and systems of linear equations in them: what the problem of
/// Apollonius comes down to. For sources only.
///
/// A sphere of d dimensions is a point v = (c, rho) of d+1 and touches a ball, the point (c_i,
/// -r_i), where the difference (x, h) has h >= 0 and <(x, h), (x, h)> = 0, with <,> = x·x - h h.
/// Relative to one ball this is <v, v> = 0 for itself and linear for the others: (X, R)·v = p / 2.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "../../core/sign.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../predicates/formulas/apollonius.hpp"

namespace signum::balls {

using exact::Rational;
template <std::size_t n>
using Vector = std::array<Rational, n>;

/// a + t b
template <std::size_t n>
[[nodiscard]] Vector<n> along(const Vector<n>& a, const Rational& t, const Vector<n>& b) {
    Vector<n> result = a;
    for (std::size_t k = 0; k < n; ++k) result[k] += t * b[k];
    return result;
}
/// <a, b>
template <std::size_t n>
[[nodiscard]] Rational inner(const Vector<n>& a, const Vector<n>& b) {
    Rational sum = -a[n - 1] * b[n - 1];
    for (std::size_t k = 0; k + 1 < n; ++k) sum += a[k] * b[k];
    return sum;
}

/// The sign of a + b √g, g >= 0.
[[nodiscard]] inline Sign sign_of_surd(const Rational& a, const Rational& b, const Rational& g) {
    return euclidean::polynomials::sign_of_difference(
        a.sign(), -b.sign() * g.sign(), [&] { return Rational(a * a - b * b * g).sign(); });
}

template <std::size_t n>
[[nodiscard]] Rational determinant(std::array<Vector<n>, n> rows) {
    Rational result = 1;
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t row = column;
        while (row < n && rows[row][column].is_zero()) ++row;
        if (row == n) return 0;
        if (row != column) {
            std::swap(rows[row], rows[column]);
            result = -result;
        }
        result *= rows[column][column];
        for (std::size_t other = column + 1; other < n; ++other)
            rows[other] =
                along(rows[other], -rows[other][column] / rows[column][column], rows[column]);
    }
    return result;
}

/// Equations row·v = value in the reduced form: in each of the first `rank` rows there is a 1 in a
/// column in which all others have 0.
template <std::size_t n>
class System {
 public:
    /// Without values these are 0.
    explicit System(std::vector<Vector<n>> rows, std::vector<Rational> values = {})
        : rows_(std::move(rows)), values_(std::move(values)) {
        values_.resize(rows_.size());
        for (std::size_t column = 0; column < n && rank() < rows_.size(); ++column) {
            std::size_t row = rank();
            while (row < rows_.size() && rows_[row][column].is_zero()) ++row;
            if (row == rows_.size()) continue;
            std::swap(rows_[row], rows_[rank()]);
            std::swap(values_[row], values_[rank()]);
            Vector<n>& pivot = rows_[rank()];
            const Rational factor = 1 / pivot[column];
            for (Rational& number : pivot) number *= factor;
            values_[rank()] *= factor;
            for (std::size_t other = 0; other < rows_.size(); ++other) {
                if (other == rank() || rows_[other][column].is_zero()) continue;
                const Rational times = -rows_[other][column];
                rows_[other] = along(rows_[other], times, pivot);
                values_[other] += times * values_[rank()];
            }
            pivots_.push_back(column);
        }
    }

    [[nodiscard]] std::size_t rank() const noexcept { return pivots_.size(); }
    [[nodiscard]] const Vector<n>& row(std::size_t k) const noexcept { return rows_[k]; }
    [[nodiscard]] const Rational& value(std::size_t k) const noexcept { return values_[k]; }
    [[nodiscard]] bool is_solvable() const {
        return std::all_of(values_.begin() + static_cast<std::ptrdiff_t>(rank()), values_.end(),
                           [](const Rational& value) { return value.is_zero(); });
    }
    /// The solution that is 0 in the columns without pivot.
    [[nodiscard]] Vector<n> solution() const {
        Vector<n> result;
        for (std::size_t k = 0; k < rank(); ++k) result[pivots_[k]] = values_[k];
        return result;
    }
    /// Those of the others from there, which all rows are orthogonal to (as a scalar product).
    [[nodiscard]] std::vector<Vector<n>> directions() const {
        std::vector<Vector<n>> result;
        for (std::size_t free = 0; free < n; ++free) {
            if (std::ranges::find(pivots_, free) != pivots_.end()) continue;
            Vector<n>& direction = result.emplace_back();
            direction[free] = 1;
            for (std::size_t k = 0; k < rank(); ++k) direction[pivots_[k]] = -rows_[k][free];
        }
        return result;
    }

 private:
    std::vector<Vector<n>> rows_;
    std::vector<Rational> values_;
    std::vector<std::size_t> pivots_;
};

/// Where a line v + t n meets the cone: a t² + 2 b t + c = 0. Calls add(middle, step, g, side) for
/// each point middle + step √g; <v, n> is side √g there, or has the sign `side` where g is 0. Of
/// two points that with the side `first` comes first.
template <std::size_t n, class Add>
void for_points_on_cone(const Vector<n>& v, const Vector<n>& direction, Sign first,
                        const Add& add) {
    const Rational a = inner(direction, direction);
    const Rational b = inner(v, direction);
    const Rational c = inner(v, v);
    if (a.is_zero()) {  // the other root is at infinity
        if (!b.is_zero()) add(along(v, -c / (2 * b), direction), {}, 0, b.sign());
        return;
    }
    const Rational g = b * b - a * c;
    if (g.sign() < 0) return;
    const Vector<n> middle = along(v, -b / a, direction);
    if (g.is_zero()) return add(middle, {}, 0, 0);
    // At t = (-b ± √g) / a it is ±√g.
    for (const Sign side : {first, -first}) add(middle, along({}, side / a, direction), g, side);
}

}  // namespace signum::balls
